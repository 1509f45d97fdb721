"""What a computation is foreseen to need, told before it starts."""

from __future__ import annotations

from dataclasses import dataclass

LONG = 5.0  # s, from which on it is told before the work starts
BASE = 3e8  # bytes, of the program and its libraries


@dataclass(frozen=True)
class Cost:
    """A forecast, right within about a factor of two on the machine of the benchmarks.

    seconds : of one processor; memory : bytes, at the peak
    """

    seconds: float
    memory: float = BASE

    def __add__(self, other: Cost) -> Cost:
        """One after the other."""
        return Cost(self.seconds + other.seconds, max(self.memory, other.memory))

    def times(self, count: float) -> Cost:
        """So many, one after the other."""
        return Cost(self.seconds * count, self.memory)

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
        return f"About {self.time} of processor time and {self.gigabytes}; less if parts are in the store."


def _round(value: float) -> float:
    """To a digit and a half: a forecast is no more exact."""
    unit = 10.0 ** (len(f"{int(value)}") - 1) if value >= 1 else 0.1
    return round(2 * value / unit) * unit / 2
