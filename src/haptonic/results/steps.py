"""Displacements of a view in small integers: each frequency, or each mode, in steps of its own."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.arrays import AnyComplex
from haptonic.later import xarray as xr

STEPS = np.iinfo(np.int8).max  # of the largest displacement; a map has as many colours


def stepped(name: str, field: AnyComplex, dims: Sequence[Hashable]) -> dict[str, Any]:
    """Variables ``name_real``, ``name_imag`` and ``name_step`` (m) of a field, whose first axis is frequency.

    The displacement is a number of steps; values that are not finite are 0.
    """
    field = np.where(np.isfinite(field), field, 0.0)
    largest = np.abs(field).max(axis=tuple(range(1, field.ndim)))
    step = np.where(largest > 0, largest, 1.0) / STEPS
    wide = step.reshape(-1, *[1] * (field.ndim - 1))
    about = {"units": "m", "long_name": "step of the displacement"}
    return {
        f"{name}_real": (dims, np.rint(field.real / wide).astype(np.int8)),
        f"{name}_imag": (dims, np.rint(field.imag / wide).astype(np.int8)),
        f"{name}_step": (dims[0], step, about),
    }


def in_steps(field: xr.DataArray) -> xr.Variable:
    """Displacements up to 1 in `STEPS`."""
    return xr.Variable(field.dims, np.rint(STEPS * field.values).astype(np.int8), field.attrs)


def step_colours() -> list[list[int]]:
    """A colour for each number of steps, from the most negative one."""
    return plots.shades(2 * STEPS + 1, signed=True)
