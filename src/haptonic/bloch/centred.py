"""Real pencils of cells that a half-turn about their centre leaves unchanged.

With phases relative to the centre, the half-turn R about the normal maps Bloch fields at kappa to fields
at -kappa by a constant matrix, and so does complex conjugation: ``conj(A(kappa)) = A(-kappa) =
R A(kappa) R``. On even vectors, and ``i`` times odd ones, A(kappa) is therefore real and symmetric. Real
eigenproblems take a quarter of the time of Hermitian ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Complex, Fields
from haptonic.bloch.pencil import AnyPencil, Pencil, Periodic, SplitPencil, bloch_pencil
from haptonic.later import linalg as la, sparse as sp
from haptonic.superelement import Tiling

STEP = 1e-3  # rad, of finite differences that approximate derivatives at Gamma


@dataclass(frozen=True)
class CentredPencil:
    """Pencil of a tiling as real symmetric matrices.

    periodic : the free unknowns of the lattice
    pencil : Laurent pencil on combinations of free unknowns that are even or odd under the half-turn
    combinations : (n, n) sparse orthogonal matrix of these combinations
    offset : (n, 2) position of the middle of each relative to the centre, in half translations
    odd : (n,) True for odd combinations
    translations : (n, 3) unit motions along x, y and z
    middle : (n, n) sparse, the mirror in the plate's middle plane on these unknowns, or None
    """

    periodic: Periodic
    pencil: Pencil
    combinations: sp.csr_array
    offset: Array
    odd: NDArray[np.bool_]
    translations: Array
    middle: sp.csr_array | None

    @classmethod
    def of(cls, tiling: Tiling, forms: tuple[Array, Array] | None = None) -> CentredPencil:
        """Centre the pencil of a cell that the half-turn leaves unchanged; forms as for `bloch_pencil`."""
        periodic = Periodic.of(tiling)
        laurent = bloch_pencil(tiling, forms)
        count, turned = len(periodic.free), tiling.half_turn()
        assert turned is not None, "a cell that the half-turn changes"
        source, signs, away = (of_unknowns[periodic.free] for of_unknowns in turned)
        image, sign = periodic.number[source], signs
        # each orbit {j, image of j} gives an even and an odd combination; a fixed unknown is even or odd
        j = np.arange(count)
        first, alone = j[j < image], j[j == image]
        second, between, pairs = image[first], sign[first], len(first)
        root = np.full(pairs, np.sqrt(0.5))
        values = np.concatenate([root, root * between, root, -root * between, np.ones(len(alone))])
        rows = np.concatenate([first, second, first, second, alone])
        even, odd = np.arange(pairs), np.arange(pairs, 2 * pairs)
        columns = np.concatenate([even, even, odd, odd, np.arange(2 * pairs, count)])
        combinations = sp.csr_array((values, (rows, columns)), shape=(count, count))

        middle = periodic.in_middle_plane(tiling)
        between = periodic.shift[source] + away  # translation from an unknown to its image
        return cls(
            periodic=periodic,
            pencil=laurent.combined(combinations),
            combinations=combinations,
            offset=0.5 * between[np.concatenate([first, first, alone])],
            odd=np.concatenate([np.zeros(pairs, bool), np.ones(pairs, bool), sign[alone] < 0]),
            translations=combinations.T @ periodic.translations(tiling.trace_size),
            middle=None if middle is None else combinations.T @ middle @ combinations,
        )

    @property
    def size(self) -> int:
        return self.pencil.size

    def phases(self, kappa: Array) -> Complex:
        """(n,) factors between real unknowns and those of the pencil."""
        return np.asarray(np.where(self.odd, 1j, 1.0) * np.exp(-1j * (self.offset @ kappa)))

    def at(self, kappa: Array) -> tuple[Array, Array]:
        """(n, n) real symmetric stiffness and mass at the phases (2,)."""
        factor = self.phases(kappa)
        turn = np.outer(factor.conj(), factor)
        K, M = (turn.real * real - turn.imag * imaginary for real, imaginary in self.pencil.components(kappa))
        return K, M

    def free(self, modes: Fields, kappa: Array) -> Complex:
        """(n, k) free unknowns of the lattice from real modes (n, k)."""
        return np.asarray(self.combinations @ (self.phases(kappa)[:, None] * modes))

    def restricted(self, fields: sp.csr_array) -> CentredPencil:
        """The pencil on orthonormal combinations (n, m) of unknowns of equal offset and parity."""
        some = abs(fields).argmax(axis=0)
        return replace(
            self,
            pencil=self.pencil.combined(fields),
            combinations=self.combinations @ fields,
            offset=self.offset[some],
            odd=self.odd[some],
            translations=fields.T @ self.translations,
            middle=None,
        )

    def projected(self, basis: Array) -> RealPencil:
        """The pencil on a constant real basis (n, r)."""
        size = basis.shape[1]
        sums: dict[tuple[float, float], Array] = {}
        for piece in self._pieces:
            # Re of (1, i, -i) exp(i x) is (cos x, -sin x, sin x)
            total = sums.setdefault(piece.shift, np.zeros((2, 2, size, size)))[1 if piece.turned else 0]
            left, right = basis[piece.rows].T, basis[piece.columns]
            total += (-piece.turned or 1) * (left @ piece.forms @ right)
        stacked = np.stack(list(sums.values()), axis=2)  # cosine or sine, form, shift, r, r
        return RealPencil(np.array(list(sums)), stacked[0], stacked[1])

    @cached_property
    def _pieces(self) -> list[_Piece]:
        """Nonzero parts of the pencil between unknowns of equal offset and parity."""
        kinds, member = np.unique(np.column_stack([2 * self.offset, self.odd]), axis=0, return_inverse=True)
        groups = [np.flatnonzero(member.ravel() == kind) for kind in range(len(kinds))]
        pencil, pieces = self.pencil, []
        for number, shift in enumerate(pencil.shifts):
            form_blocks = np.stack([pencil.stiffness[number], pencil.mass[number]])
            for sign in (1, -1) if shift.any() else (1,):
                forms = form_blocks if sign > 0 else form_blocks.swapaxes(1, 2)
                for g, rows in enumerate(groups):
                    for h, columns in enumerate(groups):
                        part = forms[:, rows[:, None], columns]
                        if not part.any():
                            continue
                        step = sign * shift + 0.5 * (kinds[g, :2] - kinds[h, :2])
                        forward = 1 if tuple(step) >= (0, 0) else -1
                        turned = int(forward * (kinds[h, 2] - kinds[g, 2]))
                        pieces.append(
                            _Piece(
                                shift=tuple(forward * step),
                                turned=turned,
                                rows=rows,
                                columns=columns,
                                forms=part,
                            )
                        )
        return pieces

    def near_rest(self) -> Array:
        """(n, 12) translations and their derivatives with respect to the phases, at zero wavevector.

        The basis contains first derivatives of all translations, and second derivatives of the one along z,
        whose frequency grows with the square of the wavevector. It is exact in the limit of long waves.
        """
        (K, M), (K1, _), (K2, _), (K12, _) = (
            self.at(STEP * np.array(kappa)) for kappa in ((0, 0), (1, 0), (0, 1), (1, 1))
        )
        crossing = self.odd[:, None] != self.odd  # there K is odd in kappa, elsewhere it is even
        first = [np.where(crossing, A, 0.0) / STEP for A in (K1, K2)]
        bent = [np.where(crossing, 0.0, A - K) / STEP**2 for A in (K1, K2, K12)]
        return _long_waves(K, M, self.translations, first, bent, -1.0)

    def snapshots(self, modes: Array) -> Array:
        """Real fields that span given modes."""
        return modes


@dataclass(frozen=True)
class PhasedPencil:
    """Pencil of a cell without the half-turn, as Hermitian matrices; see `CentredPencil`.

    A constant basis must be real to conserve time reversal, which maps kappa to -kappa.
    """

    periodic: Periodic
    pencil: Pencil
    translations: Array
    middle: sp.csr_array | None

    @classmethod
    def of(cls, tiling: Tiling, forms: tuple[Array, Array] | None = None) -> PhasedPencil:
        """Make the pencil of any cell; forms as for `bloch_pencil`."""
        periodic = Periodic.of(tiling)
        return cls(
            periodic,
            bloch_pencil(tiling, forms),
            periodic.translations(tiling.trace_size),
            periodic.in_middle_plane(tiling),
        )

    @property
    def size(self) -> int:
        return self.pencil.size

    def at(self, kappa: Array) -> tuple[Complex, Complex]:
        """(n, n) Hermitian stiffness and mass at the phases (2,)."""
        return self.pencil.at(kappa)

    def free(self, modes: Fields, kappa: Array) -> Complex:
        """(n, k) free unknowns of the lattice: the modes."""
        return np.asarray(modes, dtype=complex)

    def restricted(self, fields: sp.csr_array) -> PhasedPencil:
        """The pencil on combinations (n, m) of the unknowns."""
        return replace(
            self,
            pencil=self.pencil.combined(fields),
            translations=fields.T @ self.translations,
            middle=None,
        )

    def projected(self, basis: Array) -> Pencil:
        """The pencil on a constant real basis (n, r)."""
        return self.pencil.projected(basis)

    def near_rest(self) -> Array:
        """(n, 12) as in `CentredPencil`; first derivatives are the imaginary part of those of the modes."""
        (K, M), (K1, _), (K2, _), (K12, _) = (
            self.at(STEP * np.array(kappa)) for kappa in ((0, 0), (1, 0), (0, 1), (1, 1))
        )
        first = [A.imag / STEP for A in (K1, K2)]
        bent = [(A - K).real / STEP**2 for A in (K1, K2, K12)]
        return _long_waves(K.real, M.real, self.translations, first, bent, 1.0)

    def snapshots(self, modes: Complex) -> Array:
        """Real fields that span given modes, with at most unit mass."""
        return np.hstack([modes.real, modes.imag])


def _long_waves(
    K: Array, M: Array, translations: Array, first: list[Array], bent: list[Array], twice: float
) -> Array:
    """(n, 12) translations and their derivatives, from those of the stiffness at Gamma.

    first : first derivatives for each phase; bent : half the second ones, then for both phases together
    twice : -1, or +1 if first derivatives are imaginary and given without the factor i
    """
    momenta = M @ translations
    momenta /= np.sqrt(np.einsum("nk,nk->k", translations, momenta))
    stiff = la.cho_factor(K + (np.trace(K) / np.trace(M)) * momenta @ momenta.T)
    rest = la.cho_solve(stiff, momenta)  # along the translations, for any added stiffness
    rest /= np.sqrt(np.einsum("nk,nk->k", rest, M @ rest))

    def response(load: Array) -> Array:
        return np.asarray(la.cho_solve(stiff, load - momenta @ (rest.T @ load)))

    slopes = [response(-A @ rest) for A in first]
    (along_1, along_2), up = (slope[:, 2:] for slope in slopes), rest[:, 2:]
    curvatures = [
        response(2 * (twice * first[0] @ along_1 - bent[0] @ up)),
        response(2 * (twice * first[1] @ along_2 - bent[1] @ up)),
        response(twice * (first[0] @ along_2 + first[1] @ along_1) - (bent[2] - bent[0] - bent[1]) @ up),
    ]
    return np.hstack([rest, *slopes, *curvatures])


def lattice_pencil(tiling: Tiling, forms: tuple[Array, Array] | None = None) -> CentredPencil | PhasedPencil:
    """Make the pencil of a tiling, real if half a turn leaves the cell unchanged.

    forms : as for `bloch_pencil`
    """
    if tiling.is_centred:
        return CentredPencil.of(tiling, forms)
    return PhasedPencil.of(tiling, forms)


@dataclass(frozen=True)
class ParityPart:
    """Motions of a pencil that are symmetric or antisymmetric about the middle plane, or all motions.

    embedding : (n, m) sparse orthonormal fields of the whole pencil from unknowns of the part
    """

    pencil: CentredPencil | PhasedPencil
    embedding: sp.csr_array


def parts_of(full: CentredPencil | PhasedPencil) -> tuple[ParityPart, ...]:
    """Split a pencil into symmetric and antisymmetric motions, which are not coupled.

    A pencil whose middle plane is not a mirror is the only part.
    """
    if full.middle is None:
        return (ParityPart(full, sp.eye_array(full.size, format="csr")),)
    return tuple(ParityPart(full.restricted(fields), fields) for fields in _halves(full.middle))


def together(pencils: Sequence[AnyPencil]) -> AnyPencil | SplitPencil[AnyPencil]:
    """The pencil of all parts from those of the parts."""
    return pencils[0] if len(pencils) == 1 else SplitPencil((pencils[0], pencils[1]))


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
class _Piece:
    """Stiffness and mass (2, rows, columns) times cos(shift . kappa), or -turned * sin if turned is not 0."""

    shift: tuple[float, float]
    turned: int
    rows: NDArray[np.int64]
    columns: NDArray[np.int64]
    forms: Array


@dataclass(frozen=True)
class RealPencil:
    """Real symmetric ``sum_s C_s cos(s . kappa) + S_s sin(s . kappa)`` for stiffness and mass.

    shifts : (s, 2) in whole or half translations
    cosine, sine : (2, s, r, r), stiffness first
    """

    shifts: Array
    cosine: Array
    sine: Array

    @property
    def size(self) -> int:
        return int(self.cosine.shape[-1])

    @cached_property
    def _stack(self) -> Array:
        """(2 s, 2 r r) all coefficients, for evaluation by a single product."""
        coefficients = np.concatenate([self.cosine, self.sine], axis=1)
        return np.ascontiguousarray(np.moveaxis(coefficients, 0, 1).reshape(2 * len(self.shifts), -1))

    def at(self, kappa: Array) -> tuple[Array, Array]:
        """(r, r) real symmetric stiffness and mass at the phases (2,)."""
        turns = self.shifts @ kappa
        return self._summed(np.cos(turns), np.sin(turns))

    def slope(self, kappa: Array, direction: int) -> tuple[Array, Array]:
        """Exact derivatives of stiffness and mass with respect to one phase."""
        turns, step = self.shifts @ kappa, self.shifts[:, direction]
        return self._summed(-step * np.sin(turns), step * np.cos(turns))

    def _summed(self, of_cosine: Array, of_sine: Array) -> tuple[Array, Array]:
        K, M = (np.concatenate([of_cosine, of_sine]) @ self._stack).reshape(2, self.size, self.size)
        return K, M
