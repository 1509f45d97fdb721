"""MATLAB files as plain values: version 5 by scipy, version 7.3 (which is HDF5, axes reversed) by h5py.

Fields of a structure have names such as ``scan.frf``. A field of an array of structures, and a cell array,
becomes one array whose first axis counts the structures or cells, if all of them have equal shapes.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from haptonic.foreign import hdf5

DEEPEST = 20  # structures within structures; a damaged file may hold itself


def variables(path: str, large: int) -> dict[str, Any]:
    """All variables of a file.

    Parameters
    ----------
    large : numbers from which a variable of version 7.3 stays in the file

    Returns
    -------
    ``arrays``: name -> array; ``stored``: name -> [name in the file, shape]; ``texts``: name -> text or list
    of texts; ``others``: name -> what it is, of a variable that holds neither; ``elsewhere``: names of what
    lies in other files
    """
    found: dict[str, Any] = {"arrays": {}, "stored": {}, "texts": {}, "others": {}, "elsewhere": []}
    if h5py.is_hdf5(path):
        content = hdf5.tree(path)
        found["elsewhere"] = content["elsewhere"]
        with h5py.File(path, "r") as file:
            for name, form in content["sets"].items():
                if not name.startswith("#"):
                    _add(found, file, name, form, large)
        return found
    import scipy.io  # here, because a file of version 7.3 does without and it takes a fifth of a second

    for name, value in scipy.io.loadmat(path, struct_as_record=False, squeeze_me=False).items():
        if not name.startswith("__"):
            _add_value(found, name, value, DEEPEST)
    return found


def _add_value(found: dict[str, Any], name: str, value: Any, depth: int) -> None:
    """Add a variable of version 5, or the fields of a structure."""
    if isinstance(value, np.ndarray) and value.dtype == object and value.size == 1:
        value = value.item()
    fields = getattr(value, "_fieldnames", None)
    if fields is not None and depth:
        for field in fields:
            _add_value(found, f"{name}.{field}", getattr(value, field), depth - 1)
    elif isinstance(value, np.ndarray) and value.dtype == object and value.size:
        parts = value.ravel(order="F").tolist()
        if depth and all(hasattr(part, "_fieldnames") for part in parts):
            for field in parts[0]._fieldnames:
                _add_parts(found, f"{name}.{field}", [getattr(part, field, None) for part in parts],
                           "an array of structures")  # fmt: skip
        else:
            _add_parts(found, name, parts, "a cell array")
    else:
        _add_part(found, name, value)


def _add_part(found: dict[str, Any], name: str, value: Any) -> None:
    if isinstance(value, str):
        found["texts"][name] = value
    elif isinstance(value, np.ndarray) and value.dtype.kind in "fciu":
        found["arrays"][name] = value
    elif isinstance(value, np.ndarray) and value.dtype.kind == "b":
        found["arrays"][name] = value.astype(np.uint8)
    elif _is_text(value):
        found["texts"][name] = [str(one) for one in value.ravel()] if value.size > 1 else _plain(value)
    else:
        found["others"][name] = "neither numbers nor text"


def _add_parts(found: dict[str, Any], name: str, parts: Sequence[Any], what: str) -> None:
    """Add the values of an array of structures or of a cell array as one array."""
    inner = [
        part.item() if isinstance(part, np.ndarray) and part.dtype == object and part.size == 1 else part
        for part in parts
    ]
    kinds = "fciub"
    arrays = [np.squeeze(part) for part in inner if isinstance(part, np.ndarray) and part.dtype.kind in kinds]
    texts = [_plain(part) for part in inner if _is_text(part)]
    if len(arrays) == len(parts) and len({array.shape for array in arrays}) == 1:
        _add_part(found, name, np.stack(arrays))
    elif len(texts) == len(parts):
        found["texts"][name] = texts
    elif len(arrays) == len(parts):
        found["others"][name] = f"{what} of {len(parts)}, whose parts have unequal shapes"
    else:
        found["others"][name] = f"{what} of {len(parts)}, whose parts are not all numbers"


def _is_text(value: Any) -> bool:
    return isinstance(value, np.ndarray) and value.dtype.kind == "U"


def _plain(text: NDArray[Any]) -> str:
    return str(np.squeeze(text))


def _add(found: dict[str, Any], file: h5py.File, name: str, form: dict[str, Any], large: int) -> None:
    """Add a data set of version 7.3."""
    item, label, says = file[name], name.replace("/", "."), form["attributes"]
    kind = "-" if form["kind"] == "other" else item.dtype.kind
    if says.get("MATLAB_empty", 0) not in (0, None):
        found["others"][label] = "empty"
    elif form["kind"] == "complex":
        found["arrays"][label] = hdf5.values(item).T
    elif kind == "u" and (says.get("MATLAB_class") == "char" or label == "origin"):
        found["texts"][label] = _text(item)
    elif kind in "fiu" and item.size >= large:
        found["stored"][label] = [name, form["shape"][::-1]]
    elif kind in "fiub":
        _add_part(found, label, np.asarray(item[()]).T)  # MATLAB's order of axes
    elif form["shape"] and _holds_references(item):
        _add_parts(
            found, label, [_referred(file, one) for one in item[()].T.ravel(order="F")], "a cell array"
        )
    else:
        found["others"][label] = "neither numbers nor text"


def _holds_references(item: h5py.Dataset) -> bool:
    try:
        return h5py.check_ref_dtype(item.dtype) is h5py.Reference
    except TypeError:
        return False


def _referred(file: h5py.File, reference: Any) -> NDArray[Any] | None:
    """The values of a data set in the file itself that a cell or a field refers to."""
    item = file[reference] if reference else None
    if not isinstance(item, h5py.Dataset) or hdf5.elsewhere(item):
        return None
    kind = hdf5.kind_of(item)
    if kind not in ("number", "complex"):
        return None
    if hdf5.attributes(item).get("MATLAB_class") == "char":
        return np.array(_text(item))
    return np.asarray(hdf5.values(item)).T


def _text(item: h5py.Dataset) -> str:
    """Text that is stored as a number for each letter."""
    return "".join(chr(int(one)) for one in np.asarray(item[()]).ravel() if 0 < one < 0x110000)
