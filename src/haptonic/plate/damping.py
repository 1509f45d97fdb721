"""Response of a basis with any damping: a uniform loss, on it what differs on a few directions.

With Ritz values lambda and the loss of the plate f = 1 + i eta, the reduced dynamic stiffness is
``diag(f lambda - omega^2) + sum_j U_j Z_j(omega) U_j^T``. The second part has a low rank, so that every
frequency costs little (Woodbury 1950, Inverting modified matrices, Princeton memorandum 42). Of its weakest
directions only the diagonal is kept.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from haptonic.plate.krylov import Basis
from haptonic.superelement.parallel import threads

Array = NDArray[np.float64]
Ints = NDArray[np.int64]
Complex = NDArray[np.complex128]

AT_ONCE = 32  # lines
NO_STIFFNESS = 1e-13  # share of a form's largest eigenvalue that is rounding
NEGLIGIBLE = 2e-5  # share of the dynamic stiffness that a direction may add without being kept


@dataclass(frozen=True, eq=False)
class Extra:
    """What adds ``impedance(omega) A A^T`` to the dynamic stiffness of a plate in which all losses are alike.

    rows : (m,) unknowns that it touches; axes : (m, k) A
    impedance : complex factor at angular frequencies (n,), rad/s
    """

    rows: Ints
    axes: Array
    impedance: Callable[[Array], Complex]

    @classmethod
    def of_form(cls, rows: Ints, form: Array, weight: complex) -> Extra:
        """From a positive semidefinite form (m, m) with a constant weight."""
        sizes, axes = la.eigh(form)
        kept = sizes > NO_STIFFNESS * sizes[-1]
        axes = axes[:, kept] * np.sqrt(sizes[kept])
        return cls(rows, axes, lambda omega: np.full(len(omega), weight))

    def on(self, basis: Basis, omega: float) -> Reduced:
        """On a basis; ``omega`` is a typical frequency, rad/s."""
        scale = np.sqrt(np.abs(basis.values) + omega**2)[:, None]
        seen = basis.turn.T @ (basis.raw[self.rows].T @ self.axes)
        left, sizes, _ = la.svd(seen / scale, full_matrices=False)
        directions = scale * left * sizes
        counts = abs(self.impedance(np.array([omega]))[0]) * sizes**2 > NEGLIGIBLE
        rest = (directions[:, ~counts] ** 2).sum(axis=1, keepdims=True)
        return Reduced(self, seen, directions[:, counts], rest)


@dataclass(frozen=True, eq=False)
class Reduced:
    """What adds ``impedance(omega) U U^T`` on a basis.

    extra : from which; whole : (r, m) the U of its axes
    kept : (r, p) main directions of these that count
    alone : (r, 1) diagonal of the rest
    """

    extra: Extra
    whole: Array
    kept: Array
    alone: Array

    def dropped(self, fields: Complex) -> Complex:
        """(r, n) U U^T times fields without what ``kept`` and ``alone`` give."""
        everything = real_times(self.whole, real_times(self.whole.T, fields))
        return everything - real_times(self.kept, real_times(self.kept.T, fields)) - self.alone * fields


def real_times(matrix: Array, columns: Complex) -> Complex:
    """A real matrix times complex columns, without making it complex."""
    out = np.empty((len(matrix), columns.shape[1]), dtype=complex)
    out.real, out.imag = matrix @ columns.real, matrix @ columns.imag
    return out


def amplitudes(stiffness: Complex, extras: Sequence[tuple[Array, Complex]], loads: NDArray[Any]) -> Complex:
    """Amplitudes of Ritz vectors.

    Parameters
    ----------
    stiffness : (r, n) dynamic stiffness of each vector alone
    extras : directions (r, p) and impedances (n,) of what adds to that; loads : (r,) reduced load

    Returns
    -------
    (r, n)
    """
    alone = 1.0 / stiffness
    plain = np.asarray(alone * loads[:, None])
    extras = [(directions, impedance) for directions, impedance in extras if directions.shape[1]]
    if not extras:
        return plain
    U = np.hstack([directions for directions, _ in extras])
    flexibility = np.hstack(
        [np.repeat(1.0 / impedance[:, None], directions.shape[1], axis=1) for directions, impedance in extras]
    )
    first, second = np.triu_indices(U.shape[1])
    pair = np.empty((U.shape[1],) * 2, dtype=np.int64)
    pair[first, second] = pair[second, first] = np.arange(len(first))
    products = U[:, first] * U[:, second]
    index = np.arange(U.shape[1])
    motion = real_times(U.T, plain).T[..., None]  # of the directions, without the extras

    def forces(start: int) -> Complex:
        """(p, lines) on the directions."""
        lines = slice(start, start + AT_ONCE)
        seen = np.empty((len(motion[lines]), len(first)), dtype=complex)
        seen.real, seen.imag = alone.real[:, lines].T @ products, alone.imag[:, lines].T @ products
        compliance = np.take(seen, pair, axis=1)
        compliance[:, index, index] += flexibility[lines]
        return np.asarray(np.linalg.solve(compliance, motion[lines])[..., 0].T)

    with threadpool_limits(1), ThreadPoolExecutor(threads()) as pool:
        found = list(pool.map(forces, range(0, len(motion), AT_ONCE)))
    return np.asarray(plain - alone * real_times(U, np.hstack(found)))
