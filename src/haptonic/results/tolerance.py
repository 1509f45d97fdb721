"""Probability that a gap contains the carrier on plates with manufacturing tolerances."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.design.links import units_of
from haptonic.design.tolerance import REACH
from haptonic.later import Figure, xarray as xr
from haptonic.names import listed
from haptonic.plots.text import gap_text
from haptonic.results.plain import split
from haptonic.results.result import Result, figure
from haptonic.results.table import Cell, Column, Table
from haptonic.units import format_quantity, in_percent


@dataclass(frozen=True, eq=False, repr=False)
class Tolerance(Result):
    """Probabilities for a gap, their sensitivities, and the loosest sufficient machining.

    gap : of the nominal design
    plate, pillar : probability that all pillars of a plate keep the margin, and that one pillar does
    plate_range, pillar_range : least and largest probability within the errors of the edges of `gap`
    loosest : factor on all machined spreads that the required confidence allows, at most `REACH`; None if no
        spread is machined
    exact_sizes : probability that all pillars keep the margin if machined numbers do not vary
    dataset : edges of computed designs and of drawn plates, slopes and indices
    margin, pillars, confidence : requirements: Hz, pillars of a plate, probability
    """

    title = "Tolerance"
    data_file = "tolerance"

    gap: Gap
    plate: float
    pillar: float
    plate_range: tuple[float, float]
    pillar_range: tuple[float, float]
    loosest: float | None
    exact_sizes: float
    dataset: xr.Dataset
    margin: float
    pillars: int
    confidence: float

    def summary(self) -> list[str]:
        lower, upper = self.dataset["deviation"].values
        margin = f" with a margin of {self.margin:g} Hz" if self.margin else ""
        confidence = f"a confidence of {in_percent(self.confidence, form='.1f')}"
        if self.loosest is None:
            loosest = "No size or angle varies, so that there is no spread for a workshop to reduce."
        elif self.loosest >= REACH:
            loosest = f"Spreads may be {REACH:g} times as large or more for {confidence}."
        elif self.loosest > 0:
            loosest = f"Spreads may be {self.loosest:.2f} times as large for {confidence}."
        else:
            loosest = (
                f"With exact sizes the probability is {percent(self.exact_sizes)}, so no spread of sizes, "
                f"however small, gives {confidence}."
            )
        together = f"all {self.pillars} pillars of a plate" if self.pillars > 1 else "the pillar of a plate"
        within = [
            f"{percent(low)} to {percent(high)} for {what}"
            for (low, high), what in ((self.pillar_range, "one pillar"), (self.plate_range, together))
            if percent(low) != percent(high)
        ]
        return [
            f"Probability that the gap contains the carrier{margin}: {percent(self.pillar)} for one pillar, "
            f"{percent(self.plate)} for {together} "
            f"(to first order {percent(float(self.dataset.attrs['chance_to_first_order']))}).",
            *([f"Within the errors of the edges, {gap_text(self.gap)}: {listed(within)}."] if within else []),
            loosest,
            f"Edges vary by {lower:.0f} Hz (lower) and {upper:.0f} Hz (upper), one standard deviation.",
        ]

    def tables(self) -> list[Table]:
        rows: list[tuple[Cell, ...]] = []
        units = units_of(self.dataset["parameter"])
        names = ("parameter", "spread", "slope", "total_index")
        for path, spread, slopes, index in zip(
            *(self.dataset[name].values.tolist() for name in names), strict=True
        ):
            width = format_quantity(spread, units[path])
            rows.append((path, width, *(slope * spread for slope in slopes), *index))
        edges = [Column(f"{edge} edge", "Hz", form="+.0f") for edge in ("lower", "upper")]
        index = [Column(f"index, {edge}", "", "%", ".1f") for edge in ("lower", "upper")]
        return [Table("effects on the edges", ("parameter", "spread", *edges, *index), rows)]

    @figure("tolerance", "Distribution of the edges, and the parameters that move them.")
    def _drawn(self) -> Figure:
        return plots.tolerance(self.dataset)

    def facts(self) -> dict[str, Any]:
        edges = {name: self.dataset[name] for name in ("deviation", "first_order_deviation", "fit_doubt")}
        return {
            "gap": self.gap,
            "chance_of_a_plate": self.plate,
            "chance_of_a_plate_range": list(self.plate_range),
            "chance_of_one_pillar": self.pillar,
            "chance_of_one_pillar_range": list(self.pillar_range),
            "chance_of_a_plate_of_exact_sizes": self.exact_sizes,
            "loosest_factor": self.loosest,
            "largest_factor_tried": REACH,
            "edges": xr.Dataset(edges),
            "parameters": split(self.dataset[["slope", "first_order_share", "total_index"]], "parameter"),
        }


def percent(chance: float) -> str:
    """A probability in percent, with the accuracy of some thousands of draws."""
    if chance > 0.9999:
        return "more than 99.99 %"
    return "less than 0.01 %" if chance < 1e-4 else in_percent(chance, form=".2f")
