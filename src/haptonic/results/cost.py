"""Estimates of time and memory, printed before a computation starts."""

from __future__ import annotations

from dataclasses import dataclass, replace

from haptonic.errors import HaptonicError
from haptonic.units import duration

LONG = 5.0  # s; a longer estimate is printed before the work starts
BASE = 3e8  # bytes, of the program and its libraries


@dataclass(frozen=True)
class Cost:
    """Estimated cost, right within about a factor of two on the machine of the benchmarks.

    seconds : processor time; memory : bytes, at the peak
    refusal : error with which the computation will end, if known; it then takes no time
    budget : s, for the meshes of each cell; None for an analysis without meshes
    """

    seconds: float
    memory: float = BASE
    refusal: HaptonicError | None = None
    budget: float | None = None

    def __add__(self, other: Cost) -> Cost:
        """Cost of two computations in sequence; the first refusal ends both."""
        return Cost(
            seconds=self.seconds + other.seconds,
            memory=max(self.memory, other.memory),
            refusal=self.refusal or other.refusal,
            budget=self.budget if other.budget is None else other.budget,
        )

    def times(self, count: float) -> Cost:
        """Cost of several equal computations in sequence."""
        return replace(self, seconds=self.seconds * count)

    @property
    def time(self) -> str:
        """Rounded processor time as a text."""
        if self.seconds < 1:
            return "a second"
        if self.seconds < 100:
            return f"{_round(self.seconds):g} s"
        return (
            f"{_round(self.seconds / 60):g} min"
            if self.seconds < 6000
            else f"{_round(self.seconds / 3600):g} h"
        )

    @property
    def gigabytes(self) -> str:
        """Rounded memory as a text."""
        return f"{max(_round(self.memory / 1e9), 0.1):g} GB"

    @property
    def sentence(self) -> str:
        """Sentence with time, memory and budget."""
        fits = (
            ""
            if self.budget is None
            else f" Meshes are within the budget of {duration(self.budget)} per cell."
        )
        return (
            f"About {self.time} of processor time and {self.gigabytes}; less if parts are in the store.{fits}"
        )


def _round(value: float) -> float:
    """Round to one and a half digits, the accuracy of an estimate."""
    unit = 10.0 ** (len(f"{int(value)}") - 1) if value >= 1 else 0.1
    return round(2 * value / unit) * unit / 2
