"""MATLAB files as plain values: version 5 by scipy, version 7.3 (HDF5 with reversed axes) by h5py.

Fields of a structure have names such as ``scan.frf``. A field of an array of structures, and a cell array,
become one array whose first axis numbers the structures or cells, if all of them have equal shapes.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from haptonic.foreign import hdf5

DEEPEST = 20  # levels of nested structures; a damaged file may contain itself


def variables(path: str, large: int) -> dict[str, Any]:
    """All variables of a file.

    Parameters
    ----------
    large : variables of version 7.3 with at least this many numbers stay in the file

    Returns
    -------
    ``arrays``: name -> array; ``stored``: name -> [name in the file, shape]; ``texts``: name -> text or list
    of texts; ``others``: name -> description of a variable that is neither; ``elsewhere``: names of contents
    in other files
    """
    content: dict[str, Any] = {"arrays": {}, "stored": {}, "texts": {}, "others": {}, "elsewhere": []}
    if h5py.is_hdf5(path):
        tree = hdf5.tree(path)
        content["elsewhere"] = tree["elsewhere"]
        with h5py.File(path, "r") as file:
            for name, form in tree["sets"].items():
                if not name.startswith("#"):
                    _add(content, file, name, form, large)
        return content
    import scipy.io  # imported here, because it takes 0.2 s and version 7.3 does not need it

    for name, value in scipy.io.loadmat(path, struct_as_record=False, squeeze_me=False).items():
        if not name.startswith("__"):
            _add_value(content, name, value, DEEPEST)
    return content


def _add_value(content: dict[str, Any], name: str, value: Any, depth: int) -> None:
    """Add a variable of version 5, or the fields of a structure."""
    if isinstance(value, np.ndarray) and value.dtype == object and value.size == 1:
        value = value.item()
    fields = getattr(value, "_fieldnames", None)
    if fields is not None and depth:
        for field in fields:
            _add_value(content, f"{name}.{field}", getattr(value, field), depth - 1)
    elif isinstance(value, np.ndarray) and value.dtype == object and value.size:
        parts = value.ravel(order="F").tolist()
        if depth and all(hasattr(part, "_fieldnames") for part in parts):
            for field in parts[0]._fieldnames:
                _add_parts(content, f"{name}.{field}", [getattr(part, field, None) for part in parts],
                           "an array of structures")  # fmt: skip
        else:
            _add_parts(content, name, parts, "a cell array")
    else:
        _add_part(content, name, value)


def _add_part(content: dict[str, Any], name: str, value: Any) -> None:
    if isinstance(value, str):
        content["texts"][name] = value
    elif isinstance(value, np.ndarray) and value.dtype.kind in "fciu":
        content["arrays"][name] = value
    elif isinstance(value, np.ndarray) and value.dtype.kind == "b":
        content["arrays"][name] = value.astype(np.uint8)
    elif _is_text(value):
        content["texts"][name] = [str(item) for item in value.ravel()] if value.size > 1 else _plain(value)
    else:
        content["others"][name] = "neither numbers nor text"


def _add_parts(content: dict[str, Any], name: str, parts: Sequence[Any], what: str) -> None:
    """Add the values of an array of structures or of a cell array as one array."""
    inner = [
        part.item() if isinstance(part, np.ndarray) and part.dtype == object and part.size == 1 else part
        for part in parts
    ]
    kinds = "fciub"
    arrays = [np.squeeze(part) for part in inner if isinstance(part, np.ndarray) and part.dtype.kind in kinds]
    texts = [_plain(part) for part in inner if _is_text(part)]
    if len(arrays) == len(parts) and len({array.shape for array in arrays}) == 1:
        _add_part(content, name, np.stack(arrays))
    elif len(texts) == len(parts):
        content["texts"][name] = texts
    elif len(arrays) == len(parts):
        content["others"][name] = f"{what} of {len(parts)}, whose parts have unequal shapes"
    else:
        content["others"][name] = f"{what} of {len(parts)}, whose parts are not all numbers"


def _is_text(value: Any) -> bool:
    return isinstance(value, np.ndarray) and value.dtype.kind == "U"


def _plain(text: NDArray[Any]) -> str:
    return str(np.squeeze(text))


def _add(content: dict[str, Any], file: h5py.File, name: str, form: dict[str, Any], large: int) -> None:
    """Add a data set of version 7.3."""
    item, label, marks = file[name], name.replace("/", "."), form["attributes"]
    kind = "-" if form["kind"] == "other" else item.dtype.kind
    if marks.get("MATLAB_empty", 0) not in (0, None):
        content["others"][label] = "empty"
    elif form["kind"] == "complex":
        content["arrays"][label] = hdf5.values(item).T
    elif kind == "u" and (marks.get("MATLAB_class") == "char" or label == "origin"):
        content["texts"][label] = _text(item)
    elif kind in "fiu" and item.size >= large:
        content["stored"][label] = [name, form["shape"][::-1]]
    elif kind in "fiub":
        _add_part(content, label, np.asarray(item[()]).T)  # MATLAB's order of axes
    elif form["shape"] and _contains_references(item):
        _add_parts(
            content, label, [_referred(file, part) for part in item[()].T.ravel(order="F")], "a cell array"
        )
    else:
        content["others"][label] = "neither numbers nor text"


def _contains_references(item: h5py.Dataset) -> bool:
    try:
        return h5py.check_ref_dtype(item.dtype) is h5py.Reference
    except TypeError:
        return False


def _referred(file: h5py.File, reference: Any) -> NDArray[Any] | None:
    """Values of a data set in the file itself to which a cell or a field refers."""
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
    """Text that is stored as one number per letter."""
    return "".join(chr(int(code)) for code in np.asarray(item[()]).ravel() if 0 < code < 0x110000)
