"""Removal of the noise from the power of a measured response, and detection of values that noise hides."""

from __future__ import annotations

import json

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.gate import WORD
from haptonic.later import xarray as xr
from haptonic.response import FrequencyResponse
from haptonic.response.measures import power_contrast, spectrum, squares

LINES = 256  # that are converted to double precision at a time
TRUSTED = 0.125  # dB, largest standard error of a reported level: four of them are half a decibel
HIDDEN = {WORD: "noise hides it"}
DECIBELS = 10 / np.log(10)  # of a small relative change of a power


def averages_of(response: FrequencyResponse) -> int:
    """Number of averages of an H1 estimate by `haptonic.vibrometry.estimate`; 0 for any other response, and
    for a single average, which does not determine the noise."""
    inputs = json.loads(response.dataset.attrs["inputs"])
    count = inputs.get("averages")
    is_h1 = "coherence" in response.dataset and inputs.get("estimator") == "H1"
    return count if is_h1 and isinstance(count, int) and count > 1 else 0


def noise_power(response: FrequencyResponse, points: Bools, lines: slice, averages: int) -> Array:
    """(line, point) mean square of the noise in an H1 estimate, |H|^2 (1 - c) / c / (n - 1) [bendat2010].

    The coherence c of n averages is itself an estimate; the mean of this expression is unbiased for any n. A
    point whose coherence was set to zero by a repair has zero noise.
    """
    square = squares(response.values[lines][:, points])
    coherence = response.dataset["coherence"].values[lines][:, points].astype(np.float64)
    share = np.divide(1 - coherence, coherence, out=np.zeros_like(coherence), where=coherence > 0)
    return np.asarray(square * share / (averages - 1))


def region_power(response: FrequencyResponse, points: Bools) -> tuple[Array, Array]:
    """Mean square over points without that of the noise, and its standard error, both (line,).

    The error is that of the noise alone. For a response that is not an average of several records, the power
    is exact and the error zero.
    """
    averages, count = averages_of(response), int(points.sum())
    power, variance = np.empty(len(response.frequency)), np.zeros(len(response.frequency))
    for start in range(0, len(power), LINES):
        lines = slice(start, start + LINES)
        square = squares(response.values[lines][:, points])
        power[lines] = square.mean(axis=1)
        if averages:
            noise = noise_power(response, points, lines, averages)
            power[lines] -= noise.mean(axis=1)
            # |h + e|^2 has the variance 2 |h|^2 s^2 + s^4, and the estimate of s^2 the variance s^4 / (n - 1)
            signal = np.maximum(square - noise, 0)
            spread = 2 * signal * noise + noise**2 * averages / (averages - 1)
            variance[lines] = spread.sum(axis=1) / count**2
    return power, np.sqrt(variance)


def clean_rms(response: FrequencyResponse, region: str) -> xr.DataArray:
    """Root mean square of a region without noise; NaN where its standard error is above `TRUSTED`.

    Raises
    ------
    ResponseError : no point in that region
    """
    power, error = region_power(response, response.inside(region))
    values = np.sqrt(np.where(_decibels(power, error) <= TRUSTED, power, np.nan))
    return spectrum(response, values, response.units).assign_attrs(HIDDEN)


def clean_contrast(response: FrequencyResponse, over: Bools, under: Bools) -> xr.Dataset:
    """``level`` of some points over others without noise, and its standard ``error``, dB against frequency.

    A level is NaN if its error is above `TRUSTED`, because the coherence is too low. The error is NaN if only
    noise is left.
    """
    (upper, upper_error), (lower, lower_error) = (region_power(response, side) for side in (over, under))
    error = np.hypot(_decibels(upper, upper_error), _decibels(lower, lower_error))
    level = np.where(error <= TRUSTED, power_contrast(upper, lower), np.nan)
    rows = {"level": level, "error": np.where(np.isfinite(error), error, np.nan)}
    return xr.Dataset(
        {name: spectrum(response, row, "dB").assign_attrs(HIDDEN) for name, row in rows.items()}
    )


def _decibels(power: Array, error: Array) -> Array:
    """Standard error of a level; infinite if only noise is left."""
    return np.asarray(DECIBELS * np.divide(error, power, out=np.full_like(power, np.inf), where=power > 0))
