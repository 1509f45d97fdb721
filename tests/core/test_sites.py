"""Cells with several pillars: honeycomb, kagome, Lieb, and sites anywhere on any lattice."""

from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import assume, given, settings, strategies as st
from strategies import ALUMINIUM, lattices, reference_cell
from truth import plain_plate

from daily import daily
from haptonic.bloch.bands import count_check
from haptonic.bloch.centred import CentredPencil, PhasedPencil, lattice_pencil
from haptonic.bloch.model import BlochModel
from haptonic.bloch.pencil import Periodic, eigenpairs
from haptonic.bloch.resolution import Resolution, meeting
from haptonic.bloch.tracking import diagram, group_velocity
from haptonic.bloch.truncation import TRUSTED_TRUNCATION, largest_truncation
from haptonic.cell import Pillar, PlacedTile, Site, UnitCell
from haptonic.errors import GeometryError
from haptonic.lattice import HALF_TURN, Lattice
from haptonic.superelement import TiledMesh, Tiling
from plies import PLY

PITCH, MM = 7e-3, 1e-3
THIN, TALL = Pillar(1.5 * MM, 5 * MM), Pillar(1.5 * MM, 5.5 * MM)
K = np.array([2 * np.pi / 3, 4 * np.pi / 3])
INSIDE = np.array([0.9, 0.4])
COARSE = Resolution(2, 1)


def named(name, *pillars, pillar=None):
    """A cell of a lattice with a pillar on each site, or one on all of them."""
    site = tuple(Site(pillar=on_site) for on_site in pillars)
    return UnitCell(Lattice(lattice=name, pitch=PITCH), 1.5 * MM, ALUMINIUM, pillar, site)


def placed(lattice, *sites):
    """A cell with sites (x, y, pillar), x and y in shares of the translations."""
    return UnitCell(lattice, 1.5 * MM, ALUMINIUM, site=tuple(Site(at=(x, y), pillar=p) for x, y, p in sites))


CELLS = {
    "honeycomb": named("honeycomb", pillar=THIN),
    "unequal honeycomb": named("honeycomb", THIN, TALL),
    "kagome": named("kagome", pillar=THIN),
    "lieb": named("lieb", pillar=THIN),
    "anywhere": placed(Lattice.square(PITCH), (0, 0, THIN), (1 / 3, 0.4, TALL)),
    "glide": placed(Lattice.rectangular(PITCH, 6 * MM), (0.2, 0.3, THIN), (0.7, 0.7, THIN)),
}
by_name = pytest.mark.parametrize("name", CELLS)


@cache
def model(name, order=3, rings=1):
    return BlochModel.of(CELLS[name], Resolution(order, rings), 8, measured=order == 3)


@cache
def paths(name):
    """The path around the zone, and the bands along it."""
    path = CELLS[name].zone.path(20)
    return path, diagram(model(name), path)


@cache
def whole(cell, order=2, steps=3, block=20):
    """The pencil before any reduction to a small basis, on the mesh that each tile has alone."""
    tiles = [placed.tile for placed in cell.tiles]
    plans = meeting(tiles, [Resolution(order, 1).plan(tile, tile.area / cell.area) for tile in tiles])
    return lattice_pencil(Tiling.condensed(cell, plans, steps, block, measured=False))


def hertz(cell, kappa, count=8, *size):
    values = eigenpairs(whole(cell, *size), kappa, count)[0]
    return np.sqrt(np.maximum(values, 0.0)) / (2 * np.pi)


# --- tiles --------------------------------------------------------------------------------------------------


@st.composite
def sites(draw, most=4):
    """A lattice and places of its sites, none too near to another, no side of a tile next to nothing."""
    lattice = draw(lattices())
    places = draw(st.lists(st.tuples(*2 * [st.floats(0, 0.999)]), min_size=1, max_size=most))
    try:
        return placed(lattice, *((x, y, None) for x, y in places))
    except GeometryError as error:
        assume(not error.argument.startswith("cell.site"))
        raise


@given(sites())
@settings(deadline=None)
def test_tiles_fill_the_period_edge_to_edge(cell):
    assert sum(placed.tile.area for placed in cell.tiles) == pytest.approx(cell.lattice.area, rel=1e-9)
    tiles = [placed.tile for placed in cell.tiles]
    plans = meeting(tiles, [COARSE.plan(tile) for tile in tiles])
    joint = TiledMesh.of(cell, plans).joint  # refuses edges that do not meet
    apart = joint.position - joint.shift @ cell.lattice.vectors - joint.position[joint.master]
    assert np.abs(apart).max() < 1e-6 * cell.lattice.pitch
    for site in cell.tiles:
        corners = site.points(np.column_stack([site.tile.corners, np.zeros(len(site.tile.corners))]))[:, :2]
        for n in (-1, 0, 1):
            for m in (-1, 0, 1):
                for share in cell.shares:
                    away = np.linalg.norm(corners - (share + np.array([n, m])) @ cell.lattice.vectors, axis=1)
                    own = np.linalg.norm(corners - site.position, axis=1)
                    assert (away > own * (1 - 1e-6)).all(), "a corner is nearest to its own site"


