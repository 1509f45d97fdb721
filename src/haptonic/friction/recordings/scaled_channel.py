"""A channel of a file and its unit in SI: from the study, the file or a title."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from haptonic.arrays import Array
from haptonic.channels import Group
from haptonic.channels.labels import factor_of
from haptonic.errors import FrictionError, HaptonicError
from haptonic.friction.recordings.channel_names import split
from haptonic.friction.recordings.titles import scale_of
from haptonic.friction.signals.clock import seconds_of_day

KINDS = {"N": "force", "m": "position", "s": "time"}


@dataclass(frozen=True)
class ScaledChannel:
    """A channel by its name.

    dimension : SI unit of its values
    unit : unit that the study gives; empty if each file gives it
    sign : -1 if the study reverses it
    usual : SI value of one unit, for files that do not give the unit; from the first file
    """

    name: str
    dimension: Literal["N", "m", "s"]
    unit: str = ""
    sign: float = 1.0
    usual: float | None = None

    def factor_in(self, channels: Group) -> float:
        """SI value of one unit of the channel in this file.

        Raises
        ------
        FrictionError : a unit of another dimension
        """
        unit, counts = self.unit or channels.channels[self.name].unit or split(self.name)[1], 1.0
        if not unit and self.dimension == "N":
            scale = scale_of(channels)
            unit, counts = scale.unit, scale.counts
        if not unit:
            return self.sign / counts if counts != 1 or self.usual is None else self.usual
        kind = KINDS[self.dimension]
        try:
            return self.sign / counts * factor_of(unit, self.dimension)
        except HaptonicError as error:
            raise FrictionError.malformed(
                argument=f"unit of the channel {self.name}",
                given=f'"{unit}"',
                allowed=f'a unit of {kind}, such as "m{self.dimension}"',
                cause="raw volts without a calibration" if unit.endswith("V") else error.cause,
                next_step=f"give {kind}_unit, or calibration and gauges, in [trials.sensor]",
            ) from None

    def times(self, channels: Group) -> Array:
        """Times of the rows, s.

        Raises
        ------
        HaptonicError : no such channel, or texts that are not times of day
        """
        channel = channels.channels.get(self.name)
        values = np.zeros(0) if channel is None else np.asarray(channel)
        if values.dtype.kind in "OUS":
            return seconds_of_day(values.ravel().tolist(), f"channel {self.name}")
        return channels[self.name] * self.factor_in(channels)
