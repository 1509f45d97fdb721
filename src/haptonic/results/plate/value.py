"""Vibration of a finite plate: response over a band, localisation, energies, impedance, modes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from haptonic.arrays import Complex
from haptonic.bloch import Gap
from haptonic.later import xarray as xr
from haptonic.plate import Plate
from haptonic.plate.layout.sampling import driven_region, reference_of
from haptonic.plate.vibration.datasets import part_name
from haptonic.plate.vibration.region_measures import below_finger, contrasts, resonance_of
from haptonic.response import FrequencyResponse, rms
from haptonic.response.measures import along
from haptonic.results.plain import split
from haptonic.results.plan import border_text
from haptonic.results.plate.drawing import PRODUCTS
from haptonic.results.plate.interactive import plate_view
from haptonic.results.plate.tables import carriers_table, lines_table, modes_table, power_table
from haptonic.results.result import Result
from haptonic.results.table import Table
from haptonic.units import hz_text
from haptonic.views import InteractiveView

# Measured in tests/plate/test_full_plate.py; no cheap estimate for an arbitrary plate is known.
ERRORS = (
    "This bounds the error of solving the plate's equations. The discretisation error is not estimated for "
    "this plate. Another plate, 4 x 3 cells with a guide and a patch, was also computed in full: the "
    "frequencies here were 0.01 to 0.05 % high, and the field differed by 0.9 % in the energy norm at a "
    "resonance and by 1 to 3 % half-way between two resonances."
)

OF_FILES = (
    " The error of the meshes of cells from files is not estimated either; `haptonic bands` does, for bands."
)


@dataclass(frozen=True, eq=False)
class CarrierAnswer:
    """Vibration at one of several carriers (Hz), with only the drives that have it.

    around : gap at the carrier of each lattice beside the driven regions, by name
    """

    carrier: float
    around: Mapping[str, Gap | None]
    result: PlateResult

    @property
    def drives(self) -> list[str]:
        """Names of the active drives."""
        return [drive.name for drive in self.result.plate.drives if drive.amplitude]

    @property
    def contrasts(self) -> dict[str, float]:
        """Level of the driven region over each of the others, and over all the rest, dB."""
        levels = self.result.contrasts(self.result.at_maps)
        return {pair: float(level[0]) for pair, level in levels.items()}

    @property
    def least_contrast(self) -> tuple[str, float] | None:
        """Smallest contrast of the driven region, dB, with the names of both; None without a region."""
        return min(self.contrasts.items(), key=lambda pair: pair[1], default=None)

    def facts(self) -> dict[str, Any]:
        """Values for JSON."""
        gaps = {name: gap.edges if gap else None for name, gap in self.around.items()}
        return {
            "carrier_hz": self.carrier, "drives": self.drives, "driven": self.result.driven, "gaps_hz": gaps,
            "contrast_db": self.contrasts,
        }  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False)
class PlateResult(Result, products=PRODUCTS):
    """Response of a plate per unit of its reference, with energies, impedances and modes.

    plate : the computed plate; gap : of its lattice around the carrier, if any; carrier : Hz
    gaps : edges of all complete gaps that the lattices beside the driven region share, Hz
    response : velocity of the flat face; marked : response at the frequencies of the maps, at finer points
    at_maps : response at these frequencies, at the points of ``response``
    lines : dataset on the response's frequencies; modes : dataset of the modes near the carrier
    body : displacement of the whole plate at the carrier, on a coarse mesh
    answers : for each carrier, if the drives have several; everything else is for the study's carrier
    interactive : whether the interactive page is among its files
    """

    title = "Plate"
    data_file = "plate"

    plate: Plate
    gap: Gap | None
    carrier: float
    response: FrequencyResponse
    marked: FrequencyResponse
    at_maps: FrequencyResponse
    lines: xr.Dataset
    modes: xr.Dataset
    body: xr.Dataset
    answers: tuple[CarrierAnswer, ...] = ()
    interactive: bool = False
    gaps: tuple[tuple[float, float], ...] = ()

    @property
    def driven(self) -> str | None:
        """Region of plain plate with the first actuator, or else with the first force."""
        return driven_region(self.plate)

    def contrasts(self, response: FrequencyResponse) -> dict[str, xr.DataArray]:
        """Level of the driven region over each of the others, and over all the rest, dB."""
        return contrasts(response, self.driven)

    @cached_property
    def levels(self) -> dict[str, xr.DataArray]:
        """Root mean square velocity of every region, in the units of the response."""
        return {name: rms(self.response, name) for name in self.response.regions if name}

    @property
    def dataset(self) -> xr.Dataset:
        """Energies, powers, impedances and errors against frequency."""
        return self.lines

    @property
    def datasets(self) -> tuple[xr.Dataset, ...]:
        return self.lines, self.response.dataset, self.marked.dataset, self.modes

    @property
    def drive(self) -> float:
        """Amplitude of the first drive, used in pictures, in the unit of the reference."""
        return reference_of(self.plate)[1]

    def view(self) -> InteractiveView | None:
        """Interactive view of the response; None if it was not asked for."""
        return plate_view(self) if self.interactive else None

    def summary(self) -> list[str]:
        line = self.maps.sel(frequency=self.resonance)
        levels = [f"{name} {level:.1f} dB" for name, level in split(line.get("contrast"), "pair").items()]
        where = hz_text(self.resonance, form=".3f")
        if self.gap and self.resonance != self.carrier:
            where = f"the strongest resonance in the gap near the carrier, {where}"
        contrast = f"Contrast at {where}: {'; '.join(levels)}."
        basis = int(self.lines.attrs["basis"])
        method = f", solved on {basis} vectors" if basis else ", solved at each frequency"
        return [
            *([contrast] if levels else []),
            *border_text(self.plate.layout),
            f"Largest solver error of the field: {float(self.lines['solver_error'].max()):.1e}, of "
            f"{self.lines.attrs['unknowns']} unknowns{method}; it excludes the discretisation. Simulated.",
        ]

    @property
    def errors(self) -> str:
        """Meaning of the solver error, and the errors that it does not include."""
        return ERRORS + OF_FILES * any(cell.solid for cell in self.plate.layout.cells.values())

    def remarks(self) -> list[str]:
        if not self.plate.rigid:
            return []
        count = self.plate.rigid_modes
        return [f"the plate has no support: {count} rigid-body motions are free; they are included"]

    def tables(self) -> list[Table]:
        tables = [*carriers_table(self.answers), lines_table(self), power_table(self)]
        return [*tables, modes_table(self.modes)] if self.modes.sizes["mode"] else tables

    @property
    def gap_edges(self) -> tuple[float, float] | None:
        return self.gap.edges if self.gap else None

    def impedance(self, actuator: str) -> Complex:
        """(frequency of ``lines``,) voltage over current of an actuator with all drives active, ohm."""
        lines = self.lines.sel(actuator=actuator)
        return np.asarray(lines["impedance_real"].values + 1j * lines["impedance_imag"].values)

    @property
    def resonance(self) -> float:
        """Frequency of the map in the gap, or else of the map nearest to the carrier, Hz."""
        return resonance_of(self.marked.frequency, self.carrier, self.gap_edges)

    @cached_property
    def maps(self) -> xr.Dataset:
        """All quantities at the frequencies of the maps; see `reported`."""
        return self.reported(self.at_maps)

    def reported(self, response: FrequencyResponse) -> xr.Dataset:
        """Quantities at the frequencies of the response or the maps: energies, powers, impedances, and

        ``rms`` (region) : velocity; ``contrast`` (pair) : dB of the driven region over others
        ``finger`` (region) : largest amplitude below a finger, per unit of the reference
        """
        lines = self.lines.sel(frequency=response.frequency, method="nearest")
        data = lines.assign_coords(frequency=("frequency", response.frequency, {"units": "Hz"}))
        if names := [name for name in response.regions if name]:
            data["rms"] = along({name: rms(response, name) for name in names}, "region")
            data["finger"] = along(below_finger(response), "region")
        if levels := self.contrasts(response):
            data["contrast"] = along(levels, "pair")
        parts = data["impedance_real"], data["impedance_imag"]
        data["impedance"] = (parts[0] + 1j * parts[1]).assign_attrs(units="ohm")
        return data.drop_vars(["impedance_real", "impedance_imag"])

    def _guide_modes(self) -> dict[str, dict[str, float]]:
        """By region and name, the frequency (Hz) of the mode with most of its energy there."""
        modes, frequencies = self.modes, dict[str, dict[str, float]]()
        names, frequency = modes["name"].values.tolist(), modes["frequency"].values
        for region in self.plate.layout.regions:
            share = modes["strain_energy"].sel(part=part_name(self.plate, region)).values
            best = {name: max((k for k, n in enumerate(names) if n == name), key=share.__getitem__)
                    for name in names if name}  # fmt: skip
            frequencies[region] = {name: float(frequency[k]) for name, k in best.items()}
        return frequencies

    def facts(self) -> dict[str, Any]:
        return {
            "reference": self.response.dataset.attrs["reference"],
            "carrier_hz": self.carrier,
            "gap_hz": self.gap_edges,
            "driven": self.driven,
            "pillars": self.plate.layout.pillars,
            "resonance_hz": self.resonance,
            "largest_solver_error": float(self.lines["solver_error"].max()),
            "maps": split(self.maps, "frequency"),
            "modes": split(self.modes.drop_dims("point"), "mode"),
            "guide_modes": self._guide_modes(),
            **({"carriers": [answer.facts() for answer in self.answers]} if self.answers else {}),
        }
