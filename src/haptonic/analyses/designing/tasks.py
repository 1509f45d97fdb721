"""Tasks for the workers of a search, and their results."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, fields

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch import gaps_dataset
from haptonic.bloch.settings import BandSettings
from haptonic.cell import UnitCell
from haptonic.design.brief import Brief
from haptonic.design.quick import QUICK
from haptonic.design.search import HeightRow, Visited, climb, spread, starts_of
from haptonic.gate import describe
from haptonic.jobs import Task
from haptonic.later import xarray as xr

TITLES = {
    "value": ("SI", "varied numbers of the cell"),
    "band": ("1", "number of the band below the gap, from 1"),
    "lower": ("Hz", "lower edge in the model of the search, above the upper edge if the gap is closed"),
    "upper": ("Hz", "upper edge in the model of the search"),
    "margin": ("1", "distance of the carrier from the nearer edge, as a share of the carrier"),
    "stage": ("1", "part of the search"),
}
SEEN = [field.name for field in fields(Visited)]
FRONT_STARTS = 12  # sampled designs for each pitch of a front


def look_task(brief: Brief, shares: Array) -> Task:
    """Task that samples one column of designs."""
    return Task({"kind": "look", "shares": shares, **_named(brief)}, (brief, shares))


def look_dataset(argument: tuple[Brief, Array]) -> xr.Dataset:
    """Places and edges of a column."""
    column = HeightRow.of(*argument)
    return xr.Dataset(
        {
            "share": (("design", "parameter"), column.shares),
            "edges": (("design", "edge", "pair"), column.edges),
        }
    )


def climb_task(brief: Brief, start: Visited, offset: tuple[float, float], steps: int) -> Task:
    """Task that climbs from a design; see `haptonic.design.search.climb`."""
    inputs = {"share": start.share, "band": start.band, "offset": offset, "steps": steps}
    return Task({"kind": "climb", **inputs, **_named(brief)}, (brief, start.share, start.band, offset, steps))


def climb_dataset(argument: tuple[Brief, Array, int, tuple[float, float], int]) -> xr.Dataset:
    """All designs of a climb; the attribute ``settled`` is 1 if no step helps the last one any more."""
    better, is_settled = climb(*argument)
    return as_dataset(better).assign_attrs(settled=int(is_settled))


def gap_task(cell: UnitCell, settings: BandSettings, band: int) -> Task:
    """Task that computes the gap above a band to the required accuracy, and the other gaps less exactly."""
    return Task({"kind": "gap", "above": band, "cell": cell, "settings": settings}, (cell, settings, band))


def gap_dataset(argument: tuple[UnitCell, BandSettings, int]) -> xr.Dataset:
    """Gaps of a design; see `haptonic.bloch.gaps_of`."""
    cell, settings, band = argument
    gaps: xr.Dataset = gaps_dataset(cell, settings, above=band)
    return gaps


def front_task(brief: Brief, share: Array, steps: int) -> Task:
    """Task that climbs at one pitch, from the best of a given design and a few others."""
    return Task({"kind": "front", "share": share, "steps": steps, **_named(brief)}, (brief, share, steps))


def front_dataset(argument: tuple[Brief, Array, int]) -> xr.Dataset:
    """All designs of the climb at one pitch."""
    brief, share, steps = argument
    columns = [HeightRow.of(brief, shares) for shares in spread(brief, FRONT_STARTS, share)]
    start = starts_of(columns, brief.carrier)[0]
    return climb_dataset((brief, start.share, start.band, (0.0, 0.0), steps))


def _named(brief: Brief) -> dict[str, object]:
    # shares are in the order of the paths, which the mapping of bounds does not contain
    return {"brief": brief, "paths": brief.paths}


def as_dataset(visits: Sequence[Visited]) -> xr.Dataset:
    """Designs of a search in their order, as a dataset."""
    columns = {name: np.array([getattr(visit, name) for visit in visits]) for name in SEEN}
    axes = ("visit", "parameter")
    return xr.Dataset({name: (axes[: values.ndim], values) for name, values in columns.items()})


def visits_of(dataset: xr.Dataset) -> list[Visited]:
    """Designs of a dataset, as values."""
    columns = (dataset[name].values for name in SEEN)
    rows = zip(*(column if column.ndim > 1 else column.tolist() for column in columns), strict=True)
    return [Visited(**dict(zip(SEEN, row, strict=True))) for row in rows]


def all_seen(brief: Brief, history: Sequence[tuple[str, Visited]]) -> xr.Dataset:
    """All designs of a search, each with its stage."""
    visits = [visit for _, visit in history]
    dataset = as_dataset(visits).drop_vars("share")
    dataset["value"] = ("visit", "parameter"), np.array([brief.values(visit.share) for visit in visits])
    dataset["stage"] = "visit", np.array([stage for stage, _ in history])
    dataset = dataset.assign_coords(parameter=list(brief.paths))
    describe(dataset, TITLES)
    dataset.attrs |= {"carrier_hz": brief.carrier, "mesh": json.dumps(asdict(QUICK))}
    dataset["parameter"].attrs |= brief.links.attributes(brief.paths)
    return dataset
