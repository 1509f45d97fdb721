"""Thin plates: plain ones against Kirchhoff's, and the estimated cost of a mesh."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from strategies import ALUMINIUM

from haptonic.bloch import mesh_levels
from haptonic.bloch.candidates import bloch_model
from haptonic.bloch.mesh_levels import MeshLimits, first_level
from haptonic.bloch.model import BlochModel
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.bloch.resolution import LEVELS, Resolution
from haptonic.bloch.settings import BandSettings
from haptonic.cell import Pillar, UnitCell
from haptonic.errors import NumericalError, ResourceError
from haptonic.lattice import Lattice
from haptonic.solvers import chosen
from haptonic.superelement import condense_by_parts

PITCH = 6e-3
PARTS = {"code", "argument", "given", "allowed", "cause", "next_step"}


def thin_cell(thickness, diameter=0.0, height=0.5):
    pillar = Pillar(PITCH * diameter, PITCH * height) if diameter else None
    return UnitCell(Lattice.square(PITCH), PITCH * thickness, ALUMINIUM, pillar)


def kirchhoff(cell, kappa, count):
    """Frequencies of bending waves, Hz, below those in the plane: omega = k^2 sqrt(D / (rho h))."""
    solid, orders = cell.material, np.arange(-5, 6)
    bending = solid.youngs_modulus * cell.thickness**2 / 12 / (1 - solid.poisson_ratio**2) / solid.density
    square = np.add.outer((kappa[0] + 2 * np.pi * orders) ** 2, (kappa[1] + 2 * np.pi * orders) ** 2)
    return np.sqrt(bending) * np.sort(square.ravel())[:count] / PITCH**2 / (2 * np.pi)


@pytest.mark.nightly
@given(st.floats(0.008, 0.016), st.floats(1.6, np.pi), st.floats(0.0, 0.3))
@settings(max_examples=2)
def test_plain_thin_plates_bend_as_kirchhoff_plates(thickness, along, across):
    cell, kappa = thin_cell(thickness), np.array([along, across])
    model = BlochModel.of(cell, LEVELS[1], 10)
    above = model.frequencies(kappa) / kirchhoff(cell, kappa, 10) - 1
    assert above.max() < min(2e-3, model.worst_error)
    assert above.min() > -120 * thickness**2 - 1e-3  # shear and rotation, which that theory leaves out


@given(st.floats(0.005, 0.3), st.floats(0.05, 0.97), st.floats(0.05, 6.0), st.sampled_from([10, 60]))
def test_the_cost_of_a_first_mesh_is_estimated(thickness, diameter, height, count):
    """It is started within the limit, or refused before it is."""
    cell = thin_cell(thickness, diameter, height)
    tried = LEVELS[1].for_bands(cell, count)
    limits = MeshLimits(60.0, 1e12)
    assert (limits.lack(cell, tried) is None) == (tried.seconds(cell) <= 60.0)
    if LEVELS[0].for_bands(cell, count).seconds(cell) > 60.0:
        with pytest.raises(ResourceError) as caught:
            first_level(cell, count, 2e-3, limits)
        assert caught.value.parts().keys() == PARTS
    else:
        assert first_level(cell, count, 2e-3, limits) <= 2


@pytest.fixture(autouse=True)
def memory_enough(monkeypatch):
    """What is refused here is refused for its time."""
    monkeypatch.setattr(mesh_levels.psutil, "virtual_memory", lambda: SimpleNamespace(available=1e12))


@pytest.mark.parametrize("diameter", [0.0, 0.5])
def test_a_stiffness_that_is_not_definite_ends_in_five_parts(monkeypatch, diameter):
    def spoilt(*_, **__):
        raise np.linalg.LinAlgError("the matrix is not definite")

    monkeypatch.setattr(chosen(), "factorise", spoilt)
    cell = replace(thin_cell(0.2, diameter), thickness=1.23e-3)
    with pytest.raises(NumericalError) as caught:
        condense_by_parts(cell, LEVELS[0].plan(cell))
    assert caught.value.parts().keys() == PARTS


@pytest.mark.filterwarnings("ignore:.*is unusual")
def test_a_small_basis_adds_no_bands_to_a_very_thin_plate():
    """Directions whose inertia is a rounding error would be bands below the exact ones."""
    model = BlochModel.of(thin_cell(0.005, 0.5, 13 / 6), Resolution(2, 0), 10)
    wavevectors, _ = model.cell.zone.triangles(3)
    for kappa in (*wavevectors[1:], np.array([1.0, 0.4])):  # at Gamma rest modes are rounding errors
        exact = hertz(eigenpairs(model.fine.whole, kappa, 10)[0])
        assert model.frequencies(kappa) == pytest.approx(exact, rel=2 * model.fine.projection_error)


@pytest.mark.nightly
@pytest.mark.parametrize("size", [(0.005, 0.5, 13 / 6), (0.01, 0.5, 0.5), (0.03, 0.2, 0.1)])
def test_thin_plates_with_pillars_are_answered(size):
    limits = MeshLimits(600.0, 8e9)
    model = bloch_model(thin_cell(*size), BandSettings(10, accuracy=2e-3), limits=limits)
    assert model.worst_error < 2e-3
    assert model.resolution.order <= 5


def test_errors_by_rounding_alone_are_no_reason_for_a_finer_mesh():
    model = BlochModel.of(thin_cell(0.2, 0.5, 1.0), Resolution(3, 0), 6)
    unit = 2 * np.pi * model.highest / 100  # rad/s, of modes at rest
    rounded = replace(model, fine=replace(model.fine, rounding=unit**2))
    kappa = np.array([0.3, 0.0])
    before, after = (each.solve(kappa) for each in (model, rounded))
    assert before.error[0] < 0.02 * before.frequency[0]
    assert after.error[0] > 0.05 * after.frequency[0]
    assert rounded.rest == pytest.approx(0.3 * model.highest)
    assert rounded.worst_error < model.worst_error + 1e-3
