"""Complete gaps along rows of designs."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from haptonic import plots
from haptonic.bloch.settings import BandSettings
from haptonic.cell import UnitCell
from haptonic.cell.cantilever import euler_bernoulli, timoshenko
from haptonic.gate import declared
from haptonic.jobs import Outcome, Task
from haptonic.materials import IsotropicMaterial
from haptonic.results.common import Writer, stamped, write_netcdf
from haptonic.results.result import Result, figure, file
from haptonic.results.runner import Runner, design_gaps
from haptonic.results.table import Cell, Column, Table
from haptonic.units import format_quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

RESONANCES = 3


@dataclass(frozen=True)
class Sweep:
    """Complete gaps along a row of designs; designs that could not be computed are in ``failed``."""

    dataset: xr.Dataset
    failed: dict[int, dict[str, str]]

    def plot(self) -> Figure:
        """Gaps against the swept value, with the pillar's own resonances."""
        return plots.sweep(self.dataset)

    def gaps_at(self, step: int) -> list[dict[str, Any]]:
        """The gaps of one design as plain values."""
        row = self.dataset.isel(step=step)
        return [
            {
                "lower_hz": float(row["gap_lower"][i]),
                "upper_hz": float(row["gap_upper"][i]),
                "lower_error_hz": float(row["gap_lower_error"][i]),
                "upper_error_hz": float(row["gap_upper_error"][i]),
                "complete": True,
                "between": [int(row["gap_below"][i]), int(row["gap_below"][i]) + 1],
            }
            for i in np.flatnonzero(np.isfinite(row["gap_lower"].values))
        ]

    def table(self) -> Table:
        """The widest complete gap of each design."""
        data, unit = self.dataset, self.dataset["value"].attrs["units"]
        rows: list[tuple[Cell, ...]] = []
        for step, value in enumerate(data["value"].values):
            gaps = self.gaps_at(step)
            widest = max(gaps, key=lambda gap: gap["upper_hz"] - gap["lower_hz"], default=None)
            edges = (widest["lower_hz"], widest["upper_hz"]) if widest else None
            count = "failed" if step in self.failed else str(len(gaps))
            rows.append((float(value), count, *((edges[1] - edges[0], *edges) if edges else (None,) * 3)))
        return Table(
            "sweep",
            (Column(data.attrs["expression"], "" if unit == "1" else unit), "gaps",
             *(Column(name, "Hz", "kHz", ".2f") for name in ("widest", "from", "to"))),
            rows,
        )  # fmt: skip

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        data = self.dataset
        designs = [
            {"value": float(value), "gaps": self.gaps_at(step), "error": self.failed.get(step)}
            for step, value in enumerate(data["value"].values)
        ]
        return {"vary": data.attrs["expression"], "unit": data["value"].attrs["units"], "designs": designs}


@dataclass(frozen=True, eq=False, repr=False)
class Sweeps(Result):
    """Complete gaps along all rows of designs that a study describes."""

    title = "Parameter sweeps"

    rows: tuple[Sweep, ...]

    @property
    def dataset(self) -> xr.Dataset:
        """All rows, one behind the other along ``sweep``; shorter ones are filled up with NaN."""
        data = [one.dataset for one in self.rows]
        names = [one.attrs["expression"] for one in data]
        joined = xr.concat(data, "sweep", combine_attrs="drop_conflicts", join="outer")
        return joined.assign_coords(expression=("sweep", names))

    def summary(self) -> list[str]:
        said = []
        for one in self.rows:
            gaps = [(gap, step) for step in range(one.dataset.sizes["step"]) for gap in one.gaps_at(step)]
            name, count = one.dataset.attrs["expression"], one.dataset.sizes["step"]
            if not gaps:
                said.append(f"No design along {name} has a complete gap.")
                continue
            best, step = max(gaps, key=lambda pair: pair[0]["upper_hz"] - pair[0]["lower_hz"])
            value = format_quantity(float(one.dataset["value"][step]), one.dataset["value"].attrs["units"])
            said.append(
                f"Along {name}, the widest complete gap of {count} designs is at {value}: "
                f"{best['lower_hz'] / 1e3:.2f} to {best['upper_hz'] / 1e3:.2f} kHz."
            )
        return said

    def tables(self) -> list[Table]:
        return [one.table() for one in self.rows]

    def remarks(self) -> list[str]:
        return [
            f"design {step + 1} of the sweep was left out: {error['cause']} ({error['argument']})"
            for one in self.rows
            for step, error in one.failed.items()
        ]

    @figure("sweep_*")
    def _drawn(self) -> dict[str, Callable[[], Figure]]:
        return {f"sweep_{k}": one.plot for k, one in enumerate(self.rows, start=1)}

    @file("sweep_*.nc")
    def _written(self) -> dict[str, Writer]:
        return {
            f"sweep_{k}.nc": partial(write_netcdf, one.dataset) for k, one in enumerate(self.rows, start=1)
        }

    def to_json(self) -> dict[str, Any]:
        return {"sweeps": [one.to_json() for one in self.rows]}


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
    settings: BandSettings,
    *,
    inputs: Mapping[str, Any],
    runner: Runner,
) -> Sweeps:
    """Complete gaps of rows of designs, kept one by one in the store as they are finished.

    Parameters
    ----------
    inputs : plain values of what was asked, for the results' attributes
    runner : computes all rows as one
    """
    tasks = [
        Task({"kind": "gaps", "cell": cell, "settings": settings}, (cell, settings))
        for row in rows
        for cell in row.cells
    ]
    outcomes = iter(runner.tried(design_gaps, tasks, 0))
    return Sweeps(tuple(_sweep(row, [next(outcomes) for _ in row.cells], inputs) for row in rows))


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
    declared(
        dataset,
        **dict.fromkeys(table, "no further gap"),
        searched_up_to="the design could not be computed",
        **dict.fromkeys(("euler_bernoulli", "timoshenko"), "no formula for this pillar"),
    )
    dataset["value"].attrs = {"units": labels["units"] or "1", "long_name": labels["expression"]}
    dataset.attrs = {name: value for name, value in labels.items() if name != "units" and value is not None}
    failed = {step: o.error.parts() for step, o in enumerate(outcomes) if o.error is not None}
    return Sweep(stamped(dataset, inputs), failed)


def _cantilever(cell: UnitCell) -> tuple[np.ndarray, np.ndarray]:
    if cell.pillar is None or not isinstance(cell.material, IsotropicMaterial):
        return np.full(RESONANCES, np.nan), np.full(RESONANCES, np.nan)
    slender = np.full(RESONANCES, np.nan)
    if cell.pillar.is_cylinder:  # equation (3) knows no other
        slender = euler_bernoulli(cell.pillar, cell.material)
    return slender, timoshenko(cell.pillar, cell.material, RESONANCES)
