"""Complex band structure: exact rods, and the bands of the pencil, which know nothing of faces."""

from functools import cache

import numpy as np
import pytest
from coarse import single
from hypothesis import given, settings, strategies as st
from rods import LAMINATE, SPEED, half_space, laminate, rod
from strategies import ALUMINIUM, reference_cell

from haptonic.bloch.centred import CentredPencil
from haptonic.bloch.evanescent import (
    FaceStiffness,
    Slab,
    bloch_waves,
    decibels,
    energy_flux,
)
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.rows import CondensedRows, attenuation
from haptonic.cell import MeshPlan, Pillar, UnitCell
from haptonic.lattice import Lattice
from haptonic.superelement import Tiling, condense

RECTANGULAR = UnitCell(Lattice.rectangular(8e-3, 6e-3), 2e-3, ALUMINIUM, Pillar(2.4e-3, 9e-3))
CELLS = {"square": (reference_cell(), (0, 1)), "rectangular": (RECTANGULAR, (1, 0))}
polarised = pytest.mark.parametrize("polarisation", SPEED)
KILOHERTZ = 2e3 * np.pi


@cache
def superelement(name: str):
    cell, _ = CELLS[name]
    return condense(cell, MeshPlan.suited(cell, 3, 1), measured=False)


def rows(name: str, along: tuple[int, int] | None = None) -> CondensedRows:
    return single(superelement(name), along or CELLS[name][1])


@cache
def slab(name: str, phase: float) -> Slab:
    return rows(name).slab(phase)


def waves(name: str, phase: float, omega: float):
    return bloch_waves(slab(name, phase).at(omega), omega)


@polarised
def test_a_laminate_has_the_attenuation_of_its_exact_dispersion(polarisation):
    expected = LAMINATE[polarisation]
    omega = 2 * np.pi * expected["mid"]
    right, left = bloch_waves(laminate(polarisation, omega), omega)
    assert -right.exponent[0].real == pytest.approx(expected["att_Np"], rel=1e-9)
    assert left.exponent[0].real == pytest.approx(expected["att_Np"], rel=1e-9)
    assert decibels(right) == pytest.approx(20 / np.log(10) * expected["att_Np"], rel=1e-9)
    edges = [2 * np.pi * f for name in ("Gamma", "X") for f in expected["edges"][name]]
    for edge in edges:  # on one side of an edge of a band a wave propagates, on the other none does
        sides = [bloch_waves(laminate(polarisation, at), at)[0] for at in edge * np.array([0.9999, 1.0001])]
        assert sum(side.propagates.any() for side in sides) == 1


@given(st.floats(0.1, 3.0), st.floats(0.1, 1.4), st.floats(0.1, 1.4))
def test_two_pieces_of_a_rod_make_a_longer_one(impedance, first, second):
    both = rod(impedance, 1.0, first, 1.0).followed_by(rod(impedance, 1.0, second, 1.0))
    whole = rod(impedance, 1.0, first + second, 1.0)
    for matrix, exact in zip(vars(both).values(), vars(whole).values(), strict=True):
        assert matrix == pytest.approx(exact, rel=1e-9, abs=1e-9 * impedance)


@given(st.floats(0.05, 3.0), st.floats(0.1, 10.0))
def test_a_rod_carries_one_wave_each_way(phase, impedance):
    right, left = bloch_waves(rod(impedance, 1.0, phase, 1.0), 1.0)
    assert np.exp(right.exponent) == pytest.approx([np.exp(-1j * phase)], abs=1e-9)
    assert np.exp(left.exponent) == pytest.approx([np.exp(1j * phase)], abs=1e-9)
    exact = half_space(impedance, 1.0, 1.0)
    for side, known in zip((right, left), exact, strict=True):
        assert side.impedance() == pytest.approx(known.impedance(), rel=1e-8)


@pytest.mark.parametrize("phase", [0.0, 0.9, -2.2, np.pi])
@pytest.mark.parametrize("kilohertz", [20.0, 45.0, 61.0, 90.0, 150.0])
@pytest.mark.parametrize("name", CELLS)
def test_a_wave_that_propagates_belongs_to_a_band(name, kilohertz, phase):
    omega = kilohertz * KILOHERTZ
    full = CentredPencil.of(Tiling.single(superelement(name)))
    for side in waves(name, phase, omega):
        for kappa in rows(name).rows.phases(phase, side.exponent[side.propagates].imag):
            bands = np.sqrt(np.abs(eigenpairs(full, kappa, 30)[0]))
            assert np.abs(bands / omega - 1).min() < 1e-9


@pytest.mark.parametrize(("along", "phase"), [(0.7, 0.0), (1.3, 0.8), (-2.0, 2.5), (3.0, np.pi)])
@pytest.mark.parametrize("name", CELLS)
def test_every_band_has_its_wave_which_goes_where_the_band_rises(name, along, phase):
    full = CentredPencil.of(Tiling.single(superelement(name)))
    across = along + np.array([-1e-4, 0.0, 1e-4])
    behind, bands, ahead = (
        np.sqrt(eigenpairs(full, kappa, 8)[0]) for kappa in rows(name).rows.phases(phase, across)
    )
    for omega, slope in zip(bands, ahead - behind, strict=True):
        right, left = waves(name, phase, float(omega))
        # time runs as exp(+i omega t): energy goes against the gradient of omega(kappa)
        factors = np.exp((left if slope > 0 else right).exponent)
        assert np.abs(factors - np.exp(1j * along)).min() < 1e-6


