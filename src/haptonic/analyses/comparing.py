"""Reads what is compared: bands of ours, of a result, and those that another program exported."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch import gaps_of
from haptonic.channels.hdf5 import arrays_of
from haptonic.channels.numbers import Numbers, read_numbers
from haptonic.errors import ChannelError, StudyError, shown
from haptonic.foreign.process import ask
from haptonic.gate import json_from
from haptonic.later import xarray as xr
from haptonic.paths import unread
from haptonic.results.comparison import BandSet
from haptonic.units import to_si

WAVEVECTORS = ("rad/m", "rad/mm", "1/m", "share", "segments")
SAME_PATH = 0.02  # share by which two lengths of one path may differ
PARTS = {
    "distance": ("wavevector",),
    "frequency": ("wavevector", "band"),
    **dict.fromkeys(("gap_below", "gap_lower", "gap_upper", "gap_lower_error", "gap_upper_error"), ("gap",)),
    **dict.fromkeys(("gap_lower_kappa", "gap_upper_kappa"), ("gap", "axis")),
    **dict.fromkeys(("gap_complete", "gap_direction", "gap_samples", "gap_waves"), ("gap",)),
}  # of bands.nc
LENGTHS = {"rad/m": 1.0, "1/m": 1.0, "rad/mm": 1e3}


def of_dataset(name: str, data: xr.Dataset) -> BandSet:
    """Bands that haptonic computed."""
    labels, corners = path_in(data)
    return BandSet(
        name=name,
        position=np.interp(data["distance"].values, corners, np.arange(len(corners))),
        frequency=np.sort(data["frequency"].values, axis=1),
        labels=labels,
        gaps=tuple(gap for gap in gaps_of(data) if gap.complete),
        inputs=json_from(data.attrs["inputs"]),
    )


def of_file(path: Path) -> xr.Dataset:
    """Bands of a file that `haptonic bands` wrote, as far as they are compared.

    Raises
    ------
    StudyError : another file, or a damaged one
    """
    try:
        content = ask("hdf5.tree", path, deep=False)
        parts = arrays_of(path, content, [*PARTS])
        data = xr.Dataset(
            {name: (dims, parts[name]) for name, dims in PARTS.items()}, attrs=content["attributes"]
        )
        of_dataset("", data)
    except (ChannelError, OSError, MemoryError, KeyError, ValueError, TypeError, IndexError) as error:
        raise unread(
            StudyError,
            error,
            argument="bands of an earlier run",
            given=shown(str(path), 200),
            allowed="bands.nc of `haptonic bands`, or its folder",
            cause="another file, or damaged",
            next_step="give the study, or run `haptonic bands` again",
        ) from error
    return data


def path_in(data: xr.Dataset) -> tuple[tuple[str, ...], Array]:
    """Names of the corners of a result's path, and how far along it they lie, rad/m."""
    corners = data["distance"].values[json_from(data.attrs["path_corners"])]
    return tuple(json_from(data.attrs["path_labels"])), corners


def of_table(
    path: Path, labels: tuple[str, ...], corners: Array, wavevector: str | None, frequency_unit: str | None
) -> BandSet:
    """Bands of a text file, on the path of ours.

    Parameters
    ----------
    labels, corners : of our path, as `path_in` gives them
    wavevector, frequency_unit : what the file does not say

    Raises
    ------
    ChannelError : no table, units that nobody says, an axis that is none, or another path
    """
    numbers = read_numbers(path)
    said = numbers.units[0].replace(" ", "")
    unit = wavevector or (said if said in WAVEVECTORS else "")
    axis, first = _axis(path, numbers)
    if unit not in WAVEVECTORS:
        raise ChannelError.missing(
            argument="--wavevector",
            given=shown(unit or numbers.units[0]) if unit or numbers.units[0] else "nothing",
            allowed=f"one of {', '.join(WAVEVECTORS)}",
            cause=f"the first column of {path.name} goes from {axis[0]:g} to {axis[-1]:g}, and nobody says "
            "of what",
            next_step=f"say it: --wavevector={_likely(axis, corners)}; share is of the whole path, segments "
            "count its corners from 0",
        )
    position = _position(path, axis, unit, corners)
    in_hertz = _in_hertz(path, numbers, first, frequency_unit)
    values = numbers.values[:, list(in_hertz)] * list(in_hertz.values())
    rows = [np.sort(values[axis == one].ravel()) for one in np.unique(axis)]
    frequency = np.full((len(rows), max(map(len, rows))), np.nan)
    for row, found in zip(frequency, rows, strict=True):
        row[: len(found)] = found
    return BandSet(
        name=path.stem,
        position=np.unique(position),
        frequency=frequency,
        labels=labels,
        gaps=(),
        inputs={},
        ours=False,
        left=tuple(name for k, name in enumerate(numbers.names[first:], first) if k not in in_hertz),
    )


