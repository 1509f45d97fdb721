"""Blocks of a mesh: a grid of layers and rings, each block of a material or empty.

Rings lead from a core about the axis to the sides of the tile. From below, layer by layer, every block of the
core and of the rings has the number of its material, or is `VOID`. A pillar on the plate, a hole through it
and a coating around the hole are such grids, and the numbers of nodes follow from them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from haptonic.arrays import Bools, Ints

VOID = -1
Grid = tuple[tuple[int, ...], ...]  # (layers, 1 + rings) number of each block's material, the core first


@dataclass(frozen=True)
class Division:
    """Elements of an interval: thin ones at its lower and at its upper end, and others between."""

    low: int
    between: int
    high: int

    def orders(self, usual: int, thin: int) -> tuple[int, ...]:
        """Polynomial order of each element, from the lower end."""
        return (*(thin,) * self.low, *(usual,) * self.between, *(thin,) * self.high)

    @property
    def count(self) -> int:
        return self.low + self.between + self.high


@dataclass(frozen=True)
class StackBlocks:
    """Blocks of a tile with a stack of discs, without any lengths.

    grid : (storeys, annuli) of the stack itself, see `haptonic.cell.stack`
    in_plate : number of its lowest storeys, which form the plate
    storeys, annuli : division of each; the first annulus is around the core, the last reaches the sides
    around : thin blocks on either side of every corner of an outline with singular stress
    """

    grid: Grid
    in_plate: int
    storeys: tuple[Division, ...]
    annuli: tuple[Division, ...]
    around: int = 0

    @property
    def thin(self) -> int:
        """Thin elements on either side of a singular edge."""
        return max(max(part.low, part.high) for part in (*self.storeys, *self.annuli))

    def divided(self) -> Grid:
        """The grid with every storey and every annulus divided into elements, and the core."""
        rows = [
            (row[0], *(region for region, annulus in zip(row, self.annuli, strict=True)
                       for _ in range(annulus.count)))
            for row in self.grid
        ]  # fmt: skip
        return tuple(row for row, storey in zip(rows, self.storeys, strict=True) for _ in range(storey.count))


@lru_cache(maxsize=256)
def curves_of_levels(grid: Grid, rings: tuple[int, ...], layers: tuple[int, ...]) -> Bools:
    """(levels, 2 + steps across all rings) True where a level has nodes: in the core, then on each curve.

    rings, layers : order across each ring and through each layer
    """
    start = np.concatenate([[0], np.cumsum(rings)])
    of_block = np.zeros((1 + len(rings), 2 + start[-1]), dtype=bool)
    of_block[0, :2] = True
    for ring, order in enumerate(rings):
        of_block[1 + ring, 1 + start[ring] : 2 + start[ring] + order] = True
    present = (np.array(grid) != VOID).astype(int) @ of_block.astype(int) > 0
    levels = np.zeros((sum(layers) + 1, of_block.shape[1]), dtype=bool)
    low = 0
    for order, row in zip(layers, present, strict=True):
        levels[low : low + order + 1] |= row
        low += order
    return levels


def level_positions(curves: Bools, core: int, around: int) -> Ints:
    """Indices of a level's nodes among all possible ones: of the core, then of each curve."""
    return np.flatnonzero(np.repeat(curves, [core, *[around] * (len(curves) - 1)]))
