"""TDMS files as plain values."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from nptdms import TdmsFile

_open: dict[tuple[object, ...], TdmsFile] = {}  # the last file: its description is long and often needed


def tree(path: str) -> dict[str, Any]:
    """``properties`` of the file; ``groups``: name, properties and channels of each; a channel has a name,
    properties, its ``length``, and ``numbers``, True if it contains numbers."""
    file = _opened(path)
    groups = [
        {
            "name": str(group.name),
            "properties": _plain(group.properties),
            "channels": [
                {
                    "name": str(channel.name),
                    "properties": _plain(channel.properties),
                    "length": len(channel),
                    "numbers": channel.dtype.kind in "fiub",
                }
                for channel in group.channels()
            ],
        }
        for group in file.groups()
    ]
    return {"properties": _plain(file.properties), "groups": groups}


def channels(path: str, names: list[list[str]]) -> list[NDArray[Any]]:
    """Numbers of channels, given by group and name."""
    file = _opened(path)
    return [np.asarray(file[group][channel][:]) for group, channel in names]


def close(path: str) -> None:
    """Close a file that was read."""
    for key in [key for key in _open if key[0] == path]:
        _open.pop(key).close()


def _opened(path: str) -> TdmsFile:
    from nptdms import TdmsFile

    state = os.stat(path)
    key = path, state.st_ino, state.st_size, state.st_mtime_ns
    if key not in _open:
        while _open:
            _open.popitem()[1].close()
        _open[key] = TdmsFile.open(path)
    return _open[key]


def _plain(properties: Any) -> dict[str, Any]:
    """Keep numbers; convert other properties to text."""
    return {
        str(name): float(value) if isinstance(value, int | float | np.number) else str(value)
        for name, value in properties.items()
    }
