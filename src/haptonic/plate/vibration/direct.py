"""Solution of a plate at one frequency without a basis: complex, with all losses.

The complex equations

    [ (1 + i eta) K - omega^2 M + sum_j Z_j(omega) A_j A_j^T ] u = f

are solved by GMRES (Saad and Schultz 1986, doi 10.1137/0907058), preconditioned with the real matrix
``K - s M`` of the plate without loss, which is factorised at an s close to omega^2. Losses are small or
affect few directions, so the product is close to the identity but for some resonances, and a dozen steps
are enough.
"""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array, Complex
from haptonic.later import sparse_linalg
from haptonic.plate.body.model import PlateModel
from haptonic.plate.layout.keys import PLATE
from haptonic.plate.vibration.damping import real_times

BESIDE = 1e-3  # relative distance of the shift s from the square of the frequency
RESIDUAL = 1e-12  # relative
STEPS = 300  # at most; the caller checks the solution


def direct_answer(model: PlateModel, loads: Complex, omega: float) -> Complex:
    """Compute the displacement (size, k) under loads (size, k) at an angular frequency, rad/s."""
    assembly, line = model.assembly, np.array([omega])
    shifted = assembly.shifted((1 + BESIDE) * omega**2)
    extras = [(extra.rows, extra.axes, extra.impedance(line)[0]) for extra in model.extras]

    def stiff(field: Complex) -> Complex:
        halves = _halves(field)
        out = model.factors[PLATE] * _whole(assembly.stiffness_times(halves))
        out -= omega**2 * _whole(assembly.mass_times(halves))
        for rows, axes, impedance in extras:
            moved = real_times(axes, real_times(axes.T, field[rows, None]))
            out[rows] += impedance * moved[:, 0]
        return out

    shape = (assembly.size, assembly.size)
    matrix = sparse_linalg.LinearOperator(shape, lambda field: stiff(field.ravel()), dtype=complex)
    nearby = sparse_linalg.LinearOperator(
        shape, lambda right: _whole(shifted.solve(_halves(right.ravel()))), dtype=complex
    )
    solutions = [
        sparse_linalg.gmres(matrix, load, M=nearby, rtol=RESIDUAL, restart=STEPS, maxiter=1)[0]
        for load in loads.T
    ]
    shifted.release()
    return np.stack(solutions, axis=1)


def _halves(field: Complex) -> Array:
    """(n, 2) real and imaginary part."""
    return np.stack([field.real, field.imag], axis=1)


def _whole(halves: Array) -> Complex:
    """(n,) complex field from real and imaginary part."""
    return np.asarray(halves[:, 0] + 1j * halves[:, 1])
