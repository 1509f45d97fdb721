"""Write the pages and types that follow from the sources; a test compares them with these.

- docs/reference.md: commands with their options, and the packages
- docs/api/PACKAGE.md: every public name of a package with signature, units, results, errors and examples
- study/methods.pyi: types of the methods of a study, for editors and type checkers
"""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Iterator
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
from haptonic.fields.keys import is_described, slots

PAGE = Path(__file__).parent / "reference.md"
API = Path(__file__).parent / "api"
METHODS = Path(haptonic.__file__).parent / "study" / "methods.pyi"
SECTIONS = {"Parameters": "Parameters", "Returns": "Returns", "Raises": "Errors", "Notes": "Notes"}
LONGEST_DEFAULT = 24  # characters of a default in a signature
COLUMNS = 80  # of a signature


def packages() -> list[str]:
    """The packages, those within others too, that list their public names, and the lattices."""
    inner = [module.name for module in walk_packages(haptonic.__path__, "haptonic.") if module.ispkg]
    inner = [name for name in inner if hasattr(import_module(name), "__all__")]
    return ["haptonic", *sorted([*inner, "haptonic.lattice"])]


def pages() -> dict[Path, str]:
    """All that is written, by its path."""
    return {
        PAGE: reference(),
        METHODS: methods(),
        **{API / f"{package}.md": page for package, page in package_pages()},
    }


def reference() -> str:
    """The page of commands and packages."""
    lines = [
        "# Python API",
        "",
        "`import haptonic as hp` gives the names of the first package. All numbers are in SI units.",
        "[Errors](errors.md) lists the codes and classes of errors.",
        "",
        "## Analyses",
        "",
        "Each analysis is a command and a method of a study with the same options: `haptonic bands my.toml",
        '--surface` and `hp.load("my.toml").bands(surface=True)`. A method returns a result with',
        "`summary()`, `tables()`, `plot()`, `to_dataframe()`, `to_json()`, `write(folder)` and `dataset`.",
    ]
    for name, text in NAMES.items():
        given = named(name).options.__dataclass_fields__.values()
        options = [(field.name, known) for field in given if (known := option_of(field))]
        lines += ["", f"### {name}", "", text]
        if options:
            lines += ["", "| option | unit | meaning |", "|---|---|---|"]
            lines += [
                f"| `{option}` | {known.unit or ''} | {cell(known.help)} |" for option, known in options
            ]
    lines += ["", "## Packages", "", "| package | content |", "|---|---|"]
    lines += [
        f"| [{package}](api/{package}.md) | {cell(summary_of(import_module(package)))} |"
        for package in packages()
    ]
    lines += ["", "```{toctree}", ":hidden:", "", *(f"api/{package}" for package in packages()), "```"]
    return "\n".join(lines) + "\n"


def package_pages() -> Iterator[tuple[str, str]]:
    """Each package with its page; a name that an earlier page describes is a link to it."""
    described: dict[int, str] = {}
    for package in packages():
        module = import_module(package)
        lines = [f"# {package}", "", summary(module)]
        for name in sorted(module.__all__):
            value = getattr(module, name)
            lines += ["", f"## {name}", ""]
            known = inspect.isclass(value) or inspect.isroutine(value)
            if known and id(value) in described:
                page = described[id(value)]
                lines += [f"{summary(value)} See [{page}]({page}.md#{name.lower()})."]
                continue
            described[id(value)] = package
            lines += entry(name, value) if known else [f"A value of the type {type(value).__name__}."]
        yield package, "\n".join(lines) + "\n"


def entry(name: str, value: Any) -> list[str]:
    """Signature, docstring, fields and methods of a class or function."""
    lines = ["```python", signature(name, value), "```", "", *prose(inspect.getdoc(value) or "")]
    if inspect.isclass(value):
        lines += declared_fields(value)
        lines += members(value)
    return lines


