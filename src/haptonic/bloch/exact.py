"""Modes of a cell's mesh itself at one wavevector: nothing of the reduced model is left in them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray

from haptonic.bloch.pencil import Periodic
from haptonic.superelement import FoldedMesh, Superelement, dynamic_stiffness

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

TOGETHER = 1e-6  # relative distance of eigenvalues below which modes count as degenerate
SETTLED = 1e-11  # relative change of an eigenvalue at which the iteration stops
MOST_STEPS = 6


@dataclass(frozen=True)
class ExactModes:
    """Modes of the same eigenvalue.

    kappa : (2,) phases, rad; omega : rad/s
    fields : (nodes, 3, k) displacement on the mesh, orthogonal and of unit mass
    trace : (t, k) the unknowns behind its lateral faces
    """

    kappa: Array
    omega: float
    fields: Complex
    trace: Complex


def exact_modes(shared: FoldedMesh, superelement: Superelement, kappa: Array, omega: float) -> ExactModes:
    """The mode of the mesh whose frequency is nearest to ``omega``, with all that are degenerate with it.

    The dynamic stiffness seen by the free unknowns is singular at an eigenvalue of the mesh. At a value close
    to it the linear eigenproblem of that matrix and of minus its derivative corrects the value, with an error
    that is the square of the one before.

    Parameters
    ----------
    shared : the folded mesh; superelement : any condensation of it, for the order of its unknowns
    omega : rad/s, of the reduced model
    """
    periodic = Periodic.of(superelement).without_modes(superelement)
    value = omega**2
    for _ in range(MOST_STEPS):
        dynamic = dynamic_stiffness(shared, float(np.sqrt(value)))
        stiffness, mass = (periodic.hermitian(form, kappa) for form in (dynamic.matrix, dynamic.mass))
        offsets, vectors = la.eigh(stiffness, mass)
        nearest = np.abs(offsets - offsets[np.abs(offsets).argmin()]) <= TOGETHER * value
        shift = float(offsets[nearest].mean())
        value += shift
        if abs(shift) <= SETTLED * value:
            break
    trace = vectors[:, nearest][periodic.number] * np.exp(1j * (periodic.shift @ kappa))[:, None]
    fields = dynamic.lifted(trace)
    return ExactModes(kappa, float(np.sqrt(value)), fields, trace)
