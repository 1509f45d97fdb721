"""Guides of a plate that a scan can resolve, and the mirror beside them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from haptonic.cell import Rows
from haptonic.cell.directed import along_axis
from haptonic.plate.layout.grid import CLOSE, Block, Layout
from haptonic.vibrometry import LatticeRows
from haptonic.vibrometry.maps.waves import Axis
from haptonic.vibrometry.planning import Rectangle

MIRROR = "mirror"  # name of the points in the mirror while its decay is fitted


@dataclass(frozen=True)
class Mirror(LatticeRows):
    """Rows of a lattice beside a region.

    name : name of the lattice
    symmetric : True if its rows are their own images in a mirror along them
    face : mean position of the front of its first row (see `Rows`), m; None if that row misses a pillar
    backed : True if plain plate lies behind it
    """

    name: str
    symmetric: bool
    face: float | None
    backed: bool


@dataclass(frozen=True)
class Guiding:
    """A region as a guide.

    along : axis of its longer side
    width : size across, m
    lattice : name of the lattice on both sides, as mirror images of each other; None if they differ
    cut : lattice whose border cuts a row at the guide, so that no mode of the guide is computed
    """

    region: str
    along: Axis
    width: float
    lattice: str | None
    cut: str | None = None


def guides_of(layout: Layout) -> list[Guiding]:
    """Every region that is a full rectangle. Between lattices, its width is the distance of their faces."""
    guides = []
    for name in layout.regions:
        rows, columns = _span(layout, name)
        if len(layout.of(name)) != len(rows) * len(columns):
            continue
        width = layout.x[columns[-1] + 1] - layout.x[columns[0]]
        height = layout.y[rows[-1] + 1] - layout.y[rows[0]]
        along: Axis = "x" if width > height * (1 + CLOSE) else "y"
        sides = [mirror for mirror in _mirrors(layout, name) if mirror.depth != along and mirror.symmetric]
        faces = [mirror.face for mirror in sides if mirror.face is not None]
        between = sides[0].name if len(sides) == 2 and len({side.name for side in sides}) == 1 else None
        whole = between is not None and len(faces) == 2
        guides.append(
            Guiding(
                region=name,
                along=along,
                width=round(abs(faces[0] - faces[1]), 12) if whole else min(width, height),
                lattice=between if whole else None,
                cut=None if whole else between,
            )
        )
    return guides


def without_mode(layout: Layout) -> list[str]:
    """Guides between lattices without a computed mode, with the reason, as sentences."""
    return [
        f"no mode computed along {guide.region}: its border cuts a row of the lattice {guide.cut}"
        for guide in guides_of(layout)
        if guide.cut is not None
    ]


def mirror_beside(layout: Layout, region: str) -> Mirror | None:
    """The lattice with most rows beside a region; among equal ones, one with plain plate behind it."""
    return max(_mirrors(layout, region), key=lambda mirror: (mirror.rows, mirror.backed), default=None)


def strips_of(layout: Layout, mirror: Mirror) -> list[Mirror]:
    """Rows of a lattice beside a region, and parallel rows of the same lattice elsewhere."""
    alike = {
        strip.area: strip
        for name in layout.regions
        for strip in _mirrors(layout, name)
        if (strip.name, strip.depth) == (mirror.name, mirror.depth)
    }
    return list(alike.values())


def _mirrors(layout: Layout, region: str) -> Iterator[Mirror]:
    """Lattices along the whole of a side of a region's rectangle."""
    rows, columns = _span(layout, region)
    if len(layout.of(region)) != len(rows) * len(columns):
        return
    sides: tuple[tuple[Axis, Literal[1, -1], int, range], ...] = (
        ("x", 1, columns[-1] + 1, rows),
        ("x", -1, columns[0] - 1, rows),
        ("y", 1, rows[-1] + 1, columns),
        ("y", -1, rows[0] - 1, columns),
    )
    yield from filter(None, (_mirror(layout, *side) for side in sides))


