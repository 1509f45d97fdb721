"""MATLAB files: version 5 by scipy, version 7.3 (which is HDF5, with transposed arrays) by h5py."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import h5py
import numpy as np
import scipy.io
from numpy.typing import NDArray

from haptonic.errors import ScanError
from haptonic.vibrometry.findings import Notebook


def matlab_arrays(path: Path, notes: Notebook) -> dict[str, NDArray[Any]]:
    """Numeric variables of a file by name; fields of a structure as ``structure.field``.

    Raises
    ------
    ScanError : the file is neither of both versions, or damaged
    """
    try:
        if h5py.is_hdf5(path):
            with h5py.File(path, "r") as file:
                found: dict[str, NDArray[Any]] = {}
                file.visititems(lambda name, item: _add(found, name, item, notes))
                return found
        content = scipy.io.loadmat(path, struct_as_record=False, squeeze_me=False)
    except Exception as error:
        raise ScanError(
            argument="MATLAB file",
            given=f"{path} ({type(error).__name__})",
            allowed="a whole .mat file of version 5 (save -v7) or 7.3 (save -v7.3)",
            cause="the file is text or of version 4, or a copy was interrupted",
            next_step="save it again in MATLAB: save scan.mat -v7",
        ) from error
    arrays: dict[str, NDArray[Any]] = {}
    for name, value in content.items():
        if not name.startswith("__"):
            _flattened(arrays, name, value, notes)
    return arrays


def _flattened(arrays: dict[str, NDArray[Any]], name: str, value: Any, notes: Notebook) -> None:
    if isinstance(value, np.ndarray) and value.dtype == object and value.size == 1:
        value = value.item()
    fields = getattr(value, "_fieldnames", None)
    if fields is not None:
        for field in fields:
            _flattened(arrays, f"{name}.{field}", getattr(value, field), notes)
    elif isinstance(value, np.ndarray) and value.dtype.kind in "fciu":
        arrays[name] = value
    else:
        notes.remark(f'the variable "{name}" holds no numbers')


def _add(found: dict[str, NDArray[Any]], name: str, item: Any, notes: Notebook) -> None:
    if not isinstance(item, h5py.Dataset) or name.startswith("#"):
        return
    label = name.replace("/", ".")
    if item.dtype.names == ("real", "imag"):
        pair = item[()]
        found[label] = (pair["real"] + 1j * pair["imag"]).T
    elif item.dtype.kind in "fiu" and item.attrs.get("MATLAB_empty", 0) == 0:
        found[label] = np.asarray(item[()]).T  # MATLAB's order of axes
    else:
        notes.remark(f'the variable "{label}" holds no numbers')
