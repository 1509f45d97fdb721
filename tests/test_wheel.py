"""What an installed haptonic has: its types, and every file that a message points to."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import haptonic
from sources import tree_of

SOURCE = Path(haptonic.__file__).parent
# A path of this repository in a sentence.
REPOSITORY = re.compile(r"\b(?:studies|docs|tests|benchmarks|src)/[\w./-]*\w")


def spoken(tree: ast.AST) -> list[ast.Constant]:
    """Texts of a module that are not docstrings."""
    documented = [
        node.body[0].value
        for node in ast.walk(tree)
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef)
        and node.body
        and isinstance(node.body[0], ast.Expr)
    ]
    texts = [n for n in ast.walk(tree) if isinstance(n, ast.Constant) and isinstance(n.value, str)]
    return [text for text in texts if text not in documented]


def test_the_package_declares_types():
    assert (SOURCE / "py.typed").is_file()


def test_no_message_points_to_a_file_that_is_not_installed():
    missing = [
        f"{file.relative_to(SOURCE)}:{text.lineno}: {path}"
        for file in SOURCE.rglob("*.py")
        for text in spoken(tree_of(file))
        for path in REPOSITORY.findall(text.value)
        if not (SOURCE / path).exists()
    ]
    assert missing == []
