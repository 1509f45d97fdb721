"""The Bloch pencil: what every Laurent polynomial of a lattice must obey."""

from functools import cache

import numpy as np
import pytest
import scipy.linalg as la
from hypothesis import given, settings, strategies as st
from strategies import ALUMINIUM, reference_cell

from haptonic.bloch.pencil import Pencil, Periodic, bloch_pencil, eigenpairs, error_in_hertz, largest_pairs
from haptonic.cell import MeshPlan, Pillar, UnitCell
from haptonic.lattice import Lattice
from haptonic.superelement import Tiling, condense

phases = st.tuples(st.floats(-4, 4), st.floats(-4, 4)).map(np.array)
seeds = st.integers(0, 2**32 - 1)
SHIFTS = np.array([(0, 0), (0, 1), (1, -1), (1, 0), (1, 1)])


def random_pencil(seed: int, size: int = 7) -> Pencil:
    rng = np.random.default_rng(seed)
    stiffness, mass = rng.standard_normal((2, len(SHIFTS), size, size))
    stiffness[0] += stiffness[0].T.copy()
    mass[0] += mass[0].T.copy() + 40 * np.eye(size)
    return Pencil(SHIFTS, stiffness, mass)


RECTANGULAR = UnitCell(Lattice.rectangular(8e-3, 6e-3), 2e-3, ALUMINIUM, Pillar(2.4e-3, 9e-3))


@cache
def condensed(name: str):
    if name == "square":
        return condense(reference_cell(), MeshPlan(2, 1, 2), measured=False)
    return condense(RECTANGULAR, MeshPlan(2, 0, 2), measured=False)


@cache
def finer(name: str):
    cell = reference_cell() if name == "square" else RECTANGULAR
    return condense(cell, MeshPlan(4, 0, 3), measured=False)


physical = pytest.mark.parametrize("name", ["square", "rectangular"])


@given(seeds, phases)
def test_random_pencils_are_hermitian_and_periodic(seed, kappa):
    pencil = random_pencil(seed)
    for here, there in zip(pencil.at(kappa), pencil.at(kappa + 2 * np.pi * np.array([1, -2])), strict=True):
        assert np.array_equal(here, here.conj().T)
        assert there == pytest.approx(here, abs=1e-12)
    K, _ = pencil.at(kappa)
    whole = sum(
        np.exp(1j * sign * (shift @ kappa)) * (block if sign > 0 else block.T)
        for shift, block in zip(SHIFTS[1:], pencil.stiffness[1:], strict=True)
        for sign in (1, -1)
    )
    assert np.abs(whole + pencil.stiffness[0] - K).max() < 1e-12 * np.abs(K).max()


@given(seeds, phases, st.integers(0, 1))
def test_slope_against_differences(seed, kappa, direction):
    pencil = random_pencil(seed)
    step = 1e-5 * np.eye(2)[direction]
    for exact, ahead, behind in zip(
        pencil.slopes(kappa)[direction], pencil.at(kappa + step), pencil.at(kappa - step), strict=True
    ):
        assert exact == pytest.approx((ahead - behind) / 2e-5, abs=1e-8)
        assert np.array_equal(exact, exact.conj().T)


@physical
@settings(max_examples=10)
@given(kappa=phases)
def test_the_pencil_of_a_cell_is_its_matrices_between_bloch_fields(name, kappa):
    superelement = condensed(name)
    pencil, periodic = bloch_pencil(Tiling.single(superelement)), Periodic.of(Tiling.single(superelement))
    P = periodic.expanded(np.eye(pencil.size), kappa)
    K, M = pencil.at(kappa)
    for small, large in ((K, superelement.stiffness), (M, superelement.mass)):
        assert np.abs(small - P.conj().T @ large @ P).max() < 1e-12 * np.abs(large).max()
    assert np.abs(periodic.hermitian(superelement.stiffness, kappa) - K).max() < 1e-12 * np.abs(K).max()
    np.linalg.cholesky(M)  # positive definite at every wavevector


@physical
def test_blocks_reach_the_eight_neighbours_at_most_and_one_of_each_pair_is_kept(name):
    pencil = bloch_pencil(Tiling.single(condensed(name)))
    shifts = [tuple(s) for s in pencil.shifts.tolist()]
    assert shifts[0] == (0, 0)
    assert set(shifts) == {(0, 0), (0, 1), (1, -1), (1, 0), (1, 1)}
    assert np.abs(pencil.stiffness[0] - pencil.stiffness[0].T).max() < 1e-12 * np.abs(pencil.stiffness).max()


@physical
@pytest.mark.parametrize("point", [(0, 0), (1, 0), (0, 1), (1, 1)])
def test_the_pencil_is_real_where_minus_k_is_k(name, point):
    for matrix in bloch_pencil(Tiling.single(condensed(name))).at(np.pi * np.array(point)):
        assert np.abs(matrix.imag).max() < 1e-12 * np.abs(matrix).max()


