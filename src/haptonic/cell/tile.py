"""Tile: a convex polygon of plate about a point, with a pillar, a stack of discs, or nothing there.

Every cell consists of tiles, edge to edge; a cell of one site is a single tile.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol, cast

import numpy as np

from haptonic.arrays import Array
from haptonic.cell.outlines import Outline
from haptonic.cell.pillar import Faces, Pillar
from haptonic.cell.solid import Solid
from haptonic.cell.stack import Feature, Stack
from haptonic.materials import Material, is_symmetry
from haptonic.translations import SAME

Sides = tuple[int, int]  # images of a polygon's first two sides by a rotation or mirror

HALF_TURNED = np.diag([-1.0, -1.0, 1.0])  # about the normal
MEET = 1e-6  # of the pitch: closer places of two tiles coincide
# Thickness, in half pitches, below which elements beside a pillar bend like a plate's. At 0.17 to 0.25 the
# error of a tenth band with the six orders around the pillar of thicker plates was 1.4 to 6 %, with two more
# 0.3 to 0.7 %.
THIN = 0.3
SHEET = 0.08  # thickness, in half pitches, below which the plate may be a sheet
SHEET_CLEARANCE = 3.0  # width of the neck, in thicknesses, below which it is not a sheet


def enclosed(loop: Array) -> float:
    """Area that a closed line through corners (n, 2) encloses on its left; negative for a clockwise line."""
    following = np.roll(loop, -1, axis=0)
    return float(0.5 * (loop[:, 0] * following[:, 1] - loop[:, 1] * following[:, 0]).sum())


def inradius(loop: Array) -> float:
    """Distance from the origin to the nearest side of a polygon (sides, 2), anticlockwise about it."""
    along = np.roll(loop, -1, axis=0) - loop
    across = loop[:, 0] * along[:, 1] - loop[:, 1] * along[:, 0]
    return float((across / np.linalg.norm(along, axis=1)).min())


def sides_of(loop: Array) -> tuple[Array, Array]:
    """(sides, 2) outward normals and (sides,) distances of the sides of a polygon about the origin."""
    along = np.roll(loop, -1, axis=0) - loop
    normal = np.stack([along[:, 1], -along[:, 0]], axis=1) / np.linalg.norm(along, axis=1)[:, None]
    return normal, np.einsum("nc,nc->n", normal, loop)


def room_in(loop: Array, outline: Outline, free: float = 0.0) -> float:
    """Largest scale at which an outline fits into a polygon (sides, 2), anticlockwise about the origin.

    ``free`` : width that remains between the outline and each side
    """
    normal, away = sides_of(loop)
    return float(((away - free) / outline.support(normal)).min())


class TileShape:
    """Shape of a piece of plate for a mesh; the pillar's axis is the origin.

    corners : (sides, 2) of the polygon, anticlockwise, m
    extent : period of the surroundings, m, for necks between pillars and for waves
    faces : faces of the plate with pillars
    free_width : half-width of the pillar for a piece of a pillar, m; None for a piece of plate
    """

    thickness: float
    material: Material
    pillar: Pillar | None
    stack: Stack | None = None
    solid: Solid | None = None
    faces: Faces
    free_width: float | None = None

    @property
    def feature(self) -> Feature | None:
        """Feature about the axis: the pillar, or the stack of discs; None without one."""
        return self.pillar or self.stack

    @property
    def corners(self) -> Array:
        raise NotImplementedError

    @property
    def extent(self) -> float:
        raise NotImplementedError

    @property
    def above(self) -> TileShape:
        """The whole tile, as seen from above."""
        return self

    @property
    def pillar_material(self) -> Material:
        """Material of the pillar: its own, or the plate's."""
        if self.pillar is None or self.pillar.material is None:
            return self.material
        return self.pillar.material

    @property
    def solids(self) -> tuple[Material, ...]:
        """Materials by their numbers in the blocks of the mesh: the plate's, then those of the feature."""
        return (self.material, *(self.stack.solids if self.stack else (self.pillar_material,)))

    @property
    def elongation(self) -> float:
        """Square of the extent over the area; a lattice's cell is treated as rectangular."""
        return self.extent**2 / self.area

    @cached_property
    def inradius(self) -> float:
        """Distance from the pillar's axis to the nearest side, m."""
        return inradius(self.corners)

    @cached_property
    def area(self) -> float:
        """Area of the polygon, m^2."""
        return enclosed(self.corners)

    @property
    def is_mirrored(self) -> bool:
        """True for features on both faces, as images of each other in the plate's middle plane."""
        return self.faces == "both"

    @property
    def is_halved(self) -> bool:
        """True if the tile is its own image in this plane, so that only its upper half is meshed.

        Discs through the plate are their own images, such as holes and their coatings.
        """
        return self.is_mirrored or (self.stack is not None and self.stack.is_its_image)

    @property
    def meshed_stack(self) -> Stack | None:
        """Discs of the part that is meshed."""
        return self.stack.upper_half if self.stack is not None and self.is_halved else self.stack

    @property
    def copies(self) -> int:
        """Number of copies of each pillar: 1, or 2 with an image on the other face."""
        return 2 if self.is_mirrored else 1

    @property
    def depth(self) -> float:
        """Depth of its mesh below the plate's top: the thickness, or half of it for a mirrored tile, m."""
        return 0.5 * self.thickness if self.is_mirrored else self.thickness

    @cached_property
    def room(self) -> float:
        """Largest half-width of a feature with this outline that fits into the polygon, m."""
        return self.room_beside(0.0)

    def room_beside(self, free: float) -> float:
        """Largest half-width of a feature with this outline that leaves a width free at each side, m."""
        return room_in(self.corners, self.feature.outline, free) if self.feature else self.inradius - free

    @property
    def clearance(self) -> float:
        """Free width of plate between the feature and the nearest side, m.

        It is less if the feature is wider than its smallest half-width.
        """
        return self.room - (self.feature.widest if self.feature else 0.0)

    @property
    def is_smooth(self) -> bool:
        """True if stress is singular at no edge or interface."""
        if self.stack is not None:
            return not (self.stack.has_corners or self.stack.singular.any() or self.stack.solids)
        return self.pillar is None and self.solid is None

    @property
    def is_thin(self) -> bool:
        """True for a plate so thin for its pitch that many of its waves lie below its pillar's."""
        return self.thickness < THIN * self.inradius

    @property
    def is_sheet(self) -> bool:
        """True for a plate so thin that it bends like a sheet everywhere but at the foot.

        Its waves are as long as those of a thicker plate, so it needs many orders in its plane and few
        through it. A tile with a fillet is not a sheet, because the foot's rings follow the arc.
        """
        wide = SHEET_CLEARANCE * self.thickness < self.clearance
        return self.thickness < SHEET * self.inradius and wide and not (self.pillar and self.pillar.fillet)

    @property
    def is_upright(self) -> bool:
        """True for a rectangle along x and y about its middle."""
        corners = self.corners
        return len(corners) == 4 and bool(
            np.abs(np.abs(corners) - np.abs(corners[0])).max() < SAME * self.extent
        )

    def moved_sides(self, turn: Array) -> Sides | None:
        """Images of the first two sides by an orthogonal map of space (3, 3) that keeps the normal.

        None if it changes the polygon.
        """
        plane = turn[:2, :2].T
        images = self.corners @ plane
        apart = np.linalg.norm(images[:, None] - self.corners, axis=2).min(axis=1)
        if apart.max() > SAME * self.extent:
            return None
        middles = 0.5 * (self.corners + np.roll(self.corners, -1, axis=0))
        moved = np.linalg.norm((middles[:2] @ plane)[:, None] - middles, axis=2).argmin(axis=1)
        return int(moved[0]), int(moved[1])

    def has_symmetry(self, turn: Array) -> bool:
        """True if such a map leaves polygon, feature and material unchanged."""
        return (
            (self.feature is None or self.feature.has_symmetry(turn))
            and is_symmetry(self.material.stiffness, turn)
            and self.moved_sides(turn) is not None
        )


