"""Designs that a search has found, with all that it has seen on the way."""

from __future__ import annotations

import itertools
import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from haptonic import plots
from haptonic.bloch import Gap, gaps_dataset, gaps_of
from haptonic.cell import UnitCell
from haptonic.design.brief import Brief
from haptonic.design.parameters import UNITS, changed
from haptonic.design.quick import QUICK
from haptonic.design.search import Column, Visited, climb, distinct, spread, starts_of
from haptonic.errors import HaptonicError, ResourceError, StudyError
from haptonic.gate import declared
from haptonic.jobs import Task
from haptonic.results.common import Asked, stamped
from haptonic.results.runner import Runner
from haptonic.units import format_quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

POLISH_STEPS = 5  # designs computed at most once the coarse model has been corrected
LAST_STEPS = 20  # of the best climb at most, before it is said what holds it back
MORE_CLIMBS = 3  # times as many climbs as asked for, while none has reached the carrier
SAME = 0.02  # of the box, between two summits that count as one
REFINED = 3  # summits computed at the accuracy asked for
COARSE = 0.03  # of the carrier, by which the coarse model may miss an edge: summits below are not refined
FRONT_STARTS = 12  # designs looked at for each pitch of a front
AT_BOUND = 0.01  # share of a range, or of a limit, from which one counts as reached


@dataclass(frozen=True)
class Design:
    """The best design found, and every one seen.

    values : its numbers by path, SI
    gap : at the accuracy asked for; margin : of the carrier in it, Hz, errors counted
    dataset : all designs seen
    """

    values: dict[str, float]
    gap: Gap
    margin: float
    dataset: xr.Dataset

    @property
    def held_back_by(self) -> list[str]:
        """Bounds and limits that the design has reached, in words."""
        return list(json.loads(self.dataset.attrs["held_back_by"]))

    @property
    def left_out(self) -> list[dict[str, Any]]:
        """Designs that could not be computed: ``stage`` of the search, ``values`` by path (SI), ``cause``."""
        return list(json.loads(self.dataset.attrs["left_out"]))

    def plot(self) -> Figure:
        """Edges of the gap and margin of the carrier, design by design."""
        return plots.search(self.dataset)

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        data = self.dataset
        names = [str(name) for name in data["parameter"].values]
        return {
            "values": self.values,
            "gap": {
                "lower_hz": self.gap.lower,
                "upper_hz": self.gap.upper,
                "lower_error_hz": self.gap.lower_error,
                "upper_error_hz": self.gap.upper_error,
                "between": list(self.gap.between),
            },
            "margin_hz": self.margin,
            "held_back_by": self.held_back_by,
            "left_out": self.left_out,
            "carrier_hz": float(data.attrs["carrier_hz"]),
            "seen": [
                {
                    "stage": str(data["stage"].values[i]),
                    "values": dict(zip(names, data["value"].values[i].tolist(), strict=True)),
                    "lower_hz": float(data["lower"][i]),
                    "upper_hz": float(data["upper"][i]),
                    "margin": float(data["margin"][i]),
                }
                for i in range(data.sizes["visit"])
            ],
        }


