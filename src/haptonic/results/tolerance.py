"""How sure a gap is to hold the carrier on plates that are not alike."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.bloch.exact import exact_modes
from haptonic.bloch.gaps import need_gap_at
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.settings import BandSettings
from haptonic.cell import UnitCell
from haptonic.design.parameters import UNITS, values_of
from haptonic.design.quick import QUICK, QuickDesign
from haptonic.design.sensitivity import sensitivity
from haptonic.design.tolerance import (
    REACH,
    Chances,
    Spread,
    Surface,
    edges_of,
    first_order,
    samples,
    terms_needed,
)
from haptonic.errors import HaptonicError, StudyError
from haptonic.jobs import Task
from haptonic.results.common import stamped
from haptonic.results.result import Result, figure
from haptonic.results.runner import Runner
from haptonic.results.table import Cell, Column, Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

BATCH = 8  # designs of one task
DIVISIONS = 10  # of the irreducible zone's sides, where the bands beside the gap are followed
DRAWN = 2000  # plates in the result's dataset


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
        for row in self.to_json()["parameters"]:
            per = {"m": (1e-5, "10 µm"), "rad": (1.745e-3, "0.1°"), "Pa": (1e9, "GPa")}
            factor, word = per.get(UNITS[row["parameter"]], (0.01, "0.01"))
            if row["parameter"] == "material.density":
                factor, word = 10.0, "10 kg/m³"
            slopes = [f"{slope * factor:+.0f} Hz per {word}" for slope in row["slope_hz_per_si"]]
            rows.append((row["parameter"], *slopes, *row["total_index"]))
        index = [Column(f"index, {edge}", "", "%", ".1f") for edge in ("lower", "upper")]
        return [Table("what moves the edges", ("parameter", "lower edge", "upper edge", *index), rows)]

    @figure("tolerance", "Where the edges fall, and what moves them.")
    def _drawn(self) -> Figure:
        return plots.tolerance(self.dataset)

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        data = self.dataset
        rows = []
        for i, path in enumerate(data["parameter"].values):
            row = data.isel(parameter=i)
            rows.append(
                {
                    "parameter": str(path),
                    "slope_hz_per_si": row["slope"].values.tolist(),
                    "first_order_share": row["first_order_share"].values.tolist(),
                    "total_index": row["total_index"].values.tolist(),
                }
            )
        return {
            "gap": {"lower_hz": self.gap.lower, "upper_hz": self.gap.upper},
            "chance_of_a_plate": self.plate,
            "chance_of_one_pillar": self.pillar,
            "chance_to_first_order": float(data.attrs["chance_to_first_order"]),
            "loosest_factor": self.loosest,
            "largest_factor_tried": REACH,
            "edge_deviation_hz": data["deviation"].values.tolist(),
            "edge_deviation_to_first_order_hz": data["first_order_deviation"].values.tolist(),
            "fit_doubt_hz": data["fit_doubt"].values.tolist(),
            "parameters": rows,
        }


def percent(chance: float) -> str:
    """A chance in percent, as sure as some thousands of draws can be."""
    return "more than 99.99%" if chance > 0.9999 else "less than 0.01%" if chance < 1e-4 else f"{chance:.2%}"


def compute_tolerance(
    cell: UnitCell,
    settings: BandSettings,
    spreads: Sequence[Spread],
    *,
    carrier: float,
    margin: float,
    confidence: float,
    pillars: int,
    count: int,
    inputs: Mapping[str, Any],
    runner: Runner,
) -> Tolerance:
    """First-order answer from exact slopes, full answer from designs that are computed.

    Parameters
    ----------
    carrier, margin : Hz; confidence : for the loosest machining; pillars : on a plate
    count : designs to compute

    Raises
    ------
    StudyError : the gap does not hold the carrier even as drawn, or too few samples
    """
    needed = terms_needed(len(spreads))
    if count < 2 * needed:
        raise StudyError(
            argument="tolerance.samples",
            given=count,
            allowed=f"at least {2 * needed} for {len(spreads)} spreads",
            cause=f"a quadratic in so many parameters has {needed} coefficients",
            next_step="compute more samples, or leave spreads out that hardly matter",
        )
    gap = need_gap_at(runner.gaps(cell, settings), carrier)
    try:
        designs = samples(cell, spreads, count)
    except HaptonicError as error:
        raise StudyError(
            argument="tolerance.of",
            given="spreads that lead to bodies that cannot be",
            allowed=f"spreads of which {REACH:g} times as large ones still make a body",
            cause=f"{error.argument} would be {error.given}: {error.cause}",
            next_step="give smaller spreads",
        ) from None
    batches = [designs[i : i + BATCH] for i in range(0, count, BATCH)]
    tasks = [_beside_task(batch, gap) for batch in (*batches, [cell])]
    datasets = runner.run(beside_dataset, tasks, 1)
    *parts, own = (dataset["frequency"].values for dataset in datasets)
    offset = np.array([gap.lower, gap.upper]) - edges_of(own)[0]
    frequency = np.concatenate(parts) + offset[:, None]
    slopes = edge_slopes(cell, gap, [spread.parameter for spread in spreads])
    widths = np.array([spread.spread for spread in spreads])
    at_rest = np.array([values_of(cell)[spread.parameter] for spread in spreads])
    moved = np.array([[values_of(one)[s.parameter] for s in spreads] for one in designs])
    deviations = (moved - at_rest) / widths
    surface = Surface.fitted(deviations, frequency)
    chances = Chances(surface, tuple(spreads), carrier, margin, pillars)
    straight = Chances(_linear(gap, slopes * widths[:, None]), tuple(spreads), carrier, margin, pillars)
    variance = first_order(slopes, spreads)
    dataset = xr.Dataset(
        {
            "edge": (
                ("design", "side"), edges_of(frequency),
                {"units": "Hz", "long_name": "edges of computed designs"},
            ),
            "drawn": (
                ("plate", "side"), surface.at(chances.drawn(DRAWN)),
                {"units": "Hz", "long_name": "edges of drawn designs, from the fit"},
            ),
            "slope": (("parameter", "side"), slopes, {"units": "Hz per SI unit"}),
            "first_order_share": (("parameter", "side"), variance / variance.sum(axis=0), {"units": "1"}),
            "total_index": (("parameter", "side"), chances.importance(), {"units": "1"}),
            "deviation": ("side", chances.deviations(), {"units": "Hz"}),
            "first_order_deviation": ("side", np.sqrt(variance.sum(axis=0)), {"units": "Hz"}),
            "fit_doubt": ("side", surface.doubt, {"units": "Hz"}),
        },
        coords={"parameter": [spread.parameter for spread in spreads], "side": ["lower", "upper"]},
        attrs={
            "carrier_hz": carrier,
            "margin_hz": margin,
            "mesh": json.dumps(asdict(QUICK)),
            "chance_to_first_order": straight.of_a_plate(),
        },
    )  # fmt: skip
    return Tolerance(
        gap=gap,
        plate=chances.of_a_plate(),
        pillar=chances.of_one_pillar(),
        loosest=chances.loosest(confidence),
        dataset=stamped(dataset, inputs),
        margin=margin,
        pillars=pillars,
        confidence=confidence,
    )


def edge_slopes(cell: UnitCell, gap: Gap, paths: Sequence[str]) -> Array:
    """(parameters, 2) exact slopes of a gap's lower and upper edge, Hz per SI unit.

    Where an edge is degenerate, its modes part as a parameter changes: the lower edge follows the steepest of
    them, the upper one the least.
    """
    band = gap.between[0]
    quick = QuickDesign.of(cell, band + 2)
    fine, columns = quick.model.fine, []
    for number, kappa, pick in ((band, gap.lower_kappa, -1), (band + 1, gap.upper_kappa, 0)):
        # from the same mesh: another one's frequency may lie nearer to a neighbouring band
        value = eigenpairs(fine.pencil, np.array(kappa), number)[0][-1]
        modes = exact_modes(quick.shared, fine.superelement, np.array(kappa), float(np.sqrt(value)))
        found = sensitivity(quick.shared, modes, paths)
        columns.append([found.slopes[path][pick] for path in paths])
    return np.array(columns).T


def beside_dataset(argument: tuple[Sequence[UnitCell], Gap]) -> xr.Dataset:
    """The bands beside a gap for several designs, over the zone; what a worker is given to do."""
    cells, gap = argument
    band = gap.between[0]
    frequencies = []
    for cell in cells:
        pencil = QuickDesign.of(cell, band + 2).model.fine.pencil
        grid, _ = cell.zone.triangles(DIVISIONS)
        wavevectors = (*grid, np.array(gap.lower_kappa), np.array(gap.upper_kappa))
        values = [eigenpairs(pencil, kappa, band + 1)[0][band - 1 :] for kappa in wavevectors]
        frequencies.append(np.sqrt(np.array(values).T) / (2 * np.pi))
    return xr.Dataset({"frequency": (("design", "side", "wavevector"), np.array(frequencies))})


def _beside_task(cells: Sequence[UnitCell], gap: Gap) -> Task:
    return Task({"kind": "beside", "cells": cells, "gap": gap}, (cells, gap))


def _linear(gap: Gap, per_width: Array) -> Surface:
    """The edges as they move to first order."""
    coefficients = np.zeros((terms_needed(len(per_width)), 2, 1))
    coefficients[0, :, 0] = gap.lower, gap.upper
    coefficients[1 : len(per_width) + 1, :, 0] = per_width
    return Surface(coefficients, np.zeros(2))
