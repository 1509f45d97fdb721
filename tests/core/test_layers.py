"""Layers between plain plates: exact laminates, conservation, reciprocity, limits of few and many layers."""

from functools import cache
from itertools import islice

import numpy as np
import pytest
from coarse import lattice, rows as coarse_rows, single
from hypothesis import given, settings, strategies as st
from rods import LAMINATE, SPEED, half_space, laminate, medium, rod
from strategies import ALUMINIUM, reference_cell

from five_parts import refusing
from haptonic.bloch.evanescent import bloch_waves, decibels
from haptonic.bloch.layers import OUTGOING, Interface, reflected_by, scattered, stacked
from haptonic.bloch.plate_waves import FAMILIES
from haptonic.bloch.rows import CondensedRows
from haptonic.cell import MeshPlan, Pillar, UnitCell
from haptonic.errors import StudyError
from haptonic.lattice import Lattice
from haptonic.materials import OrthotropicMaterial
from haptonic.superelement import condense

KILOHERTZ = 2e3 * np.pi
OBLIQUE = 0.25 / 7e-3  # rad/m: at 40 kHz and above all three families propagate
SQUARE = Lattice.square(7e-3)


def turned_silicon(degrees):
    return OrthotropicMaterial(c11=166e9, c12=64e9, c44=80e9, density=2330.0, turn=np.radians(degrees))


CELLS = {
    "plain": reference_cell().without_pillar(),
    "wide": UnitCell(Lattice.rectangular(8e-3, 6e-3), 2e-3, ALUMINIUM, Pillar(2.4e-3, 9e-3)),
    "turned crystal": UnitCell(SQUARE, 2e-3, turned_silicon(20), Pillar(3e-3, 4e-3)),
    "turned back": UnitCell(SQUARE, 2e-3, turned_silicon(-20), Pillar(3e-3, 4e-3)),
    "deep": UnitCell(Lattice.rectangular(6e-3, 8e-3), 2e-3, ALUMINIUM, Pillar(2.4e-3, 9e-3)),
}


@cache
def superelement(name: str):
    if name == "reference":
        return lattice()
    cell = CELLS[name]
    return condense(cell, MeshPlan.suited(cell, 5 if name == "plain" else 3, 1), measured=False)


def rows(name: str, along: tuple[int, int] = (0, 1)) -> CondensedRows:
    return single(superelement(name), along)


@cache
def interface(k_y: float, name: str = "reference", along: tuple[int, int] = (0, 1)) -> Interface:
    return Interface.of(rows(name, along), k_y)


@pytest.mark.parametrize("polarisation", SPEED)
def test_a_finite_laminate_transmits_what_it_should(polarisation):
    expected = LAMINATE[polarisation]
    omega = 2 * np.pi * expected["mid"]
    right, left = half_space(*medium("aluminium", polarisation)[:2], omega)
    amplitudes = [scattered(slab, right, left, right) for slab in stacked(laminate(polarisation, omega), 8)]
    through = np.array([abs(t[0, 0]) for _, t in amplitudes])
    assert np.array([abs(r[0, 0]) for r, _ in amplitudes]) ** 2 + through**2 == pytest.approx(np.ones(8))
    for cells, transmitted in expected["T"].items():  # given as the root of 1 - |r|^2, hence the rounding
        assert through[int(cells) - 1] == pytest.approx(transmitted, rel=2e-7)
    # powers of a unimodular matrix: Chebyshev polynomials in N, here hyperbolic ones
    growth = np.sinh(np.arange(1, 9) * expected["att_Np"]) / np.sinh(expected["att_Np"])
    assert 1 / through**2 - 1 == pytest.approx((1 / through[0] ** 2 - 1) * growth**2, rel=1e-9)


@given(st.floats(0.05, 20.0), st.floats(0.05, 3.0))
def test_one_layer_between_half_spaces_is_a_fabry_perot(ratio, phase):
    right, left = half_space(1.0, 1.0, 1.0)
    r, t = scattered(rod(ratio, 1.0, phase, 1.0), right, left, right)
    finesse = 0.25 * (ratio - 1 / ratio) ** 2
    assert abs(t[0, 0]) ** 2 == pytest.approx(1 / (1 + finesse * np.sin(phase) ** 2), rel=1e-9)
    assert abs(r[0, 0]) ** 2 == pytest.approx(1 - abs(t[0, 0]) ** 2, abs=1e-9)


