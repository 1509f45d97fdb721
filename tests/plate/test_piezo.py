"""Piezoelectric patches on their own: closed forms of IEEE 176, reciprocity, energy."""

import json
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from fields import patch, total
from scipy.linalg import eigh
from scipy.optimize import brentq
from scipy.sparse.linalg import eigsh

from haptonic.materials import PiezoelectricMaterial, material
from haptonic.plate.body.piezo import electric_matrices, electric_part
from haptonic.plate.body.unreduced import BodyOrders, free_patch
from haptonic.plate.layout.keys import ceramic, electric
from motions import rigid_motions, unit_strains

REFERENCE = json.loads((Path(__file__).parents[1] / "data/piezo.json").read_text("utf-8"))
SOFT, HARD = material("pzt-5a"), material("pzt-4")


class Triclinic(PiezoelectricMaterial):
    """Coupling and permittivity without any symmetry, so that no two entries can be swapped unseen."""

    random = np.random.default_rng(5)
    coupling = random.normal(size=(3, 6))
    root = random.normal(size=(3, 3))
    permittivity = (root @ root.T + np.eye(3)) * 1e-9


TRICLINIC = Triclinic(**{field.name: getattr(HARD, field.name) for field in fields(HARD)})


def orders(along, ceramic):
    return BodyOrders(along=along, plate=1, bond=1, ceramic=ceramic)


def charge_constants(ceramic):
    """d (3, 6), m/V, and the permittivity at constant stress (3, 3), F/m."""
    d = np.array(ceramic.coupling) @ np.linalg.inv(ceramic.stiffness)
    return d, np.array(ceramic.permittivity) + d @ np.array(ceramic.coupling).T


def open_and_short(K, drive, capacitance):
    """Stiffness with both electrodes joined, and with no charge let in: V = -drive u / C."""
    return K, K + np.outer(drive, drive) / capacitance


@pytest.mark.parametrize("ceramic", [SOFT, HARD], ids=lambda solid: solid.name)
@pytest.mark.parametrize(("along", "through", "longest"), [(1, 1, 1.0), (2, 3, 5e-3)])
def test_a_free_patch_strains_and_charges_as_a_uniform_solid(ceramic, along, through, longest):
    """A positive voltage on the upper electrode makes a field against the poling: E_3 = -V / t."""
    actuator = patch(ceramic)
    length, width, t = actuator.size
    body = free_patch(actuator, orders(along, through), longest)
    d, free = charge_constants(ceramic)
    u = -(d[2] / t) @ unit_strains(body.points)
    force = body.drive["A"]
    assert np.abs(total(body) @ u - force).max() < 1e-10 * np.abs(force).max()
    charge = body.capacitance["A"] + force @ u
    assert charge == pytest.approx(free[2, 2] * length * width / t, rel=1e-10)
    assert body.capacitance["A"] == pytest.approx(ceramic.permittivity[2][2] * length * width / t, rel=1e-10)
    upper = body.points[:, 2] == body.points[:, 2].max()
    assert u.reshape(-1, 3)[upper, 2] == pytest.approx(-d[2, 2])  # of one volt, whatever the thickness
    assert (d[2, 0] < 0) & (d[2, 2] > 0)


def test_the_prototypes_patch_has_about_one_and_a_half_nanofarad():
    body = free_patch(patch(material("sm111")), orders(1, 1), 1.0)
    d, _ = charge_constants(HARD)
    u = -(d[2] / 0.7e-3) @ unit_strains(body.points)
    free = body.capacitance["A"] + body.drive["A"] @ u
    assert free == pytest.approx(1.5e-9, rel=0.02)
    assert 1 / (2 * np.pi * 58.8e3 * free) == pytest.approx(1.8e3, rel=0.02)
    assert body.capacitance["A"] < 0.6 * free


def half_wave(K, mass):
    """The lowest frequency above zero of a chain, Hz."""
    squared = eigh(K, np.diag(mass), eigvals_only=True)
    assert squared[0] == pytest.approx(0, abs=1e-9 * squared[1])
    return np.sqrt(squared[1]) / (2 * np.pi)


def test_thickness_mode():
    body = free_patch(patch(SOFT, (3e-3, 2e-3, 1e-3)), orders(2, 9), 2e-3)
    levels, number = np.unique(body.points[:, 2].round(12), return_inverse=True)
    uniform = np.zeros((3 * len(body.points), len(levels)))  # u_x = u_y = 0, u_z depends on z alone
    uniform[3 * np.arange(len(body.points)) + 2, number] = 1.0
    drive, mass = uniform.T @ body.drive["A"], uniform.T @ body.mass
    short, opened = open_and_short(uniform.T @ (total(body) @ uniform), drive, body.capacitance["A"])
    assert half_wave(short, mass) == pytest.approx(REFERENCE["thickness_1mm"]["fr"], rel=1e-6)
    assert half_wave(opened, mass) == pytest.approx(REFERENCE["thickness_1mm"]["fa"], rel=1e-6)


