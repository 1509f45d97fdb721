"""Counting eigenvalues without computing them, so that none can be missed.

Wittrick and Williams (1971, doi 10.1093/qjmam/24.3.263): below a frequency lie as many eigenvalues as the
interior with its trace held has there, plus the negative ones of the dynamic stiffness seen by the trace.
By Sylvester's law both counts are signs of pivots; nothing of the reduced model enters.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from haptonic.cell import MeshPlan, UnitCell
from haptonic.lattice import DIAGONAL
from haptonic.solvers import Solver
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.parallel import for_each_class
from haptonic.superelement.trace import TraceMirror

Array = NDArray[np.float64]


@dataclass(frozen=True)
class DynamicStiffness:
    """Stiffness (t, t) that the trace of a cell feels at one angular frequency, N/m.

    omega : rad/s; below : eigenvalues of the interior with the trace held that lie below it
    """

    omega: float
    matrix: Array
    below: int


def dynamic_stiffness(cell: UnitCell, plan: MeshPlan, omega: float) -> DynamicStiffness:
    """Exact dynamic condensation of the mesh's own K - omega^2 M, without any interior modes."""
    shared = FoldedMesh.of(cell, plan)
    diagonal = shared.assembler.diagonal

    def one(q: int, solver: Solver) -> tuple[Array, int]:
        folded = shared.symmetry_class(q)
        shifted = folded.interior.copy()
        shifted[diagonal] -= omega**2 * folded.mass
        below = solver.factorise(shifted, definite=False)
        own = folded.trace_stiffness - omega**2 * folded.trace_mass
        own -= folded.coupling.T @ solver.solve(folded.coupling)
        return folded.trace.unfold_form(0.5 * (own + own.T)), below

    def mirrored(original: tuple[Array, int]) -> tuple[Array, int]:
        matrix, below = original
        return TraceMirror.of(shared.mesh.topology, shared.levels, DIAGONAL).form(matrix), below

    matrices, below_each = zip(*for_each_class(shared, one, mirrored), strict=True)
    return DynamicStiffness(omega, np.sum(matrices, axis=0), sum(below_each))
