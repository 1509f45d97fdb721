"""Closed lines around tiles of a plate, and supported parts of its side faces."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from itertools import product

import numpy as np

from haptonic.arrays import Array
from haptonic.plate.layout.grid import STEPS, Layout, Side, Tile
from haptonic.plate.layout.supports import Support

LOOKS: dict[tuple[int, int], Side] = {(1, 0): "bottom", (0, 1): "right", (-1, 0): "top", (0, -1): "left"}
"""Side of a face by the direction of a line along it with the plate to the left."""


def outline(layout: Layout, names: Collection[str]) -> tuple[Array, ...]:
    """Closed lines with all tiles of these names to their left, the longest first.

    Returns
    -------
    the (n, 2) corners of each, m; a place where two tiles touch at a corner only occurs twice
    """
    around = [STEPS["bottom"], STEPS["right"], STEPS["top"], STEPS["left"]]
    after: dict[Tile, list[Tile]] = {}  # where sides of tiles lead from a crossing (row, column) of lines
    for i, j in (tile for name in names for tile in layout.of(name)):
        round_it = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)]
        for k, (down, along) in enumerate(around):
            if layout.at((i + down, j + along)) not in names:
                after.setdefault(round_it[k], []).append(round_it[(k + 1) % 4])
    loops = []
    while after:
        loop, came = [min(after)], (0, 0)
        while not (came != (0, 0) and loop[-1] == loop[0]):
            i, j = loop[-1]
            ends = after[i, j]
            # where two loops cross, a turn to the left leads around the same tile
            ends.sort(key=lambda end: came[1] * (end[0] - i) - came[0] * (end[1] - j))
            end = ends.pop()
            if not ends:
                del after[i, j]
            came = (end[0] - i, end[1] - j)
            loop.append(end)
        loops.append(np.array([(layout.x[j], layout.y[i]) for i, j in _bends(loop[:-1])]))
    return tuple(sorted(loops, key=lambda loop: -float(np.ptp(loop, axis=0).sum())))


def _bends(loop: list[Tile]) -> list[Tile]:
    """Points at which a closed loop of steps changes its direction."""
    before, beyond = loop[-1:] + loop[:-1], loop[1:] + loop[:1]
    places = zip(before, loop, beyond, strict=True)
    return [b for a, b, c in places if (b[0] - a[0], b[1] - a[1]) != (c[0] - b[0], c[1] - b[1])]


def held(layout: Layout, support: Support) -> list[tuple[Side, Array]]:
    """Parts of the plate's outline with a support.

    For a corner of the map they are parts of its two sides, if the plate reaches the corner along that side.

    Returns
    -------
    side of each part, and its (2, 2) ends, m, with the plate to the left
    """
    sides = list(_sides(layout))
    if support.where != "corners":
        return [(side, ends) for side, ends in sides if side == support.where]
    assert support.length is not None
    reached = {(side, place) for side, ends in sides for place in map(tuple, ends.tolist())}
    parts = []
    for (side, ends), last in product(sides, product((0, -1), repeat=2)):
        axis = 0 if side in ("bottom", "top") else 1
        corner = layout.x[last[0]], layout.y[last[1]]
        if corner[1 - axis] != ends[0, 1 - axis] or (side, corner) not in reached:
            continue
        low, high = sorted((corner[axis], corner[axis] + (-support.length if last[axis] else support.length)))
        part = ends.copy()
        part[:, axis] = np.clip(ends[:, axis], low, high)
        if part[0, axis] != part[1, axis]:
            parts.append((side, part))
    return parts


def _sides(layout: Layout) -> Iterator[tuple[Side, Array]]:
    """Straight sides of the whole plate, with their directions."""
    for loop in outline(layout, set(layout.there.values())):
        for ends in np.stack([loop, np.roll(loop, -1, axis=0)], axis=1):
            across, up = np.sign(ends[1] - ends[0]).astype(int).tolist()
            yield LOOKS[across, up], ends
