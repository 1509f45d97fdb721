"""A cell with several pillars: condensed cells side by side, each perhaps another, repeated without end.

Neighbours meet in their traces alone, so each pillar is condensed by itself and the matrices are sparse.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spla
from numpy.typing import NDArray

from haptonic.bloch.pencil import Periodic
from haptonic.superelement import Superelement

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Ints = NDArray[np.int64]

AWAY = 0.1  # of the lowest eigenvalue of a cell with its trace held: how far below zero the shift lies


@dataclass(frozen=True)
class Supercell:
    """Rows of condensed cells of one size, with one trace each.

    stiffness, mass : of all cells, one after the other; sparse, symmetric
    number : for each unknown of the cells the free one of the supercell behind it
    shift : (unknowns, 2) translation, in supercells, from the free unknown to this one
    softest : lowest eigenvalue of a cell with its trace held, (rad/s)^2
    """

    stiffness: sp.csr_array
    mass: sp.csr_array
    number: Ints
    shift: Ints
    softest: float

    @classmethod
    def of(cls, rows: Sequence[Sequence[Superelement]]) -> Supercell:
        """Join cells; ``rows[j][i]`` lies i translations a1 and j translations a2 from the first."""
        columns, count = len(rows[0]), len(rows)
        assert all(len(row) == columns for row in rows), "rows of different lengths"
        cells = [cell for row in rows for cell in row]
        alike = [(cell.cell.lattice, cell.cell.thickness, cell.trace_size) for cell in cells]
        assert all(one == alike[0] for one in alike), "cells whose sides do not meet"
        trace = cells[0].trace_size
        periodics = [Periodic.of(cell).without_modes(cell) for cell in cells]
        numbers, shifts = [], []
        modes = len(periodics[0].free) * len(cells)
        for place, (cell, periodic) in enumerate(zip(cells, periodics, strict=True)):
            # the free unknown behind one of the trace is that of the same cell, or of its neighbour
            at = np.array([place % columns, place // columns]) + periodic.shift
            wrapped = at // [columns, count]
            i, j = (at - wrapped * [columns, count]).T
            own = cell.size - trace
            numbers += [(j * columns + i) * len(periodic.free) + periodic.number, modes + np.arange(own)]
            shifts += [wrapped, np.zeros((own, 2), dtype=np.int64)]
            modes += own
        return cls(
            stiffness=sp.csr_array(sp.block_diag([cell.stiffness for cell in cells])),
            mass=sp.csr_array(sp.block_diag([cell.mass for cell in cells])),
            number=np.concatenate(numbers),
            shift=np.concatenate(shifts),
            softest=min(float(np.diag(cell.stiffness)[trace:].min()) for cell in cells),
        )

    @property
    def size(self) -> int:
        """Free unknowns."""
        return int(self.number.max()) + 1

    def at(self, kappa: Array) -> tuple[sp.csc_array, sp.csc_array]:
        """(n, n) sparse Hermitian stiffness and mass at the phases (2,) across the supercell."""
        turn = np.exp(1j * (self.shift @ kappa))
        every = np.arange(len(self.number))
        spread = sp.csr_array((turn, (every, self.number)), shape=(len(every), self.size))
        back = spread.conj().T
        return sp.csc_array(back @ self.stiffness @ spread), sp.csc_array(back @ self.mass @ spread)

    def eigenpairs(self, kappa: Array, count: int) -> tuple[Array, Complex]:
        """The ``count`` lowest eigenvalues omega^2, (rad/s)^2, and modes (n, count) of unit mass.

        By Lanczos's method with a shift below zero, where there are none.
        """
        K, M = self.at(kappa)
        start = np.random.default_rng(0).standard_normal(self.size)
        values, modes = spla.eigsh(K, count, M, sigma=-AWAY * self.softest, v0=start)
        order = np.argsort(values)
        return values[order], modes[:, order]
