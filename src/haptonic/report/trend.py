"""Trend of a gap along a sweep: a power of the swept value, fitted to designs around that of the study."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch.gap_datasets import certain_gaps
from haptonic.later import xarray as xr
from haptonic.units import uncertain

FEWEST = 4  # designs that a fit with a spread needs


@dataclass(frozen=True)
class Power:
    """``f ~ value^exponent`` by least squares of the logarithms; ``error`` is the exponent's standard error,
    which measures how far the points are from any one power."""

    exponent: float
    error: float

    def __str__(self) -> str:
        return uncertain(self.exponent, self.error)


@dataclass(frozen=True)
class Trend:
    """The gap of the study's own design, followed along a sweep without a break.

    value, lower, upper : (n,) swept value (SI) and edges, Hz; below : the band below it
    slender, stocky : (n, 3) resonances of the pillar alone, Euler-Bernoulli and Timoshenko, Hz
    """

    value: Array
    lower: Array
    upper: Array
    below: int
    slender: Array
    stocky: Array

    @property
    def nearest(self) -> int:
        """Which of the Timoshenko resonances lies nearest to the gap's upper edge over the designs."""
        return int(np.abs(np.log(self.stocky / self.upper[:, None])).mean(axis=0).argmin())

    @property
    def straightness(self) -> float:
        """Largest distance (Hz) of the upper edge from a straight line over the slender pillar's resonance.

        Equation (3) is linear in the diameter and in the inverse square of the height; so is the edge, but
        for a constant, when this is small.
        """
        x = self.slender[:, self.nearest]
        return float(np.abs(np.polyval(np.polyfit(x, self.upper, 1), x) - self.upper).max())

    def power(self, frequency: Array) -> Power:
        return fitted_power(self.value, frequency)


def fitted_power(value: Array, frequency: Array) -> Power:
    x, y = np.log(value), np.log(frequency)
    x = x - x.mean()
    exponent = float(x @ y / (x @ x))
    left = y - y.mean() - exponent * x
    return Power(exponent, float(np.sqrt(left @ left / max(len(x) - 2, 1) / (x @ x))))


def trend_of(sweep: xr.Dataset) -> Trend | None:
    """Follow the widest certain gap of the design nearest to the study's own; None if that has none, if it
    lies outside the sweep, if the sweep varies two expressions, or if too few designs share the gap."""
    value = sweep["value"].values
    own = sweep.attrs.get("own_value")
    if "second_value" in sweep or own is None or not value.min() <= own <= value.max() or (value <= 0).any():
        return None
    lower, upper, below = (sweep[name].values for name in ("gap_lower", "gap_upper", "gap_below"))
    width = np.where(certain_gaps(sweep), upper - lower, np.nan)
    start = int(np.abs(value - own).argmin())
    if not np.isfinite(width[start]).any():
        return None
    number = int(below[start, np.nanargmax(width[start])])
    slots = [_slot(below[step], width[step], number) for step in range(len(value))]
    first = last = start
    while first > 0 and slots[first - 1] is not None:
        first -= 1
    while last + 1 < len(value) and slots[last + 1] is not None:
        last += 1
    if last - first + 1 < FEWEST:
        return None
    steps = np.arange(first, last + 1)
    chosen = np.array([slots[step] for step in steps])
    return Trend(
        value=value[steps],
        lower=lower[steps, chosen],
        upper=upper[steps, chosen],
        below=number,
        slender=sweep["euler_bernoulli"].values[steps],
        stocky=sweep["timoshenko"].values[steps],
    )


def _slot(below: Array, width: Array, number: int) -> int | None:
    slots = np.flatnonzero((below == number) & np.isfinite(width))
    return int(slots[0]) if len(slots) else None
