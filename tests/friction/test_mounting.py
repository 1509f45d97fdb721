"""Which force is the normal one: friction needs a load."""

import numpy as np
from hypothesis import given, settings, strategies as st

from haptonic.friction.recordings.mounting import begins_sliding
from haptonic.friction.signals.record import Record

RATE = 500.0


@settings(max_examples=60)
@given(
    st.floats(0.1, 1.5),
    st.floats(0.02, 0.2),
    st.floats(0.0, 0.2),
    st.sampled_from([0.3e-3, 3e-3]),
    st.sampled_from([-1.0, 1.0]),
    st.integers(0, 10**6),
)
def test_a_tangential_force_that_begins_first_is_the_normal_one(friction, rise, wait, noise, sign, seed):
    """A finger presses, waits, slides; or presses while it slides."""
    rng = np.random.default_rng(seed)
    time = np.arange(600) / RATE
    normal = np.clip((time - 0.25) / rise, 0, 1)
    along = friction * normal * np.clip((time - 0.25 - rise - wait) / 0.05, 0, 1)
    normal, along = (
        sign * values + 0.5 + noise * rng.standard_normal(len(time)) for values in (normal, along)
    )
    assert not begins_sliding(Record(normal, along, RATE))
    assert begins_sliding(Record(along, normal, RATE))
    together = Record(normal, 0.5 + friction * (normal - 0.5), RATE)
    assert not begins_sliding(together)
