"""How sure a gap is to hold the carrier on plates that are not alike."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.design.parameters import UNITS
from haptonic.design.tolerance import REACH
from haptonic.later import Figure, xarray as xr
from haptonic.results.plain import split
from haptonic.results.result import Result, figure
from haptonic.results.table import Cell, Column, Table


@dataclass(frozen=True, eq=False, repr=False)
class Tolerance(Result):
    """Chances of a gap, what they depend on, and the loosest machining that still keeps them.

    gap : of the design as drawn
    plate, pillar : chance that all pillars of a plate keep the margin, and that one pillar does
    loosest : factor on all machined spreads that the confidence asked for allows, at most `REACH`
    dataset : edges of designs and of plates drawn, slopes and indices
    margin, pillars, confidence : what was asked: Hz, of a plate, a chance
    """

    title = "Tolerance"
    data_file = "tolerance"

    gap: Gap
    plate: float
    pillar: float
    loosest: float
    dataset: xr.Dataset
    margin: float
    pillars: int
    confidence: float

    def summary(self) -> list[str]:
        lower, upper = self.dataset["deviation"].values
        margin = f" with a margin of {self.margin:g} Hz" if self.margin else ""
        if self.loosest >= REACH:
            loosest = f"Even {REACH:g} times as loose machining keeps {self.confidence:.1%}."
        elif self.loosest > 0:
            loosest = f"Machining may be {self.loosest:.2f} times as loose for {self.confidence:.1%}."
        else:
            loosest = f"No machining, however exact, keeps {self.confidence:.1%}."
        return [
            f"One pillar keeps the carrier in its gap{margin} with a chance of {percent(self.pillar)}, "
            f"all {self.pillars} of a plate with {percent(self.plate)} "
            f"(to first order {percent(float(self.dataset.attrs['chance_to_first_order']))}).",
            loosest,
            f"Edges vary by {lower:.0f} Hz (lower) and {upper:.0f} Hz (upper), one standard deviation.",
        ]

    def tables(self) -> list[Table]:
        rows: list[tuple[Cell, ...]] = []
        for path, slopes, index in zip(
            *(self.dataset[name].values.tolist() for name in ("parameter", "slope", "total_index")),
            strict=True,
        ):
            per = {"m": (1e-5, "10 µm"), "rad": (1.745e-3, "0.1°"), "Pa": (1e9, "GPa")}
            factor, word = per.get(UNITS[path], (0.01, "0.01"))
            if path == "material.density":
                factor, word = 10.0, "10 kg/m³"
            rows.append((path, *(f"{slope * factor:+.0f} Hz per {word}" for slope in slopes), *index))
        index = [Column(f"index, {edge}", "", "%", ".1f") for edge in ("lower", "upper")]
        return [Table("what moves the edges", ("parameter", "lower edge", "upper edge", *index), rows)]

    @figure("tolerance", "Where the edges fall, and what moves them.")
    def _drawn(self) -> Figure:
        return plots.tolerance(self.dataset)

    def facts(self) -> dict[str, Any]:
        edges = {one: self.dataset[one] for one in ("deviation", "first_order_deviation", "fit_doubt")}
        return {
            "gap": self.gap,
            "chance_of_a_plate": self.plate,
            "chance_of_one_pillar": self.pillar,
            "loosest_factor": self.loosest,
            "largest_factor_tried": REACH,
            "edges": xr.Dataset(edges),
            "parameters": split(self.dataset[["slope", "first_order_share", "total_index"]], "parameter"),
        }


def percent(chance: float) -> str:
    """A chance in percent, as sure as some thousands of draws can be."""
    return "more than 99.99%" if chance > 0.9999 else "less than 0.01%" if chance < 1e-4 else f"{chance:.2%}"
