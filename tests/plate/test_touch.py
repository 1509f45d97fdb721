"""The vibration below a finger, against dense solutions with the finger in them."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st
from small import COARSE, LOSS, busy_plate, drawn
from whole import dynamic

from haptonic.plate.body.model import PlateModel
from haptonic.plate.layout.keys import PLATE
from haptonic.plate.layout.parts import Finger, Force, Plate
from haptonic.plate.layout.supports import Support
from haptonic.plate.vibration import sweep
from haptonic.plate.vibration.modes import modes_between
from haptonic.plate.vibration.sweep import Band
from haptonic.plate.vibration.touch import Sites, _Compliance, _loaded_quality, below_finger
from haptonic.response import FrequencyResponse, disc_average

HZ = 2 * np.pi
DRIVES = {"A": 40.0, "F": 0.3 - 0.2j}
SPACING = 1.75e-3


@cache
def bare():
    return PlateModel.of(replace(busy_plate(), finger=None), 40e3, COARSE)


@cache
def bare_band():
    return Band.of(bare(), 0.0, 40e3)


@cache
def grid():
    layout = bare().plate.layout
    axes = [np.arange(SPACING / 2, lines[-1], SPACING) for lines in (layout.x, layout.y)]
    return np.stack([axis.ravel() for axis in np.meshgrid(*axes)], axis=1)


def free_field(omega):
    _, vibration = bare_band().answer(DRIVES, np.array([omega / HZ]), 1e-3)
    return (bare().displaced(grid(), vibration.vectors) @ vibration.amplitudes)[:, 0]


def with_a_finger(place, places, omega, stiffness):
    """Root mean square over the disc, from the whole complex matrix with the finger's share in it."""
    disc = places.discs[place]
    seen = bare().displaced(grid()[disc], np.eye(bare().assembly.size))
    matrix = dynamic(bare(), omega) + stiffness / len(disc) * seen.T @ seen
    moved = seen @ np.linalg.solve(matrix, bare().load(DRIVES))
    return np.sqrt((np.abs(moved) ** 2).mean())


@settings(max_examples=1)
@example(21e3, 0, 30.0, 1e6)  # in a corner the disc has fewer points
@given(st.floats(6e3, 34e3), st.integers(0, 5), st.floats(0.5, 60.0), st.floats(-2e6, 2e6))
def test_a_finger_anywhere_is_as_in_the_whole_matrix(frequency, which, damping, stiffness):
    omega = HZ * frequency
    places, stiff = Sites(grid(), 8e-3), stiffness + 1j * omega * damping
    amplitude = below_finger(bare_band().reduced, places, free_field(omega), omega, [0.0, stiff])
    place = np.linspace(0, len(grid()) - 1, 6).astype(int)[which]
    for row, value in enumerate((0.0, stiff)):
        exact = with_a_finger(place, places, omega, value)
        assert amplitude[row, place] == pytest.approx(exact, rel=5e-3)


def test_compliance_is_the_inverse_of_the_reduced_matrix():
    reduced, omega = bare_band().reduced, HZ * 21e3
    line = np.array([omega])
    matrix = np.diag(reduced.model.factors[PLATE] * reduced.basis.values - omega**2).astype(complex)
    for extra in reduced.extras:
        impedance = extra.unreduced.impedance(line)[0]
        matrix += impedance * (extra.kept @ extra.kept.T + np.diag(extra.alone[:, 0]))
    seen = bare().displaced(grid()[:9], reduced.basis.raw) @ reduced.basis.turn
    compliance = _Compliance(reduced, seen, omega).among(np.array([[0, 4, 8], [1, 2, 3]]))
    for points, block in zip(([0, 4, 8], [1, 2, 3]), compliance, strict=True):
        np.testing.assert_allclose(block, seen[points] @ np.linalg.solve(matrix, seen[points].T), rtol=1e-7)


