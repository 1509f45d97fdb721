"""Energies of the highest polynomials, by elements of lifted modes, and as estimates of errors."""

import numpy as np
import pytest
from numpy.polynomial import legendre
from strategies import ALUMINIUM, reference_cell

from daily import daily
from haptonic.bloch import BlochModel, Resolution
from haptonic.bloch.pencil import Periodic, bloch_pencil, eigenpairs
from haptonic.cell import Disc, Pillar, UnitCell, mesh_cell
from haptonic.cell.quadrature import lobatto
from haptonic.elements import element_matrices
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.superelement import Tiling, on_each
from haptonic.superelement.surplus import (
    at_singular_edges,
    beyond_at_edge,
    energy_beyond,
    missing_energy,
    polynomial,
)

MM = 1e-3
SQUARE = Lattice.square(7 * MM)
HOLE = UnitCell(SQUARE, 2 * MM, ALUMINIUM, disc=(Disc(4 * MM, empty=True),))
COATED = UnitCell(
    SQUARE,
    1.5 * MM,
    ALUMINIUM,
    disc=(Disc(5 * MM, material=material("epoxy")), Disc(3 * MM, material=material("steel"))),
)
# a pillar with draft has no body without a mesh
DRAFTED = UnitCell(SQUARE, 1.5 * MM, ALUMINIUM, Pillar(3 * MM, 2 * MM, draft=0.1))
TURNED = UnitCell(Lattice.triangular(7 * MM), 1.5 * MM, ALUMINIUM, Pillar(3 * MM, 2 * MM, draft=0.1))
KAPPA = np.array([1.1, 2.3])


def part(values, axis, degree):
    """Part of values at the nodes of elements that has a hierarchical polynomial along an axis."""
    order = values.shape[axis] - 1
    basis = np.zeros((order + 1, order + 1))
    for number in range(order + 1):
        basis[number, number] = 1.0
        if number > 1:
            basis[number - 2, number] = -1.0
    at_nodes = legendre.legval(lobatto(order)[0], basis).T  # (nodes, polynomials)
    amplitudes = np.moveaxis(np.tensordot(np.linalg.inv(at_nodes), values, (1, axis)), 0, axis)
    chosen = np.zeros(order + 1)
    chosen[degree] = 1.0
    amplitudes = amplitudes * chosen.reshape([-1 if place == axis else 1 for place in range(values.ndim)])
    return np.moveaxis(np.tensordot(at_nodes, amplitudes, (1, axis)), 0, axis)


def energies(tile, mesh, fields):
    """(3, modes) the three energies, from the elements of the whole mesh."""
    topology, folding = mesh.topology, tile.parts[0].trace.folding
    at_edge = at_singular_edges(topology, tuple(map(tile.cell.solids.index, tile.cell.solids)))
    totals = np.zeros((3, fields.shape[2]))
    for family in topology.families:
        for nodes, region in zip(family.nodes, family.region, strict=True):
            matrices = element_matrices(mesh.points, nodes[None], tile.cell.solids[region])
            first, second = matrices.pairs
            representative, near = folding.node[nodes], at_edge[nodes].any()
            for axis in range(3):
                order = nodes.shape[axis] - 1
                if np.array_equal(representative, np.flip(representative, axis)):
                    wanted = [(1, order, 1), (1, order - 1, 1), (2, order - 2, 1), (2, order - 3, 1)]
                else:
                    smooth = 1 / 3 if tile.cell.pillar or axis == 1 else 1.0
                    wanted = [(0, order, beyond_at_edge(order) if near and axis != 1 else smooth)]
                for form, degree, factor in wanted:
                    if degree > 1:
                        moved = part(fields[nodes], axis, degree).reshape(nodes.size, *fields.shape[1:])
                        totals[form] += (
                            factor
                            * np.einsum(
                                "kim,kij,kjm->m", moved[first].conj(), matrices.stiffness[:, 0], moved[second]
                            ).real
                        )
    return totals


