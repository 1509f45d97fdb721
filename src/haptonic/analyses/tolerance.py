"""Probability that the gap contains the carrier on plates with manufacturing tolerances."""

from __future__ import annotations

import json
from dataclasses import asdict, replace

import numpy as np

from haptonic.analyses.analysis import KEPT, Analysis
from haptonic.analyses.costs import gaps
from haptonic.analyses.needs import need_carrier
from haptonic.analyses.options import NoOptions
from haptonic.analyses.points import ComputedPoint, PointNumber, Points
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import made_of_parts
from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.bloch.gaps import need_gap_at
from haptonic.design.discs import with_shared
from haptonic.design.edges import beside_dataset, edge_slopes, linear
from haptonic.design.links import Links
from haptonic.design.quick import QUICK
from haptonic.design.spread_designs import check_possible, deviations, own_values, samples
from haptonic.design.tolerance import Chances, Surface, edges_of, first_order, terms_needed
from haptonic.errors import StudyError
from haptonic.fields.expressions import NAMED
from haptonic.jobs import Outcome, Task
from haptonic.later import xarray as xr
from haptonic.results.common import stamped
from haptonic.results.cost import Cost
from haptonic.results.tolerance import Tolerance
from haptonic.study.named import links_of
from haptonic.study.schema import Description

BATCH = 8  # designs of one task
DRAWN = 2000  # plates in the dataset of the result
# share of the estimate for a mesh, per design beside the study's own; measured: 0.77 for the paper's cell,
# 1.07 centred, 1.25 oblique, 0.66 kagome, 0.53 Lieb
SAMPLE = 0.9


def check(study: Description, options: NoOptions) -> None:
    """Raise StudyError without a carrier or spreads, with too few samples, or with impossible spreads."""
    need_carrier(study)
    section = study.tolerance_settings
    if not section.of:
        raise StudyError.missing(
            argument="tolerance.of",
            allowed="at least one [[tolerance.of]] table with parameter and spread",
            cause="the study gives no spread of a parameter",
            next_step='add [[tolerance.of]] with parameter = "cell.pillar.diameter", spread = "20 um"',
        )
    count, needed = section.samples, terms_needed(len(section.of))
    if count < 2 * needed:
        raise StudyError.too_few(
            argument="tolerance.samples",
            given=count,
            allowed=f"at least {2 * needed} for {len(section.of)} spreads",
            cause=f"a quadratic in so many parameters has {needed} coefficients",
            next_step="compute more samples, or leave out spreads of little effect",
        )
    check_possible(study.cell, section.of, count, links_of(study))


