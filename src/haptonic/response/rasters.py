"""Places of a map, and the point that each of them shows."""

from __future__ import annotations

import numpy as np
import scipy

from haptonic.arrays import Array, Ints
from haptonic.errors import ResponseError
from haptonic.response import checks
from haptonic.response.lines import regular_line

FINER = 5  # places of a map along a step of points that lie on no grid
MOST_PLACES = 800  # along either side of such a map
NEAR = 0.75  # of a step, to which a point is shown: the corner of a square around it


def regular_grid(points: Array) -> tuple[Ints, Array, Array]:
    """Numbers of the places of points on their regular grid, row by row, and its columns and rows, m.

    Raises
    ------
    ResponseError : the points do not lie on a regular grid, or two of them coincide
    """
    extent = float(np.ptp(points, axis=0).max())
    columns, x = regular_line(points[:, 0], extent, "x")
    rows, y = regular_line(points[:, 1], extent, "y")
    place = rows * len(x) + columns
    checks.one_point_each(place, points)
    return place, x, y


def point_map(points: Array) -> tuple[Ints, Array, Array]:
    """(y, x) number of the point that each place shows, -1 for none, and the places, m.

    Points that lie on no regular grid, as when a stage was turned, are drawn finer than they lie: every place
    shows its nearest point, and nothing where that is too far.
    """
    try:
        place, x, y = regular_grid(points)
    except ResponseError:
        return _nearest(points)
    number = np.full(len(y) * len(x), -1, dtype=np.int64)
    number[place] = np.arange(len(points))
    return number.reshape(len(y), len(x)), x, y


def _nearest(points: Array) -> tuple[Ints, Array, Array]:
    tree = scipy.spatial.cKDTree(points)
    step = float(np.median(tree.query(points, k=2)[0][:, 1]))
    low, high = points.min(axis=0) - 0.5 * step, points.max(axis=0) + 0.5 * step
    count = np.maximum(1, np.minimum(np.rint(FINER * (high - low) / step), MOST_PLACES)).astype(int)
    x, y = (a + (b - a) * (np.arange(n) + 0.5) / n for a, b, n in zip(low, high, count, strict=True))
    distance, number = tree.query(np.stack(np.meshgrid(x, y), axis=-1))
    # with too few places for the distance of the points, each point is in one
    within = max(NEAR * step, 0.5 * float(np.hypot(*((high - low) / count))))
    return np.where(distance <= within, number, -1), x, y
