"""Ribbons against exact waves of a bare strip, complex bands, other bases of one structure, and counts."""

from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
import scipy.linalg as la
from coarse import single
from hypothesis import given, settings, strategies as st
from numpy.polynomial import legendre
from strategies import ALUMINIUM, reference_cell
from test_sites import TALL, THIN, named

from five_parts import refusing
from haptonic.bloch.centred import CentredPencil
from haptonic.bloch.chain import BlockChain, counted, eigenpairs_within
from haptonic.bloch.model import BlochModel
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.ribbon import RibbonModel, RibbonModes, bulk_bands
from haptonic.bloch.ribbon_datasets import ribbon_dataset
from haptonic.bloch.ribbon_modes import GuideMotion, decay, in_gap, outermost, within
from haptonic.bloch.rows import attenuation
from haptonic.cell import Pillar, Ribbon, Site, UnitCell
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.materials import elasticity_tensor, material
from haptonic.superelement import Tiling

MM = 1e-3
COARSE = Resolution(2, 1)
CRYSTAL = reference_cell()
PLAIN = UnitCell(Lattice.rectangular(8 * MM, 7 * MM), 1.5 * MM, ALUMINIUM)
ALONG = 17.5 * np.pi / 20


@cache
def prototype() -> RibbonModel:
    return RibbonModel.of(Ribbon((CRYSTAL,) * 5 + (PLAIN,) * 4 + (CRYSTAL,) * 5), COARSE)


# --- a bare strip -------------------------------------------------------------------------------------------


def strip_waves(width: float, thickness: float, wavenumber: float, degrees=(13, 7)) -> np.ndarray:
    """Hz, waves exp(i k y) of a bar of rectangular section with free faces, by Legendre polynomials over it.

    Rayleigh and Ritz on a basis of the whole section: no mesh, no tiles, no condensation.
    """

    def forms(degree, length):
        x, weight = legendre.leggauss(degree + 2)
        value = legendre.legvander(x, degree)
        slope = np.stack([legendre.legval(x, legendre.legder(row)) for row in np.eye(degree + 1)], 1)
        slope = slope * 2 / length
        weight = weight * length / 2
        return [[(a.T * weight) @ b for b in (value, slope)] for a in (value, slope)]

    across, through = forms(degrees[0], width), forms(degrees[1], thickness)
    tensor = elasticity_tensor(ALUMINIUM.stiffness)
    size = 3 * (degrees[0] + 1) * (degrees[1] + 1)
    stiffness = np.zeros((size, size), dtype=complex)
    for a in range(3):
        for b in range(3):
            factor = (-1j * wavenumber if a == 1 else 1.0) * (1j * wavenumber if b == 1 else 1.0)
            over = np.kron(across[a == 0][b == 0], through[a == 2][b == 2])
            stiffness += factor * np.kron(over, tensor[:, a, :, b])
    mass = ALUMINIUM.density * np.kron(np.kron(across[0][0], through[0][0]), np.eye(3))
    return np.sqrt(np.maximum(la.eigvalsh(stiffness, mass), 0.0)) / (2 * np.pi)


@pytest.mark.parametrize("kappa", [0.4, 0.9, 3.0])
def test_a_bare_strip_has_its_guided_waves_within_their_errors(kappa):
    cell = UnitCell(Lattice.rectangular(4 * MM, 3 * MM), 1.5 * MM, ALUMINIUM)
    ribbon = Ribbon((cell,) * 2)
    modes = RibbonModel.of(ribbon, Resolution(4, 0)).solve(kappa, 5e3, 650e3)
    zone = 2 * np.pi / (3 * MM)
    waves = [strip_waves(8 * MM, 1.5 * MM, kappa / (3 * MM) + shift * zone) for shift in (-1, 0, 1)]
    exact = np.sort(np.concatenate(waves))
    exact = exact[(exact > 5e3) & (exact < 650e3)]
    assert len(modes.frequency) == len(exact) >= 8
    assert (np.abs(modes.frequency - exact) <= modes.error + 1e-5 * exact).all()
    low = exact < 400e3
    assert modes.frequency[low] == pytest.approx(exact[low], rel=1e-3)
    assert modes.error[low].max() < 5e-3 * exact[low].max()


