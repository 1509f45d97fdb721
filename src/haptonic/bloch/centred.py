"""Pencils of Bloch waves of a lattice: stiffness and mass of a tiling at any wavevector.

Two symmetries of a cell divide the work. If the plate's middle plane is a mirror, motions that are even and
odd in it are not coupled. If half a turn R about the normal leaves the cell unchanged, R maps Bloch fields at
kappa, with phases relative to the centre, to fields at -kappa by a constant matrix, and so does complex
conjugation: ``conj(A(kappa)) = A(-kappa) = R A(kappa) R``. On even vectors, and ``i`` times odd ones,
A(kappa) is therefore real and symmetric. Real eigenproblems take a quarter of the time of Hermitian ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Self

import numpy as np

from haptonic.arrays import Array, Bools, Complex, Fields, Ints
from haptonic.bloch.pencil import AnyPencil, Pencil, Periodic, SplitPencil
from haptonic.later import linalg as la, sparse as sp
from haptonic.superelement import Tiling

STEP = 1e-3  # rad, of finite differences that approximate derivatives at Gamma
ROUNDING = 1e-12  # largest entry that is zero but for rounding, of fields with entries of order one


@dataclass(frozen=True, eq=False)
class PhasedPencil:
    """Pencil of a tiling as Hermitian matrices.

    The t + m unknowns of the tiling are ``motions diag(exp(i place . kappa)) spread`` times those of the
    pencil, at the phases kappa.

    forms : stiffness and mass (p, p) of the motions
    motions : (t + m, p) sparse orthonormal combinations of the tiling's unknowns
    place : (p, 2) of each motion, multiples of half a translation
    spread : (p, n) sparse
    translations : (n, 3) unit motions along x, y and z; zero if the pencil does not contain them
    is_turned_in_place : whether half a turn about the centre maps the tiling's unknowns to each other
    """

    forms: tuple[Array, Array]
    motions: sp.csr_array
    place: Array
    spread: sp.csr_array
    translations: Array
    is_turned_in_place: bool = False

    @classmethod
    def of(cls, tiling: Tiling) -> Self:
        """Make the pencil of all motions of a tiling."""
        periodic = Periodic.of(tiling)
        place, spread, is_turned_in_place = cls._of_free(tiling, periodic)
        uniform = np.arange(tiling.size)[:, None] % 3 == np.arange(3)
        uniform[tiling.trace_size :] = False
        shares = (spread.conj().T @ uniform) / _norms(spread)[:, None]
        return cls(
            forms=(tiling.stiffness, tiling.mass),
            motions=sp.eye_array(tiling.size, format="csr"),
            place=place,
            spread=spread,
            translations=shares.real - shares.imag,
            is_turned_in_place=is_turned_in_place,
        )

    @staticmethod
    def _of_free(tiling: Tiling, periodic: Periodic) -> tuple[Array, sp.csr_array, bool]:
        """Place of the tiling's unknowns, spread from those of the pencil, and whether a turn maps them."""
        count = len(periodic.number)
        ones = np.ones(count, dtype=complex)
        spread = sp.csr_array((ones, (np.arange(count), periodic.number)), shape=(count, len(periodic.free)))
        return periodic.shift.astype(float), spread, False

    @property
    def size(self) -> int:
        return int(self.spread.shape[1])

    @property
    def parts(self) -> tuple[Self]:
        """The pencil itself, as the only part; see `SplitPencil`."""
        return (self,)

    def at(self, kappa: Array) -> tuple[Fields, Fields]:
        """(n, n) Hermitian stiffness and mass at the phases (2,)."""
        cosine, sine = self._parts(kappa)

        def on_waves(form: Array) -> Complex:
            crossed = cosine.T @ np.ascontiguousarray((sine.T @ form).T)
            return np.asarray(_congruent(cosine, form) + _congruent(sine, form) + 1j * (crossed - crossed.T))

        K, M = (on_waves(form) for form in self.forms)
        return K, M

    def _parts(self, kappa: Array) -> tuple[sp.csr_array, sp.csr_array]:
        """Real and imaginary part (p, n) of the spread with its phases."""
        spread = self.spread
        phase = np.repeat(np.exp(1j * (self.place @ kappa)), np.diff(spread.indptr))
        data = spread.data * phase
        real, imaginary = (
            sp.csr_array((part, spread.indices, spread.indptr), shape=spread.shape)
            for part in (data.real, data.imag)
        )
        return real, imaginary

    def fields(self, modes: Fields, kappa: Array) -> Complex:
        """(t + m, k) unknowns of the tiling from modes (n, k)."""
        phase = np.exp(1j * (self.place @ kappa))
        return np.asarray(self.motions @ (phase[:, None] * (self.spread @ modes)))

    def halves(self, tiling: Tiling) -> tuple[Self, ...]:
        """Pencils of symmetric and antisymmetric motions about the middle plane, which are not coupled.

        A pencil whose middle plane is not a mirror is the only one.
        """
        reflection = tiling.in_middle_plane()
        if reflection is None:
            return (self,)
        source, sign = reflection
        count = len(source)
        mirror = sp.csr_array((sign, (np.arange(count), source)), shape=(count, count))
        on_waves = sp.csr_array((self.spread.conj().T @ mirror @ self.spread).multiply(
            1 / _norms(self.spread)[:, None]
        ))  # fmt: skip
        pencils = []
        for motions, waves in zip(_halves(mirror), _halves(_without_rounding(on_waves).real), strict=True):
            stiffness, mass = (_congruent(motions, form) for form in self.forms)
            pencils.append(
                type(self)(
                    forms=(stiffness, mass),
                    motions=motions,
                    place=self.place[abs(motions).argmax(axis=0)],
                    spread=_without_rounding(motions.T @ self.spread @ waves),
                    translations=waves.T @ self.translations,
                    is_turned_in_place=self.is_turned_in_place,
                )
            )
        return tuple(pencils)

    def projected(self, basis: Array, forms: Sequence[Array] | None = None) -> Pencil | RealPencil:
        """The pencil on a constant basis (n, r), which must be real to conserve time reversal.

        forms : two forms (t + m, t + m) of the tiling in place of its stiffness and mass
        """
        shifts, (stiffness, mass), _ = self._laurent(basis, forms)
        return Pencil(shifts.astype(np.int64), stiffness, mass)

    def _laurent(self, basis: Array, forms: Sequence[Array] | None) -> tuple[Array, Array, Array]:
        """Shifts (s, 2), real and imaginary coefficients (2, s, r, r) of ``exp(i shift . kappa)`` on a basis.

        Only one of two opposite shifts is given; (0, 0) comes first. If the unknowns are turned in place, the
        half-turn leads from a pair of places to another one, with the transpose as its share.
        """
        of_motions = [_congruent(self.motions, form) for form in forms] if forms else self.forms
        kinds, kind = np.unique(np.rint(2 * self.place).astype(np.int64), axis=0, return_inverse=True)
        order, ends = np.argsort(kind.ravel(), kind="stable"), np.cumsum(np.bincount(kind.ravel()))
        groups, opposite = [slice(*pair) for pair in pairwise([0, *ends])], range(len(kinds))[::-1]
        assert not self.is_turned_in_place or (kinds == -kinds[::-1]).all()
        size, spread = basis.shape[1], self.spread[order] @ basis
        parts = np.stack([spread.real, spread.imag], axis=1)
        sums: dict[tuple[int, ...], Array] = {}
        for number, form in enumerate(of_motions):
            form = form[np.ix_(order, order)]
            for first, columns in enumerate(groups):
                # the pairs in the other order are the adjoints of these
                last = min(first, opposite[first]) if self.is_turned_in_place else first
                loads = np.tensordot(form[: ends[last], columns], parts[columns], axes=1)
                turned = np.stack([loads[:, 1], -loads[:, 0]], axis=1)
                both = np.concatenate([loads, turned], axis=2)
                for second, rows in enumerate(groups[: last + 1]):
                    share = parts[rows].reshape(-1, size).T @ both[rows].reshape(-1, 2 * size)
                    if self.is_turned_in_place and second == opposite[first]:
                        share *= 0.5  # the half-turn leads to this pair itself
                    step = tuple((kinds[first] - kinds[second]).tolist())
                    total = sums.setdefault(step, np.zeros((2, size, 2 * size)))
                    total[number] += share
        steps = sorted(sums)
        total = np.stack([sums[step] for step in steps], axis=1)
        real, imaginary = total[..., :size], total[..., size:]
        if self.is_turned_in_place:
            real, imaginary = (part + part.swapaxes(-1, -2) for part in (real, imaginary))
        return 0.5 * np.array(steps), real, imaginary

    def near_rest(self) -> Array:
        """(n, r) translations and their derivatives with respect to the phases, at zero wavevector.

        The basis contains first derivatives of all translations, and second derivatives of the one along z,
        whose frequency grows with the square of the wavevector. It is exact in the limit of long waves.
        """
        (K, M), (K1, _), (K2, _), (K12, _) = self._around_rest()
        # first derivatives of the stiffness, and of modes, are imaginary
        first = [A.imag / STEP for A in (K1, K2)]
        bent = [(A - K).real / STEP**2 for A in (K1, K2, K12)]
        return _long_waves(K.real, M.real, self.translations, first, bent, 1.0)

    def _around_rest(self) -> list[tuple[Fields, Fields]]:
        return [self.at(STEP * np.array(kappa)) for kappa in ((0, 0), (1, 0), (0, 1), (1, 1))]

    def snapshots(self, modes: Fields) -> Array:
        """Real fields that span given modes, with at most unit mass."""
        return np.hstack([modes.real, modes.imag])


