"""A stack of discs for workshop files: rings of one material each, between two heights."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell.blocks import VOID
from haptonic.cell.outlines import Scaled
from haptonic.cell.stack import Stack
from haptonic.materials import Material
from haptonic.workshop.shape import MM


@dataclass(frozen=True)
class Ring:
    """Ring between two borders and two heights above the plate's lower face.

    inner : None for a full disc
    """

    inner: Scaled | None
    outer: Scaled
    low: float
    high: float

    @property
    def volume(self) -> float:
        area = _area(self.outer) - (_area(self.inner) if self.inner else 0.0)
        return area * (self.high - self.low)


@dataclass(frozen=True)
class Rings:
    """A whole stack, with its image on the lower face if it has one.

    levels : (storeys + 1,) ends of the storeys above the plate's lower face
    grid : (storeys, borders + 1) index of each ring's material in ``materials``, or `VOID`; the last column
        is the plate around the stack
    """

    levels: Array
    grid: Ints
    borders: tuple[Scaled, ...]
    materials: tuple[Material, ...]

    @classmethod
    def of(cls, stack: Stack, plate: Material) -> Rings:
        """Rings, in mm, of a stack in m."""
        levels, grid = MM * stack.heights, np.array(stack.grid)
        if stack.mirrored:
            image = MM * stack.thickness - levels[:0:-1]
            levels, grid = np.concatenate([image, levels]), np.concatenate([grid[::-1], grid])
        borders = tuple(Scaled(border.outline, MM * border.half_width) for border in stack.borders)
        materials = (plate, *stack.solids)
        first = np.array([VOID, *map(materials.index, materials)])  # equal materials have one index
        grid = first[1 + np.where(grid == VOID, -1, grid)]
        return cls(levels=levels, grid=grid, borders=borders, materials=materials)

    def rings(self, material: Material) -> list[Ring]:
        """Rings of a material, within the widest border."""
        borders = (None, *self.borders)
        return [
            Ring(inner=inner, outer=outer, low=low, high=high)
            for row, (low, high) in zip(self.grid, pairwise(self.levels.tolist()), strict=True)
            for number, (inner, outer) in zip(row, pairwise(borders), strict=False)
            if outer is not None and number != VOID and self.materials[number] == material
        ]

    @property
    def are_holes(self) -> list[bool]:
        """For each border, True if the plate or a disc inside it ends there at a hole."""
        in_plate = self.grid[self.grid[:, -1] != VOID]
        return [bool(hole) for hole in ((in_plate[:, :-1] == VOID) & (in_plate[:, 1:] != VOID)).any(axis=0)]

    def solids(self) -> list[list[Material | None]]:
        """Material of each ring, None for an empty one, storey by storey."""
        return [[None if n == VOID else self.materials[n] for n in row] for row in self.grid.tolist()]

    @property
    def narrowest(self) -> float:
        """Twice the narrowest width between two borders, or of the innermost border."""
        widths = np.diff([0.0, *(border.half_width for border in self.borders)])
        return 2 * float(widths[widths > 0].min())


def _area(border: Scaled) -> float:
    return border.outline.area * border.half_width**2
