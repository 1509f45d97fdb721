"""The search of a design: look all over what is allowed, climb, compute the summits as asked for."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from haptonic.analyses.designing import tasks
from haptonic.analyses.designing.refusals import held_back_by, out_of_reach, uncomputed
from haptonic.analyses.designing.tasks import all_seen, visits_of
from haptonic.analyses.runner import Runner
from haptonic.arrays import Array
from haptonic.bloch import Gap, gaps_of
from haptonic.bloch.settings import BandSettings
from haptonic.design.brief import SLACK, Brief
from haptonic.design.parameters import UNITS
from haptonic.design.search import HeightRow, Visited, distinct, spread, starts_of
from haptonic.errors import HaptonicError
from haptonic.jobs import Task
from haptonic.later import xarray as xr
from haptonic.results.common import stamped
from haptonic.results.design import Design

POLISH_STEPS = 5  # designs computed at most once the coarse model has been corrected
LAST_STEPS = 20  # of the best climb at most, before it is said what holds it back
MORE_CLIMBS = 3  # times as many climbs as asked for, while none has reached the carrier
SAME = 0.02  # of the box, between two summits that count as one
REFINED = 3  # summits computed at the accuracy asked for
COARSE = 0.03  # of the carrier, by which the coarse model may miss an edge: summits below are not refined


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
    """Look at designs all over what is allowed, climb from the best gaps, then correct the coarse model.

    A design that cannot be computed is left out, and the result says so.

    Raises
    ------
    StudyError : bounds that contradict each other, or a carrier that no allowed design reaches
    ResourceError : no design that was found has a mesh that fits the budget and the memory
    """
    brief.check()
    search = _Search(brief, settings, runner)
    begun = starts_of(search.looked(starts), brief.carrier)[: MORE_CLIMBS * climbs]
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
    return Design(best.values, best.gap, best.margin, dataset)


@dataclass(frozen=True)
class _Refined:
    """A design at the accuracy asked for.

    visit : in the coarse model; values : SI, by path; margin : of the carrier in the gap, Hz, errors counted
    """

    visit: Visited
    values: dict[str, float]
    gap: Gap
    margin: float


class _Search:
    """A search under way.

    history : all designs seen, by stage; ends : Hz, lowest frequency of the last band of those looked at
    left_out, failures : those that could not be computed, and why
    tried : summits that were to be computed at the accuracy asked for; refused : those that could not be
    best : the best that could
    """

    def __init__(self, brief: Brief, settings: BandSettings, runner: Runner) -> None:
        self.brief, self.settings, self.runner = brief, settings, runner
        self.history: list[tuple[str, Visited]] = []
        self.ends: list[float] = []
        self.left_out: list[dict[str, Any]] = []
        self.failures: list[HaptonicError] = []
        self.tried: list[Visited] = []
        self.refused: list[tuple[Visited, HaptonicError]] = []
        self.best: _Refined | None = None
        self.done = 0

    def looked(self, count: int) -> list[HeightRow]:
        """Columns of designs, in the coarse model."""
        places = spread(self.brief, count)
        asked = [tasks.look_task(self.brief, shares) for shares in places]
        found = self._run("look", tasks.look_dataset, asked, places)
        columns = [HeightRow(data["share"].values, data["edges"].values) for data in found]
        for column in columns:
            self.history += [("look", one.best(self.brief.carrier)[0][1]) for one in column.alone()]
            self.ends += column.edges[:, 1, -1].tolist()
        if not columns:
            raise self.failures[0]
        return columns

    def climbed(self, begun: Sequence[Visited], steps: int) -> list[Visited]:
        """Ends of climbs from some designs."""
        return [visits[-1] for visits in self._climbs("climb", begun, (0.0, 0.0), steps)]

    def _climbs(
        self, stage: str, begun: Sequence[Visited], offset: tuple[float, float], steps: int
    ) -> list[list[Visited]]:
        asked = [tasks.climb_task(self.brief, visit, offset, steps) for visit in begun]
        found = self._run(stage, tasks.climb_dataset, asked, [visit.share for visit in begun])
        climbs = [visits_of(data) for data in found]
        self.history += [(stage, visit) for visits in climbs for visit in visits]
        return climbs

    def ranked(self, summits: Sequence[Visited]) -> list[Visited]:
        """The summits without doubles, the best first; bands that touch are behind all gaps."""
        return distinct(
            sorted(summits, key=lambda one: (not one.is_open(self.brief.carrier), -one.margin)), SAME
        )

    def refine(self, summits: Sequence[Visited]) -> None:
        """Compute, the best first, those that may beat what has been computed."""
        for summit in summits:
            reached = -np.inf if self.best is None else self.best.margin / self.brief.carrier
            hopeful = summit.is_open(self.brief.carrier) and summit.margin > max(reached, -COARSE)
            computed = len(self.tried) - len(self.refused)
            if hopeful and computed < REFINED and not any(summit is one for one in self.tried):
                self.tried.append(summit)
                found = self.refined(summit)
                found += [] if self.best is None else [self.best]
                self.best = max(found, key=lambda one: one.margin, default=None)

    def refined(self, summit: Visited) -> list[_Refined]:
        """A summit at the accuracy asked for, and what a climb in the model corrected by it makes of it."""
        known = len(self.failures)
        found = self._at_accuracy(summit)
        self.refused += [(summit, failure) for failure in self.failures[known:]]
        for first in found[:1]:
            offset = first.gap.lower - summit.lower, first.gap.upper - summit.upper
            for visits in self._climbs("polish", [summit], offset, POLISH_STEPS):
                found += self._at_accuracy(visits[-1])
        return found

    def _at_accuracy(self, visit: Visited) -> list[_Refined]:
        """The complete gap of a design, if it has one and can be computed."""
        values, found = _rounded(self.brief, visit), []
        task = tasks.gap_task(self.brief.cell.with_numbers(values), self.settings, visit.band)
        for data in self._run("refine", tasks.gap_dataset, [task], [visit.share]):
            for gap in gaps_of(data):
                if gap.complete and gap.between[0] == visit.band:
                    found.append(_Refined(visit, values, gap, gap.margin(self.brief.carrier)))
        return found

    def refusal(self, summits: Sequence[Visited]) -> HaptonicError:
        """Why there is no design to give."""
        if self.refused:
            visit, failure = self.refused[0]
            return uncomputed(self.brief, visit, failure)
        if not summits:
            return self.failures[0]
        if self.best is None:  # a climb cut short tells nothing of what holds it back
            summits = self.ranked([*self.climbed(summits[:1], LAST_STEPS), *summits])
        gap = None if self.best is None else self.best.gap
        return out_of_reach(self.brief, gap, summits, [visit for _, visit in self.history], self.ends)

    def _run(
        self,
        stage: str,
        function: Callable[[Any], xr.Dataset],
        asked: Sequence[Task],
        places: Sequence[Array],
    ) -> list[xr.Dataset]:
        """Datasets of the tasks that could be computed; the others are noted, with the places they are at."""
        outcomes = self.runner.tried(function, asked, self.done)
        self.done += len(asked)
        for outcome, place in zip(outcomes, places, strict=True):
            if outcome.error is not None:
                values = self.brief.values(np.atleast_2d(place)[0])
                named = dict(zip(self.brief.paths, values, strict=True))
                self.left_out.append({"stage": stage, "values": named, "cause": outcome.error.cause})
                self.failures.append(outcome.error)
        return [outcome.dataset for outcome in outcomes if outcome.dataset is not None]


def _rounded(brief: Brief, visit: Visited) -> dict[str, float]:
    """Values of a design by path (SI), as a workshop would write them: lengths in whole micrometres.

    The nearest ones inside the bounds; where these break a limit, single micrometres are given until none is
    broken. A micrometre less of diameter may cost several of height, so that neighbours alone do not do.
    """
    exact, (low, high) = np.array(brief.values(visit.share)), brief.box.T
    least, most = np.ceil(np.round(low * 1e6, 6)), np.floor(np.round(high * 1e6, 6))
    whole = np.array([UNITS[path] == "m" for path in brief.paths]) & (least <= most)

    def valued(micrometres: Array) -> Array:
        return np.where(whole, micrometres / 1e6, exact)

    def broken(micrometres: Array) -> float:
        rooms = brief.limits((valued(micrometres) - low) / (high - low)).values()
        return -sum(min(room + SLACK, 0.0) for room in rooms)

    found, steps = np.clip(np.round(exact * 1e6), least, most), np.eye(len(exact))[whole]
    while broken(found) > 0:
        near = [np.clip(found + step, least, most) for step in (*steps, *-steps)]
        best = min(near, key=broken, default=found)
        if broken(best) >= broken(found):
            break  # no whole micrometres meet the limits, or one limit is met at the cost of another
        found = best
    values = valued(found)
    return dict(zip(brief.paths, values.tolist(), strict=True))