class CentredPencil(PhasedPencil):
    """Pencil of a cell that the half-turn leaves unchanged, as real symmetric matrices.

    The spread is real for unknowns of even fields, and imaginary for those of odd ones.
    """

    @staticmethod
    def _of_free(tiling: Tiling, periodic: Periodic) -> tuple[Array, sp.csr_array, bool]:
        free, turned = len(periodic.free), tiling.half_turn()
        assert turned is not None, "a cell that the half-turn changes"
        is_in_place = not turned[2].any()
        source, sign, away = (of_unknowns[periodic.free] for of_unknowns in turned)
        image = periodic.number[source]
        # each orbit {j, image of j} gives an even and an odd combination; a fixed unknown is even or odd
        j = np.arange(free)
        first, alone = j[j < image], j[j == image]
        second, between, pairs = image[first], sign[first], len(first)
        root = np.full(pairs, np.sqrt(0.5))
        single = np.where(sign[alone] > 0, 1, 1j)
        values = np.concatenate([root, root * between, 1j * root, -1j * root * between, single])
        rows = np.concatenate([first, second, first, second, alone])
        even, odd = np.arange(pairs), np.arange(pairs, 2 * pairs)
        columns = np.concatenate([even, even, odd, odd, np.arange(2 * pairs, free)])
        combinations = sp.csr_array((values, (rows, columns)), shape=(free, free))
        # half the translation from an unknown to its image leads to the centre
        offset = 0.5 * (periodic.shift[source] + away)
        offset[second] = offset[first]
        return periodic.shift - offset[periodic.number], combinations[periodic.number], is_in_place

    @property
    def odd(self) -> Bools:
        """(n,) True for unknowns of odd fields."""
        return np.asarray(abs(self.spread.imag).sum(axis=0) > abs(self.spread.real).sum(axis=0))

    def at(self, kappa: Array) -> tuple[Array, Array]:
        """(n, n) real symmetric stiffness and mass at the phases (2,)."""
        cosine, sine = self._parts(kappa)
        K, M = (_congruent(cosine, form) + _congruent(sine, form) for form in self.forms)
        return K, M

    def projected(self, basis: Array, forms: Sequence[Array] | None = None) -> RealPencil:
        """As for `PhasedPencil`; a constant basis conserves time reversal in any case."""
        shifts, real, imaginary = self._laurent(basis, forms)
        # with the opposite shifts, whose coefficients are the conjugate ones
        twice = np.where(shifts.any(axis=1), 2.0, 1.0)[:, None, None]
        return RealPencil.of(shifts, twice * real, -twice * imaginary)

    def near_rest(self) -> Array:
        """As for `PhasedPencil`."""
        (K, M), (K1, _), (K2, _), (K12, _) = self._around_rest()
        crossing = self.odd[:, None] != self.odd  # there K is odd in kappa, elsewhere it is even
        first = [np.where(crossing, A, 0.0) / STEP for A in (K1, K2)]
        bent = [np.where(crossing, 0.0, A - K) / STEP**2 for A in (K1, K2, K12)]
        return _long_waves(K, M, self.translations, first, bent, -1.0)

    def snapshots(self, modes: Array) -> Array:
        """Real fields that span given modes."""
        return modes


