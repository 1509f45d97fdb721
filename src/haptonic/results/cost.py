"""What a computation is foreseen to need, told before it starts."""

from __future__ import annotations

from dataclasses import dataclass, replace

from haptonic.errors import HaptonicError
from haptonic.units import duration

LONG = 5.0  # s, from which on it is told before the work starts
BASE = 3e8  # bytes, of the program and its libraries


@dataclass(frozen=True)
class Cost:
    """A forecast, right within about a factor of two on the machine of the benchmarks.

    seconds : of one processor; memory : bytes, at the peak
    refusal : the error that the computation will end with, where that is known; it then takes no time
    budget : s, for the meshes of each cell; None where there are none
    """

    seconds: float
    memory: float = BASE
    refusal: HaptonicError | None = None
    budget: float | None = None

    def __add__(self, other: Cost) -> Cost:
        """One after the other; the first refusal ends all."""
        return Cost(
            seconds=self.seconds + other.seconds,
            memory=max(self.memory, other.memory),
            refusal=self.refusal or other.refusal,
            budget=self.budget if other.budget is None else other.budget,
        )

    def times(self, count: float) -> Cost:
        """So many, one after the other."""
        return replace(self, seconds=self.seconds * count)

    @property
    def time(self) -> str:
        """About, in words."""
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
        """About, in words."""
        return f"{max(_round(self.memory / 1e9), 0.1):g} GB"

    @property
    def sentence(self) -> str:
        """A sentence."""
        fits = "" if self.budget is None else f" The meshes fit the budget of {duration(self.budget)} a cell."
        return (
            f"About {self.time} of processor time and {self.gigabytes}; less if parts are in the store.{fits}"
        )


def _round(value: float) -> float:
    """To a digit and a half: a forecast is no more exact."""
    unit = 10.0 ** (len(f"{int(value)}") - 1) if value >= 1 else 0.1
    return round(2 * value / unit) * unit / 2
