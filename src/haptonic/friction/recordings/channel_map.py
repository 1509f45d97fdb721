"""Channels by what they mean, and the records that they make."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from haptonic.arrays import Array
from haptonic.channels import Group
from haptonic.errors import FrictionError
from haptonic.friction.signals.filters import design_frequency
from haptonic.friction.signals.measuring import saturated
from haptonic.friction.signals.record import Record
from haptonic.friction.signals.tables import rate_of

HIGHEST_RATE = 1e12  # Hz; no converter comes near, and times that stand still give more


@dataclass(frozen=True)
class ScaledChannel:
    """A channel and what one of its units is in SI, negative where the sign is turned."""

    name: str
    factor: float


@dataclass(frozen=True, eq=False)
class ChannelMap:
    """Channels by what they mean, ready to make records; see `Sensor.channel_map`.

    remarks : what was guessed, in words
    sign_unknown : whether nobody said in which direction the normal force counts
    """

    scaled: dict[str, ScaledChannel]
    rate: float | None
    gauges: tuple[str, ...]
    matrix: Array | None
    largest_force: float | None
    largest_gauge: float | None
    remarks: tuple[str, ...]
    sign_unknown: bool

    def record(self, channels: Group, rate: float, start: float | None, stop: float | None) -> Record:
        """The record between two times, s from the first sample of the file; ``rate`` is from `rate_in`.

        Raises
        ------
        FrictionError : a channel is missing, nothing between the two times, or forces that no finger makes
        """
        first = round((start or 0.0) * rate)
        last = None if stop is None else round(stop * rate)

        def signal(meaning: str) -> Array:
            one = self.scaled[meaning]
            return one.factor * channels[one.name][first:last]

        flat = False
        if self.matrix is None:
            normal, tangential = signal("normal"), signal("tangential")
        else:
            volts = np.array([channels[name][first:last] for name in self.gauges])
            normal, tangential = self.matrix @ volts
            flat = bool(volts.size and saturated(volts[:, None]).any())
            flat |= self.largest_gauge is not None and bool((np.abs(volts) >= self.largest_gauge).any())
        if self.largest_force is not None:
            flat |= bool((np.abs([normal, tangential]) >= self.largest_force).any())
        if not normal.size:
            any_name = self.gauges[0] if self.gauges else self.scaled["normal"].name
            raise FrictionError.out_of_range(
                argument="start and stop",
                given=f"{start} s to {stop} s",
                allowed=f"times within the file, which lasts {len(channels[any_name]) / rate:.4g} s",
                cause="the file was cut, or the times are in ms",
                next_step="put the table of trials right",
            )
        position = signal("position") if "position" in self.scaled else None
        return Record(normal=normal, tangential=tangential, rate=rate, position=position, saturated=flat)

    def turned(self) -> ChannelMap:
        """The same with the sign of the normal force turned, and a remark on it."""
        remarks = (*self.remarks, "the normal force falls where the finger presses: its sign was turned")
        if self.matrix is not None:
            return replace(self, matrix=self.matrix * np.array([[-1.0], [1.0]]), remarks=remarks)
        one = self.scaled["normal"]
        turned = ScaledChannel(one.name, -one.factor)
        return replace(self, scaled={**self.scaled, "normal": turned}, remarks=remarks)

    def rate_in(self, channels: Group) -> float:
        """Sampling rate of a file or group, Hz.

        Raises
        ------
        FrictionError : times that do not advance evenly, no rate, or one too low for the filters
        """
        rate = self.rate or channels.rate
        if "time" in self.scaled:
            one = self.scaled["time"]
            rate = rate_of(one.factor * channels[one.name], f"channel {one.name}")
        if rate is None or not 0 < rate < HIGHEST_RATE:
            raise no_rate()
        design_frequency("literal", rate)
        return rate


def pressing(records: Sequence[Record]) -> float:
    """How far the normal force goes up less how far it goes down from its start, N, over all records."""
    apart = [record.normal - record.normal[: max(1, len(record.normal) // 20)].mean() for record in records]
    return float(sum(np.nanmax(one) + np.nanmin(one) for one in apart if np.isfinite(one).any()))


def no_rate() -> FrictionError:
    """The error of a file that says nothing of its times."""
    return FrictionError.missing(
        argument="sampling rate",
        given="neither times nor a rate",
        allowed="a channel of times, or trials.sensor.rate",
        cause="the times were not saved",
        next_step='add rate = "1 kHz" in [trials.sensor]',
    )