def test_so_many_layers_that_transfer_matrices_would_overflow():
    omega = 2 * np.pi * LAMINATE["longitudinal"]["mid"]
    right, left = half_space(*medium("aluminium", "longitudinal")[:2], omega)
    last = next(islice(stacked(laminate("longitudinal", omega), 600), 599, None))
    r, t = scattered(last, right, left, right)
    assert abs(r[0, 0]) == pytest.approx(1.0, abs=1e-12)
    assert abs(t[0, 0]) < 1e-300
    endless, _ = bloch_waves(laminate("longitudinal", omega), omega)
    assert reflected_by(endless.impedance(), right, left) == pytest.approx(r, abs=1e-9)


@pytest.mark.parametrize("k_y", [0.0, OBLIQUE, -OBLIQUE])
@pytest.mark.parametrize("kilohertz", [45.0, 56.0, 61.0, 130.0])
def test_energy_is_conserved_and_every_conversion_goes_both_ways(kilohertz, k_y):
    scattering = interface(k_y).scattering(kilohertz * KILOHERTZ, 6, FAMILIES)
    assert scattering.reflected.shape == scattering.transmitted.shape == (6, 3, 4)
    assert np.abs(scattering.dissipated).max() < 1e-9
    for share in (scattering.reflected, scattering.transmitted):
        assert (share >= 0).all()
        own = share[:, :, : len(FAMILIES)]
        assert own == pytest.approx(own.swapaxes(1, 2), abs=1e-9)
    assert scattering.reflected[2, 0, 1] > 1e-4  # A0 to S0: there are pillars on one side only


def test_diffracted_waves_take_their_share():
    omega, here = 250.0 * KILOHERTZ, interface(OBLIQUE)
    right, _ = here.plate_waves(omega)
    assert right.labelled("A0").sum() == 2
    scattering = here.scattering(omega, 3, FAMILIES)
    assert np.abs(scattering.dissipated).max() < 1e-9
    beyond = interface(OBLIQUE + 2 * np.pi / here.period)  # only its diffracted waves propagate
    assert (beyond.plate_waves(50.0 * KILOHERTZ)[0].labelled("A0")).any()
    with refusing(StudyError, "no-answer", "layers.incident"):
        beyond.scattering(50.0 * KILOHERTZ, 1, ("A0",))


def test_waves_from_above_and_from_below_do_the_same():
    up, down = (interface(k).scattering(56.0 * KILOHERTZ, 3, FAMILIES) for k in (OBLIQUE, -OBLIQUE))
    assert up.transmitted == pytest.approx(down.transmitted, rel=1e-6, abs=1e-12)
    assert up.transmitted[:, 0, 2].max() > 1e-7  # A0 to SH0, which symmetry forbids at normal incidence
    level = interface(0.0).scattering(56.0 * KILOHERTZ, 3, FAMILIES)
    assert level.transmitted[:, :2, 2].max() < 1e-12


@pytest.mark.parametrize(("family", "angle"), [("A0", 0.0), ("A0", 0.7), ("S0", 0.5), ("SH0", -0.5)])
def test_cells_without_pillars_transmit_everything(family, angle):
    omega = 58.8 * KILOHERTZ
    plain = Interface.met_by(rows("plain"), omega, family, angle)
    scattering = plain.scattering(omega, 3, (family,))
    assert scattering.transmitted[:, 0, OUTGOING.index(family)] == pytest.approx(np.ones(3), abs=1e-6)


