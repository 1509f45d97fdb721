"""Ribbon: cells side by side in one direction, repeated along another, with free outer edges.

One line of cells is a guide, the edge between two crystals, or a strip of one crystal. Several lines that
differ in one cell are a crystal with a defect; its periodic copies are as far apart as the number of lines.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np

from haptonic.arrays import Array, Bools, Ints
from haptonic.cell.directed import Directed, check_along
from haptonic.cell.geometry import UnitCell
from haptonic.cell.tile import FreeEdge, PlacedTile
from haptonic.errors import GeometryError
from haptonic.translations import SAME

Line = tuple[UnitCell, ...]
RibbonKind = Literal["guide", "defect", "edge", "strip"]


@dataclass(frozen=True, eq=False)
class Ribbon(Directed):
    """One period of a ribbon.

    first : cells of the first line, from left to right, with equal cells as the same object; plain plate is a
        cell without pillars
    along : numbers of the cells' two translations from a line to the next
    more : further lines, in their order along the ribbon

    Raises
    ------
    GeometryError : a translation that is not a shortest one, or cells that do not match
    """

    first: Line
    along: tuple[int, int] = (0, 1)
    more: tuple[Line, ...] = ()

    def __post_init__(self) -> None:
        check_along(self.along, "ribbon", "the ribbon")
        for column, top in enumerate(self.first):
            self._check_meets(self.first[0], top, column + 1, self.along == (0, 1))
            for line in self.more:
                assert len(line) == len(self.first), "lines of different lengths"
                self._check_meets(top, line[column], column + 1, False)

    def _check_meets(self, first: UnitCell, other: UnitCell, number: int, may_differ: bool) -> None:
        """Refuse a cell of a column whose sides do not match those of another cell; rectangles may have
        different widths across the ribbon."""
        close = SAME * first.lattice.pitch
        free = may_differ and all(cell.is_simple and cell.lattice.is_rectangular for cell in (first, other))
        vectors, other_vectors = (
            (cell.lattice.vectors[1:] if free else cell.lattice.vectors) for cell in (first, other)
        )
        alike = np.abs(vectors - other_vectors).max() < close and len(first.outlines) == len(other.outlines)
        if alike and not free:
            alike = all(
                len(outline) == len(beside) and np.abs(outline - beside).max() < close
                for outline, beside in zip(first.outlines, other.outlines, strict=True)
            )
        if not alike or first.thickness != other.thickness or first.material != other.material:
            raise GeometryError.mismatch(
                argument="ribbon.map",
                given=f"column {number}, whose tiles have other edges than those of column 1"
                if not alike
                else f"column {number}, of another thickness or material",
                allowed="columns of one plate whose edges meet: of the same period along the ribbon, and of "
                "the same sites, unless the cells are rectangles",
                cause="a changed number of the cell moves its edges",
                next_step="change sizes of pillars only, or of the pitch across the ribbon",
            )

    @property
    def translations(self) -> Array:
        return self.first[0].lattice.vectors

    @cached_property
    def steps(self) -> Array:
        """(columns, 2) translation across each column, m."""
        return np.array([np.array(self.across) @ cell.lattice.vectors for cell in self.first])

    @cached_property
    def origins(self) -> Array:
        """(columns, 2) centres of the first line's cells, with the first one at the origin, m."""
        ways = 0.5 * (self.steps[1:] + self.steps[:-1])
        return np.concatenate([np.zeros((1, 2)), np.cumsum(ways, axis=0)])

    @property
    def lines(self) -> tuple[Line, ...]:
        """All lines of one period."""
        return (self.first, *self.more)

    @property
    def vectors(self) -> Array:
        """(1, 2) the period, m."""
        return np.asarray(len(self.lines) * self.way[None])

    @cached_property
    def _placed(self) -> tuple[tuple[PlacedTile, int, int], ...]:
        """All tiles with their line and column, column by column from left to right."""
        return tuple(
            (PlacedTile(placed.tile, placed.turn, placed.position + origin + line * self.way), line, column)
            for column, origin in enumerate(self.origins)
            for line, cells in enumerate(self.lines)
            for placed in cells[column].tiles
        )

    @property
    def tiles(self) -> tuple[PlacedTile, ...]:
        return tuple(tile for tile, _, _ in self._placed)

    @cached_property
    def place_of_tile(self) -> Ints:
        """(2, tiles) line and column of each tile."""
        return np.array([(line, column) for _, line, column in self._placed]).T

    @cached_property
    def reach(self) -> int:
        """Number of columns to the farthest tile that touches a tile."""
        normal = self.turn[0]
        corners = np.concatenate([tile.corners for tile in self.first[0].tiles])
        wide = float(np.ptp(corners @ normal))
        return math.floor(wide / float(self.steps[0] @ normal) + SAME)

    @property
    def free_edges(self) -> tuple[FreeEdge, ...]:
        """Free edges to the left of the first columns, and to the right of the last ones."""
        starts = np.searchsorted(self.place_of_tile[1], np.arange(len(self.first) + 1))
        last = len(self.first) - 1
        edges = []
        for number, step in enumerate(self.steps):
            for ways in range(1, self.reach + 1):
                tiles = int(starts[number]), int(starts[number + 1])
                edges += [FreeEdge(*tiles, -ways * step)] * (ways > number)
                edges += [FreeEdge(*tiles, ways * step)] * (ways > last - number)
        return tuple(edges)

    @property
    def cells(self) -> tuple[UnitCell, ...]:
        """Different cells, each once, in the order of lines and columns."""
        return tuple({id(cell): cell for line in self.lines for cell in line}.values())

    @property
    def area(self) -> float:
        """Area of the smallest cell, m^2."""
        return min(cell.area for cell in self.cells)

    @property
    def has_features(self) -> bool:
        return any(cell.has_features for cell in self.cells)

    @cached_property
    def crystals(self) -> tuple[UnitCell, ...]:
        """Different cells with pillars in the first and the last column, or else in all columns."""
        ends = {id(line[end]): line[end] for end in (0, -1) for line in self.lines}
        return tuple(cell for cell in ends.values() if cell.has_features) or tuple(
            cell for cell in self.cells if cell.has_features
        )

    @property
    def has_bulk(self) -> bool:
        """True if each crystal has bulk bands; a strip of different lines has none of one cell."""
        return bool(self.crystals) and not (self.kind == "strip" and len(self.crystals) > 1)

    @cached_property
    def _others(self) -> Bools:
        """(lines, columns) True for plain cells, and for cells that belong to no crystal."""
        crystal_ids = [id(cell) for cell in self.crystals]
        return np.array([[id(cell) not in crystal_ids for cell in line] for line in self.lines])

    @cached_property
    def _borders(self) -> Bools:
        """(lines, columns) True for cells on either side of a border between two cells of a line."""
        number = np.array([[self.cells.index(cell) for cell in line] for line in self.lines])
        meet = number[:, 1:] != number[:, :-1]
        none = np.zeros((len(number), 1), dtype=bool)
        return np.asarray(np.hstack([none, meet]) | np.hstack([meet, none]))

    @cached_property
    def outermost(self) -> Bools:
        """(lines, columns) True for the first and the last column, which have the free edges."""
        ends = np.zeros((len(self.lines), len(self.first)), dtype=bool)
        ends[:, [0, -1]] = True
        return ends

    @cached_property
    def guide(self) -> Bools:
        """(lines, columns) True for cells that may guide waves.

        They are plain cells and those of no crystal; without such cells, those on either side of two
        crystals' border; in a strip without a border, those at its free edges.
        """
        if self._others.any():
            return self._others
        return self._borders if self._borders.any() else self.outermost

    @property
    def kind(self) -> RibbonKind:
        """Kind of the ribbon: "guide", "defect" (it changes along the ribbon), "edge" of two crystals, or
        "strip" that is crystal up to its free edges."""
        if not self._others.any():
            return "edge" if self._borders.any() else "strip"
        return "defect" if (self._others != self._others[0]).any() else "guide"

    def phases(self, along: float, across: Array) -> Array:
        """(lines n, 2) phases (k.a1, k.a2) of a crystal from those along (rad) and across (n,) the ribbon.

        A period of several lines has as many phases from line to line.
        """
        per_line = (along + 2 * np.pi * np.arange(len(self.lines))) / len(self.lines)
        return np.concatenate([Directed.phases(self, float(phase), across) for phase in per_line])