def compute(study: Description, options: NoOptions, runner: Runner) -> Tolerance:
    """First-order result from exact slopes, full result from computed designs.

    Raises
    ------
    StudyError : as `check`, or a nominal gap that does not contain the carrier
    """
    check(study, options)
    section = study.tolerance_settings
    cell, carrier, count, spreads = study.cell, need_carrier(study), section.samples, section.of
    links, paths = links_of(study), [spread.parameter for spread in spreads]
    gap = need_gap_at(runner.gaps(cell, study.bands_settings), carrier)
    designs = samples(cell, spreads, count, links)
    batches = [designs[i : i + BATCH] for i in range(0, count, BATCH)]
    tasks = [
        Task({"kind": "beside", "cells": cells, "gap": gap}, (cells, gap)) for cells in ([cell], *batches)
    ]
    drawn = DrawnPoints(study, gap, links, runner.report)
    datasets = runner.run(beside_dataset, tasks, 1, drawn.heard)
    nominal, *parts = (dataset["frequency"].values for dataset in datasets)
    offset = np.array(gap.edges) - edges_of(nominal)[0]
    frequency = np.concatenate(parts) + offset[:, None]
    own = {path: float(links.own(path)) for path in paths if path.startswith(NAMED)}
    slopes = edge_slopes(cell, gap, paths, links.directions(own))
    widths = np.array([spread.spread for spread in spreads])
    surface = Surface.fitted(deviations(spreads, count) / widths, frequency)
    chances = Chances(
        surface=surface, spreads=spreads, carrier=carrier, margin=section.margin, pillars=section.pillars
    )
    errors = gap.lower_error, gap.upper_error
    ends = [replace(chances, narrowed=(sign * errors[0], sign * errors[1])) for sign in (1, -1)]
    straight = replace(chances, surface=linear(gap, slopes * widths[:, None]))
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
            "spread": ("parameter", widths, {"units": "SI", "long_name": "spreads of the study"}),
            "slope": (("parameter", "side"), slopes, {"units": "Hz/SI"}),
            "first_order_share": (("parameter", "side"), variance / variance.sum(axis=0), {"units": "1"}),
            "total_index": (("parameter", "side"), chances.importance(), {"units": "1"}),
            "deviation": ("side", chances.deviations(), {"units": "Hz"}),
            "first_order_deviation": ("side", np.sqrt(variance.sum(axis=0)), {"units": "Hz"}),
            "fit_doubt": ("side", surface.doubt, {"units": "Hz"}),
        },
        coords={"parameter": paths, "side": ["lower", "upper"]},
        attrs={
            "carrier_hz": carrier,
            "margin_hz": section.margin,
            "mesh": json.dumps(asdict(QUICK)),
            "chance_to_first_order": straight.of_a_plate(),
        },
    )  # fmt: skip
    dataset["parameter"].attrs |= links.attributes(paths)
    if study.bands_settings.resolution is None:
        dataset.attrs |= {"accuracy": study.bands_settings.accuracy, "largest_error": gap.relative_error}
    return Tolerance(
        gap=gap,
        plate=chances.of_a_plate(),
        pillar=chances.of_one_pillar(),
        plate_range=(ends[0].of_a_plate(), ends[1].of_a_plate()),
        pillar_range=(ends[0].of_one_pillar(), ends[1].of_one_pillar()),
        loosest=chances.loosest(section.confidence),
        exact_sizes=chances.of_a_plate(0.0),
        dataset=stamped(dataset, study.inputs()),
        margin=section.margin,
        pillars=section.pillars,
        confidence=section.confidence,
    )


class DrawnPoints:
    """Reports the designs of a study's tolerances with the edges of their gap.

    The edges come from the model next to the gap, moved so that those of the study are exact, so the designs
    wait for the nominal one, the first task.
    """

    def __init__(self, study: Description, gap: Gap, links: Links, report: Points) -> None:
        self.study, self.gap, self.report = study, gap, report
        spreads = study.tolerance_settings.of
        self.own = own_values(study.cell, spreads, links)
        self.units = {path: links.unit(path) for path in self.own}
        self.rows = deviations(spreads, study.tolerance_settings.samples)
        self.offset: Array | None = None
        self.waiting: list[tuple[int, Outcome]] = []

    def heard(self, position: int, outcome: Outcome) -> None:
        """Note a finished task; see `haptonic.jobs.run_all`."""
        if position:
            self.waiting.append((position, outcome))
        elif outcome.dataset is not None:
            nominal = edges_of(outcome.dataset["frequency"].values)[0]
            self.offset = np.array(self.gap.edges) - nominal
        if self.offset is None:
            return
        for place, batch in self.waiting:
            if batch.dataset is not None:
                edges = edges_of(batch.dataset["frequency"].values) + self.offset
                for number, pair in enumerate(edges, start=(place - 1) * BATCH):
                    self.report(self._point(number, pair))
        self.waiting.clear()

    def _point(self, number: int, edges: Array) -> ComputedPoint:
        values = {
            path: own + float(d) for (path, own), d in zip(self.own.items(), self.rows[number], strict=True)
        }
        return ComputedPoint(
            group="designs within the spreads",
            changes=with_shared(self.study.cell, values),
            varied=tuple(PointNumber(path, value, self.units[path]) for path, value in values.items()),
            results=(
                PointNumber("lower edge", float(edges[0]), "Hz"),
                PointNumber("upper edge", float(edges[1]), "Hz"),
            ),
        )


def cost(study: Description, options: NoOptions) -> Cost:
    """Estimated cost of the designs within the spreads."""
    return gaps(study) + Cost(SAMPLE * QUICK.seconds(study.cell) * study.tolerance_settings.samples)


ANALYSIS = Analysis(
    name="tolerance",
    result=Tolerance,
    compute=compute,
    supports=made_of_parts,
    cost=cost,
    planned=lambda study: study.carrier is not None and bool(study.tolerance_settings.of),
    check=check,
    parallel=True,
    kept=KEPT,
)