def test_the_first_shear_wave_of_a_wide_strip_is_the_plates():
    """omega = c pi / width, motion along the strip with one nodal line: at k = 0 no other wave is coupled."""
    cell = UnitCell(Lattice.rectangular(5 * MM, 4 * MM), 1.0 * MM, ALUMINIUM)
    modes = RibbonModel.of(Ribbon((cell,) * 3), Resolution(4, 0)).solve(0.0, 90e3, 115e3)
    shear = np.sqrt(ALUMINIUM.stiffness[5, 5] / ALUMINIUM.density)
    exact = shear / (2 * 15 * MM)
    nearest = np.abs(modes.frequency - exact).argmin()
    assert modes.frequency[nearest] == pytest.approx(exact, rel=1e-4)
    assert abs(modes.frequency[nearest] - exact) < modes.error[nearest] < 1e-3 * exact


def test_group_velocity_is_the_slope_of_the_frequency():
    model, step = prototype(), 1e-4
    here = model.solve(ALONG, 54e3, 61e3)
    before, after = (model.frequencies(ALONG + s * step, 54e3, 61e3) for s in (-1, 1))
    assert here.slope == pytest.approx((after - before) / (2 * step), rel=1e-5)


# --- a guide between crystals -------------------------------------------------------------------------------


def test_a_guided_wave_decays_into_the_rows_as_in_the_complex_bands():
    model = prototype()
    modes = model.solve(ALONG, 54e3, 61e3)
    (crystal,) = {id(t): t for t in model.fine.tiling.tiles if t.cell is CRYSTAL}.values()
    omega = 2 * np.pi * modes.frequency
    expected = attenuation(single(crystal), omega, np.array([ALONG]))[:, 0]
    assert len(expected) == 1
    fall, error = decay(model, modes)
    assert fall == pytest.approx(expected, rel=0.005)
    assert 0 < error[0] < fall[0]


@pytest.mark.parametrize("rows", [3, 5, 7])
def test_the_error_of_a_decay_contains_the_beats_of_evanescent_waves(rows):
    """Falls from row to row are 6 to 22 dB; three rows have two, of which one is at the edge."""
    kappa, place = 9 * np.pi / 16, Lattice.square(10 * MM)
    crystal = UnitCell(place, 2 * MM, ALUMINIUM, pillar=Pillar(5 * MM, 5 * MM, material=material("steel")))
    plain = UnitCell(Lattice.rectangular(8.605 * MM, 10 * MM), 2 * MM, ALUMINIUM)
    model = RibbonModel.of(Ribbon((crystal,) * rows + (plain,) + (crystal,) * rows), Resolution(3, 1))
    modes = model.solve(kappa, 51.5e3, 53e3)
    guided = int(within(modes.energy, model.ribbon.guide).argmax())
    fall, error = (values[guided] for values in decay(model, modes))
    tile = next(tile for tile in model.fine.tiling.tiles if tile.cell is crystal)
    omega = 2 * np.pi * modes.frequency[guided : guided + 1]
    expected = attenuation(single(tile), omega, np.array([kappa])).item()
    assert abs(fall - expected) < error < expected


def test_errors_of_velocity_and_decay_reach_those_of_a_finer_mesh():
    coarse = prototype()
    fine = RibbonModel.of(coarse.ribbon, Resolution(3, 1))
    rough, exact = (model.solve(ALONG, 54e3, 61e3) for model in (coarse, fine))
    falls = [decay(*pair) for pair in ((coarse, rough), (fine, exact))]
    number = [int(within(modes.energy, coarse.ribbon.guide).argmax()) for modes in (rough, exact)]
    change = np.abs(rough.slope[number[0]] - exact.slope[number[1]])
    assert 0.01 * rough.slope_error[number[0]] < change < rough.slope_error[number[0]]
    (fall, error), (true, _) = ([each[k] for each in fallen] for fallen, k in zip(falls, number, strict=True))
    assert abs(fall - true) < error < fall


