"""Strips of crystal with free edges against the whole mesh of the strip, exact waves, and other bases."""

from dataclasses import replace

import numpy as np
import pytest
import scipy.sparse as sp
from brute import assembled, frequencies, periodic_projection
from strategies import ALUMINIUM
from test_ribbon import hertz, strip_waves

from daily import daily
from haptonic.bloch.model import BlochModel
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.ribbon import RibbonModel, bulk_bands
from haptonic.bloch.ribbon_modes import in_gap, within
from haptonic.cell import Disc, Pillar, Ribbon, Site, UnitCell, mesh_cell
from haptonic.lattice import Lattice
from haptonic.materials import material

MM = 1e-3
COARSE = Resolution(2, 0)
STEEL = material("steel")
PILLAR = Pillar(3.5 * MM, 9 * MM)


def on(lattice: Lattice, **features) -> UnitCell:
    return UnitCell(lattice, 1.5 * MM, ALUMINIUM, **features)


SQUARE = on(Lattice.square(7 * MM), pillar=PILLAR)
POST = (Disc(3 * MM, low=0.0, high=4 * MM, material=STEEL),)
SHORT = (Disc(3 * MM, low=0.0, high=3 * MM, material=STEEL),)
POSTS = on(Lattice.square(7 * MM), disc=POST)
# a pillar has a finer mesh of its own where it is condensed, so only discs have the meshes of the plans
STRIPS = {
    "one column": Ribbon((POSTS,)),
    "columns": Ribbon((POSTS,) * 2),
    "two sites": Ribbon((on(Lattice(lattice="honeycomb", pitch=8 * MM), site=(Site(disc=POST), Site())),)),
    "triangular": Ribbon((on(Lattice.triangular(7 * MM), disc=POST),) * 2),
    "diagonal": Ribbon((on(Lattice.oblique(7 * MM, 8 * MM, 1.2), disc=POST),) * 2, (1, 1)),
    "different lines": Ribbon((POSTS,), more=((on(Lattice.square(7 * MM), disc=SHORT),),)),
}
by_strip = pytest.mark.parametrize("name", daily(STRIPS, "one column"))


def of_whole_mesh(ribbon: Ribbon, kappa: float, count: int, resolution=COARSE) -> np.ndarray:
    """Hz, with the meshes of all tiles joined where nodes coincide: no condensation, no traces, no chain."""
    points, stiffness, mass = [], [], []
    for placed, plan in zip(ribbon.tiles, resolution.plans(ribbon), strict=True):
        mesh = mesh_cell(placed.tile, plan)
        K, weight = assembled(mesh, *placed.tile.solids)
        turn = sp.kron(sp.eye_array(mesh.topology.nodes), placed.turn)
        points.append(placed.points(mesh.points))
        stiffness.append(turn @ K @ turn.T)
        mass.append(weight)
    (period,) = ribbon.vectors
    beyond = 100 * np.array([period[1], -period[0]])  # farther than the strip is wide
    projection = periodic_projection(np.concatenate(points), np.array([beyond, period]), (0.0, kappa))
    return frequencies(sp.block_diag(stiffness, format="csr"), np.concatenate(mass), projection, count)


@by_strip
def test_waves_are_those_of_the_whole_mesh(name):
    ribbon = STRIPS[name]
    assert ribbon.kind == "strip"
    exact = of_whole_mesh(ribbon, 0.7, 6)
    high = 0.5 * (exact[-1] + exact[-2])
    frequency = hertz(ribbon, 0.7, 0.5 * exact[0], high, COARSE)
    assert len(frequency) == len(exact) - 1
    assert (frequency > exact[:-1] * (1 - 1e-7)).all(), "condensation restricts the motion"
    assert frequency == pytest.approx(exact[:-1], rel=1e-4)


@pytest.mark.nightly
def test_waves_of_pillars_are_those_of_the_whole_mesh():
    ribbon = Ribbon((SQUARE,))
    exact = of_whole_mesh(ribbon, 0.7, 4, Resolution(3, 0))
    frequency = hertz(ribbon, 0.7, 0.5 * exact[0], 1.01 * exact[-1], Resolution(3, 0))
    assert frequency == pytest.approx(exact, rel=1e-3)


# --- identities and exact waves -----------------------------------------------------------------------------


