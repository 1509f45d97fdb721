"""Bands of one unit cell."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pandas as pd
import xarray as xr

from haptonic import plots, vtu
from haptonic.bloch import Gap, bands_dataset, gaps_of
from haptonic.bloch.settings import BandSettings
from haptonic.cell import UnitCell
from haptonic.plots.words import khz
from haptonic.results.common import no_nan, stamped
from haptonic.results.result import Result, figure, file
from haptonic.results.table import Column, Table, Uncertain
from haptonic.store import Store, content_key

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def _over_the_zone(result: Bands) -> bool:
    return "zone_frequency" in result.dataset


@dataclass(frozen=True, eq=False, repr=False)
class Bands(Result):
    """Band diagram, gaps and mode shapes of a unit cell; ``dataset`` holds all of it, labelled."""

    title = "Bands and gaps"
    data_file = "bands"

    dataset: xr.Dataset

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """Complete gaps first, then those of single directions."""
        return gaps_of(self.dataset)

    def summary(self) -> list[str]:
        complete = [gap for gap in self.gaps if gap.complete]
        said = [
            f"Complete gap from {khz(gap.lower, gap.lower_error)} to {khz(gap.upper, gap.upper_error)} kHz, "
            f"between bands {gap.between[0]} and {gap.between[1]}"
            + ("." if gap.certain else "; it is not wider than the errors of its edges, so it may not exist.")
            for gap in complete
        ]
        said += [] if complete else ["There is no complete gap among the bands that were computed."]
        return [*said, counted(**self._counts)]

    def tables(self) -> list[Table]:
        gaps = self.gaps
        columns = (
            "bands", "where", Column("lower", "Hz", "kHz", ".3f"), Column("upper", "Hz", "kHz", ".3f"),
            Column("width", "Hz", "kHz", ".2f"), Column("samples"),
        )  # fmt: skip
        rows = [
            (
                f"{gap.between[0]}-{gap.between[1]}",
                "everywhere (complete)" if gap.complete else f"{gap.direction} only",
                Uncertain(gap.lower, gap.lower_error),
                Uncertain(gap.upper, gap.upper_error),
                Uncertain(
                    gap.width, gap.lower_error + gap.upper_error, "" if gap.certain else " (uncertain)"
                ),
                gap.samples,
            )
            for gap in gaps
        ]
        return [Table("band gaps", columns, rows, [k for k, gap in enumerate(gaps) if gap.complete])]

    @figure("dispersion")
    def _dispersion(self) -> Figure:
        """Dispersion diagram with the complete gaps and the carrier."""
        return plots.dispersion(self.dataset, carrier_hz=self.dataset.attrs.get("carrier_hz"))

    @figure("modes")
    def _modes(self) -> Figure:
        return plots.mode_shapes(self.dataset)

    @figure("iso_frequency", when=_over_the_zone)
    def _iso_frequency(self) -> Figure:
        return plots.iso_frequency(self.dataset)

    @figure("density_of_states", when=_over_the_zone)
    def _density_of_states(self) -> Figure:
        return plots.density_of_states(self.dataset)

    @file("gaps.csv")
    def _write_gaps(self, path: Path) -> None:
        columns = {
            "band_below": [gap.between[0] for gap in self.gaps],
            "band_above": [gap.between[1] for gap in self.gaps],
            **{
                f"{name}_hz": [f"{getattr(gap, name):.3f}" for gap in self.gaps]
                for name in ("lower", "upper", "lower_error", "upper_error")
            },
            **{
                name: [getattr(gap, name) for gap in self.gaps]
                for name in ("complete", "direction", "samples")
            },
        }
        pd.DataFrame(columns).to_csv(path, index=False)

    @file("modes.vtu")
    def _write_modes(self, path: Path) -> None:
        vtu.write_modes(path, self.dataset, overwrite=True)

    @property
    def _counts(self) -> dict[str, int]:
        return {name: int(self.dataset.attrs[f"counts_{name}"]) for name in ("checked", "missed")}

    def facts(self) -> dict[str, Any]:
        return self.to_json() | {"modes": mode_names(self.dataset)}

    def to_json(self) -> dict[str, Any]:
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
            "counts": self._counts,
            "mesh": json.loads(data.attrs["mesh"]) | {"unknowns": int(data.attrs["unknowns"])},
            "inputs": json.loads(data.attrs["inputs"]),
            "version": data.attrs["haptonic_version"],
        }


def mode_names(data: xr.Dataset) -> list[str]:
    """Names of the modes at the one wavevector where they are known, in order of frequency."""
    if "mode_name" not in data:
        return []
    names = json.loads(data.attrs["character_names"])
    return [names[int(number)] for number in data["mode_name"].values]


def counted(checked: int, missed: int) -> str:
    """What the exact counts of modes say of the bands."""
    if not checked:
        return "Bands were not counted by another method: where it would be done, one lies within its error."
    missing = f"{missed or 'no'} band{'s' * (missed != 1)} missing"
    return f"Counted by another method, in {checked} comparison{'s' * (checked != 1)}: {missing}."


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
    settings: BandSettings,
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
    key = content_key({"kind": "bands", "surface": surface, "cell": cell, "settings": settings})
    dataset = store.get(key)
    if dataset is None:
        dataset = bands_dataset(
            cell,
            count=settings.count,
            points=settings.points,
            accuracy=settings.accuracy,
            resolution=settings.resolution,
            surface=surface,
        )
        store.put(key, dataset)
    if carrier is not None:
        dataset.attrs["carrier_hz"] = carrier
    return Bands(stamped(dataset, inputs))
