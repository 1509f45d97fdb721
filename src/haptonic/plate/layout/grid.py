"""Layout of a plate: a rectangular grid whose fields are cells of a lattice, plain plate or empty."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise, product
from types import MappingProxyType
from typing import Literal

import numpy as np

from haptonic.cell import Brickwork, Pillar, UnitCell
from haptonic.cell.brickwork import Brick, Steps, equal_pieces
from haptonic.cell.stack import Feature
from haptonic.cell.tile import TileShape
from haptonic.materials import Material
from haptonic.names import counted, listed

Side = Literal["left", "right", "bottom", "top"]
Tile = tuple[int, int]
Rectangle = tuple[float, float, float, float]

STEPS: Mapping[Side, Tile] = MappingProxyType(
    {"left": (0, -1), "right": (0, 1), "bottom": (-1, 0), "top": (1, 0)}
)
"""(rows, columns) from a tile to its neighbour on that side."""
CLOSE = 1e-9  # of the smallest tile: lengths that differ by less are equal


@dataclass(frozen=True)
class Block:
    """Rectangle of tiles treated as one body: rows and columns, each as (first, last + 1)."""

    rows: tuple[int, int]
    columns: tuple[int, int]

    @property
    def edges(self) -> int:
        """Number of edges of tiles on its rim."""
        return 2 * sum(self.shape)

    def meets(self, other: Block) -> bool:
        """True if the blocks share a tile."""
        pairs = ((self.rows, other.rows), (self.columns, other.columns))
        return all(a[0] < b[1] and b[0] < a[1] for a, b in pairs)

    def joined(self, other: Block) -> Block:
        """Smallest block that contains both."""
        (r0, r1), (c0, c1) = self.rows, self.columns
        (s0, s1), (d0, d1) = other.rows, other.columns
        return Block((min(r0, s0), max(r1, s1)), (min(c0, d0), max(c1, d1)))

    @property
    def tiles(self) -> list[tuple[int, int]]:
        """(row, column) of its tiles."""
        return [(i, j) for i in range(*self.rows) for j in range(*self.columns)]

    @property
    def shape(self) -> tuple[int, int]:
        """Numbers of rows and columns of tiles."""
        return self.rows[1] - self.rows[0], self.columns[1] - self.columns[0]

    def moved(self, up: int, right: int) -> Block:
        """Block of the same shape, moved by a number of blocks."""
        (high, wide), (row, column) = self.shape, (self.rows[0], self.columns[0])
        row, column = row + up * high, column + right * wide
        return Block((row, row + high), (column, column + wide))


@dataclass(frozen=True)
class Laid:
    """Brick of a lattice on the plate.

    shape : rows and columns of tiles that it covers; number : in the `Brickwork` of its lattice
    """

    shape: tuple[int, int]
    number: int = 0


@dataclass(frozen=True)
class Layout:
    """Plate as a map of tiles. Rows count upwards (along y), columns to the right (along x).

    tiles : [row][column] the tile's name: of a lattice in ``cells``, or of a region of plain plate; None
        outside the plate
    x, y : (columns + 1), (rows + 1) positions of the lines between tiles, ascending from 0, m
    cells : unit cells of the lattices by name; all have the plate's thickness and material
    thickness : of the plate without pillars, m; its flat face lies at z = 0
    material : of plate and pillars
    offset : bricks of the lattices by the lower left one of the tiles that each covers; other tiles of a
        lattice are plain plate at its border. If it is None, every tile of a lattice is a brick
    """

    tiles: tuple[tuple[str | None, ...], ...]
    x: tuple[float, ...]
    y: tuple[float, ...]
    cells: Mapping[str, UnitCell]
    thickness: float
    material: Material
    offset: Mapping[Tile, Laid] | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "cells", MappingProxyType(dict(self.cells)))
        assert len(self.tiles) == self.rows
        assert all(len(row) == self.columns for row in self.tiles)
        if self.offset is not None:
            object.__setattr__(self, "offset", MappingProxyType(dict(self.offset)))

    @classmethod
    def laid(
        cls,
        letters: Sequence[Sequence[str | None]],
        widths: Sequence[float],
        heights: Sequence[float],
        cells: Mapping[str, UnitCell],
        thickness: float,
        material: Material,
    ) -> Layout:
        """Make a plate from a coarser map with columns and rows of given sizes, m.

        A letter of a lattice is one rectangle of its `Brickwork`. Each row is offset against the one below,
        or each column against the one on its left, as in the lattice; the first one has no offset. A brick
        that would cover the plate of another letter is replaced by plain plate.

        Raises
        ------
        GeometryError : lattices that cannot be laid, see `Brickwork`
        """
        works = {name: Brickwork.of(cell) for name, cell in cells.items()}
        every = list(zip(*letters, strict=True))
        wide = {
            (name, i): works[name].columns(i)
            for i, row in enumerate(letters)
            for name in works
            if name in row
        }
        high = {
            (name, j): works[name].rows(j)
            for j, column in enumerate(every)
            for name in works
            if name in column
        }
        across, up = (
            [
                {Fraction(0)}.union(*(cuts.get((name or "", k), ()) for k, name in enumerate(line)))
                for line in lines
            ]
            for lines, cuts in ((every, wide), (letters, high))
        )
        # keys of lines are integer numbers of smallest parts, because fractions are slow as keys
        parts = math.lcm(*(share.denominator for own in (*across, *up) for share in own))
        x, columns = _lines(widths, across, parts)
        y, rows = _lines(heights, up, parts)
        bricks = {}
        for name, number in (
            (name, number) for name, work in works.items() for number in range(len(work.bricks))
        ):
            work, brick = works[name], works[name].bricks[number]
            lefts = {i: int(parts * work.left(number, i)) for own, i in wide if own == name}
            bottoms = {j: int(parts * work.bottom(number, j)) for own, j in high if own == name}
            width, height = int(parts * brick.width), int(parts * brick.height)
            for i, j in product(lefts, bottoms):
                if letters[i][j] != name:
                    continue
                over, right = divmod(lefts[i] + width, parts)
                above, top = divmod(bottoms[j] + height, parts)
                beyond = (over and right and letters[i][j + 1 : j + 2] != letters[i][j : j + 1]) or (
                    above and top and every[j][i + 1 : i + 2] != every[j][i : i + 1]
                )
                if not beyond:
                    corner = rows[i][bottoms[j]], columns[j][lefts[i]]
                    end = rows[i + above][top], columns[j + over][right]
                    bricks[corner] = Laid((end[0] - corner[0], end[1] - corner[1]), number)
        tiles = [
            tuple(name for name, own in zip(row, across, strict=True) for _ in own)
            for row, own in zip(letters, up, strict=True)
            for _ in own
        ]
        simple = {len(work.bricks) == 1 and not any(work.offset) for work in works.values()} <= {True}
        layout = cls(
            tiles=tuple(tiles),
            x=x,
            y=y,
            cells=cells,
            thickness=thickness,
            material=material,
            offset=None if simple else bricks,
        )
        for steps in {layout.steps(layout.block(at)) for at, laid in bricks.items() if laid.shape != (1, 1)}:
            equal_pieces(steps)
        return layout

    @cached_property
    def there(self) -> Mapping[Tile, str]:
        """Name of every tile (row, column) of the plate, row by row from the lower left."""
        every = (((i, j), name) for i, row in enumerate(self.tiles) for j, name in enumerate(row))
        return {tile: name for tile, name in every if name is not None}

    @cached_property
    def bricks(self) -> Mapping[Tile, Laid]:
        """Every brick of a lattice by the lower left one of the tiles that it covers, row by row."""
        filled = {name for name, cell in self.cells.items() if cell.has_features}
        if self.offset is not None:
            return dict(sorted(self.offset.items()))
        return {tile: Laid((1, 1)) for tile, name in self.there.items() if name in filled}

    @cached_property
    def _works(self) -> Mapping[str, Brickwork]:
        return {name: Brickwork.of(cell) for name, cell in self.cells.items()}

    def brick(self, name: str, number: int) -> TileShape:
        """Tile about the pillar of a brick, given by lattice and number."""
        return self._works[name].bricks[number].tile

    def brick_at(self, corner: Tile) -> Brick:
        """Brick by the lower left one of the tiles that it covers."""
        return self._works[str(self.at(corner))].bricks[self.bricks[corner].number]

    def axis(self, corner: Tile) -> tuple[float, float]:
        """Position (x, y) of the axis of a brick's pillar, m."""
        left, below = self.brick_at(corner).tile.corners[0]
        return self.x[corner[1]] - float(left), self.y[corner[0]] - float(below)

    def lines(self, block: Block) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Positions of the lines between a block's tiles along x and along y, its ends included, m."""
        (left, right), (low, top) = block.columns, block.rows
        return self.x[left : right + 1], self.y[low : top + 1]

    def steps(self, block: Block) -> Steps:
        """Widths of the columns and heights of the rows of a block, m, without rounding errors."""
        across, up = (
            tuple(self.thickness * round((end - start) / self.thickness, 9) for start, end in pairwise(lines))
            for lines in self.lines(block)
        )
        return across, up

    def block(self, tile: Tile) -> Block:
        """The brick that a tile belongs to, or the tile itself."""
        i, j = corner = self._brick_under.get(tile, tile)
        high, wide = self.bricks[corner].shape if corner in self.bricks else (1, 1)
        return Block((i, i + high), (j, j + wide))

    @cached_property
    def _brick_under(self) -> Mapping[Tile, Tile]:
        return {
            (i + down, j + along): (i, j)
            for (i, j), laid in self.bricks.items()
            for down, along in product(*map(range, laid.shape))
        }

    @cached_property
    def blocks(self) -> tuple[Block, ...]:
        """Every brick, and every tile of plain plate, row by row from the lower left."""
        return tuple(dict.fromkeys(self.block(tile) for tile in self.there))

    def is_plain(self, tile: Tile) -> bool:
        """True for a tile of the plate outside all bricks of lattices."""
        return self.at(tile) is not None and tile not in self._brick_under

    @property
    def left_out(self) -> int:
        """Number of bricks omitted at the borders of lattices, where they would cover other plate."""
        whole = (
            len(work.bricks) * self.area(name) / (work.width * work.height)
            for name, work in self._works.items()
        )
        return round(sum(whole)) - len(self.bricks)

    @property
    def rows(self) -> int:
        return len(self.y) - 1

    @property
    def columns(self) -> int:
        return len(self.x) - 1

    @property
    def regions(self) -> tuple[str, ...]:
        """Names of the regions of plain plate, in the order of their first tile, from the lower left."""
        return tuple(dict.fromkeys(name for name in self.there.values() if name not in self.cells))

    def of(self, name: str) -> list[tuple[int, int]]:
        """(row, column) of every tile of that name."""
        return [tile for tile, own in self.there.items() if own == name]

    def beside(self, names: Sequence[str]) -> list[str]:
        """Names of the lattices with a tile that shares a side with a tile of given regions."""
        sides = [
            (i + down, j + along)
            for name in names
            for i, j in self.of(name)
            for down, along in STEPS.values()
        ]
        near = {self.at(tile) for tile in sides}
        return [name for name in self.cells if name in near]

    def at(self, tile: Tile) -> str | None:
        """Name of a tile (row, column); None outside the plate."""
        i, j = tile
        return self.tiles[i][j] if 0 <= i < self.rows and 0 <= j < self.columns else None

    def edge(self, side: Side) -> list[Tile]:
        """Tiles whose face on that side is a side face of the plate."""
        down, along = STEPS[side]
        return [(i, j) for i, j in self.there if not self.at((i + down, j + along))]

    def bounds(self, tile: Tile) -> Rectangle:
        """(left, bottom, right, top) of a tile, m."""
        i, j = tile
        return self.x[j], self.y[i], self.x[j + 1], self.y[i + 1]

    def area(self, name: str) -> float:
        """Area of all tiles of that name, m^2."""
        boxes = (self.bounds(tile) for tile in self.of(name))
        return sum((right - left) * (top - bottom) for left, bottom, right, top in boxes)

    def under(self, box: Rectangle) -> list[Tile]:
        """Tiles (row, column) below a rectangle (left, bottom, right, top; m), or touched by a point.

        They include tiles outside the plate: -1, or the number of rows or columns, for all beyond the map.
        """
        left, bottom, right, top = box
        columns, rows = _met(self.x, left, right), _met(self.y, bottom, top)
        return [(i, j) for i in rows for j in columns]

    def corner(self, name: str) -> tuple[float, float]:
        """The lower left corner of the smallest rectangle around a region, m."""
        tiles = self.of(name)
        return self.x[min(j for _, j in tiles)], self.y[min(i for i, _ in tiles)]

    @cached_property
    def standing(self) -> tuple[tuple[float, float, Pillar], ...]:
        """Every pillar with the position (x, y) of its axis, m; row by row from the lower left."""
        return tuple((x, y, part) for x, y, part in self.features if isinstance(part, Pillar))

    @cached_property
    def features(self) -> tuple[tuple[float, float, Feature], ...]:
        """Every pillar and every stack of discs with the position (x, y) of its axis, m."""
        tiles = {corner: self.brick_at(corner).tile for corner in self.bricks}
        return tuple((*self.axis(at), tile.feature) for at, tile in tiles.items() if tile.feature is not None)

    @property
    def pillars(self) -> int:
        """Number of pillars on the plate."""
        return len(self.standing)

    @property
    def parts(self) -> str:
        """Numbers of pillars, stacks of discs and cells of a file, as text."""
        stacks, solids = len(self.features) - self.pillars, len(self.bricks) - len(self.features)
        texts = [counted(self.pillars, "pillar")] if self.pillars or not (stacks or solids) else []
        texts += [f"{counted(stacks, 'stack')} of discs"] if stacks else []
        return listed(texts + ([f"{counted(solids, 'cell')} of a file"] if solids else []))


