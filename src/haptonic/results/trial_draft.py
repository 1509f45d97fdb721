"""Table of trials drafted from the names of the files, to be completed by hand."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from haptonic.friction.recordings.draft import Draft
from haptonic.friction.recordings.trial_table import TABLE
from haptonic.later import xarray as xr
from haptonic.names import cell, listed
from haptonic.progress import Progress, silent
from haptonic.results.result import Result
from haptonic.results.table import Table

SHOWN = 12  # rows


@dataclass(frozen=True, eq=False, repr=False)
class TrialDraft(Result):
    """Drafted table of trials, written beside the records.

    source : folder of the records; saved : True if the table is in it
    """

    title = "Draft of the table of trials"

    source: Path
    draft: Draft
    saved: bool = True

    @property
    def dataset(self) -> xr.Dataset:
        """All rows of the table, as texts."""
        return xr.Dataset({name: ("stroke", column) for name, column in self.draft.columns.items()})

    def save(self) -> None:
        """Write the table beside the records; an existing table is not replaced.

        Raises
        ------
        OSError : a table exists, or the folder cannot be written
        """
        with (self.source / TABLE).open("x", newline="", encoding="utf-8") as file:
            table = csv.writer(file)
            table.writerow(self.draft.columns)
            table.writerows(
                [cell(value) for value in row] for row in zip(*self.draft.columns.values(), strict=True)
            )

    def put(self, draft: Path, progress: Progress = silent) -> None:
        """Write nothing: the table is beside the records."""

    def write(self, folder: Path | str, *, overwrite: bool = False, progress: Progress = silent) -> None:
        """Write nothing: the table is beside the records."""

    def summary(self) -> list[str]:
        count = len(self.draft.columns["file"])
        order = ", and the trials of each block were numbered consecutively" if self.draft.renumbered else ""
        sentences = [f"{self.source / TABLE} was drafted from the names of {count} files{order}; check it."]
        if not self.saved:
            sentences = [f"A draft of {TABLE}, from the names of {count} files, can be written."]
        if self.draft.empty:
            sentences.append(
                f"Fill in {listed(self.draft.empty)}: the names of the files do not contain them."
            )
        if self.draft.unnamed:
            sentences.append(
                f"The meaning of {listed(self.draft.unnamed)} is not clear: rename or remove these columns."
            )
        return [*sentences, f"Then: haptonic friction {self.source}"]

    def tables(self) -> list[Table]:
        rows = list(zip(*self.draft.columns.values(), strict=True))
        return [Table(f"the first of {len(rows)} rows", tuple(self.draft.columns), rows[:SHOWN])]

    def facts(self) -> dict[str, Any]:
        return {
            "table": str(self.source / TABLE),
            "trials": len(self.draft.columns["file"]),
            "empty": self.draft.empty,
            "unnamed": self.draft.unnamed,
            "columns": self.draft.columns,
        }