def _long_waves(
    K: Array, M: Array, translations: Array, first: list[Array], bent: list[Array], twice: float
) -> Array:
    """(n, r) translations and their derivatives, from those of the stiffness at Gamma.

    translations : (n, 3), zero for those that the pencil does not contain
    first : first derivatives for each phase; bent : half the second ones, then for both phases together
    twice : -1, or +1 if first derivatives are imaginary and given without the factor i
    """
    contained = np.flatnonzero(translations.any(axis=0))
    momenta = M @ translations[:, contained]
    momenta /= np.sqrt(np.einsum("nk,nk->k", translations[:, contained], momenta))
    stiff = la.cho_factor(K + (np.trace(K) / np.trace(M)) * momenta @ momenta.T)
    rest = la.cho_solve(stiff, momenta)  # along the translations, for any added stiffness
    rest /= np.sqrt(np.einsum("nk,nk->k", rest, M @ rest))

    def response(load: Array) -> Array:
        return np.asarray(la.cho_solve(stiff, load - momenta @ (rest.T @ load)))

    slopes = [response(-A @ rest) for A in first]
    vertical = contained == 2
    (along_1, along_2), up = (slope[:, vertical] for slope in slopes), rest[:, vertical]
    curvatures = [
        response(2 * (twice * first[0] @ along_1 - bent[0] @ up)),
        response(2 * (twice * first[1] @ along_2 - bent[1] @ up)),
        response(twice * (first[0] @ along_2 + first[1] @ along_1) - (bent[2] - bent[0] - bent[1]) @ up),
    ]
    return np.hstack([rest, *slopes, *curvatures])