def _mirror(layout: Layout, depth: Axis, inwards: Literal[1, -1], first: int, beside: range) -> Mirror | None:
    """The lattice that begins at a line of tiles, beside other tiles, up to its first missing pillar."""
    names = _names(layout, depth, first, beside)
    name = next(iter(names))
    if len(names) > 1 or name is None or name not in layout.cells:
        return None
    number = 1
    while (behind := _names(layout, depth, first + inwards * number, beside)) == names:
        number += 1
    low, high = sorted((first, first + inwards * (number - 1)))
    deep, wide = (low, high + 1), (beside[0], beside[-1] + 1)
    block = _whole(layout, Block(wide, deep) if depth == "x" else Block(deep, wide))
    cell = layout.cells[name]
    along = along_axis(cell.lattice, 1 if depth == "x" else 0)
    if block is None or along is None:
        return None
    sign = inwards if depth == "x" else -inwards
    rows = Rows(cell, (sign * along[0], sign * along[1]))  # with the left face towards the region
    across, up = layout.lines(block)
    lines, pitch = across if depth == "x" else up, rows.area / rows.period
    count = int((lines[-1] - lines[0]) / pitch + CLOSE)
    if not count:
        return None
    area = Rectangle(across[0], up[0], across[-1] - across[0], up[-1] - up[0])
    offset = float(rows.step @ rows.turn[1]) / rows.period
    face = _face(layout, Block(block.rows, deep) if depth == "x" else Block(deep, block.columns), rows, pitch)
    return Mirror(
        area=area,
        depth=depth,
        start=lines[0] if inwards == 1 else lines[-1],
        inwards=inwards,
        pitch=pitch,
        period=rows.period,
        spacing=math.sqrt(rows.area / len(rows.depths)),
        repeat=1 if abs(offset - round(offset)) < CLOSE else 2,
        rows=count,
        name=name,
        symmetric=depth in cell.point_group.mirrors,
        face=None if face is None else inwards * face,
        backed=bool(behind & {*layout.regions}),
    )


def _names(layout: Layout, depth: Axis, line: int, beside: range) -> set[str | None]:
    """Names of the tiles of one column, or row, beside others."""
    return {layout.at((i, line) if depth == "x" else (line, i)) for i in beside}


def _whole(layout: Layout, block: Block) -> Block | None:
    """A block of a lattice without outer lines in which a brick is missing; None if nothing is left.

    If rows are offset, these are half bricks at their ends: the line with most missing bricks goes first.
    """
    while all(block.shape):
        (bottom, top), (left, right) = block.rows, block.columns
        lines = {
            Block((bottom + 1, top), (left, right)): Block((bottom, bottom + 1), (left, right)),
            Block((bottom, top - 1), (left, right)): Block((top - 1, top), (left, right)),
            Block((bottom, top), (left + 1, right)): Block((bottom, top), (left, left + 1)),
            Block((bottom, top), (left, right - 1)): Block((bottom, top), (right - 1, right)),
        }
        missing = {
            rest: sum(map(layout.is_plain, line.tiles)) / len(line.tiles) for rest, line in lines.items()
        }
        worst = max(missing, key=missing.__getitem__)
        if not missing[worst]:
            return block
        block = worst
    return None


def _face(layout: Layout, block: Block, rows: Rows, pitch: float) -> float | None:
    """Mean distance inwards of the front of the first row, m; None if it is not a whole row."""
    bricks = [corner for corner in layout.bricks if block.meets(layout.block(corner))]
    pillars = [(layout.brick_at(at).number, float(layout.axis(at) @ rows.turn[0])) for at in bricks]
    start = min(place for _, place in pillars)
    begin = start - min(depth for _, depth in rows.depths)
    first = {
        (site, round((place - begin) / pitch, 6))
        for site, place in pillars
        if place < start + (1 - CLOSE) * pitch
    }
    return begin if first == {(site, round(depth / pitch, 6)) for site, depth in rows.depths} else None


def _span(layout: Layout, name: str) -> tuple[range, range]:
    """Rows and columns of the rectangle around all tiles of a name."""
    tiles: NDArray[np.int64] = np.array(layout.of(name))
    low, high = tiles.min(axis=0), tiles.max(axis=0)
    return range(int(low[0]), int(high[0]) + 1), range(int(low[1]), int(high[1]) + 1)
