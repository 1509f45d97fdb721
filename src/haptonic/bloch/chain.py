"""Hermitian block-tridiagonal pencils, such as those of a ribbon at one phase.

Elimination from left to right gives the Schur complements

    S_1 = A_11,    S_c = A_cc - B_c* S_(c-1)^-1 B_c,    B_c = A_(c-1)c,

with A = K - sigma M. The number of their negative eigenvalues is the number of eigenvalues below sigma
(Sylvester), so none is missed. They also solve for the Krylov space about sigma in which the eigenvalues
near sigma are computed.
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
CONVERGED = 1e-9  # share of the interval: largest change of a converged eigenvalue in a step of the space
MOST_STEPS = 60  # of the space; eight were enough for thirty eigenvalues
LOST = 1e-20  # share of the inertia of a step's directions below which they depend on earlier ones
SEED = 20  # of the random start directions, so that results are reproducible


@dataclass(frozen=True)
class BlockChain:
    """Hermitian block-tridiagonal form.

    own : (c,) diagonal blocks (n_c, n_c); off : (c - 1,) blocks (n_c, n_(c + 1)) to the next
    """

    own: tuple[Complex, ...]
    off: tuple[Complex, ...]

    @property
    def sizes(self) -> list[int]:
        return [len(block) for block in self.own]

    def split(self, fields: Complex) -> list[Complex]:
        """Split rows (n, k) by block."""
        return np.split(fields, np.cumsum(self.sizes)[:-1])

    def times(self, fields: Complex) -> Complex:
        """(n, k) product of the form and fields (n, k)."""
        parts = self.split(fields)
        products = [block @ part for block, part in zip(self.own, parts, strict=True)]
        for number, off in enumerate(self.off):
            products[number] = products[number] + off @ parts[number + 1]
            products[number + 1] = products[number + 1] + off.conj().T @ parts[number]
        return np.concatenate(products)

    def less(self, other: BlockChain, factor: float) -> BlockChain:
        """Subtract ``factor`` times another form."""
        return BlockChain(
            tuple(block - factor * subtracted for block, subtracted in zip(self.own, other.own, strict=True)),
            tuple(block - factor * subtracted for block, subtracted in zip(self.off, other.off, strict=True)),
        )


@dataclass(frozen=True)
class _Link:
    """Factorised Schur complement of a block.

    rows : numbers of the rows coupled to the next block; answer : (n, rows) responses to unit loads there
    coupling : (rows, n of the next block) of these rows
    """

    factor: Complex
    pivots: NDArray[np.int32]
    rows: NDArray[np.int64]
    answer: Complex
    coupling: Complex

    def solved(self, loads: Complex) -> Complex:
        solution, info = la.lapack.zhetrs(self.factor, self.pivots, loads)
        assert info == 0
        return np.asarray(solution)

    @property
    def negative(self) -> int:
        """Number of negative eigenvalues; a pivot of two rows has one."""
        double = self.pivots < 0
        return int((np.diag(self.factor).real[~double] < 0).sum() + double.sum() // 2)


@dataclass(frozen=True)
class Elimination:
    """``K - sigma M`` eliminated from left to right."""

    links: tuple[_Link, ...]

    @classmethod
    def of(cls, form: BlockChain) -> Elimination:
        links: list[_Link] = []
        for number, schur in enumerate(form.own):
            if links:
                before = links[-1]
                schur = schur - before.coupling.conj().T @ before.answer[before.rows] @ before.coupling
            factor, pivots, info = la.lapack.zhetrf(schur, lwork=64 * len(schur))
            if info != 0:
                raise NumericalError.inaccurate(
                    argument="ribbon",
                    given="a frequency that equals a resonance of the ribbon to rounding",
                    allowed="frequencies between the resonances",
                    cause="an end of the range, or its middle, is a resonance by chance",
                    next_step="change ribbon.lowest or ribbon.highest a little",
                )
            off = form.off[number] if number < len(form.off) else np.zeros((len(schur), 0), dtype=complex)
            rows = np.flatnonzero(off.any(axis=1))
            unit = np.zeros((len(schur), len(rows)), dtype=complex)
            unit[rows, np.arange(len(rows))] = 1.0
            answer = la.lapack.zhetrs(factor, pivots, unit)[0] if len(rows) else unit
            links.append(_Link(factor=factor, pivots=pivots, rows=rows, answer=answer, coupling=off[rows]))
        return cls(tuple(links))

    @property
    def negative(self) -> int:
        """Number of eigenvalues of the pencil below sigma."""
        return sum(link.negative for link in self.links)

    def solved(self, loads: Sequence[Complex]) -> Complex:
        """(n, k) solutions for loads by block."""
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
    """Count the eigenvalues of a pencil below a value."""
    return Elimination.of(stiffness.less(mass, value)).negative


def eigenpairs_within(
    stiffness: BlockChain, mass: BlockChain, low: float, high: float
) -> tuple[int, Array, Complex]:
    """Compute all eigenvalues of a pencil within an interval.

    Returns
    -------
    number of eigenvalues below it; (k,) eigenvalues, ascending; (n, k) modes of unit mass

    Raises
    ------
    NumericalError : fewer eigenvalues converged than the interval contains
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
        independent = values > LOST * largest * given
        turn = turn[:, independent] / np.sqrt(values[independent])
        new, weighed = new @ turn, weighed @ turn
        following = inverse.solved(stiffness.split(weighed))
        basis, heavy = np.hstack([basis, new]), np.hstack([heavy, weighed])
        operated = np.hstack([operated, following])
        new = following
        form = heavy.conj().T @ operated
        inverses, modes = la.eigh(0.5 * (form + form.conj().T))
        with np.errstate(divide="ignore"):
            eigenvalues = middle + 1 / inverses
        inside = (eigenvalues > low) & (eigenvalues < high) & (inverses != 0)
        order = np.flatnonzero(inside)[np.argsort(eigenvalues[inside])]
        settled = (
            len(last) == len(order) and (np.abs(eigenvalues[order] - last) < CONVERGED * (high - low)).all()
        )
        exhausted = basis.shape[1] >= size or not independent.any()
        if len(order) == wanted and (settled or exhausted):
            return below, eigenvalues[order], np.asarray(basis @ modes[:, order])
        last = eigenvalues[order]
        if exhausted:
            break
    raise NumericalError.inaccurate(
        argument="ribbon",
        given=f"{len(last)} of {wanted} modes",
        allowed="as many modes as the eigenvalue count of the factorisation",
        cause="some modes lie at an end of the range of frequencies",
        next_step="change ribbon.lowest or ribbon.highest a little",
    )