def test_the_prototypes_guide_holds_one_mode_without_nodal_lines_at_17_intervals():
    model = prototype()
    modes = model.solve(ALONG, 54e3, 61e3)
    (share,), (edges,) = (
        within(modes.energy, model.ribbon.guide),
        within(modes.energy, outermost(model.ribbon)),
    )
    assert modes.energy.sum(axis=(1, 2)) == pytest.approx([1.0], rel=1e-9), "unit mass"
    assert share > 0.95
    assert edges < 1e-4
    wavenumber, across = GuideMotion(model).harmonics(modes)
    assert wavenumber == pytest.approx([17.5 * np.pi / (20 * 7 * MM)], rel=1e-9)
    assert across == pytest.approx([0.0])


def test_bulk_bands_hold_all_modes_but_those_of_guide_and_edges():
    """A wide ribbon at a phase without a guided wave nearby."""
    bulk = bulk_bands(BlochModel.of(CRYSTAL, COARSE, 8, measured=False), prototype().ribbon, [ALONG])[0]
    low, high = bulk[5] - [20.0, -20.0]
    modes = prototype().solve(ALONG, float(low), float(high))
    deep = within(modes.energy, prototype().ribbon.guide) + within(
        modes.energy, outermost(prototype().ribbon)
    )
    assert (deep < 0.5).sum() >= 8
    assert not in_gap(replace(modes, error=np.zeros_like(modes.error)), bulk[None])[deep < 0.02].any()
    held = prototype().solve(ALONG, 54e3, 61e3)
    assert in_gap(replace(held, error=0 * held.error), bulk[None]).all()


def test_a_mode_whose_energy_grows_away_from_the_guide_is_not_guided():
    model = prototype()
    bulk = bulk_bands(BlochModel.of(CRYSTAL, COARSE, 8, measured=False), model.ribbon, [ALONG])
    held = model.solve(ALONG, 54e3, 61e3)
    held = replace(held, error=0 * held.error)
    beside = np.array([0.02, 0.03, 0.04, 0.05, 0.0])  # from the guide outwards
    energy = np.concatenate([beside[::-1], np.full(4, 0.18), beside])[None, None]
    growing = replace(held, energy=energy, stiffened_energy=energy)
    dataset = ribbon_dataset(model, [held, growing], np.repeat(bulk[None], 2, axis=1), None)
    assert dataset["in_gap"].values.tolist() == [1, 1]
    assert (dataset["decay"].values > 0).tolist() == [True, False]
    assert dataset["guided"].values.tolist() == [1, 0]


def test_no_gap_is_reported_above_the_last_computed_bulk_band():
    bulk = np.array([[[10.0, 20.0], [25.0, 30.0]], [[9.0, 11.0], [26.0, 27.0]]])
    at = np.array([5.0, 15.0, 22.0, 24.8, 28.0, 31.0])
    modes = RibbonModes(0.3, at, np.full(6, 0.5), at, at, at, at, at, 1.0)
    assert list(in_gap(modes, bulk)) == [True, False, True, False, False, False]


@pytest.mark.parametrize("along", [(0, 1), (1, 0), (1, 1), (-1, 2), (3, 2)])
@pytest.mark.parametrize("lattice", [Lattice.triangular(7 * MM), Lattice.oblique(7 * MM, 9 * MM, 1.2)])
def test_phases_along_and_across_are_those_of_the_period_and_of_the_step_to_the_next_column(lattice, along):
    ribbon = Ribbon((UnitCell(lattice, 1.5 * MM, ALUMINIUM),) * 2, along)
    (period,), (step, _) = ribbon.vectors, ribbon.steps
    assert step[0] * period[1] - step[1] * period[0] == pytest.approx(lattice.area), "to the right of it"
    assert abs(step @ period) <= 0.5 * (1 + 1e-9) * (period @ period), "the shortest way"
    (wave,) = lattice.wavevector(ribbon.phases(0.7, np.array([-1.3])))
    assert wave @ period == pytest.approx(0.7)
    assert wave @ step == pytest.approx(-1.3)


