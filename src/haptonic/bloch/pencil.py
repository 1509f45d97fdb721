"""Bloch pencil: stiffness and mass of a period, from which all periodic problems are solved.

Conventions of the whole program. Space: ``exp(+i k . r)``, so a Bloch field obeys
``u(r + m a1 + n a2) = exp(i (m kappa_1 + n kappa_2)) u(r)`` with the phases ``kappa_j = k . a_j``.
Time: ``exp(+i omega t)``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

import numpy as np

from haptonic.arrays import Array, Complex, Fields, Ints
from haptonic.later import linalg as la
from haptonic.superelement import Joint, Tiling, definite
from haptonic.superelement.interior import orthonormal_beside


@dataclass(frozen=True)
class Pencil:
    """Laurent polynomials ``sum_mn A_mn exp(i (m kappa_1 + n kappa_2))`` for stiffness and mass.

    Only one of each pair (m, n), (-m, -n) is stored, since ``A_-m,-n = A_m,n^T``; (0, 0) comes first.

    shifts : (s, 2) integers
    stiffness, mass : (s, n, n) real blocks
    """

    shifts: Ints
    stiffness: Array
    mass: Array

    @property
    def size(self) -> int:
        return int(self.stiffness.shape[1])

    def at(self, kappa: Array) -> tuple[Complex, Complex]:
        """(n, n) Hermitian stiffness and mass at the phases (2,)."""
        K, M = (real + 1j * imaginary for real, imaginary in self.components(kappa))
        return K, M

    def slopes(self, kappa: Array) -> list[tuple[Complex, Complex]]:
        """Exact derivatives of stiffness and mass with respect to each phase."""
        slopes = []
        for step in self.shifts[1:].T:
            factor = 1j * step * np.exp(1j * (self.shifts[1:] @ kappa))
            K, M = (_halves(blocks, factor) for blocks in (self.stiffness, self.mass))
            slopes.append((K[0] + 1j * K[1], M[0] + 1j * M[1]))
        return slopes

    def components(self, kappa: Array) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        """(n, n) real and imaginary parts of stiffness and of mass at the phases (2,)."""
        factor = np.exp(1j * (self.shifts[1:] @ kappa))
        K, M = (_halves(blocks, factor) for blocks in (self.stiffness, self.mass))
        return (K[0] + self.stiffness[0], K[1]), (M[0] + self.mass[0], M[1])


def _halves(blocks: Array, factor: Complex) -> tuple[Array, Array]:
    """(n, n) real and imaginary parts of ``sum_s factor_s A_s`` plus its adjoint, without A_0.

    Products of real arrays take a quarter of the time of complex ones, for which NumPy copies the blocks.
    """
    size = blocks.shape[1]
    real, imaginary = (
        (weight @ blocks[1:].reshape(len(factor), -1)).reshape(size, size)
        for weight in (factor.real, factor.imag)
    )
    return real + real.T, imaginary - imaginary.T


@dataclass(frozen=True)
class Periodic:
    """Unknowns of a tiling as free unknowns of its lattice times phase factors.

    free : (n,) numbers of the free unknowns among all; number : (t + m,) free unknown of each unknown
    shift : (t + m, d) integer translation from the free unknown to this one
    """

    free: Ints
    number: Ints
    shift: Ints

    @classmethod
    def of(cls, tiling: Tiling) -> Periodic:
        return cls.of_joint(tiling.joint, tiling.size - tiling.trace_size)

    @classmethod
    def of_joint(cls, joint: Joint, modes: int = 0) -> Periodic:
        """Find the free unknowns of traces, followed by a number of modes, which are free."""
        master = joint.unknowns[:, joint.master]
        source = np.arange(joint.size + modes)
        shift = np.zeros((len(source), joint.shift.shape[1]), dtype=np.int64)
        source[joint.unknowns] = master
        shift[joint.unknowns] = joint.shift[:, None]
        free, number = np.unique(source, return_inverse=True)
        return cls(free, number, shift)

    def expanded(self, fields: Complex, kappa: Array) -> Complex:
        """(t + m, k) unknowns of one cell from the free ones (n, k)."""
        return np.asarray(fields[self.number] * np.exp(1j * (self.shift @ kappa))[:, None])

    def hermitian(self, form: Array, kappa: Array) -> Complex:
        """``P(kappa)* form P(kappa)`` on the free unknowns."""
        spread = np.zeros((len(self.number), len(self.free)), dtype=complex)
        spread[np.arange(len(self.number)), self.number] = np.exp(1j * (self.shift @ kappa))
        return np.asarray(spread.conj().T @ form @ spread)

    def pencil_blocks(self, form: Array) -> dict[tuple[int, int], Array]:
        """Blocks of ``P(kappa)* form P(kappa)``, one of each pair of opposite shifts."""
        blocks: dict[tuple[int, int], Array] = {(0, 0): np.zeros((len(self.free),) * 2)}
        groups = {
            tuple(s): np.flatnonzero((self.shift == s).all(axis=1)) for s in np.unique(self.shift, axis=0)
        }
        # sides within a cell identify several unknowns
        several = any(len(np.unique(self.number[rows])) < len(rows) for rows in groups.values())
        for s, rows in groups.items():
            for t, columns in groups.items():
                step = (int(t[0] - s[0]), int(t[1] - s[1]))
                if step < (0, 0):
                    continue  # the transpose of its opposite
                block = blocks.setdefault(step, np.zeros((len(self.free),) * 2))
                there = np.ix_(self.number[rows], self.number[columns])
                if several:  # np.add.at is slower
                    np.add.at(block, there, form[np.ix_(rows, columns)])
                else:
                    block[there] += form[np.ix_(rows, columns)]
        return blocks


def bloch_pencil(tiling: Tiling) -> Pencil:
    """Make the pencil of an infinitely repeated tiling."""
    periodic = Periodic.of(tiling)
    stiffness, mass = (periodic.pencil_blocks(form) for form in (tiling.stiffness, tiling.mass))
    return Pencil(
        shifts=np.array(list(stiffness)),
        stiffness=np.stack(list(stiffness.values())),
        mass=np.stack([mass[step] for step in stiffness]),
    )


class Evaluated(Protocol):
    """Pencil with Hermitian, or real symmetric, stiffness and mass at any wavevector."""

    @property
    def size(self) -> int: ...

    def at(self, kappa: Array, /) -> tuple[Fields, Fields]: ...


class OfTiling(Evaluated, Protocol):
    """Pencil of the unknowns of a tiling."""

    def fields(self, modes: Fields, kappa: Array, /) -> Complex: ...


class Derived(Evaluated, Protocol):
    """Pencil with derivatives with respect to the phases."""

    def slopes(self, kappa: Array, /) -> list[tuple[Fields, Fields]]: ...


AnyPencil = TypeVar("AnyPencil", bound=Evaluated, covariant=True)


@dataclass(frozen=True)
class SplitPencil(Generic[AnyPencil]):
    """Pencil of a cell that is its own image in the plate's middle plane.

    Symmetric and antisymmetric motions are not coupled.

    parts : pencils of symmetric and of antisymmetric motions; their unknowns follow each other
    """

    parts: tuple[AnyPencil, AnyPencil]

    @property
    def size(self) -> int:
        return sum(part.size for part in self.parts)

    def at(self, kappa: Array) -> tuple[Fields, Fields]:
        """(n, n) stiffness and mass at the phases (2,)."""
        return self._whole([part.at(kappa) for part in self.parts])

    def slopes(self: SplitPencil[Derived], kappa: Array) -> list[tuple[Fields, Fields]]:
        """Exact derivatives of stiffness and mass with respect to each phase."""
        of_parts = [part.slopes(kappa) for part in self.parts]
        return [self._whole(list(of_phase)) for of_phase in zip(*of_parts, strict=True)]

    def fields(self: SplitPencil[OfTiling], modes: Fields, kappa: Array) -> Complex:
        """(t + m, k) unknowns of the tiling from modes (n, k)."""
        symmetric, antisymmetric = self.split(modes)
        return self.parts[0].fields(symmetric, kappa) + self.parts[1].fields(antisymmetric, kappa)

    def split(self, modes: Fields) -> tuple[Fields, Fields]:
        """Symmetric and antisymmetric share of modes (n, k)."""
        first = self.parts[0].size
        return modes[:first], modes[first:]

    def parity(self, modes: Fields) -> Ints:
        """(k,) parity of modes (n, k): +1 symmetric, -1 antisymmetric."""
        symmetric, antisymmetric = (np.abs(share).max(axis=0) for share in self.split(modes))
        return np.where(symmetric > antisymmetric, 1, -1)

    @staticmethod
    def _whole(forms: list[tuple[Fields, Fields]]) -> tuple[Fields, Fields]:
        K, M = (la.block_diag(*of_parts) for of_parts in zip(*forms, strict=True))
        return K, M


# Share of the traces' ratio. The rounding error of an eigenvalue x is proportional to (x + shift)^2 / shift,
# so the shift lies amid the range needed, from rest to a tenth of that ratio. With 1e-12, bands 7 to 20 had
# errors of 2e-5 at rest.
SHIFT = 1e-8
MOST_BLOCKS, SPARE = 12, 8  # blocks, of which 7 or 8 are needed; their directions beyond the wanted modes
# With this number of unknowns for each direction of a block a Krylov space is faster than LAPACK: for
# 13 modes of 1200 complex unknowns 0.2 s instead of 0.5 s, of 2400 0.8 s instead of 3.8 s. For 28 modes of
# 900 both take equally long, and for 63 modes of 1200 LAPACK takes 0.5 s instead of 0.9 s.
PER_DIRECTION = 40
CONVERGED = 1e-10  # residual as a share of an eigenvalue, which then has an error of about its square
# Residual as a share of the largest eigenvalue, below which rounding is all of it. At rest that eigenvalue is
# 10^5 to 10^6 times the others, and residuals of these reach 0.3 to 1 rounding unit of it.
ROUNDED = 10 * np.finfo(float).eps


@definite()
def hertz(values: Array) -> Array:
    """Frequencies, Hz, from eigenvalues omega^2, which rounding may make slightly negative."""
    return np.sqrt(np.maximum(values, 0.0)) / (2 * np.pi)


def change_in_hertz(change: Array, frequency: Array) -> Array:
    """Changes of frequencies, Hz, from those of eigenvalues, (rad/s)^2, to first order."""
    return np.asarray(change / (8 * np.pi**2 * frequency))


def error_in_hertz(missing: Array, frequency: Array, rounding: float = 0.0) -> Array:
    """Errors of frequencies f, Hz, from energies (2 pi)^2 e that a mesh lacks, (rad/s)^2.

    The fields that a mesh lacks do no work on those that it has. Under the same forces, the energy f^2 of a
    mode would be larger by e, and its amplitude by as much, so the exact frequency is
    ``f / sqrt(1 + e / f^2)``. Rounding may make energies slightly negative; then it is larger.

    rounding : error of f^2 itself, (rad/s)^2; with it, the frequency may be 0
    """
    lacking, rounded = np.abs(missing) / (2 * np.pi) ** 2, rounding / (2 * np.pi) ** 2
    square = frequency**2
    # differences of squares over sums, because most errors are far smaller than their frequencies
    share = np.divide(lacking, square + lacking, where=lacking > 0, out=np.zeros_like(square))
    fall = square * share + rounded
    least = np.sqrt(np.maximum(square - fall, 0.0))
    below = np.divide(fall, frequency + least, where=least > 0, out=np.array(frequency, dtype=float))
    most = np.sqrt(square + lacking + rounded)
    above = np.divide(lacking + rounded, most + frequency, where=most > 0, out=np.zeros_like(most))
    return np.asarray(np.maximum(below, above))


def eigenpairs(pencil: Evaluated, kappa: Array, count: int) -> tuple[Array, Fields]:
    """Compute the ``count`` lowest eigenvalues omega^2, (rad/s)^2, and modes (n, count) of unit mass.

    Modes are real if the pencil is real, and of one parity if it is split. NumericalError is raised if
    rounding leaves a negative stiffness.

    The ratio of the highest eigenvalue to the lowest ones grows as the fourth power of pitch over thickness.
    The error of an eigensolver is rounding times its largest eigenvalue; with ``1 / (omega^2 + shift)`` the
    largest ones are the wanted ones.
    """
    if isinstance(pencil, SplitPencil):
        values, modes = zip(*(eigenpairs(part, kappa, count) for part in pencil.parts), strict=True)
        lowest = np.argsort(np.concatenate(values), kind="stable")[:count]
        return np.concatenate(values)[lowest], la.block_diag(*modes)[:, lowest]
    K, M = pencil.at(kappa)
    shift = SHIFT * float(np.trace(K).real / np.trace(M).real)
    shifted = K + shift * M
    is_large = pencil.size >= PER_DIRECTION * (count + SPARE)
    pairs = largest_pairs(M, shifted, count) if is_large else None
    ascending, shapes = pairs or _pairs_of_lapack(M, shifted, count)
    inverse = ascending[::-1]
    return 1 / inverse - shift, shapes[:, ::-1] / np.sqrt(inverse)


def _pairs_of_lapack(mass: Fields, stiffness: Fields, count: int) -> tuple[Array, Fields]:
    """Compute the pairs of `largest_pairs` with LAPACK, which transforms the whole matrices."""
    subset = max(len(mass) - count, 0), len(mass) - 1
    values, modes = la.eigh(mass, stiffness, subset_by_index=subset, check_finite=False)
    return values, modes


def largest_pairs(mass: Fields, stiffness: Fields, count: int) -> tuple[Array, Fields] | None:
    """Compute the ``count`` largest eigenvalues of ``M x = t K x`` and modes (n, count) with ``x* K x = 1``.

    Both ascend, as those of LAPACK. With ``K = L L*`` the fields ``L* x`` are Ritz vectors of
    ``L^-1 M L^-*`` on a block Krylov space; multiple eigenvalues need blocks of as many directions. None if
    the space does not converge.
    """
    factor = la.cholesky(stiffness, lower=True, check_finite=False)

    def solve(fields: Fields, trans: str) -> Fields:
        solution = la.solve_triangular(factor, fields, trans=trans, lower=True, check_finite=False)
        return np.asarray(solution)

    def applied(fields: Fields) -> Fields:
        return solve(mass @ solve(fields, "C"), "N")

    start = np.random.default_rng(0).standard_normal((len(mass), count + SPARE)).astype(mass.dtype)
    new = applied(start)
    blocks, answers = list[Fields](), list[Fields]()
    for _ in range(MOST_BLOCKS):
        blocks.append(orthonormal_beside(blocks, new))
        new = applied(blocks[-1])
        answers.append(new)
        basis, moved = np.hstack(blocks), np.hstack(answers)
        values, turn = la.eigh(basis.conj().T @ moved)
        values, turn = values[-count:], turn[:, -count:]
        fields = basis @ turn
        residual = np.linalg.norm(moved @ turn - fields * values, axis=0)
        if (residual <= CONVERGED * values + ROUNDED * values[-1]).all():
            return values, solve(fields, "C")
    return None
