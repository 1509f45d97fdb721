"""Thresholds of perception for a drop of friction."""

from __future__ import annotations

import math
from dataclasses import dataclass

from haptonic.errors import FrictionError

WEBER_FRACTION = 0.11
"""Smallest relative drop of friction that people feel [weber-fraction-2017]."""
CUE_THRESHOLD = 2.3e-3
"""Shortest friction cue that people feel, s; the lower of the values of [cue-timing-2019]."""


@dataclass(frozen=True)
class Margin:
    """Reductions of friction, relative to the threshold of perception.

    driven, idle : reductions of friction, 0.55 for 55 %
    """

    driven: float
    idle: float

    @property
    def noticed(self) -> bool:
        """True if people feel the driven region."""
        return self.driven > WEBER_FRACTION

    @property
    def localised(self) -> bool:
        """True if people feel the driven region and not the idle one."""
        return self.noticed and self.idle <= WEBER_FRACTION

    @property
    def stopped(self) -> float:
        """Share of the driven reduction that does not reach the idle region."""
        return 1 - self.idle / self.driven


def rise_time(quality_factor: float, frequency: float) -> float:
    """Rise time from 10 to 90 % of the amplitude of a resonance, s: ln 9 time constants Q / (pi f)."""
    return math.log(9) * time_constant(quality_factor, frequency)


def time_constant(quality_factor: float, frequency: float) -> float:
    """Time constant of the amplitude of a resonance, Q / (pi f), s."""
    _positive("quality_factor", quality_factor)
    _positive("frequency", frequency)
    return quality_factor / (math.pi * frequency)


@dataclass(frozen=True)
class QualityLimits:
    """Largest loaded quality factors at which the friction changes within the threshold of a cue.

    by_rise : limit at which the 10 to 90 % rise time equals the threshold
    by_constant : limit at which the time constant equals the threshold
    """

    by_rise: float
    by_constant: float


def quality_limits(frequency: float, threshold: float = CUE_THRESHOLD) -> QualityLimits:
    """Limits on the loaded quality factor at a frequency (Hz) for a threshold in s.

    Raises
    ------
    FrictionError : a frequency or a threshold that is not positive
    """
    _positive("frequency", frequency)
    _positive("threshold", threshold)
    by_constant = math.pi * frequency * threshold
    return QualityLimits(by_rise=by_constant / math.log(9), by_constant=by_constant)


def _positive(name: str, value: float) -> None:
    if not (math.isfinite(value) and value > 0):
        raise FrictionError.out_of_range(
            argument=name,
            given=f"{value}",
            allowed="a positive number",
            cause="the value was not set, or has the wrong sign",
            next_step="give it in SI units",
        )