def test_shear_mode_between_electrodes_along_the_poling():
    """Electrodes at the ends of x, u_z(x): c_55 stiffened by e_15^2 / eps_11 [ieee176]."""
    length = 2e-3
    body = free_patch(patch(HARD, (length, 1e-3, 1e-3)), orders(8, 2), 1.0)
    x = body.points[:, 0]
    left, right = (np.flatnonzero(np.isclose(x, end, atol=1e-12)) for end in (-length / 2, length / 2))
    electric = electric_part(body.points, body.elements[ceramic("A")], HARD, left, right)
    places, number = np.unique(x.round(12), return_inverse=True)
    uniform = np.zeros((3 * len(x), len(places)))
    uniform[3 * np.arange(len(x)) + 2, number] = 1.0
    K = uniform.T @ (body.stiffness[ceramic("A")] @ uniform + electric.stiffness @ uniform)
    drive, mass = uniform.T @ electric.drive, uniform.T @ body.mass
    short, opened = open_and_short(K, drive, electric.capacitance)
    e, eps, c = HARD.coupling[0][4], HARD.permittivity[0][0], HARD.stiffness[4][4]
    stiffened = c + e**2 / eps
    antiresonance = np.sqrt(stiffened / HARD.density) / (2 * length)
    squared = e**2 / eps / stiffened  # coupling factor
    angle = brentq(lambda a: a - squared * np.tan(a), 0.1, np.pi / 2 - 1e-9)
    assert half_wave(opened, mass) == pytest.approx(antiresonance, rel=1e-8)
    assert half_wave(short, mass) == pytest.approx(antiresonance * angle / (np.pi / 2), rel=1e-8)


def bar_frequencies(width, thickness):
    """Resonance and antiresonance of a free bar of PZT-5A, 20 mm long, driven across its thickness, Hz."""
    body = free_patch(patch(SOFT, (20e-3, width, thickness)), orders(4, 2), 4e-3)
    K, drive = total(body), body.drive["A"]
    unit = np.sqrt(body.mass)
    scaled = (K / unit[:, None] / unit[None, :]).toarray()
    force = drive / unit
    frequencies = []
    for stiffness in open_and_short(scaled, force, body.capacitance["A"]):
        start = np.random.default_rng(1).standard_normal(len(unit))
        squared, modes = eigsh(stiffness, 8, sigma=(2 * np.pi * 71e3) ** 2, v0=start)
        driven = np.argmax((force @ modes) ** 2)  # bending and twisting do not answer to the voltage
        frequencies.append(np.sqrt(squared[driven]) / (2 * np.pi))
    return np.array(frequencies)


def sideways_inertia(frequency, width, thickness):
    """By how much the mass that moves sideways lowers a frequency of the 1D bar, to first order (Rayleigh).

    Along the bar u = sin(k x), and no stress is left at its ends: d_31 E = k cos(k L / 2). Across it
    S_2 = s_12 T + d_31 E and S_3 = s_13 T + d_33 E with T = (S_1 - d_31 E) / s_11.
    """
    s, (d, _), length = np.linalg.inv(SOFT.stiffness), charge_constants(SOFT), 20e-3
    k = 2 * np.pi * frequency * np.sqrt(SOFT.density * s[0, 0])
    x = np.linspace(0, length / 2, 2001)
    field = k * np.cos(k * length / 2) / d[2, 0]
    stress = (k * np.cos(k * x) - d[2, 0] * field) / s[0, 0]
    across = (s[0, 1] * stress + d[2, 0] * field) ** 2 * width**2
    through = (s[0, 2] * stress + d[2, 2] * field) ** 2 * thickness**2
    return np.trapezoid((across + through) / 12, x) / np.trapezoid(np.sin(k * x) ** 2, x) / 2


def test_a_bar_tends_to_the_length_mode_as_its_section_shrinks():
    """20 x 1 x 0.5 mm: 1.8e-4 and 2.7e-4 below the 1D resonance and antiresonance; half as wide a quarter."""
    exact = np.array(REFERENCE["bar31_20mm"])
    errors = []
    for width in (1e-3, 0.5e-3):
        errors.append(1 - bar_frequencies(width, width / 2) / exact)
        expected = [sideways_inertia(frequency, width, width / 2) for frequency in exact]
        assert errors[-1] == pytest.approx(expected, rel=0.03)
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2.0, abs=0.05)
    assert (errors[1] < 1e-4).all()


