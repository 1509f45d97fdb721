"""Rules for processing and excluding trials, and the numbers that are stored of each trial."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np

from haptonic.errors import FrictionError
from haptonic.fields import Quantity, described, problem, setting
from haptonic.units import format_quantity

Share = Annotated[float, Quantity("", at_least=0.01, at_most=1.0)]
Force = Annotated[float, Quantity("N", at_least=0.0, at_most=100.0)]
Speed = Annotated[float, Quantity("m/s", at_least=0.0, at_most=10.0)]

OTHER_WAY = "normal force in the other direction"
DRIFTS = "drift of the sensor"
JUMPS, STOPS = "jump of a channel", "stop of a channel"
TOUCHED_EARLY = "contact before the stroke"
REASONS = (
    "missing numbers",
    "record too short",
    "saturated channel",
    JUMPS,
    STOPS,
    TOUCHED_EARLY,
    OTHER_WAY,
    "no contact",
    "steady part too short",
    DRIFTS,
    "normal force outside of the rule",
    "speed outside of the rule",
)
"""Reasons for excluding a record; the first that applies is given."""
UNREADABLE, DECLARED = "unreadable record", "declared beforehand"
OMISSIONS = (UNREADABLE, DECLARED)
"""Reasons for a trial without a valid record; the column ``detail`` has more."""
REMEDIES = {
    "missing numbers": (
        "cells of the record are empty or not numbers",
        "look at these files in a text editor",
    ),
    "record too short": ("the files were cut", "record these trials again"),
    "saturated channel": (
        "a force stays at one value, the end of the channel's range",
        "choose a larger range of the sensor; largest_force in [trials.sensor] gives its end",
    ),
    JUMPS: (
        "a channel jumps for a sample or two: a loose contact, or lost data",
        "look at the cables, and record these trials again",
    ),
    STOPS: (
        "a channel stays at one value, or at zero, while the finger presses: a loose contact, or lost data",
        "look at the cables, and record these trials again",
    ),
    TOUCHED_EARLY: (
        "the finger lies on the plate within the bias window, at the start of the record",
        'shorten bias_window in [trials], or write bias_window = "0 s" if the sensor was set to zero before',
    ),
    OTHER_WAY: (
        "the sensor was turned round, or a minus before normal in [trials.sensor] is wrong",
        "leave the minus out before normal in [trials.sensor]: the records of each participant show the sign",
    ),
    "no contact": (
        "the normal force stays below the threshold above its start: another channel, another unit, a light "
        "touch, or a finger that lies on the plate from start to end",
        "check normal and force_unit in [trials.sensor], lower threshold in [trials], or begin at rest",
    ),
    "steady part too short": (
        "too few samples have contact and a steady speed in one direction",
        "check position in [trials.sensor], or change plateau, middle or steady in [trials]",
    ),
    DRIFTS: (
        "the forces drift before the finger comes, and no rest at the end shows how far",
        "end each record without the finger on the plate, or let the sensor warm up before the trials",
    ),
    "normal force outside of the rule": (
        "the unit of the forces is another one, or people pressed harder or less than planned",
        "check force_unit in [trials.sensor], or change force in [trials]",
    ),
    "speed outside of the rule": (
        "the unit of the position or of the times is another one, or people were faster or slower",
        "check position_unit and time_unit in [trials.sensor], or change speed in [trials]",
    ),
    "unreadable record": ("files that cannot be read", "correct the files or the table of trials"),
    "declared beforehand": ("[[trials.exclude]] excludes them", "exclude fewer trials"),
}
"""Likely cause and next step for each reason of exclusion."""


@described("trials", FrictionError)
class Rules:
    """Rules for processing and excluding trials. Declare them before the data are seen."""

    filter: Literal["literal", "compensated", "none"] = setting(
        "literal", "Two poles at 50 Hz, run both ways: as published (-6 dB there), or -3 dB there, or none."
    )
    bias_window: Annotated[float, Quantity("s", at_least=0.0, at_most=10.0)] = setting(
        0.1,
        "Time at the start, without contact, whose mean is subtracted; 0 subtracts nothing.",
        title="Window of the bias",
    )
    threshold: Annotated[float, Quantity("N", at_least=1e-3, at_most=10.0)] = setting(
        0.1, "Normal force from which there is contact."
    )
    plateau: Share = setting(0.5, "Largest deviation of the speed from its median, as a share of the median.")
    middle: Share = setting(0.6, "Share of the contact that counts where no position was recorded.")
    steady: Annotated[float, Quantity("s", at_least=0.01, at_most=60.0)] = setting(
        0.1, "Shortest duration of the steady part.", title="Steady part"
    )
    force: tuple[Force, Force] = setting(
        (0.1, 5.0), "Lowest and highest mean normal force of a trial that counts."
    )
    speed: tuple[Speed, Speed] = setting((0.01, 0.5), "Lowest and highest mean speed of a trial that counts.")

    def __post_init__(self) -> None:
        for name, unit in (("force", "N"), ("speed", "m/s")):
            low, high = getattr(self, name)
            if not low < high:
                raise problem(
                    "conflict",
                    f"{format_quantity(low, unit)}, {format_quantity(high, unit)}",
                    "the lower limit first",
                    "the limits are exchanged or equal",
                    "exchange them",
                    at=name,
                )


DEFAULT_RULES = Rules()


@dataclass(frozen=True)
class Measured:
    """Results of one stroke. Undetermined numbers are NaN.

    mean_of_ratios, ratio_of_means : the two averages of |tangential| / normal over the steady part
    spread : standard deviation of the ratio over the steady part
    force, speed : means over the steady part, N and m/s
    duration : duration of the steady part, s
    rest_force : normal force that was subtracted as zero, at the start of the record, N
    sensor_drift : change of the rest from the start of the record to its end, N; NaN if the record does not
        end at rest
    below_threshold, reversing, off_plateau : shares of the samples left out for each reason
    excluded : one of `REASONS`, or ""
    """

    mean_of_ratios: float = np.nan
    ratio_of_means: float = np.nan
    spread: float = np.nan
    force: float = np.nan
    speed: float = np.nan
    duration: float = 0.0
    rest_force: float = np.nan
    sensor_drift: float = np.nan
    below_threshold: float = np.nan
    reversing: float = np.nan
    off_plateau: float = np.nan
    excluded: str = ""
