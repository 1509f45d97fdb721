"""What a mirror of a few rows lets through, and how waves fade in the lattice."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.arrays import Array
from haptonic.bloch import Gap, Resolution
from haptonic.bloch.evanescent import bloch_waves
from haptonic.bloch.gaps import gap_at, widest_gap
from haptonic.bloch.layers import OUTGOING, Scattering
from haptonic.bloch.mirrors import (
    GOALS,
    MOST_ROWS,
    Incidence,
    condensed_rows,
    first_reaching,
    mirror_dataset,
    scattering_at,
)
from haptonic.bloch.model import bloch_model
from haptonic.bloch.plate_waves import FAMILIES
from haptonic.bloch.rows import CondensedRows
from haptonic.bloch.settings import BandSettings, LayersSettings
from haptonic.cell import UnitCell
from haptonic.errors import StudyError
from haptonic.gate import WORD
from haptonic.jobs import Task
from haptonic.later import Axes, Figure
from haptonic.later import xarray as xr
from haptonic.parallel import one_thread
from haptonic.results.common import stamped
from haptonic.results.plain import plain, split
from haptonic.results.result import Result, figure
from haptonic.results.runner import Runner
from haptonic.results.table import Column, Table
from haptonic.units import format_quantity

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
        """The angle of incidence in words, and the direction of the rows unless it is the usual one."""
        angle = np.degrees(float(self.dataset.attrs["angle"]))
        along = [int(one) for one in self.dataset.attrs["along"]]
        rows = "" if along == [0, 1] else f" of rows along {along}"
        return f"at normal incidence{rows}" if angle == 0 else f"at {angle:.3g}° from the normal{rows}"

    @property
    def families(self) -> list[str]:
        """Kinds of plate waves that propagate towards the rows at the carrier."""
        there = np.isfinite(self.dataset["carrier_transmitted"].isel(many=0, outgoing=0))
        return [str(family) for family in self.dataset["incident"].values[there]]

    def needed(self, family: str) -> dict[float, int | None]:
        """Rows from which the insulation stays at each of the goals (dB); None if `MOST_ROWS` do not do."""
        return {goal: first_reaching(self.insulation(family), goal) for goal in GOALS}

    @cached_property
    def at_carrier(self) -> xr.Dataset:
        """(incident, rows) what many rows do at the carrier to each kind of wave that propagates there.

        ``insulation`` : all transmitted energy, dB below the incident one; ``same_wave`` : that of the
        incident kind alone; ``dissipated`` : share of the incident energy that the rows turn into heat
        """
        names = ["carrier_transmitted", "carrier_reflected"]
        data = self.dataset[names].sel(incident=self.families).rename(many="rows")
        passed, left = data[names[0]], data[names[0]] + data[names[1]]
        alike = xr.DataArray(self.families, dims="incident")
        return xr.Dataset(
            {
                "insulation": _decibels(passed.sum("outgoing")),
                "same_wave": _decibels(passed.sel(outgoing=alike).drop_vars("outgoing")),
                "dissipated": 1 - left.sum("outgoing"),
            }
        )

    @property
    def few_rows(self) -> xr.Dataset:
        """The same of as many rows as the spectra are for."""
        return self.at_carrier.isel(rows=slice(self.dataset.sizes["rows"]))

    @property
    def carrier(self) -> float:
        """Hz."""
        return float(self.dataset.attrs["carrier_hz"])

    @figure("layers", "Simulated energy that rows of cells let through between two plain plates.")
    def _layers(self, *, incident: str | None = None, ax: Axes | None = None) -> Figure:
        return plots.layers(self.dataset, incident=incident, ax=ax)

    @figure(
        "decay",
        "Simulated complex band structure across the rows (left, middle), and decay per row of the wave "
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
        passed = Table.of(
            f"transmitted energy at {self.carrier / 1e3:g} kHz {self.incidence}, dB below the incident wave: "
            "all waves, then the same kind alone",
            self.few_rows,
            "rows",
            (
                "rows",
                Column("incident {}", form=".1f", of="insulation"),
                Column("{} alone", form=".1f", of="same_wave"),
            ),
        )
        most = f"more than {MOST_ROWS}"
        needed = Table(
            "rows needed: from which on less energy than so many dB below the incident wave passes",
            ("incident", *(f"{goal:g} dB" for goal in GOALS)),
            [(name, *(n or most for n in self.needed(name).values())) for name in self.families],
        )
        return [passed, needed]

    def insulation(self, family: str) -> Array:
        """(rows,) all transmitted energy at the carrier, dB below the incident one."""
        return np.asarray(self.at_carrier["insulation"].sel(incident=family).values)

    def facts(self) -> dict[str, Any]:
        data = self.dataset
        spectrum = data[["attenuation"]].assign(
            {
                name: data[name].sum("outgoing", skipna=False, keep_attrs=True)
                for name in ("transmitted", "reflected")
            }
        )
        return {
            "gap": self.gap,
            "incident": {
                name: {
                    "rows_needed": {f"{goal:g} dB": n for goal, n in self.needed(name).items()},
                    **plain(one),
                }
                for name, one in split(self.few_rows, "incident").items()
            },
            "spectrum": spectrum,
        }


def _decibels(share: xr.DataArray) -> xr.DataArray:
    """Below the incident energy; rounding is all that is left below `LEAST_SHARE`."""
    return xr.DataArray(-10 * np.log10(share.clip(min=LEAST_SHARE))).assign_attrs(units="dB")


@one_thread()
def compute_layers(
    cell: UnitCell,
    settings: BandSettings,
    layers: LayersSettings,
    *,
    carrier: float,
    inputs: Mapping[str, Any],
    runner: Runner,
) -> Layers:
    """Spectra of a mirror, a few frequencies at a time, and how many rows it needs at the carrier.

    Parameters
    ----------
    layers : the rows and the spectra; carrier : Hz
    inputs : plain values of what was asked, for the result's attributes

    Raises
    ------
    StudyError : ends of the spectrum in the wrong order, a cell without a pillar, or no
        wave propagates towards the rows at the carrier
    """
    if not cell.has_pillars:
        raise StudyError.missing(
            argument="cell.pillar",
            allowed="a cell with a pillar",
            cause="rows of plain plate between two plain plates reflect nothing",
            next_step="add a [cell.pillar] table",
        )
    frequencies = layers.frequencies(carrier)
    incidence = Incidence(layers.angle, layers.count, cell.material.loss_factor)
    gaps = runner.gaps(cell, settings)
    gap = gap_at(gaps, carrier) or widest_gap(gaps)
    resolution = bloch_model(cell, settings).resolution
    chunks = np.array_split(frequencies, -(-len(frequencies) // CHUNK))
    along = layers.direction
    fixed = {"incidence": incidence, "cell": cell, "resolution": resolution, "along": along}
    tasks = [
        Task({"kind": "mirror", "frequency": chunk, **fixed}, (cell, resolution, along, chunk, incidence))
        for chunk in chunks
    ]
    pieces = runner.run(_chunk_dataset, tasks, 1)
    spectrum = xr.concat(pieces, "frequency", data_vars="minimal", coords="minimal")
    rows = condensed_rows(cell, resolution, along)
    found = _at_carrier(rows, carrier, incidence)
    lossless = _at_carrier(rows, carrier, replace(incidence, loss_factor=0.0))
    dataset = spectrum.merge(_carrier_dataset(found))
    omega = 2 * np.pi * carrier
    waves, _ = bloch_waves(rows.slab(0.0).at(omega), omega)
    dataset.attrs = {
        "carrier_hz": carrier,
        "carrier_attenuation_db": rows.decay(waves),
        "energy_balance": max(float(np.abs(one.dissipated).max()) for one in lossless.values()),
        "angle": incidence.angle,
        "along": list(along),
        "loss_factor": incidence.loss_factor,
        "gap": [gap.lower, gap.upper] if gap else [],
        "mesh": json.dumps(asdict(rows.plan)),
    }
    return Layers(gap, stamped(dataset, inputs))


def _at_carrier(rows: CondensedRows, carrier: float, incidence: Incidence) -> dict[str, Scattering]:
    """Energies for many rows at the carrier, by family of the incident wave."""
    found = scattering_at(rows, carrier, replace(incidence, layers=MOST_ROWS))
    if not found:
        raise StudyError.no_answer(
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


def _chunk_dataset(
    argument: tuple[UnitCell, Resolution, tuple[int, int], Array, Incidence],
) -> xr.Dataset:
    """Spectra at a few frequencies; what a worker is given to do."""
    cell, resolution, along, frequency, incidence = argument
    found: xr.Dataset = mirror_dataset(condensed_rows(cell, resolution, along), frequency, incidence)
    return found
