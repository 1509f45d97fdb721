"""Check of results: NaN is refused unless the variable declares its meaning.

Some results are undetermined; for example, a motion at rest has no group velocity. A variable that may
contain NaN declares the meaning in its attribute ``nan_means``; a dataset does so for its attributes. In all
others NaN is refused, and infinity is refused everywhere.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from haptonic.errors import NumericalError
from haptonic.later import xarray as xr

WORD = "nan_means"


def describe(dataset: xr.Dataset, titles: Mapping[str, tuple[str, str]]) -> None:
    """Give variables of a dataset their units and titles."""
    for name, (unit, title) in titles.items():
        dataset[name].attrs = {"units": unit, "long_name": title}


def titled(variables: Mapping[str, tuple[Sequence[str], Any, str, str]]) -> xr.Dataset:
    """Dataset of variables, each given by its dimensions, values, unit and title."""
    return xr.Dataset(
        {
            name: (dims, values, {"units": unit, "long_name": title})
            for name, (dims, values, unit, title) in variables.items()
        }
    )


def declared(dataset: xr.Dataset, **meanings: str) -> xr.Dataset:
    """Declare the meaning of NaN in variables of a dataset, and return the dataset."""
    for name, meaning in meanings.items():
        dataset[name].attrs[WORD] = meaning
    return dataset


def passed(dataset: xr.Dataset) -> xr.Dataset:
    """Return the dataset if all its numbers are finite or declared undetermined.

    Raises
    ------
    NumericalError : an undeclared NaN, or infinity
    """
    for name, variable in dataset.variables.items():
        _look(str(name), variable.values, declared=WORD in variable.attrs)
        for inner, value in variable.attrs.items():
            _look(f"{name}.{inner}", value, declared=False)
    for name, value in dataset.attrs.items():
        _look(str(name), value, declared=WORD in dataset.attrs)
    return dataset


def json_of(values: object) -> str:
    """Plain values as JSON, which has neither NaN nor infinity; an undetermined value is None.

    Raises
    ------
    NumericalError : NaN or infinity
    """
    for name, value in _numbers(values, ""):
        _look(name, value, declared=False)
    return json.dumps(values, allow_nan=False)


def json_from(text: str) -> Any:
    """Parse JSON from a file of unknown origin.

    Raises
    ------
    ValueError : not JSON, or nested too deeply
    """
    try:
        return json.loads(text)
    except RecursionError:
        raise ValueError("lists nested more than a thousand deep") from None


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
            cause="sizes so far apart that only rounding errors are left, or a fault of the program",
            next_step="choose sizes that are closer together; if they are ordinary, report a fault",
        )
