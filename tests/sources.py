"""Syntax trees of modules, for tests that read the sources; each module is parsed once."""

import ast
from functools import cache
from pathlib import Path


@cache
def tree_of(module: Path) -> ast.Module:
    """The tree of a Python file. Callers must not change it."""
    return ast.parse(module.read_text("utf-8"))
