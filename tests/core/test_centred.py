"""The real pencil seen from the cell's centre, against the Laurent pencil that it represents."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from strategies import ALUMINIUM, reference_cell

from haptonic.bloch import Resolution
from haptonic.bloch.centred import CentredPencil, PhasedPencil, lattice_pencil
from haptonic.bloch.pencil import Periodic, SplitPencil, bloch_pencil, eigenpairs
from haptonic.cell import Disc, MeshPlan, Pillar, UnitCell
from haptonic.lattice import Lattice
from haptonic.superelement import Tiling, condense

phases = st.tuples(st.floats(-4, 4), st.floats(-4, 4)).map(np.array)
RECTANGULAR = UnitCell(Lattice.rectangular(8e-3, 6e-3), 2e-3, ALUMINIUM, Pillar(2.4e-3, 9e-3))
# the half-turn maps a pillar of the honeycomb to one of another period
HONEYCOMB = UnitCell(Lattice("honeycomb", 8e-3), 2e-3, ALUMINIUM, Pillar(2.4e-3, 3e-3))
CELLS = {
    "square": (reference_cell(), MeshPlan(2, 1, 2)),
    "rectangular": (RECTANGULAR, MeshPlan(3, 0, 2)),
    "honeycomb": (HONEYCOMB, Resolution(2, 0).plans(HONEYCOMB)[0]),
}
both = pytest.mark.parametrize("name", CELLS)
SQUARE = Lattice.square(7e-3)
HOLES = {
    "round hole": UnitCell(SQUARE, 1e-3, ALUMINIUM, disc=(Disc(4e-3, empty=True),)),
    "triangular hole": UnitCell(
        SQUARE, 1e-3, ALUMINIUM, disc=(Disc(2e-3, empty=True, section="polygon", sides=3),)
    ),
}


@cache
def tiling(name):
    cell, plan = CELLS[name] if name in CELLS else (HOLES[name], Resolution(3, 0).plan(HOLES[name]))
    tiles = [condense(tile.tile, plan, measured=False) for tile in cell.tiles]
    return Tiling.of(cell, cell.tiles, tiles)


@cache
def pencils(name):
    return bloch_pencil(tiling(name)), CentredPencil.of(tiling(name))


@both
@settings(max_examples=10)
@given(kappa=phases)
def test_it_has_the_eigenvalues_of_the_laurent_pencil_and_its_modes(name, kappa):
    laurent, centred = pencils(name)
    values, modes = eigenpairs(centred, kappa, 8)
    assert modes.dtype == float
    assert values == pytest.approx(eigenpairs(laurent, kappa, 8)[0], rel=1e-8, abs=1e-9 * values[-1])
    K, M = laurent.at(kappa)
    fields = centred.fields(modes, kappa)[Periodic.of(tiling(name)).free]
    assert np.abs(K @ fields - M @ fields * values).max() < 1e-9 * np.abs(K @ fields).max()
    assert fields.conj().T @ M @ fields == pytest.approx(np.eye(8), abs=1e-9)


@both
@settings(max_examples=10)
@given(kappa=phases)
def test_the_real_part_is_all_there_is(name, kappa):
    _, centred = pencils(name)
    for A in super(CentredPencil, centred).at(kappa):
        assert np.abs(A.imag).max() < 1e-12 * np.abs(A).max()


@both
@settings(max_examples=10)
@given(kappa=phases, seed=st.integers(0, 100))
def test_projection_commutes_with_evaluation(name, kappa, seed):
    _, centred = pencils(name)
    basis = np.random.default_rng(seed).standard_normal((centred.size, 6))
    projected = centred.projected(basis)
    assert projected.size == 6
    for small, large in zip(projected.at(kappa), centred.at(kappa), strict=True):
        assert np.abs(small - basis.T @ large @ basis).max() < 1e-11 * np.abs(small).max()
        assert np.array_equal(small, small.T) or np.abs(small - small.T).max() < 1e-12 * np.abs(small).max()


@both
@pytest.mark.parametrize("direction", [0, 1])
def test_slopes_of_the_projected_pencil_against_differences(name, direction):
    _, centred = pencils(name)
    small = centred.projected(np.random.default_rng(1).standard_normal((centred.size, 5)))
    kappa, step = np.array([0.7, -1.1]), 1e-5 * np.eye(2)[direction]
    for exact, ahead, behind in zip(
        small.slopes(kappa)[direction], small.at(kappa + step), small.at(kappa - step), strict=True
    ):
        assert np.abs(exact - (ahead - behind) / 2e-5).max() < 1e-8 * np.abs(ahead).max()


@both
@pytest.mark.parametrize("towards", [(1.0, 0.0), (0.8, 0.6), (0.0, 1.0)])
def test_long_waves_need_no_more_than_the_derivatives_of_translations(name, towards):
    """The error of the twelve vectors falls with the square of the wavevector, for every one of the three."""
    laurent, centred = pencils(name)
    small = centred.projected(centred.near_rest())
    lost = []
    for length in (0.2, 0.1):
        kappa = length * np.array(towards)
        lost.append(eigenpairs(small, kappa, 3)[0] / eigenpairs(laurent, kappa, 3)[0] - 1)
    assert (lost[0] > 0).all()
    assert (lost[1] < lost[0] / 3).all()
    # without second derivatives the flexural wave stays too stiff, however long it is
    without = centred.projected(centred.near_rest()[:, :9])
    kappa = 0.1 * np.array(towards)
    excess = eigenpairs(without, kappa, 1)[0] / eigenpairs(laurent, kappa, 1)[0] - 1
    assert excess > 10 * lost[1][0]


@pytest.mark.parametrize("name", HOLES)
@settings(max_examples=5, deadline=None)
@given(kappa=phases)
def test_symmetric_and_antisymmetric_modes_together_are_those_of_the_laurent_pencil(name, kappa):
    laurent, split = bloch_pencil(tiling(name)), lattice_pencil(tiling(name))
    assert isinstance(split, SplitPencil)
    assert {type(part) for part in split.parts} == {CentredPencil if name == "round hole" else PhasedPencil}
    assert split.size == laurent.size
    values, modes = eigenpairs(split, kappa, 8)
    assert values == pytest.approx(eigenpairs(laurent, kappa, 8)[0], rel=1e-8, abs=1e-9 * values[-1])
    K, M = laurent.at(kappa)
    fields = split.fields(modes, kappa)[Periodic.of(tiling(name)).free]
    assert np.abs(K @ fields - M @ fields * values).max() < 1e-8 * np.abs(K @ fields).max()
    assert fields.conj().T @ M @ fields == pytest.approx(np.eye(8), abs=1e-8)


@pytest.mark.parametrize("name", HOLES)
@settings(max_examples=5, deadline=None)
@given(kappa=phases)
def test_other_forms_of_the_tiling_are_projected_like_its_mass(name, kappa):
    own = tiling(name)
    for part in lattice_pencil(own).parts:
        basis = np.random.default_rng(part.size).standard_normal((part.size, 5))
        expected = basis.T @ part.at(kappa)[1] @ basis
        for projected in (part.projected(basis), part.projected(basis, (own.stiffness, own.mass))):
            assert np.abs(projected.at(kappa)[1] - expected).max() < 1e-11 * np.abs(expected).max()
