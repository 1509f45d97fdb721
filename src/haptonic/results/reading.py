"""Base class of the reading of measured files, shown before anything is computed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib.metadata import version
from typing import Any

from haptonic.results.result import Result
from haptonic.results.table import Cell, Table
from haptonic.views import InteractiveView

MOST_SAMPLES = 2000  # of a curve
AXES = ("frequency", "time")  # of curves


class Reading(Result):
    """Points and a curve from files, and a table of how they were read.

    The dataset has ``x`` and ``y`` along ``point``, or none, and curves along one of `AXES`.
    """

    title = "How the files were read"

    def answers(self) -> list[tuple[str, str]]:
        """Questions about the files, and their answers."""
        raise NotImplementedError

    def tables(self) -> list[Table]:
        rows: list[Sequence[Cell]] = [*self.answers()]
        return [Table(f"how the files were read, {self.origin}", ("question", "answer"), rows)]

    def drawing(self) -> Mapping[str, Any] | None:
        """Outlines of the plate below the points; None without a plate."""
        return None

    def view(self) -> InteractiveView | None:
        data = self.dataset.assign_attrs(origin=self.origin, haptonic_version=version("haptonic"))
        extra = {"drawing": self.drawing(), "axis": next(name for name in AXES if name in data.sizes)}
        return InteractiveView(kind="reading", title=self.title, dataset=data, extra=extra)
