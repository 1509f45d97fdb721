"""How a plate is cut into blocks: one below everything that is attached, else rectangles of like tiles."""

from __future__ import annotations

from collections.abc import Hashable

import numpy as np

from haptonic.errors import GeometryError
from haptonic.plate.layout import Layout
from haptonic.plate.parts import Actuator, Force, Plate
from haptonic.plate.skeleton import Block

ON_LINE = 1e-6  # of a tile's size, by which the edge of a patch may miss the line that it lies on
JOINED = (4, 4)  # rows and columns of like tiles that are joined at most

Attached = Actuator | Force


def blocks_of(plate: Plate) -> dict[Block, tuple[Attached, ...]]:
    """Blocks that cover the plate, with what is attached to each."""
    layout = plate.layout
    special: list[tuple[Block, tuple[Attached, ...]]] = []
    wanted: list[tuple[Block, Attached]] = [(_covering(layout, one), one) for one in plate.actuators]
    for force in plate.forces:
        under = _covering(layout, force)
        singles = [Block((i, i + 1), (j, j + 1)) for i, j in under.tiles if layout.at((i, j)) is not None]
        wanted += [(block, force) for block in ([under] if _is_plain(layout, under) else singles)]
    for block, attached in wanted:
        members: tuple[Attached, ...] = (attached,)
        while meeting := [one for one in special if one[0].meets(block)]:
            for one in meeting:
                special.remove(one)
                block, members = block.joined(one[0]), (*one[1], *members)
        special.append((block, members))
    for block, members in special:
        pressed = len(block.tiles) == 1 and all(isinstance(member, Force) for member in members)
        if not (pressed or _is_plain(layout, block)):
            raise GeometryError.unsupported(
                argument="plate",
                given=" and ".join(f'"{member.name}"' for member in members) + " on one block of tiles",
                allowed="a block of nothing but plain tiles below what shares a tile with something else",
                cause="the smallest rectangle of tiles below them holds a lattice, or leaves the plate",
                next_step="move them apart, so that they share no tile",
            )
    taken = {tile for block, _ in special for tile in block.tiles}
    return {**dict.fromkeys(_rectangles(layout, taken), ()), **dict(special)}


def _extent(attached: Attached) -> tuple[float, float]:
    """Of what is attached, along x and y, m."""
    return (0.0, 0.0) if attached.size is None else (attached.size[0], attached.size[1])


def _covering(layout: Layout, attached: Attached) -> Block:
    """The smallest block of tiles below something."""
    ranges = []
    for lines, centre, size in zip(
        (layout.y, layout.x), attached.centre[::-1], _extent(attached)[::-1], strict=True
    ):
        slack = ON_LINE * float(np.diff(lines).min())
        start = int(np.searchsorted(lines, centre - size / 2 + slack, side="right")) - 1
        end = int(np.searchsorted(lines, centre + size / 2 - slack, side="left"))
        ranges.append((max(start, 0), min(max(end, start + 1), len(lines) - 1)))
    return Block(ranges[0], ranges[1])


def _is_plain(layout: Layout, block: Block) -> bool:
    """Whether a block holds nothing but plain plate."""
    return not {layout.at(tile) for tile in block.tiles} & {None, *layout.cells}


def _rectangles(layout: Layout, taken: set[tuple[int, int]]) -> list[Block]:
    """Rectangles of like tiles that cover what is not taken, from the lower left."""
    left = [
        (i, j) for i in range(layout.rows) for j in range(layout.columns)
        if layout.at((i, j)) is not None and (i, j) not in taken
    ]  # fmt: skip
    open_tiles = dict.fromkeys(left)
    found = []
    while open_tiles:
        i, j = next(iter(open_tiles))
        kind = kind_of(layout, (i, j))

        def fits(tile: tuple[int, int], kind: Hashable = kind) -> bool:
            return tile in open_tiles and kind_of(layout, tile) == kind

        wide = high = 1
        while wide < JOINED[1] and fits((i, j + wide)):
            wide += 1
        while high < JOINED[0] and all(fits((i + high, j + k)) for k in range(wide)):
            high += 1
        found.append(Block((i, i + high), (j, j + wide)))
        for tile in found[-1].tiles:
            del open_tiles[tile]
    return found


def kind_of(layout: Layout, tile: tuple[int, int]) -> Hashable:
    """What tiles that may be joined have in common: name and size, in thicknesses."""
    left, bottom, right, top = layout.bounds(tile)
    sizes = (round((right - left) / layout.thickness, 9), round((top - bottom) / layout.thickness, 9))
    return layout.at(tile), sizes
