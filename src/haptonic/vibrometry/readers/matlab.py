"""MATLAB files: version 5 by scipy, version 7.3 (which is HDF5, with transposed arrays) by h5py."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import scipy.io
from scipy.io.matlab import MatReadError

from haptonic.errors import ScanError
from haptonic.vibrometry.findings import Notebook
from haptonic.vibrometry.readers.stored import Stored
from haptonic.vibrometry.readers.tables import ORIGIN

DAMAGED = (
    MatReadError, ValueError, TypeError, LookupError, AttributeError, EOFError, RuntimeError, OSError,
    struct.error, zlib.error,
)  # fmt: skip
"""What scipy and h5py raise at a file of another kind or a damaged one."""
LARGE = 16_000_000  # numbers, from which a variable of version 7.3 stays in the file until it is asked for


def matlab_arrays(path: Path, notes: Notebook) -> dict[str, Any]:
    """Numeric variables of a file by name, large ones as `Stored`; fields of a structure as
    ``structure.field``. A text ``origin`` that says "simulated" is found as well.

    Raises
    ------
    ScanError : the file is neither of both versions, or damaged
    PermissionError, MemoryError : it may not be read, or does not fit into memory
    """
    try:
        if h5py.is_hdf5(path):
            with h5py.File(path, "r") as file:
                found: dict[str, Any] = {}
                file.visititems(lambda name, item: _add(found, path, name, item, notes))
                return found
        content = scipy.io.loadmat(path, struct_as_record=False, squeeze_me=False)
    except PermissionError:
        raise
    except DAMAGED as error:
        raise ScanError(
            argument="MATLAB file",
            given=f"{path} ({type(error).__name__})",
            allowed="a whole .mat file of version 5 (save -v7) or 7.3 (save -v7.3)",
            cause="the file is text or of version 4, or a copy was interrupted",
            next_step="save it again in MATLAB: save scan.mat -v7",
        ) from error
    arrays: dict[str, Any] = {}
    for name, value in content.items():
        if not name.startswith("__"):
            _flattened(arrays, name, value, notes)
    return arrays


def _flattened(arrays: dict[str, Any], name: str, value: Any, notes: Notebook) -> None:
    if isinstance(value, np.ndarray) and value.dtype == object and value.size == 1:
        value = value.item()
    fields = getattr(value, "_fieldnames", None)
    if fields is not None:
        for field in fields:
            _flattened(arrays, f"{name}.{field}", getattr(value, field), notes)
    elif isinstance(value, np.ndarray) and value.dtype.kind in "fciu":
        arrays[name] = value
    elif name == ORIGIN:
        arrays[name] = str(np.squeeze(value))
    else:
        notes.remark(f'the variable "{name}" holds no numbers')


def _add(found: dict[str, Any], path: Path, name: str, item: Any, notes: Notebook) -> None:
    if not isinstance(item, h5py.Dataset) or name.startswith("#"):
        return
    label = name.replace("/", ".")
    if item.dtype.names == ("real", "imag"):
        pair = item[()]
        found[label] = (pair["real"] + 1j * pair["imag"]).T
    elif name == ORIGIN and item.dtype.kind == "u":  # text, a number for each letter
        found[label] = bytes(np.asarray(item[()], dtype=np.uint8).ravel()).decode("ascii", "replace")
    elif item.dtype.kind in "fiu" and item.size >= LARGE:
        found[label] = Stored(path, name, item.shape[::-1])
    elif item.dtype.kind in "fiu" and item.attrs.get("MATLAB_empty", 0) == 0:
        found[label] = np.asarray(item[()]).T  # MATLAB's order of axes
    else:
        notes.remark(f'the variable "{label}" holds no numbers')
