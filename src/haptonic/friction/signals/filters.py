"""Zero-lag low-pass filters for force records, by name."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from types import MappingProxyType

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.errors import FrictionError

ORDER = 2  # of one of the two passes
CORNER = 50.0  # Hz

FILTERS: Mapping[str, str] = MappingProxyType(
    {
        "literal": "two poles at 50 Hz, run forwards and backwards: -6 dB at 50 Hz",
        "compensated": "two poles a little higher, run forwards and backwards: -3 dB at 50 Hz",
        "none": "no filter",
    }
)


def design_frequency(name: str, rate: float) -> float:
    """Corner frequency (Hz) of the design of a single pass.

    A pass of the bilinear Butterworth design has |H|^2 = 1 / (1 + (tan(pi f / rate) / tan(pi f_c / rate))^4),
    and two passes have |H|^2 as their amplitude. It is -3 dB at `CORNER` if that ratio to the fourth is
    sqrt(2) - 1.

    Raises
    ------
    FrictionError : an unknown filter, or a sampling rate too low for it
    """
    if name not in FILTERS:
        raise FrictionError.unknown("filter", name, FILTERS, "the word is misspelt")
    if not (np.isfinite(rate) and rate > 4 * CORNER):
        raise FrictionError.out_of_range(
            argument="rate",
            given=f"{rate:g} Hz",
            allowed=f"above {4 * CORNER:g} Hz",
            cause="the rate is in kHz, or the times are in ms",
            next_step="give times in seconds; forces are usually recorded at 1000 Hz",
        )
    if name != "compensated":
        return CORNER
    tangent = np.tan(np.pi * CORNER / rate) / (np.sqrt(2) - 1) ** 0.25
    return float(rate / np.pi * np.arctan(tangent))


def smoothed(signals: Array, rate: float, name: str = "literal") -> Array:
    """Low-pass signals at 50 Hz without delay.

    Parameters
    ----------
    signals : (..., samples), more than 9 of them
    rate : sampling rate, Hz
    name : one of `FILTERS`

    Raises
    ------
    FrictionError : an unknown filter, a sampling rate too low for it, or too few samples
    """
    frequency = design_frequency(name, rate)
    if name == "none":
        return np.asarray(signals)
    if signals.shape[-1] <= 3 * (ORDER + 1):
        raise FrictionError.too_few(
            argument="signals",
            given=f"{signals.shape[-1]} samples",
            allowed=f"more than {3 * (ORDER + 1)}",
            cause="an empty or a cut record",
            next_step="leave the record out, or look at its file",
        )
    return np.asarray(scipy.signal.filtfilt(*_coefficients(frequency, rate), signals))


@lru_cache(maxsize=16)
def _coefficients(frequency: float, rate: float) -> tuple[Array, Array]:
    numerator, denominator = scipy.signal.butter(ORDER, frequency, fs=rate)
    return np.asarray(numerator), np.asarray(denominator)