@physical
@settings(max_examples=10)
@given(kappa=phases)
def test_waves_run_both_ways_and_repeat_with_the_reciprocal_lattice(name, kappa):
    pencil = bloch_pencil(Tiling.single(condensed(name)))
    values = eigenpairs(pencil, kappa, 8)[0]
    for same in (-kappa, kappa + 2 * np.pi * np.array([1, -1]), kappa * [1, -1], kappa * [-1, 1]):
        assert eigenpairs(pencil, same, 8)[0] == pytest.approx(values, rel=1e-8, abs=1e-8 * values[-1])


@settings(max_examples=10)
@given(kappa=phases)
def test_the_square_cell_looks_the_same_along_both_axes(kappa):
    pencil = bloch_pencil(Tiling.single(condensed("square")))
    values = eigenpairs(pencil, kappa, 6)[0]
    # the interior's Krylov space is not built to have the diagonal's symmetry
    assert eigenpairs(pencil, kappa[::-1], 6)[0] == pytest.approx(values, rel=1e-4, abs=1e-8 * values[-1])


@physical
def test_eigenpairs_have_unit_mass_and_no_residual(name):
    pencil = bloch_pencil(Tiling.single(condensed(name)))
    kappa = np.array([0.7, 1.9])
    K, M = pencil.at(kappa)
    values, modes = eigenpairs(pencil, kappa, 5)
    assert (np.diff(values) >= 0).all()
    assert modes.conj().T @ M @ modes == pytest.approx(np.eye(5), abs=1e-10)
    assert np.abs(K @ modes - M @ modes * values).max() < 1e-9 * np.abs(K @ modes).max()
    assert len(eigenpairs(Graded(1.0), kappa, 100)[0]) == Graded.size  # no more than there are


class Graded:
    """K = D A D with A = tridiag(-1, 2, -1), whose inverse is known, D over some powers of ten; M = 1."""

    size = 40

    def __init__(self, powers: float) -> None:
        self.scale = 10.0 ** np.linspace(0, powers, self.size)

    def at(self, _kappa):
        A = 2 * np.eye(self.size) - np.eye(self.size, k=1) - np.eye(self.size, k=-1)
        return self.scale[:, None] * A * self.scale, np.eye(self.size)

    def inverse(self):
        n, i = self.size, np.arange(1, self.size + 1)
        low, high = np.minimum.outer(i, i), np.maximum.outer(i, i)
        return low * (n + 1 - high) / (n + 1) / np.outer(self.scale, self.scale)


@given(st.floats(0.0, 6.5), st.integers(1, 5))
def test_low_eigenvalues_keep_their_digits_below_very_high_ones(powers, count):
    """A thin plate's highest eigenvalue is 10^13 times its lowest; a solver must not work with it."""
    pencil = Graded(powers)
    values, modes = eigenpairs(pencil, np.zeros(2), count)
    exact = 1 / np.linalg.eigvalsh(pencil.inverse())[::-1][:count]
    assert values == pytest.approx(exact, rel=1e-8)
    assert modes.T @ modes == pytest.approx(np.eye(count), abs=1e-6)


@physical
@pytest.mark.parametrize("kappa", [(0.0, 0.0), (np.pi, np.pi), (np.pi, 0.0), (0.7, 0.3)])
def test_a_krylov_space_has_the_modes_of_lapack(name, kappa):
    """At rest three modes have the frequency 0, at a corner of the square zone frequencies are double."""
    K, M = bloch_pencil(Tiling.single(finer(name))).at(np.array(kappa))
    K = K + 1e-8 * np.trace(K).real / np.trace(M).real * M
    count = 8
    values, modes = largest_pairs(M, K, count)
    assert values == pytest.approx(la.eigh(M, K, eigvals_only=True)[-count:], rel=1e-12)
    assert modes.conj().T @ K @ modes == pytest.approx(np.eye(count), abs=1e-7)
    assert np.abs(M @ modes - K @ modes * values).max() < 1e-7 * np.abs(M @ modes).max()


def test_errors_of_modes_at_rest_are_finite():
    energy = np.array([0.0, -4e-2, 4e-2, 1e6, -1e6])
    error = error_in_hertz(energy, np.array([0.0, 0.0, 0.0, 1e4, 1e4]))
    at_rest = np.sqrt(4e-2) / (2 * np.pi)  # root of the energy
    lost = np.sqrt(1e8 + 1e6 / (2 * np.pi) ** 2) - 1e4
    assert error == pytest.approx([0.0, at_rest, at_rest, lost, lost])


def test_a_mode_that_lacks_as_much_energy_as_it_has_does_not_fall_to_zero():
    """A bar between two springs: under one force, its energy doubles with a part that the mesh lacks."""
    stiff, lacking = 3.0, 3.0
    whole = 1 / (1 / stiff + 1 / lacking)  # N/m, in series
    exact, frequency = np.sqrt(np.array([whole, stiff])) / (2 * np.pi)
    error = error_in_hertz(np.array([stiff]), np.array([frequency]))
    assert frequency - exact <= error < 0.5 * frequency


def test_the_error_of_a_mode_that_may_be_at_rest_reaches_down_to_zero():
    frequency = np.array([0.041, 0.0418, 0.0451])
    error = error_in_hertz(np.zeros(3), frequency, rounding=(2 * np.pi * 0.0451) ** 2)
    assert error == pytest.approx(frequency)
