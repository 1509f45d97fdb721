"""What the channels of a file mean: names, units, signs, and the calibration of a six-axis sensor."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from haptonic.channels import Group
from haptonic.channels.labels import factor_of
from haptonic.channels.signals import Array
from haptonic.errors import FrictionError, HaptonicError
from haptonic.friction.signals.filters import design_frequency
from haptonic.friction.signals.measuring import saturated
from haptonic.friction.signals.record import Record
from haptonic.friction.signals.tables import rate_of
from haptonic.paths import source

AXES = ("Fx", "Fy", "Fz", "Tx", "Ty", "Tz")
WORST_CONDITION = 1e6  # of a calibration matrix; beyond, two gauges say the same
# What a channel may be called where the study does not say; the first that is there is taken.
GUESSES = {
    "normal": ("fz", "force z", "normal", "normal force", "fn", "z force"),
    "tangential": ("fy", "force y", "tangential", "tangential force", "ft", "friction force", "y force"),
    "position": ("position", "pos", "finger position", "finger"),
    "time": ("time", "t", "timestamp", "times", "time s"),
}  # fmt: skip
GAUGES = tuple(
    tuple(f"{word}{number}" for number in range(first, first + 6))
    for word in ("g", "sg", "gauge", "gauge ", "ch", "ai", "v")
    for first in (0, 1)
)
HIGHEST_RATE = 1e12  # Hz; no converter comes near, and times that stand still give more
DIMENSION = {"normal": "N", "tangential": "N", "position": "m", "time": "s"}


@dataclass(frozen=True, eq=False)
class Sensor:
    """How channels become forces. What is empty is guessed from usual names, or taken from the file.

    normal, tangential, position, time : names; a minus before it turns the sign
    force_unit, position_unit, time_unit : of the channels
    rate : sampling rate, Hz, where the files have no time
    gauges : names of six channels in V, in the order of the columns of ``calibration``
    calibration : (6, 6) Fx Fy Fz Tx Ty Tz (N, N m) for one volt of each gauge, or None
    forced : whether the calibration is to be used also where a file has forces
    largest_force, largest_gauge : N and V at which a channel is at its end, or None
    """

    normal: str = ""
    tangential: str = ""
    position: str = ""
    time: str = ""
    force_unit: str = ""
    position_unit: str = ""
    time_unit: str = ""
    rate: float | None = None
    gauges: tuple[str, ...] = ()
    calibration: NDArray[np.float64] | None = None
    largest_force: float | None = None
    largest_gauge: float | None = None
    forced: bool = True

    def channel_map(self, channels: Group) -> ChannelMap:
        """Which channel is which.

        Raises
        ------
        FrictionError : a channel that is needed is not there, or its unit is no unit of it
        """
        names = {_plain(name): name for name in channels.signals}
        remarks: list[str] = []
        scaled: dict[str, ScaledChannel] = {}
        matrix: Array | None = None
        gauges: tuple[str, ...] = ()
        guesses = {
            meaning: next((names[word] for word in words if word in names), "")
            for meaning, words in GUESSES.items()
        }
        raw = self.calibration is not None and (self.forced or not guesses["normal"])
        for meaning in ("normal", "tangential", "position", "time"):
            asked = getattr(self, meaning)
            found = guesses[meaning]
            if raw and DIMENSION[meaning] == "N":
                continue
            if asked:
                scaled[meaning] = self._scaled(meaning, asked, channels)
            elif found:
                scaled[meaning] = self._scaled(meaning, found, channels)
                remarks.append(f'the channel "{found}" was taken as {meaning}')
            elif DIMENSION[meaning] == "N":
                channels[GUESSES[meaning][0].capitalize()]  # refused, with the names that there are
        if raw and self.calibration is not None:
            matrix = self._rows(self.calibration)
            gauges = self.gauges or _guessed_gauges(names, channels)
            if not self.gauges:
                remarks.append(f"the channels {', '.join(gauges)} were taken as the gauges, in this order")
        if "time" not in scaled and self.rate is None and channels.rate is None:
            raise _no_rate()
        limits = self.largest_force, self.largest_gauge
        return ChannelMap(scaled, self.rate, gauges, matrix, *limits, tuple(remarks), not self.normal)

    def _scaled(self, meaning: str, asked: str, channels: Group) -> ScaledChannel:
        turned = asked.startswith("-")
        name = asked.removeprefix("-").strip()
        if name not in channels.signals:
            name = next((known for known in channels.signals if _plain(known) == _plain(name)), name)
        channels[name]
        kind = {"N": "force", "m": "position", "s": "time"}[DIMENSION[meaning]]
        unit = getattr(self, f"{kind}_unit") or channels.signals[name].unit
        factor = 1.0
        if unit:
            try:
                factor = factor_of(unit, DIMENSION[meaning])
            except HaptonicError as error:
                raise FrictionError(
                    argument=f"unit of the channel {name}",
                    given=f'"{unit}"',
                    allowed=f'a unit of {kind}, such as "m{DIMENSION[meaning]}"',
                    cause="raw volts without a calibration" if unit.endswith("V") else error.cause,
                    next_step=f"give {kind}_unit, or calibration and gauges, in [trials.sensor]",
                ) from None
        return ScaledChannel(name, -factor if turned else factor)

    def _rows(self, calibration: Array) -> Array:
        """(2, 6) rows of the calibration for normal and tangential force."""
        rows = []
        for asked, usual in ((self.normal, "Fz"), (self.tangential, "Fy")):
            axis = asked.removeprefix("-").strip() or usual
            if axis not in AXES[:3]:
                raise FrictionError(
                    argument="trials.sensor",
                    given=axis,
                    allowed="Fx, Fy or Fz, where a calibration makes the forces",
                    cause="the name of a raw channel was given",
                    next_step="name the axis; the raw channels are named by gauges",
                )
            rows.append(calibration[AXES.index(axis)] * (-1 if asked.startswith("-") else 1))
        return np.array(rows)


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
            raise FrictionError(
                argument="start and stop",
                given=f"{start} s to {stop} s",
                allowed=f"times within the file, which lasts {len(self._any(channels)) / rate:.4g} s",
                cause="the file was cut, or the times are in ms",
                next_step="put the table of trials right",
            )
        position = signal("position") if "position" in self.scaled else None
        return Record(normal, tangential, rate, position, flat)

    def turned(self) -> ChannelMap:
        """The same with the sign of the normal force turned, and a remark on it."""
        remarks = (*self.remarks, "the normal force falls where the finger presses: its sign was turned")
        if self.matrix is not None:
            return replace(self, matrix=self.matrix * np.array([[-1.0], [1.0]]), remarks=remarks)
        one = self.scaled["normal"]
        turned = ScaledChannel(one.name, -one.factor)
        return replace(self, scaled={**self.scaled, "normal": turned}, remarks=remarks)

    def _any(self, channels: Group) -> Array:
        return channels[self.gauges[0] if self.gauges else self.scaled["normal"].name]

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
            raise _no_rate()
        design_frequency("literal", rate)
        return rate


def pressing(records: Sequence[Record]) -> float:
    """How far the normal force goes up less how far it goes down from its start, N, over all records."""
    apart = [record.normal - record.normal[: max(1, len(record.normal) // 20)].mean() for record in records]
    return float(sum(np.nanmax(one) + np.nanmin(one) for one in apart if np.isfinite(one).any()))


def read_calibration(path: Path) -> Array:
    """A calibration matrix, (6, 6): forces and torques Fx Fy Fz Tx Ty Tz for one volt of each gauge.

    A CSV file of six rows of six numbers; a row of names above and a column of names before may stand there.

    Raises
    ------
    FrictionError : no such file, another shape, text, or rows that depend on each other
    """
    path = source(path, "trials.sensor.calibration", FrictionError)
    try:
        table = pd.read_csv(path, header=None, comment="#")
        if len(table) == 7:
            table = table.iloc[1:]
        if table.shape[1] == 7:
            table = table.iloc[:, 1:]
        matrix = np.asarray(table, dtype=float)
        given = f"{matrix.shape[0]} x {matrix.shape[1]} numbers"
    except OSError:
        matrix, given = np.empty((0, 0)), f"{path}, which cannot be read"
    except ValueError:  # also an empty file, and one with rows of unequal length
        matrix, given = np.empty((0, 0)), f"{path}, which is no table of numbers"
    cause = "another file, or the matrix of a sensor with another number of axes"
    if matrix.shape == (6, 6):
        whole = np.nan_to_num(matrix / _scale(np.nan_to_num(matrix)))
        condition = float(np.linalg.cond(whole))
        if np.isfinite(matrix).all() and condition < WORST_CONDITION:
            return matrix
        rank = np.linalg.matrix_rank(whole)
        given = f"a matrix of rank {rank}, condition number {condition:.2g}"
        cause = "a row was copied twice or left at zero"
    raise FrictionError(
        argument="trials.sensor.calibration",
        given=given,
        allowed="a CSV file of six rows (Fx Fy Fz Tx Ty Tz) by six gauges, of full rank",
        cause=cause,
        next_step="export the matrix from the sensor's calibration file again",
    )


def _no_rate() -> FrictionError:
    return FrictionError(
        argument="sampling rate",
        given="neither times nor a rate",
        allowed="a channel of times, or trials.sensor.rate",
        cause="the times were not saved",
        next_step='add rate = "1 kHz" in [trials.sensor]',
    )


def _scale(matrix: Array) -> Array:
    """(6, 1) size of each row: newtons and newton metres differ."""
    return np.asarray(np.maximum(np.abs(matrix).max(axis=1, keepdims=True), 1e-300))


def _plain(name: str) -> str:
    return re.sub(r"[_\-\s]+", " ", name).strip().lower()


def _guessed_gauges(names: dict[str, str], channels: Group) -> tuple[str, ...]:
    for six in GAUGES:
        if all(name in names for name in six):
            return tuple(names[name] for name in six)
    raise FrictionError(
        argument="trials.sensor.gauges",
        given=", ".join(channels.signals) or "no channel of numbers",
        allowed="the names of six channels",
        cause="the gauges have other names than g0 ... g5",
        next_step='add gauges = "name, name, name, name, name, name" in [trials.sensor]',
    )
