"""The table that says which file holds which trial."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import FrictionError, ResourceError, shown
from haptonic.friction.signals.tables import LABEL, label_of, numbers_of, read_columns
from haptonic.later import pandas as pd

TABLE = "trials.csv"
CARRIED = ("order", "direction")  # columns that go on into the table of results
ORIGINS = ("measured", "simulated")
LONGEST = 1e9  # s, of a recording: 30 years
PORTION = 512  # trials that a worker reads at a time


class RecordSpan(NamedTuple):
    """Where the record of a trial is: row of the table, group ("" for none), s from the start of the file."""

    row: int
    group: str
    start: float | None
    stop: float | None


@dataclass(frozen=True, eq=False)
class TrialTable:
    """Trials and their files, in the order of the table.

    folder : that the files are in
    labels : (trial,) columns ``participant``, ``block``, ``trial``, ``waveguide``, ``actuation``
    files : (trial,) names; carried : other columns that are kept
    simulated : whether any trial says so
    """

    folder: Path
    labels: dict[str, NDArray[Any]]
    carried: dict[str, NDArray[Any]]
    files: list[str]
    spans: list[RecordSpan]
    simulated: bool

    @classmethod
    def read(cls, folder: Path) -> TrialTable:
        """The table ``trials.csv`` of a folder.

        Raises
        ------
        ResourceError : no such folder, or no table in it
        FrictionError : a column is missing, a cell that means nothing, or files outside of the folder
        """
        path = folder / TABLE
        if not path.is_file():
            raise ResourceError.not_found(
                argument="folder of trials",
                given=folder,
                allowed=f"a folder with {TABLE}: participant, block, trial, waveguide, actuation, file",
                cause="the folder holds records without a table" if folder.is_dir() else "no such folder",
                next_step="haptonic protocol STUDY writes such a table",
            )
        columns = read_columns(path, (*LABEL, "file"))
        count = len(columns["file"])
        labels = [label_of(columns, row) for row in range(count)]
        files = ["" if pd.isna(name) else str(name).strip() for name in columns["file"]]
        for label, name in zip(labels, files, strict=True):
            if not name or Path(name).is_absolute() or ".." in Path(name).parts:
                raise _bad_cell(path, f"file of {label}", name, "the name of a file in this folder")
        origins = {str(word) for word in columns["origin"]} if "origin" in columns else set()
        if not origins <= set(ORIGINS):
            wrong = sorted(origins - set(ORIGINS))[0]
            raise _bad_cell(path, "column origin", wrong, '"measured" or "simulated" in every row')
        groups = columns["group"] if "group" in columns else np.full(count, np.nan)
        times = [
            _times(path, columns, name) if name in columns else [None] * count for name in ("start", "stop")
        ]
        spans = [
            RecordSpan(row, "" if pd.isna(group) else str(group), start, stop)
            for row, (group, start, stop) in enumerate(zip(groups, *times, strict=True))
        ]
        return cls(
            folder=folder,
            labels={name: np.array([getattr(label, name) for label in labels]) for name in LABEL},
            carried={name: columns[name] for name in CARRIED if name in columns},
            files=files,
            spans=spans,
            simulated="simulated" in origins,
        )

    def portions(self) -> Iterator[list[tuple[str, list[RecordSpan]]]]:
        """The trials by files, some hundred at a time; a file with many trials is not divided."""
        portion: list[tuple[str, list[RecordSpan]]] = []
        for one in self.portion(range(len(self.files))):
            portion.append(one)
            if sum(len(spans) for _, spans in portion) >= PORTION:
                yield portion
                portion = []
        if portion:
            yield portion

    def portion(self, rows: Iterable[int]) -> list[tuple[str, list[RecordSpan]]]:
        """Some trials by files."""
        by_file = groupby(rows, self.files.__getitem__)
        return [(name, [self.spans[row] for row in group]) for name, group in by_file]


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
        next_step="put this row of the table right",
    )
