"""Numbers of the unknowns on the boundary of a slab: those of its faces, and those of the sides between."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.later import sparse as sp
from haptonic.superelement import Tiling, steps_between

BETWEEN = 2  # places on neither of two faces


@dataclass(frozen=True)
class SlabBoundary:
    """Places of a tiling with one period between two faces, at a fixed phase of the period.

    column : (levels, places, 3) number on the boundary of each unknown of the rims: the left face, the right
        face (``size`` each), then the sides between
    turn : (places,) factor of its motion relative to that of its master
    starts : (tiles + 1,) first place of each tile
    size, total : numbers of unknowns of a face and of the boundary
    """

    column: Ints
    turn: Complex
    starts: Ints
    size: int
    total: int

    @classmethod
    def of(cls, tiling: Tiling, phase: float, left: Array, right: Array) -> Self:
        """Number the unknowns for places (n, 2) of the faces, m, in the same order."""
        joint, levels = tiling.joint, tiling.joint.levels
        free, number_of_free = np.unique(joint.master, return_inverse=True)
        kind, slot, shift = np.full(len(free), BETWEEN), np.zeros_like(free), np.zeros_like(free)
        for number, face in enumerate((left, right)):
            whole, same = steps_between(joint.position[free], face, joint.period.vectors)
            assert (same.sum(axis=0) == 1).all(), "a place of a face belongs to no tile or to several"
            place, slots = np.nonzero(same)
            kind[place], slot[place], shift[place] = number, slots, whole[place, slots, 0]
        between = kind == BETWEEN
        assert (np.bincount(number_of_free)[between] > 1).all(), (
            "sides of tiles meet neither another tile nor a face"
        )
        slot[between] = np.arange(between.sum())
        size = 3 * levels * len(left)
        on_level = 3 * np.where(between, between.sum(), len(left))
        first = (size * kind + 3 * slot)[number_of_free][:, None] + np.arange(3)
        return cls(
            column=first + np.arange(levels)[:, None, None] * on_level[number_of_free][:, None],
            turn=np.exp(1j * phase * (joint.shift[:, 0] + shift[number_of_free])),
            starts=np.concatenate([[0], joint.ends]),
            size=size,
            total=2 * size + 3 * levels * int(between.sum()),
        )

    def rim(self, number: int) -> tuple[Ints, sp.csr_array]:
        """Numbers (r,) on the boundary of a tile's rim, and the matrix (t, r) from these to its trace."""
        places = slice(self.starts[number], self.starts[number + 1])
        column = self.column[:, places]
        rows, at = np.unique(column, return_inverse=True)
        factor = np.broadcast_to(self.turn[places, None], column.shape).ravel()
        traces = column.size
        return rows, sp.csr_array((factor, (np.arange(traces), at.ravel())), shape=(traces, len(rows)))