@pytest.mark.parametrize("name", daily(["hole", "coated", "square", "triangular"], "hole", "square"))
def test_forms_give_the_energies_of_lifted_modes(name):
    cell = {"hole": HOLE, "coated": COATED, "square": DRAFTED, "triangular": TURNED}[name]
    tiling = Tiling.condensed(cell, Resolution(3, 0).plans(cell), 2, 10, measured=False)
    pencil = bloch_pencil(tiling)
    _, modes = eigenpairs(pencil, KAPPA, 6)
    (tile,) = tiling.tiles
    unknowns = Periodic.of(tiling).expanded(modes, KAPPA)
    (mesh,) = tile.meshes
    rigid = tile.rigid_motions
    assert np.abs(tile.stiffness @ rigid).max() < 1e-9 * np.abs(tile.stiffness).max() * np.abs(rigid).max()
    momenta = rigid.T @ tile.mass
    deformed = unknowns - rigid @ np.linalg.solve(momenta @ rigid, momenta @ unknowns)
    exact = energies(tile, mesh, tiling.lifted(deformed))
    assert np.array([on_each(form, unknowns) for form in tiling.surplus]) == pytest.approx(exact, rel=1e-6)
    assert exact[0].min() > 0


@pytest.mark.parametrize(
    ("cell", "circles"),
    [
        (reference_cell(), {(reference_cell().pillar.radius, 1.0)}),
        (HOLE, set()),
        (COATED, {(2.5 * MM, 0.0), (2.5 * MM, 1.0), (1.5 * MM, 0.0), (1.5 * MM, 1.0)}),
    ],
    ids=["pillar", "hole", "coated"],
)
def test_stress_is_singular_at_re_entrant_edges_and_at_ends_of_interfaces(cell, circles):
    mesh = mesh_cell(cell, Resolution(4, 1).plan(cell))
    at_edge = at_singular_edges(mesh.topology, tuple(map(cell.solids.index, cell.solids)))
    x, y, z = mesh.points[at_edge].T
    edges = {
        (round(float(radius), 9), round(float(height), 6))
        for radius, height in zip(np.hypot(x, y), z / cell.thickness, strict=True)
    }
    assert edges == {(round(radius, 9), height) for radius, height in circles}


def test_a_polynomial_is_found_in_itself_and_not_in_those_of_lower_degree():
    points = lobatto(5)[0]
    values, share = polynomial(5, 5)
    assert share @ values == pytest.approx(1.0)
    assert np.abs(share @ np.stack([points**degree for degree in range(5)], axis=1)).max() < 1e-12
    assert np.abs(values[[0, -1]]).max() < 1e-12


def test_energy_beyond_a_degree_is_the_sum_of_a_power():
    degrees = np.arange(5, 200_000)
    assert beyond_at_edge(4) == pytest.approx(((4 / degrees) ** (4 * 0.5445 + 1)).sum(), rel=2e-2)


@pytest.mark.parametrize("inner", ["round", "square"])
def test_energies_fall_as_those_of_waves_around_outlines_without_corners(inner):
    """Corners count in all discs, not in the widest alone."""
    discs = (Disc(5 * MM, material=material("epoxy")), Disc(2 * MM, section=inner, empty=True))
    (placed,) = UnitCell(SQUARE, 1.5 * MM, ALUMINIUM, disc=discs).tiles
    along, across = (energy_beyond(placed.tile, axis, 4, np.array([True, False])) for axis in (1, 0))
    at_edge = [beyond_at_edge(4), 1.0]
    assert across == pytest.approx(at_edge)
    assert along == pytest.approx([1 / 3, 1 / 3] if inner == "round" else at_edge)


def test_smooth_energies_that_do_not_fall_are_missing_as_a_whole():
    ones = np.ones(1)
    assert missing_energy(0 * ones, ones, 0 * ones) == pytest.approx(1.0)
    assert missing_energy(0 * ones, ones, 0.5 * ones) == pytest.approx(1.0)
    assert missing_energy(ones, ones, 100 * ones) == pytest.approx(1.01)


@pytest.mark.parametrize("name", daily(["pillar", "hole", "coated"], "pillar", "hole"))
def test_estimates_bound_the_distance_to_a_finer_mesh(name):
    cell = {"pillar": reference_cell(), "hole": HOLE, "coated": COATED}[name]
    coarse, fine = (BlochModel.of(cell, Resolution(order, 1, 3, 24), 8, measured=False) for order in (3, 4))
    ratios = []
    for kappa in (KAPPA, np.array([np.pi, 0.4])):
        solution, exact = coarse.solve(kappa), fine.solve(kappa)
        away = np.abs(solution.frequency - exact.frequency)
        ratios += (solution.error / (away + exact.error)).tolist()
        assert (away < solution.error + exact.error).all()
    assert 1 < np.median(ratios) < 8
