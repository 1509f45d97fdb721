"""What workers of a search are given to do, and what comes back."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch import gaps_dataset
from haptonic.bloch.settings import BandSettings
from haptonic.cell import UnitCell
from haptonic.design.brief import Brief
from haptonic.design.search import HeightRow, Visited, climb, spread, starts_of
from haptonic.jobs import Task
from haptonic.later import xarray as xr

FRONT_STARTS = 12  # designs looked at for each pitch of a front


def look_task(brief: Brief, shares: Array) -> Task:
    """Look at one column of designs."""
    return Task({"kind": "look", "shares": shares, **_named(brief)}, (brief, shares))


def look_dataset(argument: tuple[Brief, Array]) -> xr.Dataset:
    """Places and edges of the column."""
    column = HeightRow.of(*argument)
    return xr.Dataset(
        {
            "share": (("design", "parameter"), column.shares),
            "edges": (("design", "edge", "pair"), column.edges),
        }
    )


def climb_task(brief: Brief, start: Visited, offset: tuple[float, float], steps: int) -> Task:
    """Climb from a design; see `haptonic.design.search.climb`."""
    inputs = {"share": start.share, "band": start.band, "offset": offset, "steps": steps}
    return Task({"kind": "climb", **inputs, **_named(brief)}, (brief, start.share, start.band, offset, steps))


def climb_dataset(argument: tuple[Brief, Array, int, tuple[float, float], int]) -> xr.Dataset:
    """All designs of the climb."""
    return as_dataset(list(climb(*argument)))


def gap_task(cell: UnitCell, settings: BandSettings, band: int) -> Task:
    """Compute the gap above a band at the accuracy asked for, others less surely."""
    return Task({"kind": "gap", "above": band, "cell": cell, "settings": settings}, (cell, settings, band))


def gap_dataset(argument: tuple[UnitCell, BandSettings, int]) -> xr.Dataset:
    """The gaps; see `haptonic.bloch.gaps_of`."""
    cell, settings, band = argument
    found: xr.Dataset = gaps_dataset(cell, settings, above=band)
    return found


def front_task(brief: Brief, share: Array, steps: int) -> Task:
    """Climb at one pitch, from the best of a design and a few others."""
    return Task({"kind": "front", "share": share, "steps": steps, **_named(brief)}, (brief, share, steps))


def front_dataset(argument: tuple[Brief, Array, int]) -> xr.Dataset:
    """All designs of the climb."""
    brief, share, steps = argument
    columns = [HeightRow.of(brief, shares) for shares in spread(brief, FRONT_STARTS, share)]
    start = starts_of(columns, brief.carrier)[0]
    return climb_dataset((brief, start.share, start.band, (0.0, 0.0), steps))


def _named(brief: Brief) -> dict[str, object]:
    # shares are in the order of the paths, which the mapping of bounds alone does not tell
    return {"brief": brief, "paths": brief.paths}


def as_dataset(visits: Sequence[Visited]) -> xr.Dataset:
    """Designs on the way of a search, in their order."""
    return xr.Dataset(
        {
            "share": (("visit", "parameter"), np.array([visit.share for visit in visits])),
            "band": ("visit", np.array([visit.band for visit in visits])),
            "lower": ("visit", np.array([visit.lower for visit in visits])),
            "upper": ("visit", np.array([visit.upper for visit in visits])),
            "margin": ("visit", np.array([visit.margin for visit in visits])),
        }
    )


def visits_of(dataset: xr.Dataset) -> list[Visited]:
    """The designs again, as values."""
    rows = zip(*(dataset[name].values for name in ("share", "band", "lower", "upper", "margin")), strict=True)
    return [Visited(share, int(band), float(low), float(up), float(m)) for share, band, low, up, m in rows]
