"""Meaning of the channels of a file: names, units, signs, and the calibration of a six-axis sensor."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import AfterValidator, Field

from haptonic.arrays import Array
from haptonic.channels import Group
from haptonic.channels.delimited import FIRST_ROW, NAMES_LINE
from haptonic.errors import FrictionError, HaptonicError, nearest, shown
from haptonic.fields import Quantity, described, handed_on, problem, setting
from haptonic.friction.recordings.channel_map import ChannelMap, no_rate
from haptonic.friction.recordings.channel_names import Names, plain
from haptonic.friction.recordings.scaled_channel import KINDS, ScaledChannel
from haptonic.friction.recordings.titles import scale_of
from haptonic.later import pandas as pd
from haptonic.names import listed, names_in
from haptonic.paths import source
from haptonic.units import to_si

AXES = ("Fx", "Fy", "Fz", "Tx", "Ty", "Tz")
SIX = 6  # gauges of a sensor
WORST_CONDITION = 1e6  # of a calibration matrix; beyond, two gauges are nearly equal
GAUGES = tuple(
    tuple(f"{word}{number}" for number in range(first, first + 6))
    for word in ("g", "sg", "gauge", "gauge ", "ch", "ai", "v")
    for first in (0, 1)
)
CALIBRATION = "calibration.csv"  # used without a setting if it is beside the trials
DIMENSION: dict[str, Literal["N", "m", "s"]] = {
    "normal": "N", "tangential": "N", "across": "N", "position": "m", "time": "s",
}  # fmt: skip
WORDS = {
    "normal": "the normal force", "tangential": "the tangential force", "position": "the position",
    "time": "the times",
}  # fmt: skip
USUAL = {"normal": "Fz or normal force", "tangential": "Fy, Fx or tangential force"}


def _unit_like(unit: str) -> AfterValidator:
    """Refuse units of another dimension."""

    def checked(text: str) -> str:
        try:
            if text:
                to_si(f"1 {text}", unit, "")
        except HaptonicError as error:
            raise handed_on(error.changed(HaptonicError, allowed=f'a unit, such as "m{unit}"'), "") from None
        return text

    return AfterValidator(checked)


Text = Annotated[str, Field(max_length=200, strict=True)]


@described("trials.sensor", FrictionError, kw_only=True)
class Sensor:
    """Channels of the files. Missing names are guessed from usual names and reported."""

    normal: Text = setting(
        "",
        "Name or number of the channel; a minus before it reverses the sign, by default the records give it.",
        title="Normal force",
        examples=["-Fz"],
    )
    tangential: Text = setting(
        "", "Name or number of its channel.", title="Tangential force", examples=["Fx"]
    )
    position: Text = setting("", "Name or number of the channel along the stroke.", examples=["x"])
    time: Text = setting("", "Name or number of its channel.", examples=["t"])
    force_unit: Annotated[Text, _unit_like("N")] = setting(
        "", "Unit of forces; by default that of the file, or N.", title="Unit of the forces", examples=["mN"]
    )
    position_unit: Annotated[Text, _unit_like("m")] = setting(
        "",
        "Unit of positions; by default that of the file, or m.",
        title="Unit of the position",
        examples=["mm"],
    )
    time_unit: Annotated[Text, _unit_like("s")] = setting(
        "", "Unit of times; by default that of the file, or s.", title="Unit of the time", examples=["ms"]
    )
    rate: Annotated[float, Quantity("Hz", above=0.0, at_most=1e7, typical=(250.0, 1e5))] | None = setting(
        None,
        "Samples per second; needed without a channel of times, and used in place of one.",
        title="Sampling rate",
    )
    gauges: Text = setting(
        "",
        "Names of six raw channels, with commas, in the calibration's order.",
        examples=["G1,G2,G3,G4,G5,G6"],
    )
    calibration: Text = setting(
        "",
        "CSV file of 6 x 6 numbers beside the trials: Fx Fy Fz Tx Ty Tz for 1 V of each gauge; "
        f"else {CALIBRATION} if it is there and the files have no forces.",
        examples=[CALIBRATION],
    )
    largest_force: Annotated[float, Quantity("N", above=0.0, at_most=1e4)] | None = setting(
        None, "Force at which a channel is saturated.", title="End of the range"
    )
    largest_gauge: Annotated[float, Quantity("V", above=0.0, at_most=1e3)] | None = setting(
        None, "Voltage at which a raw channel is saturated.", title="End of the gauges"
    )

    def __post_init__(self) -> None:
        if self.gauges and (count := self.gauges.count(",") + 1) < SIX:  # more, if names contain commas
            raise problem(
                "malformed",
                shown(self.gauges), "six different names with commas between them",
                f"there are {count}", 'write gauges = "G0, G1, G2, G3, G4, G5"', at="gauges",
            )  # fmt: skip
        axes = [name.removeprefix("-").strip() for name in (self.normal, self.tangential) if name]
        if self.calibration and not set(axes) <= set(AXES[:3]):
            raise problem(
                "unknown",
                listed(axes), "Fx, Fy or Fz if the forces come from a calibration",
                "the name of a raw channel was given", 'write normal = "Fz"', at="normal",
            )  # fmt: skip

    def matrix(self, folder: Path) -> Array | None:
        """(6, 6) Fx Fy Fz Tx Ty Tz (N, N m) for one volt of each gauge; None without a calibration.

        Raises
        ------
        FrictionError : a calibration that is not a matrix of full rank
        """
        path = folder / (self.calibration or CALIBRATION)
        return read_calibration(path) if self.calibration or path.is_file() else None

    def channel_map(self, channels: Group, calibration: Array | None) -> ChannelMap:
        """Map the meanings to channels.

        Parameters
        ----------
        calibration : see `matrix`; the study's gauges or file go before forces in the file, a default file
            after

        Raises
        ------
        FrictionError : a required channel is missing, or its unit has another dimension
        """
        guesses = self._guesses(channels)
        remarks: list[str] = []
        scaled: dict[str, ScaledChannel] = {}
        matrix: Array | None = None
        gauges: tuple[str, ...] = ()
        raw = calibration is not None and bool(self.calibration or self.gauges or not guesses["normal"])
        for meaning, dimension in DIMENSION.items():
            given = getattr(self, meaning, "")
            if raw and dimension == "N":
                continue
            name = (
                self._by_name(meaning, given, channels)
                if given
                else self._guessed(meaning, guesses, channels)
            )
            if not name:
                continue
            sign = -1.0 if given.startswith("-") else 1.0
            unit = getattr(self, f"{KINDS[dimension]}_unit")
            channel = ScaledChannel(name, dimension, unit, sign)
            scaled[meaning] = replace(channel, usual=channel.factor_in(channels))
            if not given and meaning != "across":
                remarks.append(f'the channel "{name}" was taken as {meaning}')
        if raw and calibration is not None:
            matrix = self._rows(calibration)
            gauges = self._gauges(channels) or _guessed_gauges(channels)
            if not self.gauges:
                remarks.append(f"the channels {', '.join(gauges)} were taken as the gauges, in this order")
        scale = scale_of(channels)
        if scale.counts != 1 and not self.force_unit:
            remarks.append(f"a title gives {scale.counts:g} counts for a force of 1 {scale.unit or 'N'}")
        if "time" not in scaled and self.rate is None and channels.rate is None:
            if scale.rate is None:
                raise no_rate()
            remarks.append(f"the sampling rate, {scale.rate:g} Hz, was taken from a title")
        return ChannelMap(
            scaled=scaled, rate=self.rate, gauges=gauges, matrix=matrix, largest_force=self.largest_force,
            largest_gauge=self.largest_gauge, remarks=tuple(remarks),
            sign_unknown=not self.normal.startswith("-"), axis_unknown=not self.tangential,
            named=bool(self.normal and self.tangential),
        )  # fmt: skip

    def _guesses(self, channels: Group) -> dict[str, list[str]]:
        """Names of channels by meaning: names with the meaning, or else names of the axes."""
        names = Names.of(channels.signals)
        texts = Names.of(name for name, channel in channels.channels.items() if channel.kind == "text")
        normal = names.normal or names.axes["z"]
        pressing = [self.normal.removeprefix("-").strip()] if self.normal else normal
        tangential, across = names.tangential, list[str]()
        if not tangential:
            plane = [names.axes[axis] for axis in "yxz"]
            plane = [alike for alike in plane if alike and not set(alike) & set(pressing)]
            wanted = self.tangential.removeprefix("-").strip()
            plane = sorted(plane[:2], key=lambda alike: wanted not in alike) if wanted else plane[:2]
            tangential, across = (*plane, [], [])[:2]
        time = names.time or texts.time
        return {
            "normal": normal, "tangential": tangential, "across": across, "position": names.position,
            "time": time,
        }  # fmt: skip

    def _guessed(self, meaning: str, guesses: dict[str, list[str]], channels: Group) -> str:
        """The channel whose name has this meaning; "" if an optional channel is missing.

        Raises
        ------
        FrictionError : several channels have the meaning, or a required channel is missing
        """
        names = guesses[meaning]
        if len(names) == 1:
            return names[0]
        if meaning == "across" or (not names and DIMENSION[meaning] != "N"):
            return ""
        if not names and FIRST_ROW in channels.properties and NAMES_LINE not in channels.properties:
            raise self._nameless(meaning, channels)
        candidates = ", ".join(f'"{name}"' for name in names or channels.signals)
        others = {*guesses["time"], *guesses["position"]}
        example = (names or [*(name for name in channels.signals if name not in others), "Fz"])[0]
        raise FrictionError(
            "conflict" if names else "unknown",
            argument=f"channel of {WORDS[meaning]}",
            given=f"several that may be meant: {candidates}"
            if names
            else f"no usual name among {candidates or 'none'}",
            allowed=f"one channel of {WORDS[meaning]}"
            + ("" if names else f", such as {USUAL.get(meaning, meaning)}"),
            cause="several names have this meaning" if names else "the channels have unusual names",
            next_step=f'name it, or give its number, in [trials.sensor], such as {meaning} = "{example}"',
        )

    def _nameless(self, meaning: str, channels: Group) -> FrictionError:
        first = ", ".join(channels.properties[FIRST_ROW])
        return FrictionError.unknown(
            f"channel of {WORDS[meaning]}", first, list(channels.signals),
            "the file has no line of names: the first line of the table contains numbers", slip=False,
            allowed=f"columns by number, from 1 to {len(channels.channels)}",
            next_step='write normal = "4", tangential = "3" and time = "1", with the right numbers, in '
            "[trials.sensor]",
        )  # fmt: skip

    def _by_name(self, meaning: str, given: str, channels: Group) -> str:
        """The channel that the study names, or gives by its number from 1.

        Raises
        ------
        FrictionError : no such channel
        """
        name = given.removeprefix("-").strip()
        candidates = channels.channels if meaning == "time" else channels.signals
        if name in candidates:
            return name
        alike = [candidate for candidate in candidates if plain(candidate) == plain(name)]
        if len(alike) == 1:
            return alike[0]
        every = list(channels.channels)
        if name.isdecimal() and 1 <= int(name) <= len(every) and every[int(name) - 1] in candidates:
            return every[int(name) - 1]
        guess = nearest(name, candidates) or next(iter(candidates), name)
        raise FrictionError.unknown(
            f"trials.sensor.{meaning}", name, candidates,
            "the column has another name, or the file is another one", slip=False,
            next_step=f'write {meaning} = "{guess}", or the number of the channel, in [trials.sensor]',
        )  # fmt: skip

    def _gauges(self, channels: Group) -> tuple[str, ...]:
        """The raw channels that the study names, in the order of the calibration's columns."""
        gauges = names_in(self.gauges, channels.signals)
        if gauges and (len(gauges) != SIX or len(set(gauges)) != SIX):
            raise FrictionError.malformed(
                argument="trials.sensor.gauges",
                given=shown(self.gauges),
                allowed="six different names with commas between them",
                cause=f"there are {len(set(gauges))} among {len(gauges)}",
                next_step='write gauges = "G0, G1, G2, G3, G4, G5"',
            )
        return gauges

    def _rows(self, calibration: Array) -> Array:
        """(3, 6) rows of the calibration: normal force, tangential force, and the force across."""
        normal = self.normal.removeprefix("-").strip() or "Fz"
        along = self.tangential.removeprefix("-").strip() or next(
            axis for axis in ("Fy", "Fx") if axis != normal
        )
        for axis in (normal, along):
            if axis not in AXES[:3]:
                cause = "a calibration makes the forces, and the name of a raw channel was given"
                raise FrictionError.unknown("trials.sensor", axis, AXES[:3], cause)
        across = next(axis for axis in AXES[:3] if axis not in (normal, along))
        rows = calibration[[AXES.index(axis) for axis in (normal, along, across)]]
        signs = [-1.0 if name.startswith("-") else 1.0 for name in (self.normal, self.tangential, "")]
        return np.asarray(rows * np.array(signs)[:, None])