@pytest.mark.parametrize(
    ("name", "distinct", "sides"),
    [("honeycomb", 1, 3), ("unequal honeycomb", 2, 3), ("kagome", 1, 4), ("lieb", 2, 4), ("glide", 1, 6)],
)
def test_equal_tiles_are_one_object(name, distinct, sides):
    """Triangles, rhombi and squares: turned ones are condensed once."""
    tiles = [placed.tile for placed in CELLS[name].tiles]
    assert len({id(tile) for tile in tiles}) == distinct
    assert {len(tile.corners) for tile in tiles} == {sides}


@pytest.mark.parametrize("name", daily(["honeycomb", "kagome"], "honeycomb"))
def test_turned_tiles_have_the_bands_of_tiles_in_the_axes_of_the_cell(name):
    """Condensed once and turned, or each by itself on a mesh of its own orientation."""
    cell = CELLS[name]
    upright = []
    for number, placed in enumerate(cell.tiles):
        outline = tuple((float(x), float(y)) for x, y in cell.outlines[number])
        tile = replace(placed.tile, outline=outline)
        upright.append(PlacedTile(tile, np.eye(3), placed.position))
    plans = [COARSE.plan(placed.tile) for placed in upright]
    alone = replace(cell)
    alone.__dict__["tiles"] = tuple(upright)
    assert any(placed.is_turned for placed in cell.tiles)
    frequency, expected = (
        np.sqrt(
            eigenpairs(PhasedPencil.of(Tiling.condensed(each, plans, 4, 20, measured=False)), INSIDE, 8)[0]
        )
        for each in (cell, alone)
    )
    assert frequency == pytest.approx(expected, rel=1e-5)


def test_a_material_that_may_not_be_turned_keeps_its_axes():
    cell = replace(CELLS["kagome"], material=PLY)
    assert all(np.array_equal(np.abs(placed.turn), np.eye(3)) for placed in cell.tiles)
    assert len(cell.point_group) == 4


# --- one structure in two bases -----------------------------------------------------------------------------


def test_a_square_lattice_is_a_turned_and_doubled_one():
    cell = reference_cell()
    side = np.sqrt(2) * cell.lattice.pitch
    double = replace(
        cell,
        lattice=Lattice.square(side),
        pillar=None,
        site=(Site(at=(0, 0), pillar=cell.pillar), Site(at=(0.5, 0.5), pillar=cell.pillar)),
    )
    assert len(double.point_group) == 8
    k = np.array([110.0, 260.0])
    turn = np.array([[1, -1], [1, 1]]) / np.sqrt(2)  # from the axes of the simple cell to the other's
    waves = [k, k + 2 * np.pi / side * np.array([1, 0])]
    expected = np.concatenate([hertz(cell, cell.lattice.vectors @ (wave @ turn)) for wave in waves])
    assert hertz(double, double.lattice.vectors @ k) == pytest.approx(np.sort(expected)[:8], rel=1e-5)


def test_a_triangular_lattice_is_a_rectangle_with_two_sites():
    cell = UnitCell(Lattice.triangular(PITCH), 1.5 * MM, ALUMINIUM, Pillar(3.5 * MM, 9 * MM))
    sides = (PITCH, np.sqrt(3) * PITCH)
    double = placed(Lattice.rectangular(*sides), (0, 0, cell.pillar), (0.5, 0.5, cell.pillar))
    k = np.array([150.0, 90.0])
    waves = [k, k + np.array([2 * np.pi / sides[0], 0])]
    expected = np.concatenate([hertz(cell, cell.lattice.vectors @ wave) for wave in waves])
    assert hertz(double, double.lattice.vectors @ k) == pytest.approx(np.sort(expected)[:8], rel=1e-8)


def test_a_honeycomb_is_a_rectangle_with_four_sites():
    """Orthogonal faces, as tools without other lattices want them; bands fold once."""
    cell = CELLS["unequal honeycomb"]
    sides = (PITCH, np.sqrt(3) * PITCH)
    positions = cell.shares @ cell.lattice.vectors
    four = tuple(
        Site(position=tuple(float(v) % s for v, s in zip(place + move, sides, strict=True)), pillar=pillar)
        for place, pillar in zip(positions, cell.pillars, strict=True)
        for move in (np.zeros(2), cell.lattice.vectors[1])
    )
    double = UnitCell(Lattice.rectangular(*sides), cell.thickness, ALUMINIUM, site=four)
    k = np.array([170.0, -60.0])
    waves = [k, k + np.array([2 * np.pi / sides[0], 0])]
    expected = np.concatenate([hertz(cell, cell.lattice.vectors @ wave) for wave in waves])
    assert hertz(double, double.lattice.vectors @ k) == pytest.approx(np.sort(expected)[:8], rel=1e-6)


