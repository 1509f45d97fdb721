"""What a run gives back: values that can be asked, drawn and written, each with the inputs that made it."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import astuple, dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from haptonic import plots, vtu
from haptonic.bloch import Gap, Resolution, bands_dataset, gaps_dataset, gaps_of
from haptonic.cell import UnitCell
from haptonic.cell.cantilever import euler_bernoulli, timoshenko
from haptonic.jobs import Outcome, Task, run_all
from haptonic.materials import IsotropicMaterial
from haptonic.store import Store, content_key, fingerprint, refuse_overwrite, write_atomically

RESONANCES = 3


@dataclass(frozen=True)
class Asked:
    """What is asked of the bands of a cell: see the table ``[bands]`` of the study file."""

    count: int
    points: int
    accuracy: float
    resolution: Resolution | None


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
                "group_velocity_m_per_s": _no_nan(data["group_velocity"].values),
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


@dataclass(frozen=True)
class Sweep:
    """Complete gaps along a row of designs; designs that could not be computed are in ``failed``."""

    dataset: xr.Dataset
    failed: dict[int, dict[str, str]]

    def plot(self) -> Figure:
        """Gaps against the swept value, with the pillar's own resonances."""
        return plots.sweep(self.dataset)

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        data = self.dataset
        designs = []
        for step in range(data.sizes["step"]):
            row = data.isel(step=step)
            there = np.isfinite(row["gap_lower"].values)
            gaps = [
                {
                    "lower_hz": float(row["gap_lower"][i]),
                    "upper_hz": float(row["gap_upper"][i]),
                    "lower_error_hz": float(row["gap_lower_error"][i]),
                    "upper_error_hz": float(row["gap_upper_error"][i]),
                    "complete": True,
                    "between": [int(row["gap_below"][i]), int(row["gap_below"][i]) + 1],
                }
                for i in np.flatnonzero(there)
            ]
            designs.append({"value": float(row["value"]), "gaps": gaps, "error": self.failed.get(step)})
        return {"vary": data.attrs["expression"], "unit": data["value"].attrs["units"], "designs": designs}


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
    key = content_key({"kind": "bands", "surface": surface, "points": asked.points, **_key_of(cell, asked)})
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
        dataset.attrs["lattice"] = json.dumps([*cell.lattice.a1, *cell.lattice.a2])
        store.put(key, dataset)
    if carrier is not None:
        dataset.attrs["carrier_hz"] = carrier
    return Bands(_stamped(dataset, inputs))


@dataclass(frozen=True)
class Row:
    """A row of designs: the swept value and the cell of each.

    labels : attributes of the result: ``expression``, ``units``, and if known ``own_value``, ``carrier_hz``
    """

    values: Sequence[float]
    cells: Sequence[UnitCell]
    labels: Mapping[str, Any]


def compute_sweeps(
    rows: Sequence[Row],
    asked: Asked,
    *,
    inputs: Mapping[str, Any],
    store: Store,
    workers: int = 0,
    scheduler: str | None = None,
    on_progress: Callable[[int, int, bool], None] | None = None,
) -> tuple[Sweep, ...]:
    """Complete gaps of rows of designs, kept one by one in the store as they are finished.

    Parameters
    ----------
    inputs : plain values of what was asked, for the results' attributes
    workers, scheduler, on_progress : see `haptonic.jobs.run_all`; all rows are computed as one
    """
    tasks = [
        Task({"kind": "gaps", **_key_of(cell, asked)}, (cell, asked)) for row in rows for cell in row.cells
    ]
    outcomes = iter(
        run_all(
            design_gaps, tasks, store=store, workers=workers, scheduler=scheduler, on_progress=on_progress
        )
    )
    return tuple(_sweep(row, [next(outcomes) for _ in row.cells], inputs) for row in rows)


