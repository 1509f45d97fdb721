"""A toy analysis, as somebody adds one: this file, and its line in the table."""

from __future__ import annotations

from dataclasses import dataclass

from haptonic import plots
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.options import option
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import every_cell
from haptonic.fields import Quantity
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.results.cost import Cost
from haptonic.results.result import Result, figure
from haptonic.results.table import Column, Table
from haptonic.study.schema import Description


@dataclass(frozen=True)
class ToyOptions:
    """What may be chosen."""

    number: int = option(2, "How far to count.", metavar="N")
    length: float = option(1e-3, "Length of a step.", quantity=Quantity("m"), metavar="LENGTH")


@dataclass(frozen=True, eq=False, repr=False)
class Toy(Result):
    """It counts."""

    title = "A toy"
    data_file = "toy"

    number: int
    length: float = 1e-3

    @property
    def dataset(self) -> xr.Dataset:
        """The numbers."""
        return xr.Dataset({"number": ("step", list(range(self.number)), {"units": "1"})})

    def summary(self) -> list[str]:
        return [f"It counts to {self.number}."]

    def tables(self) -> list[Table]:
        rows = [(k, k * self.length) for k in range(self.number)]
        return [Table("numbers", (Column("number"), Column("way", "m", "mm", ".2f")), rows)]

    @figure("toy", "Simulated numbers.")
    def _drawn(self, *, ax: Axes | None = None) -> Figure:
        def paint(on: plots.Stage) -> None:
            on.axes.plot(range(self.number), label="way")
            on.legend()

        return plots.painted(paint, height=6.0, ax=ax)

    def facts(self) -> dict[str, object]:
        return {"number": self.number, "length_m": self.length, "steps": self.dataset}


def compute(study: Description, options: ToyOptions, runner: Runner) -> Toy:
    """Count."""
    return Toy(options.number, options.length)


ANALYSIS = Analysis(
    supports=every_cell,
    name="toy", result=Toy, compute=compute, options=ToyOptions,
    cost=lambda study, options: Cost(2.0 * options.number),
    reported=lambda study: ToyOptions(),
)  # fmt: skip
