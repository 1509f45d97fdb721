"""Write what follows from the sources, a test holds it to them: docs/reference.md, every public name of every
package, and the types of a study's methods, for editors and type checkers."""

from __future__ import annotations

import inspect
import re
from dataclasses import MISSING, Field, fields
from importlib import import_module
from pathlib import Path
from pkgutil import walk_packages
from textwrap import wrap
from types import UnionType
from typing import Any, Union, get_args, get_origin, get_type_hints

import haptonic
from haptonic.analyses import NAMES, named
from haptonic.analyses.options import option_of

PAGE = Path(__file__).parent / "reference.md"
METHODS = Path(haptonic.__file__).parent / "study" / "methods.pyi"


def packages() -> list[str]:
    """The packages, those within others too, that say what is public in them, and the lattices."""
    inner = [one.name for one in walk_packages(haptonic.__path__, "haptonic.") if one.ispkg]
    inner = [name for name in inner if hasattr(import_module(name), "__all__")]
    return ["haptonic", *sorted([*inner, "haptonic.lattice"])]


def first_line(value: object) -> str:
    """What a name is for: the first sentence of its docstring; the type of a value without one."""
    if not (inspect.isclass(value) or inspect.isroutine(value)):
        return f"A value of the type {type(value).__name__}."
    return (inspect.getdoc(value) or "").split("\n\n")[0].replace("\n", " ").replace("|", "\\|")


def reference() -> str:
    """The page."""
    lines = [
        "# Public names",
        "",
        "Every name that a package opens to others, and the first sentence of its docstring.",
        "",
        "## Analyses",
        "",
        "Commands, and methods of a study with the same options.",
        "",
    ]
    for name, text in NAMES.items():
        options = [(one.name, known) for one in named(name).options.__dataclass_fields__.values()
                   if (known := option_of(one))]  # fmt: skip
        lines += [f"- `{name}`: {text}"]
        lines += [f"  - `{option}`: {known.help}" for option, known in options]
    for package in packages():
        module = import_module(package)
        rows = [f"| `{name}` | {first_line(getattr(module, name))} |" for name in sorted(module.__all__)]
        lines += ["", f"## {package}", "", "| name | what |", "|---|---|", *rows]
    return "\n".join(lines) + "\n"


def methods() -> str:
    """The types of what a study is asked for: a method for each analysis, with its options and its result."""
    lines = []
    for name, text in NAMES.items():
        analysis = named(name)
        kinds = get_type_hints(analysis.options)
        given = [f"{one.name}: {_taken(one, kinds[one.name])}" for one in fields(analysis.options)]
        lines += [
            f"    def {name.replace(' ', '_')}(",
            "        self,",
            "        *,",
            *(f"        {one}," for one in [*given, *_of_run()]),
            f"    ) -> {_named(analysis.result)}:",
            *(f"        {line}" for line in wrap(f'"""{text}"""', 102)),
            "",
        ]
    modules = set(re.findall(r"([a-z_.]+)\.[A-Z]", "\n".join(lines)))
    ours = {one for one in modules if one.startswith("haptonic")}
    head = [
        '"""The methods of a study; docs/write_reference.py writes this from the table of analyses."""',
        "",
        *(f"import {one}" for one in sorted(modules - ours)),
        "",
        *(f"import {one}" for one in sorted(ours)),
        "",
        "class Methods:",
    ]
    return "\n".join(head + lines[:-1]) + "\n"


def _of_run() -> list[str]:
    """What every method takes besides its options, as `haptonic.Study.run` declares it."""
    kinds = get_type_hints(haptonic.Study.run)
    return [
        f"{name}: {_named(kinds[name])} = {one.default!r}"
        for name, one in inspect.signature(haptonic.Study.run).parameters.items()
        if one.kind is one.KEYWORD_ONLY
    ]


def _taken(one: Field[Any], kind: Any) -> str:
    """The type of an option and its default; a quantity may be a text with its unit, a path a text."""
    taken, known = _named(kind), option_of(one)
    if "pathlib.Path" in taken or (known and known.unit):
        taken = f"str | {taken}"
    return taken if one.default is MISSING and one.default_factory is MISSING else f"{taken} = ..."


def _named(kind: Any) -> str:
    """A type as an annotation has it, with its module."""
    if isinstance(kind, type) and not hasattr(kind, "__args__"):
        return f"{kind.__module__}.{kind.__qualname__}".removeprefix("builtins.")
    if get_origin(kind) in (Union, UnionType):  # typing writes Optional[...]
        return " | ".join("None" if one is type(None) else _named(one) for one in get_args(kind))
    return str(kind).replace("'", '"')


if __name__ == "__main__":
    PAGE.write_text(reference(), encoding="utf-8")
    METHODS.write_text(methods(), encoding="utf-8")
