"""Scan in a folder with one CSV file for each point, and a table of the points.

The table ``geometry.csv``, or the only table of another name with these columns, has the columns ``file, x,
y`` (in m or a given unit). A file of a point has a line of names: ``frequency, real, imaginary``, or
phase``, and perhaps ``coherence``. Units may follow in brackets, ``real (mm/s/V)``, ``x [mm]``, or in a line
below the names. A column ``origin`` in the table of the points may contain "simulated".
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from haptonic.channels import Channel, Group, Notebook, delimited
from haptonic.channels.signals import SIMULATED, Origin
from haptonic.errors import ChannelError, ScanError
from haptonic.names import listed
from haptonic.response import FrequencyResponse, Reference
from haptonic.vibrometry.curves import Curve, Point, assemble
from haptonic.vibrometry.readers.mapped import NAMES, Mapped, check_meanings, chosen, inventory, unfit
from haptonic.vibrometry.readers.quantities import (
    UnfitError,
    frequency_factor,
    largest_of,
    length_factor,
    numbers,
    of_amplitude,
    phase_factor,
    response_unit,
    share_factor,
)
from haptonic.vibrometry.readers.uff import estimator_of, points_by_order

GEOMETRY = "geometry.csv"
MOST_NAMED = 3  # folders, in a message
PLACES = ("file", "x", "y")
COLUMNS = ("frequency", "response", "real", "imaginary", "amplitude", "phase", "coherence")
PARTS = (("real", "imaginary"), ("amplitude", "phase"), ("response",))


@dataclass(frozen=True, eq=False)
class PointFile:
    """File of a point: all its columns, and those with a known meaning."""

    path: Path
    group: Group
    columns: Mapping[str, Channel]

    @property
    def parts(self) -> tuple[str, ...] | None:
        """The columns that form a complex response."""
        return next((pair for pair in PARTS if {*pair} <= self.columns.keys()), None)


def read_folder(path: Path, how: Mapped, notes: Notebook, origin: Origin, title: str) -> FrequencyResponse:
    """Read the responses of a folder.

    Raises
    ------
    ScanError : no table of the points, or no usable point
    """
    check_meanings(how, (*PLACES, *COLUMNS))
    if how.at:
        files = {file.name: file for file in sorted(path.glob("*.csv")) if file.name != GEOMETRY}
        places = points_by_order(list(files), how.at, notes)
        listed_files, simulated = set(files), False
    else:
        table = _table_of_points(path, how, notes)
        places, files, simulated = _geometry(path, table, how, notes)
        listed_files = {file.name for file in files.values()} | {table.name}
        for file in sorted(path.glob("*.csv")):
            if file.name not in listed_files:
                notes.drop(f"file {file.name}", f"it is not in {table.name}")
    points, errors = _point_files(files, how, notes)
    if not points and errors:
        raise errors[0]
    phases = [_largest_phase(point) for point in points.values()]
    curves: list[Curve] = []
    for name, point in points.items():
        try:
            curves += curves_of(name, point, how, notes, max(phases))
        except UnfitError as error:
            notes.drop(f"file {point.path.name}", str(error))
        except ChannelError as error:
            notes.drop(f"file {point.path.name}", error.given)
    origin = SIMULATED if simulated else origin
    return assemble(
        curves,
        places,
        notes,
        estimator=how.estimator,
        origin=origin,
        title=title,
        inputs={"folder": path.name},
    )


def _point_files(
    files: Mapping[str, Path], how: Mapped, notes: Notebook
) -> tuple[dict[str, PointFile], list[ScanError]]:
    """Files of the points with responses; and errors for the others, which list their columns."""
    points: dict[str, PointFile] = {}
    errors: list[ScanError] = []
    mine = replace(how, variables={k: name for k, name in how.variables.items() if k in COLUMNS})
    for name, file in files.items():
        try:
            group = delimited.read(file, notes)[""]
            point = PointFile(file, group, chosen(group.channels, mine, Notebook(file, ""), COLUMNS))
        except FileNotFoundError:
            notes.missing.append(name)
        except OSError as error:
            notes.drop(f"file {file.name}", str(error))
        except ScanError as error:
            errors.append(error)
            notes.drop(f"file {file.name}", f"{error.argument}: {error.given}")
        except ChannelError as error:
            notes.drop(f"file {file.name}", error.given)
        else:
            if "frequency" in point.columns and point.parts:
                points[name] = point
                continue
            needed = ("frequency", "real", "imaginary")
            lacking = "no columns frequency, real, imaginary (or amplitude, phase)"
            errors.append(unfit(file.name, lacking, group.channels, notes, how, needed))
            notes.drop(f"file {file.name}", f"{lacking}; it has {inventory(group.channels, notes)}")
    return points, errors


def _largest_phase(point: PointFile) -> float:
    """Largest phase of a point without a unit of phases, or 0."""
    try:
        return largest_of(numbers(point.columns["phase"])) if "phase" in point.columns else 0.0
    except (UnfitError, ChannelError):
        return 0.0  # making the response raises the error


def curves_of(
    name: str, point: PointFile, how: Mapped, notes: Notebook, largest_phase: float | None = None
) -> list[Curve]:
    """The response of a point, and its coherence.

    largest_phase : of all points, if the phases have no unit; by default of this one

    Raises
    ------
    UnfitError, ChannelError : columns that form no response
    """
    largest_phase = _largest_phase(point) if largest_phase is None else largest_phase
    columns, parts = point.columns, point.parts
    assert parts is not None
    if delimited.UNEVEN in point.group.properties:
        line = point.group.properties[delimited.UNEVEN]
        raise UnfitError(f"line {line} has another number of cells than the header; cut short?")
    lines = frequency_factor(columns["frequency"].unit, how, notes) * numbers(columns["frequency"])
    if not lines.size:
        raise UnfitError("it has no values")
    if parts == ("response",):
        if columns["response"].kind != "complex":
            raise UnfitError("real numbers: the phase is missing")
        values = np.asarray(columns["response"]).ravel()
    elif parts == ("real", "imaginary"):
        values = numbers(columns["real"]) + 1j * numbers(columns["imaginary"])
    else:
        factor = phase_factor(columns["phase"], largest_phase, how, notes)
        values = of_amplitude(
            numbers(columns["amplitude"]), factor * numbers(columns["phase"]), columns["amplitude"].unit
        )
    of_unit = [columns[part] for part in parts if part != "phase"]
    ratio = response_unit(of_unit, how, notes)
    like = Curve(
        source=f"file {point.path.name}", point=name, axis=3, kind="response", frequency=lines,
        values=ratio.factor * values, motion=ratio.over.motion or "velocity",
        reference=how.reference_of(ratio),
        estimator=estimator_of([*point.group.properties.get(delimited.TITLES, ()), *point.group.channels]),
    )  # fmt: skip
    if "coherence" not in columns:
        return [like]
    share = share_factor(columns["coherence"].unit) * numbers(columns["coherence"])
    return [like, replace(like, kind="coherence", values=share, reference=Reference(), estimator="")]


def _table_of_points(path: Path, how: Mapped, notes: Notebook) -> Path:
    """``geometry.csv``, or the only other table with names of files, x and y."""
    if (path / GEOMETRY).is_file():
        return path / GEOMETRY
    tables = []
    for file in sorted(path.glob("*.csv")):
        try:
            if _of_points(file, how, Notebook(file, ""))[1].keys() == {*PLACES}:
                tables.append(file)
        except (ChannelError, ScanError, OSError):
            continue  # reading it as a point raises the error
    if len(tables) != 1:
        raise _without_points(path, how)
    notes.remark(f"{tables[0].name} was used as the table of the points")
    return tables[0]


def _of_points(table: Path, how: Mapped, notes: Notebook) -> tuple[Group, dict[str, Channel]]:
    """A table, and its columns with the names of files and with the positions."""
    words = [how.variables["file"]] if "file" in how.variables else list(NAMES["file"])
    group = delimited.read(table, notes, texts=[*words, *NAMES["file"], "file name"])[""]
    mine = replace(how, variables={k: name for k, name in how.variables.items() if k in PLACES})
    arrays = {
        name: replace(channel, kind="text" if _is_words(channel) else channel.kind)
        for name, channel in group.channels.items()
    }
    return group, chosen(arrays, mine, Notebook(table, ""), PLACES)


def _is_words(channel: Channel) -> bool:
    return channel.rows(0, channel.shape[0]).dtype.kind == "O" if channel.size else False


def _geometry(
    path: Path, table: Path, how: Mapped, notes: Notebook
) -> tuple[dict[str, Point], dict[str, Path], bool]:
    """Positions and files of the points by name, and True if they are simulated."""
    places: dict[str, Point] = {}
    files: dict[str, Path] = {}
    try:
        group, columns = _of_points(table, how, notes)
    except ScanError:
        raise
    except ChannelError as error:
        raise ScanError.unreadable(
            argument=f"{table.name} of a scan",
            given=f"{table}: {error.given}",
            allowed="a text table with the columns file, x, y",
            cause=error.cause,
            next_step=error.next_step,
        ) from error
    if missing := {*PLACES} - columns.keys():
        raise _without_columns(table, how, inventory(group.channels, notes), sorted(missing))
    try:
        factors = [length_factor(columns[axis].unit, how, notes) for axis in "xy"]
    except UnfitError as error:
        raise _without_columns(table, how, str(error), ["x", "y"]) from error
    rows = zip(*(columns[column].rows(0, columns[column].shape[0]) for column in PLACES), strict=True)
    first = int(group.properties.get(delimited.NAMES_LINE, 0)) + 1
    for number, row in enumerate(rows, start=first):
        name = str(row[0]).strip()
        try:
            place = Point(factors[0] * float(row[1]), factors[1] * float(row[2]))
        except (TypeError, ValueError):
            place = Point(np.nan, np.nan)
        if name in ("", "nan") or Path(name).name != name:
            notes.drop(f"line {number} of {table.name}", "not the name of a file in this folder")
        elif name in files:
            notes.drop(f"line {number} of {table.name}", f"{name} a second time; the first line is used")
        elif not np.isfinite([place.x, place.y]).all():
            notes.drop(f"point {name}", "no coordinates: x or y is not a number")
            files[name] = path / name
        else:
            places[name], files[name] = place, path / name
    return places, {name: file for name, file in files.items() if name in places}, group.simulated


def _without_points(path: Path, how: Mapped) -> ScanError:
    """The error for a folder that is not a scan, but may contain one."""
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
        allowed=f"a folder with one CSV file for each point and {GEOMETRY} with the columns file, x, y; or a "
        "folder with one file of a scan",
        cause=cause,
        next_step=next_step,
    )


def _without_columns(table: Path, how: Mapped, given: str, missing: Sequence[str]) -> ScanError:
    named = ", ".join(f'"{column}": "NAME"' for column in missing)
    return ScanError.missing(
        argument=f"{table.name} of a scan",
        given=f"columns {given}",
        allowed="the columns file, x, y, with lengths in m or in a unit behind the name",
        cause=f"no column is called {listed(missing, 'or')}",
        next_step=f"name them: read_scan(path, variables={{{named}}}), or in {table.name}: file,x,y",
        command=f"haptonic scan {how.path} --variables {','.join(f'{name}=NAME' for name in missing)}, or "
        f"name them in {table.name}: file,x,y",
    )
