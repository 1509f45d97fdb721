"""How trials are processed, which of them do not count, and what is kept of each."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from haptonic.errors import FrictionError
from haptonic.friction.signals.filters import design_frequency
from haptonic.units import shown

REASONS = (
    "missing numbers",
    "record too short",
    "saturated channel",
    "contact before the stroke",
    "no contact",
    "steady part too short",
    "normal force outside of the rule",
    "speed outside of the rule",
)
"""Why a record is excluded; the first that applies is named."""
UNREADABLE, DECLARED = "unreadable record", "declared beforehand"
OMISSIONS = (UNREADABLE, DECLARED)
"""Why a trial has no record that counts; the column ``detail`` says more."""


@dataclass(frozen=True)
class Rules:
    """How a trial is processed, and which trials do not count. Declared before the data are seen.

    filter : of `FILTERS`
    bias_window : s at the start, without contact, whose mean is subtracted; 0 for none
    threshold : normal force, N, from which there is contact
    plateau : how far the speed may be from its median over the stroke, as a share of it
    middle : share of the contact that counts where no position was recorded
    steady : shortest time, s, that has to be left
    force, speed : N and m/s, (lowest, highest) mean that a trial may have
    """

    filter: str = "literal"
    bias_window: float = 0.1
    threshold: float = 0.1
    plateau: float = 0.5
    middle: float = 0.6
    steady: float = 0.1
    force: tuple[float, float] = (0.1, 5.0)
    speed: tuple[float, float] = (0.01, 0.5)

    def __post_init__(self) -> None:
        design_frequency(self.filter, 1000.0)
        limits = {"bias_window": (0, 10), "threshold": (1e-3, 10), "plateau": (0.01, 1), "middle": (0.01, 1)}
        for name, (low, high) in (limits | {"steady": (0.01, 60)}).items():
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int | float) or not low <= value <= high:
                raise _bad_rule(name, value, f"a number from {low:g} to {high:g}")
        for name in ("force", "speed"):
            pair = getattr(self, name)
            if not (isinstance(pair, tuple) and len(pair) == 2 and 0 <= pair[0] < pair[1]):
                raise _bad_rule(name, pair, "two numbers, the lowest and the highest that count")


DEFAULT_RULES = Rules()


def _bad_rule(name: str, value: object, allowed: str) -> FrictionError:
    return FrictionError(
        argument=f"rules.{name}",
        given=shown(value),
        allowed=allowed,
        cause="another unit (ms, mN, per cent), or the limits in the wrong order",
        next_step="give it in s, N, m/s or as a share",
    )


@dataclass(frozen=True)
class Measured:
    """What one stroke says. Numbers that could not be had are NaN.

    mean_of_ratios, ratio_of_means : the two ways to average |tangential| / normal over the steady part
    spread : standard deviation of the ratio over the steady part
    force, speed : means over the steady part, N and m/s
    duration : of the steady part, s
    below_threshold, reversing, off_plateau : shares of the samples left out for that reason
    excluded : one of `REASONS`, or nothing
    """

    mean_of_ratios: float = np.nan
    ratio_of_means: float = np.nan
    spread: float = np.nan
    force: float = np.nan
    speed: float = np.nan
    duration: float = 0.0
    below_threshold: float = np.nan
    reversing: float = np.nan
    off_plateau: float = np.nan
    excluded: str = ""