@dataclass(frozen=True)
class SiteTile(TileShape):
    """Polygon nearer to one site of a cell than to any other, in its own axes; see `TileShape`."""

    outline: tuple[tuple[float, float], ...]
    period: float
    thickness: float
    material: Material
    site_feature: Feature | None
    faces: Faces

    @property
    def pillar(self) -> Pillar | None:  # type: ignore[override]
        return self.site_feature if isinstance(self.site_feature, Pillar) else None

    @property
    def stack(self) -> Stack | None:  # type: ignore[override]
        return self.site_feature if isinstance(self.site_feature, Stack) else None

    @cached_property
    def corners(self) -> Array:
        return cast("Array", np.array(self.outline))

    @property
    def extent(self) -> float:
        return self.period


@dataclass(frozen=True, eq=False)
class PlacedTile:
    """A tile at its position in a cell: rotated about the normal, then moved.

    turn : (3, 3) from the tile's axes to the cell's
    position : (2,) of the tile's origin, m
    """

    tile: TileShape
    turn: Array
    position: Array

    @property
    def is_turned(self) -> bool:
        return not np.array_equal(self.turn, np.eye(3))

    @property
    def corners(self) -> Array:
        """(n, 2) corners of the tile at its position, m."""
        return np.asarray(self.tile.corners @ self.turn[:2, :2].T + self.position)

    def points(self, local: Array) -> Array:
        """(n, 3) points of the cell from those of the tile, m."""
        return np.asarray(local @ self.turn.T + np.append(self.position, 0.0))


@dataclass(frozen=True, eq=False)
class FreeEdge:
    """Free edges of a period: sides of tiles first, ..., beyond - 1 that would meet their own images a step
    (2,) away, m; without a step, all sides that meet none."""

    first: int
    beyond: int
    step: Array | None


class Period(Protocol):
    """A repeated unit: a cell in two directions, a ribbon in one.

    tiles : its tiles
    vectors : (d, 2) translations, m
    free_edges : edges without a neighbour
    area : area of plate for the requested number of bands, m^2
    """

    @property
    def tiles(self) -> tuple[PlacedTile, ...]: ...

    @property
    def vectors(self) -> Array: ...

    @property
    def free_edges(self) -> tuple[FreeEdge, ...]: ...

    @property
    def area(self) -> float: ...

    @property
    def has_features(self) -> bool: ...
