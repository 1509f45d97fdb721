"""MATLAB files: version 5, and version 7.3, which is HDF5.

Variables of version 5 are compressed as a whole and read at once; large ones of version 7.3 stay in the file.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import scipy

from haptonic import hdf5
from haptonic.channels.notes import ELSEWHERE, Notebook
from haptonic.channels.signals import ORIGIN, Channel, Group, Samples
from haptonic.foreign.process import ask
from haptonic.later import h5py

LARGE = 16_000_000  # numbers; a larger variable of version 7.3 stays in the file until it is used
HEADER = b"MATLAB 7.3 MAT-file, written by haptonic"
USER_BLOCK = 512  # bytes before the HDF5 part of a MATLAB file


def read(path: Path, notes: Notebook, large: int = LARGE) -> dict[str, Group]:
    """Read variables of numbers and texts. A structure is a group; the group "" contains all variables, and
    fields of structures as ``structure.field``.

    Single numbers and single texts are properties as well.

    Raises
    ------
    ChannelError : the file is of neither version, or damaged
    OSError : no right to read it
    """
    content = ask("matlab.variables", path, large=large)
    notes.unread.update(content["others"])
    for name, kind in content["others"].items():
        notes.remark(f'the variable "{name}" was not read: it is {kind}')
    for name in content["elsewhere"]:
        notes.drop(f'the variable "{name}"', ELSEWHERE)
    every = {name: Channel.of(name, array) for name, array in content["arrays"].items()}
    for name, (inside, shape) in content["stored"].items():
        every[name] = Channel(name, tuple(shape), partial(_rows, path, inside))
    for name, text in content["texts"].items():
        every[name] = Channel.of(name, np.array(text, dtype=object))
    whole = _group("", every, {})
    starts = {name[: i + 1] for name in every for i, letter in enumerate(name) if letter == "."}
    groups = (_group(start, every, whole.properties) for start in sorted(starts))
    return {"": whole} | {group.name: group for group in groups}


def _group(start: str, every: Mapping[str, Channel], of_file: Mapping[str, Any]) -> Group:
    inside = {name.removeprefix(start): channel for name, channel in every.items() if name.startswith(start)}
    single = {
        name: channel.__array__().item()
        for name, channel in inside.items()
        if channel.size == 1 and "." not in name
    }
    return Group(start.removesuffix("."), inside, single, of_file)


def _rows(path: Path, name: str, first: int, last: int) -> Samples:
    """Rows of the first axis in MATLAB's order, which is the last axis in the file."""
    (part,) = ask("hdf5.rows", path, names=[name], start=first, stop=last, last=True)
    return np.asarray(part).T


def write(path: Path, variables: Mapping[str, Any], origin: str) -> None:
    """Write arrays and texts as variables of version 5, arrays of one axis as columns."""
    content = {**variables, ORIGIN: origin}
    scipy.io.savemat(path, content, appendmat=False, oned_as="column", do_compression=True)


def write_rows(
    path: Path,
    small: Mapping[str, Samples],
    shapes: Mapping[str, tuple[int, ...]],
    portions: Iterable[tuple[int, Mapping[str, Samples]]],
    origin: str,
) -> None:
    """Write variables of version 7.3 in single precision, large ones a few rows at a time.

    Parameters
    ----------
    small : (n,) arrays that are written at once, as columns
    shapes : shapes of the large ones
    portions : number of the first row, and the next rows of some of them
    """
    with hdf5.written(path) as raw, h5py.File(raw, "w", userblock_size=USER_BLOCK) as file:
        for name, values in small.items():
            file[name] = values[:, None]
            file[name].attrs["MATLAB_class"] = np.bytes_("double")
        text = np.frombuffer(origin.encode("utf-16-le"), np.uint16)
        file[ORIGIN] = text[:, None]
        file[ORIGIN].attrs["MATLAB_class"] = np.bytes_("char")
        file[ORIGIN].attrs["MATLAB_int_decode"] = np.int32(2)
        for name, shape in shapes.items():
            turned = shape[::-1]  # MATLAB's axes are in reverse order in HDF5
            file.create_dataset(name, turned, np.float32, chunks=(*turned[:-1], 1))
            file[name].attrs["MATLAB_class"] = np.bytes_("single")
        for first, parts in portions:
            for name, rows in parts.items():
                file[name][..., first : first + len(rows)] = rows.T
    with path.open("rb+") as again:
        again.write(HEADER.ljust(124) + b"\x00\x02IM")
