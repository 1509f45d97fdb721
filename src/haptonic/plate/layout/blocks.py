"""Division of a plate into blocks: one below each attached part, otherwise rectangles of equal tiles."""

from __future__ import annotations

from collections.abc import Hashable
from itertools import product

import numpy as np

from haptonic.errors import GeometryError
from haptonic.names import listed
from haptonic.plate.layout.grid import Block, Layout, Tile
from haptonic.plate.layout.parts import Actuator, Force, Plate

ON_LINE = 1e-6  # of a tile's size, tolerance of the edge of a patch on a line
JOINED = (4, 4)  # largest numbers of rows and columns of joined tiles

Attached = Actuator | Force


def blocks_of(plate: Plate) -> dict[Block, tuple[Attached, ...]]:
    """Blocks that cover the plate, with the parts attached to each."""
    layout = plate.layout
    special: list[tuple[Block, tuple[Attached, ...]]] = []
    wanted: list[tuple[Block, Attached]] = [(_covering(layout, part), part) for part in plate.actuators]
    for force in plate.forces:
        under = _covering(layout, force)
        singles = dict.fromkeys(layout.block(tile) for tile in under.tiles if layout.at(tile) is not None)
        wanted += [(block, force) for block in ([under] if _is_plain(layout, under) else singles)]
    for block, attached in wanted:
        members: tuple[Attached, ...] = (attached,)
        while meeting := [entry for entry in special if entry[0].meets(block)]:
            for entry in meeting:
                special.remove(entry)
                other, parts = entry
                block, members = block.joined(other), (*parts, *members)
        special.append((block, members))
    for block, members in special:
        pressed = layout.block(block.tiles[0]) == block and all(isinstance(part, Force) for part in members)
        if not (pressed or _is_plain(layout, block)):
            raise GeometryError.unsupported(
                argument="plate",
                given=listed([f'"{member.name}"' for member in members]) + " on one block of tiles",
                allowed="a block of plain tiles only below parts that share a tile",
                cause="the smallest rectangle of tiles below them contains a lattice, or leaves the plate",
                next_step="move them apart, so that they share no tile",
            )
    taken = {tile for block, _ in special for tile in block.tiles}
    return {**dict.fromkeys(_rectangles(layout, taken), ()), **dict(special)}


def _covering(layout: Layout, attached: Attached) -> Block:
    """Smallest block of tiles below an attached part."""
    ranges = []
    (x, y), (width, height, *_) = attached.centre, attached.size or (0.0, 0.0)
    for lines, centre, size in ((layout.y, y, height), (layout.x, x, width)):
        slack = ON_LINE * float(np.diff(lines).min())
        start = int(np.searchsorted(lines, centre - size / 2 + slack, side="right")) - 1
        end = int(np.searchsorted(lines, centre + size / 2 - slack, side="left"))
        ranges.append((max(start, 0), min(max(end, start + 1), len(lines) - 1)))
    return Block(ranges[0], ranges[1])


def _is_plain(layout: Layout, block: Block) -> bool:
    """True if a block contains plain plate only."""
    return all(layout.is_plain(tile) for tile in block.tiles)


def _rectangles(layout: Layout, taken: set[Tile]) -> list[Block]:
    """Rectangles of equal bricks, or tiles, that cover the rest of the plate, from the lower left."""
    left = dict.fromkeys(block for block in layout.blocks if not taken.intersection(block.tiles))
    rectangles = []
    while left:
        first = next(iter(left))
        kind = kind_of(layout, first)

        def fits(row: int, column: int, first: Block = first, kind: Hashable = kind) -> bool:
            other = first.moved(row, column)
            return other in left and kind_of(layout, other) == kind

        columns = rows = 1
        while columns < JOINED[1] and fits(0, columns):
            columns += 1
        while rows < JOINED[0] and all(fits(rows, column) for column in range(columns)):
            rows += 1
        rectangles.append(first.joined(first.moved(rows - 1, columns - 1)))
        for row, column in product(range(rows), range(columns)):
            del left[first.moved(row, column)]
    return rectangles


def kind_of(layout: Layout, block: Block) -> Hashable:
    """Key of bricks or tiles that may be joined: name, brick and sizes."""
    corner = block.tiles[0]
    return layout.at(corner), layout.bricks.get(corner), layout.steps(block)
