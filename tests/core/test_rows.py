"""Rows of any lattice along any direction: two bases of one structure, energy, plain plate, complex bands."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from strategies import ALUMINIUM
from test_sites import THIN, named, placed, sites

from five_parts import refusing
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.evanescent import bloch_waves
from haptonic.bloch.layers import OUTGOING, Interface, scattered, stacked
from haptonic.bloch.mirrors import Incidence, mirror_dataset
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.plate_waves import FAMILIES
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.rows import CondensedRows, attenuation
from haptonic.cell import Disc, Filler, Pillar, Rows, UnitCell
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.superelement import Tiling

MM, KILOHERTZ = 1e-3, 2e3 * np.pi
PITCH = 7 * MM
COARSE = Resolution(2, 0)
STOUT = Pillar(3.5 * MM, 14.7 * MM)
SQUARE = UnitCell(Lattice.square(PITCH), 1.5 * MM, ALUMINIUM, STOUT)
TRIANGULAR = UnitCell(Lattice.triangular(PITCH), 1.5 * MM, ALUMINIUM, STOUT)
TURNED = placed(Lattice.square(PITCH * np.sqrt(2)), (0, 0, STOUT), (0.5, 0.5, STOUT))
UPRIGHT = placed(Lattice.rectangular(PITCH, PITCH * np.sqrt(3)), (0, 0, STOUT), (0.5, 0.5, STOUT))
HONEYCOMB = named("honeycomb", THIN, Pillar(1.5 * MM, 6 * MM))
CELLS = {
    "square": SQUARE,
    "triangular": TRIANGULAR,
    "honeycomb": HONEYCOMB,
    "kagome": named("kagome", pillar=THIN),
    "lieb": named("lieb", pillar=THIN),
    "oblique": UnitCell(Lattice.oblique(PITCH, 8 * MM, 1.25), 1.5 * MM, ALUMINIUM, STOUT),
}
DIRECTIONS = [(0, 1), (1, 0), (1, 1), (1, -1), (1, 2), (-2, 1)]
EVERYWHERE = [(name, along) for name in CELLS for along in DIRECTIONS]
SOME = [("triangular", (0, 1)), ("honeycomb", (1, 1)), ("oblique", (1, -1))]
DEAR = [pytest.param(*case, marks=pytest.mark.nightly) for case in EVERYWHERE if case not in SOME]
everywhere = pytest.mark.parametrize(("name", "along"), [*SOME, *DEAR])


@cache
def rows(cell: UnitCell, along: tuple[int, int] = (0, 1), resolution: Resolution = COARSE) -> CondensedRows:
    return CondensedRows.of(cell, resolution, along)


def shares(here: CondensedRows, kilohertz: float, k_y: float, count: int, incident=FAMILIES):
    return Interface.of(here, k_y).scattering(kilohertz * KILOHERTZ, count, incident)


# --- faces --------------------------------------------------------------------------------------------------


@settings(max_examples=20, deadline=None)
@given(cell=sites(), along=st.sampled_from(DIRECTIONS))
def test_faces_never_turn_back_and_trapezoids_fit_between_them_and_a_straight_line(cell, along):
    block = Rows(cell, along)
    sides, period, wide = block.sides, block.period, float(block.step @ block.turn[0])
    assert (sides[:, 1, 1] > sides[:, 0, 1]).all()
    assert np.ptp(sides[..., 1]) == pytest.approx(period)
    assert sides[1:, 0] == pytest.approx(sides[:-1, 1])
    assert wide * period == pytest.approx(cell.area)
    of_row = [placed.position @ block.turn[0] for placed in block.tiles[: len(cell.tiles)]]
    assert np.ptp(of_row) < wide, "sites of a row have their place in it"
    assert sum(placed.tile.area for placed in block.tiles) == pytest.approx(block.reach * cell.area)
    if not block.is_straight:
        left, right = (Filler(block, way) for way in (-1, 1))
        areas = [sum(placed.tile.area for placed in filler.tiles) for filler in (left, right)]
        assert sum(areas) == pytest.approx((right.line - left.line) * period)


@everywhere
def test_rows_and_what_leads_to_them_fill_a_strip_of_plate(name, along):
    """`Tiling.of` refuses what does not meet edge to edge; the areas show that nothing overlaps."""
    here = rows(CELLS[name], along)
    for period, tiling in (*here.blocks, *here.fillers):
        assert isinstance(tiling, Tiling)
        assert len(period.tiles) == len(tiling.tiles)
    block = here.rows
    assert sum(placed.tile.area for placed in block.tiles) == pytest.approx(block.reach * CELLS[name].area)
    assert here.rows.reach == 1 or len(here.blocks) == here.rows.reach


# --- one structure, two bases -------------------------------------------------------------------------------

BASES = [
    (SQUARE, (1, 1), TURNED, (0, 1)),
    (TRIANGULAR, (1, 0), UPRIGHT, (1, 0)),
    pytest.param(TRIANGULAR, (-1, 2), UPRIGHT, (0, 1), marks=pytest.mark.nightly),
]


def ratio(cell: UnitCell, along: tuple[int, int], other: UnitCell, way: tuple[int, int]) -> int:
    """Rows of the first that one of the second is."""
    wide = [Rows(*basis).step @ Rows(*basis).turn[0] for basis in ((cell, along), (other, way))]
    return round(wide[1] / wide[0])


@pytest.mark.parametrize(("cell", "along", "other", "way"), BASES)
def test_one_structure_in_two_bases_has_equal_decay_and_transmission(cell, along, other, way):
    here, there = rows(cell, along), rows(other, way)
    assert here.rows.period == pytest.approx(there.rows.period)
    times = ratio(cell, along, other, way)
    omega, phases = np.array([30.0, 56.0, 90.0]) * KILOHERTZ, np.array([0.0, 0.9])
    fades = attenuation(here, omega, phases) * times, attenuation(there, omega, phases)
    assert fades[0] == pytest.approx(fades[1], rel=2e-3, abs=1e-6)
    assert fades[0].max() > 5
    for k_y in (0.0, 40.0):
        shares_here = shares(here, 56.0, k_y, 2 * times)
        shares_there = shares(there, 56.0, k_y, 2)
        for name in ("transmitted", "reflected"):
            expected = getattr(shares_here, name)[times - 1 :: times]
            assert expected == pytest.approx(getattr(shares_there, name), abs=2e-3)


# --- energy -------------------------------------------------------------------------------------------------


@settings(max_examples=6)
@given(where=st.sampled_from(SOME), kilohertz=st.floats(20.0, 90.0), k_y=st.floats(-60.0, 60.0))
def test_energy_is_conserved_on_every_lattice_in_every_direction(where, kilohertz, k_y):
    name, along = where
    here = Interface.of(rows(CELLS[name], along), k_y)
    right, _ = here.plate_waves(kilohertz * KILOHERTZ)
    incident = tuple(f for f in FAMILIES if (right.labelled(f) & (right.harmonic == 0)).any())
    scattering = here.scattering(kilohertz * KILOHERTZ, 3, incident)
    assert np.abs(scattering.dissipated).max() < 1e-9
    assert scattering.reflected.min() >= 0


@everywhere
def test_rows_of_plain_tiles_transmit_everything(name, along):
    here = rows(CELLS[name].without_pillar(), along, Resolution(3, 0))
    for k_y in (0.0, 50.0):
        scattering = shares(here, 58.8, k_y, 3)
        for number, family in enumerate(FAMILIES):
            assert scattering.transmitted[:, number, OUTGOING.index(family)] == pytest.approx(
                np.ones(3), abs=1e-4
            )


# --- complex bands ------------------------------------------------------------------------------------------


@everywhere
def test_waves_that_propagate_are_those_of_the_bands(name, along):
    """Per row, though a slab may be several; the pencil of the whole lattice knows nothing of rows."""
    here, phase, omega = rows(CELLS[name], along), 2.1, 50.0 * KILOHERTZ
    right, left = bloch_waves(here.slab(phase).at(omega), omega)
    tiles = {tile.cell: tile for tile in here.blocks[-1][1].tiles}
    cell = CELLS[name]
    pencil = lattice_pencil(Tiling.of(cell, cell.tiles, [tiles[placed.tile] for placed in cell.tiles]))
    moving = 0
    for waves in (right, left):
        kappa = -1j * here.exponents(waves, phase)[waves.propagates]
        assert kappa.imag == pytest.approx(np.zeros(len(kappa)), abs=1e-6)
        for phases in here.rows.phases(phase, kappa.real):
            bands = np.sqrt(np.abs(eigenpairs(pencil, phases, 16)[0]))
            assert np.abs(bands / omega - 1).min() < 1e-7
        moving += len(kappa)
    assert moving, "no wave propagates, and nothing was compared"


@pytest.mark.parametrize(
    ("name", "along", "kilohertz"),
    [("triangular", (0, 1), 58.0), ("square", (1, 1), 58.0), ("honeycomb", (1, 0), 142.0)],
)
def test_a_row_more_takes_what_the_farthest_reaching_wave_loses(name, along, kilohertz):
    here, k_y, omega = rows(CELLS[name], along), 30.0, kilohertz * KILOHERTZ
    right, _ = bloch_waves(here.slab(k_y * here.rows.period).at(omega), omega)
    assert not right.propagates.any()
    insulation = shares(here, kilohertz, k_y, 30).insulation
    slope = (insulation[-1] - insulation[-21]) / 20
    assert slope.min() == pytest.approx(here.decay(right), rel=0.02)


@pytest.mark.parametrize(("name", "along"), [("triangular", (0, 1)), ("square", (1, 1))])
def test_many_rows_are_a_mirror(name, along):
    """Also behind the plate that leads to a zigzag."""
    omega, here = 58.0 * KILOHERTZ, Interface.of(rows(CELLS[name], along), 30.0)
    right, left = here.plate_waves(omega)
    before, behind = (end.at(omega) for end in here.ends)
    *_, stack = stacked(here.slab.at(omega), 15)
    slab = before.followed_by(stack).followed_by(behind).projected(here.trace)
    r, _ = scattered(slab, right.waves, left.waves, right.waves)
    mirror = here.mirror(omega)
    assert mirror.reflection() == pytest.approx(r, abs=1e-6 * np.abs(r).max())


@pytest.mark.parametrize("kilohertz", [45.0, 64.0])
def test_what_a_zigzag_does_not_reflect_enters_the_bands_behind_it(kilohertz):
    mirror = Interface.of(rows(TRIANGULAR), 30.0).mirror(kilohertz * KILOHERTZ)
    r = mirror.reflection()
    right, left = (side.waves.propagates for side in (mirror.incoming, mirror.outgoing))
    inside = mirror.transmission(r)[np.ix_(mirror.lattice.propagates, right)]
    back = (np.abs(r[np.ix_(left, right)]) ** 2).sum(axis=0)
    assert back + (np.abs(inside) ** 2).sum(axis=0) == pytest.approx(np.ones(right.sum()), abs=1e-8)
    assert len(inside) == 0 or np.abs(inside).max() > 0.1


def test_only_rows_of_the_lattice_take_energy():
    """Of slabs of three rows, and before and behind them, the rest is plate without losses."""
    here = Interface.of(rows(SQUARE.without_pillar(), (1, 2)), 0.0)
    lost = here.scattering(58.0 * KILOHERTZ, 6, ("A0",), 1e-4).dissipated[:, 0]
    assert lost == pytest.approx(lost[0] * np.arange(1, 7), rel=0.05)


# --- what is asked ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("along", [(2, 0), (0, 0), (2, -4)])
def test_a_direction_that_is_none_or_no_shortest_one_is_refused(along):
    with refusing(GeometryError, "out-of-range", "layers.along"):
        rows(SQUARE, along)


def test_a_spectrum_is_per_row_in_any_direction():
    data = mirror_dataset(rows(SQUARE, (1, 1)), np.array([58e3]), Incidence(0.3, 3, 0.0))
    whole = (data["reflected"] + data["transmitted"]).sum("outgoing").values
    assert whole == pytest.approx(np.ones((1, 3, 3)), abs=1e-9)
    decay = data["kappa_imag"].values[0]
    assert data["attenuation"].values[0, 0] == pytest.approx(20 / np.log(10) * decay[0])
    assert np.abs(data["kappa_real"].values).max() <= np.pi + 1e-9


def test_discs_lie_in_their_row_as_pillars_do():
    discs = UnitCell(Lattice.triangular(PITCH), 1.5 * MM, ALUMINIUM, disc=(Disc(3 * MM, empty=True),))
    assert Rows(discs).depths == Rows(TRIANGULAR).depths != []