@pytest.mark.parametrize("k_y", [0.0, OBLIQUE])
@pytest.mark.parametrize("kilohertz", [45.0, 58.8, 80.0])
def test_half_plates_may_as_well_be_made_of_plain_cells(kilohertz, k_y):
    """Whole faces against restricted ones, waves of cells against waves of a plate: a route of its own."""
    omega, here = kilohertz * KILOHERTZ, interface(k_y)
    expected = here.scattering(omega, 2, FAMILIES)
    cells = bloch_waves(coarse_rows(pillars=False).slab(k_y * here.period).at(omega), omega)
    number = []
    for side, known in zip(cells, here.plate_waves(omega), strict=True):
        turns = [np.exp(1j * known.wavenumber[known.label.index(f)] * here.period) for f in FAMILIES]
        number.append(np.abs(np.exp(side.exponent) - np.array(turns)[:, None]).argmin(axis=1))
    right, left = cells
    *_, both = stacked(here.slab.at(omega), 2)
    r, t = scattered(both, right.chosen(number[0]), left, right)
    shares = [np.abs(r[number[1]]).T ** 2, np.abs(t[number[0]]).T ** 2]
    assert shares[0] == pytest.approx(expected.reflected[1, :, :3], abs=5e-4)
    assert shares[1] == pytest.approx(expected.transmitted[1, :, :3], abs=5e-4)


def test_a_layer_more_takes_what_the_farthest_reaching_wave_loses():
    omega = 56.0 * KILOHERTZ
    scattering = interface(0.0).scattering(omega, 12, FAMILIES)
    right, _ = bloch_waves(interface(0.0).slab.at(omega), omega)
    slope = np.diff(scattering.insulation, axis=0)[-1]
    assert slope[:2] == pytest.approx(decibels(right), rel=1e-3)
    # SH0 is odd in the mirror along the layers: it couples to another wave, which decays faster
    decay = -20 / np.log(10) * right.exponent.real
    assert slope[2] > 1.2 * decibels(right)
    assert np.abs(decay - slope[2]).min() < 1e-3 * slope[2]


def test_many_layers_are_a_mirror():
    omega, oblique = 56.0 * KILOHERTZ, interface(OBLIQUE)
    right, left = oblique.plate_waves(omega)
    slab = next(islice(stacked(oblique.slab.at(omega), 30), 29, None)).projected(oblique.trace)
    r, _ = scattered(slab, right.waves, left.waves, right.waves)
    mirror = oblique.mirror(omega)
    assert mirror.reflection() == pytest.approx(r, abs=1e-6 * np.abs(r).max())


@pytest.mark.parametrize("kilohertz", [45.0, 56.0, 61.5])
@pytest.mark.parametrize("k_y", [0.0, OBLIQUE])
def test_what_a_mirror_does_not_reflect_enters_its_bands(kilohertz, k_y):
    mirror = interface(k_y).mirror(kilohertz * KILOHERTZ)
    r = mirror.reflection()
    t = mirror.transmission(r)
    right, left = (side.waves.propagates for side in (mirror.incoming, mirror.outgoing))
    back = (np.abs(r[np.ix_(left, right)]) ** 2).sum(axis=0)
    inside = (np.abs(t[np.ix_(mirror.lattice.propagates, right)]) ** 2).sum(axis=0)
    assert back + inside == pytest.approx(np.ones(right.sum()), abs=1e-8)
    assert (inside.max() > 0.01) == (kilohertz != 56.0 and mirror.lattice.propagates.any())


def test_a_little_loss_takes_in_proportion():
    omega = 56.0 * KILOHERTZ
    lossless, first, second = (
        interface(OBLIQUE).scattering(omega, 6, FAMILIES, loss_factor) for loss_factor in (0, 1e-5, 2e-5)
    )
    assert (first.dissipated > 0).all()
    assert second.dissipated == pytest.approx(2 * first.dissipated, rel=2e-2)
    assert first.transmitted == pytest.approx(lossless.transmitted, rel=1e-2, abs=1e-9)
    strong = interface(OBLIQUE).scattering(omega, 6, FAMILIES, 0.2)
    assert (strong.dissipated > 0.05).all()
    assert (strong.dissipated < 1).all()