@pytest.mark.parametrize(
    "name",
    daily(CELLS, "unequal honeycomb"),
)
def test_the_origin_may_be_anywhere(name):
    """Sites moved together are the same structure."""
    cell = CELLS[name]
    moved = [((x + 0.13) % 1, (y + 0.42) % 1, p) for (x, y), p in zip(cell.shares, cell.pillars, strict=True)]
    lattice = Lattice.square(PITCH) if name == "lieb" else cell.lattice
    if name in ("honeycomb", "unequal honeycomb", "kagome"):
        lattice = Lattice.triangular(PITCH)
    other = placed(lattice, *moved)
    assert len(other.point_group) == len(cell.point_group)
    for kappa in (INSIDE, K):
        assert hertz(other, kappa) == pytest.approx(hertz(cell, kappa), rel=1e-6)


# --- symmetry -----------------------------------------------------------------------------------------------


def test_a_honeycomb_of_equal_pillars_is_degenerate_at_the_corner_to_rounding():
    """A third of a turn, and the half-turn, make pairs of the mesh's own dynamic stiffness."""
    cell = CELLS["honeycomb"]
    mesh = TiledMesh.of(cell, COARSE.plans(cell))
    periodic = Periodic.of_joint(mesh.joint)
    values = np.linalg.eigvalsh(periodic.hermitian(mesh.dynamic(2 * np.pi * 30e3).matrix, K))
    near = values[np.argsort(np.abs(values))][:24]
    near.sort()
    gaps = np.diff(near) / np.abs(values).max()
    assert (gaps < 1e-13).sum() >= 6, "pairs"
    frequency = model("honeycomb", 2, 0).solve(K).frequency
    assert frequency[2] == pytest.approx(frequency[1], rel=1e-5)


def test_unequal_pillars_open_a_gap_at_the_corner_in_proportion():
    widths = []
    for share in (0.01, 0.02, 0.04):
        other = replace(THIN, height=(1 + share) * THIN.height)
        low, high = hertz(named("honeycomb", THIN, other), K, 3)[1:]
        widths.append((high - low) / share)
    equal = hertz(named("honeycomb", THIN, THIN), K, 3)[1:]
    assert np.diff(equal)[0] < 1e-3 * widths[0] * 0.01
    assert widths[1] == pytest.approx(widths[0], rel=0.05)
    assert widths[2] == pytest.approx(widths[0], rel=0.1)


@pytest.mark.parametrize(
    ("name", "order", "half_turn"),
    daily(
        [
            ("honeycomb", 12, True),
            ("unequal honeycomb", 6, False),
            ("kagome", 12, True),
            ("lieb", 8, True),
            ("anywhere", 1, False),
            ("glide", 4, True),
        ],
        ("honeycomb", 12, True),
        ("unequal honeycomb", 6, False),
        ("glide", 4, True),
    ),
)
def test_the_group_is_that_of_lattice_and_sites(name, order, half_turn):
    cell = CELLS[name]
    assert len(cell.point_group) == order
    assert (HALF_TURN in cell.point_group) == half_turn
    assert type(whole(cell)) is (CentredPencil if half_turn else PhasedPencil)
    expected = hertz(cell, INSIDE)
    for operation in cell.point_group.operations:
        turned = np.linalg.inv(np.array(operation)).T @ INSIDE
        assert hertz(cell, turned) == pytest.approx(expected, rel=1e-5)
    assert hertz(cell, -INSIDE) == pytest.approx(expected, rel=1e-9), "time reversal"


@pytest.mark.nightly
@given(sites(2), st.floats(0.3, 0.6), st.floats(0.5, 2.0), st.floats(0.2, 0.4))
@settings(max_examples=1, deadline=None)
def test_bands_of_any_sites_have_the_symmetry_of_their_group(cell, width, height, plate):
    room = 2 * min(placed.tile.inradius for placed in cell.tiles)
    pillar = Pillar(width * room, height * room)
    cell = replace(
        cell,
        thickness=max(plate * cell.inradius, 0.01 * cell.lattice.pitch),
        site=tuple(replace(site, pillar=pillar if n % 2 == 0 else None) for n, site in enumerate(cell.site)),
    )
    expected = hertz(cell, INSIDE, 6, 2, 2, 10)
    images = [np.linalg.inv(np.array(operation)).T @ INSIDE for operation in cell.point_group.operations]
    for kappa in (-INSIDE, *images):
        assert hertz(cell, kappa, 6, 2, 2, 10) == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize(
    "name",
    ["kagome", *(pytest.param(name, marks=pytest.mark.nightly) for name in ("glide", "honeycomb", "lieb"))],
)
def test_modes_beside_a_mirror_are_even_or_odd(name):
    path, along = paths(name)
    for start, stop in pairwise(path.corners):
        assert (np.abs(along.parity[start + 1 : stop]) == 1).all(), "each side has its mirror"


