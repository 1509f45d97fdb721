"""Map from meanings to channels, and the records that it makes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from haptonic.arrays import Array
from haptonic.channels import Group
from haptonic.errors import FrictionError, HaptonicError
from haptonic.friction.recordings.mounting import Mounting, own_angle
from haptonic.friction.recordings.scaled_channel import ScaledChannel
from haptonic.friction.recordings.titles import scale_of
from haptonic.friction.signals.clock import Clock, clock_at, clock_of, repeats_of
from haptonic.friction.signals.filters import design_frequency
from haptonic.friction.signals.record import Record

HIGHEST_RATE = 1e12  # Hz; above any converter
ELSEWHERE = "the stroke goes in another direction than the participant's others: its own direction was taken"


@dataclass(frozen=True, eq=False)
class ChannelMap:
    """Channels by their meaning, ready to make records; see `Sensor.channel_map`.

    remarks : guesses, in sentences
    sign_unknown : True if the study does not give the sign of the normal force
    axis_unknown : True if the study does not give the channel along the stroke
    named : True if the study names both the normal and the tangential force
    mountings : orientation of the sensor, by participant; see `mounted`
    doubts : unusual facts about the sensor
    """

    scaled: dict[str, ScaledChannel]
    rate: float | None
    gauges: tuple[str, ...]
    matrix: Array | None
    largest_force: float | None
    largest_gauge: float | None
    remarks: tuple[str, ...]
    sign_unknown: bool
    axis_unknown: bool
    named: bool = False
    mountings: Mapping[str, Mounting] = field(default_factory=dict)
    doubts: tuple[str, ...] = ()

    def mounted(
        self, mountings: Mapping[str, Mounting], remarks: tuple[str, ...], doubts: tuple[str, ...]
    ) -> ChannelMap:
        """A copy with the orientation of the sensor, by participant, and remarks on it."""
        oblique = any(mounting.angle for mounting in mountings.values())
        guessed = [text for text in self.remarks if not (oblique and text.endswith("as tangential"))]
        return replace(self, mountings=mountings, remarks=(*guessed, *remarks), doubts=doubts)

    @property
    def plane(self) -> tuple[str, str]:
        """Names of the tangential channel and of the other one in the plane."""
        if self.matrix is not None:
            return "the tangential axis", "the other axis"
        return tuple(
            self.scaled[role].name if role in self.scaled else "" for role in ("tangential", "across")
        )  # type: ignore[return-value]

    def record(
        self, channels: Group, clock: Clock, start: float | None, stop: float | None, participant: str = ""
    ) -> Record:
        """The record between two times, s from the first sample of the file; ``clock`` is from `clock_in`.

        Raises
        ------
        FrictionError : a channel is missing, no sample lies between the two times, or the forces are too
            large
        """
        self._refuse_lengths(channels)
        rate = clock.rate
        first = round((start or 0.0) * rate)
        last = None if stop is None else round(stop * rate)

        def signal(name: str) -> Array:
            return clock.regular(channels[name])[first:last]

        def scaled(meaning: str) -> Array:
            channel = self.scaled[meaning]
            values = signal(channel.name)
            return channel.factor_in(channels) * values

        flat, across = False, None
        if self.matrix is None:
            normal, tangential = scaled("normal"), scaled("tangential")
            across = scaled("across") if "across" in self.scaled else None
            forces = [self.scaled[axis] for axis in ("normal", "tangential", "across") if axis in self.scaled]
            raw = [(force.name, force.factor_in(channels)) for force in forces]
        else:
            volts, raw = (
                np.array([signal(name) for name in self.gauges]),
                [(name, 1.0) for name in self.gauges],
            )
            normal, tangential, across = self.matrix @ volts
            flat = self.largest_gauge is not None and bool((np.abs(volts) >= self.largest_gauge).any())
        if self.largest_force is not None:
            flat |= bool((np.abs([normal, tangential]) >= self.largest_force).any())
        if not normal.size:
            any_name = self.gauges[0] if self.gauges else self.scaled["normal"].name
            raise FrictionError.out_of_range(
                argument="start and stop",
                given=f"{start} s to {stop} s",
                allowed=f"times within the file, which lasts {len(channels[any_name]) / rate:.4g} s",
                cause="the file was cut, or the times are in ms",
                next_step="correct the table of trials",
            )
        mounting = self.mountings.get(participant, Mounting())
        record = Record(
            normal=mounting.sign * normal, tangential=tangential, rate=rate,
            position=scaled("position") if "position" in self.scaled else None, saturated=flat,
            across=across,
            raw=np.array([unit * clock.rows(channels[name], first, last) for name, unit in raw]),
            remarks=(clock.remark,) if clock.remark else (),
        )  # fmt: skip
        return self._along(record, mounting.angle) if self.axis_unknown and self.mountings else record

    def _refuse_lengths(self, channels: Group) -> None:
        """Refuse a file in which one channel has fewer samples than another: the missing ones are unknown."""
        timed = self.rate is None  # with a given rate, times are not used
        used = (channel.name for meaning, channel in self.scaled.items() if timed or meaning != "time")
        all_channels = channels.channels
        lengths = {name: all_channels[name].size for name in (*self.gauges, *used) if name in all_channels}
        if not lengths:
            return
        few, many = min(lengths, key=lengths.__getitem__), max(lengths, key=lengths.__getitem__)
        if lengths[few] != lengths[many]:
            raise FrictionError.malformed(
                argument=f"channel {few}",
                given=f"{lengths[few]} samples, where {many} has {lengths[many]}",
                allowed="as many samples in all channels of a record",
                cause="the file was cut, or the channels have different rates",
                next_step="record this trial again, or export all channels at one rate",
            )

    def _along(self, record: Record, usual: float) -> Record:
        """The record with the force along the usual stroke, or along a stroke that departs from it."""
        aside = own_angle(record, usual)
        remarks = record.remarks if aside is None else (*record.remarks, ELSEWHERE)
        angle = usual if aside is None else aside
        if not angle or record.across is None:
            return record
        along = math.cos(angle) * record.tangential + math.sin(angle) * record.across
        across = math.cos(angle) * record.across - math.sin(angle) * record.tangential
        return replace(record, tangential=along, across=across, remarks=remarks)

    def clock_in(self, channels: Group) -> Clock:
        """Clock of a file or group, from the study's rate, else from times, else from the file's rate.

        Raises
        ------
        FrictionError : times without even samples, no rate, or a rate too low for the filters
        """
        clock = self._clock(channels)
        design_frequency("literal", clock.rate)
        return clock

    def _clock(self, channels: Group) -> Clock:
        if "time" not in self.scaled:
            rate = self.rate or channels.rate or scale_of(channels).rate
            if rate is None or not 0 < rate < HIGHEST_RATE:
                raise no_rate()
            return Clock(rate)
        time = self.scaled["time"]
        try:
            times = time.times(channels)
        except HaptonicError:
            if self.rate is not None:  # the times are not needed
                return Clock(self.rate)
            raise
        others = {*(channel.name for channel in self.scaled.values()), *self.gauges} - {time.name}
        repeats = repeats_of(times, (channels[name] for name in others))
        times, where = times[~repeats], f"channel {time.name}"
        clock = clock_of(times, where) if self.rate is None else clock_at(self.rate, times, where)
        return clock.without(repeats)


def no_rate() -> FrictionError:
    """The error for a file with neither times nor a sampling rate."""
    return FrictionError.missing(
        argument="sampling rate",
        given="neither times nor a rate",
        allowed="a channel of times, or trials.sensor.rate",
        cause="the times were not saved, or their channel has another name than time or t",
        next_step='add rate = "1 kHz", or time = "the name of the channel", in [trials.sensor]',
    )
