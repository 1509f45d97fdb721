"""Modes of a cell's mesh at one wavevector, independent of the reduced model."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array, Complex
from haptonic.bloch.pencil import Periodic
from haptonic.later import linalg as la
from haptonic.superelement import TiledMesh

TOGETHER = 1e-6  # relative distance of eigenvalues below which modes count as degenerate
ASIDE = 2e-4  # relative distance of the shift from the eigenvalue; nearer, the interior may resonate
BLOCK = 4  # number of modes iterated together
SETTLED = 1e-12  # relative change of the eigenvalue at which the iteration stops
MOST_STEPS = 12  # of the iteration


@dataclass(frozen=True)
class ExactModes:
    """Modes of one eigenvalue.

    kappa : (2,) phases, rad; omega : rad/s
    fields : (nodes, 3, k) displacement on the mesh, orthogonal and of unit mass
    trace : (t, k) unknowns of its lateral faces
    """

    kappa: Array
    omega: float
    fields: Complex
    trace: Complex


def exact_modes(shared: TiledMesh, kappa: Array, omega: float) -> ExactModes:
    """Compute the mode of the mesh with the frequency nearest to ``omega``, and all degenerate with it.

    Inverse iteration on whole fields: ``(K - s M) y = M x`` with a shift s a little below the eigenvalue,
    starting from traces for which the dynamic stiffness at s is nearly zero. A shift at the eigenvalue itself
    would need one step, but it fails for modes with little motion of the trace, as the interior resonates.

    Parameters
    ----------
    shared : the folded meshes of the tiles
    omega : rad/s, of the reduced model

    Raises
    ------
    ArithmeticError : the iteration does not converge
    """
    periodic = Periodic.of_joint(shared.joint)
    turn = np.exp(1j * (periodic.shift @ kappa))[:, None]
    mass = shared.nodal_mass[:, None, None]
    shift = (1 - ASIDE) * omega**2
    at_shift = shared.dynamic(float(np.sqrt(shift)))
    stiffness = periodic.hermitian(at_shift.matrix, kappa)
    factor = la.lu_factor(stiffness)  # nearly singular, as required for inverse iteration
    offsets, vectors = la.eigh(stiffness, periodic.hermitian(at_shift.mass, kappa))
    start = np.argsort(np.abs(offsets - ASIDE * omega**2))[:BLOCK]
    trace = vectors[:, start][periodic.number] * turn
    fields, value = at_shift.lifted(trace), 0.0
    for _ in range(MOST_STEPS):
        answer = shared.dynamic(float(np.sqrt(shift)), mass * fields)
        load = np.zeros((len(periodic.free), fields.shape[2]), dtype=complex)
        np.add.at(load, periodic.number, answer.force * turn.conj())
        trace = la.lu_solve(factor, load)[periodic.number] * turn
        new = answer.lifted(trace) + answer.held
        flat, inertia = new.reshape(-1, new.shape[2]), (mass * new).reshape(-1, new.shape[2])
        work = flat.conj().T @ (mass * fields).reshape(inertia.shape)
        offsets, mixed = la.eigh(0.5 * (work + work.conj().T), flat.conj().T @ inertia)
        order = np.argsort(np.abs(shift + offsets - omega**2))
        fields, trace = new @ mixed[:, order], trace @ mixed[:, order]
        before, value = value, float(shift + offsets[order[0]])
        if abs(value - before) <= SETTLED * value:
            same = np.abs(shift + offsets[order] - value) <= TOGETHER * value
            return ExactModes(kappa, float(np.sqrt(value)), fields[:, :, same], trace[:, same])
    raise ArithmeticError(f"the mode near {omega / (2 * np.pi):g} Hz does not converge")
