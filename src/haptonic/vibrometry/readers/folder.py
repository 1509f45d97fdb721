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

from haptonic.arrays import Array
from haptonic.channels import Channel, Notebook, delimited
from haptonic.channels.labels import label_of, ratio_of
from haptonic.channels.signals import ORIGIN, SIMULATED, Origin
from haptonic.errors import ChannelError, ScanError
from haptonic.response import FrequencyResponse, Reference
from haptonic.vibrometry.curves import Curve, Point, assemble
from haptonic.vibrometry.readers.tables import Mapped

GEOMETRY = "geometry.csv"
MOST_NAMED = 3  # folders, in a message
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
        except (_UnfitError, OSError) as error:
            notes.drop(f"file {file.name}", str(error))
        except ChannelError as error:
            notes.drop(f"file {file.name}", error.given)
    known = {file.name for file in files.values()} | {GEOMETRY}
    for file in sorted(path.glob("*.csv")):
        if file.name not in known:
            notes.drop(f"file {file.name}", f"it is not in {GEOMETRY}")
    origin = SIMULATED if simulated else origin
    return assemble(curves, places, notes, origin=origin, title=title, inputs={"folder": path.name})


def _without_points(path: Path) -> ScanError:
    """What to say of a folder that is no scan, but perhaps holds one."""
    cause, next_step = (
        "another folder was chosen, or the coordinates were not exported",
        f"write {GEOMETRY}: a header file,x,y and one line for each file, in m",
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


class _UnfitError(Exception):
    """A file of a point cannot be used; the text says why."""


def _geometry(
    path: Path, length_unit: float, notes: Notebook
) -> tuple[dict[str, Point], dict[str, Path], bool]:
    """Places and files of the points by name, and whether they are simulated."""
    table = path / GEOMETRY
    if not table.is_file():
        raise _without_points(path)
    places: dict[str, Point] = {}
    files: dict[str, Path] = {}
    simulated = False
    try:
        text = io.StringIO(delimited.text_of(table), newline="")
        rows = list(csv.DictReader(text, skipinitialspace=True))
    except (ChannelError, csv.Error) as error:
        raise ScanError.unreadable(
            argument=f"{GEOMETRY} of a scan",
            given=f"{table}: {error.given if isinstance(error, ChannelError) else error}",
            allowed="a table in UTF-8 with the columns file, x, y",
            cause="the file is no text, or of another encoding",
            next_step="save it again as CSV in UTF-8",
        ) from error
    for number, row in enumerate(rows, start=2):
        name = (row.get("file") or "").strip()
        simulated |= row.get(ORIGIN) == SIMULATED
        try:
            place = Point(*(length_unit * float(row.get(axis) or "nan") for axis in "xy"))
        except ValueError:
            place = Point(np.nan, np.nan)
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


def _curves(name: str, file: Path, how: Mapped, notes: Notebook) -> list[Curve]:
    group = delimited.read(file, notes)[""]
    # a unit whose bracket is not closed is none, and no reason to lose the column
    found = {re.split(r"[\[(]", head)[0].strip().lower(): one for head, one in group.channels.items()}
    columns = {
        meaning: next(found[head] for head in heads if head in found)
        for meaning, heads in COLUMNS.items()
        if not found.keys().isdisjoint(heads)
    }
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
    made = [Curve(source, name, 3, "response", lines, ratio.factor * values, motion, reference)]
    if "coherence" in column:
        made.append(Curve(source, name, 3, "coherence", lines, column["coherence"], motion, Reference()))
    return made


def _numbers(channel: Channel) -> Array:
    try:
        return np.asarray(channel, dtype=float)
    except ValueError as error:
        raise _UnfitError(f"a cell is not a number ({error})") from None
