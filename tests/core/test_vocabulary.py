"""One name, one meaning; and the field's words: no public name of the house's dialect."""

import ast
import re
from collections import defaultdict
from collections.abc import Iterator, Mapping

from test_architecture import trees

# word of the dialect -> the field's word; see docs/glossary.md
BANNED = {
    "asked": "settings",
    "asking": "settings",
    "bed": "elastic foundation",
    "beds": "elastic foundation",
    "fading": "decay",
    "felt": "friction, tactile response",
    "judged": "compared, assessed",
    "judging": "compared, assessed",
    "lead": "scaled channel",
    "leads": "scaled channels",
    "lights": "requirements",
    "omission": "truncation residual",
    "places": "sites, measurement points",
    "question": "settings",
    "retuned": "updated",
    "said": "reported",
    "shaft": "body of a pillar",
    "shafted": "substructured",
    "told": "reported, uncertainty",
    "twin": "simulated measurement",
    "wired": "channel map",
    "wiring": "channel map",
    "words": "text",
}


def public_names(tree: ast.Module) -> Iterator[str]:
    """Classes, functions, methods and fields of a module without an underscore before them."""
    for node in tree.body:
        if isinstance(node, ast.ClassDef | ast.FunctionDef) and not node.name.startswith("_"):
            yield node.name
            for inner in node.body if isinstance(node, ast.ClassDef) else ():
                if isinstance(inner, ast.FunctionDef):
                    yield inner.name
                elif isinstance(inner, ast.AnnAssign) and isinstance(inner.target, ast.Name):
                    yield inner.target.id


def banned_in(module: str, tree: ast.Module) -> set[str]:
    """Words of the dialect in the public names of a module, and in its own name."""
    names = [module.rpartition(".")[2], *public_names(tree)]
    words = (re.findall(r"[A-Z]?[a-z]+|[A-Z]+", name) for name in names if not name.startswith("_"))
    return {word.lower() for each in words for word in each} & BANNED.keys()


def defined_twice(trees: Mapping[str, ast.Module]) -> dict[str, list[str]]:
    """Names of classes, private ones too, that several modules define, with these modules."""
    modules_by_class = defaultdict(list)
    for module, tree in trees.items():
        for node in tree.body:
            if isinstance(node, ast.ClassDef):
                modules_by_class[node.name].append(module)
    return {name: modules for name, modules in modules_by_class.items() if len(modules) > 1}


def test_class_names_are_unique():
    assert defined_twice(trees()) == {}


def test_a_class_name_in_two_modules_is_found():
    tree, other = ast.parse("class A: ..."), ast.parse("class A: ...; b = 1")
    assert defined_twice({"a": tree, "b": other}) == {"A": ["a", "b"]}


def test_public_names_are_the_fields_words():
    words = {module: banned_in(module, tree) for module, tree in trees().items()}
    assert [f"{module}: {word}, write {BANNED[word]}" for module in words for word in words[module]] == []


def test_a_banned_word_would_be_found():
    tree = ast.parse("class Scan:\n    lead: int\n    def _told(self): ...\ndef wired_up(): ...\n")
    assert banned_in("haptonic.judging", tree) == {"judging", "lead", "wired"}


MOST_BY_PLACE = 4  # values that a class is built from without their names


def built_by_place(trees: Mapping[str, ast.Module]) -> Iterator[str]:
    """Where a class of the house, or that of a class method, is built from too many bare values."""
    classes = {
        node.name for tree in trees.values() for node in ast.walk(tree) if isinstance(node, ast.ClassDef)
    }
    for module, tree in trees.items():
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and len(node.args) > MOST_BY_PLACE:
                name = ast.unparse(node.func).rpartition(".")[2]
                if name in classes | {"cls"}:
                    yield f"{module}, line {node.lineno}: {name}"


def test_what_has_many_fields_is_built_by_their_names():
    assert list(built_by_place(trees())) == []


def test_a_class_built_from_bare_values_would_be_found():
    tree = ast.parse(
        "class A: ...\nA(1, 2, 3, 4)\nA(1, 2, *b, 4, 5)\nA(1, b=2, c=3, d=4, e=5)\nf(1, 2, 3, 4, 5)"
    )
    assert list(built_by_place({"a": tree})) == ["a, line 3: A"]
