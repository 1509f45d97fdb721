"""Every error has a code, every code a constructor and a row in the docs."""

import ast
import inspect
import pickle
import re
from pathlib import Path

import pytest

import haptonic
from each import each
from haptonic.errors import HaptonicError, ScanError, StudyError
from sources import tree_of

ROOT = Path(haptonic.__file__).parent
PAGE = Path(__file__).parents[1] / "docs" / "errors.md"
PARTS = {"argument": "a", "given": "b", "allowed": "c", "cause": "d", "next_step": "e"}
CODES = {
    name.replace("_", "-"): factory
    for name, factory in vars(HaptonicError).items()
    if isinstance(factory, classmethod) or hasattr(factory, "code")
}
FAMILY = {kind.__name__ for kind in [HaptonicError, *HaptonicError.__subclasses__()]}


def codes_given(tree: ast.AST) -> list[str]:
    """Codes that a module raises by a text, and errors that it makes without a code, as "none"."""
    codes = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            coded = node.func.id in {"problem", "_refused"} or node.func.id in FAMILY
            first = node.args[0] if coded and node.args else None
            if isinstance(first, ast.Constant):
                codes.append(first.value)
            elif coded and first is None:
                codes.append("none")
    return codes


def test_the_docs_list_every_code_and_no_other():
    rows = re.findall(
        r"^\| `([a-z-]+)` \| (.+?) \|$", PAGE.read_text("utf-8").split("## Codes")[1], re.MULTILINE
    )
    assert dict(rows) == {code: inspect.getdoc(factory).split("\n")[0] for code, factory in CODES.items()}
    assert len(rows) == len(CODES)


@each("code", sorted(CODES.keys() - {"unknown"}))
def test_a_constructor_gives_its_code(code):
    error = getattr(ScanError, code.replace("-", "_"))(**PARTS)
    assert isinstance(error, ScanError)
    assert error.parts() == {"code": code, **PARTS}
    assert f"code: {code}" in str(error)
    assert pickle.loads(pickle.dumps(error)).parts() == error.parts()
    changed = error.changed(StudyError, given="other")
    assert isinstance(changed, StudyError)
    assert changed.parts() == error.parts() | {"given": "other"}


def test_every_error_of_the_sources_has_a_known_code():
    seen = {}
    for file in sorted(ROOT.rglob("*.py")):
        wrong = set(codes_given(tree_of(file))) - CODES.keys()
        if wrong:
            seen[str(file.relative_to(ROOT))] = wrong
    assert seen == {}


def test_an_error_without_a_known_code_would_be_found():
    tree = ast.parse(
        "raise problem('oops', 'a')\nraise StudyError(argument='a')\nraise ScanError.missing(a=1)"
    )
    assert codes_given(tree) == ["oops", "none"]


def test_an_unknown_name_proposes_the_nearest_unless_it_cannot_be_a_slip():
    known = ["pitch", "Thickness"]
    error = HaptonicError.unknown("key", "thicknes", known, "no such key")
    assert (error.code, error.given, error.next_step) == ("unknown", "'thicknes'", 'write "Thickness"')
    assert error.allowed == "one of pitch, Thickness"
    assert (
        HaptonicError.unknown("key", "thicknes", known, "why", slip=False).next_step == "choose one of these"
    )
    assert "none" in HaptonicError.unknown("key", "thicknes", [], "why").allowed


@pytest.mark.parametrize(
    ("given", "meant"),
    [
        ("glass", 'write "soda-lime-glass" or "borosilicate-glass"'),
        ("Lime_Glass", 'write "soda-lime-glass"'),
        ("bras", 'write "brass"'),
        ("zzz", "choose one of these"),
        ("silicone rubber", "choose one of these"),
        ("silicon 100", 'write "silicon"'),
    ],
)
def test_names_that_contain_the_given_words_are_proposed_before_a_similar_spelling(given, meant):
    known = ["brass", "silicon", "soda-lime-glass", "borosilicate-glass"]
    assert HaptonicError.unknown("material", given, known, "why").next_step == meant
