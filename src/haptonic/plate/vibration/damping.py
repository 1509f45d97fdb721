"""Response of a basis with any damping: a uniform loss, and deviations from it in few directions.

With Ritz values lambda and the loss of the plate f = 1 + i eta, the reduced dynamic stiffness is
``diag(f lambda - omega^2) + sum_j U_j Z_j(omega) U_j^T``. The second part has a low rank, so each
frequency takes little time (Woodbury 1950, Inverting modified matrices, Princeton memorandum 42).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Complex
from haptonic.later import linalg as la
from haptonic.parallel import each
from haptonic.plate.body.model import Extra
from haptonic.plate.vibration.krylov import Basis

AT_ONCE = 32  # lines
NEGLIGIBLE = 2e-4  # share of the dynamic stiffness below which a direction is neglected


@dataclass(frozen=True, eq=False)
class ReducedExtra:
    """Addition ``impedance(omega) U U^T`` to the dynamic stiffness on a basis.

    unreduced : the addition to the whole plate; whole : (r, m) U of all its axes
    kept : (r, p) main directions
    alone : (r, 1) diagonal of the rest
    """

    unreduced: Extra
    whole: Array
    kept: Array
    alone: Array

    @classmethod
    def of(cls, extra: Extra, basis: Basis, omega: float) -> ReducedExtra:
        """Reduce an addition to a basis; ``omega`` is a typical frequency, rad/s."""
        scale = np.sqrt(np.abs(basis.values) + omega**2)[:, None]
        whole = basis.turn.T @ (basis.raw[extra.rows].T @ extra.axes)
        left, sizes, _ = la.svd(whole / scale, full_matrices=False)
        directions = scale * left * sizes
        counts = abs(extra.impedance(np.array([omega]))[0]) * sizes**2 > NEGLIGIBLE
        rest = (directions[:, ~counts] ** 2).sum(axis=1, keepdims=True)
        return cls(extra, whole, directions[:, counts], rest)

    def dropped(self, fields: Complex) -> Complex:
        """(r, n) U U^T times fields, minus the contributions of ``kept`` and ``alone``."""
        everything = real_times(self.whole, real_times(self.whole.T, fields))
        return everything - real_times(self.kept, real_times(self.kept.T, fields)) - self.alone * fields


def real_times(matrix: Array, columns: NDArray[Any]) -> Complex:
    """Multiply a real matrix by complex columns without a complex copy of the matrix."""
    out = np.empty((len(matrix), columns.shape[1]), dtype=complex)
    out.real, out.imag = matrix @ columns.real, matrix @ columns.imag
    return out


def amplitudes(
    values: Array, loss: complex, extras: Sequence[ReducedExtra], loads: NDArray[Any], omega: Array
) -> tuple[Complex, Complex]:
    """Compute amplitudes of Ritz vectors, and the small residual forces on them.

    ``(loss Lambda - omega^2 + sum_e Z_e (alone_e + U_e U_e^T)) a = loads`` by the identity of Woodbury: the
    diagonal is inverted, and a few main directions U_e of every extra are added.

    One step of iterative refinement corrects for the neglected directions.

    Parameters
    ----------
    values : (r,) Ritz values; loss : complex factor of them
    loads : (r,) reduced load; omega : (n,) rad/s

    Returns
    -------
    amplitudes (r, n) and forces (r, n)
    """
    impedances = [extra.unreduced.impedance(omega) for extra in extras]
    stiffness = np.asarray(loss * values[:, None] - omega**2, np.complex128)
    for extra, impedance in zip(extras, impedances, strict=True):
        stiffness = stiffness + extra.alone * impedance
    alone = 1.0 / stiffness
    if not extras:
        return np.asarray(alone * loads[:, None]), np.zeros_like(alone)
    U = np.hstack([extra.kept for extra in extras])
    sizes = [extra.kept.shape[1] for extra in extras]
    with np.errstate(divide="ignore", invalid="ignore"):  # an extra of zero impedance has no directions
        flexibility = np.repeat(1.0 / np.stack(impedances, axis=1), sizes, axis=1)
    first, second = np.triu_indices(U.shape[1])
    pair = np.empty((U.shape[1],) * 2, dtype=np.int64)
    pair[first, second] = pair[second, first] = np.arange(len(first))
    products = U[:, first] * U[:, second]
    index = np.arange(U.shape[1])

    def some(start: int) -> tuple[Complex, Complex]:
        lines = slice(start, start + AT_ONCE)
        own = alone[:, lines]
        seen = np.empty((own.shape[1], len(first)), dtype=complex)
        seen.real, seen.imag = own.real.T @ products, own.imag.T @ products
        compliance = np.take(seen, pair, axis=1)
        compliance[:, index, index] += flexibility[lines]

        def moved(force: Complex) -> Complex:
            plain = np.asarray(own * force)
            motion = real_times(U.T, plain).T[..., None]
            return np.asarray(plain - own * real_times(U, np.linalg.solve(compliance, motion)[..., 0].T))

        def left_out(field: Complex) -> Complex:
            parts = zip(extras, impedances, strict=True)
            return np.asarray(sum(impedance[lines] * extra.dropped(field) for extra, impedance in parts))

        field = moved(np.broadcast_to(loads[:, None], own.shape).astype(complex))
        correction = moved(left_out(field))
        return field - correction, left_out(correction)

    fields, forces = zip(*each(some, range(0, len(omega), AT_ONCE)), strict=True)
    return np.hstack(fields), np.hstack(forces)
