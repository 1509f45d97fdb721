"""Stack of discs about one axis, as a grid of storeys and annuli, each of one material or empty.

The borders of all discs, seen from above, divide a tile into annuli; their ends divide it into storeys. A
hole, an inclusion with a coating, a pillar on glue, or a cap wider than its pillar is a grid of a few parts.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Bools, Ints
from haptonic.cell.blocks import VOID, Grid
from haptonic.cell.disc import Disc
from haptonic.cell.outlines import Outline, Scaled
from haptonic.cell.outlines.outline import SAME
from haptonic.cell.pillar import Pillar
from haptonic.fields import problem
from haptonic.materials import Material
from haptonic.units import format_quantity

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
        return _distinct(self._ends, self.thickness)

    @cached_property
    def _ends(self) -> Array:
        """(2 + 2 discs,) heights of the lowest level, of the plate's top and of both ends of each disc, m."""
        floor = 0.5 * self.thickness if self.mirrored else 0.0
        ends = [end for disc in self.discs for end in disc.ends(self.thickness)]
        return np.maximum([floor, self.thickness, *ends], floor)

    @cached_property
    def borders(self) -> tuple[Scaled, ...]:
        """Borders of the annuli, from the innermost outwards."""
        scale = self._widest_disc.radius
        borders: list[Scaled] = []
        for disc in sorted(self.discs, key=lambda disc: disc.radius * disc.outline.reach):
            if not any(_is_border_of(border, disc, scale) for border in borders):
                borders.append(Scaled(disc.outline, disc.radius))
        return tuple(borders)

    def border_of(self, disc: Disc) -> int:
        """Number of the border that a disc has, counted from the innermost."""
        scale = self._widest_disc.radius
        return next(n for n, border in enumerate(self.borders) if _is_border_of(border, disc, scale))

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
        return self._grid_of(self.discs)

    def _grid_of(self, discs: tuple[Disc, ...]) -> Grid:
        middles = 0.5 * (self.heights[1:] + self.heights[:-1])
        grid = np.full((len(middles), len(self.borders) + 1), VOID)
        grid[middles < self.thickness] = 0
        for disc in discs:
            low, high = disc.ends(self.thickness)
            region = VOID if disc.empty else 0
            if disc.material is not None:
                region = 1 + self.solids.index(disc.material)
            grid[(middles > low) & (middles < high), : self.border_of(disc) + 1] = region
        return tuple(tuple(int(region) for region in row) for row in grid)

    @cached_property
    def singular(self) -> Bools:
        """(borders, ends of storeys) True where stress is singular.

        That is at re-entrant edges, and where materials meet in a corner. It is not at convex edges, nor
        along a straight surface or interface; at the end of an interface on a level surface the singularity
        is weak.
        """
        grid = np.array(self.grid)
        below = grid[:1] if self.mirrored else np.full_like(grid[:1], VOID)
        grid = np.concatenate([below, grid, np.full_like(grid[:1], VOID)])
        inner, outer = grid[:, :-1], grid[:, 1:]
        corners = np.stack([inner[:-1], outer[:-1], inner[1:], outer[1:]])  # of each end, (4, ends, borders)
        upright = (corners[0] == corners[2]) & (corners[1] == corners[3])
        level = (corners[0] == corners[1]) & (corners[2] == corners[3])
        solid = corners != VOID
        juts_out = solid.sum(axis=0) == 1
        ends_at_surface = (solid[0] == solid[1]) & (solid[2] == solid[3]) & (solid[0] != solid[2])
        return np.asarray(~(upright | level | juts_out | ends_at_surface).T)

    def layers(self, like: Stack) -> Array:
        """(storeys,) thicknesses of the storeys of a stack with as many discs, for the ends in this one, m.

        They are negative where two ends have another order than in the other stack.
        """
        order = np.argsort(like._ends, kind="stable")
        apart = np.diff(like._ends[order]) > SAME * like.thickness
        return np.asarray(np.diff(self._ends[order])[apart])

    def rings(self, like: Stack) -> Array:
        """(borders - 1,) smallest widths between neighbouring borders of such a stack, m; see `layers`."""
        angle = 2 * np.pi * np.arange(TURNS) / TURNS
        directions = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
        border = [like.border_of(disc) for disc in like.discs]
        discs = [self.discs[border.index(number)] for number in range(len(like.borders))]
        reach = [disc.radius * radii(disc.outline, directions) for disc in discs]
        return np.asarray(np.diff(reach, axis=0).min(axis=1))

    def check(self, table: str) -> None:
        """Refuse discs that form no body with the plate, or one that changes nothing.

        table : table of the study with the discs, with a dot at its end; errors give a disc by its number
        """
        self._check_ends(table)
        self._check_borders(table)
        for number in range(len(self.discs)):
            if self._grid_of(self.discs[:number] + self.discs[number + 1 :]) == self.grid:
                raise problem(
                    "conflict",
                    "a disc that changes nothing",
                    "discs of a material, empty ones, and those that are above the plate",
                    "it lies within the plate and is of the plate's material, or later discs replace it",
                    "give it a material or empty = true, move it, or leave it out",
                    at=f"{table}disc[{number + 1}]",
                )
        self._check_joined(table)

    def _check_ends(self, table: str) -> None:
        for number, disc in enumerate(self.discs, start=1):
            low, high = disc.ends(self.thickness)
            if low < -SAME * self.thickness:
                raise problem(
                    "out-of-range",
                    format_quantity(low - self.thickness, "m"),
                    f"at least {format_quantity(-self.thickness, 'm')}, the plate's lower face",
                    "the disc reaches out of the plate below",
                    'leave low out for a disc through the plate; faces = "both" gives its image below',
                    at=f"{table}disc[{number}].low",
                )
            if high <= self.heights[0]:
                raise problem(
                    "out-of-range",
                    format_quantity(high - self.thickness, "m"),
                    f"above the plate's middle plane, {format_quantity(-0.5 * self.thickness, 'm')}",
                    "discs on both faces are given by those of the upper half",
                    'give its image in the upper half, or write faces = "one"',
                    at=f"{table}disc[{number}].high",
                )
        thinnest = float(np.diff(self.heights).min())
        if thinnest < LEAST_APART * self.thickness:
            raise problem(
                "out-of-range",
                f"ends that are {format_quantity(thinnest, 'm', digits=3)} apart",
                f"equal ends, or ends at least {format_quantity(LEAST_APART * self.thickness, 'm')} apart",
                "a layer as thin as that has no mesh",
                "make the two ends equal, or the layer thicker",
                at=f"{table}disc",
            )

    def _check_borders(self, table: str) -> None:
        """Refuse borders that cross or touch, or are nearly the same."""
        least, widths = LEAST_APART * self.borders[-1].half_width, self.rings(self)
        if widths.min(initial=np.inf) < least:
            inner, outer = self.borders[widths.argmin() : widths.argmin() + 2]
            raise problem(
                "out-of-range",
                f"sections of {format_quantity(2 * inner.half_width, 'm')} and "
                f"{format_quantity(2 * outer.half_width, 'm')} whose outlines cross or nearly touch",
                f"equal sections, or one at least {format_quantity(least, 'm', digits=3)} inside another",
                "discs of a stack lie inside each other, seen from above",
                "make the inner one smaller, or the two equal",
                at=f"{table}disc",
            )

    def _check_joined(self, table: str) -> None:
        """Refuse parts without contact to the rest, or with contact along an edge only."""
        solid = np.array(self.grid) != VOID
        joined = np.zeros_like(solid)
        joined[: self.in_plate, -1] = True
        while True:
            more = joined.copy()
            more[1:] |= joined[:-1]
            more[:-1] |= joined[1:]
            more[:, 1:] |= joined[:, :-1]
            more[:, :-1] |= joined[:, 1:]
            more &= solid
            if (more == joined).all():
                break
            joined = more
        grid = np.pad(solid, ((1, 1), (0, 0)))
        inner, outer = grid[:, :-1], grid[:, 1:]
        rising, falling = inner[:-1] & outer[1:], outer[:-1] & inner[1:]
        neither = ~(outer[:-1] | inner[1:]), ~(inner[:-1] | outer[1:])
        edges = (rising & neither[0]) | (falling & neither[1])
        if (joined != solid).any() or edges.any():
            raise problem(
                "conflict",
                "a part that touches the plate along an edge only"
                if edges.any()
                else "a part that the plate does not carry",
                "discs that make one body with the plate",
                "between the part and the plate there is nothing",
                "let the ends of the discs meet, or leave the part out",
                at=f"{table}disc",
            )

    @property
    def has_corners(self) -> bool:
        """True if a section has corners, along which stress is singular and no mesh is graded."""
        return any(len(border.outline.corners) for border in self.borders)

    @property
    def outline(self) -> Outline:
        """Outline of the widest disc."""
        return self.borders[-1].outline

    @property
    def radius(self) -> float:
        """Smallest half-width of the widest disc, m."""
        return self.borders[-1].half_width

    @property
    def widest(self) -> float:
        """Smallest half-width of the widest disc, m; the same as `radius`."""
        return self.radius

    @property
    def broadest(self) -> float:
        """Smallest half-width of the widest disc, m; the same as `radius`."""
        return self.radius

    @property
    def _widest_disc(self) -> Disc:
        return max(self.discs, key=lambda disc: disc.radius)

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
        annuli = np.flatnonzero((above != VOID).any(axis=0))
        return self.borders[annuli[-1]] if len(annuli) else None


Feature = Pillar | Stack


def _is_border_of(border: Scaled, disc: Disc, scale: float) -> bool:
    """True if a border is that of a disc up to rounding; ``scale`` is a length of the stack, m."""
    return border.outline.is_same(disc.outline) and abs(border.half_width - disc.radius) < SAME * scale


def radii(outline: Outline, way: Array) -> Array:
    """(n,) distance of an outline from its axis in directions (n, 2), in its half-widths.

    The outline encloses the axis; between points of a fine polygon on it the distance is interpolated.
    """
    curve = outline.polygon(4 * TURNS, 8)
    angle = np.unwrap(np.arctan2(curve[:, 1], curve[:, 0]))
    distance = np.linalg.norm(curve, axis=1)
    angles = np.arctan2(way[:, 1], way[:, 0])
    return np.asarray(np.interp(angles, angle, distance, period=2 * np.pi))


def _distinct(values: Array, scale: float) -> Array:
    """Values in ascending order; those that differ only by rounding are listed once."""
    ordered: Ints | Array = np.sort(values)
    return np.asarray(ordered[np.append(True, np.diff(ordered) > SAME * scale)])
