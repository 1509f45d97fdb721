"""Exact dynamic condensation of a cell's mesh: nothing of a reduced model enters.

It counts eigenvalues without computing them, so that none can be missed. Wittrick and Williams (1971,
doi 10.1093/qjmam/24.3.263): below a frequency lie as many eigenvalues as the interior with its trace held has
there, plus the negative ones of the dynamic stiffness seen by the trace. By Sylvester's law both counts are
signs of pivots. It also gives modes of the mesh itself, see `haptonic.bloch.exact`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from haptonic.solvers import Solver
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.lifting import DiagonalImage, Fields, Part, lifted
from haptonic.superelement.parallel import for_each_class

Array = NDArray[np.float64]


@dataclass(frozen=True)
class DynamicStiffness:
    """What the trace of a cell feels at one angular frequency.

    omega : rad/s; below : eigenvalues of the interior with the trace held that lie below it
    matrix : (t, t) dynamic stiffness K - omega^2 M, N/m
    mass : (t, t) minus the derivative of that with respect to omega^2, kg
    parts : how the interior follows the trace at this frequency
    """

    omega: float
    below: int
    matrix: Array
    mass: Array
    parts: tuple[Part, ...]

    def lifted(self, trace: Fields) -> Fields:
        """(nodes, 3, k) displacement on the mesh from a trace (t, k), real or complex."""
        return lifted(self.parts, trace, np.zeros((0, trace.shape[1])))


@dataclass(frozen=True)
class _DynamicClass:
    below: int
    matrix: Array
    mass: Array
    part: Part

    def mirrored(self, mirror: DiagonalImage) -> _DynamicClass:
        return _DynamicClass(
            self.below,
            mirror.trace.form(self.matrix),
            mirror.trace.form(self.mass),
            replace(self.part, image=mirror),
        )


def dynamic_stiffness(shared: FoldedMesh, omega: float) -> DynamicStiffness:
    """Condense K - omega^2 M of a folded mesh onto its trace, without any interior modes."""
    diagonal = shared.assembler.diagonal

    def one(q: int, solver: Solver) -> _DynamicClass:
        folded = shared.symmetry_class(q)
        shifted = folded.interior.copy()
        shifted[diagonal] -= omega**2 * folded.mass
        below = solver.factorise(shifted, definite=False)
        inside = solver.solve(-folded.coupling)
        own = folded.trace_stiffness - omega**2 * folded.trace_mass + folded.coupling.T @ inside
        inertia = folded.trace_mass + inside.T @ (folded.mass[:, None] * inside)
        part = Part(folded.trace, shared.through, inside, np.zeros((len(inside), 0)))
        unfold = folded.trace.unfold_form
        return _DynamicClass(below, unfold(0.5 * (own + own.T)), unfold(inertia), part)

    def mirrored(original: _DynamicClass) -> _DynamicClass:
        return original.mirrored(DiagonalImage.of(shared.mesh.topology, shared.levels))

    pieces = for_each_class(shared, one, mirrored)
    return DynamicStiffness(
        omega=omega,
        below=sum(piece.below for piece in pieces),
        matrix=np.sum([piece.matrix for piece in pieces], axis=0),
        mass=np.sum([piece.mass for piece in pieces], axis=0),
        parts=tuple(piece.part for piece in pieces),
    )
