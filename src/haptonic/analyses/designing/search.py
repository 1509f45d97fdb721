"""The search of a design: sample the allowed designs, climb, compute the summits to the required accuracy."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from haptonic.analyses.designing import tasks
from haptonic.analyses.designing.refusals import held_back_by, out_of_reach, uncomputed
from haptonic.analyses.designing.tasks import all_seen, visits_of
from haptonic.analyses.points import ComputedPoint, PointNumber
from haptonic.analyses.runner import Runner
from haptonic.arrays import Array
from haptonic.bloch import Gap, gaps_of
from haptonic.bloch.settings import BandSettings
from haptonic.design.brief import SLACK, Brief
from haptonic.design.discs import with_shared
from haptonic.design.search import HeightRow, Visited, begun_from, distinct, spread, starts_of
from haptonic.errors import HaptonicError
from haptonic.jobs import Outcome, Task
from haptonic.later import xarray as xr
from haptonic.results.common import stamped
from haptonic.results.design import Design

LAST_STEPS = 20  # most designs of climbs whose ends are reported, unless the user allows more
SAME = 0.02  # of the box; closer summits count as one
REFINED = 3  # summits computed to the required accuracy
STAGES = {
    "look": "sampled, coarse model", "climb": "climbs, coarse model", "polish": "climbs, corrected model",
    "refine": "required accuracy",
}  # fmt: skip
COARSE = 0.03  # of the carrier; largest error of an edge in the coarse model: summits below are not refined


def compute_design(
    brief: Brief,
    settings: BandSettings,
    *,
    starts: int,
    climbs: int,
    steps: int,
    inputs: Mapping[str, Any],
    runner: Runner,
) -> Design:
    """Sample the allowed designs, climb from the best gaps, then correct the coarse model.

    The brief has allowed designs, see `haptonic.design.unmet`.

    Designs that cannot be computed are left out and listed in the result.

    Raises
    ------
    StudyError : a carrier that no allowed design reaches
    ResourceError : no design of the search has a mesh within the budget and the memory
    """
    search = _Search(brief, settings, runner, max(steps, LAST_STEPS))
    begun = begun_from(starts_of(search.looked(starts), brief.carrier), brief.carrier, climbs)
    summits: list[Visited] = []
    for first in range(0, len(begun), climbs):
        summits = search.ranked(summits + search.climbed(begun[first : first + climbs], steps))
        search.refine(summits)
        if search.best is not None and search.best.margin > 0:
            break
    best = search.best
    if best is None or best.margin <= 0:
        raise search.refusal(summits)
    dataset = stamped(all_seen(brief, search.history), inputs)
    if settings.resolution is None:
        dataset.attrs |= {"accuracy": settings.accuracy, "largest_error": best.gap.relative_error}
    dataset.attrs["left_out"] = json.dumps(search.left_out)
    dataset.attrs["held_back_by"] = json.dumps(held_back_by(brief, best.visit.share))
    dataset.attrs["settled"] = int(best.is_settled)
    return Design(best.values, best.gap, best.margin, dataset)


@dataclass(frozen=True)
class _Refined:
    """A design at the required accuracy.

    visit : in the coarse model; values : SI, by path; margin : of the carrier in the gap with errors, Hz
    is_settled : whether the corrected model shows no better design nearby
    """

    visit: Visited
    values: dict[str, float]
    gap: Gap
    margin: float
    is_settled: bool = False


class _Search:
    """State of a search.

    last_steps : most designs of climbs whose ends are reported
    history : all designs, by stage; ends : Hz, lowest frequency of the last band of each sampled design
    left_out, failures : designs that could not be computed, with the reasons
    tried : summits for the required accuracy; refused : those that could not be computed
    best : the best one that could be computed
    """

    def __init__(self, brief: Brief, settings: BandSettings, runner: Runner, last_steps: int) -> None:
        self.brief, self.settings, self.runner, self.last_steps = brief, settings, runner, last_steps
        self.history: list[tuple[str, Visited]] = []
        self.ends: list[float] = []
        self.left_out: list[dict[str, Any]] = []
        self.failures: list[HaptonicError] = []
        self.tried: list[Visited] = []
        self.refused: list[tuple[Visited, HaptonicError]] = []
        self.best: _Refined | None = None
        self.done = 0

    def looked(self, count: int) -> list[HeightRow]:
        """Columns of sampled designs, in the coarse model."""
        places = spread(self.brief, count)
        asked = [tasks.look_task(self.brief, shares) for shares in places]
        datasets = self._run("look", tasks.look_dataset, asked, places)
        columns = [HeightRow(data["share"].values, data["edges"].values) for data in datasets]
        for column in columns:
            self.history += [("look", row.best(self.brief.carrier)[0][1]) for row in column.alone()]
            self.ends += column.edges[:, 1, -1].tolist()
        if not columns:
            raise self.failures[0]
        return columns

    def climbed(self, begun: Sequence[Visited], steps: int) -> list[Visited]:
        """Ends of climbs from the given designs."""
        return [visits[-1] for visits, _ in self._climbs("climb", begun, (0.0, 0.0), steps)]

    def _climbs(
        self, stage: str, begun: Sequence[Visited], offset: tuple[float, float], steps: int
    ) -> list[tuple[list[Visited], bool]]:
        """Designs of climbs, and whether each ended where no step helps."""
        asked = [tasks.climb_task(self.brief, visit, offset, steps) for visit in begun]
        datasets = self._run(stage, tasks.climb_dataset, asked, [visit.share for visit in begun])
        climbs = [(visits_of(data), bool(data.attrs["settled"])) for data in datasets]
        self.history += [(stage, visit) for visits, _ in climbs for visit in visits]
        return climbs

    def ranked(self, summits: Sequence[Visited]) -> list[Visited]:
        """Summits without duplicates, the best first; bands that touch come after all gaps."""
        return distinct(
            sorted(summits, key=lambda visit: (not visit.is_open(self.brief.carrier), -visit.margin)), SAME
        )

    def refine(self, summits: Sequence[Visited]) -> None:
        """Compute, the best first, the summits that may exceed the best computed design.

        They are at most ``REFINED``, and further ones of later climbs that exceed all of these.
        """
        for summit in summits:
            reached = -np.inf if self.best is None else self.best.margin / self.brief.carrier
            hopeful = summit.is_open(self.brief.carrier) and summit.margin > max(reached, -COARSE)
            computed = len(self.tried) - len(self.refused)
            higher = all(summit.margin > other.margin for other in self.tried)
            untried = not any(summit is other for other in self.tried)
            if hopeful and untried and (higher or computed < REFINED):
                self.tried.append(summit)
                candidates = self.refined(summit)
                candidates += [] if self.best is None else [self.best]
                self.best = max(candidates, key=lambda design: design.margin, default=None)

    def refined(self, summit: Visited) -> list[_Refined]:
        """A summit at the required accuracy, and the end of a climb in the model corrected by it."""
        before = len(self.failures)
        designs = self._at_accuracy(summit)
        self.refused += [(summit, failure) for failure in self.failures[before:]]
        for first in designs[:1]:
            offset = first.gap.lower - summit.lower, first.gap.upper - summit.upper
            for visits, is_settled in self._climbs("polish", [summit], offset, self.last_steps):
                designs += self._at_accuracy(visits[-1])
                designs = [replace(design, is_settled=is_settled) for design in designs]
        return designs

    def _at_accuracy(self, visit: Visited) -> list[_Refined]:
        """Complete gap of a design; empty without a gap, or if it cannot be computed."""
        values, designs = _round_to_micrometres(self.brief, visit.share), []
        task = tasks.gap_task(self.brief.made(values), self.settings, visit.band)
        for data in self._run("refine", tasks.gap_dataset, [task], [visit.share]):
            for gap in gaps_of(data):
                if gap.complete and gap.between[0] == visit.band:
                    designs.append(_Refined(visit, values, gap, gap.margin(self.brief.carrier)))
        return designs

    def refusal(self, summits: Sequence[Visited]) -> HaptonicError:
        """Error of a search without a result."""
        if self.refused:
            visit, failure = self.refused[0]
            return uncomputed(self.brief, visit, failure)
        if not summits:
            return self.failures[0]
        if self.best is None:  # only a finished climb shows the bounds that limit it
            summits = self.ranked([*self.climbed(summits[:1], self.last_steps), *summits])
        gap = None if self.best is None else self.best.gap
        return out_of_reach(self.brief, gap, summits, [visit for _, visit in self.history], self.ends)

    def _run(
        self,
        stage: str,
        function: Callable[[Any], xr.Dataset],
        asked: Sequence[Task],
        places: Sequence[Array],
    ) -> list[xr.Dataset]:
        """Datasets of the tasks that succeed; the failures are noted with the places of their designs."""
        outcomes = self.runner.tried(
            function, asked, self.done, lambda k, outcome: self._report(stage, places[k], outcome)
        )
        self.done += len(asked)
        for outcome, place in zip(outcomes, places, strict=True):
            if outcome.error is not None:
                values = self.brief.values(np.atleast_2d(place)[0])
                named = dict(zip(self.brief.paths, values, strict=True))
                self.left_out.append({"stage": stage, "values": named, "cause": outcome.error.cause})
                self.failures.append(outcome.error)
        return [outcome.dataset for outcome in outcomes if outcome.dataset is not None]

    def _report(self, stage: str, place: Array, outcome: Outcome) -> None:
        """Report the designs of a finished task."""
        data = outcome.dataset
        if data is None:
            return
        if stage == "look":
            rows = HeightRow(data["share"].values, data["edges"].values).alone()
            visits = [row.best(self.brief.carrier)[0][1] for row in rows]
        elif stage == "refine":
            self._report_gaps(place, data)
            return
        else:
            visits = visits_of(data)
        for visit in visits:
            values = dict(zip(self.brief.paths, self.brief.values(visit.share), strict=True))
            margin = PointNumber("margin of the carrier", visit.margin * self.brief.carrier, "Hz")
            self._report_point(stage, values, (margin,))

    def _report_gaps(self, place: Array, data: xr.Dataset) -> None:
        """Report a design at the required accuracy, with the margin in its gap next to the carrier."""
        carrier, gaps = self.brief.carrier, [gap for gap in gaps_of(data) if gap.complete]
        if not gaps:
            return
        gap = max(gaps, key=lambda gap: gap.margin(carrier))
        margin, error = min((carrier - gap.lower, gap.lower_error), (gap.upper - carrier, gap.upper_error))
        values = _round_to_micrometres(self.brief, place)
        self._report_point("refine", values, (PointNumber("margin of the carrier", margin, "Hz", error),))

    def _report_point(
        self, stage: str, values: Mapping[str, float], results: tuple[PointNumber, ...]
    ) -> None:
        units = self.brief.links.unit
        self.runner.report(
            ComputedPoint(
                group=STAGES[stage],
                changes=with_shared(self.brief.cell, values),
                varied=tuple(PointNumber(path, value, units(path)) for path, value in values.items()),
                results=results,
            )
        )


def _round_to_micrometres(brief: Brief, share: Array) -> dict[str, float]:
    """Values of a design by path (SI), with lengths in whole micrometres as in a workshop.

    These are the nearest values inside the bounds. If they break a limit, they are changed by single
    micrometres until no limit is broken. A micrometre of diameter may cost several of height, so the direct
    neighbours are not enough.
    """
    exact, (low, high) = np.array(brief.values(share)), brief.box.T
    least, most = np.ceil(np.round(low * 1e6, 6)), np.floor(np.round(high * 1e6, 6))
    whole = np.array([brief.links.unit(path) == "m" for path in brief.paths]) & (least <= most)

    def in_si(micrometres: Array) -> Array:
        return np.where(whole, micrometres / 1e6, exact)

    def broken(micrometres: Array) -> float:
        rooms = brief.limits((in_si(micrometres) - low) / (high - low)).values()
        return -sum(min(room + SLACK, 0.0) for room in rooms)

    rounded, steps = np.clip(np.round(exact * 1e6), least, most), np.eye(len(exact))[whole]
    while broken(rounded) > 0:
        near = [np.clip(rounded + step, least, most) for step in (*steps, *-steps)]
        best = min(near, key=broken, default=rounded)
        if broken(best) >= broken(rounded):
            break  # no whole micrometres meet the limits, or one limit is met at the cost of another
        rounded = best
    values = in_si(rounded)
    return dict(zip(brief.paths, values.tolist(), strict=True))
