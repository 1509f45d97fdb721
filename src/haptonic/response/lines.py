"""Numbers of rows and columns of points on a nearly regular grid."""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.errors import ResponseError

SAME = 2e-4  # of the extent of all points: closer coordinates belong to one row or column
OFF = 0.05  # of the step, largest distance of a row or column from its regular position


def regular_line(coordinate: Array, extent: float, name: str) -> tuple[Ints, Array]:
    """Numbers of the rows (columns) that points belong to, and positions of these.

    Parameters
    ----------
    coordinate : (n,) m
    extent : of all points along x or y, the larger one, m
    name : "x" or "y", for the error

    Returns
    -------
    number : (n,) counted from 0
    place : (rows,) evenly spaced positions, m

    Raises
    ------
    ResponseError : the rows are not evenly spaced
    """
    order = np.argsort(coordinate, kind="stable")
    ascending = coordinate[order]
    begins = np.diff(ascending, prepend=-np.inf) > SAME * extent
    group = np.empty(len(coordinate), dtype=np.int64)
    group[order] = np.cumsum(begins) - 1
    middle = np.bincount(group, coordinate) / np.bincount(group)
    if len(middle) == 1:
        return group, middle
    gaps = np.diff(middle)
    step = float(np.median(gaps[gaps < 1.5 * gaps.min()]))
    number = np.rint((middle - middle[0]) / step).astype(np.int64)
    step, first = np.polynomial.polynomial.polyfit(number, middle, 1)[::-1]
    off = np.abs(first + step * number - middle)
    if off.max() > OFF * step:
        raise ResponseError.unsupported(
            argument=f"{name} of the points",
            given=f"{middle[off.argmax()] * 1e3:.4g} mm, where steps are {step * 1e3:.4g} mm",
            allowed="points in evenly spaced rows and columns along x and y; some of them may be missing",
            cause="the points were chosen by hand, or the grid is turned against the plate",
            next_step="scan or compute a regular grid, or draw the points as they are",
        )
    return number[group], first + step * np.arange(number[-1] + 1)
