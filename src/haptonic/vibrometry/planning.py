"""Order in which a scan visits its points, and points that it leaves out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.errors import ScanError

RIM = 1e-9  # of a size, within which a point lies on the rim


@dataclass(frozen=True)
class Rectangle:
    """A rectangle along the axes with its lowest corner at (x, y), rim included; m."""

    x: float
    y: float
    width: float
    height: float

    def holds(self, points: Array) -> Bools:
        """(point,) True for points, of (point, 2), inside the rectangle."""
        slack = RIM * max(self.width, self.height)
        inside_x = (points[:, 0] >= self.x - slack) & (points[:, 0] <= self.x + self.width + slack)
        inside_y = (points[:, 1] >= self.y - slack) & (points[:, 1] <= self.y + self.height + slack)
        return np.asarray(inside_x & inside_y)


@dataclass(frozen=True)
class RoundRegion:
    """A disc around (x, y), rim included; m."""

    x: float
    y: float
    diameter: float

    def holds(self, points: Array) -> Bools:
        """(point,) True for points, of (point, 2), inside the disc."""
        distance = np.hypot(points[:, 0] - self.x, points[:, 1] - self.y)
        return np.asarray(distance <= 0.5 * self.diameter * (1 + RIM))


class Region(Protocol):
    """A region of the plane."""

    def holds(self, points: Array) -> Bools:
        """(point,) True for points, of (point, 2), inside the region."""


@dataclass(frozen=True, eq=False)
class ScanPlan:
    """Points in the order in which the scan visits them.

    points : (point, 2) m
    left_out : (point, 2) points of the grid in an excluded region
    travel : length of the path, m
    """

    points: Array
    left_out: Array
    travel: float


def scan_plan(area: Rectangle, step: float, excluded: Sequence[Region] = ()) -> ScanPlan:
    """Regular grid centred in an area, in rows along its longer side, with alternating direction.

    Parameters
    ----------
    step : spacing of the grid along both axes, m
    excluded : regions without points, such as clamps, or pillars if their side is scanned

    Raises
    ------
    ScanError : sizes that are not positive, or no point left
    """
    for name, given in (("step", step), ("area.width", area.width), ("area.height", area.height)):
        if not (np.isfinite(given) and given > 0):
            raise _wrong(name, f"{given:g} m", "a positive length", "give it in m, such as 0.002")
    axes = []
    for start, size in ((area.x, area.width), (area.y, area.height)):
        count = int(np.floor(size / step * (1 + RIM))) + 1
        axes.append(start + 0.5 * (size - (count - 1) * step) + step * np.arange(count))
    return visited(np.stack(np.meshgrid(*axes), axis=-1).reshape(-1, 2), excluded)


def visited(points: Array, excluded: Sequence[Region] = ()) -> ScanPlan:
    """Plan a scan of points (n, 2) in rows and columns, along their longer side in alternating direction.

    Raises
    ------
    ScanError : no point left
    """
    out = np.zeros(len(points), dtype=bool)
    for region in excluded:
        out |= region.holds(points)
    points_left = points[~out]
    if not len(points_left):
        raise _wrong(
            "excluded", f"{len(excluded)} regions", "a point outside of them", "leave one of them out"
        )
    sides = np.ptp(points, axis=0)
    along = 0 if sides[0] >= sides[1] else 1
    across = np.sort(points_left[:, 1 - along])
    # a new row begins where the next point lies off by more than rounding
    starts = across[np.diff(across, prepend=-np.inf) > RIM * max(sides.max(), 1.0)]
    number = np.searchsorted(
        starts, points_left[:, 1 - along] + 0.5 * RIM * max(sides.max(), 1.0), side="right"
    )
    path: list[Array] = []
    for row in range(1, len(starts) + 1):
        left = points_left[number == row]
        left = left[np.argsort(left[:, along], kind="stable")]
        # begin at the end that is nearer to the stage; it need not alternate if rows are interrupted
        here = path[-1] if path else left[0]
        turn = np.linalg.norm(left[-1] - here) < np.linalg.norm(left[0] - here)
        path.extend(left[::-1] if turn else left)
    order = np.array(path)
    travel = float(np.linalg.norm(np.diff(order, axis=0), axis=1).sum())
    return ScanPlan(order, points[out], travel)


def _wrong(argument: str, given: str, allowed: str, next_step: str) -> ScanError:
    return ScanError.out_of_range(
        argument=f"scan_plan.{argument}",
        given=given,
        allowed=allowed,
        cause="a size in mm, or regions that cover the whole plate",
        next_step=next_step,
    )
