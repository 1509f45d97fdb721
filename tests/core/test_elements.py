"""Spectral hexahedra on curved meshes: patch tests, rigid motions and mass against closed forms."""

from dataclasses import replace

import numpy as np
import pytest
from brute import assembled, dense
from hypothesis import given, settings, strategies as st
from strategies import cells, reference_cell

from haptonic.cell import MeshPlan, mesh_cell
from haptonic.elements import element_matrices
from haptonic.materials import IsotropicMaterial, elasticity_tensor
from motions import rigid_motions, unit_strains
from plies import PLY


@st.composite
def low_plans(draw, cell, order):
    """As for bands around the pillar, but a single layer of pillar and plate: the claims hold on any mesh."""
    suited = MeshPlan.suited(cell, order, draw(st.integers(0, 1)))
    return replace(suited, pillar_layers=1, plate_layers=1, upward=2, along=2)


@settings(max_examples=2)
@given(st.data(), st.sampled_from([PLY, IsotropicMaterial(200e9, 0.3, 7850.0, name="steel")]))
def test_constant_strains_have_the_energy_of_the_voigt_matrix(data, material):
    cell = data.draw(cells())
    mesh = mesh_cell(cell, data.draw(low_plans(cell, 2)))
    K, mass = assembled(mesh, material)
    volume = mass.sum() / 3 / material.density
    fields = unit_strains(mesh.points)
    energy = fields @ (K @ fields.T) / volume
    assert np.abs(energy - material.stiffness).max() < 1e-9 * material.stiffness.max()


@settings(max_examples=2)
@given(st.data())
def test_constant_stress_is_in_balance_inside_curved_meshes(data):
    cell = data.draw(cells())
    mesh = mesh_cell(cell, data.draw(low_plans(cell, 2)))
    K, _ = assembled(mesh, PLY)
    forces = (K @ unit_strains(mesh.points).T).reshape(-1, 3, 6)
    x, y, z = mesh.points.T
    half = 0.5 * np.diag(cell.lattice.vectors)
    on_lateral = (np.abs(np.abs(mesh.points[:, :2]) - half) < 1e-9 * cell.lattice.pitch).any(axis=1)
    in_plate = (z > 0) & (z < cell.thickness * (1 - 1e-9)) & ~on_lateral
    above = z > cell.thickness * (1 + 1e-9)
    at_top = z > (cell.thickness + cell.pillar.height) * (1 - 1e-9)
    in_pillar = above & ~at_top & (np.hypot(x, y) < cell.pillar.radius * (1 - 1e-9))
    assert in_plate.any()
    assert in_pillar.any()
    assert np.abs(forces[in_plate | in_pillar]).max() < 1e-9 * np.abs(forces).max()


@settings(max_examples=2)
@given(st.data())
def test_exactly_the_rigid_motions_are_free_of_energy(data):
    cell = data.draw(cells())
    mesh = mesh_cell(cell, data.draw(low_plans(cell, 2)))
    K, _ = assembled(mesh, PLY)
    motions = rigid_motions(mesh.points)
    largest = np.abs(K).max() * (motions**2).sum(axis=1)
    assert (np.abs(motions @ (K @ motions.T)).diagonal() < 1e-12 * largest).all()


def test_a_single_element_has_six_free_motions_and_no_more():
    """No hourglass modes, although nodes and quadrature points coincide."""
    mesh = mesh_cell(reference_cell(), MeshPlan(3, 1, 2, upward=2, thin=2))
    for family in mesh.topology.families:
        matrices = element_matrices(mesh.points, family.nodes, PLY)
        values = np.linalg.eigvalsh(dense(matrices))
        assert (np.abs(values[:, :6]) < 1e-13 * values[:, -1:]).all()
        assert (values[:, 6] > 1e-9 * values[:, -1]).all()  # thin elements bend easily, yet not freely


@settings(max_examples=2)
@given(st.data())
def test_element_matrices_are_symmetric(data):
    cell = data.draw(cells())
    mesh = mesh_cell(cell, data.draw(low_plans(cell, 2)))
    for family in mesh.topology.families:
        stiffness = dense(element_matrices(mesh.points, family.nodes[::7], PLY))
        assert np.abs(stiffness - stiffness.swapaxes(1, 2)).max() < 1e-12 * np.abs(stiffness).max()


@settings(max_examples=1)
@given(st.data())
def test_mass_and_its_moments_are_those_of_the_body(data):
    cell = data.draw(cells())
    mesh = mesh_cell(cell, data.draw(low_plans(cell, 3)))
    mass = np.zeros(len(mesh.points))
    for family in mesh.topology.families:
        for nodes in np.array_split(family.nodes, 1 + len(family.nodes) // 16):  # all at once take gigabytes
            np.add.at(mass, nodes.ravel(), element_matrices(mesh.points, nodes, cell.material).mass.ravel())
    assert mass.min() > 0
    rho, (e, h, r) = cell.material.density, (cell.thickness, cell.pillar.height, cell.pillar.radius)
    plate, cylinder = rho * cell.lattice.area * e, rho * np.pi * r**2 * h
    z = mesh.points[:, 2]
    assert mass.sum() == pytest.approx(plate + cylinder, rel=1e-6)
    assert mass @ z == pytest.approx(plate * e / 2 + cylinder * (e + h / 2), rel=1e-6)
    assert mass @ z**2 == pytest.approx(
        plate * e**2 / 3 + cylinder * ((e + h) ** 3 - e**3) / (3 * h), rel=1e-6
    )
    (ax, _), (_, ay) = cell.lattice.a1, cell.lattice.a2
    polar = mass @ (mesh.points[:, :2] ** 2).sum(axis=1)
    assert polar == pytest.approx(plate * (ax**2 + ay**2) / 12 + cylinder * r**2 / 2, rel=1e-6)


def test_the_tensor_is_that_of_hooke():
    steel = IsotropicMaterial(200e9, 0.3, 7850.0, name="steel")
    delta = np.eye(3)
    hooke = steel.lame * np.einsum("ik,jl->ikjl", delta, delta)
    hooke += steel.shear_modulus * (
        np.einsum("ij,kl->ikjl", delta, delta) + np.einsum("il,kj->ikjl", delta, delta)
    )
    assert elasticity_tensor(steel.stiffness) == pytest.approx(hooke)