def read_calibration(path: Path) -> Array:
    """Read a calibration matrix, (6, 6): Fx Fy Fz Tx Ty Tz for one volt of each gauge.

    The CSV file has six rows of six numbers; a row of names above and a column of names before are allowed.

    Raises
    ------
    FrictionError : no such file, another shape, text, or rows that depend on each other
    """
    path, code = source(path, "trials.sensor.calibration", FrictionError), "unreadable"
    try:
        table = pd.read_csv(path, header=None, comment="#")
        if len(table) == 7:
            table = table.iloc[1:]
        if table.shape[1] == 7:
            table = table.iloc[:, 1:]
        matrix = np.asarray(table, dtype=float)
        given = f"{matrix.shape[0]} x {matrix.shape[1]} numbers"
    except OSError as error:
        matrix, given = np.empty((0, 0)), f"{path}, which cannot be read"
        code = "not-found" if isinstance(error, FileNotFoundError) else code
    except ValueError:  # also an empty file, and one with rows of unequal length
        matrix, given = np.empty((0, 0)), f"{path}, which is no table of numbers"
    cause = "another file, or the matrix of a sensor with another number of axes"
    if matrix.shape == (6, 6):
        # each row is scaled by its size: newtons and newton metres differ
        size = np.abs(np.nan_to_num(matrix)).max(axis=1, keepdims=True)
        whole = np.nan_to_num(matrix / np.maximum(size, 1e-300))
        condition = float(np.linalg.cond(whole))
        if np.isfinite(matrix).all() and condition < WORST_CONDITION:
            return matrix
        rank = np.linalg.matrix_rank(whole)
        given = f"a matrix of rank {rank}, condition number {condition:.2g}"
        cause = "a row was copied twice or left at zero"
    raise FrictionError(
        code,
        argument="trials.sensor.calibration",
        given=given,
        allowed="a CSV file of six rows (Fx Fy Fz Tx Ty Tz) by six gauges, of full rank",
        cause=cause,
        next_step="export the matrix from the sensor's calibration file again",
    )


def _guessed_gauges(channels: Group) -> tuple[str, ...]:
    names = {re.sub(r"[_\-\s]+", " ", name).strip().lower(): name for name in channels.signals}
    for six in GAUGES:
        if all(name in names for name in six):
            return tuple(names[name] for name in six)
    raise FrictionError.missing(
        argument="trials.sensor.gauges",
        given=", ".join(channels.signals) or "no channel of numbers",
        allowed="the names of six channels",
        cause="the gauges have other names than g0 ... g5",
        next_step='add gauges = "name, name, name, name, name, name" in [trials.sensor]',
    )
