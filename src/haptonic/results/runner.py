"""Several rounds of tasks that make one result."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import xarray as xr

from haptonic.bloch import Gap, gaps_of
from haptonic.cell import UnitCell
from haptonic.jobs import Outcome, Task, run_all
from haptonic.results.common import Asked
from haptonic.results.sweeps import design_gaps
from haptonic.store import Store

Progress = Callable[[int, int, bool], None]


@dataclass(frozen=True)
class Runner:
    """How and where the tasks of a search are computed; see `haptonic.jobs.run_all`."""

    store: Store
    workers: int = 0
    scheduler: str | None = None
    on_progress: Progress | None = None

    def run(
        self, function: Callable[[Any], xr.Dataset], tasks: Sequence[Task], done: int
    ) -> list[xr.Dataset]:
        """Datasets of all tasks; ``done`` tasks of the search were finished before."""
        return [_dataset(outcome) for outcome in self.tried(function, tasks, done)]

    def tried(self, function: Callable[[Any], xr.Dataset], tasks: Sequence[Task], done: int) -> list[Outcome]:
        """What came of each task, in their order: a dataset, or the error that stands in its place."""

        def counted(now: int, total: int, stored: bool) -> None:
            if self.on_progress is not None:
                self.on_progress(done + now, done + total, stored)

        return run_all(
            function, tasks, store=self.store, workers=min(self.workers, len(tasks)),
            scheduler=self.scheduler, on_progress=counted,
        )  # fmt: skip

    def gaps(self, cell: UnitCell, asked: Asked, done: int = 0) -> tuple[Gap, ...]:
        """Complete gaps of a cell, the task of one design of a sweep."""
        task = Task({"kind": "gaps", "cell": cell, "asked": asked}, (cell, asked))
        (dataset,) = self.run(design_gaps, [task], done)
        return gaps_of(dataset)


def _dataset(outcome: Outcome) -> xr.Dataset:
    if outcome.dataset is None:
        assert outcome.error is not None
        raise outcome.error
    return outcome.dataset
