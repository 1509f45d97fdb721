"""Shapes out of responses that are known in closed form."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from hypothesis.extra.numpy import arrays

from haptonic.response import mac
from haptonic.updating.shapes import Shapes, can_identify, pairs, resolved, shapes_of

LINES = np.arange(1e3, 20e3, 10.0)
FREQUENCY = np.array([3e3, 7.4e3, 8.1e3, 14e3])
DAMPING = np.array([0.004, 0.003, 0.004, 0.005])
SHAPE = np.random.default_rng(0).standard_normal((4, 25))


def receptance(frequency=FREQUENCY, damping=DAMPING):
    """(lines, points) of viscously damped modes, driven alike."""
    omega, own = 2 * np.pi * LINES[:, None], 2 * np.pi * frequency
    return (1 / (own**2 - omega**2 + 2j * damping * own * omega)) @ SHAPE[: len(frequency)]


@pytest.mark.parametrize("velocity", [False, True])
def test_modes_are_identified(velocity):
    assert can_identify()
    response = receptance() * (2j * np.pi * LINES[:, None] if velocity else 1)
    shapes = shapes_of(LINES, response, "modes")
    assert shapes.how == "modes"
    assert shapes.frequency == pytest.approx(FREQUENCY, rel=1e-4)
    assert shapes.damping == pytest.approx(DAMPING, rel=0.02)
    assert np.diag(mac(shapes.shape, SHAPE)) == pytest.approx(np.ones(4), abs=2e-3)


def test_modes_of_a_narrow_band_far_from_zero_are_identified():
    """As a plate has them around its carrier: six within a sixth of their frequency."""
    lines = np.arange(50e3, 60e3, 50.0)
    own = np.array([51.4e3, 51.95e3, 53.58e3, 56.74e3, 57.75e3, 59.6e3])
    shape = np.random.default_rng(1).standard_normal((6, 40))
    s = 2j * np.pi * lines[:, None]
    velocity = (s / ((2 * np.pi * own) ** 2 + s**2 + 2 * 1.3e-3 * (2 * np.pi * own) * s)) @ shape
    noise = np.random.default_rng(2).standard_normal((2, *velocity.shape))
    noisy = velocity + 1e-3 * np.abs(velocity).max() * (noise[0] + 1j * noise[1])
    shapes = shapes_of(lines, noisy, "modes")
    assert shapes.frequency == pytest.approx(own, abs=10)
    assert shapes.damping == pytest.approx(np.full(6, 1.3e-3), rel=0.1)
    assert (np.diag(mac(shapes.shape, shape)) > 0.98).all()


@pytest.mark.parametrize(("step", "enough"), [(50.0, True), (120.0, True), (130.0, False), (200.0, False)])
def test_modes_need_two_lines_in_their_half_power_width(step, enough):
    lines = np.arange(45e3, 55e3 + step / 2, step)
    assert resolved(lines, 5e-3) == enough


def test_operating_shapes_are_the_response_at_its_peaks():
    shapes = shapes_of(LINES, receptance(), "operating shapes")
    assert shapes.how == "operating shapes"
    assert shapes.frequency == pytest.approx(FREQUENCY, rel=1e-3)
    assert (np.diag(mac(shapes.shape, SHAPE)) > 0.95).all()


def test_width_of_a_lone_peak_is_its_damping():
    """The energy of one mode near its resonance: half of it at f (1 +- damping)."""
    shapes = shapes_of(LINES, receptance(FREQUENCY[:1], DAMPING[:1]), "operating shapes")
    assert shapes.frequency == pytest.approx([3e3], rel=1e-4)
    assert shapes.damping == pytest.approx([0.004], rel=0.02)


def test_a_peak_narrower_than_the_lines_has_no_width():
    shapes = shapes_of(LINES, receptance(FREQUENCY[:1], np.array([2e-4])), "operating shapes")
    assert np.isnan(shapes.damping).all()


def test_a_flat_response_has_no_shapes():
    shapes = shapes_of(LINES, np.ones((len(LINES), 3), complex), "modes")
    assert not len(shapes.frequency)
    assert pairs(shapes, shapes) == []


complex_numbers = st.complex_numbers(min_magnitude=0.1, max_magnitude=10, allow_nan=False)


@given(
    arrays(complex, (3, 6), elements=complex_numbers),
    arrays(complex, 3, elements=complex_numbers),
    st.permutations(range(6)),
)
def test_the_criterion_is_blind_to_factors_and_to_the_order_of_points(shapes, factors, order):
    own = mac(shapes, shapes)
    assert np.diag(own) == pytest.approx(np.ones(3))
    assert own == pytest.approx(own.T)
    assert mac(shapes * factors[:, None], shapes) == pytest.approx(own)
    assert mac(shapes[:, order], shapes[:, order]) == pytest.approx(own)


def measured(frequency, shape):
    return Shapes(np.array(frequency), np.full(len(frequency), 0.01), np.array(shape, complex), "modes")


@given(st.permutations(range(4)), st.floats(-0.05, 0.05))
def test_pairs_are_found_in_any_order(order, shift):
    """Also where the frequencies are all off alike, and two of them have crossed."""
    shapes = measured(FREQUENCY, SHAPE)
    shifted = measured((1 + shift) * FREQUENCY[list(order)], -2j * SHAPE[list(order)])
    paired = pairs(shapes, shifted)
    assert [(pair.first, pair.second) for pair in paired] == [(k, order.index(k)) for k in range(4)]
    assert [pair.mac for pair in paired] == pytest.approx([1.0] * 4)


def test_what_has_no_partner_stays_alone():
    far = measured([3e3, 9e3], SHAPE[[0, 3]])  # the last one lies much too low
    assert [(pair.first, pair.second) for pair in pairs(measured(FREQUENCY, SHAPE), far)] == [(0, 0)]
    unlike = measured(FREQUENCY, np.random.default_rng(9).standard_normal((4, 25)))
    assert pairs(measured(FREQUENCY, SHAPE), unlike) == []


def test_each_shape_has_one_partner():
    """Two shapes that are both like one: the nearer one gets it."""
    twice = measured([2.9e3, 3.01e3], SHAPE[[0, 0]])
    paired = pairs(measured(FREQUENCY, SHAPE), twice)
    assert [(pair.first, pair.second) for pair in paired] == [(0, 1)]
