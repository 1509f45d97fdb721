"""Widest margin against the pitch."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict

import numpy as np

from haptonic.analyses.designing.tasks import front_dataset, front_task, visits_of
from haptonic.analyses.runner import Runner
from haptonic.design.brief import Brief
from haptonic.design.parameters import FEATURE
from haptonic.design.quick import QUICK
from haptonic.gate import declared
from haptonic.jobs import Task
from haptonic.later import xarray as xr


def compute_front(
    brief: Brief, best: Mapping[str, float], pitches: Sequence[float], *, steps: int, runner: Runner
) -> xr.Dataset:
    """Widest margin for each of the pitches; each search starts from the best design, scaled.

    NaN for a pitch at which no design is allowed.
    """
    asked: dict[float, Task] = {}
    briefs = {pitch: brief.fixed("cell.pitch", pitch) for pitch in pitches}
    for pitch, at_pitch in briefs.items():
        scale = pitch / best["cell.pitch"]
        sizes = [FEATURE.search(path) and brief.links.unit(path) == "m" for path in at_pitch.paths]
        scaled = np.array(
            [
                best[path] * (scale if is_size else 1.0)
                for path, is_size in zip(at_pitch.paths, sizes, strict=True)
            ]
        )
        low, high = at_pitch.box.T
        share = at_pitch.feasible(np.clip((scaled - low) / (high - low), 0.0, 1.0))
        if at_pitch.allows(share):
            asked[pitch] = front_task(at_pitch, share, steps)
    datasets = runner.run(front_dataset, list(asked.values()), 0)
    names = [path for path in brief.paths if path != "cell.pitch"]
    columns = {name: np.full(len(pitches), np.nan) for name in ("lower", "upper", "margin")}
    values = np.full((len(pitches), len(names)), np.nan)
    for pitch, dataset in zip(asked, datasets, strict=True):
        row = list(pitches).index(pitch)
        end = max(visits_of(dataset), key=lambda visit: visit.margin)
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