@pytest.mark.parametrize("columns", [1, 2])
def test_discs_of_the_plates_own_material_leave_the_exact_waves_of_a_bare_strip(columns):
    """The crystal is an inclusion of aluminium in aluminium: Legendre polynomials over the whole section."""
    plate = on(Lattice.square(4 * MM), disc=(Disc(2 * MM, low=-1.5 * MM, high=0.0, material=ALUMINIUM),))
    ribbon = Ribbon((plate,) * columns)
    assert ribbon.kind == "strip"
    kappa, zone = 0.9, 2 * np.pi / (4 * MM)
    modes = RibbonModel.of(ribbon, Resolution(3, 0)).solve(kappa, 5e3, 300e3)
    waves = [strip_waves(columns * 4 * MM, 1.5 * MM, kappa / (4 * MM) + n * zone) for n in (-1, 0, 1)]
    exact = np.sort(np.concatenate(waves))
    exact = exact[(exact > 5e3) & (exact < 300e3)]
    assert len(modes.frequency) == len(exact) >= 4
    assert (np.abs(modes.frequency - exact) <= modes.error + 1e-5 * exact).all()
    assert modes.frequency == pytest.approx(exact, rel=4e-3)


def test_columns_of_one_site_are_one_column_of_several():
    """A cell as wide as the strip, with a pillar of each column as a site; discs alike."""
    for feature in ({"pillar": PILLAR}, {"disc": POST}):
        sites = tuple(Site(at=(0.5 * n, 0.0), **feature) for n in range(2))
        wide = Ribbon((on(Lattice.rectangular(14 * MM, 7 * MM), site=sites),))
        strip = Ribbon((on(Lattice.square(7 * MM), **feature),) * 2)
        of_strip, of_wide = (hertz(ribbon, 0.9, 2e3, 80e3, COARSE) for ribbon in (strip, wide))
        assert len(of_strip) > 5
        assert of_wide == pytest.approx(of_strip, rel=1e-3)


def test_a_strip_and_its_mirror_image_have_the_same_waves():
    """A column of two unequal pillars; in the image they are exchanged."""
    pillars = (PILLAR, Pillar(3 * MM, 6 * MM))

    def strip(*order):
        site = tuple(Site(at=(0.5 * n, 0.0), pillar=pillar) for n, pillar in enumerate(order))
        return Ribbon((on(Lattice.rectangular(14 * MM, 7 * MM), site=site),) * 2)

    frequencies, of_image = (
        hertz(strip(*order), 0.9, 5e3, 40e3, COARSE) for order in (pillars, pillars[::-1])
    )
    assert len(frequencies) > 4
    assert of_image == pytest.approx(frequencies, rel=1e-6)


@pytest.mark.nightly
def test_errors_bound_the_distance_to_a_finer_mesh():
    draw = np.random.default_rng(39)
    width, height = draw.uniform([2 * MM, 2 * MM], [4.5 * MM, 9 * MM])
    cell = on(Lattice.square(7 * MM), pillar=Pillar(width, height))
    ribbon, kappa = Ribbon((cell,) * int(draw.integers(1, 3))), draw.uniform(0.1, 3.0)
    modes = RibbonModel.of(ribbon, Resolution(3, 1)).solve(kappa, 2e3, 70e3)
    ends = 0.97 * modes.frequency.min(), 1.002 * modes.frequency.max()
    exact = hertz(ribbon, kappa, *ends, Resolution(4, 2))[: len(modes.frequency)]
    assert len(exact) == 7
    assert (np.abs(modes.frequency - exact) < modes.error).all()


# --- waves of free edges ------------------------------------------------------------------------------------


def test_waves_between_the_bulk_bands_are_those_of_the_free_edges():
    """In the gap of the crystal a wide strip has waves at its edges only, in pairs of equal frequency."""
    strip = Ribbon((SQUARE,) * 8)
    bulk = bulk_bands(BlochModel.of(SQUARE, COARSE, 10, measured=False), strip, [2.0])
    modes = RibbonModel.of(strip, COARSE).solve(2.0, 20e3, 90e3)
    apart = in_gap(replace(modes, error=3e-3 * modes.frequency), bulk)  # more than phases across leave out
    assert np.argwhere(strip.guide).tolist() == [[0, 0], [0, 7]]
    assert within(modes.energy, strip.guide)[apart].min() > 0.8
    pairs = modes.frequency[apart].reshape(-1, 2)
    assert len(pairs)
    assert np.ptp(pairs, axis=1).max() < 1e-3 * pairs.min()
