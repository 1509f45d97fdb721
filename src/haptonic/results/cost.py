"""Estimates of time and memory, printed before a computation starts."""

from __future__ import annotations

from dataclasses import dataclass, replace

from haptonic.errors import HaptonicError
from haptonic.units import duration

LONG = 5.0  # s; a longer estimate is printed before the work starts
BASE = 3e8  # bytes, of the program and its libraries
# Classes of estimates below a number of seconds. They are a factor of ten apart, because machines and solvers
# differ: runs took 0.5 to 4 times the estimate.
CLASSES = (
    (8.0, "seconds"),
    (100.0, "about a minute"),
    (1500.0, "about ten minutes"),
    (7200.0, "about an hour"),
)


@dataclass(frozen=True)
class Cost:
    """Estimated cost on the machine of the benchmarks.

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
        """Processor time as one of a few classes, a factor of ten apart, for a sentence or a table."""
        for limit, text in CLASSES:
            if self.seconds < limit:
                return text
        return f"about {_round(self.seconds / 3600):g} hours"

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
        time = f"{self.time[0].upper()}{self.time[1:]}"
        return f"{time} of processor time and {self.gigabytes}; less if parts are in the store.{fits}"


def _round(value: float) -> float:
    """Round to one and a half digits, the accuracy of an estimate."""
    unit = 10.0 ** (len(f"{int(value)}") - 1) if value >= 1 else 0.1
    return round(2 * value / unit) * unit / 2
