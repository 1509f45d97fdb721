"""A stack of discs for workshop files: rings of one material each, between two heights."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell.blocks import VOID
from haptonic.cell.outlines import Outline, Scaled
from haptonic.cell.outlines.outline import SAME
from haptonic.cell.stack import Stack
from haptonic.materials import Material
from haptonic.workshop.shape import MM

BEYOND = 1.01  # rim of a stack whose last border is no prism in the plate, in its largest half-widths


@dataclass(frozen=True)
class Border:
    """Side of a ring: an outline with its half-widths at the lower and the upper end."""

    outline: Outline
    low: float
    high: float

    @property
    def squares(self) -> float:
        """Area times the mean square of the half-width, of the frustum within."""
        return self.outline.area * (self.low**2 + self.low * self.high + self.high**2) / 3


@dataclass(frozen=True)
class Ring:
    """Ring between two borders and two heights above the plate's lower face.

    inner : None for a full disc
    """

    inner: Border | None
    outer: Border
    low: float
    high: float

    @property
    def volume(self) -> float:
        area = self.outer.squares - (self.inner.squares if self.inner else 0.0)
        return area * (self.high - self.low)


@dataclass(frozen=True)
class Rings:
    """A whole stack, with its image on the lower face if it has one.

    levels : (storeys + 1,) ends of the storeys above the plate's lower face
    outlines, widths : of each border, and its (borders, storeys + 1) half-widths at the levels. In the plate
        the last one is upright; if that of the stack is not, it is a rim around the stack
    grid : (storeys, borders + 1) index of each ring's material in ``materials``, or `VOID`; the last column
        is the plate around the stack
    """

    levels: Array
    outlines: tuple[Outline, ...]
    widths: Array
    grid: Ints
    materials: tuple[Material, ...]

    @classmethod
    def of(cls, stack: Stack, plate: Material) -> Rings:
        """Rings, in mm, of a stack in m."""
        levels, grid, widths = MM * stack.heights, np.array(stack.grid), MM * stack.widths
        in_plate = widths[-1, : stack.in_plate + 1]
        if stack.mirrored:
            image = MM * stack.thickness - levels[:0:-1]
            levels, grid = np.concatenate([image, levels]), np.concatenate([grid[::-1], grid])
            widths = np.concatenate([widths[:, :0:-1], widths], axis=1)
        outlines = [border.outline for border in stack.borders]
        if np.ptp(in_plate) > SAME * in_plate.max():
            outlines.append(stack.outline)
            widths = np.concatenate([widths, np.full_like(widths[:1], BEYOND * widths[-1].max())])
            grid = np.concatenate([grid, grid[:, -1:]], axis=1)
        materials = (plate, *stack.solids)
        first = np.array([VOID, *map(materials.index, materials)])  # equal materials have one index
        grid = first[1 + np.where(grid == VOID, -1, grid)]
        return cls(levels=levels, outlines=tuple(outlines), widths=widths, grid=grid, materials=materials)

    def rings(self, material: Material) -> list[Ring]:
        """Rings of a material, within the last border."""
        rings = []
        for storey, (low, high) in enumerate(pairwise(self.levels.tolist())):
            ends = self.widths[:, storey : storey + 2].tolist()
            borders = [None, *(Border(o, *pair) for o, pair in zip(self.outlines, ends, strict=True))]
            for number, (inner, outer) in zip(self.grid[storey], pairwise(borders), strict=False):
                if outer is not None and number != VOID and self.materials[number] == material:
                    rings.append(Ring(inner=inner, outer=outer, low=low, high=high))
        return rings

    @property
    def rim(self) -> Scaled:
        """The last border in the plate."""
        floor = int(np.flatnonzero(self.grid[:, -1] != VOID)[0])
        return Scaled(self.outlines[-1], float(self.widths[-1, floor]))

    def edges(self) -> list[tuple[Scaled, bool]]:
        """Outlines at the ends of all sides, each once, and True if the plate or a disc has a hole there."""
        is_side = self.grid[:, :-1] != self.grid[:, 1:]
        is_hole = (self.grid[:, :-1] == VOID) & (self.grid[:, 1:] != VOID)
        is_hole = (is_hole & (self.grid[:, -1:] != VOID)).any(axis=0)
        edges = []
        for border, outline in enumerate(self.outlines):
            storeys = np.flatnonzero(is_side[:, border])
            widths = np.concatenate([self.widths[border, storeys], self.widths[border, storeys + 1]])
            for width in np.unique(widths.round(9)).tolist():
                edges.append((Scaled(outline, width), bool(is_hole[border])))
        return edges

    def solids(self) -> list[list[Material | None]]:
        """Material of each ring, None for an empty one, storey by storey."""
        return [[None if n == VOID else self.materials[n] for n in row] for row in self.grid.tolist()]

    @property
    def narrowest(self) -> float:
        """Twice the narrowest width between two borders that are sides, or of the innermost border."""
        sides = self.widths[(self.grid[:, :-1] != self.grid[:, 1:]).any(axis=0)]
        widths = np.diff(sides, axis=0, prepend=0.0)
        return 2 * float(widths[widths > 0].min())
