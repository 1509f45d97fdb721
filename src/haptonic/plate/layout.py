"""Which tile lies where: a rectangular grid of lines, each field of it a cell of a lattice, plain plate or
nothing.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from haptonic.cell import UnitCell
from haptonic.materials import Material

Array = NDArray[np.float64]


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

    def corner(self, name: str) -> tuple[float, float]:
        """The lower left corner of the smallest rectangle around a region, m."""
        tiles = self.of(name)
        return self.x[min(j for _, j in tiles)], self.y[min(i for i, _ in tiles)]

    @property
    def pillars(self) -> int:
        """How many pillars stand on the plate."""
        standing = {name for name, cell in self.cells.items() if cell.pillar is not None}
        return sum(tile in standing for row in self.tiles for tile in row)
