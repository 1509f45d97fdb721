"""Tables of trials and of force records in CSV, NetCDF and HDF5 files."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic import hdf5
from haptonic.channels import Notebook, delimited, hdf5 as stored
from haptonic.errors import ChannelError, FrictionError, ResourceError, nearest
from haptonic.friction.signals.clock import clock_of, repeats_of
from haptonic.friction.signals.columns import UNSURE, meanings, plain_word, renamed, whole_number
from haptonic.friction.signals.record import Label, Record
from haptonic.gate import declared, passed
from haptonic.later import pandas as pd, xarray as xr
from haptonic.names import cell, listed, visible
from haptonic.paths import unread

Column = NDArray[Any]

LABEL = ("participant", "block", "trial", "waveguide", "actuation")
RECORD = (*LABEL, "time", "normal", "tangential")
TRIALS = (*LABEL, "friction")
WHOLE = ("block", "trial")
LEFT_OUT = "left_out"  # attribute of a table of trials: rows without a valid label
FEW = 3  # rows that a sentence lists
TEXTS = ("participant", "waveguide", "actuation", "file")
FORMATS = {".csv": "CSV", ".nc": "NetCDF", ".h5": "HDF5", ".hdf5": "HDF5"}


def read_records(path: Path) -> Iterator[tuple[Label, Record]]:
    """Read force records from a table with one row for each sample.

    Columns: ``participant``, ``block``, ``trial``, ``waveguide``, ``actuation`` ("on" or "off"), ``time``
    (s), ``normal`` and ``tangential`` (N), and, if recorded, ``position`` (m). The rows of a trial lie
    together.

    Raises
    ------
    ResourceError : the file cannot be read
    FrictionError : a column is missing, times that are not equidistant, or a channel in another unit
    """
    columns = read_columns(path, RECORD)
    keys = [columns[name] for name in ("participant", "block", "trial")]
    new = np.ones(len(keys[0]), dtype=bool)
    new[1:] = np.any([key[1:] != key[:-1] for key in keys], axis=0)
    starts = [*np.flatnonzero(new), len(new)]
    for start, stop in pairwise(starts):
        label = label_of(columns, start)
        for name in ("waveguide", "actuation"):
            if len(set(columns[name][start:stop])) != 1:
                raise _bad_table(path, f"{label}: {name} changes", "one condition for each trial")
        time = numbers_of(path, columns, "time")[start:stop]
        position = numbers_of(path, columns, "position")[start:stop] if "position" in columns else None
        normal, tangential = (
            numbers_of(path, columns, name)[start:stop] for name in ("normal", "tangential")
        )
        repeats = repeats_of(time, [normal, tangential, *([] if position is None else [position])])
        clock = clock_of(time[~repeats], f"{path.name}, {label}").without(repeats)
        position = None if position is None else clock.regular(position)
        yield label, Record(
            clock.regular(normal), clock.regular(tangential), clock.rate, position,
            remarks=(clock.remark,) if clock.remark else (),
        )  # fmt: skip


def read_trials(path: Path) -> xr.Dataset:
    """Read a table with one row for each trial, made by another program or by `write_trials`.

    Columns: ``participant``, ``block``, ``trial``, ``waveguide``, ``actuation`` ("on" or "off"), ``friction``
    (mu); others, such as ``speed``, ``force`` and ``excluded``, are copied.

    Raises
    ------
    ResourceError : the file cannot be read
    FrictionError : a column is missing, or a cell cannot be read
    """
    columns = read_columns(path, TRIALS)
    labels, rows, refusals = labels_of(columns)
    columns = {name: column[rows] for name, column in columns.items()}
    table = dict(columns) | {name: np.array([getattr(label, name) for label in labels]) for name in LABEL}
    friction = numbers_of(path, columns, "friction")
    excluded = table.get("excluded", np.full(len(labels), "", dtype=object))
    table["excluded"] = np.array(["" if pd.isna(reason) else str(reason) for reason in excluded])
    empty = np.isnan(friction) & (table["excluded"] == "")
    table["excluded"] = np.where(empty, "missing numbers", table["excluded"].astype(object)).astype(str)
    bad = ((friction < 0) | (friction > 10)) & (table["excluded"] == "")
    if bad.any():
        row = int(np.flatnonzero(bad)[0])
        raise _bad_table(path, f"{labels[row]}: friction {friction[row]:g}", "coefficients from 0 to 10")
    table["friction"] = friction
    attributes = {LEFT_OUT: left_out(path, refusals)} if refusals else {}
    return xr.Dataset({name: ("stroke", values) for name, values in table.items()}, attrs=attributes)


def write_trials(trials: xr.Dataset, path: Path) -> None:
    """Write a table of trials, in the format of the ending.

    Raises
    ------
    FrictionError : another ending than .csv or .nc
    NumericalError : an infinite number
    """
    numbers = [str(name) for name, column in trials.items() if column.dtype.kind == "f"]
    checked = passed(declared(trials.copy(), **dict.fromkeys(numbers, "not measured, or left out")))
    if path.suffix == ".csv":
        trials.to_dataframe().map(cell).to_csv(path, index=False)
    elif path.suffix == ".nc":
        hdf5.write_dataset(checked, path)
    else:
        raise _other_format(path, [".csv", ".nc"])


def read_columns(path: Path, required: Sequence[str]) -> dict[str, Column]:
    """Read all columns of a table, of equal length.

    Raises
    ------
    ResourceError : the file cannot be read
    FrictionError : another ending, no rows, a missing column, or columns of unequal length
    """
    if path.suffix not in FORMATS:
        raise _other_format(path, list(FORMATS))
    try:
        columns = renamed(_READERS[path.suffix](path), path.name)
    except (OSError, MemoryError, ChannelError) as error:
        raise unread(
            ResourceError,
            error,
            argument="table of trials",
            given=path,
            allowed=f"a readable {FORMATS[path.suffix]} file",
            cause="it is damaged, or its ending does not match its content",
            next_step="open it in another program to see",
        ) from error
    missing = [name for name in required if name not in columns]
    if missing:
        others = [name for name in columns if name not in required]
        alike = {name: guess for name in missing if (guess := nearest(name, others))}
        steps = [f'rename "{guess}" to "{name}"' for name, guess in alike.items()]
        absent = [f'"{name}"' for name in missing if name not in alike]
        if absent:
            steps.append(f"add {listed(absent)} to every row")
        raise FrictionError.missing(
            argument=f"{path.name}: {'columns' if len(missing) > 1 else 'column'} {listed(missing)}",
            given=", ".join(columns) or "no columns",
            allowed=f"the columns {', '.join(required)}",
            cause="a column has another name, or the table is of another kind",
            next_step=listed(steps),
        )
    lengths = {len(column) for column in columns.values()}
    if lengths == {0}:
        raise FrictionError.missing(
            argument=path.name, given="no rows below the head", allowed="one row or more",
            cause="the table was not filled in, or was cut", next_step="add a row for each trial",
        )  # fmt: skip
    if len(lengths) != 1:
        raise _bad_table(path, f"columns of {sorted(lengths)} rows", "one row or more, in all columns")
    return columns


def _from_hdf5(path: Path) -> dict[str, Column]:
    """Candidates for columns: numbers or texts along one axis."""
    channels = stored.read(path, Notebook(path, "HDF5"))[""].channels.values()
    return {c.name: np.asarray(c) for c in channels if len(c.shape) == 1 and c.kind != "complex"}


def _from_csv(path: Path) -> dict[str, Column]:
    """Columns of a CSV file; names of people, regions and files stay text even if they look like numbers."""
    columns = delimited.columns(path, TEXTS)
    by_meaning = meanings(columns, path.name)
    words = {by_meaning[name] for name in TEXTS if name in by_meaning}
    words |= {name for name in columns if plain_word(name) in UNSURE}
    text_columns = {name.casefold() for name in TEXTS}
    if all(name.casefold() in text_columns for name in words):
        return columns
    return delimited.columns(path, words)


_READERS: Mapping[str, Callable[[Path], dict[str, Column]]] = {
    ".csv": _from_csv,
    **dict.fromkeys((".nc", ".h5", ".hdf5"), _from_hdf5),
}


def label_of(columns: dict[str, Column], row: int) -> Label:
    """Label of a row of a table.

    Raises
    ------
    FrictionError : a cell that cannot be read
    """
    cells: dict[str, Any] = {name: columns[name][row] for name in LABEL}
    for name in WHOLE:
        cells[name] = whole_number(cells[name])
    for name in set(LABEL) - set(WHOLE):
        cells[name] = "" if pd.isna(cells[name]) else visible(str(cells[name])).strip()
    cells["actuation"] = cells["actuation"].lower()
    return Label(**cells)


def labels_of(columns: dict[str, NDArray[Any]]) -> tuple[list[Label], list[int], list[str]]:
    """Labels of the valid rows, the rows, and the faults of the other rows.

    Raises
    ------
    FrictionError : no valid row
    """
    labels, rows, refusals = list[Label](), list[int](), list[str]()
    first: FrictionError | None = None
    for row in range(len(columns["trial"])):
        try:
            labels.append(label_of(columns, row))
        except FrictionError as error:
            first = first or error
            refusals.append(f"row {row + 1}: {error.argument.split(' of ')[0]} is {error.given}")
        else:
            rows.append(row)
    if first is not None and not rows:
        raise first
    return labels, rows, refusals


def left_out(path: Path, refusals: Sequence[str]) -> str:
    """A sentence about rows of a table without a valid label."""
    first = "; ".join(refusals[:FEW])
    more = f"; and {len(refusals) - FEW} more" if len(refusals) > FEW else ""
    return f"rows of {path.name} were left out: {first}{more}"


def numbers_of(path: Path, columns: dict[str, Column], name: str) -> NDArray[np.float64]:
    """A column as numbers.

    Raises
    ------
    FrictionError : the column contains text
    """
    try:
        return np.asarray(columns[name], dtype=float)
    except (TypeError, ValueError):
        raise _bad_table(path, f"text in the column {name}", f"numbers in the column {name}") from None


def _bad_table(path: Path, given: str, allowed: str) -> FrictionError:
    return FrictionError.malformed(
        argument=path.name,
        given=given,
        allowed=allowed,
        cause="rows were lost, sorted or joined, or a decimal comma was used",
        next_step="look at these rows of the table",
    )


def _other_format(path: Path, allowed: list[str]) -> FrictionError:
    return FrictionError.malformed(
        argument="table of trials",
        given=path.name,
        allowed=f"a name that ends in {', '.join(allowed)}",
        cause="the format is not read, or the ending was left out",
        next_step="save the table as CSV",
    )
