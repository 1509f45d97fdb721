"""Spectra of records, and estimators of a frequency response from them [bendat2010]."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import scipy
from numpy.typing import NDArray

from haptonic.arrays import AnyComplex
from haptonic.errors import ScanError

Real = NDArray[np.floating[Any]]
Estimator = Literal["H1", "H2", "Hv"]
WindowName = Literal["none", "hann", "exponential"]

ESTIMATORS: tuple[Estimator, ...] = ("H1", "H2", "Hv")
WINDOWS: tuple[WindowName, ...] = ("none", "hann", "exponential")


@dataclass(frozen=True, eq=False)
class Spectra:
    """Averaged spectra of the reference x and the response y, each (point, line).

    xx, yy : auto spectra, means of |X|^2 and |Y|^2
    xy : cross spectrum, mean of conj(X) Y
    averages : number of records in the means
    """

    xx: Real
    yy: Real
    xy: AnyComplex
    averages: int

    def response(self, estimator: Estimator) -> AnyComplex:
        """H1 = Sxy/Sxx, unbiased by noise on the response; H2 = Syy/Syx, unbiased by noise on the reference;
        Hv, their geometric mean. The result is not finite on a line without signal."""
        with np.errstate(divide="ignore", invalid="ignore"):
            if estimator == "H1":
                return np.asarray(self.xy / self.xx)
            if estimator == "H2":
                return np.asarray(self.yy / self.xy.conj())
            return np.asarray(self.xy / np.abs(self.xy) * np.sqrt(self.yy / self.xx))

    def coherence(self) -> Real:
        """|Sxy|^2 / (Sxx Syy) = H1/H2, from 0 to 1; always 1 for a single average."""
        with np.errstate(divide="ignore", invalid="ignore"):
            squared = self.xy.real**2 + self.xy.imag**2
            return np.asarray(np.minimum(squared / self.xx / self.yy, 1.0))


def window_of(name: WindowName, samples: int, sample_rate: float, decay: float | None) -> Real | None:
    """Weights of a record's samples; None for "none".

    "none" is for periodic drives recorded over whole periods, which do not leak. "hann" is for random drives.
    "exponential", exp(-t / decay), is for bursts whose ring-down outlasts the record. It weights both
    channels, so the estimate is exactly H(i omega + 1/decay): every pole is damped by 1/decay more.

    Raises
    ------
    ScanError : an unknown name, or an exponential window without its decay
    """
    if name not in WINDOWS:
        next_step = 'use "none" for periodic chirps, "exponential" for bursts, "hann" for random drives'
        cause = "the name is misspelt, or haptonic does not have such a window"
        raise ScanError.unknown("window", name, WINDOWS, cause, next_step=next_step)
    if (name == "exponential") != (decay is not None and np.isfinite(decay) and decay > 0):
        raise ScanError.conflict(
            argument="decay",
            given=str(decay),
            allowed='a positive time in s with the window "exponential", nothing with the others',
            cause="the window and its decay were not given together",
            next_step='give both: window="exponential", decay=0.01',
        )
    if name == "none":
        return None
    time = np.arange(samples)
    if name == "hann":
        return np.asarray(0.5 - 0.5 * np.cos(2 * np.pi * time / samples))
    return np.asarray(np.exp(-time / (sample_rate * (decay or 1.0))))


def segmented(records: Real, length: int, step: int) -> Real:
    """(point, segment, sample) of records (point, repeat, sample), cut into pieces that may overlap."""
    if length == step == records.shape[2]:
        return records
    views = np.lib.stride_tricks.sliding_window_view(records, length, axis=2)[:, :, ::step]
    return np.asarray(views).reshape(len(records), -1, length)


def transformed(segments: Real, window: Real | None, lines: slice) -> AnyComplex:
    """(point, segment, line) spectra of segments (point, segment, sample), weighted by a window (sample,)."""
    weighted = segments if window is None else segments * window.astype(segments.dtype)
    return np.asarray(scipy.fft.rfft(weighted, axis=2)[..., lines])


def spectra_of(x: AnyComplex, y: AnyComplex) -> Spectra:
    """Averaged spectra of transforms (point or 1, segment, line) and (point, segment, line)."""
    xx = _power(x)
    # sums of products are faster than `einsum`, whose inner loop over segments jumps from line to line
    xy = (x.conj() * y).sum(axis=1) / y.shape[1]
    return Spectra(np.broadcast_to(xx, xy.shape), _power(y), xy, y.shape[1])


def _power(transforms: AnyComplex) -> Real:
    """(point, line) mean of the squared amplitude over the segments."""
    return np.asarray((transforms.real**2 + transforms.imag**2).mean(axis=1))


def shifts(reference: Real, like: Real) -> NDArray[np.int64]:
    """Lag of each reference record (..., sample) behind another record, in samples, by correlation.

    The records are treated as periodic, like those of a repeated drive.
    """
    length = reference.shape[-1]
    spectrum = scipy.fft.rfft(reference, axis=-1) * scipy.fft.rfft(like).conj()
    lag = scipy.fft.irfft(spectrum, n=length, axis=-1).argmax(axis=-1)
    return np.asarray(np.where(lag > length // 2, lag - length, lag))


def rolled(records: Real, lags: NDArray[np.int64]) -> Real:
    """Records (point, repeat, sample) advanced by their lags, periodically."""
    places = (np.arange(records.shape[-1]) + lags[..., None]) % records.shape[-1]
    return np.asarray(np.take_along_axis(records, places, axis=-1))
