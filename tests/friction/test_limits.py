"""Channels at the end of their range: every stroke that it changes is seen, and no other."""

import numpy as np
from hypothesis import given, settings, strategies as st

from haptonic.friction.signals.limits import RangeEnds

RATE = 500.0


def stroke(rng, *, step, noise, offset, drift, rest_after):
    """(2, sample) normal and tangential force of a stroke, without a limit, N."""
    time = np.arange(round((1.05 + rest_after) * RATE)) / RATE
    pressed = np.clip(np.minimum(time - 0.25, 1.05 - time if rest_after else np.inf) / 0.1, 0, 1)
    # no finger presses evenly; a quiet force that does looks like one at a limit
    wave = rng.uniform(0.03, 0.1) * np.sin(2 * np.pi * rng.uniform(1, 3) * time + rng.uniform(0, 6))
    normal = rng.uniform(0.6, 1.4) * pressed * (1 + wave)
    forces = np.array([normal, 0.4 * normal * np.clip((time - 0.35) / 0.05, 0, 1)])
    return forces + offset + drift * time + noise * step * rng.standard_normal(forces.shape)


def experiment(seed, *, count, limit, step, offset, **drawn):
    """Strokes of a sensor whose normal force ends at a limit, and by what share this changes each."""
    rng = np.random.default_rng(seed)
    strokes, changed = [], []
    for _ in range(count):
        written = np.round(stroke(rng, step=step, offset=offset, **drawn) / step) * step
        before = np.mean(written[0] - offset)
        written[0] = np.minimum(written[0], np.round((offset + limit) / step) * step)
        changed.append(1 - np.mean(written[0] - offset) / before)
        strokes.append(written)
    return strokes, np.array(changed)


EXPERIMENTS = st.fixed_dictionaries(
    {
        "seed": st.integers(0, 10**6),
        "count": st.integers(1, 6),
        "step": st.sampled_from([1e-6, 1e-4, 1e-3, 5e-3]),
        "noise": st.sampled_from([0.15, 0.4, 1.0, 3.0]),  # of a step
        "offset": st.sampled_from([0.0, 0.3, 2.0]),
        "drift": st.sampled_from([0.0, 0.05, -0.1]),
        "rest_after": st.sampled_from([0.0, 0.2]),
    }
)


@settings(max_examples=200)
@given(EXPERIMENTS, st.sampled_from([0.7, 0.8, 1.0]))
def test_a_limit_that_changes_a_force_is_seen(drawn, limit):
    strokes, changed = experiment(limit=limit, **drawn)
    assert RangeEnds.of(strokes).reached()[changed > 0.03].all()


@settings(max_examples=200)
@given(EXPERIMENTS)
def test_forces_within_the_range_are_at_no_limit(drawn):
    strokes, changed = experiment(limit=10.0, **drawn)
    assert not changed.any()
    assert not RangeEnds.of(strokes).reached().any()


@settings(max_examples=20)
@given(st.integers(0, 10**6), st.sampled_from([1000.0, 1 / 4.4482216152605]))
def test_an_end_is_the_same_in_files_of_other_units(seed, unit):
    drawn = {"step": 5e-3, "noise": 0.15, "offset": 0.0, "drift": 0.0, "rest_after": 0.2, "count": 3}
    strokes, changed = experiment(seed, limit=0.8, **drawn)
    others = [np.vectorize(lambda value: float(f"{value:.6g}"))(unit * forces) / unit for forces in strokes]
    reached = RangeEnds.of([*strokes, *others]).reached()
    assert reached[np.tile(changed > 0.02, 2)].all()


@settings(max_examples=20)
@given(st.integers(0, 10**6))
def test_a_smaller_range_of_some_strokes_is_seen_where_noise_shows(seed):
    drawn = {"step": 1e-3, "noise": 3.0, "offset": 0.0, "drift": 0.0, "rest_after": 0.2, "count": 3}
    small, changed = experiment(seed, limit=0.7, **drawn)
    large, _ = experiment(seed + 1, limit=10.0, **drawn)
    reached = RangeEnds.of([*small, *large]).reached()[:3]
    assert reached[changed > 2e-3].all(), "smaller changes are a few samples of noise"
    assert not reached[changed == 0].any()
