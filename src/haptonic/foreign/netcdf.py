"""NetCDF 4 files, which are HDF5 files with conventions, as the arrays that they mean."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from haptonic.foreign.process import ForeignError, ask

PACKING = ("scale_factor", "add_offset", "_FillValue", "missing_value", "dtype", "_Unsigned")


def arrays_of(path: Path, content: dict[str, Any], names: Sequence[str]) -> dict[str, NDArray[Any]]:
    """Numbers, unpacked, and texts by name, of a file of which ``content`` is the "hdf5.tree".

    Raises
    ------
    ForeignError : the data or what is said of their packing is damaged
    MemoryError : too large
    """
    read = ask("hdf5.read", path, names=list(names))
    return {
        name: _unpacked(name, values, content["sets"][name]["attributes"])
        for name, values in zip(names, read, strict=True)
    }


def _unpacked(name: str, values: Any, says: dict[str, Any]) -> NDArray[Any]:
    array = np.asarray(values, dtype=None if isinstance(values, np.ndarray) else object)
    packed = {word: says[word] for word in PACKING if word in says}
    if not packed or array.dtype == object:
        return array
    variable = xr.Variable([f"axis {i}" for i in range(array.ndim)], array, packed)
    try:
        decoded = xr.conventions.decode_cf_variable(
            name, variable, concat_characters=False, stack_char_dim=False, decode_times=False
        )
        return np.asarray(decoded.values)
    except (TypeError, ValueError, LookupError, AttributeError, ArithmeticError) as error:
        raise ForeignError(f"{name}: {', '.join(packed)} make no sense") from error
