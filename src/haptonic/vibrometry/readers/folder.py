"""A folder with one CSV file for each point, and a table of the points.

``geometry.csv`` has the columns ``file, x, y`` (in m, or as asked). A file of a point has a header line with
its columns: ``frequency, real, imaginary`` and perhaps ``coherence``, or ``frequency, amplitude, phase_deg``.
Units may follow in brackets: ``real (mm/s/V)``. A column ``origin`` in ``geometry.csv`` may say "simulated".
"""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import ScanError
from haptonic.paths import source
from haptonic.response import FrequencyResponse, Reference
from haptonic.vibrometry.curves import Curve, Place, assemble
from haptonic.vibrometry.findings import Notebook
from haptonic.vibrometry.labels import ratio_of
from haptonic.vibrometry.readers.tables import ORIGIN, Mapped, Origin

Array = NDArray[np.float64]

GEOMETRY = "geometry.csv"
COLUMNS = {
    "frequency": ("frequency", "freq", "f"),
    "real": ("real", "re"),
    "imaginary": ("imaginary", "imag", "im"),
    "amplitude": ("amplitude", "magnitude", "mag"),
    "phase": ("phase_deg", "phase"),
    "coherence": ("coherence", "coh"),
}


def read_folder(path: Path, how: Mapped, notes: Notebook, origin: Origin, title: str) -> FrequencyResponse:
    """Responses of a folder.

    Raises
    ------
    ScanError : there is no table of the points, or no point can be used
    """
    places, files, simulated = _geometry(path, how.length_unit, notes)
    curves: list[Curve] = []
    for name, file in files.items():
        try:
            curves += _curves(name, file, how, notes)
        except FileNotFoundError:
            notes.missing.append(name)
        except (_UnfitError, OSError, csv.Error) as error:
            notes.drop(f"file {file.name}", str(error))
    known = {file.name for file in files.values()} | {GEOMETRY}
    for file in sorted(path.glob("*.csv")):
        if file.name not in known:
            notes.drop(f"file {file.name}", f"it is not in {GEOMETRY}")
    origin = "simulated" if simulated else origin
    return assemble(curves, places, notes, origin=origin, title=title, inputs={"folder": path.name})


class _UnfitError(Exception):
    """A file of a point cannot be used; the text says why."""


def _geometry(
    path: Path, length_unit: float, notes: Notebook
) -> tuple[dict[str, Place], dict[str, Path], bool]:
    """Places and files of the points by name, and whether they are simulated."""
    table = path / GEOMETRY
    if not table.is_file():
        raise ScanError(
            argument="folder of a scan",
            given=f"{path}: no {GEOMETRY}",
            allowed=f"a folder with one CSV file for each point and {GEOMETRY} with the columns file, x, y",
            cause="another folder was chosen, or the coordinates were not exported",
            next_step=f"write {GEOMETRY}: a header file,x,y and one line for each file, in m",
        )
    places: dict[str, Place] = {}
    files: dict[str, Path] = {}
    simulated = False
    try:
        rows = list(csv.DictReader(_text(table), skipinitialspace=True))
    except (_UnfitError, csv.Error) as error:
        raise ScanError(
            argument=f"{GEOMETRY} of a scan",
            given=f"{table}: {error}",
            allowed="a table in UTF-8 with the columns file, x, y",
            cause="the file is no text, or of another encoding",
            next_step="save it again as CSV in UTF-8",
        ) from error
    for number, row in enumerate(rows, start=2):
        name = (row.get("file") or "").strip()
        simulated |= row.get(ORIGIN) == "simulated"
        try:
            place = Place(*(length_unit * float(row.get(axis) or "nan") for axis in "xy"))
        except ValueError:
            place = Place(np.nan, np.nan)
        if not name or Path(name).name != name:
            notes.drop(f"line {number} of {GEOMETRY}", "no name of a file in this folder")
        elif name in files:
            notes.drop(f"line {number} of {GEOMETRY}", f"{name} a second time; the first line is used")
        elif not np.isfinite([place.x, place.y]).all():
            notes.drop(f"point {name}", "no coordinates: x or y is not a number")
            files[name] = path / name
        else:
            places[name], files[name] = place, path / name
    return places, {name: file for name, file in files.items() if name in places}, simulated


def _text(file: Path) -> io.StringIO:
    """The text of a file, which names or units in the code page of an older program do not spoil.

    Raises
    ------
    FileNotFoundError, OSError : no such file, or it cannot be read
    _UnfitError : it holds bytes that no text has, or is no file that ends
    """
    try:
        content = source(file, "file of a point", ScanError).read_bytes()
    except ScanError as error:
        raise _UnfitError(error.cause) from None
    if b"\0" in content:
        raise _UnfitError("it holds bytes that no text has; UTF-16, or damaged")
    try:
        return io.StringIO(content.decode("utf-8-sig"), newline="")
    except UnicodeDecodeError:
        return io.StringIO(content.decode("latin-1"), newline="")


def _curves(name: str, file: Path, how: Mapped, notes: Notebook) -> list[Curve]:
    text = _text(file)
    first = text.readline()
    separator = ";" if first.count(";") > first.count(",") else "\t" if "\t" in first else ","
    heads = [head.strip() for head in first.split(separator)]
    rows = [row for row in csv.reader(text, delimiter=separator) if any(cell.strip() for cell in row)]
    columns = {meaning: i for meaning, names in COLUMNS.items() if (i := _column(heads, names)) is not None}
    if "frequency" not in columns or not ({"real", "imaginary"} <= columns.keys()
                                          or {"amplitude", "phase"} <= columns.keys()):  # fmt: skip
        raise _UnfitError("no columns frequency, real, imaginary (or amplitude, phase_deg)")
    short = [i for i, row in enumerate(rows, start=2) if len(row) != len(heads)]
    if short:
        raise _UnfitError(f"line {short[0]} has another number of cells than the header; cut short?")
    try:
        table = np.array([[float(cell) for cell in row] for row in rows])
    except ValueError as error:
        raise _UnfitError(f"a cell is not a number ({error})") from None
    if not len(table):
        raise _UnfitError("it holds no values")
    column = {meaning: table[:, i] for meaning, i in columns.items()}
    if "real" in column and "imaginary" in column:
        values, head = column["real"] + 1j * column["imaginary"], heads[columns["real"]]
    else:
        values = column["amplitude"] * np.exp(1j * np.deg2rad(column["phase"]))
        head = heads[columns["amplitude"]]
    ratio = ratio_of(_unit(head) or how.unit)
    if ratio.over.motion is None:
        raise _UnfitError(f'"{_unit(head)}" is no displacement, velocity or acceleration')
    written = _unit(heads[columns["frequency"]])
    column["frequency"] = {"kHz": 1e3, "Hz": 1.0}.get(written, how.frequency_unit) * column["frequency"]
    reference = how.reference_of(ratio)
    made = [
        Curve(f"file {file.name}", name, 3, "response", column["frequency"], ratio.factor * values,
              ratio.over.motion, reference)
    ]  # fmt: skip
    if "coherence" in column:
        made.append(
            Curve(f"file {file.name}", name, 3, "coherence", column["frequency"], column["coherence"],
                  ratio.over.motion, Reference())
        )  # fmt: skip
    return made


def _column(heads: list[str], names: tuple[str, ...]) -> int | None:
    plain = [re.sub(r"[\[(].*", "", head).strip().lower() for head in heads]
    return next((plain.index(name) for name in names if name in plain), None)


def _unit(head: str) -> str:
    found = re.search(r"[\[(](.*)[\])]\s*$", head)
    return found[1] if found else ""
