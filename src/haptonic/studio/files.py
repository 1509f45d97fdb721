"""Files of a result for the user: pictures in a style, tables in a form, data files, or its whole folder."""

from __future__ import annotations

import io
import math
import re
import zipfile
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from haptonic import plots
from haptonic.errors import StudyError, shown
from haptonic.plots.looks import LOOKS, AxisUnit
from haptonic.results.result import Result
from haptonic.results.table import FORMS

PICTURES = ("svg", "pdf", "png")
ENDINGS = {"latex": "tex", "markdown": "md"}  # of tables, where it is not the name of the form
UNITS = {"Hz": ("Hz", "kHz", "MHz", "ωa/(2πcₜ)"), "rad/m": ("rad/m", "π/a", "2π/a")}  # as in units.ts
OTHERS = re.compile(r"[^A-Za-z0-9._+-]+")


@dataclass(frozen=True)
class Export:
    """A file to make of a result.

    kind : "picture", "table", "file", or "folder" for everything; name : of the picture, table or file
    form : format of a picture or table; style : of a picture
    units : of the axes of a picture by the SI unit of their quantity
    """

    kind: str
    name: str
    form: str
    style: str
    units: dict[str, AxisUnit] = field(default_factory=dict)


def choices() -> dict[str, Any]:
    """Forms and styles that the page offers."""
    looks = {name: f"{name}, {10 * look.width:g} mm" for name, look in LOOKS.items()}
    return {"pictures": PICTURES, "looks": looks, "tables": list(FORMS)}


def chosen_export(given: dict[str, Any]) -> Export:
    """The export that the page asks for.

    Raises
    ------
    StudyError : another kind, form or style
    """
    kind, name = given.get("kind"), given.get("name", "")
    form, style = given.get("form", ""), given.get("style", "plain")
    allowed = {"picture": PICTURES, "table": tuple(FORMS), "file": ("",), "folder": ("",)}
    for argument, value, names in (
        ("kind", kind, allowed), ("form", form, allowed.get(str(kind), ())), ("style", style, LOOKS),
    ):  # fmt: skip
        if not isinstance(value, str) or value not in names:
            raise StudyError.unknown(argument, shown(value), list(names), "the page does not offer it")
    units = _units(given.get("units", {}))
    return Export(kind=str(kind), name=str(name), form=form, style=style, units=units)


def _units(given: object) -> dict[str, AxisUnit]:
    """Units of axes, each with its factor, which depends on the pitch and the material of the design."""
    units = {}
    for quantity, unit in given.items() if isinstance(given, dict) else [("", given)]:
        name, factor = unit if isinstance(unit, list) and len(unit) == 2 else ("", 0)
        is_number = isinstance(factor, int | float) and math.isfinite(factor) and factor > 0
        if name not in UNITS.get(quantity, ()) or not is_number:
            every = [each for of_quantity in UNITS.values() for each in of_quantity]
            raise StudyError.unknown("units", shown(given), every, "the page does not offer it")
        units[quantity] = AxisUnit(name, float(factor))
    return units


def picture_export(name: str) -> Export:
    """The export of a picture for the page."""
    return Export(kind="picture", name=name, form="svg", style="plain")


def file_of(result: Result, export: Export, analysis: str) -> tuple[str, bytes]:
    """Name and content of an exported file.

    Raises
    ------
    StudyError : the result has no picture, table or file of this name
    """
    match export.kind:
        case "picture":
            _need(export.name, result.figures)
            with plots.chosen(export.style, units=export.units):
                content = plots.rendered(result.figures[export.name], export.form)
            name = f"{export.name}.{export.form}"
        case "table":
            tables = {table.title: table for table in result.tables()}
            _need(export.name, tables)
            content = tables[export.name].labelled(result.origin).written(export.form).encode()
            name = f"{export.name}.{ENDINGS.get(export.form, export.form)}"
        case "file":
            names = {str(name): write for name, write in result.files.items()}
            _need(export.name, names)
            with TemporaryDirectory() as folder:
                path = Path(folder, f"file{Path(export.name).suffix}")
                names[export.name](path)
                content = path.read_bytes()
            name = export.name
        case _:
            content, name = _zipped(result), f"{analysis}.zip"
    return OTHERS.sub("_", name).lstrip("."), content


def _zipped(result: Result) -> bytes:
    """The folder of a result, as `Result.write` writes it."""
    content = io.BytesIO()
    with TemporaryDirectory() as folder:
        result.write(Path(folder))
        with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as parts:
            for path in sorted(Path(folder).rglob("*")):
                if path.is_file():
                    parts.write(path, path.relative_to(folder))
    return content.getvalue()


def _need(name: str, known: Any) -> None:
    if name not in known:
        raise StudyError.unknown("name", shown(name), list(known), "the result has nothing of this name")
