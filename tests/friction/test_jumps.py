"""Jumps of a sample or two are seen; noise, and a finger that sticks and slips, are no jumps."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from haptonic.friction.signals.jumps import jumps, median_of_five


def stroke(rng, rate, noise, sticking):
    """(2, sample) normal and tangential force of a finger that may stick and slip, N."""
    time = np.arange(round(1.2 * rate)) / rate
    normal = rng.uniform(0.6, 1.4) * np.clip(np.minimum(time - 0.25, 1.05 - time) / 0.1, 0, 1)
    slips = 1 - sticking * (1 - (time * rng.uniform(3, rate / 20)) % 1)
    forces = np.array([normal, 0.5 * normal * slips])
    return forces + noise * rng.standard_normal(forces.shape)


STROKES = st.tuples(
    st.sampled_from([250.0, 500.0, 1000.0, 2000.0]),
    st.sampled_from([0.0, 0.3e-3, 3e-3, 0.03]),
    st.sampled_from([0.0, 0.5]),
)


@settings(max_examples=60)
@given(st.integers(0, 10**6), STROKES)
def test_a_stroke_has_no_jumps(seed, drawn):
    assert not jumps(stroke(np.random.default_rng(seed), *drawn))


@settings(max_examples=60)
@given(
    st.integers(0, 10**6), STROKES, st.integers(0, 1), st.sampled_from([-3.0, 3.0]), st.integers(1, 2),
    st.floats(0.05, 0.95),
)  # fmt: skip
def test_a_jump_anywhere_is_seen(seed, drawn, channel, size, samples, place):
    forces = stroke(np.random.default_rng(seed), *drawn)
    at = round(place * forces.shape[1])
    forces[channel, at : at + samples] += size
    assert jumps(forces)


def test_a_record_of_few_samples_has_none():
    assert not jumps(np.array([[0.0, 5.0, 0.0]]))


@pytest.mark.parametrize("digits", [1, 6])
def test_medians_of_five_are_those_of_numpy(digits):
    """With one digit, many of the five samples are equal."""
    channels = np.round(np.random.default_rng(4).standard_normal((3, 700)), digits)
    channels[1, 40] = np.nan
    windows = np.lib.stride_tricks.sliding_window_view(channels, 5, axis=1)
    assert np.array_equal(median_of_five(channels), np.median(windows, axis=2), equal_nan=True)