@settings(max_examples=8)
@given(phase=st.floats(-3.1, 3.1), kilohertz=st.floats(15.0, 160.0))
def test_waves_carry_unit_energies_independently_and_come_in_pairs(phase, kilohertz):
    omega = kilohertz * KILOHERTZ
    face = slab("square", phase).at(omega)
    right, left = bloch_waves(face, omega)
    assert len(right) == len(left) == face.size
    moving = [w.chosen(np.flatnonzero(w.propagates)) for w in (right, left)]
    u, f = (np.hstack([getattr(w, name) for w in moving]) for name in ("displacement", "force"))
    sign = np.repeat([1.0, -1.0], [len(w) for w in moving])
    assert np.abs(energy_flux(u, f, omega) - np.diag(sign)).max(initial=0.0) < 1e-6
    # lambda and 1 / conj(lambda) without losses, where rounding leaves anything of lambda
    size = [np.sort(np.abs(w.exponent.real))[:20] for w in (right, left)]
    assert size[0] == pytest.approx(size[1], rel=1e-6, abs=1e-7)


def test_waves_with_the_same_multiplier_are_separated_by_energy_flux():
    single = rod(2.0, 1.0, 0.7, 1.0)
    mixed = np.linalg.qr(np.random.default_rng(3).standard_normal((3, 3)))[0]
    three = FaceStiffness(*(mixed @ np.kron(np.eye(3), block) @ mixed.T for block in vars(single).values()))
    for side, sign in zip(bloch_waves(three, 1.0), (1, -1), strict=True):
        power = energy_flux(side.displacement, side.force, 1.0)
        assert power == pytest.approx(sign * np.eye(3), abs=1e-9)


@settings(max_examples=5)
@given(phase=st.floats(-3.1, 3.1), kilohertz=st.floats(15.0, 160.0))
def test_the_forces_are_those_of_the_slab(phase, kilohertz):
    omega = kilohertz * KILOHERTZ
    face = slab("square", phase).at(omega)
    scale = np.abs(face.LL).max()
    for side, far in zip(bloch_waves(face, omega), (1, -1), strict=True):
        u, step = side.displacement, np.exp(side.exponent * far)  # decays, whichever side it goes to
        here, there = (face.LL, face.LR) if far > 0 else (face.RR, face.RL)
        assert np.abs(here @ u + (there @ u) * step - far * side.force).max() < 1e-9 * scale * np.abs(u).max()
        balance = face.RL @ u + (face.LL + face.RR) @ u * step + face.LR @ u * step**2
        opposite = face.LR @ u + (face.LL + face.RR) @ u * step + face.RL @ u * step**2
        left = balance if far > 0 else opposite
        assert np.abs(left).max() < 1e-9 * scale * np.abs(u).max()


def test_the_gap_of_the_reference_cell_attenuates_and_its_bands_do_not():
    omega, phases = np.array([45.0, 56.0, 59.0, 61.5]) * KILOHERTZ, np.array([0.0, -0.7, 0.7, 2.75])
    decay = attenuation(rows("square"), omega, phases)
    assert decay.shape == (4, 4)
    assert (decay[1:3] > 1.0).all()
    assert decay[0] == pytest.approx(np.zeros(4))
    assert decay[3, 0] == 0.0
    assert decay[:, 1] == pytest.approx(decay[:, 2], rel=1e-6)  # the mirror along the faces
    other = attenuation(rows("square", (1, 0)), omega, phases)
    assert other == pytest.approx(decay, rel=2e-3)  # interiors are not quite the same along both axes
    lossy = attenuation(rows("square"), omega, phases, loss_factor=1e-3)
    assert (lossy > 0).all()
    assert lossy[1:3] == pytest.approx(decay[1:3], rel=1e-2)


def test_attenuation_is_along_the_translation_that_was_asked_for():
    omega, phase, decays = 20.0 * KILOHERTZ, 2.5, []
    for along in ((0, 1), (1, 0)):
        here = rows("rectangular", along)
        right, _ = bloch_waves(here.slab(phase).at(omega), omega)
        decays.append(attenuation(here, np.array([omega]), np.array([phase])))
        assert decays[-1].item() == pytest.approx(decibels(right), rel=1e-9)
    assert decays[0] > 1.1 * decays[1] > 0


def test_a_slab_has_the_pencil_in_it():
    phase, kappa, omega = 0.8, 1.7, 40.0 * KILOHERTZ
    face = slab("square", phase).at(omega)
    turn = np.exp(1j * kappa)
    folded = face.LL + face.RR + face.LR * turn + face.RL / turn
    assert np.abs(folded - folded.conj().T).max() < 1e-10 * np.abs(folded).max()
    # one face at rest and no forces: eliminating unknowns keeps the number of frequencies passed, but for
    # those of the eliminated ones alone (Wittrick and Williams 1971)
    K, M = CentredPencil.of(Tiling.single(superelement("square"))).at(np.array([kappa, phase]))
    passed = int((np.linalg.eigvalsh(K - omega**2 * M) < 0).sum())
    own = slab("square", phase)
    inner = np.arange(2 * own.size, len(own.mass))
    modes = np.diag(own.poles - omega**2)
    between = (own.stiffness - omega**2 * own.mass)[np.ix_(inner, inner)]
    side = -(omega**2) * own.coupling[inner]
    still = np.block([[between, side], [side.conj().T, modes]])
    alone = int((np.linalg.eigvalsh(still) < 0).sum())
    assert passed == int((np.linalg.eigvalsh(folded) < 0).sum()) + alone
