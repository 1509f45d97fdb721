"""Values at points of the flat face: positions exactly, smooth fields to the order's accuracy."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from strategies import ALUMINIUM, cells, plans, reference_cell

from daily import daily
from five_parts import refusing
from haptonic.cell import MeshPlan, Pillar, Step, UnitCell, mesh_cell
from haptonic.cell.quadrature import interpolation, lobatto
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.plate.body.surface import flat_faces, surface_weights

SQUARE = Lattice.square(7e-3)
CELLS = {
    "reference": reference_cell(),
    "plain": reference_cell().without_pillar(),
    "thin": UnitCell(SQUARE, 1.5e-3, ALUMINIUM, Pillar(0.7e-3, 10e-3)),
    "thick": UnitCell(SQUARE, 1.5e-3, ALUMINIUM, Pillar(6.8e-3, 10e-3)),
    "fillet": UnitCell(SQUARE, 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 14.7e-3, fillet=0.3e-3)),
    "stepped": UnitCell(SQUARE, 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 14.7e-3, step=Step(2e-3, 7e-3))),
    "square pillar": UnitCell(SQUARE, 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 14.7e-3, section="square")),
    "rectangular": UnitCell(Lattice.rectangular(8e-3, 7e-3), 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 14.7e-3)),
}


def meshed(name: str, order: int = 3, rings: int = 1):
    return mesh_cell(CELLS[name], MeshPlan.suited(CELLS[name], order, rings))


def half(cell: UnitCell) -> np.ndarray:
    return 0.5 * np.array([cell.lattice.a1[0], cell.lattice.a2[1]])


def even_points(cell: UnitCell, count: int = 41) -> np.ndarray:
    """A grid with the border, the corners and the middle of the cell."""
    along = np.linspace(-1, 1, count)
    return np.stack(np.meshgrid(along, along), axis=-1).reshape(-1, 2) * half(cell)


@pytest.mark.parametrize("name", daily(CELLS, "thin", "stepped"))
class TestEveryCell:
    def test_the_faces_tile_the_cell_once(self, name):
        """Their areas, by quadrature, add up to that of the cell, and none is turned over."""
        mesh, total = meshed(name), 0.0
        for nodes in flat_faces(mesh):
            (_, w1, D1), (_, w2, D2) = (lobatto(n - 1) for n in nodes.shape[1:])
            assert np.ptp(mesh.points[nodes][..., 2]) == 0.0
            x = mesh.points[nodes][..., :2]
            along, across = np.einsum("qi,kijc->kqjc", D1, x), np.einsum("qj,kijc->kiqc", D2, x)
            area = (along[..., 0] * across[..., 1] - along[..., 1] * across[..., 0]) * w1[:, None] * w2
            assert area.min() > 0
            total += area.sum()
        assert total == pytest.approx(CELLS[name].lattice.area, rel=1e-12)

    def test_positions_come_out_as_they_went_in(self, name):
        """The map of an element is made of the same polynomials as a field on it."""
        mesh, where = meshed(name), even_points(CELLS[name])
        weights = surface_weights(mesh.points, flat_faces(mesh), where)
        assert weights.shape == (len(where), len(mesh.points))
        assert abs(weights.sum(axis=1) - 1).max() < 1e-12
        size = CELLS[name].lattice.pitch
        assert np.abs(weights @ mesh.points[:, :2] - where).max() < 1e-12 * size
        assert np.abs(weights @ mesh.points[:, 2]).max() == 0.0

    def test_at_a_node_only_the_node_counts(self, name):
        mesh = meshed(name)
        nodes = np.unique(np.concatenate([face.ravel() for face in flat_faces(mesh)]))
        weights = surface_weights(mesh.points, flat_faces(mesh), mesh.points[nodes, :2])
        expected = np.zeros(weights.shape)
        expected[np.arange(len(nodes)), nodes] = 1.0
        assert np.abs(weights.toarray() - expected).max() < 1e-10
        assert weights.nnz == len(nodes), "zeros are not kept"

    def test_between_two_elements_it_does_not_matter_which(self, name):
        """Even a rough field is continuous: on a border and a hair beside it, only its nodes count."""
        mesh = meshed(name)
        faces = flat_faces(mesh)
        field = np.random.default_rng(3).normal(size=len(mesh.points))
        face = max(faces, key=len)
        nodes = lobatto(face.shape[2] - 1)[0]
        share = interpolation(nodes, np.linspace(-0.97, 0.97, 9))
        border = np.einsum("ti,kic->ktc", share, mesh.points[face[:, 0, :]][..., :2]).reshape(-1, 2)
        exact = np.einsum("ti,ki->kt", share, field[face[:, 0, :]]).ravel()
        hair = 1e-10 * CELLS[name].lattice.pitch
        for shift in ([0, 0], [hair, 0], [-hair, 0], [0, hair], [0, -hair]):
            inside = np.clip(border + shift, -half(CELLS[name]), half(CELLS[name]))
            values = surface_weights(mesh.points, faces, inside) @ field
            assert values == pytest.approx(exact, abs=1e-5)


@given(st.data())
def test_positions_come_out_for_any_cell_any_mesh_and_any_point(data):
    cell = data.draw(cells())
    mesh = mesh_cell(cell, data.draw(plans(cell)))
    shares = data.draw(st.lists(st.tuples(*2 * [st.floats(-1, 1)]), min_size=1, max_size=30))
    shares = [*shares, (1.0, 0.3), (-0.7, -1.0)]
    # sizes of tiles and positions are rounded apart: a point on a border may lie beside it by this, m
    where = np.array(shares) * half(cell) + 5e-12 * np.sign(shares)
    weights = surface_weights(mesh.points, flat_faces(mesh), where)
    size = 2 * half(cell).max()
    assert abs(weights.sum(axis=1) - 1).max() < 1e-12
    assert np.abs(weights @ mesh.points[:, :2] - where).max() < 1e-12 * size


@given(
    st.floats(0.02, 0.2), st.floats(0.3, 0.9), st.integers(2, 6), st.integers(1, 3), st.floats(0, 2 * np.pi)
)
def test_points_at_the_foot_of_a_pillar_on_a_thin_plate_are_found(plate, width, order, rings, turn):
    """Rings there are much thinner than they are long, and the circle lies just beside their borders."""
    cell = UnitCell(SQUARE, plate * 7e-3, ALUMINIUM, Pillar(width * 7e-3, 7e-3))
    mesh = mesh_cell(cell, MeshPlan.suited(cell, order, rings))
    where = 0.5 * width * 7e-3 * np.array([[np.cos(turn), np.sin(turn)]])
    weights = surface_weights(mesh.points, flat_faces(mesh), where)
    assert np.abs(weights @ mesh.points[:, :2] - where).max() < 1e-12 * 7e-3


def test_polynomials_on_straight_elements_are_exact():
    """Up to the order of the elements, four here, in either direction; one more is not."""
    cell = UnitCell(SQUARE, 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 14.7e-3, section="square"))
    mesh = mesh_cell(cell, MeshPlan.suited(cell, 2, 0))
    (core,) = (face for face in flat_faces(mesh) if face.shape == (1, 5, 5))
    reach = mesh.points[core.ravel(), :2].max()
    where = even_points(cell, 23) * reach / 3.5e-3
    weights = surface_weights(mesh.points, flat_faces(mesh), where)
    x, y = mesh.points[:, :2].T / reach

    def miss(power_x: int, power_y: int) -> float:
        exact = (where[:, 0] / reach) ** power_x * (where[:, 1] / reach) ** power_y
        return float(np.abs(weights @ (x**power_x * y**power_y) - exact).max())

    assert max(miss(i, j) for i in range(5) for j in range(5)) < 1e-12
    assert min(miss(5, 0), miss(0, 5)) > 1e-3


def test_a_smooth_field_converges_with_the_order():
    """Two orders more leave less than a tenth of the error; curved elements of low order spoil the slope."""
    wave = np.array([700.0, 450.0])  # rad/m, a wavelength of 7.5 mm
    errors = []
    for order in range(2, 7):
        mesh = meshed("reference", order)
        where = even_points(CELLS["reference"])
        weights = surface_weights(mesh.points, flat_faces(mesh), where)
        errors.append(np.abs(weights @ np.cos(mesh.points[:, :2] @ wave) - np.cos(where @ wave)).max())
    assert errors[0] < 0.1
    assert all(finer < coarser / 10 for coarser, finer in zip(errors[:-2], errors[2:], strict=True)), errors
    assert errors[-1] < 1e-4


def test_rounding_at_the_border_is_forgiven_and_more_is_not():
    mesh = meshed("reference")
    faces, edge = flat_faces(mesh), 3.5e-3
    for beyond in (1e-17, 1e-15):
        surface_weights(mesh.points, faces, np.array([[edge + beyond, 0.0], [-edge - beyond, edge + beyond]]))
    with refusing(
        GeometryError,
        "out-of-range",
        "points of the flat face",
        "1 of 2 beside it, the first at x = 3.501 mm",
    ):
        surface_weights(mesh.points, faces, np.array([[0.0, 0.0], [edge + 1e-6, 0.0]]))


@pytest.mark.parametrize("place", [(3.5, 0.0), (np.nan, 0.0), (0.0, -3.51e-3)])
def test_a_point_beside_the_tile_is_refused(place):
    mesh = meshed("reference")
    with refusing(GeometryError, "out-of-range", "points of the flat face"):
        surface_weights(mesh.points, flat_faces(mesh), np.array([place]))


def test_a_search_that_has_not_arrived_is_no_answer():
    """With too few steps a point is found where it is, or not at all."""
    mesh, refused = meshed("reference"), 0
    for place in even_points(CELLS["reference"], 9):
        try:
            weights = surface_weights(mesh.points, flat_faces(mesh), place[None], steps=2)
        except GeometryError:
            refused += 1
        else:
            assert np.abs(weights @ mesh.points[:, :2] - place).max() < 1e-6 * 7e-3
    assert 0 < refused < 81


def test_no_points_are_no_rows():
    mesh = meshed("reference")
    assert surface_weights(mesh.points, flat_faces(mesh), np.empty((0, 2))).shape == (0, len(mesh.points))
