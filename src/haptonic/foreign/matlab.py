"""MATLAB files as plain values: version 5 by scipy, version 7.3 (which is HDF5, axes reversed) by h5py."""

from __future__ import annotations

from typing import Any

import h5py
import numpy as np

from haptonic.foreign import hdf5

ORIGIN = "origin"  # the one text that is wanted


def variables(path: str, large: int) -> dict[str, Any]:
    """All variables of a file, fields of a structure as ``structure.field``.

    Parameters
    ----------
    large : numbers from which a variable of version 7.3 stays in the file

    Returns
    -------
    ``arrays``: name -> array; ``stored``: name -> [name in the file, shape]; ``origin``: text or None;
    ``others``: names of what holds no numbers; ``elsewhere``: names of what lies in other files
    """
    found: dict[str, Any] = {"arrays": {}, "stored": {}, ORIGIN: None, "others": [], "elsewhere": []}
    if h5py.is_hdf5(path):
        content = hdf5.tree(path)
        found["elsewhere"] = content["elsewhere"]
        with h5py.File(path, "r") as file:
            for name, form in content["sets"].items():
                if not name.startswith("#"):
                    _add(found, file[name], name, form, large)
        return found
    import scipy.io  # here, because a file of version 7.3 does without and it takes a fifth of a second

    for name, value in scipy.io.loadmat(path, struct_as_record=False, squeeze_me=False).items():
        if not name.startswith("__"):
            _flattened(found, name, value)
    return found


def _flattened(found: dict[str, Any], name: str, value: Any) -> None:
    if isinstance(value, np.ndarray) and value.dtype == object and value.size == 1:
        value = value.item()
    fields = getattr(value, "_fieldnames", None)
    if fields is not None:
        for field in fields:
            _flattened(found, f"{name}.{field}", getattr(value, field))
    elif isinstance(value, np.ndarray) and value.dtype.kind in "fciu":
        found["arrays"][name] = value
    elif name == ORIGIN:
        found[ORIGIN] = str(np.squeeze(value))
    else:
        found["others"].append(name)


def _add(found: dict[str, Any], item: h5py.Dataset, name: str, form: dict[str, Any], large: int) -> None:
    label = name.replace("/", ".")
    kind = "-" if form["kind"] == "other" else item.dtype.kind
    if form["kind"] == "complex":
        found["arrays"][label] = hdf5.values(item).T
    elif name == ORIGIN and kind == "u":  # text, a number for each letter
        found[ORIGIN] = bytes(np.asarray(item[()], dtype=np.uint8).ravel()).decode("ascii", "replace")
    elif kind in "fiu" and item.size >= large:
        found["stored"][label] = [name, form["shape"][::-1]]
    elif kind in "fiu" and form["attributes"].get("MATLAB_empty", 0) == 0:
        found["arrays"][label] = np.asarray(item[()]).T  # MATLAB's order of axes
    else:
        found["others"].append(label)
