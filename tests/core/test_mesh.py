"""Meshes of the cell: volumes, orientation, symmetry and periodicity, from coordinates alone."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from strategies import ALUMINIUM, cells, plans, reference_cell, upright_lattices

from five_parts import refusing
from haptonic.bloch.candidates import bloch_model
from haptonic.bloch.settings import BandSettings
from haptonic.cell import HexMesh, MeshPlan, Pillar, UnitCell, mesh_cell
from haptonic.cell.orders import PRISM_LAYER, layers_along
from haptonic.cell.quadrature import lobatto
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.superelement import repeated


def volumes_of(mesh: HexMesh):
    """Shares of the volume that the quadrature points represent, m^3, of the plate and of the pillar."""
    plate, pillar = [np.empty(0)], [np.empty(0)]
    for family in mesh.topology.families:
        (_, w1, D1), (_, w2, D2), (_, w3, D3) = (lobatto(n - 1) for n in family.nodes.shape[1:])
        x = mesh.points[family.nodes]
        along = [
            np.moveaxis(np.tensordot(D, x, axes=(1, axis)), 0, axis)
            for axis, D in ((1, D1), (2, D2), (3, D3))
        ]
        jacobian = np.einsum("...i,...i->...", along[0], np.cross(along[1], along[2]))
        volumes = jacobian * w1[:, None, None] * w2[:, None] * w3
        plate.append(volumes[~family.in_pillar].ravel())
        pillar.append(volumes[family.in_pillar].ravel())
    return np.concatenate(plate), np.concatenate(pillar)


def nodes_of(mesh: HexMesh, *, in_pillar: bool):
    """Numbers of the nodes of the pillar's elements, or of the plate's."""
    families = mesh.topology.families
    return np.unique(np.concatenate([f.nodes[f.in_pillar == in_pillar].ravel() for f in families]))


@given(st.data())
def test_no_element_is_turned_inside_out(data):
    cell = data.draw(cells())
    plate, pillar = volumes_of(mesh_cell(cell, data.draw(plans(cell))))
    assert min(plate.min(), pillar.min()) > 0


@given(st.data())
def test_volume_is_that_of_plate_and_cylinder(data):
    cell = data.draw(cells())
    order = data.draw(st.integers(2, 6))
    mesh = mesh_cell(cell, MeshPlan.suited(cell, order, data.draw(st.integers(0, 3))))
    plate, pillar = volumes_of(mesh)
    # straight sides: the plate is exact at any order; the circle is a polynomial of order + 2
    assert plate.sum() == pytest.approx(cell.lattice.area * cell.thickness)
    cylinder = np.pi * cell.pillar.radius**2 * cell.pillar.height
    assert pillar.sum() == pytest.approx(cylinder, rel={2: 1e-4, 3: 1e-5, 4: 1e-6, 5: 1e-7, 6: 1e-8}[order])


def test_volume_converges_spectrally():
    cell = reference_cell()
    exact = np.pi * cell.pillar.radius**2 * cell.pillar.height
    errors = []
    for order in (1, 2, 3, 4, 5, 6):
        _, pillar = volumes_of(mesh_cell(cell, MeshPlan(order, 1, 3)))
        errors.append(abs(pillar.sum() / exact - 1))
    # two orders more gain at least as much as the two before them: faster than any power
    gains = np.log(np.array(errors[:-2]) / errors[2:])
    assert (gains > np.log(30)).all()
    assert errors[-1] < 1e-9


@given(st.data())
def test_body_reaches_exactly_to_its_faces(data):
    cell = data.draw(cells())
    mesh = mesh_cell(cell, data.draw(plans(cell)))
    top = cell.thickness + cell.pillar.height
    assert mesh.points[:, 2].min() == 0.0
    assert mesh.points[:, 2].max() == pytest.approx(top)
    half = 0.5 * np.abs(np.diag(cell.lattice.vectors))
    assert np.abs(mesh.points[:, :2]).max(axis=0) == pytest.approx(half)
    pillar = mesh.points[nodes_of(mesh, in_pillar=True)]
    assert pillar[:, 2].min() == pytest.approx(cell.thickness)
    assert np.hypot(*pillar[:, :2].T).max() == pytest.approx(cell.pillar.radius)
    plate = mesh.points[nodes_of(mesh, in_pillar=False)]
    assert plate[:, 2].max() == pytest.approx(cell.thickness)


def test_a_plan_with_one_layer_along_the_pillar_reaches_its_top():
    cell = reference_cell()
    mesh = mesh_cell(cell, MeshPlan(order=2, foot_rings=0, pillar_layers=1))
    assert mesh.points[:, 2].max() == pytest.approx(cell.thickness + cell.pillar.height)


@given(st.data())
def test_nodes_are_distinct_and_all_used(data):
    cell = data.draw(cells())
    mesh = mesh_cell(cell, data.draw(plans(cell, highest=4)))
    assert len(mesh.points) == mesh.topology.nodes
    assert mesh.unknowns == 3 * mesh.topology.nodes
    used = np.union1d(nodes_of(mesh, in_pillar=True), nodes_of(mesh, in_pillar=False))
    assert np.array_equal(used, np.arange(mesh.topology.nodes))
    assert len(np.unique(np.round(mesh.points / cell.lattice.pitch, 10), axis=0)) == len(mesh.points)


def turned(points, operation):
    """Points after an operation on lattice coordinates, for lattices with axes along x and y."""
    sizes = np.abs(points[:, :2]).max(axis=0)
    return np.column_stack([(points[:, :2] / sizes) @ np.array(operation).T * sizes, points[:, 2]])


@given(st.data())
def test_permutations_move_nodes_as_the_symmetry_does(data):
    cell = data.draw(cells())
    mesh = mesh_cell(cell, data.draw(plans(cell, highest=4)))
    everywhere = np.arange(mesh.topology.nodes)
    for operation in cell.point_group.operations:
        move = mesh.topology.permutation(cell.moved_sides(cell.point_group.turn(operation)))
        assert np.array_equal(np.sort(move), everywhere)
        away = mesh.points[move] - turned(mesh.points, operation)
        assert np.abs(away).max() < 1e-10 * cell.lattice.pitch
        if np.array_equal(np.array(operation) @ np.array(operation), np.eye(2)):
            assert np.array_equal(move[move], everywhere)


@given(st.data())
def test_the_rim_repeats_by_whole_translations(data):
    cell = data.draw(cells())
    mesh = mesh_cell(cell, data.draw(plans(cell)))
    topology, pitch = mesh.topology, cell.lattice.pitch
    rim = mesh.points[topology.rim]
    number, shift = repeated(rim[0, :, :2], cell.lattice.vectors)
    master = rim[:, number]
    offset = shift @ cell.lattice.vectors
    assert np.abs(rim[..., :2] - offset - master[..., :2]).max() < 1e-12 * pitch
    assert np.array_equal(rim[..., 2], master[..., 2])
    assert np.array_equal(number[number], number)
    # exactly the nodes on the lateral faces, once each; a quarter plus the corner repeat nothing
    half = 0.5 * np.diag(cell.lattice.vectors)
    lateral = (np.abs(np.abs(mesh.points[:, :2]) - half) < 1e-9 * pitch).any(axis=1)
    assert np.array_equal(np.sort(topology.rim.ravel()), np.flatnonzero(lateral))
    own = (shift == 0).all(axis=1)
    assert own.sum() == 2 * topology.plan.side - 1
    assert np.array_equal(np.unique(number), np.flatnonzero(own))
    assert (rim[1:, :, 2] > rim[:-1, :, 2]).all()


@given(cells(), cells(), st.integers(1, 4), st.integers(0, 2))
def test_topology_does_not_depend_on_sizes(cell, other, order, foot_rings):
    plan = MeshPlan(order, foot_rings, 3)
    assert mesh_cell(cell, plan).topology is mesh_cell(other, plan).topology
    assert mesh_cell(cell, plan).topology is not mesh_cell(cell, replace(plan, pillar_layers=4)).topology


@given(upright_lattices(), st.floats(0.05, 1.0), st.integers(1, 5))
def test_the_plain_plate_is_a_box(lattice, share, order):
    cell = UnitCell(lattice, share * lattice.pitch, ALUMINIUM)
    mesh = mesh_cell(cell, MeshPlan.suited(cell, order, 2))
    plate, pillar = volumes_of(mesh)
    assert len(pillar) == 0
    assert plate.min() > 0
    assert plate.sum() == pytest.approx(lattice.area * cell.thickness)


@given(st.integers(0, 8), st.floats(1e-4, 1e-2), st.floats(0.01, 100.0))
def test_layers_along_a_pillar_that_lie_between_two_numbers_scale_with_it(count, diameter, factor):
    pillar = Pillar(diameter=diameter, height=(count + 0.5) * PRISM_LAYER * diameter)
    larger = Pillar(diameter=factor * pillar.diameter, height=factor * pillar.height)
    assert layers_along(larger) == layers_along(pillar) == [count + 2]


@given(cells(), st.floats(0.01, 100.0))
def test_meshes_scale_with_the_cell(cell, factor):
    plan = MeshPlan.suited(cell, 3, 1)
    larger = cell.scaled(factor)
    assert MeshPlan.suited(larger, 3, 1) == plan
    assert np.allclose(
        mesh_cell(larger, plan).points,
        factor * mesh_cell(cell, plan).points,
        rtol=1e-12,
        atol=1e-12 * larger.lattice.pitch,
    )


@settings(max_examples=20)
@given(st.data())
def test_subcells_for_drawing_fill_the_body_in_the_order_of_vtk(data):
    cell = data.draw(cells())
    mesh = mesh_cell(cell, data.draw(plans(cell, highest=3)))
    corners = mesh.points[mesh.linear_subcells()]
    # VTK_HEXAHEDRON: 0 1 2 3 round the base, 4 5 6 7 above them; six tetrahedra fill it
    split = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
    volume = 0.0
    for tetrahedron in split:
        a, b, c, d = (corners[:, i] for i in tetrahedron)
        shares = np.einsum("ni,ni->n", np.cross(b - a, c - a), d - a) / 6
        assert shares.min() > -1e-12 * cell.lattice.pitch**3
        volume += shares.sum()
    circle = np.pi * cell.pillar.radius**2 * cell.pillar.height
    assert volume == pytest.approx(cell.lattice.area * cell.thickness + circle, rel=0.06)


@pytest.mark.parametrize(
    "change", [{"diameter": 7.2e-3}, {"diameter": -1e-3}, {"height": 0.0}, {"height": np.nan}]
)
def test_impossible_pillars_are_refused(change):
    with refusing(GeometryError, "out-of-range", "", "cell.pillar"):
        replace(reference_cell(), pillar=replace(Pillar(3.5e-3, 14.7e-3), **change))


def test_a_pillar_must_leave_room_on_the_shorter_side():
    wide = Lattice.rectangular(8e-3, 4e-3)
    with refusing(GeometryError, "out-of-range", "cell.pillar.diameter"):
        UnitCell(wide, 1e-3, ALUMINIUM, Pillar(4.5e-3, 5e-3))
    assert UnitCell(wide, 1e-3, ALUMINIUM, Pillar(3e-3, 5e-3)).clearance == pytest.approx(0.5e-3)


def test_a_fillet_that_reaches_beyond_the_cell_is_blamed_itself():
    filleted = replace(reference_cell().pillar, fillet=2.6e-3)
    with refusing(GeometryError, "out-of-range", "cell.pillar.fillet", "less than 1.68 mm"):
        replace(reference_cell(), pillar=filleted)
    just = replace(filleted, fillet=1.679e-3)
    assert replace(reference_cell(), pillar=just).clearance == pytest.approx(0.071e-3)


@pytest.mark.parametrize("pillar", [None, Pillar(3e-3, 13e-3)], ids=["plain", "pillar"])
@given(thickness=st.floats(1e-9, 2.39e-5))
def test_plates_too_thin_for_any_digit_are_refused_at_once(thickness, pillar):
    with refusing(GeometryError, "out-of-range", "cell.thickness", "at least 0.024 mm"):
        bloch_model(UnitCell(Lattice.square(6e-3), thickness, ALUMINIUM, pillar), BandSettings())