LatticePencil = PhasedPencil | SplitPencil[PhasedPencil]


def lattice_pencil(tiling: Tiling) -> LatticePencil:
    """Make the pencil of a tiling: real with a half-turn, and split with a mirror in the middle plane."""
    pencil = (CentredPencil if tiling.is_centred else PhasedPencil).of(tiling)
    return together(pencil.halves(tiling))


def together(pencils: Sequence[AnyPencil]) -> AnyPencil | SplitPencil[AnyPencil]:
    """The pencil of all motions from one, or from those of symmetric and antisymmetric motions."""
    return pencils[0] if len(pencils) == 1 else SplitPencil((pencils[0], pencils[1]))


def _congruent(fields: sp.csr_array, form: Array) -> Array:
    """(n, n) symmetric form (p, p) on sparse real fields (p, n)."""
    return np.asarray(fields.T @ np.ascontiguousarray((fields.T @ form).T))


def _norms(fields: sp.csr_array) -> Array:
    """(n,) squared norms of the columns."""
    return np.asarray(abs(fields).power(2).sum(axis=0))


def _without_rounding(fields: sp.csr_array) -> sp.csr_array:
    fields = sp.csr_array(fields)
    fields.data[np.abs(fields.data) < ROUNDING] = 0.0
    fields.eliminate_zeros()
    return fields


def _halves(middle: sp.csr_array) -> tuple[sp.csr_array, sp.csr_array]:
    """(n, s) and (n, a) orthonormal bases of even and odd motions of a mirror (n, n).

    The mirror exchanges pairs of unknowns, or maps an unknown to itself or to its opposite.
    """
    entries = middle.tocoo()
    first, second = entries.coords
    alone, pair = first == second, first < second
    root = np.full(int(pair.sum()), np.sqrt(0.5))
    parts = []
    for parity in (1, -1):
        single = first[alone & (entries.data * parity > 0)]
        columns, size = np.arange(len(root)), len(root) + len(single)
        values = np.concatenate([root, parity * root * entries.data[pair], np.ones(len(single))])
        rows = np.concatenate([first[pair], second[pair], single])
        places = (rows, np.concatenate([columns, columns, np.arange(len(root), size)]))
        parts.append(sp.csr_array((values, places), shape=(middle.shape[0], size)))
    return parts[0], parts[1]


@dataclass(frozen=True)
class RealPencil:
    """Real symmetric ``sum_s C_s cos(s . kappa) + S_s sin(s . kappa)`` for stiffness and mass.

    Sums of the lower triangles take less than half of the time of sums of whole matrices.

    shifts : (s, 2) in whole or half translations
    size : r, of the matrices
    lower : (2 s, 2, r (r + 1) / 2) lower triangles of all C_s, then of all S_s, stiffness first
    """

    shifts: Array
    size: int
    lower: Array

    @classmethod
    def of(cls, shifts: Array, cosine: Array, sine: Array) -> Self:
        """Make the pencil from symmetric coefficients (2, s, r, r), stiffness first."""
        size = cosine.shape[-1]
        rows, columns = np.tril_indices(size)
        every = np.concatenate([cosine, sine], axis=1).swapaxes(0, 1).reshape(2 * len(shifts), 2, -1)
        return cls(shifts, size, np.take(every, rows * size + columns, axis=-1))

    @cached_property
    def _entry(self) -> Ints:
        """(r, r) number in the lower triangle of each entry of a symmetric matrix."""
        entry = np.zeros((self.size, self.size), dtype=np.int64)
        entry[np.tril_indices(self.size)] = np.arange(self.lower.shape[-1])
        return np.maximum(entry, entry.T)

    def at(self, kappa: Array) -> tuple[Array, Array]:
        """(r, r) real symmetric stiffness and mass at the phases (2,)."""
        turns = self.shifts @ kappa
        (pair,) = self._summed(np.concatenate([np.cos(turns), np.sin(turns)])[None])
        return pair

    def slopes(self, kappa: Array) -> list[tuple[Array, Array]]:
        """Exact derivatives of stiffness and mass with respect to each phase."""
        turns, steps = self.shifts @ kappa, self.shifts.T
        return self._summed(np.hstack([-steps * np.sin(turns), steps * np.cos(turns)]))

    def _summed(self, factors: Array) -> list[tuple[Array, Array]]:
        """Stiffness and mass for each row of factors (n, 2 s) of the coefficients."""
        forms = np.take(np.tensordot(factors, self.lower, axes=1), self._entry, axis=-1)
        return [(K, M) for K, M in forms]
