"""A ribbon: cells side by side in one direction, repeated along another; its outermost edges are free."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell.directed import Directed, check_along
from haptonic.cell.geometry import UnitCell
from haptonic.cell.tile import FreeEdge, PlacedTile
from haptonic.errors import GeometryError
from haptonic.lattice import SAME

LEAST_COLUMNS = 2


@dataclass(frozen=True, eq=False)
class Ribbon(Directed):
    """One period of a ribbon, as computed with.

    columns : the cell of each column, equal ones one object; plain plate is a cell without pillars
    along : how many of its cell's two translations the period is; next to each other they may be 0 and 1

    Raises
    ------
    GeometryError : a single column, a period that is no shortest one, or columns that do not fit together
    """

    columns: tuple[UnitCell, ...]
    along: tuple[int, int] = (0, 1)

    def __post_init__(self) -> None:
        if len(self.columns) < LEAST_COLUMNS:
            raise GeometryError.out_of_range(
                argument="ribbon.map",
                given=f"{len(self.columns)} column",
                allowed=f"at least {LEAST_COLUMNS}, side by side",
                cause="a single column has no neighbour that a wave could be guided by",
                next_step="write the letters of all columns, such as ooo1111ooo",
            )
        check_along(self.along, "ribbon", "the ribbon")
        first = self.columns[0]
        for number, one in enumerate(self.columns[1:], start=2):
            self._check_meets(first, one, number)

    def _check_meets(self, first: UnitCell, one: UnitCell, number: int) -> None:
        close = SAME * first.lattice.pitch
        free = self.along == (0, 1) and all(
            cell.is_simple and cell.lattice.is_rectangular for cell in (first, one)
        )
        wanted, found = (
            (cell.lattice.vectors[1:] if free else cell.lattice.vectors) for cell in (first, one)
        )
        alike = np.abs(wanted - found).max() < close and len(first.outlines) == len(one.outlines)
        if alike and not free:
            alike = all(
                len(mine) == len(other) and np.abs(mine - other).max() < close
                for mine, other in zip(first.outlines, one.outlines, strict=True)
            )
        if not alike or first.thickness != one.thickness or first.material != one.material:
            raise GeometryError.mismatch(
                argument="ribbon.map",
                given=f"column {number}, whose tiles have other edges than those of column 1"
                if not alike
                else f"column {number}, of another thickness or material",
                allowed="columns of one plate whose edges meet: of the same period along the ribbon, and of "
                "the same sites, unless the cells are rectangles",
                cause="a number of the cell was changed that moves its edges",
                next_step="change sizes of pillars only, or of the pitch across the ribbon",
            )

    @property
    def translations(self) -> Array:
        return self.columns[0].lattice.vectors

    @cached_property
    def steps(self) -> Array:
        """(columns, 2) translation across each column, m."""
        return np.array([np.array(self.across) @ cell.lattice.vectors for cell in self.columns])

    @cached_property
    def origins(self) -> Array:
        """(columns, 2) of the columns' cells, the first one's at the origin, m."""
        ways = 0.5 * (self.steps[1:] + self.steps[:-1])
        return np.concatenate([np.zeros((1, 2)), np.cumsum(ways, axis=0)])

    @cached_property
    def tiles(self) -> tuple[PlacedTile, ...]:
        """Of all columns, from left to right."""
        return tuple(
            PlacedTile(one.tile, one.turn, one.position + origin)
            for cell, origin in zip(self.columns, self.origins, strict=True)
            for one in cell.tiles
        )

    @cached_property
    def column_of_tile(self) -> Ints:
        """(tiles,) number of the column that each belongs to."""
        return np.repeat(np.arange(len(self.columns)), [len(cell.tiles) for cell in self.columns])

    @cached_property
    def reach(self) -> int:
        """How many columns away the farthest tiles are that touch one."""
        normal = self.turn[0]
        corners = [one.tile.corners @ one.turn[:2, :2].T + one.position for one in self.columns[0].tiles]
        wide = float(np.ptp(np.concatenate(corners) @ normal))
        return math.floor(wide / float(self.steps[0] @ normal) + SAME)

    @property
    def free_edges(self) -> tuple[FreeEdge, ...]:
        """To the left of the first columns, and to the right of the last ones."""
        starts = np.searchsorted(self.column_of_tile, np.arange(len(self.columns) + 1))
        last = len(self.columns) - 1
        found = []
        for number, step in enumerate(self.steps):
            for ways in range(1, self.reach + 1):
                own = int(starts[number]), int(starts[number + 1])
                found += [FreeEdge(*own, -ways * step)] * (ways > number)
                found += [FreeEdge(*own, ways * step)] * (ways > last - number)
        return tuple(found)

    @property
    def area(self) -> float:
        """Of the smallest column, m^2."""
        return min(cell.area for cell in self.columns)

    @property
    def has_pillars(self) -> bool:
        return any(cell.has_pillars for cell in self.columns)

    @property
    def crystals(self) -> tuple[UnitCell, ...]:
        """The cells with pillars, each once, from left to right."""
        return tuple({id(cell): cell for cell in self.columns if cell.has_pillars}.values())

    @property
    def guide(self) -> tuple[int, ...]:
        """Columns that may guide waves: the plain ones, else those beside each other of two crystals."""
        plain = [number for number, cell in enumerate(self.columns) if not cell.has_pillars]
        meet = [n for n in range(1, len(self.columns)) if self.columns[n] is not self.columns[n - 1]]
        return tuple(plain or sorted({number for n in meet for number in (n - 1, n)}))

    @property
    def has_plain_guide(self) -> bool:
        """Whether the guide is plain plate, and not the edge of a crystal."""
        return any(not self.columns[number].has_pillars for number in self.guide)
