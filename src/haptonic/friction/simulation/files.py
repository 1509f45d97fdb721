"""Force records as files: named channels in CSV, HDF5, MATLAB or TDMS, each marked as simulated."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np

from haptonic.arrays import Array
from haptonic.channels import Channel, Group, delimited, hdf5, matlab, tdms
from haptonic.channels.signals import ORIGIN, SIMULATED
from haptonic.friction.simulation.gauges import GAUGES, voltages
from haptonic.friction.simulation.strokes import AXES, RATE, Stroke

__all__ = ["SIMULATED", "WRITERS", "channels_of"]

Channels = Mapping[str, Array]

GROUP = "records"  # of a TDMS file, which needs one
DIGITS = 6  # after the decimal point, in text: 1 uN, 1 um
UNITS = {"time": "s", "position": "m"}


def channels_of(strokes: Sequence[Stroke], calibration: Array | None = None) -> Channels:
    """Channels of a file by name, strokes one after the other.

    calibration : of the sensor; with it, gauge voltages replace forces and torques
    """
    axes = np.hstack([stroke.axes for stroke in strokes])
    names = AXES if calibration is None else GAUGES
    values = axes if calibration is None else voltages(axes, calibration)
    time = np.arange(axes.shape[1]) / RATE
    position = np.concatenate([stroke.position for stroke in strokes])
    return {"time": time, **dict(zip(names, values, strict=True)), "position": position}


def unit_of(channel: str) -> str:
    """Unit of a channel by its name."""
    return UNITS.get(channel) or {"F": "N", "T": "N m", "G": "V"}[channel[0]]


def write_csv(channels: Channels, path: Path) -> None:
    """Write a line for each sample, below the names; the last column marks it as simulated."""
    table = {name: np.round(values, DIGITS) for name, values in channels.items()}
    delimited.write(path, {**table, ORIGIN: [SIMULATED] * len(channels["time"])})


def write_h5(channels: Channels, path: Path) -> None:
    """Write a data set for each channel, with its unit; the file is marked as simulated."""
    hdf5.write(path, _channels(channels), {ORIGIN: SIMULATED})


def write_mat(channels: Channels, path: Path) -> None:
    """Write a variable for each channel, and a text that marks the file as simulated (MATLAB, version 5)."""
    matlab.write(path, channels, SIMULATED)


def write_tdms(channels: Channels, path: Path) -> None:
    """Write a waveform for each channel, with its unit; the file is marked as simulated.

    Raises
    ------
    ChannelError : npTDMS is not installed
    """
    every = {channel.name: channel for channel in _channels(channels)}
    tdms.write(path, {ORIGIN: SIMULATED}, [[Group(GROUP, every)]])


def _channels(channels: Channels) -> list[Channel]:
    rate = 1 / float(channels["time"][1] - channels["time"][0])
    return [Channel.of(name, values, unit_of(name), rate) for name, values in channels.items()]


WRITERS: Mapping[str, Callable[[Channels, Path], None]] = {
    "csv": write_csv,
    "h5": write_h5,
    "mat": write_mat,
    "tdms": write_tdms,
}
