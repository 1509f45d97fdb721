"""Complete gaps along rows of designs."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr

from haptonic import plots
from haptonic.bloch import gaps_dataset
from haptonic.cell import UnitCell
from haptonic.cell.cantilever import euler_bernoulli, timoshenko
from haptonic.gate import declared
from haptonic.jobs import Outcome, Task, run_all
from haptonic.materials import IsotropicMaterial
from haptonic.results.common import Asked, stamped
from haptonic.store import Store

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
        Task({"kind": "gaps", "cell": cell, "asked": asked}, (cell, asked))
        for row in rows
        for cell in row.cells
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


def design_gaps(design: tuple[UnitCell, Asked]) -> xr.Dataset:
    """Complete gaps of one design; what a worker is given to do."""
    cell, asked = design
    found: xr.Dataset = gaps_dataset(
        cell, count=asked.count, accuracy=asked.accuracy, resolution=asked.resolution
    )
    return found


def _cantilever(cell: UnitCell) -> tuple[np.ndarray, np.ndarray]:
    if cell.pillar is None or not isinstance(cell.material, IsotropicMaterial):
        return np.full(RESONANCES, np.nan), np.full(RESONANCES, np.nan)
    slender = np.full(RESONANCES, np.nan)
    if cell.pillar.is_cylinder:  # equation (3) knows no other
        slender = euler_bernoulli(cell.pillar, cell.material)
    return slender, timoshenko(cell.pillar, cell.material, RESONANCES)
