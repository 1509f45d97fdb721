"""Exact dynamic condensation of a cell's mesh: nothing of a reduced model enters.

At an angular frequency omega the trace b feels, with the interior i eliminated,

    D(omega) = K_bb - omega^2 M_bb - K_bi (K_ii - omega^2 M_ii)^-1 K_ib.

It counts eigenvalues without computing them, so that none can be missed. Below omega lie

    J(omega) = J_held(omega) + s(D(omega))

of them (Wittrick and Williams 1971, doi 10.1093/qjmam/24.3.263): those of the interior with its trace held,
plus the negative eigenvalues of D. By Sylvester's law of inertia both are counts of negative pivots. D also
gives modes of the mesh itself, see `haptonic.bloch.exact`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce

import numpy as np

from haptonic.arrays import Array, Fields
from haptonic.solvers import Solver
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.lifting import ClassLifting, lifted
from haptonic.superelement.parts import ClassPart, PartForms, for_each_part


@dataclass(frozen=True)
class DynamicStiffness:
    """What the trace of a cell feels at one angular frequency, and how the inside answers to loads.

    omega : rad/s; below : eigenvalues of the interior with the trace held that lie below it
    matrix : (t, t) dynamic stiffness K - omega^2 M, N/m
    mass : (t, t) minus the derivative of that with respect to omega^2, kg
    parts : how the interior follows the trace at this frequency
    held : (nodes, 3, k) answers to k loads with the trace held; force : (t, k) what they add to its loads
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
    """What a part has of one symmetry class; see `DynamicStiffness`.

    static : (3 interior, b) how the inside follows the boundary
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

    def one(part: ClassPart, solver: Solver) -> dict[int, _Share]:
        forms = PartForms.of(shared, part, ())
        body, shifted = forms.body, forms.interior.copy()
        shifted[part.pattern.indptr[:-1]] -= omega**2 * body.mass
        below = solver.factorise(shifted, definite=False)
        inside = solver.solve(-body.coupling)
        own = body.outer_stiffness - omega**2 * body.outer_mass + body.coupling.T @ inside
        inertia = body.outer_mass + inside.T @ (body.mass[:, None] * inside)
        shares = {}
        for q, boundary in forms.boundary.items():
            fields, unfold = part.inside[q], shared.traces[q].unfold_form
            load = fields.T @ _folded_load(shared, q, loads)
            static = inside if part.is_class else fields @ (inside @ boundary.T)
            shares[q] = _Share(
                below=below,
                matrix=unfold(boundary @ (0.5 * (own + own.T)) @ boundary.T),
                mass=unfold(boundary @ inertia @ boundary.T),
                static=static,
                held=_unfolded(shared, q, fields @ _solved(solver, load)),
                force=shared.traces[q].unfold_rows(boundary @ (inside.T @ load)),
            )
        return shares

    pieces = for_each_part(shared, one)
    every = [share for piece in pieces for share in piece.values()]
    on_rim = np.tensordot(shared.through.T, loads[topology.rim], axes=1)
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
            )
            for q in range(shared.folding.classes)
        ),
        held=np.sum([share.held for share in every], axis=0),
        force=on_rim.reshape(3 * shared.levels * topology.rim.shape[1], loads.shape[2])
        + np.sum([share.force for share in every], axis=0),
    )


def _folded_load(shared: FoldedMesh, q: int, load: Fields) -> Fields:
    """(3 interior, k) share of a load (nodes, 3, k) that works on the fields of one class."""
    folding = shared.folding
    total = np.zeros((len(folding.origin), *load.shape[1:]), dtype=load.dtype)
    np.add.at(total, folding.node, folding.sign[q][:, :, None] * load)
    return total[: folding.interior].reshape(3 * folding.interior, load.shape[2])


def _unfolded(shared: FoldedMesh, q: int, interior: Fields) -> Fields:
    """(nodes, 3, k) field of one class from its interior unknowns, its sides at rest."""
    folding = shared.folding
    values = np.zeros((len(folding.origin), 3, interior.shape[1]), dtype=interior.dtype)
    values[: folding.interior] = interior.reshape(folding.interior, 3, interior.shape[1])
    return np.asarray(folding.sign[q][:, :, None] * values[folding.node])


def _solved(solver: Solver, right: Fields) -> Fields:
    """Solutions for real or complex right-hand sides; some solvers take real ones only."""
    if not right.shape[1]:
        return right
    if not np.iscomplexobj(right):
        return solver.solve(right)
    real, imaginary = np.split(solver.solve(np.hstack([right.real, right.imag])), 2, axis=1)
    return np.asarray(real + 1j * imaginary)
