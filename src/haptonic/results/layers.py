"""What a mirror of a few rows lets through, and how waves fade in the lattice."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from haptonic import plots
from haptonic.bloch import Gap, Resolution
from haptonic.bloch.evanescent import Slab, bloch_waves, decibels
from haptonic.bloch.gaps import gap_at, widest_gap
from haptonic.bloch.layers import OUTGOING, Scattering
from haptonic.bloch.mirrors import (
    GOALS,
    MOST_ROWS,
    Incidence,
    condensed_cell,
    first_reaching,
    mirror_dataset,
    scattering_at,
)
from haptonic.bloch.model import bloch_model
from haptonic.bloch.plate_waves import FAMILIES
from haptonic.bloch.settings import BandSettings, LayersSettings
from haptonic.cell import UnitCell
from haptonic.errors import StudyError
from haptonic.gate import WORD
from haptonic.jobs import Task
from haptonic.results.common import no_nan, stamped
from haptonic.results.result import Result, figure
from haptonic.results.runner import Runner
from haptonic.results.table import Table
from haptonic.superelement import Superelement
from haptonic.units import format_quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

LEAST_SHARE = 1e-30  # of the energy
CHUNK = 12  # frequencies of one task


@dataclass(frozen=True, eq=False, repr=False)
class Layers(Result):
    """Complex band structure and transmission of a mirror.

    gap : that holds the carrier, or else the widest; None if there is none
    dataset : the spectra, and energies at the carrier for many rows
    """

    title = "Mirror"
    data_file = "layers"

    gap: Gap | None
    dataset: xr.Dataset

    @property
    def incidence(self) -> str:
        """The angle of incidence in words."""
        angle = np.degrees(float(self.dataset.attrs["angle"]))
        return "at normal incidence" if angle == 0 else f"at {angle:.3g}° from the normal"

    @property
    def families(self) -> list[str]:
        """Kinds of plate waves that propagate towards the rows at the carrier."""
        there = np.isfinite(self.dataset["carrier_transmitted"].isel(many=0, outgoing=0))
        return [str(family) for family in self.dataset["incident"].values[there]]

    def needed(self, family: str) -> dict[float, int | None]:
        """Rows from which the insulation stays at each of the goals (dB); None if `MOST_ROWS` do not do."""
        return {goal: first_reaching(self.insulation(family), goal) for goal in GOALS}

    def dissipated(self, family: str) -> Array:
        """(rows,) share of the energy of an incident wave at the carrier that the rows turn into heat."""
        at_carrier = self.dataset["carrier_transmitted"] + self.dataset["carrier_reflected"]
        return np.asarray(1 - at_carrier.sel(incident=family).sum("outgoing").values)

    def same_wave(self, family: str) -> Array:
        """(rows,) transmitted energy of the incident kind alone at the carrier, dB below the incident one."""
        share = self.dataset["carrier_transmitted"].sel(incident=family, outgoing=family).values
        return _decibels(share)

    @property
    def carrier(self) -> float:
        """Hz."""
        return float(self.dataset.attrs["carrier_hz"])

    @figure("layers", "Simulated energy that rows of cells let through between two plain plates.")
    def _layers(self) -> Figure:
        return plots.layers(self.dataset)

    @figure(
        "decay",
        "Simulated complex band structure across the rows (left, middle), and decay per cell of the wave "
        "that reaches farthest, for several phases along the rows (right).",
    )
    def _decay(self) -> Figure:
        return plots.decay(self.dataset)

    def summary(self) -> list[str]:
        decay, rows = float(self.dataset.attrs["carrier_attenuation_db"]), self.dataset.sizes["rows"]
        passed = [
            f"incident {family}: {rows} rows let "
            f"{-self.insulation(family)[rows - 1]:.0f} dB through at the carrier"
            for family in self.families
        ]
        return [
            f"{'; '.join(passed)}.",
            f"The wave that reaches farthest fades by {decay:.2f} dB per row at the carrier.",
        ]

    def tables(self) -> list[Table]:
        families, counts = self.families, self.dataset["rows"].values
        passed = Table(
            f"transmitted energy at {self.carrier / 1e3:g} kHz {self.incidence}, dB below the incident wave: "
            "all waves, in brackets the same kind alone",
            ("rows", *(f"incident {family}" for family in families)),
            [
                (str(rows), *(f"{self.insulation(f)[k]:.1f} ({self.same_wave(f)[k]:.1f})" for f in families))
                for k, rows in enumerate(counts)
            ],
        )
        needed = {family: self.needed(family) for family in families}
        goals = [f"{goal:g} dB" for goal in GOALS]
        many = f"more than {MOST_ROWS}"
        return [
            passed,
            Table(
                "rows needed: from which on less energy than so many dB below the incident wave passes",
                ("incident", *goals),
                [
                    (family, *(str(n) if n else many for n in found.values()))
                    for family, found in needed.items()
                ],
            ),
        ]

    def insulation(self, family: str) -> Array:
        """(rows,) all transmitted energy at the carrier, dB below the incident one."""
        share = self.dataset["carrier_transmitted"].sel(incident=family).sum("outgoing").values
        return _decibels(share)

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        data = self.dataset
        few = slice(0, data.sizes["rows"])
        return {
            "carrier_hz": self.carrier,
            "gap": None if self.gap is None else {"lower_hz": self.gap.lower, "upper_hz": self.gap.upper},
            "attenuation_db_per_row": float(data.attrs["carrier_attenuation_db"]),
            "energy_balance": float(data.attrs["energy_balance"]),
            "incident": {
                family: {
                    "rows_needed": {f"{goal:g} dB": rows for goal, rows in self.needed(family).items()},
                    "insulation_db": self.insulation(family)[few].tolist(),
                    "same_wave_db": self.same_wave(family)[few].tolist(),
                    "dissipated": self.dissipated(family)[few].tolist(),
                }
                for family in self.families
            },
            "spectrum": {
                "frequency_hz": data["frequency"].values.tolist(),
                "phase_rad": data["phase"].values.tolist(),
                "attenuation_db": data["attenuation"].values.tolist(),
                "transmitted": no_nan(data["transmitted"].sum("outgoing", skipna=False).values),
                "reflected": no_nan(data["reflected"].sum("outgoing", skipna=False).values),
            },
        }


def _decibels(share: Array) -> Array:
    """Below the incident energy; rounding is all that is left below `LEAST_SHARE`."""
    return np.asarray(-10 * np.log10(np.maximum(share, LEAST_SHARE)))


def layer_tasks(points: int) -> int:
    """How many tasks `compute_layers` has."""
    return 1 + -(-points // CHUNK)


@threadpool_limits.wrap(limits=1)  # these matrices are too small for threads inside the linear algebra
def compute_layers(
    cell: UnitCell,
    settings: BandSettings,
    layers: LayersSettings,
    *,
    carrier: float,
    inputs: Mapping[str, Any],
    runner: Runner,
) -> Layers:
    """Spectra of a mirror, a few frequencies at a time, and how many rows it needs at the carrier (Hz).

    Raises
    ------
    StudyError : ends of the spectrum in the wrong order, a cell without a pillar, or no
        wave propagates towards the rows at the carrier
    """
    if cell.pillar is None:
        raise StudyError(
            argument="cell.pillar",
            given="nothing",
            allowed="a cell with a pillar",
            cause="rows of plain plate between two plain plates reflect nothing",
            next_step="add a [cell.pillar] table",
        )
    frequencies = layers.frequencies(carrier)
    incidence = Incidence(layers.angle, layers.count, cell.material.loss_factor)
    gaps = runner.gaps(cell, settings)
    gap = gap_at(gaps, carrier) or widest_gap(gaps)
    resolution = bloch_model(cell, settings.count, settings.accuracy, settings.resolution).resolution
    chunks = np.array_split(frequencies, layer_tasks(layers.points) - 1)
    fixed = {"incidence": incidence, "cell": cell, "resolution": resolution}
    tasks = [
        Task(
            {"kind": "mirror", "frequency": chunk, **fixed},
            (cell, resolution, chunk, incidence),
        )
        for chunk in chunks
    ]
    pieces = runner.run(_chunk_dataset, tasks, 1)
    spectrum = xr.concat(pieces, "frequency", data_vars="minimal", coords="minimal")
    superelement = condensed_cell(cell, resolution)
    found = _at_carrier(superelement, carrier, incidence)
    lossless = _at_carrier(superelement, carrier, replace(incidence, loss_factor=0.0))
    dataset = spectrum.merge(_carrier_dataset(found))
    omega = 2 * np.pi * carrier
    waves, _ = bloch_waves(Slab.of(superelement, 0.0).at(omega), omega)
    dataset.attrs = {
        "carrier_hz": carrier,
        "carrier_attenuation_db": decibels(waves),
        "energy_balance": max(float(np.abs(one.dissipated).max()) for one in lossless.values()),
        "angle": incidence.angle,
        "loss_factor": incidence.loss_factor,
        "gap": [gap.lower, gap.upper] if gap else [],
        "mesh": json.dumps(asdict(superelement.mesh.topology.plan)),
    }
    return Layers(gap, stamped(dataset, inputs))


def _at_carrier(superelement: Superelement, carrier: float, incidence: Incidence) -> dict[str, Scattering]:
    """Energies for many rows at the carrier, by family of the incident wave."""
    found = {}
    for family in FAMILIES:
        one = scattering_at(superelement, carrier, family, replace(incidence, layers=MOST_ROWS))
        if one is not None:
            found[family] = one
    if not found:
        raise StudyError(
            argument="layers.angle",
            given=f"{np.degrees(incidence.angle):g} deg at {format_quantity(carrier, 'Hz')}",
            allowed="an angle at which some plate wave propagates towards the rows",
            cause="all of them only fade",
            next_step="give a smaller angle",
        )
    return found


def _carrier_dataset(found: Mapping[str, Scattering]) -> xr.Dataset:
    """Energies at the carrier for 1, 2, ... many rows; NaN for families that do not propagate."""
    shape = len(FAMILIES), MOST_ROWS, len(OUTGOING)
    arrays, silent = {}, {WORD: "the incident wave does not propagate"}
    for name in ("transmitted", "reflected"):
        values = np.full(shape, np.nan)
        for family, scattering in found.items():
            values[FAMILIES.index(family)] = getattr(scattering, name)[:, 0]
        arrays[f"carrier_{name}"] = ("incident", "many", "outgoing"), values, {"units": "1", **silent}
    coords = {"many": np.arange(1, MOST_ROWS + 1), "incident": list(FAMILIES), "outgoing": list(OUTGOING)}
    return xr.Dataset(arrays, coords=coords)


def _chunk_dataset(argument: tuple[UnitCell, Resolution, Array, Incidence]) -> xr.Dataset:
    """Spectra at a few frequencies; what a worker is given to do."""
    cell, resolution, frequency, incidence = argument
    found: xr.Dataset = mirror_dataset(condensed_cell(cell, resolution), frequency, incidence)
    return found
