"""A real basis that answers given loads over a band of frequencies, for any damping: rational Krylov vectors.

At each of several real shifts s the Krylov space of (K - s M)^-1 M on (K - s M)^-1 B is spanned (Ruhe 1984,
doi 10.1016/0024-3795(84)90221-0).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from haptonic.plate.assembly import Assembly, Shifted
from haptonic.solvers import Solver, chosen
from haptonic.superelement.parallel import threads

Array = NDArray[np.float64]

REPEATED = 1e-13  # share of the largest Gram eigenvalue below which a direction is one of the others


@dataclass(frozen=True)
class Stop:
    """One shift of the rational Krylov space, (rad/s)^2, and how many blocks of vectors it gives."""

    shift: float
    length: int


def chain(shifted: Shifted, loads: Array, length: int) -> Array:
    """(size, k) mass-orthonormal Krylov vectors of loads (size, b) at one shift, k at most length * b."""
    assembly = shifted.assembly
    vectors = np.empty((assembly.size, length * loads.shape[1]), order="F")
    inertia = np.empty_like(vectors)
    count = 0
    new = shifted.solve(loads)
    for step in range(length):
        for _ in range(2 if count else 0):  # one pass of Gram and Schmidt is not enough
            new -= vectors[:, :count] @ (inertia[:, :count].T @ new)
        heavy = assembly.mass_times(new)
        weights, turn = la.eigh(new.T @ heavy)
        kept = weights > REPEATED * weights[-1]
        turn = turn[:, kept] / np.sqrt(weights[kept])
        end = count + turn.shape[1]
        vectors[:, count:end], inertia[:, count:end] = new @ turn, heavy @ turn
        if step < length - 1:
            new = shifted.solve(inertia[:, count:end])
        count = end
    return vectors[:, :count]


def chains(
    assembly: Assembly, loads: Array, stops: Sequence[Stop], told: Callable[[], None] = lambda: None
) -> list[Array]:
    """The chains of the same loads at several shifts, side by side in threads."""
    idle: list[Solver] = []

    def one(stop: Stop) -> Array:
        solver = idle.pop() if idle else chosen()(assembly.pattern)
        found = chain(assembly.shifted(stop.shift, solver), loads, stop.length)
        idle.append(solver)
        told()
        return found

    assembly.prepare()
    with threadpool_limits(1):
        if threads() == 1:
            return [one(stop) for stop in stops]
        with ThreadPoolExecutor(threads()) as pool:
            return list(pool.map(one, stops))


@dataclass(frozen=True, eq=False)
class Basis:
    """Ritz vectors: orthonormal in mass, orthogonal in stiffness.

    vectors : (size, r); values : (r,) Ritz values, (rad/s)^2, ascending
    """

    vectors: Array
    values: Array

    @classmethod
    def spanned(cls, assembly: Assembly, vectors: Array) -> Basis:
        """Rayleigh and Ritz on the span of vectors (size, k) of any scale."""
        work = np.empty_like(vectors)
        gram = vectors.T @ assembly.mass_times(vectors, out=work)
        size = np.sqrt(np.diag(gram))
        weights, turn = la.eigh(gram / size / size[:, None])
        kept = weights > REPEATED * weights[-1]
        turn = turn[:, kept] / np.sqrt(weights[kept]) / size[:, None]
        stiff = turn.T @ (vectors.T @ assembly.stiffness_times(vectors, out=work)) @ turn
        values, rotation = la.eigh(0.5 * (stiff + stiff.T))
        turn = turn @ rotation
        return cls(np.matmul(vectors, turn, out=work[:, : len(values)]), values)

    @property
    def dimension(self) -> int:
        return len(self.values)
