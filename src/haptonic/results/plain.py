"""Plain values of a result, for JSON, tables and reference values.

The rules: the name of a number ends with its SI unit, as in ``frequency_hz`` or ``speed_m_per_s``. A
dimension that is labelled with names becomes an object, any other dimension a list. A complex number becomes
two numbers. NaN is written as None in a variable that declares it undetermined by `haptonic.gate.WORD`; any
other NaN is refused when it is written.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Hashable, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import PurePath
from typing import Any, get_type_hints

import numpy as np

from haptonic.gate import WORD
from haptonic.hdf5 import STUDY
from haptonic.later import xarray as xr


def named(name: str, unit: str) -> str:
    """Append a unit to a name: ``frequency`` in Hz becomes ``frequency_hz``; a bare number keeps its name."""
    words = re.sub(r"\W+", "_", unit.replace("/", " per ")).strip("_").lower()
    return name if words in ("", "1") or name.endswith(f"_{words}") else f"{name}_{words}"


def plain(value: Any) -> Any:
    """Convert a value for JSON: object, list, text, number, bool or None."""
    match value:
        case xr.Dataset():
            return _of_dataset(value)
        case xr.DataArray():
            return _of_array(value)
        case np.ndarray():
            return _of_numbers(value, undetermined=False)
        case np.generic():
            return plain(value.item())
        case complex():
            return {"real": value.real, "imag": value.imag}
        case Mapping():
            return {str(key): plain(inner) for key, inner in value.items()}
        case list() | tuple() | set() | frozenset():
            return [plain(inner) for inner in value]
        case PurePath():
            return str(value)
        case _ if is_dataclass(value):
            units = _units(value.__class__)
            return {named(name, unit): plain(getattr(value, name)) for name, unit in units.items()}
    return value


def determined(value: Any) -> Any:
    """Replace every NaN and infinity in a value by None, for quantities that could not be determined."""
    if isinstance(value, dict):
        return {key: determined(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [determined(inner) for inner in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def split(data: xr.Dataset | xr.DataArray | None, dimension: str) -> Any:
    """Parts along a dimension, by its labels; a list if it has no labels, {} for None."""
    if data is None:
        return {}
    each = [data.isel({dimension: number}) for number in range(data.sizes[dimension])]
    if not _has_names(data, dimension):
        return each
    return dict(
        zip(data[dimension].values.tolist(), (part.drop_vars(dimension) for part in each), strict=True)
    )


def attributes(data: xr.Dataset) -> dict[str, Any]:
    """Attributes of a dataset but the text of its study; JSON texts of objects and lists are decoded."""
    decoded = {name: _attribute(value) for name, value in data.attrs.items() if name not in (WORD, STUDY)}
    return {name: determined(value) for name, value in decoded.items()} if WORD in data.attrs else decoded


def _attribute(value: Any) -> Any:
    if isinstance(value, str) and value[:1] in ("{", "["):
        try:
            return json.loads(value)
        except ValueError:
            return value  # a user's name, such as "[A1], V"
    return plain(value)


def _has_names(data: xr.Dataset | xr.DataArray, dimension: Hashable) -> bool:
    return dimension in data.coords and data[dimension].dtype.kind in "UO"


@cache
def _units(kind: type[Any]) -> dict[str, str]:
    """Units of the fields of a dataclass, from `haptonic.units.In` and declared quantities."""
    hints = get_type_hints(kind, include_extras=True)
    units = {name: [part.unit for part in getattr(hint, "__metadata__", ()) if hasattr(part, "unit")]
             for name, hint in hints.items()}  # fmt: skip
    return {field.name: "".join(units[field.name][:1]) for field in fields(kind)}


def _of_dataset(data: xr.Dataset) -> dict[str, Any]:
    keys = {dimension for dimension in data.dims if _has_names(data, dimension)}
    return {
        named(str(name), data[name].attrs.get("units", "")): _of_array(data[name])
        for name in (*(coord for coord in data.coords if coord not in keys), *data.data_vars)
    }


def _of_array(array: xr.DataArray) -> Any:
    if array.dims and _has_names(array, array.dims[0]) and array.name != array.dims[0]:
        names = array[array.dims[0]].values.tolist()
        return {name: _of_array(array[number]) for number, name in enumerate(names)}
    if any(_has_names(array, dimension) for dimension in array.dims[1:]):
        return [_of_array(part) for part in array]
    return _of_numbers(array.values, undetermined=WORD in array.attrs)


def _of_numbers(values: np.ndarray, *, undetermined: bool) -> Any:
    if values.dtype.kind == "c":
        return {part: _of_numbers(getattr(values, part), undetermined=undetermined)
                for part in ("real", "imag")}  # fmt: skip
    if undetermined and values.dtype.kind == "f":
        values = np.where(np.isnan(values), np.array(None), values)
    return values.tolist()
