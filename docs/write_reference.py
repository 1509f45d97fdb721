"""Write docs/reference.md: every public name of every package, from the sources; a test holds it to them."""

from __future__ import annotations

import inspect
from importlib import import_module
from pathlib import Path
from pkgutil import walk_packages

import haptonic
from haptonic.analyses import NAMES, named
from haptonic.analyses.options import option_of

PAGE = Path(__file__).parent / "reference.md"


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


if __name__ == "__main__":
    PAGE.write_text(reference(), encoding="utf-8")
