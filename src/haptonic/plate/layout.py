"""Which tile lies where: a rectangular grid of lines, each field of it a cell of a lattice, plain plate or
nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import Literal

import numpy as np

from haptonic.cell import Pillar, UnitCell
from haptonic.materials import Material

Side = Literal["left", "right", "bottom", "top"]
Tile = tuple[int, int]
Rectangle = tuple[float, float, float, float]

STEPS: Mapping[Side, Tile] = MappingProxyType(
    {"left": (0, -1), "right": (0, 1), "bottom": (-1, 0), "top": (1, 0)}
)
"""(rows, columns) from a tile to its neighbour on that side."""
CLOSE = 1e-9  # of the smallest tile: lengths that differ by less are equal


@dataclass(frozen=True)
class Layout:
    """A plate as a map of tiles. Rows count upwards (along y), columns to the right (along x).

    tiles : [row][column] the tile's name: of a lattice in ``cells``, or of a region of plain plate; None
        where there is no plate
    x, y : (columns + 1), (rows + 1) positions of the lines between tiles, ascending from 0, m
    cells : unit cells of the lattices by name; all have the plate's thickness and material
    thickness : of the plate without pillars, m; its flat face lies at z = 0
    material : of plate and pillars
    """

    tiles: tuple[tuple[str | None, ...], ...]
    x: tuple[float, ...]
    y: tuple[float, ...]
    cells: Mapping[str, UnitCell]
    thickness: float
    material: Material

    def __post_init__(self) -> None:
        object.__setattr__(self, "cells", MappingProxyType(dict(self.cells)))
        assert len(self.tiles) == self.rows
        assert all(len(row) == self.columns for row in self.tiles)

    @property
    def rows(self) -> int:
        return len(self.y) - 1

    @property
    def columns(self) -> int:
        return len(self.x) - 1

    @property
    def regions(self) -> tuple[str, ...]:
        """Names of the regions of plain plate, in the order of their first tile, from the lower left."""
        named = (name for row in self.tiles for name in row if name is not None and name not in self.cells)
        return tuple(dict.fromkeys(named))

    def of(self, name: str) -> list[tuple[int, int]]:
        """(row, column) of every tile of that name."""
        return [
            (i, j) for i, row in enumerate(self.tiles) for j, tile in enumerate(row) if tile == name
        ]  # fmt: skip

    def at(self, tile: Tile) -> str | None:
        """The name of a tile (row, column); None where there is no plate, as outside the map."""
        i, j = tile
        return self.tiles[i][j] if 0 <= i < self.rows and 0 <= j < self.columns else None

    def edge(self, side: Side) -> list[Tile]:
        """Tiles whose face on that side is a side face of the plate."""
        down, along = STEPS[side]
        every = ((i, j) for i in range(self.rows) for j in range(self.columns))
        return [(i, j) for i, j in every if self.at((i, j)) and not self.at((i + down, j + along))]

    def bounds(self, tile: Tile) -> Rectangle:
        """(left, bottom, right, top) of a tile, m."""
        i, j = tile
        return self.x[j], self.y[i], self.x[j + 1], self.y[i + 1]

    def area(self, name: str) -> float:
        """Of all tiles of that name, m^2."""
        boxes = (self.bounds(tile) for tile in self.of(name))
        return sum((right - left) * (top - bottom) for left, bottom, right, top in boxes)

    def under(self, box: Rectangle) -> list[Tile]:
        """(row, column) of all that a rectangle (left, bottom, right, top; m) lies on, or a point touches;
        also of tiles that are not there: -1 and the number of rows or columns stand for all beyond."""
        left, bottom, right, top = box
        columns, rows = _met(self.x, left, right), _met(self.y, bottom, top)
        return [(i, j) for i in rows for j in columns]

    def corner(self, name: str) -> tuple[float, float]:
        """The lower left corner of the smallest rectangle around a region, m."""
        tiles = self.of(name)
        return self.x[min(j for _, j in tiles)], self.y[min(i for i, _ in tiles)]

    @cached_property
    def standing(self) -> tuple[tuple[float, float, Pillar], ...]:
        """Every pillar of the plate with the place (x, y) of its axis, m; row by row from the lower left."""
        found = []
        for i, row in enumerate(self.tiles):
            for j, name in enumerate(row):
                pillar = self.cells[name].pillar if name and name in self.cells else None
                if pillar is not None:
                    left, bottom, right, top = self.bounds((i, j))
                    found.append((0.5 * (left + right), 0.5 * (bottom + top), pillar))
        return tuple(found)

    @property
    def pillars(self) -> int:
        """How many pillars stand on the plate."""
        return len(self.standing)


def _met(lines: tuple[float, ...], low: float, high: float) -> range:
    """Numbers of the intervals between lines that [low, high] shares more than an end with; of all that
    touch it, if it is a point. -1 lies below the first line."""
    close = CLOSE * float(np.diff(lines).min())
    inward = close if high - low > 2 * close else -close
    first, last = (int(np.searchsorted(lines, end)) - 1 for end in (low + inward, high - inward))
    return range(first, last + 1)


def pieces(there: Sequence[Sequence[bool]]) -> list[set[Tile]]:
    """Tiles [row][column] that hang together by their sides, as sets of (row, column), the largest first."""
    left = {(i, j) for i, row in enumerate(there) for j, is_there in enumerate(row) if is_there}
    found = []
    while left:
        piece, front = set(), [min(left)]
        while front:
            i, j = front.pop()
            if (i, j) in left:
                left.remove((i, j))
                piece.add((i, j))
                front += [(i + down, j + along) for down, along in STEPS.values()]
        found.append(piece)
    return sorted(found, key=len, reverse=True)
