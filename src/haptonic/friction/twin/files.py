"""Force records as files: channels by name in CSV, HDF5, MATLAB or TDMS, each saying that it is simulated."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

import h5py
import numpy as np
import pandas as pd
import scipy.io
from numpy.typing import NDArray

from haptonic import hdf5
from haptonic.errors import FrictionError

Array = NDArray[np.float64]
Channels = Mapping[str, Array]

GROUP = "records"  # of a TDMS file, which cannot do without
DIGITS = 6  # behind the point, in text: 1 uN, 1 um
UNITS = {"time": "s", "position": "m"}
SIMULATED = "simulated"


def unit_of(channel: str) -> str:
    """Unit of a channel by its name."""
    return UNITS.get(channel) or {"F": "N", "T": "N m", "G": "V"}[channel[0]]


def write_csv(channels: Channels, path: Path) -> None:
    """A line for each sample, below the names; a last column says that it is simulated."""
    table = pd.DataFrame({name: np.round(values, DIGITS) for name, values in channels.items()})
    table.assign(origin=SIMULATED).to_csv(path, index=False)


def write_h5(channels: Channels, path: Path) -> None:
    """A set for each channel, with its unit; the file says that it is simulated."""
    with hdf5.written(path) as raw, h5py.File(raw, "w") as file:
        file.attrs["origin"] = SIMULATED
        for name, values in channels.items():
            file.create_dataset(name, data=values).attrs["units"] = unit_of(name)


def write_mat(channels: Channels, path: Path) -> None:
    """A variable for each channel, and a text that says that it is simulated (MATLAB, version 5)."""
    scipy.io.savemat(path, {**channels, "origin": SIMULATED}, oned_as="column", do_compression=True)


def write_tdms(channels: Channels, path: Path) -> None:
    """A waveform for each channel, with its unit; the file says that it is simulated.

    Raises
    ------
    FrictionError : npTDMS is not installed
    """
    try:
        from nptdms import ChannelObject, RootObject, TdmsWriter
    except ImportError as error:
        raise FrictionError(
            argument="--format",
            given="tdms",
            allowed="csv, h5 or mat, and tdms where the package npTDMS is installed",
            cause="npTDMS is an optional part of haptonic and is not installed",
            next_step='pip install "haptonic[tdms]"',
        ) from error
    step = float(channels["time"][1] - channels["time"][0])
    objects = [RootObject({"origin": SIMULATED})]
    for name, values in channels.items():
        properties = {"unit_string": unit_of(name), "wf_increment": step, "wf_start_offset": 0.0}
        objects.append(ChannelObject(GROUP, name, values, properties))
    with TdmsWriter(path) as file:
        file.write_segment(objects)


WRITERS: Mapping[str, Callable[[Channels, Path], None]] = {
    "csv": write_csv,
    "h5": write_h5,
    "mat": write_mat,
    "tdms": write_tdms,
}
