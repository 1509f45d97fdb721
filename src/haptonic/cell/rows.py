"""Rows of a lattice as a piece of plate between two equal faces, and plain plate up to straight lines.

Sites belong to a row by their position across it. Therefore each side of a tile on a face lies between
neighbours, one of a tile farther left and one of a tile farther right: a face never turns back, and a
trapezoid of plain plate fits between each of its sides and a straight line.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.cell.directed import Directed, check_along
from haptonic.cell.geometry import UnitCell
from haptonic.cell.sites import placed_tiles
from haptonic.cell.tile import MEET, FreeEdge, PlacedTile
from haptonic.translations import SAME

MARGIN = 0.5  # of a face's longest side as seen along the rows: from its farthest point to the straight line


@dataclass(frozen=True, eq=False)
class Rows(Directed):
    """One period of rows side by side, as many as the distance of the farthest rows that touch each other.

    filled : number of rows, from the left, with features; the others are plain plate. 0 means all
    table : table of the study that gives their direction

    Raises
    ------
    GeometryError : a period that is not a shortest one
    """

    cell: UnitCell
    along: tuple[int, int] = (0, 1)
    filled: int = 0
    table: str = "layers"

    def __post_init__(self) -> None:
        check_along(self.along, self.table, "a row")

    @property
    def translations(self) -> Array:
        return self.cell.lattice.vectors

    @cached_property
    def step(self) -> Array:
        """(2,) translation from a row to the next, m."""
        return np.asarray(np.array(self.across) @ self.translations)

    @cached_property
    def _moves(self) -> Array:
        """(sites, 2) translations that move the sites of a cell into one row, m.

        A row begins after the widest gap between sites, seen across it.
        """
        basis = np.array([self.along, self.across], dtype=float)
        across = (self.cell.shares @ np.linalg.inv(basis))[:, 1]
        fractions = (across + SAME) % 1.0 - SAME
        ordered = np.sort(fractions)
        start = ordered[
            np.round(ordered - np.roll(ordered - [*[0.0] * (len(fractions) - 1), 1.0], 1), 9).argmax()
        ]
        moves = np.round(start + (fractions - start + SAME) % 1.0 - SAME - across)
        return np.asarray(moves[:, None] * self.step)

    def _row(self, cell: UnitCell, number: int) -> list[PlacedTile]:
        return [
            PlacedTile(placed.tile, placed.turn, placed.position + move + number * self.step)
            for placed, move in zip(cell.tiles, self._moves, strict=True)
        ]

    def _apart(self, corners: Array) -> tuple[Array, Bools]:
        """(n, n) rows from each corner to each other corner, and True for whole numbers of rows."""
        steps = corners[:, None] - corners
        basis = np.array([self.vectors[0], self.step])
        translations = np.round(steps @ np.linalg.inv(basis))
        apart = np.linalg.norm(steps - translations @ basis, axis=2)
        return translations[..., 1], np.asarray(apart < MEET * self.cell.lattice.pitch)

    @cached_property
    def reach(self) -> int:
        """Number of rows to the farthest tile that touches a tile."""
        rows, same = self._apart(_corners(self._row(self.cell, 0)))
        return int(rows[same].max())

    @cached_property
    def tiles(self) -> tuple[PlacedTile, ...]:
        """Tiles of all rows, from left to right."""
        plain = self.cell.without_pillar() if self.filled else self.cell
        cells = [self.cell if n < self.filled else plain for n in range(self.reach)]
        return tuple(tile for n, cell in enumerate(cells) for tile in self._row(cell, n))

    def is_reversible(self, direction: Array) -> bool:
        """True if the crystal has a mirror or a half turn that reverses a direction (2,) of the plane.

        Then two equal crystals on both sides of a strip reflect its waves equally.
        """
        group = self.cell.point_group
        images = (group.turn(operation)[:2, :2] @ direction for operation in group.operations)
        return any(np.abs(image + direction).max() < SAME for image in images)

    @property
    def lossy(self) -> list[bool]:
        """For each tile, True if it belongs to the lattice."""
        filled, sites = self.filled or self.reach, len(self.cell.tiles)
        return [True] * filled * sites + [False] * (self.reach - filled) * sites

    @cached_property
    def face(self) -> Array:
        """(s, 2) corners of the left face within a period, from one end to the other, m.

        The right face is equal, translated by `reach` steps.
        """
        corners = _corners(self.tiles)
        rows, same = self._apart(corners)
        corners_on_face = corners[(same & (rows == -self.reach)).any(axis=1)]
        along = corners_on_face @ self.turn[1] / self.period
        whole = np.floor(along + MEET)
        corners_on_face, along = corners_on_face - whole[:, None] * self.vectors, along - whole
        order = np.argsort(along)
        corners_on_face, along = corners_on_face[order], along[order]
        return np.asarray(corners_on_face[np.diff(along, prepend=along[0] - 1.0) > MEET])

    @property
    def sides(self) -> Array:
        """(s, 2, 2) sides of the left face, from corner to corner, in axes (across, along), m."""
        ends = np.concatenate([self.face, self.face[:1] + self.vectors]) @ self.turn.T
        return np.stack([ends[:-1], ends[1:]], axis=1)

    @property
    def middle(self) -> float:
        """Mean position of the left face across the rows, m."""
        across, along = self.sides[..., 0], self.sides[..., 1]
        return float((across.mean(axis=1) * np.abs(np.diff(along, axis=1)[:, 0])).sum() / self.period)

    @property
    def depths(self) -> list[tuple[int, float]]:
        """Sites with features, and their mean distance behind the left face in the first row, m.

        Solids of a file count as one site, in the middle of the cell.
        """
        places = [placed.position @ self.turn[0] - self.middle for placed in self._row(self.cell, 0)]
        features = [self.cell.solid] if self.cell.solid else self.cell.features
        return [(k, float(places[k])) for k, feature in enumerate(features) if feature is not None]

    @property
    def is_straight(self) -> bool:
        """True if the faces are planes."""
        return float(np.ptp(self.sides[..., 0])) < MEET * self.cell.lattice.pitch

    @property
    def free_edges(self) -> tuple[FreeEdge, ...]:
        """The two faces."""
        return tuple(FreeEdge(0, len(self.tiles), way * self.reach * self.step) for way in (-1, 1))

    @property
    def area(self) -> float:
        """Area of a cell, m^2."""
        return self.cell.area

    @property
    def has_features(self) -> bool:
        return self.cell.has_features


@dataclass(frozen=True, eq=False)
class Filler:
    """Plain plate between a straight line and the left face of rows: a trapezoid for each of its sides.

    way : -1 on the left of the face, 1 on the right
    """

    rows: Rows
    way: int

    @cached_property
    def line(self) -> float:
        """Position of the straight line across the rows, m."""
        sides = self.rows.sides
        margin = MARGIN * float(np.ptp(sides[..., 1], axis=1).max())
        return float((self.way * sides[..., 0]).max() + margin) * self.way

    @cached_property
    def tiles(self) -> tuple[PlacedTile, ...]:
        """Tiles from one end of the period to the other."""
        cell, outlines = self.rows.cell, []
        for low, high in self.rows.sides:
            corners = [low, high, [self.line, high[1]], [self.line, low[1]]]
            outlines.append(np.array(corners[:: -self.way]) @ self.rows.turn)
        places = [outline.mean(axis=0) for outline in outlines]
        return placed_tiles(
            np.array(places),
            [outline - place for outline, place in zip(outlines, places, strict=True)],
            [None] * len(places),
            (cell.thickness, cell.material, cell.faces),
            None,
        )

    @property
    def vectors(self) -> Array:
        """(1, 2) translation of one period, m."""
        return self.rows.vectors

    @property
    def free_edges(self) -> tuple[FreeEdge, ...]:
        """The line and the face."""
        return (FreeEdge(0, len(self.tiles), None),)

    @property
    def area(self) -> float:
        """Area of a cell, m^2."""
        return self.rows.area

    @property
    def has_features(self) -> bool:
        return False


def _corners(tiles: tuple[PlacedTile, ...] | list[PlacedTile]) -> Array:
    """(n, 2) corners of all tiles, m."""
    return np.concatenate([tile.corners for tile in tiles])