def signature(name: str, value: Any) -> str:
    """As source text, a parameter on each line where it is long; units of fields are in their table."""
    try:
        known = inspect.signature(value)
    except ValueError:  # of a class that is built by no function
        return name
    parts, positional = [], True
    for parameter in known.parameters.values():
        if parameter.kind is parameter.KEYWORD_ONLY and positional:
            parts, positional = [*parts, "*"], False
        if parameter.kind is parameter.VAR_POSITIONAL:
            positional = False
        stars = {parameter.VAR_POSITIONAL: "*", parameter.VAR_KEYWORD: "**"}.get(parameter.kind, "")
        kind = "" if parameter.annotation is parameter.empty else f": {annotation(parameter.annotation)}"
        default = ""
        if parameter.default is not parameter.empty:
            text = repr(parameter.default)
            default = f" = {text if len(text) <= LONGEST_DEFAULT and ' at 0x' not in text else '...'}"
        parts.append(f"{stars}{parameter.name}{kind}{default}")
    returned = known.return_annotation
    after = "" if inspect.isclass(value) or returned is known.empty else f" -> {annotation(returned)}"
    whole = f"{name}({', '.join(parts)}){after}"
    return whole if len(whole) <= COLUMNS else f"{name}(\n    " + ",\n    ".join(parts) + f",\n){after}"


def annotation(kind: Any) -> str:
    """A type without its declarations: ``Annotated[float, ...]`` is float."""
    text = kind if isinstance(kind, str) else _named(kind)
    try:
        tree = ast.parse(text, mode="eval")
    except SyntaxError:
        return text
    return ast.unparse(_Plain().visit(tree))


class _Plain(ast.NodeTransformer):
    def visit_Subscript(self, node: ast.Subscript) -> Any:
        self.generic_visit(node)
        is_annotated = isinstance(node.value, ast.Name) and node.value.id == "Annotated"
        return node.slice.elts[0] if is_annotated and isinstance(node.slice, ast.Tuple) else node


def summary(value: object) -> str:
    """The first paragraph of a docstring in one line of Markdown."""
    return markdown(summary_of(value).replace("\n", " "))


def cell(text: str) -> str:
    """A text as the cell of a table."""
    return markdown(text).replace("|", "\\|").replace("\n", " ")


def markdown(text: str) -> str:
    """Code of reStructuredText as that of Markdown; no HTML."""
    pieces = re.split(r"(`+[^`]+`+)", text)
    return "".join(
        f"`{piece.strip('`')}`" if piece.startswith("`") else re.sub(r"([<*_\[\]])", r"\\\1", piece)
        for piece in pieces
    )


def prose(text: str) -> list[str]:
    """A docstring in Markdown: paragraphs, lists of names, sections, examples."""
    lines: list[str] = []
    for block in re.split(r"\n\s*\n", text):
        title = re.match(r"(\w+)\n-+\n", block)
        if title:
            lines += [f"**{SECTIONS.get(title[1], title[1])}**", ""]
            block = block[title.end() :]
        if block.lstrip().startswith(">>>"):
            lines += ["```pycon", block, "```", ""]
        else:
            lines += [*paragraph(block), ""]
    return lines


def paragraph(block: str) -> list[str]:
    """Lines ``name : meaning`` as a list, others as they are."""
    joined = re.sub(r"\n {2,}", " ", block)
    if not re.search(r"^[\w`, .*]+ : ", joined, re.MULTILINE):
        return [markdown(joined)]
    lines = []
    for line in re.split(r"\n|; (?=[\w`, ]+ : )", joined):
        names, colon, meaning = line.partition(" : ")
        named_ = colon and re.fullmatch(r"[\w`, .*]+", names)
        lines.append(f"- `{names.strip('`')}`: {markdown(meaning)}" if named_ else f"- {markdown(line)}")
    return lines


