"""Channels that hang or drop to zero are seen; quiet ones, coarse ones and ends of ranges are no stops."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from haptonic.friction.signals.stops import stops


def stroke(rng, rate, noise, step, rest=0.25):
    """(2, sample) normal and tangential force of a finger, N, with the noise and the step of the channels."""
    time = np.arange(round((rest + 0.95) * rate)) / rate
    normal = rng.uniform(0.6, 1.4) * np.clip(np.minimum(time - rest, rest + 0.8 - time) / 0.1, 0, 1)
    forces = np.array([normal, 0.5 * normal]) + noise * rng.standard_normal((2, len(time)))
    return step * np.round(forces / step) if step else forces


RATES = st.sampled_from([250.0, 500.0, 1000.0, 2000.0])
NOISES, STEPS = st.sampled_from([0.0, 0.3e-3, 3e-3, 0.03]), st.sampled_from([0.0, 1e-3, 0.01, 0.05])


@settings(max_examples=100)
@given(st.integers(0, 10**6), RATES, NOISES, STEPS)
def test_a_stroke_has_no_stops(seed, rate, noise, step):
    assert not stops(stroke(np.random.default_rng(seed), rate, noise, step))


@settings(max_examples=60)
@given(
    st.integers(0, 10**6), st.sampled_from([500.0, 1000.0, 2000.0]),
    st.sampled_from([(0.3e-3, 0.0), (3e-3, 1e-3), (0.03, 0.01)]), st.integers(0, 1),
    st.sampled_from(["zero", "hang"]), st.floats(0.45, 0.7), st.floats(0.06, 0.2),
)  # fmt: skip
def test_a_stop_while_the_finger_presses_is_seen(seed, rate, fine, channel, kind, place, seconds):
    forces = stroke(np.random.default_rng(seed), rate, *fine)
    at = round(place * forces.shape[1])
    part = slice(at, at + max(round(seconds * rate), 10))
    forces[channel, part] = 0.0 if kind == "zero" else forces[channel, at]
    assert stops(forces)


@pytest.mark.parametrize("rest", [0.0, 0.01])
def test_without_a_rest_nothing_is_known(rest):
    forces = stroke(np.random.default_rng(1), 250.0, 3e-3, 0.0, rest)
    forces[0, 100:125] = 0.0
    assert not stops(forces)
