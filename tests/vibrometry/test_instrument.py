"""The vibrometer in software: its records are those of the response that it was given."""

from __future__ import annotations

import numpy as np
import pytest

from five_parts import assert_explained
from haptonic.errors import ScanError
from haptonic.response import FrequencyResponse
from haptonic.vibrometry import drive, estimate
from haptonic.vibrometry.instrument import Instrument, lines_of, recorded

SIGNAL = drive(low=5e3, high=20e3, sample_rate=100e3, duration=5e-3, amplitude=60.0)
LINES = lines_of(SIGNAL)
X, Y = (axis.ravel() for axis in np.meshgrid(np.arange(6) * 2e-3, np.arange(5) * 2e-3))


def ideal(**changes):
    """An instrument without noise and dropouts, but for what is changed."""
    return Instrument(**{"noise": 0.0, "dropouts": 0.0, **changes})


def resonant() -> FrequencyResponse:
    """One resonance whose strength differs from point to point, m/s/V."""
    omega, own = 2 * np.pi * LINES, 2 * np.pi * 11e3
    shape = 1.0 + np.sin(300 * X) * np.cos(500 * Y)
    values = 1j * omega / (own**2 * (1 + 0.02j) - omega**2) * 10.0
    return FrequencyResponse.of(
        (values[:, None] * shape)[..., None].astype(np.complex64), frequency=LINES, x=X, y=Y,
        reference="A1, V", origin="simulated",
    )  # fmt: skip


def measured(instrument: Instrument, averages: int = 4, seed: int = 1):
    return estimate(recorded(resonant(), SIGNAL, instrument, averages=averages, seed=seed), band=SIGNAL.band)


def test_without_noise_the_estimate_is_the_response_through_the_path():
    instrument = ideal(bits=24, delay=7e-6, bandwidth=30e3)
    estimated = measured(instrument).response
    # by hand: a delay turns the phase, a first-order low-pass is 3 dB down at its frequency
    path = np.exp(-1j * 2 * np.pi * LINES * 7e-6) * (1 - 1j * LINES / 30e3) / (1 + (LINES / 30e3) ** 2)
    expected = resonant().values * path[:, None, None]
    assert np.array_equal(estimated.frequency, LINES)
    assert np.abs(estimated.values - expected).max() < 2e-5 * np.abs(expected).max()
    assert estimated.dataset.attrs["origin"] == "simulated"


def test_sixteen_bits_are_coarser_than_twenty_four_and_a_few_bits_are_worse():
    errors = [
        np.abs(measured(ideal(bits=bits), 1).response.values - resonant().values).max()
        for bits in (24, 16, 8)
    ]
    assert errors[0] < 0.1 * errors[1] < 0.1 * errors[2]


def test_the_error_of_the_estimate_is_that_of_the_noise():
    noise, averages = 2e-3, 16
    values = measured(ideal(bits=24, noise=noise), averages).response.values
    error = values - resonant().values
    # white noise of variance s^2 has E|N_k|^2 = n s^2 in each line of a transform of n samples
    drive_lines = np.abs(np.fft.rfft(SIGNAL.samples))[25:101]
    expected = noise * np.sqrt(len(SIGNAL.samples) / averages) / drive_lines
    seen = np.sqrt((np.abs(error[..., 0]) ** 2).mean(axis=1))
    assert (seen / expected).mean() == pytest.approx(1.0, rel=0.05)


def test_records_do_not_depend_on_the_order_of_reading():
    scan = recorded(resonant(), SIGNAL, ideal(noise=1e-3, dropouts=0.3), averages=2, seed=5)
    whole = scan.source.load(0, 30)[1]
    assert whole.dtype == np.int16
    for start, stop in ((20, 30), (0, 7), (7, 20)):
        assert np.array_equal(scan.source.load(start, stop)[1], whole[start:stop])
    other = recorded(resonant(), SIGNAL, ideal(noise=1e-3), averages=2, seed=6).source.load(0, 30)[1]
    assert not np.array_equal(other, whole)


def test_what_goes_wrong_is_flagged():
    lost = measured(ideal(dropouts=0.999), seed=2).quality
    assert lost.flagged("dropout").mean() > 0.95
    clipped = measured(ideal(full_scale=0.2)).quality
    loud = np.abs(recorded(resonant(), SIGNAL, ideal(), averages=1, seed=0).source.load(0, 30)[1]).max(
        axis=(1, 2)
    )
    scale = recorded(resonant(), SIGNAL, ideal(), averages=1, seed=0).response_scale
    assert np.array_equal(clipped.flagged("saturated"), loud * scale > 0.2 * 0.999)
    assert not measured(ideal(noise=1e-5)).quality.flagged().any()


def test_a_response_at_other_lines_is_refused():
    with pytest.raises(ScanError) as caught:
        recorded(resonant().between(6e3, 20e3), SIGNAL, ideal(), averages=1, seed=0)
    assert_explained(caught.value, code="mismatch", argument="response")
