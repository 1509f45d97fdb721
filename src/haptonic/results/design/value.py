"""The best design found, and every one seen."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.design.brief import Brief
from haptonic.design.quick import QUICK
from haptonic.design.search import Visited
from haptonic.results.design.tasks import as_dataset

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TITLES = {
    "value": ("SI", "numbers of the cell that were varied"),
    "band": ("1", "number of the band below the gap, from 1"),
    "lower": ("Hz", "lower edge in the model of the search, above the upper one where there is no gap"),
    "upper": ("Hz", "upper edge in the model of the search"),
    "margin": ("1", "distance of the carrier from the nearer edge, as a share of the carrier"),
    "stage": ("1", "part of the search"),
}


@dataclass(frozen=True)
class Design:
    """The best design found, and every one seen.

    values : its numbers by path, SI
    gap : at the accuracy asked for; margin : of the carrier in it, Hz, errors counted
    dataset : all designs seen
    """

    values: dict[str, float]
    gap: Gap
    margin: float
    dataset: xr.Dataset

    @property
    def held_back_by(self) -> list[str]:
        """Bounds and limits that the design has reached, in words."""
        return list(json.loads(self.dataset.attrs["held_back_by"]))

    @property
    def left_out(self) -> list[dict[str, Any]]:
        """Designs that could not be computed: ``stage`` of the search, ``values`` by path (SI), ``cause``."""
        return list(json.loads(self.dataset.attrs["left_out"]))

    def plot(self) -> Figure:
        """Edges of the gap and margin of the carrier, design by design."""
        return plots.search(self.dataset)

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        data = self.dataset
        names = [str(name) for name in data["parameter"].values]
        return {
            "values": self.values,
            "gap": {
                "lower_hz": self.gap.lower,
                "upper_hz": self.gap.upper,
                "lower_error_hz": self.gap.lower_error,
                "upper_error_hz": self.gap.upper_error,
                "between": list(self.gap.between),
            },
            "margin_hz": self.margin,
            "held_back_by": self.held_back_by,
            "left_out": self.left_out,
            "carrier_hz": float(data.attrs["carrier_hz"]),
            "seen": [
                {
                    "stage": str(data["stage"].values[i]),
                    "values": dict(zip(names, data["value"].values[i].tolist(), strict=True)),
                    "lower_hz": float(data["lower"][i]),
                    "upper_hz": float(data["upper"][i]),
                    "margin": float(data["margin"][i]),
                }
                for i in range(data.sizes["visit"])
            ],
        }


def all_seen(brief: Brief, history: Sequence[tuple[str, Visited]]) -> xr.Dataset:
    """The designs seen, each with the stage of the search that saw it."""
    visits = [visit for _, visit in history]
    dataset = as_dataset(visits).drop_vars("share")
    dataset["value"] = ("visit", "parameter"), np.array([brief.values(visit.share) for visit in visits])
    dataset["stage"] = "visit", np.array([stage for stage, _ in history])
    dataset = dataset.assign_coords(parameter=list(brief.paths))
    for name, (unit, title) in TITLES.items():
        dataset[name].attrs = {"units": unit, "long_name": title}
    dataset.attrs |= {"carrier_hz": brief.carrier, "mesh": json.dumps(asdict(QUICK))}
    return dataset