def test_the_quality_with_a_finger_is_that_of_the_plate_with_one():
    """To first order in its damping, by the loss of the touched plate's modes."""
    damping, modes = (0.1, 0.2, 0.4), modes_between(bare_band(), 1e3, 40e3)
    layout = bare().plate.layout
    room = np.minimum(grid(), np.array([layout.x[-1], layout.y[-1]]) - grid()).min(axis=1)
    for k in (2, 5):
        omega = HZ * modes.frequency[k]
        near, quality = _loaded_quality(bare(), modes, DRIVES, omega, Sites(grid(), 8e-3), damping)
        assert near == pytest.approx(modes.frequency[k])
        assert quality[0] == pytest.approx(np.full(len(grid()), modes.quality[k]))
        place = int(np.where(room > 4e-3, quality[3], np.inf).argmin())  # where it is felt most
        finger = Finger(tuple(grid()[place]), 8e-3, mass=None, stiffness=0.0, damping=0.4)
        touched = modes_between(bare_band().touched(finger), 1e3, 40e3).quality[k]
        ours = 1 / quality[3, place] - 1 / quality[0, place]
        assert ours == pytest.approx(1 / touched - 1 / modes.quality[k], rel=0.15)
        assert ours == pytest.approx(4 * (1 / quality[1, place] - 1 / quality[0, place]))


def test_without_a_finger_it_is_the_average_over_the_disc():
    omega = HZ * 21e3
    field = free_field(omega)
    response = FrequencyResponse.of(
        field[None, :, None], frequency=np.array([21e3]), x=grid()[:, 0], y=grid()[:, 1],
        reference="A, V", origin="simulated", quantity="displacement",
    )  # fmt: skip
    amplitude = below_finger(bare_band().reduced, Sites(grid(), 8e-3), field, omega, [0.0])
    np.testing.assert_allclose(amplitude[0], disc_average(response, 8e-3).values[0], rtol=1e-5)


def test_a_finger_that_does_not_give_way_stops_the_plate():
    omega = HZ * 21e3
    free, held = below_finger(bare_band().reduced, Sites(grid(), 8e-3), free_field(omega), omega, [0.0, 1e13])
    assert (held < 1e-3 * free.max()).all()


def test_the_grid_of_a_disc_is_fine_enough():
    """Another grid of points below the same finger, the one that a plate with a finger of its own has."""
    omega, place = HZ * 21e3, len(grid()) // 2 + 5
    amplitude = below_finger(
        bare_band().reduced, Sites(grid(), 8e-3), free_field(omega), omega, [10j * omega]
    )
    finger = Finger(tuple(grid()[place]), 8e-3, mass=None, stiffness=0.0, damping=10.0)
    _, vibration = bare_band().touched(finger).answer(DRIVES, np.array([21e3]), 1e-2)
    disc = Sites(grid(), 8e-3).discs[place]
    moved = bare().displaced(grid()[disc], vibration.vectors) @ vibration.amplitudes
    assert amplitude[0, place] == pytest.approx(np.sqrt((np.abs(moved) ** 2).mean()), rel=0.05)


# -- a basis that misses nothing ----------------------------------------------------------------------


def test_crowded_modes_are_parted_and_missing_ones_found(monkeypatch):
    """With few and short chains modes are missing at first; the basis has to notice and to find them."""
    high = 80e3
    lattice = Plate(
        drawn("ooo ooo"),
        supports=(Support("left", "clamped"),),
        forces=(Force("F", (10e-3, 5e-3), None),),
        loss_factor=LOSS,
    )
    model = PlateModel.of(lattice, high, COARSE)
    full = Band.of(model, 0.0, high).reduced.basis
    assert full.incomplete == []
    for name, value in {"LENGTH": 1, "MODES": 10_000, "SPACING": 200e3, "ROUNDS": 0}.items():
        monkeypatch.setattr(sweep, name, value)
    assert Band.of(model, 0.0, high).reduced.basis.incomplete
    monkeypatch.setattr(sweep, "ROUNDS", 8)
    mended = Band.of(model, 0.0, high).reduced.basis
    assert mended.incomplete == []
    top = max(mended.below)
    assert (mended.values < top).sum() == mended.below[top] > 30
    for name, value in {"MODES": 3, "LENGTH": 8, "ROUNDS": 5}.items():
        monkeypatch.setattr(sweep, name, value)
    parted = sorted(Band.of(model, 0.0, high).reduced.basis.below.items())
    assert max(np.diff([below for _, below in parted])) <= sweep.CROWDED * 3


def test_modes_of_a_band_are_all_modes():
    modes = modes_between(bare_band(), 1e3, 40e3)
    assert (modes.error < 1e-3).all()
