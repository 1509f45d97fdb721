"""A folder with one CSV file for each point, and a table of the points.

``geometry.csv``, or the one table of another name that has them, has the columns ``file, x, y`` (in m, or as
asked). A file of a point has a header line with its columns: ``frequency, real, imaginary`` and perhaps
``coherence``, or ``frequency, amplitude, phase_deg``. Units may follow in brackets: ``real (mm/s/V)``,
``x [mm]``. A column ``origin`` in the table of the points may say "simulated".
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from haptonic.arrays import Array
from haptonic.channels import Channel, Notebook, delimited
from haptonic.channels.labels import label_of, ratio_of
from haptonic.channels.signals import SIMULATED, Origin
from haptonic.channels.text_table import read_table
from haptonic.errors import ChannelError, ScanError
from haptonic.response import FrequencyResponse, Reference
from haptonic.vibrometry.curves import Curve, Point, assemble
from haptonic.vibrometry.readers.tables import Mapped

GEOMETRY = "geometry.csv"
MOST_NAMED = 3  # folders, in a message
PLACES = {"file": ("file", "filename", "file name", "name", "point"), "x": ("x",), "y": ("y",)}
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
    table = _table_of_points(path, notes)
    places, files, simulated = _geometry(path, table, how.length_unit, notes)
    curves: list[Curve] = []
    for name, file in files.items():
        try:
            curves += _curves(name, file, how, notes)
        except FileNotFoundError:
            notes.missing.append(name)
        except (_UnfitError, OSError) as error:
            notes.drop(f"file {file.name}", str(error))
        except ChannelError as error:
            notes.drop(f"file {file.name}", error.given)
    known = {file.name for file in files.values()} | {table.name}
    for file in sorted(path.glob("*.csv")):
        if file.name not in known:
            notes.drop(f"file {file.name}", f"it is not in {table.name}")
    origin = SIMULATED if simulated else origin
    return assemble(curves, places, notes, origin=origin, title=title, inputs={"folder": path.name})


def _without_points(path: Path) -> ScanError:
    """What to say of a folder that is no scan, but perhaps holds one."""
    cause, next_step = (
        "another folder was chosen, or the coordinates were not exported",
        f"write {GEOMETRY}: a header file,x,y and one line for each file, in m; or x [mm],y [mm]",
    )
    if not any(path.glob("*.csv")):
        for name in (GEOMETRY, "*.csv"):
            below = sorted({file.parent for depth in ("*/", "*/*/") for file in path.glob(depth + name)})
            if below:
                cause = f"CSV files lie in {', '.join(map(str, below[:MOST_NAMED]))}, not in {path} itself"
                next_step = f"give that folder: {below[0]}"
                break
    return ScanError.missing(
        argument="folder of a scan",
        given=f"{path}: no {GEOMETRY}",
        allowed=f"a folder with one CSV file for each point and {GEOMETRY} with the columns file, x, y",
        cause=cause,
        next_step=next_step,
    )


def _without_columns(table: Path, found: Iterable[str], missing: Iterable[str]) -> ScanError:
    return ScanError.missing(
        argument=f"{table.name} of a scan",
        given=f"columns {', '.join(found) or 'without names'}",
        allowed="the columns file, x, y, parted by commas, semicolons or tabs",
        cause=f"no column is called {' or '.join(sorted(missing))}",
        next_step=f"name them in the first line of {table.name}: file,x,y",
    )


class _UnfitError(Exception):
    """A file of a point cannot be used; the text says why."""


def _table_of_points(path: Path, notes: Notebook) -> Path:
    """``geometry.csv``, or the only other table with names of files, x and y."""
    if (path / GEOMETRY).is_file():
        return path / GEOMETRY
    named = []
    for file in sorted(path.glob("*.csv")):
        try:
            if (
                _meant(dict.fromkeys(read_table(file, texts=PLACES["file"]).names), PLACES).keys()
                == PLACES.keys()
            ):
                named.append(file)
        except (ChannelError, OSError):
            continue  # what is wrong with it is said when it is read as a point
    if len(named) != 1:
        raise _without_points(path)
    notes.remark(f"{named[0].name} was taken as the table of the points")
    return named[0]


def _meant(found: Mapping[str, Any], known: Mapping[str, tuple[str, ...]]) -> dict[str, Any]:
    """What belongs to the columns of a table, by what they mean; a unit behind a name is none of it."""
    # a unit whose bracket is not closed is none, and no reason to lose the column
    plain = {re.split(r"[\[(]", head)[0].strip().lower(): one for head, one in found.items()}
    return {
        meaning: next(plain[head] for head in heads if head in plain)
        for meaning, heads in known.items()
        if not plain.keys().isdisjoint(heads)
    }


def _geometry(
    path: Path, table: Path, length_unit: float, notes: Notebook
) -> tuple[dict[str, Point], dict[str, Path], bool]:
    """Places and files of the points by name, and whether they are simulated."""
    places: dict[str, Point] = {}
    files: dict[str, Path] = {}
    try:
        group = delimited.read(table, notes, texts=PLACES["file"])[""]
    except ChannelError as error:
        raise ScanError.unreadable(
            argument=f"{table.name} of a scan",
            given=f"{table}: {error.given}",
            allowed="a table in UTF-8 with the columns file, x, y",
            cause="the file is no text, or of another encoding",
            next_step="save it again as CSV in UTF-8",
        ) from error
    columns = _meant(group.channels, PLACES)
    if missing := PLACES.keys() - columns.keys():
        raise _without_columns(table, group.channels, missing)
    units = {axis: label_of(columns[axis].unit) for axis in "xy"}
    scale = {axis: one.factor if one.unit == "m" else length_unit for axis, one in units.items()}
    for number, row in enumerate(zip(*(np.asarray(columns[one]) for one in PLACES), strict=True), start=2):
        name = str(row[0]).strip()
        try:
            place = Point(scale["x"] * float(row[1]), scale["y"] * float(row[2]))
        except ValueError:
            place = Point(np.nan, np.nan)
        if name in ("", "nan") or Path(name).name != name:
            notes.drop(f"line {number} of {table.name}", "no name of a file in this folder")
        elif name in files:
            notes.drop(f"line {number} of {table.name}", f"{name} a second time; the first line is used")
        elif not np.isfinite([place.x, place.y]).all():
            notes.drop(f"point {name}", "no coordinates: x or y is not a number")
            files[name] = path / name
        else:
            places[name], files[name] = place, path / name
    return places, {name: file for name, file in files.items() if name in places}, group.simulated


def _curves(name: str, file: Path, how: Mapped, notes: Notebook) -> list[Curve]:
    group = delimited.read(file, notes)[""]
    columns = _meant(group.channels, COLUMNS)
    if "frequency" not in columns or not ({"real", "imaginary"} <= columns.keys()
                                          or {"amplitude", "phase"} <= columns.keys()):  # fmt: skip
        raise _UnfitError("no columns frequency, real, imaginary (or amplitude, phase_deg)")
    if delimited.UNEVEN in group.properties:
        line = group.properties[delimited.UNEVEN]
        raise _UnfitError(f"line {line} has another number of cells than the header; cut short?")
    column = {meaning: _numbers(channel) for meaning, channel in columns.items()}
    if not column["frequency"].size:
        raise _UnfitError("it holds no values")
    if "real" in column and "imaginary" in column:
        values, unit = column["real"] + 1j * column["imaginary"], columns["real"].unit
    else:
        values = column["amplitude"] * np.exp(1j * np.deg2rad(column["phase"]))
        unit = columns["amplitude"].unit
    ratio = ratio_of(unit or how.unit)
    if ratio.over.motion is None:
        raise _UnfitError(f'"{unit}" is no displacement, velocity or acceleration')
    written = label_of(columns["frequency"].unit)
    lines = (written.factor if written.unit == "Hz" else how.frequency_unit) * column["frequency"]
    source, motion = f"file {file.name}", ratio.over.motion
    reference = how.reference_of(ratio)
    made = [
        Curve(
            source=source,
            point=name,
            axis=3,
            kind="response",
            frequency=lines,
            values=ratio.factor * values,
            motion=motion,
            reference=reference,
        )
    ]
    if "coherence" in column:
        made.append(
            Curve(
                source=source,
                point=name,
                axis=3,
                kind="coherence",
                frequency=lines,
                values=column["coherence"],
                motion=motion,
                reference=Reference(),
            )
        )
    return made


def _numbers(channel: Channel) -> Array:
    try:
        return np.asarray(channel, dtype=float)
    except ValueError as error:
        raise _UnfitError(f"a cell is not a number ({error})") from None
