"""Run the tasks of a result, in several rounds if necessary."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from haptonic.analyses.options import option
from haptonic.analyses.points import Points, no_points
from haptonic.bloch import Gap, gaps_dataset, gaps_of
from haptonic.bloch.settings import BandSettings
from haptonic.cell import UnitCell
from haptonic.errors import HaptonicError
from haptonic.jobs import Outcome, Task, check_workers, ignored, run_all
from haptonic.later import xarray as xr
from haptonic.progress import Progress, silent
from haptonic.store import Store


@dataclass(frozen=True)
class Runner:
    """Place and means of a computation; see `haptonic.jobs.run_all` for tasks.

    about : analysed file, a study or a measurement, if any
    folder : folder for the result, if any; an interrupted analysis may keep its state there
    report : called with each design that an analysis of many designs computes
    first : called with the part of a dataset that is computed first, if the analysis has one
    """

    store: Store = field(default_factory=Store.default)
    workers: int = option(0, "Worker processes on this machine; 0 uses the main process.", metavar="N")
    scheduler: str | None = option(None, "Address of a running Dask scheduler.", metavar="ADDRESS")
    progress: Progress = silent
    about: Path | None = None
    folder: Path | None = None
    report: Points = no_points
    first: Callable[[xr.Dataset], object] | None = None

    def __post_init__(self) -> None:
        check_workers(self.workers, self.scheduler)
        for name, allowed, fits, other in (
            ("store", "a haptonic.store.Store", isinstance(self.store, Store), "the name of a folder"),
            ("progress", "a function of (done, planned, what)", callable(self.progress), "True"),
        ):
            if not fits:
                raise HaptonicError.malformed(
                    argument=name,
                    given=repr(getattr(self, name)),
                    allowed=allowed,
                    cause=f"it is of another type, such as {other}",
                    next_step="leave it out",
                )

    def run(
        self,
        function: Callable[[Any], xr.Dataset],
        tasks: Sequence[Task],
        done: int,
        heard: Callable[[int, Outcome], object] = ignored,
    ) -> list[xr.Dataset]:
        """Datasets of all tasks; ``done`` is the number of tasks that the search finished before."""
        outcomes = self.tried(function, tasks, done, heard)
        for outcome in outcomes:
            if outcome.error is not None:
                raise outcome.error
        return [outcome.dataset for outcome in outcomes if outcome.dataset is not None]

    def tried(
        self,
        function: Callable[[Any], xr.Dataset],
        tasks: Sequence[Task],
        done: int,
        heard: Callable[[int, Outcome], object] = ignored,
    ) -> list[Outcome]:
        """Outcome of each task, in their order: a dataset or an error; see `haptonic.jobs.run_all`."""

        def counted(now: int, total: int, what: str = "", /) -> None:
            self.progress(done + now, done + total, what)

        return run_all(
            function, tasks, store=self.store, workers=min(self.workers, len(tasks)),
            scheduler=self.scheduler, progress=counted, heard=heard,
        )  # fmt: skip

    def gaps(self, cell: UnitCell, settings: BandSettings) -> tuple[Gap, ...]:
        """Complete gaps of a cell, one step of an analysis that has others."""
        self.progress(0, 0, "gaps of the lattice")
        (dataset,) = replace(self, progress=silent).run(design_gaps, [gaps_task(cell, settings)], 0)
        self.progress(0, 0)
        return gaps_of(dataset)


def gaps_task(cell: UnitCell, settings: BandSettings) -> Task:
    """Task of `design_gaps` for a cell."""
    return Task({"kind": "gaps", "cell": cell, "settings": settings}, (cell, settings))


def design_gaps(design: tuple[UnitCell, BandSettings]) -> xr.Dataset:
    """Complete gaps of one design; the function of a worker."""
    gaps: xr.Dataset = gaps_dataset(*design)
    return gaps
