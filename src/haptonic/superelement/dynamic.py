"""Exact dynamic condensation of a cell's mesh, independent of any reduced model.

At an angular frequency omega, elimination of the interior i leaves on the trace b the dynamic stiffness

    D(omega) = K_bb - omega^2 M_bb - K_bi (K_ii - omega^2 M_ii)^-1 K_ib.

It gives the number of eigenvalues below omega without their computation, so none can be missed:

    J(omega) = J_held(omega) + s(D(omega))

(Wittrick and Williams 1971, doi 10.1093/qjmam/24.3.263), the eigenvalues of the interior with its trace
clamped plus the negative eigenvalues of D. By Sylvester's law of inertia, both are numbers of negative
pivots. D also gives modes of the mesh itself, see `haptonic.bloch.exact`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce

import numpy as np

from haptonic.arrays import Array, Fields
from haptonic.cell.mesh import along_rim
from haptonic.solvers import Solver
from haptonic.superelement.class_parts import ClassPart
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.lifting import ClassLifting, lifted
from haptonic.superelement.parts import PartForms, for_each_part


@dataclass(frozen=True)
class DynamicStiffness:
    """Dynamic stiffness of a cell on its trace at one angular frequency, and responses to loads inside.

    omega : rad/s; below : number of eigenvalues of the interior with the trace clamped below omega
    matrix : (t, t) dynamic stiffness K - omega^2 M, N/m
    mass : (t, t) minus the derivative of that with respect to omega^2, kg
    parts : motion of the interior for a given trace at this frequency
    held : (nodes, 3, k) responses to k loads with the trace clamped
    force : (t, k) forces of these loads on the trace
    """

    omega: float
    below: int
    matrix: Array
    mass: Array
    parts: tuple[ClassLifting, ...]
    held: Fields
    force: Fields

    def lifted(self, trace: Fields) -> Fields:
        """(nodes, 3, k) displacement on the mesh from a trace (t, k), real or complex, without loads."""
        return lifted(self.parts, trace, np.zeros((0, trace.shape[1])))


@dataclass(frozen=True)
class _Share:
    """Contribution of a part to one symmetry class; see `DynamicStiffness`.

    static : (3 interior, b) motion of the interior for a motion of the boundary
    """

    below: int
    matrix: Array
    mass: Array
    static: Array
    held: Fields
    force: Fields


def dynamic_stiffness(shared: FoldedMesh, omega: float, loads: Fields | None = None) -> DynamicStiffness:
    """Condense K - omega^2 M of a folded mesh onto its trace, without any interior modes.

    ``loads`` (nodes, 3, k), N, act on the nodes of one cell.
    """
    topology = shared.mesh.topology
    loads = np.zeros((topology.nodes, 3, 0)) if loads is None else loads

    def shares_of_part(part: ClassPart, solver: Solver) -> dict[int, _Share]:
        forms = PartForms.of(shared, part, ())
        body, shifted = forms.body, forms.interior.copy()
        shifted[part.pattern.indptr[:-1]] -= omega**2 * body.mass
        below = solver.factorise(shifted, definite=False)
        inside = body.static(solver)
        stiffness = body.stiffness_with(inside) - omega**2 * body.outer_mass
        inertia = body.mass_with(inside)
        shares = {}
        for q, boundary in forms.boundary.items():
            fields, unfold = part.inside[q], shared.traces[q].unfold_form
            load = fields.T @ _folded_load(shared, q, loads)
            static = inside if part.is_class else fields @ (inside @ boundary.T)
            shares[q] = _Share(
                below=below,
                matrix=unfold(boundary @ (0.5 * (stiffness + stiffness.T)) @ boundary.T),
                mass=unfold(boundary @ inertia @ boundary.T),
                static=static,
                held=_unfolded(shared, q, fields @ _solved(solver, load)),
                force=shared.traces[q].unfold_rows(boundary @ (inside.T @ load)),
            )
        return shares

    pieces = for_each_part(shared, shares_of_part)
    every = [share for piece in pieces for share in piece.values()]
    on_rim = np.tensordot(shared.through.T, loads[topology.rim], axes=1)
    on_trace = np.tensordot(along_rim(topology.plan).T, on_rim, axes=(1, 1)).swapaxes(0, 1)
    return DynamicStiffness(
        omega=omega,
        below=sum(share.below for share in every),
        matrix=np.sum([share.matrix for share in every], axis=0),
        mass=np.sum([share.mass for share in every], axis=0),
        parts=tuple(
            ClassLifting(
                trace=shared.traces[q],
                through=shared.through,
                static=(static := reduce(np.add, [piece[q].static for piece in pieces if q in piece])),
                modes=static[:, :0],
                rows=None,
            )
            for q in range(shared.folding.classes)
        ),
        held=np.sum([share.held for share in every], axis=0),
        force=on_trace.reshape(3 * shared.levels * topology.plan.rim_nodes, loads.shape[2])
        + np.sum([share.force for share in every], axis=0),
    )


def _folded_load(shared: FoldedMesh, q: int, load: Fields) -> Fields:
    """(3 interior, k) share of a load (nodes, 3, k) that does work on the fields of one class."""
    folding = shared.folding
    total = np.zeros((len(folding.origin), *load.shape[1:]), dtype=load.dtype)
    np.add.at(total, folding.node, folding.sign[q][:, :, None] * load)
    return total[: folding.interior].reshape(3 * folding.interior, load.shape[2])


def _unfolded(shared: FoldedMesh, q: int, interior: Fields) -> Fields:
    """(nodes, 3, k) field of one class from its interior unknowns, with its sides at rest."""
    folding = shared.folding
    values = np.zeros((len(folding.origin), 3, interior.shape[1]), dtype=interior.dtype)
    values[: folding.interior] = interior.reshape(folding.interior, 3, interior.shape[1])
    return np.asarray(folding.sign[q][:, :, None] * values[folding.node])


def _solved(solver: Solver, right: Fields) -> Fields:
    """Solve for real or complex right-hand sides with solvers that may accept real ones only."""
    if not right.shape[1]:
        return right
    if not np.iscomplexobj(right):
        return solver.solve(right)
    real, imaginary = np.split(solver.solve(np.hstack([right.real, right.imag])), 2, axis=1)
    return np.asarray(real + 1j * imaginary)