def declared_fields(kind: type) -> list[str]:
    """The fields that a study declares, with unit, default and meaning."""
    if not is_described(kind):
        return []
    rows = []
    for slot in slots(kind):
        unit = " or ".join(dict.fromkeys(quantity.unit or "1" for quantity in slot.quantities))
        default = slot.field.default
        shown = "" if default is None or len(repr(default)) > LONGEST_DEFAULT else f"`{default!r}`"
        shown = "required" if slot.field.is_required() else shown
        meaning = " ".join(
            filter(None, [f"{slot.field.title}." if slot.field.title else "", slot.field.description])
        )
        rows.append(f"| `{slot.name}` | {unit} | {shown} | {cell(meaning)} |")
    return ["| field | unit | default | meaning |", "|---|---|---|---|", *rows, ""] if rows else []


def members(kind: type) -> list[str]:
    """Public methods and properties of a class that it defines itself."""
    rows = []
    for name, value in vars(kind).items():
        plain = value.__func__ if isinstance(value, classmethod | staticmethod) else value
        if name.startswith("_") or not inspect.getdoc(plain):
            continue
        if isinstance(plain, property) or hasattr(plain, "func"):
            rows.append(f"| `{name}` | {cell(summary_of(plain))} |")
        elif inspect.isfunction(plain):
            given = [
                parameter
                for parameter in inspect.signature(plain).parameters
                if parameter not in ("self", "cls")
            ]
            rows.append(f"| `{name}({', '.join(given)})` | {cell(summary_of(plain))} |")
    return ["| member | meaning |", "|---|---|", *rows, ""] if rows else []


def summary_of(value: object) -> str:
    """The first paragraph of a docstring as it is written."""
    return (inspect.getdoc(value) or "").split("\n\n")[0]


def methods() -> str:
    """The types of what a study is asked for: a method for each analysis, with its options and its result."""
    lines = []
    for name, text in NAMES.items():
        analysis = named(name)
        kinds = get_type_hints(analysis.options)
        given = [f"{field.name}: {_taken(field, kinds[field.name])}" for field in fields(analysis.options)]
        lines += [
            f"    def {name.replace(' ', '_')}(",
            "        self,",
            "        *,",
            *(f"        {parameter}," for parameter in [*given, *_of_run()]),
            f"    ) -> {_named(analysis.result)}:",
            *(f"        {line}" for line in wrap(f'"""{text}"""', 102)),
            "",
        ]
    modules = set(re.findall(r"([a-z_.]+)\.[A-Z]", "\n".join(lines)))
    ours = {module for module in modules if module.startswith("haptonic")}
    head = [
        '"""The methods of a study; docs/write_reference.py writes this from the table of analyses."""',
        "",
        *(f"import {module}" for module in sorted(modules - ours)),
        "",
        *(f"import {module}" for module in sorted(ours)),
        "",
        "class Methods:",
    ]
    return "\n".join(head + lines[:-1]) + "\n"


def _of_run() -> list[str]:
    """What every method takes besides its options, as `haptonic.Study.run` declares it."""
    kinds = get_type_hints(haptonic.Study.run)
    return [
        f"{name}: {_named(kinds[name])} = {parameter.default!r}"
        for name, parameter in inspect.signature(haptonic.Study.run).parameters.items()
        if parameter.kind is parameter.KEYWORD_ONLY
    ]


def _taken(field: Field[Any], kind: Any) -> str:
    """The type of an option and its default; a quantity may be a text with its unit, a path a text."""
    taken, known = _named(kind), option_of(field)
    if "pathlib.Path" in taken or (known and known.unit):
        taken = f"str | {taken}"
    return taken if field.default is MISSING and field.default_factory is MISSING else f"{taken} = ..."


def _named(kind: Any) -> str:
    """A type as an annotation has it, with its module."""
    if isinstance(kind, type) and not hasattr(kind, "__args__"):
        return f"{kind.__module__}.{kind.__qualname__}".removeprefix("builtins.")
    if get_origin(kind) in (Union, UnionType):  # typing writes Optional[...]
        return " | ".join("None" if part is type(None) else _named(part) for part in get_args(kind))
    return str(kind).replace("'", '"')


if __name__ == "__main__":
    API.mkdir(exist_ok=True)
    for path, text in pages().items():
        path.write_text(text, encoding="utf-8")
