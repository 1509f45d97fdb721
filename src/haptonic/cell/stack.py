"""Stack of discs about one axis, as a grid of storeys and annuli, each of one material or empty.

The borders of all discs, seen from above, divide a tile into annuli; their ends divide it into storeys. A
hole, an inclusion with a coating, a pillar on glue, or a cap wider than its pillar is a grid of a few parts.

The half-width of a border is a continuous function of height, straight within each storey: discs whose sides
continue each other, such as a shaft and its chamfer, share a border. Beyond its discs a border is upright.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Bools
from haptonic.cell.blocks import VOID, Grid
from haptonic.cell.disc import Disc, Side
from haptonic.cell.outlines import Outline, Scaled
from haptonic.cell.outlines.outline import SAME
from haptonic.cell.pillar import Pillar
from haptonic.materials import Material

LEAST_APART = 1e-3  # smallest distance of different borders, over the widest half-width or the thickness
TURNS = 360  # directions for the comparison of borders


@dataclass(frozen=True)
class Stack:
    """Discs about the axis of a tile, added in order.

    thickness : of the plate, m
    mirrored : True if the tile is its own image in the plate's middle plane; the discs then give the upper
        half
    """

    noun: ClassVar[str] = "disc"
    discs: tuple[Disc, ...]
    thickness: float
    mirrored: bool = False

    @cached_property
    def heights(self) -> Array:
        """(storeys + 1,) ends of the storeys above the plate's lower face, m, ascending."""
        ends = np.sort(self._ends)  # those that differ only by rounding are listed once
        return np.asarray(ends[np.append(True, np.diff(ends) > SAME * self.thickness)])

    @cached_property
    def _ends(self) -> Array:
        """(2 + 2 discs,) heights of the lowest level, of the plate's top and of both ends of each disc, m."""
        floor = 0.5 * self.thickness if self.mirrored else 0.0
        ends = [end for disc in self.discs for end in disc.ends(self.thickness)]
        return np.maximum([floor, self.thickness, *ends], floor)

    @cached_property
    def chains(self) -> tuple[tuple[int, ...], ...]:
        """Numbers of the discs of each border, from the innermost border outwards, and upwards in each."""
        chains: list[list[int]] = []
        for number in sorted(range(len(self.discs)), key=lambda number: self._sides[number][0][1]):
            chain = next((chain for chain in chains if self._continues(chain, number)), None)
            if chain is None:
                chains.append(chain := [])
            chain.append(number)

        def reach(chain: list[int]) -> float:
            return float(self._curve(chain)[0].max()) * self.discs[chain[0]].outline.reach

        return tuple(tuple(chain) for chain in sorted(chains, key=reach))

    @cached_property
    def _sides(self) -> tuple[Side, ...]:
        return tuple(disc.side(self.thickness) for disc in self.discs)

    def _curve(self, chain: Sequence[int]) -> Array:
        """(2, n) half-widths and heights of the ends of discs, upwards."""
        places = [place for number in chain for place in self._sides[number]]
        return np.array(sorted(places, key=lambda place: place[1])).T

    def _continues(self, chain: Sequence[int], number: int) -> bool:
        """True if a disc that begins above the lowest disc of a chain continues its border, or repeats it."""
        if not self.discs[number].outline.is_same(self.discs[chain[0]].outline):
            return False
        curve, side = self._curve(chain), self._curve([number])
        low = side[1, 0]
        high = min(side[1, 1], max(curve[1, -1], low))
        levels = np.clip(np.concatenate([curve[1], side[1]]), low, high)
        apart = np.interp(levels, curve[1], curve[0]) - np.interp(levels, side[1], side[0])
        return bool(np.abs(apart).max() < SAME * max(curve[0].max(), side[0].max()))

    @cached_property
    def widths(self) -> Array:
        """(borders, storeys + 1) half-widths of the borders at the ends of the storeys, m."""
        return self.widths_at(self.heights)

    def widths_at(self, heights: Array | float, like: Stack | None = None) -> Array:
        """(borders, ...) half-widths at heights above the lower face, m; for ``like`` see `layers`."""
        curves = [self._curve(chain) for chain in (like or self).chains]
        return np.array([np.interp(heights, curve[1], curve[0]) for curve in curves])

    @cached_property
    def borders(self) -> tuple[Scaled, ...]:
        """Borders of the annuli where each is widest, from the innermost outwards."""
        return tuple(
            Scaled(self.discs[chain[0]].outline, float(width))
            for chain, width in zip(self.chains, self.widths.max(axis=1), strict=True)
        )

    def border_of(self, number: int) -> int:
        """Number of the border that a disc has, counted from the innermost."""
        return next(border for border, chain in enumerate(self.chains) if number in chain)

    @cached_property
    def in_plate(self) -> int:
        """Number of storeys that form the plate."""
        return int(np.argmin(np.abs(self.heights - self.thickness)))

    @cached_property
    def solids(self) -> tuple[Material, ...]:
        """Materials of discs that have one; their numbers in the grid are 1, 2, ..."""
        return tuple(dict.fromkeys(disc.material for disc in self.discs if disc.material is not None))

    @cached_property
    def grid(self) -> Grid:
        """(storeys, annuli) number of each part's material: 0 for the plate's, `VOID` for empty parts."""
        return self.grid_without(None)

    def grid_without(self, omitted: int | None) -> Grid:
        middles = 0.5 * (self.heights[1:] + self.heights[:-1])
        grid = np.full((len(middles), len(self.borders) + 1), VOID)
        grid[middles < self.thickness] = 0
        for number, disc in enumerate(self.discs):
            if number == omitted:
                continue
            low, high = disc.ends(self.thickness)
            region = VOID if disc.empty else 0
            if disc.material is not None:
                region = 1 + self.solids.index(disc.material)
            grid[(middles > low) & (middles < high), : self.border_of(number) + 1] = region
        return tuple(tuple(int(region) for region in row) for row in grid)

    @cached_property
    def singular(self) -> Bools:
        """(borders, ends of storeys) True where stress is singular.

        That is at re-entrant edges, and where materials meet in a corner or at a surface. It is not at
        convex edges, nor along a straight surface or interface.
        """
        grid = np.array(self.grid)
        below = grid[:1] if self.mirrored else np.full_like(grid[:1], VOID)
        grid = np.concatenate([below, grid, np.full_like(grid[:1], VOID)])
        inner, outer = grid[:, :-1], grid[:, 1:]
        corners = np.stack([inner[:-1], outer[:-1], inner[1:], outer[1:]])  # of each end, (4, ends, borders)
        slope = np.diff(self.widths, axis=1) / np.diff(self.heights)
        lowest = -slope[:, :1] if self.mirrored else slope[:, :1]
        slope = np.concatenate([lowest, slope, slope[:, -1:]], axis=1).T
        slope[np.abs(slope) < SAME] = 0.0
        bend = np.diff(slope, axis=0)  # positive: the border turns outwards
        same = (corners[0] == corners[2]) & (corners[1] == corners[3])
        convex = ((corners[0] == VOID) & (bend > 0)) | ((corners[1] == VOID) & (bend < 0))
        smooth = same & (convex | (np.abs(bend) < SAME))
        level = (corners[0] == corners[1]) & (corners[2] == corners[3])
        solid = corners != VOID
        juts_out = solid.sum(axis=0) == 1
        return np.asarray(~(smooth | level | juts_out).T)

    @cached_property
    def singular_corners(self) -> tuple[tuple[bool, ...], ...]:
        """For each border, True for the joints of its outline at corners along which stress is singular.

        There the solid on one side of the border fills more than half a turn, or two materials meet. Both
        ends of an arc count if it is so small that the sides beside it need thin elements.
        """
        grid = np.array(self.grid)
        corners = []
        for border, inner, outer in zip(self.borders, grid.T[:-1], grid.T[1:], strict=True):
            meet = (inner != outer) & (inner != VOID) & (outer != VOID)
            convex = ((inner == VOID) & (outer != VOID)).any() or meet.any()
            concave = ((inner != VOID) & (outer == VOID)).any() or meet.any()
            bend = border.outline.bends * bool(len(border.outline.beside_corners(1)))
            corners.append(tuple(((bend > SAME) & convex | (bend < -SAME) & concave).tolist()))
        return tuple(corners)

    def layers(self, like: Stack) -> Array:
        """(storeys,) thicknesses of the storeys of a stack with as many discs, for the ends in this one, m.

        They are negative where two ends have another order than in the other stack.
        """
        order = np.argsort(like._ends, kind="stable")
        apart = np.diff(like._ends[order]) > SAME * like.thickness
        return np.asarray(np.diff(self._ends[order])[apart])

    def rings(self, like: Stack) -> Array:
        """(borders - 1, storeys + 1) smallest widths between neighbouring borders, m; see `layers`."""
        angle = 2 * np.pi * np.arange(TURNS) / TURNS
        directions = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        shapes = [radii(self.discs[chain[0]].outline, directions) for chain in like.chains]
        reach = np.array(shapes)[:, None] * self.widths_at(self.heights, like)[..., None]
        return np.asarray(np.diff(reach, axis=0).min(axis=2))

    @cached_property
    def is_its_image(self) -> bool:
        """True if all discs are prisms through the whole plate: the middle plane is then a mirror.

        A material has this mirror if it has the half-turn about the normal, as all materials of a cell have.
        """
        ends = np.array([disc.ends(self.thickness) for disc in self.discs])
        through = np.abs(ends - [0.0, self.thickness]).max() <= SAME * self.thickness
        return bool(through) and not any(disc.draft for disc in self.discs)

    @cached_property
    def upper_half(self) -> Stack:
        """The same discs above the plate's middle plane."""
        return replace(self, mirrored=True)

    @property
    def has_corners(self) -> bool:
        """True if a section has corners, sharp or nearly so."""
        return any(len(border.outline.beside_corners(1)) for border in self.borders)

    @property
    def outline(self) -> Outline:
        """Outline of the widest disc."""
        return self.borders[-1].outline

    @property
    def radius(self) -> float:
        """Smallest half-width of the widest disc at its lower end, m."""
        return self._widest_disc.radius

    @property
    def widest(self) -> float:
        """Largest half-width of the last border, in the direction of the smallest half-width, m."""
        return self.borders[-1].half_width

    @property
    def broadest(self) -> float:
        """The same as `widest`, m."""
        return self.widest

    @property
    def _widest_disc(self) -> Disc:
        return self.discs[max(self.chains[-1], key=lambda number: max(self._sides[number])[0])]

    @property
    def table(self) -> str:
        """Table of the study that gives the widest disc."""
        return f"disc[{1 + self.discs.index(self._widest_disc)}]"

    @property
    def diameter(self) -> float:
        """Diameter of the widest disc, m."""
        return self._widest_disc.diameter

    @property
    def section(self) -> str:
        """Name of the widest disc's section."""
        return self._widest_disc.section

    @property
    def height(self) -> float:
        """Height of the highest part above the plate, m; 0 without such a part."""
        return float(self.heights[-1]) - self.thickness

    @property
    def is_void_at_rim(self) -> bool:
        """True if the widest disc is empty everywhere in the plate: a hole."""
        return all(row[-2] == VOID for row in self.grid[: self.in_plate])

    @property
    def fills_plate(self) -> bool:
        """True if a disc of its own material reaches into the plate: an inclusion."""
        return any(disc.material is not None and disc.is_in_plate for disc in self.discs)

    def keeps_material(self, turn: NDArray[np.float64]) -> bool:
        """True if a map leaves the materials of all discs unchanged."""
        return all(disc.keeps_material(turn) for disc in self.discs)

    def has_symmetry(self, turn: NDArray[np.float64]) -> bool:
        """True if an orthogonal map (3, 3) of space that keeps the normal leaves the stack unchanged."""
        return self.is_image(self, turn)

    def is_image(self, other: object, turn: NDArray[np.float64]) -> bool:
        """True if an orthogonal map (3, 3) that keeps the normal maps the stack to another one."""
        return (
            isinstance(other, Stack)
            and len(self.discs) == len(other.discs)
            and all(disc.is_image(image, turn) for disc, image in zip(self.discs, other.discs, strict=True))
        )

    def turned(self, angle: float) -> Stack:
        """A copy turned anticlockwise about its axis, rad."""
        return replace(self, discs=tuple(disc.turned(angle) for disc in self.discs))

    @property
    def raised(self) -> Scaled | None:
        """Border of the widest part above the plate; None without such a part."""
        above = np.array(self.grid[self.in_plate :]).reshape(-1, len(self.borders) + 1)
        if not (above != VOID).any():
            return None
        ends = self.widths[:, self.in_plate :]
        return max(
            (Scaled(self.borders[border].outline, float(ends[border, storey : storey + 2].max()))
             for storey, row in enumerate(above) for border in np.flatnonzero(row != VOID)[-1:]),
            key=lambda border: border.half_width,
        )  # fmt: skip


Feature = Pillar | Stack


def radii(outline: Outline, way: Array) -> Array:
    """(n,) distance of an outline from its axis in directions (n, 2), in its half-widths.

    The outline encloses the axis; between points of a fine polygon on it the distance is interpolated.
    """
    curve = outline.polygon(4 * TURNS, 8)
    angle = np.unwrap(np.arctan2(curve[:, 1], curve[:, 0]))
    distance = np.linalg.norm(curve, axis=1)
    angles = np.arctan2(way[:, 1], way[:, 0])
    return np.asarray(np.interp(angles, angle, distance, period=2 * np.pi))
