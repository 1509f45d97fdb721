"""Shapes in which a plate vibrates, out of its response, and which of two plates' shapes belong together."""

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

PROMINENT = 3.0  # dB by which a peak of the average spectrum rises above what separates it from a higher one
AROUND = 0.5  # share of a peak's energy, above which lines belong to it
ORDER = 60  # of the polynomial in which poles are looked for, at most; it needs twice as many lines
ASIDE = 0.01  # share of a peak's frequency by which a pole may miss it
LEAST = 0.5  # criterion (MAC) of a pair at least
APART = 0.1  # share by which frequencies of a pair may differ at most


@dataclass(frozen=True, eq=False)
class Shapes:
    """Shapes of a plate in ascending order.

    frequency : (m,) Hz; damping : (m,) ratios, of critical; NaN where the lines are too far apart to tell
    shape : (m, points); how : modes are identified, operating shapes are the response at its peaks
    """

    frequency: Array
    damping: Array
    shape: Complex
    how: How


@dataclass(frozen=True)
class Pair:
    """Two shapes that belong together. first, second : numbers; mac : their criterion"""

    first: int
    second: int
    mac: float


def shapes_of(frequency: Array, response: Complex, how: How) -> Shapes:
    """Shapes at the peaks of a response.

    Parameters
    ----------
    frequency : (lines,) Hz, evenly spaced for modes; response : (lines, points) normal,
        velocity or displacement
    how : modes need `can_identify`
    """
    energy = (np.abs(response) ** 2).mean(axis=1)
    level = 10 * np.log10(np.maximum(energy, np.finfo(float).tiny))
    lines = np.asarray(scipy.signal.find_peaks(level, prominence=PROMINENT)[0], np.int64)
    if how == "operating shapes" or not len(lines):
        tops = [_top(frequency, energy, int(line)) for line in lines]
        found = np.array(tops).reshape(-1, 2)
        return Shapes(found[:, 0], found[:, 1], response[lines], "operating shapes")
    return _identified(frequency, response, lines)


def can_identify() -> bool:
    """Whether the extra for modes is installed."""
    return find_spec("sdypy") is not None and find_spec("sdypy.EMA") is not None


def even(frequency: Array) -> bool:
    """Whether lines are evenly spaced, as identification needs them."""
    steps = np.diff(frequency)
    return bool(np.ptp(steps) < 1e-6 * steps.max())


def pairs(first: Shapes, second: Shapes) -> list[Pair]:
    """Which shapes belong together, one to one: alike, and at frequencies that do not differ too much."""
    if not len(first.frequency) or not len(second.frequency):
        return []
    alike = mac(first.shape, second.shape)
    apart = np.abs(np.log(first.frequency[:, None] / second.frequency)) / np.log1p(APART)
    allowed = (alike >= LEAST) & (apart <= 1)
    one, other = scipy.optimize.linear_sum_assignment(
        np.where(allowed, alike - LEAST * apart, -1.0), maximize=True
    )
    return [
        Pair(int(i), int(j), float(alike[i, j])) for i, j in zip(one, other, strict=True) if allowed[i, j]
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

    Its poles are those of a polynomial in exp(i pi f / f_highest). The band is moved down to zero for that,
    and its poles are moved back: a band that fills a small part of the circle tells them apart badly. A pole
    is that of velocity as well as of displacement, and the shapes differ by a factor only.
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
    own, ratio = np.asarray(model.nat_freq), np.asarray(model.nat_xi)
    decay, turning = ratio * own, own * np.sqrt(np.maximum(1 - ratio**2, 0)) + base
    found = np.hypot(decay, turning)
    good = (np.abs(found / frequency[lines] - 1) < ASIDE) & (decay > 0)
    kept = np.flatnonzero(good)[np.argsort(found[good])]
    return Shapes(found[kept], (decay / found)[kept], np.asarray(shape, complex).T[kept], "modes")
