"""A real basis that answers loads over a band of frequencies, for any damping: rational Krylov vectors.

At several real shifts s the block Krylov space of (K - s M)^-1 M on loads and on random forces is spanned
(Ruhe 1984, doi 10.1016/0024-3795(84)90221-0). The random forces find the modes that the loads hardly excite:
any damping may couple them. Inertia counts at the shifts tell whether a mode of the band is missing.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from haptonic.plate.assembly import Assembly, Shifted
from haptonic.solvers import Solver, chosen
from haptonic.superelement.parallel import threads

Array = NDArray[np.float64]

REPEATED = 1e-13  # share of a direction's squared length that must not lie in the others


@dataclass(frozen=True, eq=False)
class Chain:
    """Krylov vectors at one shift. shift : (rad/s)^2; below : eigenvalues below it; vectors : (size, k)"""

    shift: float
    below: int
    vectors: Array


def chain(shifted: Shifted, loads: Array, length: int) -> Chain:
    """At most ``length`` blocks of mass-orthonormal Krylov vectors of loads (size, b)."""
    assembly = shifted.assembly
    vectors = np.empty((assembly.size, length * loads.shape[1]), order="F")
    inertia = np.empty_like(vectors)
    count = 0
    new = shifted.solve(loads)
    for step in range(length):
        for _ in range(2 if count else 0):  # one pass of Gram and Schmidt is not enough
            new -= vectors[:, :count] @ (inertia[:, :count].T @ new)
        heavy = assembly.mass_times(new)
        gram = new.T @ heavy
        scale = np.sqrt(np.maximum(np.diag(gram), np.finfo(float).tiny))
        weights, turn = la.eigh(gram / scale / scale[:, None])
        kept = weights > REPEATED
        turn = turn[:, kept] / np.sqrt(weights[kept]) / scale[:, None]
        end = count + turn.shape[1]
        vectors[:, count:end], inertia[:, count:end] = new @ turn, heavy @ turn
        if step < length - 1:
            new = shifted.solve(inertia[:, count:end])
        count = end
    return Chain(shifted.shift, shifted.below, vectors[:, :count])


def chains(
    assembly: Assembly,
    loads: Callable[[Shifted], Array],
    shifts: Sequence[float],
    length: int,
    told: Callable[[], None] = lambda: None,
) -> list[Chain]:
    """Chains at several shifts, side by side in threads. ``loads`` gives those of a shift."""
    idle: list[Solver] = []

    def one(shift: float) -> Chain:
        solver = idle.pop() if idle else chosen()(assembly.pattern)
        shifted = assembly.shifted(shift, solver)
        found = chain(shifted, loads(shifted), length)
        idle.append(solver)
        told()
        return found

    assembly.prepare()
    with threadpool_limits(1):
        if threads() == 1:
            return [one(shift) for shift in shifts]
        with ThreadPoolExecutor(threads()) as pool:
            return list(pool.map(one, shifts))


@dataclass(frozen=True, eq=False)
class Basis:
    """Ritz vectors: orthonormal in mass, orthogonal in stiffness.

    vectors : (size, r); values : (r,) Ritz values, (rad/s)^2, ascending
    complete : (rad/s)^2 between which no mode is missing, by inertia counts
    """

    vectors: Array
    values: Array
    complete: tuple[float, float]

    @classmethod
    def spanned(cls, assembly: Assembly, chains: Sequence[Chain]) -> Basis:
        """Rayleigh and Ritz on the span of chains."""
        raw = np.asfortranarray(np.hstack([chain.vectors for chain in chains]))
        work = np.empty_like(raw)
        gram = raw.T @ assembly.mass_times(raw, out=work)
        factor, pivots, rank, _ = la.lapack.dpstrf(gram, tol=REPEATED * gram.diagonal().max(), lower=0)
        order = pivots - 1
        kept = order[:rank]
        triangle = np.triu(factor[:rank, :rank])
        stiff = raw.T @ assembly.stiffness_times(raw, out=work)
        stiff = la.solve_triangular(triangle, stiff[np.ix_(kept, kept)], trans=1)
        stiff = la.solve_triangular(triangle, stiff.T, trans=1)
        values, turn = la.eigh(0.5 * (stiff + stiff.T), driver="evd")
        turn = la.solve_triangular(triangle, turn)
        full = np.zeros((raw.shape[1], rank))
        full[kept] = turn
        vectors = np.matmul(raw, full, out=work[:, :rank])
        return cls(vectors, values, _complete(values, chains))

    @property
    def dimension(self) -> int:
        return len(self.values)


def _complete(values: Array, chains: Sequence[Chain]) -> tuple[float, float]:
    """The widest interval between two shifts in which as many Ritz values lie as there are modes."""
    ends = sorted({(chain.shift, chain.below) for chain in chains})
    best = run = (0.0, 0.0)
    if (values < ends[0][0]).sum() == ends[0][1]:
        best = run = (0.0, ends[0][0])
    else:
        run = (ends[0][0], ends[0][0])
    for (low, below_low), (high, below_high) in pairwise(ends):
        found = int(((values >= low) & (values < high)).sum())
        run = (run[0], high) if found == below_high - below_low else (high, high)
        if run[1] - run[0] > best[1] - best[0]:
            best = run
    return best
