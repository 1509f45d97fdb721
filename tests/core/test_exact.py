"""Modes of the mesh itself against the whole mesh's matrices."""

import math
from functools import cache

import numpy as np
import pytest
from brute import assembled, frequencies, periodic_projection
from strategies import ALUMINIUM, reference_cell

from daily import daily
from haptonic.bloch.exact import exact_modes
from haptonic.bloch.pencil import bloch_pencil, eigenpairs
from haptonic.cell import MeshPlan, Pillar, Step, UnitCell
from haptonic.lattice import Lattice
from haptonic.superelement import TiledMesh

MM = 1e-3
ALL = Pillar(4 * MM, 9 * MM, "round", math.radians(2), 0.6 * MM, Step(2.6 * MM, 4 * MM))
CELLS = {
    "reference": reference_cell(),
    "all at once": UnitCell(Lattice.rectangular(8 * MM, 6 * MM), 1.5 * MM, ALUMINIUM, ALL),
}
GENERIC, CORNER, ORIGIN = np.array([1.1, -0.4]), np.full(2, np.pi), np.zeros(2)
COUNT = 9
by_name = pytest.mark.parametrize("name", daily(CELLS, "all at once"))


@cache
def small(name):
    """A folded mesh of second order, and its condensation."""
    cell = CELLS[name]
    plan = MeshPlan.suited(cell, 2, 1)
    shared = TiledMesh.of(cell, [MeshPlan(2, 1, *(plan.pillar_layers, plan.step_layers))])
    return shared, shared.condensed(2, 10, measured=False)


@cache
def whole(name):
    """(K, mass) of the whole mesh."""
    (shared,) = small(name)[0].meshes
    return assembled(shared.mesh, shared.cell.material)


def projection(name, kappa):
    """Bloch fields of the mesh whose trace is the polynomial through the thickness that a cell has."""
    (shared,) = small(name)[0].meshes
    mesh = shared.mesh
    return periodic_projection(
        mesh.points, shared.cell.lattice.vectors, kappa, shared.through, mesh.topology.rim
    )


@cache
def brute(name, kappa):
    return frequencies(*whole(name), projection(name, np.array(kappa)), COUNT)


def guesses(name, kappa):
    """(COUNT,) rad/s, of the reduced model."""
    return np.sqrt(np.maximum(eigenpairs(bloch_pencil(small(name)[1]), kappa, COUNT)[0], 0.0))


@by_name
@pytest.mark.parametrize(
    "kappa", [GENERIC, pytest.param(CORNER, marks=pytest.mark.nightly)], ids=["inside", "corner"]
)
def test_exact_frequencies_are_those_of_the_whole_mesh(name, kappa):
    expected = brute(name, tuple(kappa))
    guess = guesses(name, kappa)
    assert np.abs(guess / (2 * np.pi) / expected - 1).max() > 1e-6, "there is something to put right"
    for band in range(COUNT):
        modes = exact_modes(small(name)[0], kappa, guess[band])
        nearest = expected[np.abs(expected - modes.omega / (2 * np.pi)).argmin()]
        assert modes.omega / (2 * np.pi) == pytest.approx(nearest, rel=1e-9)
        alike = np.abs(expected[: COUNT - 1] / nearest - 1) < 1e-7
        if alike.any():  # the last band may be one of a pair that goes on
            assert modes.fields.shape[2] == alike.sum()
    # none of the lower ones is passed over
    lowest = [exact_modes(small(name)[0], kappa, w).omega / (2 * np.pi) for w in guess[:5]]
    assert lowest == pytest.approx(list(expected[:5]), rel=1e-9)


def test_a_pair_at_the_origin_is_found_as_a_pair():
    name, kappa = "reference", ORIGIN
    expected, guess = brute(name, tuple(kappa)), guesses(name, kappa)
    assert expected[3] == pytest.approx(expected[4], rel=1e-10), "bending along x and along y"
    for band in (3, 4, 6, 7, 8):
        modes = exact_modes(small(name)[0], kappa, guess[band])
        assert modes.omega / (2 * np.pi) == pytest.approx(expected[band], rel=1e-9)
        assert modes.fields.shape == (len(modes.fields), 3, 1 if band == 8 else 2)


def test_a_mode_that_hardly_moves_its_trace_is_found():
    shared, _ = small("reference")
    poor = shared.condensed(1, 4, measured=False)
    expected = brute("reference", tuple(ORIGIN))[5]
    guess = np.sqrt(eigenpairs(bloch_pencil(poor), ORIGIN, 6)[0][5])
    assert guess / (2 * np.pi) == pytest.approx(expected, rel=1e-5), "not a bad guess"
    modes = exact_modes(shared, ORIGIN, float(guess))
    assert modes.omega / (2 * np.pi) == pytest.approx(expected, rel=1e-9)


CASES = [
    ("reference", GENERIC, 5),
    ("reference", ORIGIN, 3),
    ("all at once", GENERIC, 4),
    ("all at once", CORNER, 6),
]


@pytest.mark.parametrize(("name", "kappa", "band"), CASES)
def test_fields_are_orthonormal_bloch_waves_without_a_residual(name, kappa, band):
    tiled = small(name)[0]
    (shared,), joint = tiled.meshes, tiled.joint
    modes = exact_modes(tiled, kappa, guesses(name, kappa)[band])
    fields = modes.fields
    K, mass = whole(name)
    flat = fields.reshape(-1, fields.shape[2])
    gram = flat.conj().T @ (mass[:, None] * flat)
    assert np.abs(gram - np.eye(fields.shape[2])).max() < 1e-9
    rayleigh = flat.conj().T @ (K @ flat)
    assert np.abs(rayleigh / modes.omega**2 - np.eye(fields.shape[2])).max() < 1e-8

    topology = shared.mesh.topology
    phase = np.exp(1j * (joint.shift @ kappa))
    rim = fields[topology.rim]
    repeated = phase[None, :, None, None] * rim[:, joint.master]
    assert np.abs(rim - repeated).max() < 1e-12 * np.abs(rim).max()
    trace = modes.trace.reshape(shared.levels, topology.rim.shape[1], 3, -1)
    assert np.abs(rim - np.tensordot(shared.through, trace, axes=1)).max() < 1e-12 * np.abs(rim).max()

    P = projection(name, kappa)
    inertia = modes.omega**2 * (mass[:, None] * flat)
    residual = P.conj().T @ (K @ flat - inertia)
    assert np.abs(residual).max() < 1e-8 * np.abs(P.conj().T @ inertia).max()


def test_a_guess_two_percent_off_finds_the_same_mode():
    name = "all at once"
    guess = guesses(name, GENERIC)[4]
    here, there = (exact_modes(small(name)[0], GENERIC, guess * share) for share in (1.0, 1.02))
    assert there.omega == pytest.approx(here.omega, rel=1e-10)
