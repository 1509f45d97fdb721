"""Designs that a search has found, with all that it has seen on the way."""

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
from haptonic.cell import UnitCell
from haptonic.design.brief import Brief
from haptonic.design.parameters import UNITS, changed
from haptonic.design.quick import QUICK
from haptonic.design.search import Visited, climb, looked_at, starting_points
from haptonic.errors import StudyError
from haptonic.jobs import Task
from haptonic.results.common import Asked, stamped
from haptonic.results.runner import Runner
from haptonic.units import format_quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

POLISH_STEPS = 5  # designs computed at most once the coarse model has been corrected
FRONT_STARTS = 8  # designs looked at for each pitch of a front
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
    values = _rounded(brief, best)
    gap = _gap(runner, changed(brief.cell, values), asked, best.band, done)
    if gap is not None:
        offset = gap.lower - best.lower, gap.upper - best.upper
        polished = runner.run(climb_dataset, [_climb(brief, best, offset, POLISH_STEPS)], done + 1)
        best = keep("polish", polished)[0]
        values = _rounded(brief, best)
        gap = _gap(runner, changed(brief.cell, values), asked, best.band, done + 2)
    margin = -np.inf
    if gap is not None:
        below, above = (
            brief.carrier - gap.lower - gap.lower_error,
            gap.upper - gap.upper_error - brief.carrier,
        )
        margin = min(below, above)
    if gap is None or margin <= 0:
        raise _out_of_reach(brief, best, gap, [visit for _, visit in history])
    return Design(values, gap, margin, stamped(_history(brief, history), inputs))


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
    return xr.Dataset(
        {
            "pitch": ("design", np.asarray(pitches), {"units": "m"}),
            **{name: ("design", column, {"units": units[name]}) for name, column in columns.items()},
            "value": (("design", "parameter"), values, {"units": "SI"}),
        },
        coords={"parameter": names},
        attrs={"carrier_hz": brief.carrier, "mesh": json.dumps(asdict(QUICK))},
    )


def look_dataset(argument: tuple[Brief, Array]) -> xr.Dataset:
    """One design looked at; what a worker is given to do."""
    return _as_dataset([looked_at(*argument)])


def climb_dataset(argument: tuple[Brief, Array, int, tuple[float, float], int]) -> xr.Dataset:
    """One climb; what a worker is given to do."""
    return _as_dataset(list(climb(*argument)))


def front_dataset(argument: tuple[Brief, Array, int]) -> xr.Dataset:
    """The climb at one pitch, from the best of the scaled design and a few others."""
    brief, share, steps = argument
    others = [point for point in starting_points(brief, FRONT_STARTS)[1:] if brief.allows(point)]
    start = max((looked_at(brief, point) for point in (share, *others)), key=lambda visit: visit.margin)
    return _as_dataset(list(climb(brief, start.share, start.band, (0.0, 0.0), steps)))


def _look(brief: Brief, share: Array) -> Task:
    return Task({"kind": "look", "share": share, **_named(brief)}, (brief, share))


def _climb(brief: Brief, start: Visited, offset: tuple[float, float], steps: int) -> Task:
    inputs = {"share": start.share, "band": start.band, "offset": offset, "steps": steps}
    return Task({"kind": "climb", **inputs, **_named(brief)}, (brief, start.share, start.band, offset, steps))


def _front_task(brief: Brief, share: Array, steps: int) -> Task:
    return Task({"kind": "front", "share": share, "steps": steps, **_named(brief)}, (brief, share, steps))


def _named(brief: Brief) -> dict[str, object]:
    # shares are in the order of the paths, which the mapping of bounds alone does not tell
    return {"brief": brief, "paths": brief.paths}


def _rounded(brief: Brief, visit: Visited) -> dict[str, float]:
    """Values of a design by path (SI), as a workshop would write them: lengths in whole micrometres."""
    values = dict(zip(brief.paths, brief.values(visit.share), strict=True))
    return {path: round(v, 6) if UNITS[path] == "m" else v for path, v in values.items()}


def _gap(runner: Runner, cell: UnitCell, asked: Asked, band: int, done: int) -> Gap | None:
    """The complete gap above a band at the accuracy asked for."""
    gaps = runner.gaps(cell, asked, done)
    return next((gap for gap in gaps if gap.between[0] == band and gap.complete), None)


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


def _out_of_reach(brief: Brief, best: Visited, gap: Gap | None, seen: Sequence[Visited]) -> StudyError:
    """How close the search came, and what held it back."""
    values = brief.values(best.share)
    reached = [
        f"{path} = {format_quantity(value, UNITS[path])}"
        for path, value, share in zip(brief.paths, values, best.share, strict=True)
        if min(share, 1 - share) < AT_BOUND
    ]
    limits = brief.limits(best.share).items()
    reached += [f"the limit on the {name}" for name, room in limits if room < AT_BOUND]
    there = [(visit.lower, visit.upper) for visit in seen if visit.lower < visit.upper]
    if gap is not None:
        there.append((gap.lower, gap.upper))
    closest = "no design seen has a gap near it"
    if there:
        lower, upper = min(there, key=lambda edges: max(edges[0] - brief.carrier, brief.carrier - edges[1]))
        away = max(lower - brief.carrier, brief.carrier - upper)
        closest = f"the closest gap seen, {lower / 1e3:.2f} to {upper / 1e3:.2f} kHz, "
        closest += f"misses it by {max(away, 0.0) / 1e3:.2f} kHz"
    bounds = ", ".join(reached) or "none of the bounds"
    if gap is not None and gap.lower < brief.carrier < gap.upper:
        errors = " and ".join(f"{error / 1e3:.2f} kHz" for error in (gap.lower_error, gap.upper_error))
        return StudyError(
            argument="bands.accuracy",
            given=f"edges known to {errors} only",
            allowed="edges known well enough to say that the carrier lies between them",
            cause=f"the gap {gap.lower / 1e3:.2f} to {gap.upper / 1e3:.2f} kHz holds it by less than that",
            next_step="ask for a finer accuracy, or leave [mesh] out",
        )
    return StudyError(
        argument="carrier",
        given=format_quantity(brief.carrier, "Hz"),
        allowed="a frequency that the gap of some allowed design holds",
        cause=f"{closest}; the best design is held back by {bounds}",
        next_step="widen these bounds, vary other parameters, start from more designs ([design] starts), "
        "or choose another carrier",
    )
