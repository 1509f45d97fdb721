"""Designs that a search has found, with all that it has seen on the way."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from numpy.typing import NDArray

from haptonic import plots
from haptonic.bloch import Gap, gaps_of
from haptonic.cell import UnitCell
from haptonic.design.brief import Brief
from haptonic.design.parameters import UNITS
from haptonic.design.search import Visited, climb, looked_at, starting_points
from haptonic.errors import StudyError
from haptonic.jobs import Outcome, Task, run_all
from haptonic.results.common import Asked, key_of, stamped
from haptonic.results.sweeps import design_gaps
from haptonic.store import Store
from haptonic.units import format_quantity

Array = NDArray[np.float64]
Progress = Callable[[int, int, bool], None]

POLISH_STEPS = 5  # designs computed at most once the coarse model has been corrected
AT_BOUND = 0.01  # share of a range, or of a limit, from which one counts as reached
STAGES = ("look", "climb", "polish")


@dataclass(frozen=True)
class Runner:
    """How and where the tasks of a search are computed; see `haptonic.jobs.run_all`."""

    store: Store
    workers: int = 0
    scheduler: str | None = None
    on_progress: Progress | None = None

    def run(
        self, function: Callable[[Any], xr.Dataset], tasks: Sequence[Task], done: int
    ) -> list[xr.Dataset]:
        """Datasets of all tasks; ``done`` tasks of the search were finished before."""

        def counted(now: int, _total: int, stored: bool) -> None:
            if self.on_progress is not None:
                self.on_progress(done + now, 0, stored)

        outcomes = run_all(
            function, tasks, store=self.store, workers=min(self.workers, len(tasks)),
            scheduler=self.scheduler, on_progress=counted,
        )  # fmt: skip
        return [_dataset(outcome) for outcome in outcomes]


def _dataset(outcome: Outcome) -> xr.Dataset:
    if outcome.dataset is None:
        assert outcome.error is not None
        raise outcome.error
    return outcome.dataset


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


def planned(starts: int, climbs: int) -> int:
    """How many tasks a search has."""
    return starts + min(climbs, starts) + 3


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
    """Look at some designs, improve the best, correct the coarse model by the fine one, and improve again.

    Raises
    ------
    StudyError : bounds that contradict each other, or a carrier that no allowed design reaches
    """
    brief.check()
    history: list[tuple[str, Visited]] = []

    def keep(stage: str, datasets: Sequence[xr.Dataset]) -> list[Visited]:
        found = [visit for dataset in datasets for visit in _visits(dataset)]
        history.extend((stage, visit) for visit in found)
        return sorted(found, key=lambda visit: -visit.margin)

    points = starting_points(brief, starts)
    first = keep("look", runner.run(look_dataset, [_look(brief, point) for point in points], 0))
    begun = [_climb(brief, visit, (0.0, 0.0), steps) for visit in first[:climbs]]
    best = keep("climb", runner.run(climb_dataset, begun, len(points)))[0]
    done = len(points) + len(begun)
    gap = _gap(runner, brief.at(best.share), asked, best.band, done)
    if gap is not None:
        offset = gap.lower - best.lower, gap.upper - best.upper
        polished = runner.run(climb_dataset, [_climb(brief, best, offset, POLISH_STEPS)], done + 1)
        best = keep("polish", polished)[0]
        gap = _gap(runner, brief.at(best.share), asked, best.band, done + 2)
    margin = -np.inf
    if gap is not None:
        below, above = (
            brief.carrier - gap.lower - gap.lower_error,
            gap.upper - gap.upper_error - brief.carrier,
        )
        margin = min(below, above)
    if gap is None or margin <= 0:
        raise _out_of_reach(brief, best, gap)
    values = dict(zip(brief.paths, brief.values(best.share), strict=True))
    return Design(values, gap, margin, stamped(_history(brief, history), inputs))


def compute_front(
    brief: Brief, best: Mapping[str, float], pitches: Sequence[float], *, steps: int, runner: Runner
) -> xr.Dataset:
    """The widest margin that each of some pitches allows; each search starts from the best design, scaled.

    Where no design is allowed, all but the pitch is NaN.
    """
    briefs: list[Brief] = []
    starts: list[Array | None] = []
    for pitch in pitches:
        scale = pitch / best["cell.pitch"]
        held = brief.fixed("cell.pitch", pitch)
        scaled = np.array([best[p] * (scale if p.startswith("cell.pillar") else 1.0) for p in held.paths])
        low, high = held.box.T
        share = held.feasible(np.clip((scaled - low) / (high - low), 0.0, 1.0))
        briefs.append(held)
        starts.append(share if held.allows(share) else None)
    there = [(held, share) for held, share in zip(briefs, starts, strict=True) if share is not None]
    datasets = iter(runner.run(front_dataset, [_front_task(*one, steps) for one in there], 0))
    ends = [
        _nowhere(held) if share is None else max(_visits(next(datasets)), key=lambda visit: visit.margin)
        for held, share in zip(briefs, starts, strict=True)
    ]
    values = [dict(zip(b.paths, b.values(v.share), strict=True)) for b, v in zip(briefs, ends, strict=True)]
    names = [path for path in brief.paths if path != "cell.pitch"]
    return xr.Dataset(
        {
            "pitch": ("design", np.asarray(pitches), {"units": "m"}),
            "lower": ("design", [v.lower for v in ends], {"units": "Hz"}),
            "upper": ("design", [v.upper for v in ends], {"units": "Hz"}),
            "margin": ("design", [v.margin for v in ends], {"units": "1"}),
            "value": (("design", "parameter"), np.array([[v[n] for n in names] for v in values])),
        },
        coords={"parameter": names},
        attrs={"carrier_hz": brief.carrier},
    )


def look_dataset(argument: tuple[Brief, Array]) -> xr.Dataset:
    """One design looked at; what a worker is given to do."""
    return _as_dataset([looked_at(*argument)])


def climb_dataset(argument: tuple[Brief, Array, int, tuple[float, float], int]) -> xr.Dataset:
    """One climb; what a worker is given to do."""
    return _as_dataset(list(climb(*argument)))


def front_dataset(argument: tuple[Brief, Array, int]) -> xr.Dataset:
    """The climb at one pitch, from the gap that holds the carrier best at its start."""
    brief, share, steps = argument
    start = looked_at(brief, share)
    return _as_dataset(list(climb(brief, share, start.band, (0.0, 0.0), steps)))


def _look(brief: Brief, share: Array) -> Task:
    return Task({"kind": "look", "share": share.tolist(), **_brief_key(brief)}, (brief, share))


def _climb(brief: Brief, start: Visited, offset: tuple[float, float], steps: int) -> Task:
    inputs = {"share": start.share.tolist(), "band": start.band, "offset": list(offset), "steps": steps}
    return Task(
        {"kind": "climb", **inputs, **_brief_key(brief)}, (brief, start.share, start.band, offset, steps)
    )


def _front_task(brief: Brief, share: Array, steps: int) -> Task:
    inputs = {"share": share.tolist(), "steps": steps, **_brief_key(brief)}
    return Task({"kind": "front", **inputs}, (brief, share, steps))


def _brief_key(brief: Brief) -> dict[str, object]:
    asked = Asked(brief.count, 0, 0.0, None)
    bounds = {path: list(limits) for path, limits in brief.bounds.items()}
    finger = brief.finger and asdict(brief.finger)
    limits = {"slenderness": brief.slenderness, "tool": brief.tool, "reach": brief.reach, "finger": finger}
    held = dict(brief.held)
    return {"carrier": brief.carrier, "bounds": bounds, "held": held, **limits, **key_of(brief.cell, asked)}


def _gap(runner: Runner, cell: UnitCell, asked: Asked, band: int, done: int) -> Gap | None:
    """The complete gap above a band at the accuracy asked for."""
    task = Task({"kind": "gaps", **key_of(cell, asked)}, (cell, asked))
    (dataset,) = runner.run(design_gaps, [task], done)
    return next((gap for gap in gaps_of(dataset) if gap.between[0] == band and gap.complete), None)


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


def _nowhere(brief: Brief) -> Visited:
    """What stands for a design where none is allowed."""
    return Visited(np.full(len(brief.bounds), np.nan), 0, np.nan, np.nan, np.nan)


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
    dataset.attrs["carrier_hz"] = brief.carrier
    return dataset


def _out_of_reach(brief: Brief, best: Visited, gap: Gap | None) -> StudyError:
    """How close the search came, and what held it back."""
    values = brief.values(best.share)
    reached = [
        f"{path} = {format_quantity(value, UNITS[path])}"
        for path, value, share in zip(brief.paths, values, best.share, strict=True)
        if min(share, 1 - share) < AT_BOUND
    ]
    reached += [
        f"the limit on the {name}" for name, room in brief.limits(best.share).items() if room < AT_BOUND
    ]
    lower, upper = (gap.lower, gap.upper) if gap else (best.lower, best.upper)
    edges = f"{lower / 1e3:.2f} to {upper / 1e3:.2f} kHz"
    closest = (
        f"a gap from {edges}" if lower < upper else f"no gap: bands {best.band} and {best.band + 1} overlap"
    )
    bounds = ", ".join(reached) or "none of the bounds"
    if gap is not None and gap.lower < brief.carrier < gap.upper:
        errors = " and ".join(f"{error / 1e3:.2f} kHz" for error in (gap.lower_error, gap.upper_error))
        return StudyError(
            argument="bands.accuracy",
            given=f"edges known to {errors} only",
            allowed="edges known well enough to say that the carrier lies between them",
            cause=f"the closest design has {closest}, but its edges may be off by so much",
            next_step="ask for a finer accuracy, or leave [mesh] out",
        )
    return StudyError(
        argument="carrier",
        given=format_quantity(brief.carrier, "Hz"),
        allowed="a frequency that the gap of some allowed design holds",
        cause=f"the closest design has {closest}; it is held back by {bounds}",
        next_step="widen these bounds, vary other parameters, start from more designs ([design] starts), "
        "or choose another carrier",
    )