# --- one structure, several ways ----------------------------------------------------------------------------


def hertz(ribbon: Ribbon, kappa: float, low: float, high: float, resolution=COARSE) -> np.ndarray:
    return RibbonModel.of(ribbon, resolution).frequencies(kappa, low, high)


def test_a_ribbon_and_its_mirror_image_have_the_same_waves():
    columns = (CRYSTAL, CRYSTAL, PLAIN, PLAIN, CRYSTAL)
    frequencies, of_image = (hertz(Ribbon(c), 1.1, 20e3, 60e3) for c in (columns, columns[::-1]))
    assert len(frequencies) > 5
    assert of_image == pytest.approx(frequencies, rel=1e-8)


def test_a_square_lattice_may_be_repeated_along_either_translation():
    """But for the random directions that symmetry classes of a foot and its body get each: 7e-8 seen."""
    columns = (CRYSTAL, CRYSTAL.without_pillar(), CRYSTAL)
    along_a2, along_a1 = (hertz(Ribbon(columns, along), 0.7, 20e3, 60e3) for along in ((0, 1), (1, 0)))
    assert along_a1 == pytest.approx(along_a2, rel=5e-7)


@pytest.mark.parametrize("along", [(1, 1), (-1, 2)])
def test_waves_run_alike_both_ways_whatever_the_direction(along):
    """Time reversal, on a ribbon whose columns reach beyond their neighbours."""
    cell = replace(CRYSTAL, pillar=Pillar(3.5 * MM, 5 * MM))
    model = RibbonModel.of(Ribbon((cell, cell.without_pillar(), cell), along), COARSE)
    forward, backward = (model.frequencies(sign * 0.8, 10e3, 60e3) for sign in (1, -1))
    assert len(forward) >= 5
    assert backward == pytest.approx(forward, rel=1e-9)


def test_two_periods_are_one_twice_as_long():
    """Its waves at kappa are those of the shorter one at half of it, and half a turn on."""
    pillar = Pillar(3.5 * MM, 9 * MM)
    short = UnitCell(Lattice.rectangular(7 * MM, 7 * MM), 1.5 * MM, ALUMINIUM, pillar)
    sites = (Site(at=(0, 0), pillar=pillar), Site(at=(0, 0.5), pillar=pillar))
    long = UnitCell(Lattice.rectangular(7 * MM, 14 * MM), 1.5 * MM, ALUMINIUM, site=sites)
    single = RibbonModel.of(Ribbon((short, short.without_pillar(), short)), COARSE)
    double = RibbonModel.of(Ribbon((long, long.without_pillar(), long)), COARSE)
    expected = np.concatenate([single.frequencies(0.6 + turn, 15e3, 50e3) for turn in (0.0, np.pi)])
    frequencies = double.frequencies(1.2, 15e3, 50e3)
    assert len(frequencies) == len(expected)
    assert frequencies == pytest.approx(np.sort(expected), rel=2e-3)


# --- two crystals -------------------------------------------------------------------------------------------


def honeycomb(*heights: float) -> UnitCell:
    site = tuple(Site(pillar=Pillar(5 * MM, h * MM)) for h in heights)
    return UnitCell(Lattice(lattice="honeycomb", pitch=12 * MM), 1.5 * MM, ALUMINIUM, None, site)


