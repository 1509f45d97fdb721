"""Real bases of rational Krylov vectors for loads over a band of frequencies and any damping.

At several real shifts s the block Krylov space of (K - s M)^-1 M on loads and on random forces is spanned
(Ruhe 1984, doi 10.1016/0024-3795(84)90221-0). The random forces excite modes that the loads hardly excite,
because damping may couple them. Inertia counts at the shifts show whether a mode of the band is missing.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.later import linalg as la
from haptonic.parallel import each
from haptonic.plate.body.assembly import AT_ONCE, Assembly, Shifted

TOGETHER = 4  # number of chains made orthogonal to the others at once
REPEATED = 1e-13  # share of a direction's squared length outside the others below which it is dropped
CLEAR = 0.1  # such a share above which one pass of Gram and Schmidt is enough


class _Orthonormal:
    """Growing set of vectors that are orthonormal in mass."""

    def __init__(self, assembly: Assembly, capacity: int) -> None:
        self.assembly = assembly
        self._vectors = np.empty((assembly.size, capacity), order="F")
        self._heavy = np.empty_like(self._vectors)
        self.count = 0

    @property
    def vectors(self) -> Array:
        """(size, count)"""
        return self._vectors[:, : self.count]

    def add(self, new: Array) -> Array:
        """Add the new directions of vectors (size, k); return the mass times the added vectors."""
        for _ in range(2):  # one pass of Gram and Schmidt is not enough
            self._project(new)
        heavy = self.assembly.mass_times(new)
        lengths = np.sqrt(np.maximum(np.einsum("nk,nk->k", new, heavy), np.finfo(float).tiny))
        _, turn = _turned(new, heavy, lengths)
        return self._append(new @ turn, heavy @ turn)

    def add_known(self, new: Array) -> None:
        """Add the new directions of vectors (size, k) of length 1 in mass; the vectors are overwritten."""
        self._project(new)
        heavy = self.assembly.mass_times(new)
        weights, turn = _turned(new, heavy, np.ones(new.shape[1]))
        clear = weights > CLEAR
        self._append(new @ turn[:, clear], heavy @ turn[:, clear])
        new = new @ turn[:, ~clear]  # nearly dependent; now normalised, so another pass is accurate
        self._project(new)
        heavy = self.assembly.mass_times(new)
        _, turn = _turned(new, heavy, np.ones(new.shape[1]))
        self._append(new @ turn, heavy @ turn)

    def _project(self, new: Array) -> None:
        if self.count:
            present = slice(0, self.count)
            new -= self._vectors[:, present] @ (self._heavy[:, present].T @ new)

    def _append(self, new: Array, heavy: Array) -> Array:
        added = slice(self.count, self.count + new.shape[1])
        self.count = added.stop
        self._vectors[:, added], self._heavy[:, added] = new, heavy
        return self._heavy[:, added]


def _turned(new: Array, heavy: Array, lengths: Array) -> tuple[Array, Array]:
    """Combinations that make vectors orthonormal, without directions of rounding errors.

    new, heavy : (size, k) vectors and the mass times them; lengths : (k,) lengths scaled to 1

    Returns
    -------
    (r,) squared lengths of the independent directions, ascending, and (k, r) these at length 1
    """
    weights, turn = la.eigh(new.T @ heavy / lengths / lengths[:, None])
    independent = weights > REPEATED
    return weights[independent], turn[:, independent] / np.sqrt(weights[independent]) / lengths[:, None]


@dataclass(frozen=True, eq=False)
class Chain:
    """Krylov vectors at one shift. shift : (rad/s)^2; below : eigenvalues below it; vectors : (size, k)"""

    shift: float
    below: int
    vectors: Array


def chain(shifted: Shifted, loads: Array, length: int) -> Chain:
    """Compute at most ``length`` blocks of mass-orthonormal Krylov vectors of loads (size, b)."""
    span = _Orthonormal(shifted.assembly, length * loads.shape[1])
    heavy = loads
    for _ in range(length):
        heavy = span.add(shifted.solve(heavy))
    return Chain(shifted.shift, shifted.below, span.vectors)


def chains(
    assembly: Assembly,
    loads: Callable[[Shifted], Array],
    shifts: Sequence[float],
    length: int,
    finished: Callable[[], None] = lambda: None,
) -> list[Chain]:
    """Compute chains at several shifts in parallel threads; ``loads(shifted)`` returns the loads.

    ``finished()`` is called after each of them.
    """

    def chain_at(shift: float) -> Chain:
        shifted = assembly.shifted(shift)
        vectors = chain(shifted, loads(shifted), length)
        shifted.release()
        finished()
        return vectors

    assembly.prepare()
    return each(chain_at, shifts)


@dataclass(frozen=True, eq=False)
class Basis:
    """Ritz vectors: orthonormal in mass, orthogonal in stiffness.

    raw : (size, r) orthonormal in mass; turn : (r, r) Ritz vectors in terms of these
    values : (r,) Ritz values, (rad/s)^2, ascending
    below : eigenvalues below each shift, from the inertia of its factorisation
    """

    raw: Array
    turn: Array
    values: Array
    below: Mapping[float, int]

    @classmethod
    def spanned(
        cls, assembly: Assembly, pieces: list[Array], below: Mapping[float, int], together: int = TOGETHER
    ) -> Basis:
        """Compute Ritz vectors on the span of pieces (size, k); the list is emptied to free its memory.

        ``together`` pieces are made orthogonal to the others at once.
        """
        span = _Orthonormal(assembly, sum(piece.shape[1] for piece in pieces))
        while pieces:
            span.add_known(np.hstack(pieces[:together]))
            del pieces[:together]
        raw = span.vectors
        reduced = np.zeros((span.count, span.count))  # its upper triangle, block by block

        def project(start: int) -> None:
            end = min(start + AT_ONCE, span.count)
            reduced[:end, start:end] = raw[:, :end].T @ assembly.stiffness_times(raw[:, start:end])

        assembly.prepare()
        each(project, range(0, span.count, AT_ONCE))
        values, turn = la.eigh(reduced, lower=False, driver="evd", overwrite_a=True)
        return cls(raw, turn, values, below)

    @classmethod
    def of(cls, assembly: Assembly, chains: list[Chain], known: Basis | None = None) -> Basis:
        """Make the basis of chains, whose list is emptied, and of an existing basis."""
        below = {chain.shift: chain.below for chain in chains}
        pieces = [chain.vectors for chain in chains]
        chains.clear()
        if known is None:
            return cls.spanned(assembly, pieces, below)
        return cls.spanned(assembly, [known.raw, *pieces], {**known.below, **below})

    @classmethod
    def empty(cls, size: int) -> Basis:
        """Make a basis without vectors for ``size`` unknowns."""
        return cls(np.zeros((size, 0)), np.zeros((0, 0)), np.zeros(0), {})

    @property
    def dimension(self) -> int:
        return len(self.values)

    def vectors(self, which: NDArray[np.int64] | slice = slice(None)) -> Array:
        """(size, k) Ritz vectors, all or some."""
        return np.asarray(self.raw @ self.turn[:, which])

    @cached_property
    def _counted(self) -> list[tuple[float, float, bool]]:
        """Intervals between neighbouring shifts, and True if they contain as many Ritz values as modes."""
        ends = sorted(self.below.items())
        if ends and (self.values < ends[0][0]).sum() == ends[0][1]:
            ends = [(0.0, 0), *ends]
        return [
            (low, high, int(((self.values >= low) & (self.values < high)).sum()) == upper_count - lower_count)
            for (low, lower_count), (high, upper_count) in pairwise(ends)
        ]

    @property
    def incomplete(self) -> list[tuple[float, float]]:
        """Intervals between shifts, (rad/s)^2, with different numbers of Ritz values and modes."""
        return [(low, high) for low, high, whole in self._counted if not whole]

    @cached_property
    def complete(self) -> tuple[float, float]:
        """Widest interval, (rad/s)^2, that contains as many Ritz values as modes."""
        start = self._counted[0][0] if self._counted else 0.0
        best = run = (start, start)
        for low, high, whole in self._counted:
            run = (run[0] if run[1] == low else low, high) if whole else (high, high)
            best = max(best, run, key=lambda interval: interval[1] - interval[0])
        return best
