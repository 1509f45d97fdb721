"""Hermitian pencils of a row of blocks, each coupled to the next alone: what a ribbon is at one phase.

Elimination from left to right leaves the Schur complements

    S_1 = A_11,    S_c = A_cc - B_c* S_(c-1)^-1 B_c,    B_c = A_(c-1)c,

with A = K - sigma M, one after the other. They have as many negative eigenvalues together as there are
eigenvalues below sigma (Sylvester), so that none is missed, and they answer loads for the Krylov space about
sigma in which the eigenvalues near it are found.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Complex
from haptonic.errors import NumericalError
from haptonic.later import linalg as la

BLOCK = 16  # directions in each step of the Krylov space
CONVERGED = (
    1e-9  # of the interval: change of an eigenvalue in a step of the space from which it counts as found
)
MOST_STEPS = 60  # of the space; eight did for thirty eigenvalues
LOST = 1e-20  # share of the inertia of a step's directions below which nothing new is left of them
SEED = 20  # of the first directions: the same pencil gives the same modes


@dataclass(frozen=True)
class BlockChain:
    """A Hermitian form of blocks in a row. own : (c,) of them (n_c, n_c); off : (c - 1,) (n_c, n_(c + 1))"""

    own: tuple[Complex, ...]
    off: tuple[Complex, ...]

    @property
    def sizes(self) -> list[int]:
        return [len(one) for one in self.own]

    def split(self, fields: Complex) -> list[Complex]:
        """Rows (n, k) by block."""
        return np.split(fields, np.cumsum(self.sizes)[:-1])

    def times(self, fields: Complex) -> Complex:
        """(n, k) the form times fields (n, k)."""
        parts = self.split(fields)
        found = [one @ part for one, part in zip(self.own, parts, strict=True)]
        for number, off in enumerate(self.off):
            found[number] = found[number] + off @ parts[number + 1]
            found[number + 1] = found[number + 1] + off.conj().T @ parts[number]
        return np.concatenate(found)

    def less(self, other: BlockChain, factor: float) -> BlockChain:
        """This minus ``factor`` times another one."""
        return BlockChain(
            tuple(mine - factor * one for mine, one in zip(self.own, other.own, strict=True)),
            tuple(mine - factor * one for mine, one in zip(self.off, other.off, strict=True)),
        )


@dataclass(frozen=True)
class _Link:
    """A Schur complement, factorised. rows : that are coupled to the next block; answer : to unit loads there
    (n, rows); coupling : of these rows (rows, n of the next)"""

    factor: Complex
    pivots: NDArray[np.int32]
    rows: NDArray[np.int64]
    answer: Complex
    coupling: Complex

    def solved(self, loads: Complex) -> Complex:
        found, info = la.lapack.zhetrs(self.factor, self.pivots, loads)
        assert info == 0
        return np.asarray(found)

    @property
    def negative(self) -> int:
        """Eigenvalues below zero; a pivot of two rows has one."""
        double = self.pivots < 0
        return int((np.diag(self.factor).real[~double] < 0).sum() + double.sum() // 2)


@dataclass(frozen=True)
class Elimination:
    """``K - sigma M`` eliminated from left to right."""

    links: tuple[_Link, ...]

    @classmethod
    def of(cls, form: BlockChain) -> Elimination:
        links: list[_Link] = []
        for number, own in enumerate(form.own):
            if links:
                before = links[-1]
                own = own - before.coupling.conj().T @ before.answer[before.rows] @ before.coupling
            factor, pivots, info = la.lapack.zhetrf(own, lwork=64 * len(own))
            if info != 0:
                raise NumericalError.inaccurate(
                    argument="ribbon",
                    given="a frequency that is one of the ribbon's own to rounding",
                    allowed="frequencies between them",
                    cause="an end of the range, or its middle, met one by chance",
                    next_step="change ribbon.lowest or ribbon.highest a little",
                )
            off = form.off[number] if number < len(form.off) else np.zeros((len(own), 0), dtype=complex)
            rows = np.flatnonzero(off.any(axis=1))
            unit = np.zeros((len(own), len(rows)), dtype=complex)
            unit[rows, np.arange(len(rows))] = 1.0
            answer = la.lapack.zhetrs(factor, pivots, unit)[0] if len(rows) else unit
            links.append(_Link(factor=factor, pivots=pivots, rows=rows, answer=answer, coupling=off[rows]))
        return cls(tuple(links))

    @property
    def negative(self) -> int:
        """Eigenvalues of the pencil below sigma."""
        return sum(one.negative for one in self.links)

    def solved(self, loads: Sequence[Complex]) -> Complex:
        """(n, k) answers to loads by block."""
        carried = np.zeros((0, loads[0].shape[1]), dtype=complex)
        answers: list[Complex] = []
        for link, load in zip(self.links, loads, strict=True):
            answers.append(link.solved(load - carried if len(carried) else load))
            carried = link.coupling.conj().T @ answers[-1][link.rows]
        for number in range(len(answers) - 2, -1, -1):
            link = self.links[number]
            answers[number] = answers[number] - link.answer @ (link.coupling @ answers[number + 1])
        return np.concatenate(answers)


def counted(stiffness: BlockChain, mass: BlockChain, value: float) -> int:
    """Eigenvalues of a pencil below a value."""
    return Elimination.of(stiffness.less(mass, value)).negative


def eigenpairs_within(
    stiffness: BlockChain, mass: BlockChain, low: float, high: float
) -> tuple[int, Array, Complex]:
    """All eigenvalues of a pencil within an interval.

    Returns
    -------
    how many lie below it; (k,) eigenvalues, ascending; (n, k) modes of unit mass

    Raises
    ------
    NumericalError : those found are not as many as the interval holds
    """
    below, beyond = (counted(stiffness, mass, value) for value in (low, high))
    wanted, size = beyond - below, sum(stiffness.sizes)
    if wanted == 0:
        return below, np.empty(0), np.empty((size, 0), dtype=complex)
    middle = 0.5 * (low + high)
    inverse = Elimination.of(stiffness.less(mass, middle))
    draw = np.random.default_rng(SEED)
    block = min(BLOCK, size)
    new = draw.standard_normal((size, block)) + 1j * draw.standard_normal((size, block))
    basis = np.empty((size, 0), dtype=complex)
    heavy = np.empty((size, 0), dtype=complex)  # the mass times the basis
    operated = np.empty((size, 0), dtype=complex)
    last = np.empty(0)
    for _ in range(MOST_STEPS):
        given = float(np.linalg.norm(new))
        for _ in range(2):  # one pass of Gram and Schmidt is not enough
            new = new - basis @ (heavy.conj().T @ new)
        weighed = mass.times(new)
        values, turn = la.eigh(new.conj().T @ weighed)
        largest = float(np.linalg.norm(weighed)) * given / max(float(np.linalg.norm(new)), 1e-300)
        kept = values > LOST * largest * given
        turn = turn[:, kept] / np.sqrt(values[kept])
        new, weighed = new @ turn, weighed @ turn
        following = inverse.solved(stiffness.split(weighed))
        basis, heavy = np.hstack([basis, new]), np.hstack([heavy, weighed])
        operated = np.hstack([operated, following])
        new = following
        form = heavy.conj().T @ operated
        inverses, modes = la.eigh(0.5 * (form + form.conj().T))
        with np.errstate(divide="ignore"):
            found = middle + 1 / inverses
        inside = (found > low) & (found < high) & (inverses != 0)
        order = np.flatnonzero(inside)[np.argsort(found[inside])]
        settled = len(last) == len(order) and (np.abs(found[order] - last) < CONVERGED * (high - low)).all()
        exhausted = basis.shape[1] >= size or not kept.any()
        if len(order) == wanted and (settled or exhausted):
            return below, found[order], np.asarray(basis @ modes[:, order])
        last = found[order]
        if exhausted:
            break
    raise NumericalError.inaccurate(
        argument="ribbon",
        given=f"{len(last)} of {wanted} modes",
        allowed="as many modes as a count by signs says there are",
        cause="some of them lie at an end of the range of frequencies",
        next_step="change ribbon.lowest or ribbon.highest a little",
    )
