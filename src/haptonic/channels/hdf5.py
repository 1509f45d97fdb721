"""HDF5 files, and NetCDF 4 files, which are HDF5 with conventions, read by h5py in the reader process."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic import hdf5
from haptonic.channels.notes import ELSEWHERE, Notebook
from haptonic.channels.signals import Channel, Group, Samples
from haptonic.foreign.process import ask, damaged, refuse_larger
from haptonic.later import h5py, xarray as xr

PACKING = ("scale_factor", "add_offset", "_FillValue", "missing_value", "dtype", "_Unsigned")


def read(path: Path, notes: Notebook) -> dict[str, Group]:
    """Read the groups, by "group/name" with depth; the unit of a channel is its attribute ``units``.

    Raises
    ------
    ChannelError : the file is damaged
    OSError : no right to read it
    """
    content = ask("hdf5.tree", path)
    for name in content["elsewhere"]:
        notes.drop(set_name(name), ELSEWHERE)
    inside: dict[str, dict[str, Channel]] = {name: {} for name in ("", *content["groups"])}
    for label, form in content["sets"].items():
        group, _, name = label.rpartition("/")
        if form["kind"] != "other":
            inside[group][name] = _channel(path, label, name, form)
    of_file = content["attributes"]
    attributes = {"": of_file} | content["groups"]
    return {name: Group(name, channels, attributes[name], of_file) for name, channels in inside.items()}


def set_name(name: str) -> str:
    """Name of a data set in the list of dropped content."""
    return f'the data set "{name}"'


def _channel(path: Path, label: str, name: str, form: Mapping[str, Any]) -> Channel:
    attributes, shape = form["attributes"], tuple(form["shape"])
    written = {word.lower(): value for word, value in attributes.items()}
    unit = written.get("units", written.get("unit"))
    in_parts = form["kind"] == "number" and shape and not any(word in attributes for word in PACKING)
    rows = partial(_rows, path, label, shape) if in_parts else partial(_whole, path, label, form)
    unit = unit if isinstance(unit, str) else ""
    return Channel(name=name, shape=shape, rows=rows, kind=form["kind"], unit=unit, properties=attributes)


def _rows(path: Path, name: str, shape: tuple[int, ...], first: int, last: int) -> Samples:
    refuse_larger(path, (min(last, shape[0]) - first) * math.prod(shape[1:]))
    return np.asarray(ask("hdf5.rows", path, names=[name], start=first, stop=last)[0])


def _whole(path: Path, name: str, form: Mapping[str, Any], first: int, last: int) -> Samples:
    array = arrays_of(path, {"sets": {name: form}}, [name])[name]
    return array[first:last] if array.ndim else array


def arrays_of(path: Path, content: Mapping[str, Any], names: Sequence[str]) -> dict[str, NDArray[Any]]:
    """Numbers, unpacked, and texts by name, of a file with the given "hdf5.tree" in ``content``.

    Raises
    ------
    ChannelError : the data or their packing attributes are damaged
    ResourceError : more memory than a file of this size may need
    """
    refuse_larger(path, sum(math.prod(content["sets"][name]["shape"]) for name in names))
    read = ask("hdf5.read", path, names=list(names))
    return {
        name: _unpacked(path, name, values, content["sets"][name]["attributes"])
        for name, values in zip(names, read, strict=True)
    }


def refuse_sizes(
    path: Path, sets: Mapping[str, Mapping[str, Any]], dimensions: Mapping[str, Sequence[str]]
) -> None:
    """Refuse sets whose sizes contradict their dimensions, before any of them is read.

    A compressed set of some kB may expand to a gigabyte, which takes seconds.

    Parameters
    ----------
    sets : of the "hdf5.tree"; missing ones are ignored
    dimensions : names of the dimensions of each set; the first set with a dimension defines its size

    Raises
    ------
    ChannelError : a set has another shape
    """
    sizes: dict[str, int] = {}
    for name, axes in dimensions.items():
        if name not in sets:
            continue
        shape = tuple(sets[name]["shape"])
        if len(shape) == len(axes):
            for axis, size in zip(axes, shape, strict=True):
                sizes.setdefault(axis, size)
        if shape != tuple(sizes.get(axis, -1) for axis in axes):
            raise damaged(path, f"{name} is {sets[name]['kind']} of shape {shape}")


def _unpacked(path: Path, name: str, values: Any, attributes: Mapping[str, Any]) -> NDArray[Any]:
    array = np.asarray(values, dtype=None if isinstance(values, np.ndarray) else object)
    packed = {word: attributes[word] for word in PACKING if word in attributes}
    if not packed or array.dtype == object:
        return array
    variable = xr.Variable([f"axis {i}" for i in range(array.ndim)], array, packed)
    try:
        decoded = xr.conventions.decode_cf_variable(
            name, variable, concat_characters=False, stack_char_dim=False, decode_times=False
        )
        return np.asarray(decoded.values)
    except (TypeError, ValueError, LookupError, AttributeError, ArithmeticError) as error:
        raise damaged(path, f"{name}: invalid {', '.join(packed)}") from error


def write(path: Path, channels: Sequence[Channel], properties: Mapping[str, Any]) -> None:
    """Write a data set for each channel, with its unit."""
    with hdf5.written(path) as raw, h5py.File(raw, "w") as file:
        file.attrs.update(properties)
        for channel in channels:
            file.create_dataset(channel.name, data=channel.__array__()).attrs["units"] = channel.unit
