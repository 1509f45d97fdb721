"""Table of the trials of an experiment and their files."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import FrictionError, ResourceError, shown
from haptonic.friction.signals.record import Label
from haptonic.friction.signals.tables import (
    LABEL,
    labels_of,
    left_out,
    numbers_of,
    read_columns,
)
from haptonic.later import pandas as pd
from haptonic.names import counted, listed

TABLE = "trials.csv"
CARRIED = ("order", "direction")  # columns that are copied to the table of results
ORIGINS = ("measured", "simulated")
LONGEST = 1e9  # s, of a recording: 30 years
SHARED = 0.5  # of the shorter of two records, which may overlap by as much
PORTION = 512  # trials that a worker reads at a time


class RecordSpan(NamedTuple):
    """Position of a trial's record: row of the table, group ("" for none), s from the start of the file."""

    row: int
    group: str
    start: float | None
    stop: float | None


@dataclass(frozen=True, eq=False)
class TrialTable:
    """Trials and their files, in the order of the table.

    folder : folder of the files
    labels : (trial,) columns ``participant``, ``block``, ``trial``, ``waveguide``, ``actuation``
    files : (trial,) names
    carried : other columns, copied to the results
    simulated : True if any trial is simulated
    doubts : trials left out of the table, and assumptions
    """

    folder: Path
    labels: dict[str, NDArray[Any]]
    carried: dict[str, NDArray[Any]]
    files: list[str]
    spans: list[RecordSpan]
    simulated: bool
    doubts: tuple[str, ...] = ()

    @classmethod
    def read(cls, folder: Path) -> TrialTable:
        """Read the table ``trials.csv`` of a folder.

        Raises
        ------
        ResourceError : no such folder, or no table in it
        FrictionError : a column is missing, a cell cannot be read, or files lie outside of the folder
        """
        path = table_in(folder)
        if not path.is_file():
            raise ResourceError.not_found(
                argument="folder of trials",
                given=folder,
                allowed=f"a folder with {TABLE}: participant, block, trial, waveguide, actuation, file",
                cause="the folder has records without a table" if folder.is_dir() else "no such folder",
                next_step=f"haptonic friction {folder} --draft writes one from the names of the files"
                if folder.is_dir()
                else "check the path",
            )
        columns, doubts = _with_blocks(read_columns(path, (*(n for n in LABEL if n != "block"), "file")))
        labels, rows, refusals = labels_of(columns)
        columns = {name: column[rows] for name, column in columns.items()}
        count = len(rows)
        origins = {str(word) for word in columns["origin"]} if "origin" in columns else set()
        if not origins <= set(ORIGINS):
            wrong = sorted(origins - set(ORIGINS))[0]
            raise _bad_cell(path, "column origin", wrong, '"measured" or "simulated" in every row')
        groups = columns["group"] if "group" in columns else np.full(count, np.nan)
        times = [
            _times(path, columns, name) if name in columns else [None] * count for name in ("start", "stop")
        ]
        files = _files(path, folder, columns["file"], labels, times)
        spans = [
            RecordSpan(row, "" if pd.isna(group) else str(group), start, stop)
            for row, (group, start, stop) in enumerate(zip(groups, *times, strict=True))
        ]
        if refusals:
            doubts.append(left_out(path, refusals))
        doubts += _shared_records(path, labels, files, spans)
        doubts += [text for name in ("participant", "waveguide") for text in _alike(labels, name)]
        return cls(
            folder=folder,
            labels={name: np.array([getattr(label, name) for label in labels]) for name in LABEL},
            carried={name: columns[name] for name in CARRIED if name in columns},
            files=files,
            spans=spans,
            simulated="simulated" in origins,
            doubts=tuple(doubts),
        )

    def portions(self) -> Iterator[list[tuple[str, list[RecordSpan]]]]:
        """Group the trials by files, some hundred at a time; a file with many trials is not divided."""
        portion: list[tuple[str, list[RecordSpan]]] = []
        for of_file in self.portion(range(len(self.files))):
            portion.append(of_file)
            if sum(len(spans) for _, spans in portion) >= PORTION:
                yield portion
                portion = []
        if portion:
            yield portion

    def portion(self, rows: Iterable[int]) -> list[tuple[str, list[RecordSpan]]]:
        """Group some trials by files."""
        by_file = groupby(rows, self.files.__getitem__)
        return [(name, [self.spans[row] for row in group]) for name, group in by_file]


def table_in(folder: Path) -> Path:
    """The table of trials of a folder; capitals in its name do not matter."""
    exact = folder / TABLE
    if exact.is_file() or not folder.is_dir():
        return exact
    return next((path for path in sorted(folder.iterdir()) if path.name.casefold() == TABLE), exact)


