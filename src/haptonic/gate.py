"""The gate that every result passes: no NaN leaves the program unless it says what it means.

Some results are honestly undetermined: a motion at rest has no group velocity. A variable in which that may
happen says so in its attribute ``nan_means``, and a dataset for its attributes; in all others NaN is refused,
and infinity everywhere.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from haptonic.errors import NumericalError
from haptonic.later import xarray as xr

WORD = "nan_means"


def declared(dataset: xr.Dataset, **meanings: str) -> xr.Dataset:
    """The same dataset, its variables marked with what a NaN in each means."""
    for name, meaning in meanings.items():
        dataset[name].attrs[WORD] = meaning
    return dataset


def passed(dataset: xr.Dataset) -> xr.Dataset:
    """The dataset itself if all of its numbers are some.

    Raises
    ------
    NumericalError : NaN that no ``nan_means`` declares, or infinity
    """
    for name, variable in dataset.variables.items():
        _look(str(name), variable.values, declared=WORD in variable.attrs)
        for inner, value in variable.attrs.items():
            _look(f"{name}.{inner}", value, declared=False)
    for name, value in dataset.attrs.items():
        _look(str(name), value, declared=WORD in dataset.attrs)
    return dataset


def json_of(values: object) -> str:
    """Plain values as JSON, which knows neither NaN nor infinity; an undetermined value is None.

    Raises
    ------
    NumericalError : a number that is none
    """
    for name, value in _numbers(values, ""):
        _look(name, value, declared=False)
    return json.dumps(values, allow_nan=False)


def json_from(text: str) -> Any:
    """What a file of somebody else holds as JSON.

    Raises
    ------
    ValueError : it is not JSON, or nested deeper than anything that is meant
    """
    try:
        return json.loads(text)
    except RecursionError:
        raise ValueError("lists within lists, a thousand deep") from None


def _numbers(values: object, name: str) -> Iterator[tuple[str, float]]:
    if isinstance(values, float):
        yield name, values
    elif isinstance(values, dict):
        for key, inner in values.items():
            yield from _numbers(inner, f"{name}.{key}" if name else str(key))
    elif isinstance(values, list | tuple):
        for number, inner in enumerate(values):
            yield from _numbers(inner, f"{name}[{number}]")


def _look(name: str, values: Any, *, declared: bool) -> None:
    array = np.asarray(values)
    if array.dtype.kind not in "fc":
        return
    bad = np.isinf(array) if declared else ~np.isfinite(array)
    if bad.any():
        place = ", ".join(map(str, np.argwhere(bad)[0]))
        raise NumericalError.inaccurate(
            argument=f"result {name}",
            given=f"{array[bad].flat[0]} in {int(bad.sum())} of {math.prod(array.shape)} values"
            + (f", the first at [{place}]" if place else ""),
            allowed="finite numbers",
            cause="sizes so far apart that rounding is all that is left, or a fault of the program",
            next_step="bring the sizes nearer to each other; if they are ordinary, report a fault",
        )
