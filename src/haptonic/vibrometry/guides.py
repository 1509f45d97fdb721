"""Where on a plate the guides lie that a scan looks along, and the mirror that it looks into."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from haptonic.plate.layout import Layout
from haptonic.vibrometry import LatticeRows
from haptonic.vibrometry.maps.waves import Axis
from haptonic.vibrometry.planning import Rectangle

MIRROR = "mirror"  # name of the points in it while its decay is fitted


@dataclass(frozen=True)
class Mirror:
    """Rows of a lattice beside a region.

    name : of the lattice; depth : axis into it; inwards : -1 towards smaller coordinates
    start : where it begins, m; pitch : of a row, m; rows : how many; area : of all of it
    """

    name: str
    depth: Axis
    inwards: Literal[1, -1]
    start: float
    pitch: float
    rows: int
    area: Rectangle


@dataclass(frozen=True)
class Guiding:
    """A region as a guide. along : its longer side; width : across, m; between : whether lattices lie on both
    of its sides"""

    region: str
    along: Axis
    width: float
    lattice: str | None


def guides_of(layout: Layout) -> list[Guiding]:
    """Every region that is a whole rectangle."""
    found = []
    for name in layout.regions:
        rows, columns = _span(layout, name)
        if len(layout.of(name)) != len(rows) * len(columns):
            continue
        width = layout.x[columns[-1] + 1] - layout.x[columns[0]]
        height = layout.y[rows[-1] + 1] - layout.y[rows[0]]
        along: Axis = "x" if width > height else "y"
        sides = [mirror.name for mirror in _mirrors(layout, name) if mirror.depth != along]
        lattice = sides[0] if len(sides) == 2 and len(set(sides)) == 1 else None
        found.append(Guiding(name, along, min(width, height), lattice))
    return found


def mirror_beside(layout: Layout, region: str) -> Mirror | None:
    """The lattice with most rows beside a region; of equal ones one with plain plate behind it."""
    found = list(_mirrors(layout, region))

    def worth(mirror: Mirror) -> tuple[int, bool]:
        end = mirror.start + mirror.inwards * (mirror.rows + 0.5) * mirror.pitch
        area = mirror.area
        place = [area.x + 0.5 * area.width, area.y + 0.5 * area.height]
        place[0 if mirror.depth == "x" else 1] = end
        behind = layout.under((*place, *place))  # type: ignore[arg-type]
        return mirror.rows, any(layout.at(tile) in layout.regions for tile in behind)

    return max(found, key=worth, default=None)


def strips_of(layout: Layout, region: str) -> list[LatticeRows]:
    """Rows of the lattice beside a region, and those of the same lattice along them elsewhere."""
    first = mirror_beside(layout, region)
    if first is None:
        return []
    alike = {
        one.area: one
        for name in layout.regions
        for one in _mirrors(layout, name)
        if (one.name, one.depth) == (first.name, first.depth)
    }
    return [
        LatticeRows(
            area=one.area,
            depth=one.depth,
            start=one.start,
            inwards=one.inwards,
            pitch=one.pitch,
            period=_period(layout, one),
            rows=one.rows,
        )
        for one in alike.values()
    ]


def _period(layout: Layout, mirror: Mirror) -> float:
    """Of the cells along the rows of a mirror, m."""
    area = mirror.area
    tiles = layout.under((area.x, area.y, area.x + area.width, area.y + area.height))
    length = area.height if mirror.depth == "x" else area.width
    return length / len({row if mirror.depth == "x" else column for row, column in tiles})


def _mirrors(layout: Layout, region: str) -> Iterator[Mirror]:
    """Lattices along the whole of a side of a region's rectangle, every tile of which holds a pillar."""
    in_rows = {name for name in layout.cells if all(layout.block(t).tiles == [t] for t in layout.of(name))}
    rows, columns = _span(layout, region)
    if len(layout.of(region)) != len(rows) * len(columns):
        return
    sides: tuple[tuple[Axis, Literal[1, -1]], ...] = (("x", 1), ("x", -1), ("y", 1), ("y", -1))
    for depth, inwards in sides:
        lines, own = (layout.x, columns) if depth == "x" else (layout.y, rows)
        first = own[-1] + 1 if inwards == 1 else own[0] - 1
        number, name = 0, None
        while True:
            at = first + inwards * number
            names = {
                layout.at((i, at) if depth == "x" else (at, i)) for i in (rows if depth == "x" else columns)
            }
            if len(names) != 1 or not names <= in_rows or (name is not None and names != {name}):
                break
            (name,) = names
            number += 1
        if name is None:
            continue
        start = lines[own[-1] + 1] if inwards == 1 else lines[own[0]]
        end = lines[first + inwards * (number - 1) + (1 if inwards == 1 else 0)]
        low, high = sorted((start, end))
        left, right = layout.x[columns[0]], layout.x[columns[-1] + 1]
        bottom, top = layout.y[rows[0]], layout.y[rows[-1] + 1]
        area = (
            Rectangle(low, bottom, high - low, top - bottom)
            if depth == "x"
            else Rectangle(left, low, right - left, high - low)
        )
        yield Mirror(
            name=name,
            depth=depth,
            inwards=inwards,
            start=start,
            pitch=(high - low) / number,
            rows=number,
            area=area,
        )


def _span(layout: Layout, name: str) -> tuple[range, range]:
    """Rows and columns of the rectangle around all tiles of a name."""
    tiles: NDArray[np.int64] = np.array(layout.of(name))
    low, high = tiles.min(axis=0), tiles.max(axis=0)
    return range(int(low[0]), int(high[0]) + 1), range(int(low[1]), int(high[1]) + 1)