def _with_blocks(columns: dict[str, NDArray[Any]]) -> tuple[dict[str, NDArray[Any]], list[str]]:
    """The columns with a block for every trial, and the assumptions."""
    if "block" in columns:
        return columns, []
    blocks = np.ones(len(columns["trial"]), dtype=int)
    return columns | {"block": blocks}, [
        f"{TABLE} has no column block: all trials were taken as of one block"
    ]


def _files(
    path: Path, folder: Path, cells: NDArray[Any], labels: Sequence[Label], times: Sequence[Sequence[Any]]
) -> list[str]:
    """Names of files in the folder; "" for a trial without a file, or without times if others have them.

    Raises
    ------
    FrictionError : no trial has a file in the folder
    """
    files, first = list[str](), None
    for label, cell in zip(labels, cells, strict=True):
        name = "" if pd.isna(cell) else str(cell).strip().replace("\\", "/")
        outside = not name or Path(name).is_absolute() or ".." in Path(name).parts
        if outside:
            first = first or _bad_cell(path, f"file of {label}", name, "the name of a file in this folder")
        files.append("" if outside else _with_ending(folder, name))
    if first is not None and not any(files):
        raise first
    shared, timed = Counter(files), [any(time is not None for time in column) for column in times]
    for row, name in enumerate(files):
        if shared[name] > 1 and any(
            has and column[row] is None for has, column in zip(timed, times, strict=True)
        ):
            files[row] = ""
    return files


def _shared_records(
    path: Path, labels: Sequence[Label], files: Sequence[str], spans: Sequence[RecordSpan]
) -> list[str]:
    """Remark on trials that have the record of another trial, or overlap with it by more than half."""
    there = {name for name in set(files) if name and _exists(path.parent / name)}
    records = sorted(
        (name, span.group, span.start or 0.0, LONGEST if span.stop is None else span.stop, span.row)
        for name, span in zip(files, spans, strict=True)
        if name in there
    )
    shared = [
        (name, labels[row], labels[next_row])
        for (name, group, start, stop, row), (other, next_group, begin, end, next_row) in pairwise(records)
        if (name, group) == (other, next_group)
        and min(stop, end) - begin > SHARED * min(stop - start, end - begin)
    ]
    if not shared:
        return []
    name, first, second = shared[0]
    have = "has" if len(shared) == 1 else "have"
    trials = f"{counted(len(shared), 'trial')} {have} the record of another trial"
    return [
        f"{trials}, such as {name} of {first} and {second}: statistics count it again; correct the column "
        "file, or add the columns start and stop (s)"
    ]


def _exists(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):  # too long for any file, or with a zero
        return False


def _alike(labels: Sequence[Label], name: str) -> list[str]:
    """Remarks on names that differ only in capitals and blanks."""
    spellings: dict[str, dict[str, None]] = {}
    for label in labels:
        text = str(getattr(label, name))
        spellings.setdefault("".join(text.casefold().split()), {})[text] = None
    return [
        f"{name}s {listed(list(several))} differ only in capitals or blanks and count as {len(several)}"
        for several in spellings.values()
        if len(several) > 1
    ]


def _with_ending(folder: Path, name: str) -> str:
    """The name with its missing ending, if exactly one file in the folder has this name."""
    whole = folder / name
    try:
        if whole.suffix or "*" in name or not whole.parent.is_dir() or whole.is_file():
            return name
        matches = [path for path in whole.parent.iterdir() if path.stem == whole.name and path.is_file()]
    except OSError:
        return name  # too long for any file, or of an unreadable folder: opening the file raises the error
    return str(matches[0].relative_to(folder)) if len(matches) == 1 else name


def _times(path: Path, columns: dict[str, NDArray[Any]], name: str) -> list[float | None]:
    """Times in a file, s; None for an empty cell."""
    times = numbers_of(path, columns, name)
    wrong = times[~(np.isnan(times) | ((times >= 0) & (times < LONGEST)))]
    if wrong.size:
        raise _bad_cell(
            path, f"column {name}", f"{wrong[0]:g}", "seconds from the start of the file, or nothing"
        )
    return [None if np.isnan(time) else float(time) for time in times]


def _bad_cell(path: Path, what: str, given: object, allowed: str) -> FrictionError:
    return FrictionError.malformed(
        argument=f"{path.name}: {what}",
        given=shown(given),
        allowed=allowed,
        cause="the cell is empty, misspelt, or names a place on another machine",
        next_step="correct this row of the table",
    )