def test_bands_at_a_corner_of_the_kagome_are_pairs_and_singles():
    path, along = paths("kagome")
    labels = dict(zip(path.labels, along.corner_symmetry, strict=True))
    assert "E" in labels["K"]
    assert "E" not in labels["M"]


@pytest.mark.nightly
@pytest.mark.parametrize("name", ["unequal honeycomb", "glide"])
def test_velocities_are_slopes(name):
    kappa, step = np.array([1.1, 0.7]), 1e-4
    fine = model(name)
    vectors = CELLS[name].lattice.vectors
    velocity = group_velocity(fine, fine.solve(kappa))
    for axis in range(2):
        away = vectors @ (step * np.eye(2)[axis] / PITCH)
        slope = (fine.solve(kappa + away).frequency - fine.solve(kappa - away).frequency) * np.pi
        assert velocity[:, axis] == pytest.approx(slope * PITCH / step, rel=1e-4, abs=2e-2)


# --- how far to trust them ----------------------------------------------------------------------------------


@pytest.mark.nightly
@pytest.mark.parametrize(
    "name",
    CELLS,
)
def test_the_estimates_hold_against_a_finer_mesh(name):
    """Order 4 errs by a part of what order 3 does."""
    coarse, fine = model(name), model(name, 4)
    for kappa in (INSIDE, *list(CELLS[name].zone.corner_phases.values())[1:3]):
        solution, better = coarse.solve(kappa), fine.solve(kappa)
        away = np.abs(solution.frequency - better.frequency)
        assert (away <= solution.error + better.error).all()
        assert (away > 0.01 * solution.error).any(), "and they are not far too large"


@pytest.mark.nightly
@pytest.mark.parametrize(
    "name",
    ["kagome", "unequal honeycomb", "glide"],
)
def test_no_band_is_missing(name):
    the_model = model(name)
    level = 0.5 * float(
        the_model.solve(np.zeros(2)).frequency[3] + the_model.solve(np.zeros(2)).frequency[-1]
    )
    checked, missed = count_check(the_model, [level, 0.7 * level, 1.05 * level])
    assert checked > 0
    assert missed == 0


@pytest.mark.nightly
@pytest.mark.parametrize(
    "name",
    ["unequal honeycomb", "kagome", "lieb"],
)
def test_a_tile_needs_its_share_of_the_bands_inside(name):
    """With an interior for all of them in each tile 24 bands of a Lieb lattice were estimated at 96 s."""
    cell, count = CELLS[name], 20
    asked = COARSE.for_bands(cell, count)
    the_model = BlochModel.of(cell, asked, count, measured=False)
    truncation, _ = largest_truncation(the_model.fine.tiling, count)
    assert truncation < TRUSTED_TRUNCATION
    more = BlochModel.of(cell, asked.grown(), count, measured=False).solve(INSIDE)
    away = the_model.solve(INSIDE).frequency - more.frequency
    assert (np.abs(away) <= truncation * more.frequency).all()
    alone = COARSE.for_bands(reference_cell(), count)
    assert asked.steps * asked.block < 0.7 * alone.steps * alone.block


@pytest.mark.nightly
@pytest.mark.parametrize(
    "name",
    ["honeycomb", "kagome", "lieb", "anywhere"],
)
def test_empty_sites_leave_the_waves_of_a_plate(name):
    """Rayleigh's and Lamb's, and shear ones, folded, within the estimates."""
    cell = CELLS[name].without_pillar()
    plain = BlochModel.of(cell, Resolution(4, 1), 8, measured=False)
    alike = UnitCell(
        Lattice.triangular(PITCH) if name in ("honeycomb", "kagome") else Lattice.square(PITCH),
        cell.thickness,
        ALUMINIUM,
    )
    for kappa in (INSIDE, *list(cell.zone.corner_phases.values())[1:]):
        solution = plain.solve(kappa)
        exact = plain_plate(alike, kappa, 8)
        assert (np.abs(solution.frequency - exact) <= solution.error).all()
        assert (np.abs(solution.frequency - exact) < 5e-3 * exact.max()).all()
