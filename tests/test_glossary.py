"""Each term of the glossary has one meaning, and its names are those of the code."""

import ast
import re
from functools import cache
from pathlib import Path

import haptonic
from sources import tree_of

PAGE = Path(__file__).parents[1] / "docs" / "glossary.md"
ROWS = [
    [cell.strip() for cell in line.strip("|").split("|")]
    for line in PAGE.read_text("utf-8").splitlines()
    if line.startswith("|") and not line.startswith(("| term", "|---"))
]


@cache
def names_in_the_code() -> set[str]:
    """Public functions and classes, and ``Class.member`` of every field and method."""
    names = set()
    for file in Path(haptonic.__file__).parent.rglob("*.py"):
        for node in tree_of(file).body:
            if isinstance(node, ast.ClassDef | ast.FunctionDef):
                names.add(node.name)
            if isinstance(node, ast.ClassDef):
                fields = [member.target for member in node.body if isinstance(member, ast.AnnAssign)]
                names |= {f"{node.name}.{field.id}" for field in fields if isinstance(field, ast.Name)}
                methods = (member for member in node.body if isinstance(member, ast.FunctionDef))
                names |= {f"{node.name}.{method.name}" for method in methods}
    return names


def test_every_row_is_complete_and_every_term_is_unique():
    assert len(ROWS) > 50
    for row in ROWS:
        assert len(row) == 4, row
        assert row[0], row
        assert row[2], row
    terms = [row[0] for row in ROWS]
    assert len(set(terms)) == len(terms)


def test_the_names_beside_equations_exist():
    table = PAGE.with_name("method.md").read_text("utf-8").split("## Equations")[1]
    given = {name for line in table.splitlines() for name in re.findall(r"`([^`]+)` \|$", line)}
    assert len(given) > 10
    assert given <= names_in_the_code(), given - names_in_the_code()


def test_the_names_of_the_code_exist():
    known = names_in_the_code()
    given = {name for row in ROWS for name in re.findall(r"`([^`]+)`", row[3])}
    assert len(given) > 20
    assert given <= known, given - known
