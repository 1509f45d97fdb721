"""Bands of one unit cell."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import xarray as xr

from haptonic import plots, vtu
from haptonic.bloch import Gap, bands_dataset, gaps_of
from haptonic.cell import UnitCell
from haptonic.results.common import Asked, no_nan, stamped, write_netcdf
from haptonic.store import Store, content_key

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Bands:
    """Band diagram, gaps and mode shapes of a unit cell; ``dataset`` holds all of it, labelled."""

    dataset: xr.Dataset

    FILES: ClassVar = ("bands.nc", "gaps.csv", "modes.vtu")

    @staticmethod
    def figure_names(*, surface: bool) -> list[str]:
        """Names of the pictures that `figures` makes."""
        return ["dispersion", "modes"] + ["iso_frequency", "density_of_states"] * surface

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """Complete gaps first, then those of single directions."""
        return gaps_of(self.dataset)

    def plot(self) -> Figure:
        """Dispersion diagram with the complete gaps and the carrier."""
        return plots.dispersion(self.dataset, carrier_hz=self.dataset.attrs.get("carrier_hz"))

    def files(self) -> dict[str, Callable[[Path], object]]:
        """Names of the data files, and what writes each."""
        writers = (
            lambda path: write_netcdf(self.dataset, path),
            self._write_gaps,
            lambda path: vtu.write_modes(path, self.dataset, overwrite=True),
        )
        return dict(zip(self.FILES, writers, strict=True))

    def figures(self) -> dict[str, Figure]:
        """All pictures, by name."""
        surface = "zone_frequency" in self.dataset
        drawn = [self.plot(), plots.mode_shapes(self.dataset)]
        if surface:
            drawn += [plots.iso_frequency(self.dataset), plots.density_of_states(self.dataset)]
        return dict(zip(self.figure_names(surface=surface), drawn, strict=True))

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        data = self.dataset
        labels, corners = json.loads(data.attrs["path_labels"]), json.loads(data.attrs["path_corners"])
        names = json.loads(data.attrs["character_names"])
        return {
            "gaps": [gap_json(gap) for gap in self.gaps],
            "bands": {
                "labels": labels,
                "corners": corners,
                "kappa": data["kappa"].values.tolist(),
                "frequency_hz": data["frequency"].values.tolist(),
                "error_hz": data["frequency_error"].values.tolist(),
                "group_velocity_m_per_s": no_nan(data["group_velocity"].values),
                "out_of_plane": data["out_of_plane"].values.tolist(),
                "pillar_strain": data["pillar_strain"].values.tolist(),
                "parity": data["parity"].values.tolist(),
                "corner_symmetry": data["corner_symmetry"].values.tolist(),
                "branch": data["branch"].values.tolist(),
                "character": [[names[i] for i in row] for row in data["character"].values],
            },
            "counts": {name: int(data.attrs[f"counts_{name}"]) for name in ("checked", "missed")},
            "mesh": json.loads(data.attrs["mesh"]) | {"unknowns": int(data.attrs["unknowns"])},
            "inputs": json.loads(data.attrs["inputs"]),
            "version": data.attrs["haptonic_version"],
        }

    def _write_gaps(self, path: Path) -> None:
        with path.open("w", newline="", encoding="utf-8") as file:
            table = csv.writer(file)
            table.writerow(
                ["band_below", "band_above", "lower_hz", "upper_hz", "lower_error_hz", "upper_error_hz",
                 "complete", "direction", "samples"]
            )  # fmt: skip
            for g in self.gaps:
                edges = [f"{value:.3f}" for value in (g.lower, g.upper, g.lower_error, g.upper_error)]
                table.writerow([*g.between, *edges, g.complete, g.direction, g.samples])


def gap_json(gap: Gap) -> dict[str, Any]:
    """One gap as plain values."""
    return {
        "lower_hz": gap.lower,
        "upper_hz": gap.upper,
        "lower_error_hz": gap.lower_error,
        "upper_error_hz": gap.upper_error,
        "complete": gap.complete,
        "between": list(gap.between),
        "direction": gap.direction,
        "lower_kappa": list(gap.lower_kappa),
        "upper_kappa": list(gap.upper_kappa),
        "samples": gap.samples,
    }


def compute_bands(
    cell: UnitCell,
    asked: Asked,
    *,
    surface: bool,
    inputs: Mapping[str, Any],
    carrier: float | None,
    store: Store,
) -> Bands:
    """Bands of a cell, from the store if they were computed before.

    Parameters
    ----------
    surface : also sample the whole zone evenly
    inputs : plain values of what was asked, for the result's attributes
    carrier : Hz, marked in the diagram
    """
    key = content_key({"kind": "bands", "surface": surface, "cell": cell, "asked": asked})
    dataset = store.get(key)
    if dataset is None:
        dataset = bands_dataset(
            cell,
            count=asked.count,
            points=asked.points,
            accuracy=asked.accuracy,
            resolution=asked.resolution,
            surface=surface,
        )
        store.put(key, dataset)
    if carrier is not None:
        dataset.attrs["carrier_hz"] = carrier
    return Bands(stamped(dataset, inputs))
