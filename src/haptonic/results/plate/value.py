"""Vibration of a finite plate: response over a band, localisation, energies, impedance, modes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from pathlib import Path
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.arrays import Complex
from haptonic.bloch import Gap
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.names import file_parts
from haptonic.plate import Plate
from haptonic.plate.layout.sampling import driven_region, reference_of
from haptonic.plate.vibration.datasets import part_name
from haptonic.plate.vibration.region_measures import below_finger, compared, contrasts, resonance_of
from haptonic.response import FrequencyResponse, rms, write
from haptonic.response.measures import along
from haptonic.results.common import write_netcdf
from haptonic.results.plain import split
from haptonic.results.plan import border_text
from haptonic.results.plate.interactive import plate_view
from haptonic.results.plate.tables import carriers_table, lines_table, modes_table, power_table
from haptonic.results.result import Result, figure, file
from haptonic.results.table import Table
from haptonic.units import hz_text
from haptonic.views import InteractiveView, write_page
from haptonic.vtu import write_body

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


def _has_spectrum(result: PlateResult) -> bool:
    return len(result.response.frequency) > 1


def _compares(result: PlateResult) -> bool:
    return _has_spectrum(result) and bool(compared(result.response, result.driven))


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
        levels = self.result.contrasts(self.result.marked)
        return {pair: float(level[0]) for pair, level in levels.items()}

    @property
    def least_contrast(self) -> tuple[str, float] | None:
        """Smallest contrast of the driven region, dB, with the names of both; None without a region."""
        return min(self.contrasts.items(), key=lambda pair: pair[1], default=None)

    def facts(self) -> dict[str, Any]:
        """Values for JSON."""
        gaps = {name: gap and (gap.lower, gap.upper) for name, gap in self.around.items()}
        return {
            "carrier_hz": self.carrier, "drives": self.drives, "driven": self.result.driven, "gaps_hz": gaps,
            "contrast_db": self.contrasts,
        }  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False)
class PlateResult(Result):
    """Response of a plate per unit of its reference, with energies, impedances and modes.

    plate : the computed plate; gap : of its lattice around the carrier, if any; carrier : Hz
    response : velocity of the flat face; marked : response at the frequencies of the maps
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
    lines: xr.Dataset
    modes: xr.Dataset
    body: xr.Dataset
    answers: tuple[CarrierAnswer, ...] = ()
    interactive: bool = False

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
    def _origin(self) -> str:
        return str(self.response.dataset.attrs["origin"])

    @figure("plan", "Simulated plate: its pillars, regions, actuators and supports.")
    def _plan(self, *, ax: Axes | None = None) -> Figure:
        return plots.plate_plan(self.plate, ax=ax)

    @property
    def drive(self) -> float:
        """Amplitude of the first drive, used in pictures, in the unit of the reference."""
        return reference_of(self.plate)[1]

    @figure("maps", "Simulated normal displacement of the flat face, all maps on one scale.")
    def _maps(self, *, frequency: float | None = None, ax: Axes | None = None) -> Figure:
        layout, drive = self.plate.layout, self.drive
        gap = None if self.answers else self._gap_edges  # lattices of several carriers have different gaps
        shown, lines = self.marked, self.marked.frequency.tolist()
        if frequency is not None:
            shown, lines = self.response, [frequency]
        if ax is not None:
            return plots.map_at(shown, frequency or self.resonance, layout, gap, drive=drive, ax=ax)
        return plots.maps(shown, lines, layout, gap, drive=drive)

    @figure(
        "carriers",
        "Simulated normal displacement of the flat face at each carrier, with its own drives alone.",
        when=lambda result: result.answers,
    )
    def _carriers(self) -> Figure:
        alone = [(" and ".join(answer.drives), answer.result) for answer in self.answers]
        driven = {drives: (each.marked, each.drive, each._gap_edges) for drives, each in alone}
        return plots.maps_of_drives(driven, self.plate.layout)

    @figure("velocity", "Simulated velocity of the regions.", when=_has_spectrum)
    def _velocity(self, *, ax: Axes | None = None) -> Figure:
        levels = {name: level.values for name, level in self.levels.items()}
        return plots.velocity_spectrum(
            self.response.frequency, levels, self._gap_edges, units=self.response.units, drive=self.drive,
            carrier=self.carrier, origin=self._origin, ax=ax,
        )  # fmt: skip

    @figure("contrast", "Simulated contrast of the driven region.", when=_compares)
    def _contrast(self, *, ax: Axes | None = None) -> Figure:
        curves = {name: level.values for name, level in self.contrasts(self.response).items()}
        lines = self.response.frequency
        return plots.contrast_spectrum(
            lines, curves, self._gap_edges, carrier=self.carrier, origin=self._origin, ax=ax
        )

    @figure(
        "impedance-*",
        "Simulated conductance and capacitance of a driven actuator, which give its electrical impedance.",
        when=_has_spectrum,
    )
    def _impedances(self) -> dict[str, Callable[[], Figure]]:
        return {
            name: partial(self._impedance, actuator)
            for actuator, name in impedance_names(self.plate).items()
            if self.impedance(actuator).any()
        }

    def _impedance(self, actuator: str) -> Figure:
        lines, values = self.lines["frequency"].values, self.impedance(actuator)
        return plots.impedance_spectrum(lines, values, self._gap_edges, origin=self._origin)

    @file("response.nc")
    def _write_response(self, path: Path) -> None:
        write(self.response, path)

    @file("maps.nc")
    def _write_maps(self, path: Path) -> None:
        write(self.marked, path)

    @file("modes.nc")
    def _write_modes(self, path: Path) -> None:
        write_netcdf(self.modes, path)

    @file("plate.vtu")
    def _write_body(self, path: Path) -> None:
        write_body(path, self.body)

    @file("plate.html", when=lambda result: result.interactive)
    def _write_page(self, path: Path) -> None:
        write_page(self.view(), path)

    def view(self) -> InteractiveView | None:
        """Interactive view of the response; None if it was not asked for."""
        return plate_view(self) if self.interactive else None

    @file("carrier.webp")
    def _animate(self, path: Path) -> None:
        content = plots.animated(self.marked, self.resonance, self.plate.layout, drive=self.drive)
        path.write_bytes(content)

    def summary(self) -> list[str]:
        line = self.maps.sel(frequency=self.resonance)
        levels = [f"{name} {level:.1f} dB" for name, level in split(line.get("contrast"), "pair").items()]
        contrast = f"Contrast at {hz_text(self.resonance, form='.3f')}: {'; '.join(levels)}."
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
        return [f"the plate has no support: {self.plate.rigid_modes} rigid-body motions are free"]

    def tables(self) -> list[Table]:
        tables = [*carriers_table(self.answers), lines_table(self), power_table(self)]
        return [*tables, modes_table(self.modes)] if self.modes.sizes["mode"] else tables

    @property
    def _gap_edges(self) -> tuple[float, float] | None:
        return (self.gap.lower, self.gap.upper) if self.gap else None

    def impedance(self, actuator: str) -> Complex:
        """(frequency of ``lines``,) voltage over current of an actuator with all drives active, ohm."""
        lines = self.lines.sel(actuator=actuator)
        return np.asarray(lines["impedance_real"].values + 1j * lines["impedance_imag"].values)

    @property
    def resonance(self) -> float:
        """Frequency of the map in the gap, or else of the map nearest to the carrier, Hz."""
        return resonance_of(self.marked.frequency, self.carrier, self._gap_edges)

    @cached_property
    def maps(self) -> xr.Dataset:
        """All quantities at the frequencies of the maps; see `reported`."""
        return self.reported(self.marked)

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
            "gap_hz": self._gap_edges,
            "driven": self.driven,
            "pillars": self.plate.layout.pillars,
            "resonance_hz": self.resonance,
            "largest_solver_error": float(self.lines["solver_error"].max()),
            "maps": split(self.maps, "frequency"),
            "modes": split(self.modes.drop_dims("point"), "mode"),
            "guide_modes": self._guide_modes(),
            **({"carriers": [answer.facts() for answer in self.answers]} if self.answers else {}),
        }


def impedance_names(plate: Plate) -> dict[str, str]:
    """Name of the picture of each actuator's impedance."""
    parts = file_parts(actuator.name for actuator in plate.actuators)
    return {name: f"impedance-{part}" for name, part in parts.items()}