@pytest.mark.parametrize("k_y", [0.0, OBLIQUE])
def test_either_translation_can_be_crossed(k_y):
    omega = 50.0 * KILOHERTZ
    wide = interface(k_y, "wide", (1, 0)).scattering(omega, 3, FAMILIES)
    deep = interface(k_y, "deep", (0, 1)).scattering(omega, 3, FAMILIES)
    assert wide.transmitted == pytest.approx(deep.transmitted, abs=2e-3)
    assert wide.reflected == pytest.approx(deep.reflected, abs=2e-3)
    assert wide.transmitted.std() > 0.1


@settings(max_examples=6)
@given(k_y=st.floats(-60.0, 60.0))
def test_an_interface_repeats_with_the_reciprocal_lattice(k_y):
    """With the harmonics named anew, the same waves of the plate meet the same lattice."""
    omega, step = 56.0 * KILOHERTZ, 2 * np.pi / 7e-3
    here, there = (Interface.of(rows("reference"), k) for k in (k_y, k_y + step))
    assert np.sort(there.tangential) == pytest.approx(np.sort(here.tangential), abs=1e-6)
    assert there.tangential[0] == pytest.approx(here.tangential[0] + step)
    first, second = (i.mirror(omega) for i in (here, there))
    energy = [
        np.abs(m.reflection()[np.ix_(m.outgoing.waves.propagates, m.incoming.waves.propagates)]) ** 2
        for m in (first, second)
    ]
    assert np.sort(energy[0], axis=None) == pytest.approx(np.sort(energy[1], axis=None), abs=1e-8)


@pytest.mark.parametrize("angle", [-0.7, 0.0, 1.2])
def test_the_angle_sets_the_wavenumber_along_the_layers(angle):
    omega = 50.0 * KILOHERTZ
    met = Interface.met_by(rows("reference"), omega, "SH0", angle)
    assert met.tangential[0] == pytest.approx(-omega / ALUMINIUM.shear_speed * np.sin(angle), rel=1e-9)


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("angle", [-0.5, 0.7])
def test_a_wave_in_a_turned_crystal_comes_at_the_angle_that_was_asked(angle, family):
    """Its phase moves against its wavevector, because time enters as exp(+i omega t)."""
    omega = 50.0 * KILOHERTZ
    met = Interface.met_by(rows("turned crystal"), omega, family, angle)
    right, _ = met.plate_waves(omega)
    (across,) = right.wavenumber[right.labelled(family) & (right.harmonic == 0)]
    assert np.arctan2(-met.tangential[0], -across.real) == pytest.approx(angle, rel=1e-9)


def test_mirror_images_of_a_crystal_and_an_angle_lose_the_same():
    omega = 50.0 * KILOHERTZ
    losses = [
        Interface.met_by(rows(name), omega, "A0", angle).scattering(omega, 2, ("A0",)).transmitted
        for name, angle in (("turned crystal", 0.6), ("turned back", -0.6), ("turned crystal", -0.6))
    ]
    assert losses[1] == pytest.approx(losses[0], rel=1e-6, abs=1e-9)
    assert not np.allclose(losses[2], losses[0], rtol=1e-4)


@pytest.mark.parametrize("angle", [0.5 * np.pi, 2.0, -1.6, np.nan])
def test_a_wave_that_does_not_come_is_refused(angle):
    with refusing(StudyError, "out-of-range", "layers.angle"):
        Interface.met_by(rows("reference"), 50.0 * KILOHERTZ, "A0", angle)


def test_what_cannot_be_scattered_is_refused():
    reference, omega = rows("reference"), 50.0 * KILOHERTZ
    with refusing(StudyError, "no-answer", "layers.incident", "S1 at 50 kHz"):
        Interface.met_by(reference, omega, "S1", 0.0)
    steep = Interface.met_by(reference, omega, "A0", 1.2)
    with refusing(StudyError, "no-answer", "layers.incident"):
        steep.scattering(omega, 2, ("A0", "S0"))
    with refusing(StudyError, "out-of-range", "layers.angle", "at most 2244 rad/m"):
        Interface.of(reference, 2300.0)
    assert Interface.of(reference, 2200.0).tangential[0] == pytest.approx(2200.0)
    with refusing(StudyError, "out-of-range", "layers.count"):
        steep.scattering(omega, 0, ("A0",))