@pytest.mark.nightly
def test_an_edge_between_mirrored_honeycombs_holds_a_wave_that_crosses_the_gap():
    """Unequal pillars open the cone at K; exchanged ones on the other side give their edge a wave there."""
    crystal, other = honeycomb(3.3, 2.7), honeycomb(2.7, 3.3)
    wall = Ribbon((crystal,) * 4 + (other,) * 4)
    bulk_model = BlochModel.of(crystal, COARSE, 9, measured=False)
    phases = np.linspace(0.35, 0.725, 5) * np.pi
    bulk = bulk_bands(bulk_model, wall, phases)
    low, high = bulk[:, 4, 1].max(), bulk[:, 5, 0].min()
    assert high > 1.02 * low, "a gap between the fifth and the sixth band"
    model = RibbonModel.of(wall, COARSE)
    held = []
    for kappa in phases:
        modes = model.solve(kappa, low, high)
        chosen = within(modes.energy, wall.guide) > 0.4
        assert chosen.any(), "at each phase"
        assert (within(modes.energy, outermost(wall))[chosen] < 0.1).all(), "it is no wave of the free edges"
        held.append((float(modes.frequency[chosen][0]), float(modes.slope[chosen][0])))
    frequency, slope = np.array(held).T
    assert (np.diff(frequency) < 0).all(), "it runs one way at one of the two corners"
    assert (slope < 0).all()
    assert frequency[0] > low + 0.8 * (high - low)
    assert frequency[-1] < low + 0.3 * (high - low)


# --- a defect -----------------------------------------------------------------------------------------------

LOWER = replace(CRYSTAL, pillar=replace(CRYSTAL.pillar, height=0.95 * CRYSTAL.pillar.height))