def _lines(
    sizes: Sequence[float], shares: Sequence[set[Fraction]], parts: int
) -> tuple[tuple[float, ...], list[dict[int, int]]]:
    """Lines at shares of intervals that follow each other: positions, each rounded once, and numbers.

    These are by interval and by the share, counted in a number of parts; an interval of no width ends them.
    """
    start = Fraction(0)
    lines: list[float] = []
    numbers: list[dict[int, int]] = []
    for size, own in zip((*sizes, 0.0), (*shares, {Fraction(0)}), strict=True):
        numbers.append({int(parts * share): len(lines) + k for k, share in enumerate(sorted(own))})
        lines += [float(start + share * Fraction(size)) for share in sorted(own)]
        start += Fraction(size)
    return tuple(lines), numbers


def _met(lines: tuple[float, ...], low: float, high: float) -> range:
    """Numbers of the intervals between lines that [low, high] shares more than an end with; of all that
    touch it, if it is a point. -1 lies below the first line."""
    close = CLOSE * float(np.diff(lines).min())
    inward = close if high - low > 2 * close else -close
    first, last = (int(np.searchsorted(lines, end)) - 1 for end in (low + inward, high - inward))
    return range(first, last + 1)


def pieces(there: Sequence[Sequence[bool]]) -> list[set[Tile]]:
    """Tiles [row][column] connected by their sides, as sets of (row, column), the largest first."""
    left = {(i, j) for i, row in enumerate(there) for j, is_there in enumerate(row) if is_there}
    connected = []
    while left:
        piece, front = set(), [min(left)]
        while front:
            i, j = front.pop()
            if (i, j) in left:
                left.remove((i, j))
                piece.add((i, j))
                front += [(i + down, j + along) for down, along in STEPS.values()]
        connected.append(piece)
    return sorted(connected, key=len, reverse=True)
