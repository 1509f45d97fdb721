"""Times as computers write them: the rate that made them, or a reason."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from five_parts import refused
from haptonic.friction.signals.clock import (
    BRIDGED,
    OTHER_RATE,
    SCATTER,
    UNEVEN,
    clock_at,
    clock_of,
    seconds_of_day,
)

RATES = st.sampled_from([250.0, 400.0, 500.0, 1000.0, 2000.0])


@settings(max_examples=30, deadline=None)
@given(RATES, st.floats(0.0, 0.45), st.integers(0, 99), st.sampled_from([0.0, 1e-4, 1e-3]))
def test_even_samples_with_scattered_or_rounded_times_keep_their_rate(rate, scatter, seed, rounded):
    rng = np.random.default_rng(seed)
    time = (np.arange(1200) + rng.uniform(-scatter, scatter, 1200)) / rate
    if rounded:
        time = np.round(time / rounded) * rounded
    clock = clock_of(time, "a.csv")
    if clock.times is not None:  # coarse rounding on top of scatter may look like uneven samples
        assert rounded
        assert len(clock.regular(time)) / clock.rate == pytest.approx(time[-1] - time[0], rel=0.02)
        return
    assert clock.rate == pytest.approx(rate, rel=5e-3)
    assert len(clock.regular(np.zeros(1200))) == 1200


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 99))
def test_samples_at_uneven_times_are_interpolated(seed):
    rng = np.random.default_rng(seed)
    time = np.cumsum(rng.uniform(0.0012, 0.0032, 1500))
    clock = clock_of(time, "a.csv")
    assert clock.remark in (UNEVEN, SCATTER)
    signal = clock.regular(np.sin(2 * np.pi * 3 * time))
    even = time[0] + np.arange(len(signal)) / clock.rate
    assert np.abs(signal - np.sin(2 * np.pi * 3 * even)).max() < 0.05


def test_a_few_lost_rows_are_bridged_and_many_are_refused():
    time = np.arange(1000) / 500
    few = clock_of(np.delete(time, [100, 101, 500]), "a.csv")
    assert few.remark == BRIDGED
    assert few.rate == pytest.approx(500)
    assert few.regular(np.delete(time, [100, 101, 500])) == pytest.approx(time, abs=1e-9)
    refused(
        lambda: clock_of(np.delete(time, range(300, 400)), "a.csv"),
        "no sample for 0.202 s after 0.598 s",
        "rate",
        code="malformed",
        argument="a.csv",
    )


@settings(max_examples=30, deadline=None)
@given(RATES, st.floats(0.0, 0.3), st.integers(0, 99), st.floats(0.05, 0.5))
def test_lost_rows_are_seen_though_the_rate_is_given(rate, scatter, seed, gap):
    time = (np.arange(1200) + np.random.default_rng(seed).uniform(-scatter, scatter, 1200)) / rate
    assert clock_at(rate, time, "a.csv").remark == ""
    assert clock_at(2 * rate, time, "a.csv").remark == OTHER_RATE
    time[700:] += gap
    refused(lambda: clock_at(rate, time, "a.csv"), "no sample for", "record this trial", code="malformed")


def test_unusable_times_do_not_go_before_a_rate():
    for time in (np.floor(np.arange(700) / 500), np.zeros(9), np.array([0.0, np.nan, 1.0]), np.zeros(0)):
        assert clock_at(500.0, time, "a.csv").rate == 500


@pytest.mark.parametrize(
    ("time", "given"),
    [
        (np.concatenate([np.arange(500), np.arange(500)]) / 500, "go back at sample 501"),
        (np.arange(500)[::-1] / 500, "go back at sample 2"),
        (np.floor(np.arange(700) / 500), "rounded to 1 s"),
        (np.zeros(9), "the same time in every row"),
        (np.where(np.arange(500) == 7, np.nan, np.arange(500) / 500), "sample 8 without a time"),
        (np.arange(500) * 2e-8, "5e+07 samples per second"),
        (np.zeros(1), "1 times"),
    ],
)
def test_times_that_belong_to_no_samples_are_refused(time, given):
    refused(lambda: clock_of(time, "a.csv"), given, "[trials.sensor]" * (len(time) > 1), code="malformed")


def test_times_of_day():
    seconds = seconds_of_day(["23:59:59.500", "1/5/2024 00:00:00.250", "00:00:01,5"], "a.csv")
    assert np.diff(seconds) == pytest.approx([0.75, 1.25])
    assert seconds_of_day(["1/5/2024 12:00:01 AM", "1:00:00 PM"], "a.csv") == pytest.approx([1, 46800])
    refused(lambda: seconds_of_day(["soon"], "a.csv"), '"soon" in sample 1', code="malformed")