def _axis(path: Path, numbers: Numbers) -> tuple[Array, int]:
    """The wavevector of every row, and the first column behind it; of k_x and k_y, the way along them."""
    two = len(numbers.names) > 2 and numbers.names[1].lower().replace("_", "") == "ky"
    axis = numbers.values[:, 0]
    if two:
        steps = np.hypot(*np.diff(numbers.values[:, :2], axis=0).T)
        axis = np.concatenate([[0.0], np.cumsum(steps)])
    bad = np.flatnonzero(np.diff(axis) < 0)
    if len(bad) or not np.isfinite(axis).all() or axis[0] == axis[-1]:
        row = int(bad[0]) if len(bad) else 0
        raise ChannelError.malformed(
            argument=f"{path.name}, first column",
            given=f"{axis[row]:g}, then {axis[row + 1]:g}" if len(axis) > 1 else f"{axis[0]:g} alone",
            allowed="wavevectors along the path that never fall, or come back after some frequencies",
            cause="it is not the wavevector, or the rows are sorted by something else",
            next_step="export the wavevector first, and sort the rows by it",
        )
    return axis, 2 if two else 1


def _likely(axis: Array, corners: Array) -> str:
    """What a column without a unit may be, by its end; to be said, not to be taken."""
    ends = {"segments": len(corners) - 1.0, "share": 1.0, "rad/m": corners[-1], "rad/mm": corners[-1] / 1e3}
    return min(ends, key=lambda name: abs(np.log(max(axis[-1], 1e-12) / ends[name])))


def _position(path: Path, axis: Array, unit: str, corners: Array) -> Array:
    last = len(corners) - 1
    ends = {"segments": float(last), "share": 1.0}
    end = ends.get(unit, float(corners[-1]) / LENGTHS.get(unit, 1.0))
    if axis[0] < -SAME_PATH * end or axis[-1] > (1 + SAME_PATH) * end:
        raise ChannelError.mismatch(
            argument=f"{path.name}, first column",
            given=f"{axis[0]:g} to {axis[-1]:g} as {unit}",
            allowed=f"0 to {end:.4g}, along the path of the study",
            cause="another unit, another pitch, or a path with other corners",
            next_step="check --wavevector; the path of the study is in its diagram",
        )
    if unit == "segments":
        return np.asarray(np.clip(axis, 0, last))
    return np.asarray(np.interp(axis / end * corners[-1], corners, np.arange(last + 1.0)))


def _in_hertz(path: Path, numbers: Numbers, first: int, given: str | None) -> dict[int, float]:
    """One of each column of frequencies in Hz, by its number.

    Where units tell frequencies from others, such as the damping ratios and angular frequencies beside them,
    only these are taken.
    """
    units = dict(enumerate(numbers.units[first:], first))
    named = {unit for unit in units.values() if unit.lower().endswith("hz")}
    taken = {k: unit for k, unit in units.items() if unit in named or not unit} if named else units
    usual = given or (named.pop() if len(named) == 1 else "")
    if not usual and not all(unit in named for unit in taken.values()):
        raise ChannelError.missing(
            argument="--frequency-unit",
            given=", ".join(sorted(filter(None, set(taken.values())))) or "nothing",
            allowed="Hz, kHz, MHz, ...",
            cause=f"columns of {path.name} have no unit, or none of a frequency",
            next_step="say it: --frequency-unit=kHz",
        )
    return {k: to_si(f"1 {given or unit or usual}", "Hz", "--frequency-unit") for k, unit in taken.items()}
