"""Lattices whose cells have six sides, from mesh to bands: triangular, centred and oblique ones."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from strategies import ALUMINIUM, lattices
from truth import plain_plate

from daily import daily
from five_parts import refusing
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.model import BlochModel
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.symmetry import clusters
from haptonic.bloch.tracking import diagram, group_velocity
from haptonic.cell import MeshPlan, Pillar, Site, UnitCell, mesh_cell
from haptonic.elements import element_matrices
from haptonic.errors import HaptonicError
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.study import loads
from haptonic.superelement import FoldedMesh, Tiling, repeated
from plies import PLY

PITCH = 7e-3
LATTICE = Lattice.triangular(PITCH)
CELL = UnitCell(LATTICE, 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 14.7e-3))
PLAIN = CELL.without_pillar()
CENTRED = Lattice.centred(PITCH, PITCH * np.sqrt(3))  # the triangular one
TILTED = Lattice.oblique(7e-3, 6e-3, 1.1)


@cache
def model(cell: UnitCell, order: int = 3) -> BlochModel:
    return BlochModel.of(cell, Resolution(order, 1), 10)


@given(lattices(), st.floats(0.1, 0.9), st.floats(0.1, 3.0), st.floats(0.05, 0.5), st.integers(2, 4))
@settings(max_examples=2)
def test_any_cell_is_filled_once_and_moved_by_its_operations(lattice, width, height, plate, order):
    wide = 2 * lattice.inradius
    cell = UnitCell(lattice, plate * wide, ALUMINIUM, Pillar(width * wide, height * wide))
    plan = MeshPlan.suited(cell, order, 1)
    mesh = mesh_cell(cell, plan)
    volume = 0.0
    for family in mesh.topology.families:
        mass = element_matrices(mesh.points, family.nodes, ALUMINIUM).mass
        assert mass.min() > 0
        volume += mass.sum() / ALUMINIUM.density
    exact = lattice.area * cell.thickness + np.pi * (0.5 * width * wide) ** 2 * height * wide
    assert volume == pytest.approx(exact, rel=3e-4)
    for operation in cell.point_group.operations:
        moved = mesh.points @ cell.point_group.turn(operation).T
        nodes = mesh.topology.permutation(cell.moved_sides(cell.point_group.turn(operation)))
        assert np.abs(mesh.points[nodes] - moved).max() < 1e-9 * wide
    rim = mesh.points[mesh.topology.rim]
    master, shift = repeated(rim[0, :, :2], lattice.vectors)
    assert np.abs(rim[..., :2] - shift @ lattice.vectors - rim[:, master, :2]).max() < 1e-12 * lattice.pitch


@pytest.mark.parametrize(
    "lattice",
    daily(
        [
            Lattice.centred(8e-3, 13e-3),
            Lattice.centred(8e-3, 8.1e-3),
            TILTED,
        ],
        TILTED,
    ),
    ids=["centred", "nearly square", "oblique"],
)
def test_plain_plates_of_any_lattice_have_their_waves_folded(lattice):
    plain = UnitCell(lattice, 1.5e-3, ALUMINIUM)
    for kappa in (*list(plain.zone.corner_phases.values())[1:], np.array([0.7, -1.3])):
        solution = model(plain).solve(kappa)
        assert (np.abs(solution.frequency - plain_plate(plain, kappa, 10)) <= solution.error).all()


@pytest.mark.nightly
@pytest.mark.parametrize("sides", [(8e-3, 13e-3), (8e-3, 8.1e-3)])
def test_a_centred_lattice_is_a_rectangle_with_two_pillars(sides):
    """Quarters of the rectangle with and without a pillar, of other meshes, have both wavevectors."""
    cell = UnitCell(Lattice.centred(*sides), 1.5e-3, ALUMINIUM, Pillar(2e-3, 10e-3))
    pillars = {(0, 0): cell.pillar, (0.5, 0): None, (0, 0.5): None, (0.5, 0.5): cell.pillar}
    sites = tuple(Site(at=at, pillar=pillar) for at, pillar in pillars.items())
    quarters = replace(cell, lattice=Lattice.rectangular(*sides), pillar=None, site=sites)
    assert all(placed.tile.is_upright for placed in quarters.tiles)
    tiling = Tiling.condensed(quarters, Resolution(4, 1).plans(quarters), 3, 20, measured=False)
    k = np.array([60.0, 95.0])
    values, _ = eigenpairs(lattice_pencil(tiling), k * sides, 12)
    solutions = [
        model(cell).solve(cell.lattice.vectors @ (k + turn)) for turn in ([0, 0], [2 * np.pi / sides[0], 0])
    ]
    frequency = np.concatenate([solution.frequency for solution in solutions])
    error = np.concatenate([solution.error for solution in solutions])[np.argsort(frequency)][:12]
    assert (np.abs(np.sort(frequency)[:12] - np.sqrt(values) / (2 * np.pi)) <= error).all()


STOUT = UnitCell(LATTICE, 1.5e-3, material("aluminium-2017a"), Pillar(5.5e-3, 6e-3))
FINER = {  # Hz by phases / pi, with order 5 and three rings at the foot
    (1, 1): [25240.4, 49162.5, 77213.2, 108601.8, 170853.1, 195913.5, 251606.1, 272549.7, 299165.9, 300558.7],
    (2 / 3, 4 / 3): [
        36866.3, 36866.3, 85115.9, 108394.9, 188806.4, 188806.5, 260009.3, 260010.1, 286032.7, 321245.1
    ],
    (5 / 6, 7 / 6): [
        28978.5, 44755.3, 81305.8, 108474.9, 177275.9, 194216.2, 252850.3, 278034.1, 279340.6, 313469.3
    ],
    (1 / 2, 1 / 2): [
        13682.5, 46792.2, 63489.8, 102497.5, 127307.3, 161536.1, 262005.7, 269220.0, 294709.7, 320435.2
    ],
}  # fmt: skip


@pytest.mark.parametrize("order", daily([3, 4, 5], 3))
def test_the_truth_is_within_the_estimates_of_a_stout_pillar(order):
    the_model = BlochModel.of(STOUT, Resolution(order, 1, 4, 24), 10, measured=False)
    ratios = []
    for phases, exact in FINER.items():
        solution = the_model.solve(np.pi * np.array(phases))
        ratios.append(solution.error / np.abs(solution.frequency - exact))
    assert np.min(ratios) > 1
    assert np.median(ratios) < 20


@pytest.mark.parametrize(
    "lattice", [LATTICE, Lattice.square(PITCH), Lattice(lattice="honeycomb", pitch=2 * PITCH)]
)
@pytest.mark.parametrize("order", [3, 4, 5, 6])
def test_a_quarter_turn_has_at_least_its_order_however_many_blocks_share_it(lattice, order):
    whole = MeshPlan.suited(replace(CELL, lattice=Lattice.square(PITCH)), order, 1)
    tile = UnitCell(lattice, 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 14.7e-3)).tiles[0].tile
    plan = MeshPlan.suited(tile, order, 1)
    assert whole.per_quarter == whole.order <= plan.per_quarter <= whole.order + 2
    assert plan.lowered(tile).per_quarter < plan.per_quarter


def test_a_longer_translation_spans_the_same_lattice():
    longer = Lattice.oblique(PITCH, PITCH * np.sqrt(7), np.arctan2(np.sqrt(3), 5))
    assert longer.vectors == pytest.approx(Lattice.oblique(PITCH, PITCH, np.pi / 3).vectors)


@pytest.mark.parametrize(
    "lattice",
    daily(
        [Lattice.oblique(PITCH, PITCH, np.pi / 3), CENTRED],
        CENTRED,
    ),
    ids=["oblique", "centred"],
)
def test_a_triangular_lattice_is_an_oblique_one_of_equal_pitches(lattice):
    """With fewer symmetries the basis differs, so the two agree within the error of one."""
    k = np.array([130.0, 210.0])
    expected, solution = (
        model(replace(CELL, lattice=each)).solve(each.vectors @ k) for each in (LATTICE, lattice)
    )
    assert (np.abs(solution.frequency - expected.frequency) < expected.error).all()


@pytest.mark.parametrize("order", [3, 4])
@pytest.mark.parametrize("share", [0.2, 0.6, 1.0])
@pytest.mark.parametrize("side", ["M", "K"])
def test_a_plain_plate_has_its_waves_folded_into_the_zone(order, share, side):
    """Rayleigh's and Lamb's waves, and shear ones, within the estimates."""
    kappa = share * PLAIN.zone.corner_phases[side]
    solution = model(PLAIN, order).solve(kappa)
    exact = plain_plate(PLAIN, kappa, 10)
    assert (np.abs(solution.frequency - exact) <= solution.error).all()
    assert (np.abs(solution.frequency - exact) < (6e-3 if order == 3 else 1.5e-3) * exact.max()).all()


def test_pairs_of_the_six_fold_axis_and_of_the_corner_are_pairs():
    """At K a third of a turn makes pairs, whatever the mesh; at Γ there are two kinds of them."""
    corners = CELL.zone.corner_phases
    at_corner = model(CELL).solve(corners["K"])
    assert np.diff(at_corner.frequency[:2])[0] < 1e-4 * at_corner.frequency[0]
    path = CELL.zone.path(20)
    labels = dict(zip(path.labels, diagram(model(CELL), path).corner_symmetry, strict=True))
    assert labels["K"][:2] == ["E", "E"]
    assert "E" in labels["Γ"]
    assert "E" not in labels["M"]


def test_the_bands_have_the_symmetry_of_the_lattice():
    kappa = np.array([0.9, 0.4])
    pencil = model(CELL).fine.whole
    values = [
        np.sqrt(eigenpairs(pencil, np.linalg.inv(np.array(op)).T @ kappa, 8)[0])
        for op in CELL.point_group.operations
    ]
    assert np.ptp(values, axis=0).max() < 1e-4 * np.max(values)


def test_velocities_are_slopes():
    kappa, step = np.array([1.1, 0.7]), 1e-4
    fine = model(CELL)
    velocity = group_velocity(fine, fine.solve(kappa))
    for axis in range(2):
        away = LATTICE.vectors @ (step * np.eye(2)[axis] / PITCH)
        slope = (fine.solve(kappa + away).frequency - fine.solve(kappa - away).frequency) * np.pi
        assert velocity[:, axis] == pytest.approx(slope * PITCH / step, rel=1e-4, abs=1e-2)


def test_a_diagram_goes_from_the_centre_to_m_and_k():
    path = CELL.zone.path(66)
    assert path.labels == ("Γ", "M", "K", "Γ")
    along = diagram(model(CELL), path)
    for start, stop in zip(path.corners, path.corners[1:], strict=False):
        assert (np.abs(along.parity[start + 1 : stop]) == 1).all(), "each side has its mirror"
    assert len(clusters(along.frequency[path.corners[0]])) < 10


def test_a_material_with_two_mirrors_leaves_a_larger_zone():
    """A quarter of the whole zone in place of a twelfth: two corners K and two middles M that differ."""
    cell = replace(CELL, material=PLY)
    assert len(cell.point_group) == 4
    assert [label for label, _ in cell.zone.corners] == ["Γ", "M", "K", "M\N{PRIME}", "K\N{PRIME}"]
    plain = cell.without_pillar()
    the_model = BlochModel.of(plain, Resolution(3, 1), 8)
    for kappa in list(cell.zone.corner_phases.values())[1:]:
        solution = the_model.solve(kappa)
        assert (np.abs(solution.frequency - plain_plate(plain, kappa, 8)) <= solution.error).all()


def test_a_hexagon_may_have_a_square_pillar():
    """The lumped mass is that of the exact volume, and the group what a square and a hexagon share."""
    cell = UnitCell(LATTICE, 1.5e-3, ALUMINIUM, Pillar(3e-3, 5e-3, section="square"))
    assert len(cell.point_group) == 4
    mass = FoldedMesh.of(cell, MeshPlan.suited(cell, 3, 1)).nodal_mass.sum()
    volume = cell.area * cell.thickness + cell.pillar.volume
    assert mass == pytest.approx(ALUMINIUM.density * volume, rel=1e-9)


STUDY = """
title = "Triangular"
carrier = "60 kHz"
material = "aluminium-2017a"
[cell]
lattice = "triangular"
pitch = "7 mm"
thickness = "1.5 mm"
[cell.pillar]
diameter = "3.5 mm"
height = "14.7 mm"
"""


PLATE = """
[plate]
map = '''
oo
oo
'''
loss_factor = 1e-3
[plate.tiles]
o = "lattice"
"""


SHAPES = {
    'lattice = "triangular"\npitch = "7 mm"': LATTICE,
    'lattice = "centred"\npitch = "7 mm"\npitch_y = "9 mm"': Lattice.centred(7e-3, 9e-3),
    'lattice = "oblique"\npitch = "7 mm"\npitch_2 = "8 mm"\nangle = "70 deg"': Lattice.oblique(
        7e-3, 8e-3, np.radians(70)
    ),
}


@pytest.mark.parametrize("text", SHAPES)
def test_a_study_may_have_any_lattice(text):
    written = STUDY.replace('lattice = "triangular"\npitch = "7 mm"', text)
    study = loads(written)
    assert study.cell.lattice == SHAPES[text]
    assert loads(study.to_toml()) == study
    if study.cell.lattice.name == "oblique":  # whose rows are offset by no simple share
        with refusing(HaptonicError, "unsupported", "study: cell.lattice"):
            loads(written + PLATE)
    else:
        assert loads(written + PLATE).mounted_plate().layout.standing


@pytest.mark.parametrize(
    ("text", "key"),
    [
        ('lattice = "centred"', "cell.pitch_y"),
        ('lattice = "centred"\npitch_y = "7 mm"', "cell.lattice"),
        ('lattice = "oblique"\npitch_2 = "8 mm"', "cell.angle"),
        ('lattice = "oblique"\npitch_2 = "8 mm"\nangle = "90 deg"', "cell.lattice"),
        ('lattice = "oblique"\npitch_2 = "8 mm"\nangle = "180 deg"', "cell.angle"),
        ('lattice = "oblique"\npitch_2 = "8 mm"\nangle = "70 deg"\npitch_y = "7 mm"', "cell.pitch_y"),
        ('lattice = "square"\nangle = "70 deg"', "cell.angle"),
    ],
)
def test_sizes_that_give_no_such_lattice_are_refused(text, key):
    with pytest.raises(HaptonicError) as caught:
        loads(STUDY.replace('lattice = "triangular"', text))
    assert caught.value.argument.endswith(key)