def around(defect: UnitCell, columns: int, lines: int) -> Ribbon:
    """One other cell in the middle of a crystal."""
    line, half = (CRYSTAL,) * columns, columns // 2
    middle = (CRYSTAL,) * half + (defect,) + (CRYSTAL,) * half
    lowest, *more = (middle if number == lines // 2 else line for number in range(lines))
    return Ribbon(lowest, more=tuple(more))


@pytest.mark.parametrize("lines", [2, 3])
def test_equal_lines_have_the_waves_of_one_at_as_many_phases(lines):
    line = (CRYSTAL, CRYSTAL.without_pillar(), CRYSTAL)
    single = RibbonModel.of(Ribbon(line), COARSE)
    several = RibbonModel.of(Ribbon(line, more=(line,) * (lines - 1)), COARSE)
    phases = (0.6 + 2 * np.pi * np.arange(lines)) / lines
    expected = np.sort(np.concatenate([single.frequencies(kappa, 54e3, 61e3) for kappa in phases]))
    modes = several.solve(0.6, 54e3, 61e3)
    assert len(expected) > 1
    assert modes.frequency == pytest.approx(expected, rel=1e-9)
    assert modes.energy.sum(axis=(1, 2)) == pytest.approx(np.ones(len(expected)), rel=1e-9)
    assert modes.energy[:, 0] == pytest.approx(modes.energy[:, -1], abs=1e-6), "alike in each line"
    assert several.ribbon.kind == "guide", "it does not change along the ribbon"


@pytest.mark.nightly
def test_a_pillar_a_twentieth_too_short_holds_the_same_wave_in_a_crystal_without_edges():
    """As one site of nine it is repeated in both directions: no free edges, and another solver."""
    model = RibbonModel.of(around(LOWER, 5, 3), COARSE)
    assert model.ribbon.kind == "defect"
    assert np.argwhere(model.ribbon.guide).tolist() == [[1, 2]]
    solutions = [model.solve(kappa, 53.4e3, 53.8e3) for kappa in (0.0, np.pi)]
    assert [len(modes.frequency) for modes in solutions] == [1, 1]
    held = np.concatenate([modes.frequency for modes in solutions])
    assert np.concatenate([within(modes.energy, model.ribbon.guide) for modes in solutions]).min() > 0.97
    assert np.ptp(held) < 2e-4 * held.mean(), "copies three cells apart hardly feel each other"
    thirds = [0.0, 1 / 3, 2 / 3]
    site = tuple(
        Site(at=(x, y), pillar=LOWER.pillar if x == y == 0 else CRYSTAL.pillar)
        for x in thirds
        for y in thirds
    )
    cell = UnitCell(Lattice.square(21 * MM), CRYSTAL.thickness, ALUMINIUM, site=site)
    tiling = Tiling.condensed(cell, COARSE.plans(cell), COARSE.steps, COARSE.block, measured=False)
    values, _ = eigenpairs(CentredPencil.of(tiling), np.zeros(2), 60)
    nearest = np.abs(np.sqrt(np.abs(values)) / (2 * np.pi) - held.mean()).min()
    assert nearest < 2e-4 * held.mean()


def test_the_kind_of_a_ribbon_is_derived_from_its_crystals():
    plain = CRYSTAL.without_pillar()
    line = (CRYSTAL,) * 3
    changed = Ribbon((CRYSTAL, LOWER, CRYSTAL))
    assert changed.kind == "guide", "a column of other pillars"
    assert changed.crystals == (CRYSTAL,)
    assert Ribbon((CRYSTAL, LOWER)).kind == "edge"
    assert Ribbon((CRYSTAL, LOWER)).guide.all()
    missing = Ribbon(line, more=((CRYSTAL, plain, CRYSTAL), line))
    assert missing.kind == "defect"
    assert np.argwhere(missing.guide).tolist() == [[1, 1]]
    lines = Ribbon(line, more=((LOWER,) * 3,))
    assert lines.kind == "strip", "a line across is no guide along"
    assert not lines.has_bulk
    strip = Ribbon(line)
    assert strip.kind == "strip"
    assert strip.has_bulk
    assert np.argwhere(strip.guide).tolist() == [[0, 0], [0, 2]], "waves of free edges"


# --- all modes, and no others -------------------------------------------------------------------------------


@given(st.integers(0, 10**6), st.lists(st.integers(1, 12), min_size=2, max_size=6), st.floats(0.05, 0.9))
@settings(max_examples=40, deadline=None)
def test_all_eigenvalues_of_a_chain_within_an_interval_are_found(seed, sizes, share):
    draw = np.random.default_rng(seed)

    def hermitian(size):
        matrix = draw.standard_normal((size, size)) + 1j * draw.standard_normal((size, size))
        return matrix + matrix.conj().T

    own = [hermitian(size) for size in sizes]
    off = [draw.standard_normal(pair) + 0j for pair in pairwise(sizes)]
    heavy = [hermitian(size) + 100 * np.eye(size) for size in sizes]
    light = [0.1 * block for block in off]
    stiffness, mass = BlockChain(tuple(own), tuple(off)), BlockChain(tuple(heavy), tuple(light))
    whole = [form.times(np.eye(sum(sizes), dtype=complex)) for form in (stiffness, mass)]
    exact = la.eigh(*whole, eigvals_only=True)
    low, high = exact[0] - 0.01, exact[0] + share * (exact[-1] - exact[0]) + 1e-3
    below, values, modes = eigenpairs_within(stiffness, mass, low, high)
    assert below == 0
    assert values == pytest.approx(exact[exact < high], rel=1e-7, abs=1e-9)
    assert modes.conj().T @ whole[1] @ modes == pytest.approx(np.eye(len(values)), abs=1e-8)
    assert counted(stiffness, mass, high) == (exact < high).sum()


# --- what is refused ----------------------------------------------------------------------------------------


def test_columns_whose_edges_do_not_meet_are_refused():
    low = replace(CRYSTAL, lattice=Lattice.rectangular(7 * MM, 6 * MM))
    with refusing(GeometryError, "mismatch", "ribbon.map", "column 2"):
        Ribbon((CRYSTAL, low))
    thick = replace(CRYSTAL, thickness=1.4 * MM)
    with refusing(GeometryError, "mismatch", "ribbon.map", "thickness"):
        Ribbon((CRYSTAL, CRYSTAL, thick))
    comb = named("honeycomb", THIN, TALL)
    with refusing(GeometryError, "mismatch", "ribbon.map", "column 2"):
        Ribbon((comb, named("kagome", pillar=THIN)))
    wide = replace(PLAIN, lattice=Lattice.rectangular(8 * MM, 7 * MM))
    with refusing(GeometryError, "mismatch", "ribbon.map"):
        Ribbon((CRYSTAL, wide), (1, 0))


@pytest.mark.parametrize("along", [(0, 0), (2, 0), (2, 4)])
def test_a_period_is_a_shortest_one(along):
    with refusing(GeometryError, "out-of-range", "ribbon.along"):
        Ribbon((CRYSTAL,) * 2, along)