def bent(points):
    """A smooth map that leaves no face flat."""
    x, y, z = (points / np.abs(points).max(axis=0)).T
    curved = np.stack([y * z + 0.5 * x**2, x * z - 0.6 * z**2, x * y + 0.4 * y**2], axis=-1)
    return points + 0.12 * np.abs(points).max(axis=0) * curved


def curved_patch(solid):
    body = free_patch(patch(solid, (4e-3, 3e-3, 2e-3)), orders(3, 2), 2.5e-3)
    return body, bent(body.points)


def test_uniform_fields_have_the_energy_of_the_constants_in_curved_elements():
    solid = TRICLINIC
    body, points = curved_patch(solid)
    nodes = body.elements[ceramic("A")]
    matrices = electric_matrices(points, nodes, solid)
    flat = nodes.reshape(len(nodes), -1)
    slopes, strains = points.T, unit_strains(points).reshape(6, -1, 3)
    coupled = sum(
        np.einsum("an,nmk,smk->as", slopes[:, f], A, strains[:, f])
        for f, A in zip(flat, matrices.coupling, strict=True)
    )
    stored = sum(
        np.einsum("an,nm,bm->ab", slopes[:, f], P, slopes[:, f])
        for f, P in zip(flat, matrices.permittivity, strict=True)
    )
    volume = stored[0, 0] / solid.permittivity[0][0]
    assert volume == pytest.approx(24e-9, rel=0.2)  # m^3, about that of the straight box
    assert coupled / volume == pytest.approx(np.array(solid.coupling), rel=1e-9, abs=1e-12)
    assert stored / volume == pytest.approx(np.array(solid.permittivity), rel=1e-9, abs=1e-21)


def test_elimination_leaves_forces_charges_and_energy_as_they_were():
    """The same forces and charges from the whole system with every potential in it."""
    solid = TRICLINIC
    body, points = curved_patch(solid)
    nodes = body.elements[ceramic("A")]
    z = body.points[:, 2]
    glued, free = np.flatnonzero(z == 0.0), np.flatnonzero(z == z.max())
    electric = electric_part(points, nodes, solid, glued, free)
    count = len(points)
    assert np.array_equal(electric.nodes, np.arange(count))
    matrices = electric_matrices(points, nodes, solid)
    A, P = np.zeros((count, 3 * count)), np.zeros((count, count))
    for number, coupling, permittivity in zip(
        nodes.reshape(len(nodes), -1), matrices.coupling, matrices.permittivity, strict=True
    ):
        unknown = (3 * number[:, None] + np.arange(3)).ravel()
        A[np.ix_(number, unknown)] += coupling.reshape(len(number), -1)
        P[np.ix_(number, number)] += permittivity
    random = np.random.default_rng(2)
    u, voltage = random.normal(size=3 * count) * 1e-9, 7.0
    held = np.zeros(count)
    held[free] = voltage
    inner = np.setdiff1d(np.arange(count), np.concatenate([glued, free]))
    phi = held.copy()
    phi[inner] = np.linalg.solve(P[np.ix_(inner, inner)], (A @ u - P @ held)[inner])
    charge = P @ phi - A @ u
    assert np.abs(charge[inner]).max() < 1e-12 * np.abs(charge).max()
    assert charge[free].sum() == pytest.approx(-charge[glued].sum(), rel=1e-9)
    assert electric.capacitance * voltage + electric.drive @ u == pytest.approx(charge[free].sum(), rel=1e-9)
    forces = electric.stiffness @ u - electric.drive * voltage
    assert np.abs(forces - A.T @ phi).max() < 1e-10 * np.abs(forces).max()
    energy = 0.5 * (u @ electric.stiffness @ u + electric.capacitance * voltage**2)
    assert energy == pytest.approx(0.5 * phi @ P @ phi, rel=1e-9)
    assert np.linalg.eigvalsh(electric.stiffness).min() > -1e-12 * np.abs(electric.stiffness).max()
    motions = rigid_motions(points)
    assert (
        np.abs(electric.drive @ motions.T).max() < 1e-11 * (np.abs(electric.drive) @ np.abs(motions.T)).max()
    )


def test_a_potential_linear_through_the_patch_adds_no_stiffness():
    body = free_patch(patch(HARD), orders(2, 1), 1.0)
    assert abs(body.stiffness[electric("A")]).max() == 0.0
