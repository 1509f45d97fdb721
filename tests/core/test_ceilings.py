"""Bounds of bands between sampled wavevectors, against analytic bands."""

from types import SimpleNamespace

import numpy as np
from hypothesis import given, strategies as st

from haptonic.bloch.gaps import BETWEEN, ceilings, partial_gaps
from haptonic.lattice import Lattice

SQUARE = Lattice.square(1.0)


def along_x(samples, below, slope_below):
    """Diagram from G to X of a band (Hz) of the phase and a flat one at 10 Hz, without mesh errors."""
    x = np.linspace(0.0, np.pi, samples)
    frequency = np.stack([below(x), np.full(samples, 10.0)], axis=1)
    velocity = np.zeros((samples, 2, 2))
    velocity[:, 0, 0] = 2 * np.pi * slope_below(x)  # of a pitch of 1 m
    path = SimpleNamespace(
        kappa=np.stack([x, np.zeros(samples)], axis=1), corners=(0, samples - 1), labels=("G", "X")
    )
    return SimpleNamespace(path=path, frequency=frequency, velocity=velocity, error=np.zeros_like(frequency))


def bumpy(x):
    """A band that has a minimum at X, on both sides of which it rises."""
    return 5.0 - 2 * np.cos(x) + np.cos(2 * x) + 0.9 * np.cos(3 * x)


def slope_of_bumpy(x):
    return 2 * np.sin(x) - 2 * np.sin(2 * x) - 2.7 * np.sin(3 * x)


def test_an_edge_at_a_minimum_between_two_maxima_gets_the_excess_of_its_band():
    highest = bumpy(np.linspace(0, np.pi, 4001)).max()
    for samples in (4, 5, 7, 20):
        gap = partial_gaps(SQUARE, along_x(samples, bumpy, slope_of_bumpy), ())
        assert not gap or gap[0].lower + gap[0].lower_error >= highest - 1e-12, samples
    (gap,) = partial_gaps(SQUARE, along_x(20, bumpy, slope_of_bumpy), ())
    assert gap.lower_error < 0.2


def test_an_edge_at_a_maximum_that_symmetry_requires_has_no_excess():
    (gap,) = partial_gaps(SQUARE, along_x(4, lambda x: 5 - 2 * np.cos(x), lambda x: 2 * np.sin(x)), ())
    assert gap.edges == (7.0, 10.0)
    assert gap.lower_error == gap.upper_error == 0.0


@given(
    amplitudes=st.lists(st.floats(-1, 1), min_size=3, max_size=3),
    phase=st.sampled_from([0.0, 0.3, 1.1]),
    samples=st.integers(8, 20),
)
def test_bands_of_three_harmonics_stay_below_their_ceilings(amplitudes, phase, samples):
    order = np.arange(1, 4)

    def band(x):
        return np.cos(np.multiply.outer(x, order) + phase) @ amplitudes

    x = np.linspace(0.0, np.pi, samples)
    slope = -np.sin(np.multiply.outer(x, order) + phase) @ (order * amplitudes)
    on_line = np.stack([x, np.zeros(samples)], axis=1)
    slopes = np.stack([slope, np.zeros(samples)], axis=1)
    ends = (np.stack([values[:-1], values[1:]], axis=1) for values in (on_line, band(x), slopes))
    finer = band(np.linspace(0.0, np.pi, 3001))
    assert ceilings(*ends, BETWEEN).max() >= finer.max() - 1e-2 * max(np.ptp(finer), 1e-9)
