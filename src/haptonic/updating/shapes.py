"""Shapes of vibration from a plate's response, and pairs of corresponding shapes of two plates."""

from __future__ import annotations

import contextlib
import io
from dataclasses import dataclass
from importlib.util import find_spec
from typing import Literal

import numpy as np
import scipy

from haptonic.arrays import Array, Complex, Ints
from haptonic.response import mac

How = Literal["modes", "operating shapes"]

PROMINENT = 3.0  # dB, smallest height of a peak of the average spectrum above the dip to a higher peak
AROUND = 0.5  # of a peak's energy: lines above belong to it
ORDER = 60  # largest order of the polynomial for poles; it needs twice as many lines
LINES_OF_A_MODE = 2.0  # in its half-power width, for an identification
ASIDE = 0.01  # largest relative distance of a pole from its peak
LEAST = 0.5  # smallest criterion (MAC) of a pair
APART = 0.1  # largest relative difference of the frequencies of a pair


@dataclass(frozen=True, eq=False)
class Shapes:
    """Shapes of a plate in ascending order.

    frequency : (m,) Hz
    damping : (m,) ratios to critical damping; NaN if the lines are too far apart
    shape : (m, points)
    how : "modes" are identified, "operating shapes" are the response at its peaks
    """

    frequency: Array
    damping: Array
    shape: Complex
    how: How


@dataclass(frozen=True)
class Pair:
    """Two corresponding shapes. first, second : their numbers; mac : their criterion."""

    first: int
    second: int
    mac: float


def shapes_of(frequency: Array, response: Complex, how: How) -> Shapes:
    """Shapes at the peaks of a response.

    Parameters
    ----------
    frequency : (lines,) Hz, evenly spaced for modes
    response : (lines, points) normal,
        velocity or displacement
    how : modes need `can_identify`
    """
    energy = (np.abs(response) ** 2).mean(axis=1)
    level = 10 * np.log10(np.maximum(energy, np.finfo(float).tiny))
    lines = np.asarray(scipy.signal.find_peaks(level, prominence=PROMINENT)[0], np.int64)
    if how == "operating shapes" or not len(lines):
        tops = [_top(frequency, energy, int(line)) for line in lines]
        peaks = np.array(tops).reshape(-1, 2)
        return Shapes(peaks[:, 0], peaks[:, 1], response[lines], "operating shapes")
    return _identified(frequency, response, lines)


def can_identify() -> bool:
    """True if the extra for modes is installed."""
    return find_spec("sdypy") is not None and find_spec("sdypy.EMA") is not None


def even(frequency: Array) -> bool:
    """True if lines are evenly spaced, as the identification needs."""
    steps = np.diff(frequency)
    return bool(np.ptp(steps) < 1e-6 * steps.max())


def resolved(frequency: Array, loss_factor: float) -> bool:
    """True if lines are close enough to identify modes with this loss factor.

    With 1.2 lines in the half-power width of modes, exact data of a plate gave shapes with a MAC of 0.54 to
    those of the same plate, while operating shapes agreed to 1e-5.
    """
    width = loss_factor * 0.5 * float(frequency[0] + frequency[-1])
    return width >= LINES_OF_A_MODE * float(np.diff(frequency).max())


def pairs(first: Shapes, second: Shapes) -> list[Pair]:
    """Pairs of corresponding shapes: with similar shapes and frequencies, each in one pair at most."""
    if not len(first.frequency) or not len(second.frequency):
        return []
    alike = mac(first.shape, second.shape)
    apart = np.abs(np.log(first.frequency[:, None] / second.frequency)) / np.log1p(APART)
    allowed = (alike >= LEAST) & (apart <= 1)
    rows, columns = scipy.optimize.linear_sum_assignment(
        np.where(allowed, alike - LEAST * apart, -1.0), maximize=True
    )
    return [
        Pair(int(i), int(j), float(alike[i, j])) for i, j in zip(rows, columns, strict=True) if allowed[i, j]
    ]


def _top(frequency: Array, energy: Array, line: int) -> tuple[float, float]:
    """Frequency and damping of a peak: its energy is the inverse of a parabola as wide as the damping."""
    first = last = line
    while first > 0 and AROUND * energy[line] < energy[first - 1] < energy[first]:
        first -= 1
    while last < len(energy) - 1 and AROUND * energy[line] < energy[last + 1] < energy[last]:
        last += 1
    first, last = min(first, line - 1), max(last, line + 1)
    near = frequency[first : last + 1] - frequency[line]
    a, b, c = np.polyfit(near, energy[line] / energy[first : last + 1], 2)
    if a <= 0:
        return float(frequency[line]), float("nan")
    shift = -b / (2 * a)
    width = np.sqrt(max(c / a - shift**2, 0.0))
    resolved = width > 0.5 * float(np.diff(frequency).min())
    return float(frequency[line] + shift), float(width / frequency[line]) if resolved else float("nan")


def _identified(frequency: Array, response: Complex, lines: Ints) -> Shapes:
    """Modes near given lines, by `sdypy-EMA`: least squares for poles, then for shapes.

    Its poles are those of a polynomial in exp(i pi f / f_highest). The band is shifted down to zero for it,
    and the poles are shifted back: a band on a small part of the circle separates them badly. A pole is the
    same for velocity and displacement, and the shapes differ by a factor only.
    """
    from sdypy import EMA

    step = float(np.diff(frequency).mean())
    base = float(frequency[0]) - 2 * step  # not nearer to zero, where its residuals are infinite
    moved = frequency - base
    low, high = float(moved[0]), float(moved[-1])
    order = min(ORDER, len(frequency) // 2)
    model = EMA.Model(response.T, moved, lower=low, upper=high, pol_order_high=order, frf_form="accelerance")
    with contextlib.redirect_stderr(io.StringIO()):  # it draws a progress bar that cannot be turned off
        model.get_poles(show_progress=False)
        model.select_closest_poles(moved[lines].tolist(), f_window=8 * step)
    _, shape = model.get_constants(f_upper=float(model.freq[-1]))
    natural, ratio = np.asarray(model.nat_freq), np.asarray(model.nat_xi)
    decay, turning = ratio * natural, natural * np.sqrt(np.maximum(1 - ratio**2, 0)) + base
    frequencies = np.hypot(decay, turning)
    good = (np.abs(frequencies / frequency[lines] - 1) < ASIDE) & (decay > 0)
    rows = np.flatnonzero(good)[np.argsort(frequencies[good])]
    return Shapes(frequencies[rows], (decay / frequencies)[rows], np.asarray(shape, complex).T[rows], "modes")
