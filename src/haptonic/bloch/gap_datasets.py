"""Gaps as labelled datasets: how they are stored in a result, read from it and compared."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.bloch.gaps import Gap
from haptonic.gate import describe, titled
from haptonic.later import xarray as xr

# type, unit and title of each variable of a gap, by its name without "gap_", an attribute of `Gap`
VARIABLES: dict[str, tuple[Any, str, str]] = {
    "lower": (float, "Hz", "lower edge"),
    "upper": (float, "Hz", "upper edge"),
    "lower_error": (float, "Hz", "bound of the lower edge's error"),
    "upper_error": (float, "Hz", "bound of the upper edge's error"),
    "below": (np.int64, "1", "number of the band below, from 1"),
    "lower_kappa": (float, "rad", "phases at which the lower edge lies"),
    "upper_kappa": (float, "rad", "phases at which the upper edge lies"),
    "complete": (np.int8, "1", "1 if it covers the whole irreducible zone and all waves"),
    "direction": (str, "1", "segment of the path of the gap, or all"),
    "waves": (str, "1", "waves of the gap, by their symmetry about the plate's middle plane"),
    "samples": (np.int64, "1", "number of sampled wavevectors"),
}
OF_EDGES = ("lower_kappa", "upper_kappa")  # pairs of numbers
FURTHER = "further_"  # before the names of variables and dimensions of other lattices of a plate


def dataset_of_gaps(gaps: tuple[Gap, ...]) -> xr.Dataset:
    """Gaps with dimension ``gap``; `gaps_of` reads them."""
    variables: dict[str, tuple[Sequence[str], Any, str, str]] = {}
    for name, (kind, unit, title) in VARIABLES.items():
        values = np.array([getattr(gap, name) for gap in gaps], dtype=kind)
        if name in OF_EDGES:
            variables[f"gap_{name}"] = ("gap", "axis"), values.reshape(-1, 2), unit, title
        else:
            variables[f"gap_{name}"] = "gap", values, unit, title
    return titled(variables)


def gaps_of(dataset: xr.Dataset) -> tuple[Gap, ...]:
    """Read the gaps of a dataset, complete gaps first."""
    columns = (dataset[f"gap_{name}"].values.tolist() for name in VARIABLES)
    gaps = []
    for values in zip(*columns, strict=True):
        row = dict(zip(VARIABLES, values, strict=True))
        row |= {"complete": bool(row["complete"]), **{name: tuple(row[name]) for name in OF_EDGES}}
        below = row.pop("below")
        gaps.append(Gap(between=(below, below + 1), **row))
    return tuple(gaps)


def add_further_gaps(dataset: xr.Dataset, gaps: Mapping[str, tuple[Gap, ...]]) -> xr.Dataset:
    """A dataset of bands with the gaps of further lattices, by the name of each; see `further_gaps_of`."""
    if not gaps:
        return dataset
    own = dataset_of_gaps(tuple(gap for every in gaps.values() for gap in every))
    further = own.rename({name: f"{FURTHER}{name}" for name in (*own, "gap")})
    number = np.repeat(np.arange(len(gaps)), [len(every) for every in gaps.values()])
    further[f"{FURTHER}gap_lattice"] = f"{FURTHER}gap", number
    further[f"{FURTHER}lattice"] = f"{FURTHER}lattice", np.array(list(gaps))
    titles = {"gap_lattice": "number of its lattice, from 0", "lattice": "name of a further lattice"}
    describe(further, {f"{FURTHER}{name}": ("1", title) for name, title in titles.items()})
    return dataset.merge(further)


def further_gaps_of(dataset: xr.Dataset) -> dict[str, tuple[Gap, ...]]:
    """Read the gaps of further lattices by the name of each, also of those without a gap."""
    if f"{FURTHER}lattice" not in dataset:
        return {}
    stored = {name: name.removeprefix(FURTHER) for name in map(str, dataset) if name.startswith(FURTHER)}
    own = dataset[list(stored)].rename({**stored, f"{FURTHER}gap": "gap"})
    return {
        name: gaps_of(own.isel(gap=own["gap_lattice"].values == number))
        for number, name in enumerate(dataset[f"{FURTHER}lattice"].values.tolist())
    }


def certain_gaps(dataset: xr.Dataset) -> NDArray[np.bool_]:
    """True for each gap of a dataset that is wider than the errors of its edges; False without a gap."""
    width = dataset["gap_upper"].values - dataset["gap_lower"].values
    return np.asarray(width > dataset["gap_lower_error"].values + dataset["gap_upper_error"].values)


def carrier_margins(dataset: xr.Dataset) -> Array:
    """(step,) margins of the carrier in the gaps of a sweep, Hz; NaN without a carrier, or outside of all.

    The margin is the distance to the nearer edge, with the error of the edge subtracted.
    """
    carrier = float(dataset.attrs.get("carrier_hz", np.nan))
    lower, upper, lower_error, upper_error = (
        dataset[name].values for name in ("gap_lower", "gap_upper", "gap_lower_error", "gap_upper_error")
    )
    margin = np.minimum(carrier - lower - lower_error, upper - upper_error - carrier)
    return np.asarray(np.fmax.reduce(np.where(margin > 0, margin, np.nan), axis=1, initial=np.nan))
