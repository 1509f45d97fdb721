"""Gaps as labelled datasets: how they are stored in a result, read from it and compared."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.bloch.gaps import Gap
from haptonic.gate import describe
from haptonic.later import xarray as xr

FURTHER = "further_"  # before the names of variables and dimensions of other lattices of a plate


def dataset_of_gaps(gaps: tuple[Gap, ...]) -> xr.Dataset:
    """Gaps with dimension ``gap``; `gaps_of` reads them."""
    plain: dict[str, tuple[Any, str, str]] = {
        "gap_lower": ([g.lower for g in gaps], "Hz", "lower edge"),
        "gap_upper": ([g.upper for g in gaps], "Hz", "upper edge"),
        "gap_lower_error": ([g.lower_error for g in gaps], "Hz", "bound of the lower edge's error"),
        "gap_upper_error": ([g.upper_error for g in gaps], "Hz", "bound of the upper edge's error"),
    }
    dataset = xr.Dataset(
        {name: ("gap", np.array(values, dtype=float)) for name, (values, _, _) in plain.items()}
        | {
            "gap_below": ("gap", np.array([g.between[0] for g in gaps], dtype=np.int64)),
            "gap_lower_kappa": (("gap", "axis"), np.array([g.lower_kappa for g in gaps]).reshape(-1, 2)),
            "gap_upper_kappa": (("gap", "axis"), np.array([g.upper_kappa for g in gaps]).reshape(-1, 2)),
            "gap_complete": ("gap", np.array([g.complete for g in gaps], dtype=np.int8)),
            "gap_direction": ("gap", np.array([g.direction for g in gaps], dtype=object).astype("U")),
            "gap_waves": ("gap", np.array([g.waves for g in gaps], dtype=object).astype("U")),
            "gap_samples": ("gap", np.array([g.samples for g in gaps], dtype=np.int64)),
        }
    )
    describe(dataset, {name: (unit, title) for name, (_, unit, title) in plain.items()} | {
        "gap_below": ("1", "number of the band below, from 1"),
        "gap_lower_kappa": ("rad", "phases at which the lower edge lies"),
        "gap_upper_kappa": ("rad", "phases at which the upper edge lies"),
        "gap_complete": ("1", "1 if it covers the whole irreducible zone and all waves"),
        "gap_direction": ("1", "segment of the path of the gap, or all"),
        "gap_waves": ("1", "waves of the gap, by their symmetry about the plate's middle plane"),
        "gap_samples": ("1", "number of sampled wavevectors"),
    })  # fmt: skip
    return dataset


def gaps_of(dataset: xr.Dataset) -> tuple[Gap, ...]:
    """Read the gaps of a dataset, complete gaps first."""
    gaps = []
    for number in range(dataset.sizes["gap"]):
        row = dataset.isel(gap=number)
        gaps.append(
            Gap(
                between=(int(row["gap_below"]), int(row["gap_below"]) + 1),
                lower=float(row["gap_lower"]),
                upper=float(row["gap_upper"]),
                lower_error=float(row["gap_lower_error"]),
                upper_error=float(row["gap_upper_error"]),
                lower_kappa=(float(row["gap_lower_kappa"][0]), float(row["gap_lower_kappa"][1])),
                upper_kappa=(float(row["gap_upper_kappa"][0]), float(row["gap_upper_kappa"][1])),
                complete=bool(row["gap_complete"]),
                direction=str(row["gap_direction"].item()),
                samples=int(row["gap_samples"]),
                waves=row["gap_waves"].item(),
            )
        )
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