def _sweep(row: Row, outcomes: Sequence[Outcome], inputs: Mapping[str, Any]) -> Sweep:
    cells, labels = row.cells, row.labels
    slots = max([o.dataset.sizes["gap"] for o in outcomes if o.dataset is not None], default=0)
    names = ("gap_lower", "gap_upper", "gap_lower_error", "gap_upper_error", "gap_below")
    table = {name: np.full((len(cells), slots), np.nan) for name in names}
    highest = np.full(len(cells), np.nan)
    for step, outcome in enumerate(outcomes):
        if outcome.dataset is not None:
            for name in names:
                table[name][step, : outcome.dataset.sizes["gap"]] = outcome.dataset[name]
            highest[step] = float(outcome.dataset["searched_up_to"])
    beams = [_cantilever(cell) for cell in cells]
    dataset = xr.Dataset(
        {
            "value": ("step", np.asarray(row.values)),
            **{name: (("step", "gap_slot"), array) for name, array in table.items()},
            "searched_up_to": ("step", highest),
            "euler_bernoulli": (("step", "resonance"), np.stack([slender for slender, _ in beams])),
            "timoshenko": (("step", "resonance"), np.stack([stocky for _, stocky in beams])),
        }
    )
    for variable in dataset.values():
        variable.attrs = {"units": "1" if variable.name == "gap_below" else "Hz"}
    dataset["value"].attrs = {"units": labels["units"] or "1", "long_name": labels["expression"]}
    dataset.attrs = {name: value for name, value in labels.items() if name != "units" and value is not None}
    failed = {step: o.error.parts() for step, o in enumerate(outcomes) if o.error is not None}
    return Sweep(_stamped(dataset, inputs), failed)


def design_gaps(design: tuple[UnitCell, Asked]) -> xr.Dataset:
    """Complete gaps of one design; what a worker is given to do."""
    cell, asked = design
    found: xr.Dataset = gaps_dataset(
        cell, count=asked.count, accuracy=asked.accuracy, resolution=asked.resolution
    )
    return found


def write_files(
    folder: Path, writers: Mapping[str, Callable[[Path], object]], *, overwrite: bool
) -> list[Path]:
    """Write files into a folder, each whole or not at all, and none if one is in the way."""
    refuse_taken(folder, writers, overwrite=overwrite)
    for name, writer in writers.items():
        write_atomically(folder / name, writer)
    return [folder / name for name in writers]


def refuse_taken(folder: Path | None, names: Iterable[str], *, overwrite: bool) -> None:
    """Raise ResourceError if one of the names is taken in a folder, or if nothing can be written there.

    Asked before the work starts, so that no run is lost on its last step.
    """
    if folder is None:
        return
    for name in names:
        refuse_overwrite(folder / name, overwrite)
    probe = folder / ".haptonic-probe"
    write_atomically(probe, Path.touch)
    probe.unlink()


def write_netcdf(dataset: xr.Dataset, path: Path) -> None:
    """NetCDF 4 by h5netcdf."""
    dataset.to_netcdf(path, engine="h5netcdf")


def _stamped(dataset: xr.Dataset, inputs: Mapping[str, Any]) -> xr.Dataset:
    dataset.attrs |= {
        "inputs": json.dumps(inputs),
        "haptonic_version": version("haptonic"),
        "code_fingerprint": fingerprint(),
        "origin": "simulated",
    }
    return dataset


def _key_of(cell: UnitCell, asked: Asked) -> dict[str, object]:
    pillar = cell.pillar
    resolution = asked.resolution
    return {
        "lattice": [cell.lattice.name, *cell.lattice.a1, *cell.lattice.a2],
        "thickness": cell.thickness,
        "material": cell.material.to_dict(),
        "pillar": None if pillar is None else [pillar.diameter, pillar.height],
        "count": asked.count,
        "accuracy": asked.accuracy,
        "mesh": None if resolution is None else list(astuple(resolution)),
    }


def _cantilever(cell: UnitCell) -> tuple[np.ndarray, np.ndarray]:
    if cell.pillar is None or not isinstance(cell.material, IsotropicMaterial):
        return np.full(RESONANCES, np.nan), np.full(RESONANCES, np.nan)
    return euler_bernoulli(cell.pillar, cell.material), timoshenko(cell.pillar, cell.material, RESONANCES)


def _no_nan(array: np.ndarray) -> Any:
    """Nested lists with null in place of NaN, which JSON does not have."""
    return np.where(np.isnan(array), np.array(None), array).tolist()