def compute_design(
    brief: Brief,
    asked: Asked,
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
    ResourceError : no design that was found can be computed at the accuracy asked for
    """
    brief.check()
    search = _Search(brief, asked, runner)
    begun = starts_of(search.looked(starts), brief.carrier)[: MORE_CLIMBS * climbs]
    summits: list[Visited] = []
    for first in range(0, len(begun), climbs):
        summits = search.ranked(summits + search.climbed(begun[first : first + climbs], steps))
        search.refine(summits)
        if search.best is not None and search.best.margin > 0:
            break
    best = search.best
    if best is None or best.margin <= 0:
        if search.refused:
            raise _uncomputed(brief, *search.refused[0])
        if not summits:
            raise search.failures[0]
        if best is None:  # a climb cut short tells nothing of what holds it back
            summits = search.ranked(search.climbed(summits[:1], LAST_STEPS) + summits)
        raise _out_of_reach(brief, best, summits, [visit for _, visit in search.history])
    dataset = stamped(_history(brief, search.history), inputs)
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

    history : all designs seen, by stage; left_out, failures : those that could not be computed, and why
    tried : summits that were to be computed at the accuracy asked for; refused : those that could not be
    best : the best that could
    """

    def __init__(self, brief: Brief, asked: Asked, runner: Runner) -> None:
        self.brief, self.asked, self.runner = brief, asked, runner
        self.history: list[tuple[str, Visited]] = []
        self.left_out: list[dict[str, Any]] = []
        self.failures: list[HaptonicError] = []
        self.tried: list[Visited] = []
        self.refused: list[tuple[Visited, HaptonicError]] = []
        self.best: _Refined | None = None
        self.done = 0

    def looked(self, count: int) -> list[Column]:
        """Columns of designs, in the coarse model."""
        places = spread(self.brief, count)
        found = self._run("look", look_dataset, [_look(self.brief, shares) for shares in places], places)
        columns = [Column(data["share"].values, data["edges"].values) for data in found]
        for column in columns:
            self.history += [("look", one.best(self.brief.carrier)[0][1]) for one in column.alone()]
        if not columns:
            raise self.failures[0]
        return columns

    def climbed(self, begun: Sequence[Visited], steps: int) -> list[Visited]:
        """Ends of climbs from some designs."""
        tasks = [_climb(self.brief, visit, (0.0, 0.0), steps) for visit in begun]
        visits = [
            _visits(data) for data in self._run("climb", climb_dataset, tasks, [one.share for one in begun])
        ]
        self.history += [("climb", visit) for one in visits for visit in one]
        return [one[-1] for one in visits]

    def ranked(self, summits: Sequence[Visited]) -> list[Visited]:
        """The summits without twins, the best first; bands that touch are behind all gaps."""
        return distinct(
            sorted(summits, key=lambda one: (not one.is_open(self.brief.carrier), -one.margin)), SAME
        )

    def refine(self, summits: Sequence[Visited]) -> None:
        """Compute, the best first, those that may beat what has been computed."""
        for summit in summits:
            reached = -np.inf if self.best is None else self.best.margin / self.brief.carrier
            hopeful = summit.is_open(self.brief.carrier) and summit.margin > max(reached, -COARSE)
            if hopeful and len(self.tried) < REFINED and not any(summit is one for one in self.tried):
                self.tried.append(summit)
                known = len(self.failures)
                found = self.refined(summit)
                if not found and len(self.failures) > known:
                    self.refused.append((summit, self.failures[-1]))
                found += [] if self.best is None else [self.best]
                self.best = max(found, key=lambda one: one.margin, default=None)

    def refined(self, summit: Visited) -> list[_Refined]:
        """A summit at the accuracy asked for, and what a climb in the model corrected by it makes of it."""
        found = self._at_accuracy(summit)
        if found:
            gap = found[0].gap
            offset = gap.lower - summit.lower, gap.upper - summit.upper
            tasks = [_climb(self.brief, summit, offset, POLISH_STEPS)]
            for data in self._run("polish", climb_dataset, tasks, [summit.share]):
                self.history += [("polish", visit) for visit in _visits(data)]
                found += self._at_accuracy(_visits(data)[-1])
        return found

    def _at_accuracy(self, visit: Visited) -> list[_Refined]:
        """The complete gap of a design, if it has one and can be computed."""
        values = _rounded(self.brief, visit)
        cell, found = changed(self.brief.cell, values), []
        key = {"kind": "gap", "above": visit.band, "cell": cell, "asked": self.asked}
        task = Task(key, (cell, self.asked, visit.band))
        for data in self._run("refine", gap_dataset, [task], [visit.share]):
            for gap in gaps_of(data):
                if gap.complete and gap.between[0] == visit.band:
                    below = self.brief.carrier - gap.lower - gap.lower_error
                    above = gap.upper - gap.upper_error - self.brief.carrier
                    found.append(_Refined(visit, values, gap, min(below, above)))
        return found

    def _run(
        self,
        stage: str,
        function: Callable[[Any], xr.Dataset],
        tasks: Sequence[Task],
        places: Sequence[Array],
    ) -> list[xr.Dataset]:
        """Datasets of the tasks that could be computed; the others are noted, with the places they are at."""
        outcomes = self.runner.tried(function, tasks, self.done)
        self.done += len(tasks)
        for outcome, place in zip(outcomes, places, strict=True):
            if outcome.error is not None:
                values = self.brief.values(np.atleast_2d(place)[0])
                named = dict(zip(self.brief.paths, values, strict=True))
                self.left_out.append({"stage": stage, "values": named, "cause": outcome.error.cause})
                self.failures.append(outcome.error)
        return [outcome.dataset for outcome in outcomes if outcome.dataset is not None]


def compute_front(
    brief: Brief, best: Mapping[str, float], pitches: Sequence[float], *, steps: int, runner: Runner
) -> xr.Dataset:
    """The widest margin that each of some pitches allows; each search starts from the best design, scaled.

    NaN where no design is allowed at all.
    """
    tasks: dict[float, Task] = {}
    briefs = {pitch: brief.fixed("cell.pitch", pitch) for pitch in pitches}
    for pitch, held in briefs.items():
        scale = pitch / best["cell.pitch"]
        scaled = np.array([best[p] * (scale if p.startswith("cell.pillar") else 1.0) for p in held.paths])
        low, high = held.box.T
        share = held.feasible(np.clip((scaled - low) / (high - low), 0.0, 1.0))
        if held.allows(share):
            tasks[pitch] = _front_task(held, share, steps)
    datasets = runner.run(front_dataset, list(tasks.values()), 0)
    names = [path for path in brief.paths if path != "cell.pitch"]
    columns = {name: np.full(len(pitches), np.nan) for name in ("lower", "upper", "margin")}
    values = np.full((len(pitches), len(names)), np.nan)
    for pitch, dataset in zip(tasks, datasets, strict=True):
        row = list(pitches).index(pitch)
        end = max(_visits(dataset), key=lambda visit: visit.margin)
        values[row] = briefs[pitch].values(end.share)
        for name, column in columns.items():
            column[row] = getattr(end, name)
    units = {"lower": "Hz", "upper": "Hz", "margin": "1"}
    front = xr.Dataset(
        {
            "pitch": ("design", np.asarray(pitches), {"units": "m"}),
            **{name: ("design", column, {"units": units[name]}) for name, column in columns.items()},
            "value": (("design", "parameter"), values, {"units": "SI"}),
        },
        coords={"parameter": names},
        attrs={"carrier_hz": brief.carrier, "mesh": json.dumps(asdict(QUICK))},
    )
    return declared(front, **dict.fromkeys((*columns, "value"), "no design of this pitch is allowed"))


def look_dataset(argument: tuple[Brief, Array]) -> xr.Dataset:
    """One column of designs looked at; what a worker is given to do."""
    brief, shares = argument
    column = Column.of(brief, shares)
    return xr.Dataset(
        {
            "share": (("design", "parameter"), column.shares),
            "edges": (("design", "edge", "pair"), column.edges),
        }
    )


def climb_dataset(argument: tuple[Brief, Array, int, tuple[float, float], int]) -> xr.Dataset:
    """One climb; what a worker is given to do."""
    return _as_dataset(list(climb(*argument)))


def gap_dataset(argument: tuple[UnitCell, Asked, int]) -> xr.Dataset:
    """The gap above a band at the accuracy asked for, others less surely; what a worker is given to do."""
    cell, asked, band = argument
    found: xr.Dataset = gaps_dataset(
        cell, count=asked.count, accuracy=asked.accuracy, resolution=asked.resolution, above=band
    )
    return found


def front_dataset(argument: tuple[Brief, Array, int]) -> xr.Dataset:
    """The climb at one pitch, from the best of the scaled design and a few others."""
    brief, share, steps = argument
    columns = [Column.of(brief, shares) for shares in spread(brief, FRONT_STARTS, share)]
    start = starts_of(columns, brief.carrier)[0]
    return _as_dataset(list(climb(brief, start.share, start.band, (0.0, 0.0), steps)))


def _look(brief: Brief, shares: Array) -> Task:
    return Task({"kind": "look", "shares": shares, **_named(brief)}, (brief, shares))


def _climb(brief: Brief, start: Visited, offset: tuple[float, float], steps: int) -> Task:
    inputs = {"share": start.share, "band": start.band, "offset": offset, "steps": steps}
    return Task({"kind": "climb", **inputs, **_named(brief)}, (brief, start.share, start.band, offset, steps))


def _front_task(brief: Brief, share: Array, steps: int) -> Task:
    return Task({"kind": "front", "share": share, "steps": steps, **_named(brief)}, (brief, share, steps))


def _named(brief: Brief) -> dict[str, object]:
    # shares are in the order of the paths, which the mapping of bounds alone does not tell
    return {"brief": brief, "paths": brief.paths}


def _rounded(brief: Brief, visit: Visited) -> dict[str, float]:
    """Values of a design by path (SI), as a workshop would write them: lengths in whole micrometres.

    Each is one of the two next to the exact value: the nearest that break no bound and no limit together.
    """
    exact = brief.values(visit.share)
    choices = []
    for path, value, (low, high) in zip(brief.paths, exact, brief.box, strict=True):
        whole = [math.floor(value * 1e6) / 1e6, math.ceil(value * 1e6) / 1e6] if UNITS[path] == "m" else []
        choices.append([v for v in whole if low <= v <= high] or [value])
    lowest, highest = brief.box.T
    span = highest - lowest
    near = sorted(
        itertools.product(*choices),
        key=lambda values: float((np.abs(np.array(values) - exact) / span).sum()),
    )
    allowed = (values for values in near if brief.allows((np.array(values) - lowest) / span))
    return dict(zip(brief.paths, next(allowed, near[0]), strict=True))


def _as_dataset(visits: Sequence[Visited]) -> xr.Dataset:
    return xr.Dataset(
        {
            "share": (("visit", "parameter"), np.array([visit.share for visit in visits])),
            "band": ("visit", np.array([visit.band for visit in visits])),
            "lower": ("visit", np.array([visit.lower for visit in visits])),
            "upper": ("visit", np.array([visit.upper for visit in visits])),
            "margin": ("visit", np.array([visit.margin for visit in visits])),
        }
    )


def _visits(dataset: xr.Dataset) -> list[Visited]:
    rows = zip(*(dataset[name].values for name in ("share", "band", "lower", "upper", "margin")), strict=True)
    return [Visited(share, int(band), float(low), float(up), float(m)) for share, band, low, up, m in rows]


def _history(brief: Brief, history: Sequence[tuple[str, Visited]]) -> xr.Dataset:
    visits = [visit for _, visit in history]
    dataset = _as_dataset(visits).drop_vars("share")
    dataset["value"] = ("visit", "parameter"), np.array([brief.values(visit.share) for visit in visits])
    dataset["stage"] = "visit", np.array([stage for stage, _ in history])
    dataset = dataset.assign_coords(parameter=list(brief.paths))
    words = {
        "value": ("SI", "numbers of the cell that were varied"),
        "band": ("1", "number of the band below the gap, from 1"),
        "lower": ("Hz", "lower edge in the model of the search, above the upper one where there is no gap"),
        "upper": ("Hz", "upper edge in the model of the search"),
        "margin": ("1", "distance of the carrier from the nearer edge, as a share of the carrier"),
        "stage": ("1", "part of the search"),
    }
    for name, (unit, title) in words.items():
        dataset[name].attrs = {"units": unit, "long_name": title}
    dataset.attrs |= {"carrier_hz": brief.carrier, "mesh": json.dumps(asdict(QUICK))}
    return dataset


def held_back_by(brief: Brief, share: Array) -> list[str]:
    """Bounds and limits that a design has reached, in words; each could be widened or relaxed."""
    values = zip(brief.paths, brief.values(share), share, strict=True)
    reached = [
        f"{path} = {format_quantity(value, UNITS[path])}"
        for path, value, place in values
        if min(place, 1 - place) < AT_BOUND
    ]
    return reached + [
        f"the limit on the {name}" for name, room in brief.limits(share).items() if room < AT_BOUND
    ]


def _out_of_reach(
    brief: Brief, best: _Refined | None, summits: Sequence[Visited], seen: Sequence[Visited]
) -> StudyError:
    """How close the search came, and what held it back."""
    carrier = brief.carrier
    if best is not None and best.gap.lower < carrier < best.gap.upper:
        gap = best.gap
        lower, upper, *errors = in_khz(gap.lower, gap.upper, gap.lower_error, gap.upper_error)
        return StudyError(
            argument="bands.accuracy",
            given=f"edges known to {' and '.join(errors)} kHz only",
            allowed="edges known well enough to say that the carrier lies between them",
            cause=f"the gap {lower} to {upper} kHz holds it by less than that",
            next_step="ask for a finer accuracy, or leave [mesh] out",
        )
    there = [(visit.lower, visit.upper) for visit in seen if visit.is_open(carrier)]
    there += [(best.gap.lower, best.gap.upper)] if best is not None else []
    closest = "no design seen has a gap at all"
    if there:
        edges = min(there, key=lambda edges: max(edges[0] - carrier, carrier - edges[1]))
        lower, upper, away = in_khz(*edges, max(edges[0] - carrier, carrier - edges[1]))
        closest = f"the closest gap seen, {lower} to {upper} kHz, misses it by {away} kHz"
    reached = held_back_by(brief, summits[0].share)
    held = f"the best design is held back by {', '.join(reached)}"
    return StudyError(
        argument="carrier",
        given=format_quantity(carrier, "Hz"),
        allowed="a frequency that the gap of some allowed design holds",
        cause=f"{closest}; {held if reached else 'the best design lies inside all bounds and limits'}",
        next_step=("widen these bounds, vary" if reached else "vary")
        + " other parameters, look at more designs ([design] starts and climbs), or choose another carrier",
    )


def _uncomputed(brief: Brief, summit: Visited, failure: HaptonicError) -> ResourceError:
    """Designs were found, and none of them can be computed as exactly as asked for."""
    values = zip(brief.paths, brief.values(summit.share), strict=True)
    named = ", ".join(f"{path} = {format_quantity(value, UNITS[path])}" for path, value in values)
    lower, upper = in_khz(summit.lower, summit.upper)
    return ResourceError(
        argument=failure.argument,
        given=failure.given,
        allowed=failure.allowed,
        cause=f"{failure.cause}; no design found can be computed. The best of them, {named}, "
        f"has, in the coarse model, a gap from {lower} to {upper} kHz",
        next_step=failure.next_step,
    )


def in_khz(*frequencies: float) -> list[str]:
    """Frequencies, Hz, with so many digits that those that differ read so, and none reads as zero."""
    steps = [abs(f) for f in frequencies] + [abs(a - b) for a, b in itertools.combinations(frequencies, 2)]
    steps = [step for step in steps if step]
    digits = min(9, max(2, *(1 - math.floor(math.log10(step / 1e3)) for step in steps))) if steps else 2
    return [f"{frequency / 1e3:.{digits}f}" for frequency in frequencies]
