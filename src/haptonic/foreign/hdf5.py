"""HDF5 files as plain values, without links to other files, virtual data sets and external storage.

These would give a file from somebody else access to other files of the user.
"""

from __future__ import annotations

from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray


def tree(path: str, deep: bool = True) -> dict[str, Any]:
    """Contents of a file without its data.

    Returns
    -------
    ``attributes`` of the file; ``groups``: name -> attributes; ``sets``: name -> ``shape``, ``kind``
    ("number", "complex", "text", "other"), ``attributes``; ``elsewhere``: names of contents in other files.
    Names include their groups, "group/name". Without ``deep`` only the first level is read.
    """
    content: dict[str, Any] = {"groups": {}, "sets": {}, "elsewhere": []}
    with h5py.File(path, "r") as file:
        content["attributes"] = attributes(file)
        _add(content, file, "", {_address(file)}, deep)
    return content


def _add(content: dict[str, Any], group: h5py.Group, start: str, above: set[Any], deep: bool) -> None:
    for name in group:
        label = start + name
        if not isinstance(group.get(name, getlink=True), h5py.HardLink):
            content["elsewhere"].append(label)
            continue
        item = group[name]
        if isinstance(item, h5py.Dataset):
            if elsewhere(item):
                content["elsewhere"].append(label)
            else:
                shape = list(item.shape or ())
                form = {"shape": shape, "kind": kind_of(item), "attributes": attributes(item)}
                content["sets"][label] = form
        elif isinstance(item, h5py.Group):
            content["groups"][label] = attributes(item)
            # a group may contain itself
            if deep and (address := _address(item)) not in above:
                _add(content, item, f"{label}/", above | {address}, deep)


def _address(item: h5py.Group) -> Any:
    return h5py.h5o.get_info(item.id).addr


def elsewhere(item: h5py.Dataset) -> bool:
    """True if the numbers of a data set are in other files."""
    return bool(item.is_virtual or item.external)


def kind_of(item: h5py.Dataset) -> str:
    try:
        kind = item.dtype
    except TypeError:  # a type that numpy does not have, such as HDF5's times
        return "other"
    if item.shape is None:
        return "other"
    if kind.kind in "fiub":
        return "number"
    if kind.kind == "c" or kind.names == ("real", "imag"):
        return "complex"
    return "text" if h5py.check_string_dtype(kind) else "other"


def read(path: str, names: list[str]) -> list[Any]:
    """Whole data sets, arrays of numbers or lists of texts."""
    with h5py.File(path, "r") as file:
        return [values(_set(file, name)) for name in names]


def rows(path: str, names: list[str], start: int, stop: int, last: bool = False) -> list[NDArray[Any]]:
    """Parts of data sets along their first or last axis. A set of one row is read whole."""
    parts = []
    with h5py.File(path, "r") as file:
        for name in names:
            item = _set(file, name)
            span = slice(None) if item.shape[-1 if last else 0] == 1 else slice(start, stop)
            parts.append(np.asarray(item[..., span] if last else item[span]))
    return parts


def values(item: h5py.Dataset) -> Any:
    kind = kind_of(item)
    if kind == "text":
        return np.asarray(item.asstr("utf-8", "replace")[()], dtype=object).tolist()
    if kind == "number":
        return np.asarray(item[()])
    if kind == "other":
        raise TypeError(kind)
    pair = item[()]
    return np.asarray(pair if item.dtype.kind == "c" else pair["real"] + 1j * pair["imag"])


def _set(file: h5py.File, name: str) -> h5py.Dataset:
    place: Any = file
    for part in name.split("/"):
        if not isinstance(place.get(part, getlink=True), h5py.HardLink):
            raise LookupError(name)
        place = place[part]
    if not isinstance(place, h5py.Dataset) or elsewhere(place):
        raise LookupError(name)
    return place


def attributes(item: Any) -> dict[str, Any]:
    """Attributes as numbers, texts, lists of texts or arrays; None for other types."""
    plain = {}
    for name in item.attrs:
        try:
            plain[name] = _plain(item.attrs[name])
        except TypeError:  # a type that numpy does not have
            plain[name] = None
    return plain


def _plain(value: Any) -> Any:
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace")
    if isinstance(value, str):
        return value
    if isinstance(value, h5py.Empty):
        return ""
    array = np.asarray(value)
    if array.dtype.kind in "fiub":
        number = array.ravel()[0] if array.size == 1 else None
        if number is None:
            return array
        return float(number) if array.dtype.kind == "f" else int(number)
    if array.dtype.kind in "OSU" and all(isinstance(item, str | bytes) for item in array.ravel().tolist()):
        texts = [_plain(item) for item in array.ravel().tolist()]
        return texts[0] if len(texts) == 1 else texts
    return None
