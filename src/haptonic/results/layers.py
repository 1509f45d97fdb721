"""Insertion loss of a mirror of a few rows, and decay of waves in the lattice."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.bloch.mirrors import GOALS, MOST_ROWS, first_reaching, passed_by_rows
from haptonic.errors import HaptonicError
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.names import counted
from haptonic.results.layers_view import layers_view
from haptonic.results.plain import plain, split
from haptonic.results.result import Result, figure, page
from haptonic.results.table import Column, Table
from haptonic.units import hz_text, uncertain
from haptonic.views import InteractiveView


@dataclass(frozen=True, eq=False, repr=False)
class Layers(Result):
    """Complex band structure and transmission of a mirror.

    gap : the gap that contains the carrier, or else the widest; None without a gap
    dataset : the spectra, and energies at the carrier for many rows
    interactive : whether the interactive page is among its files
    """

    title = "Mirror"
    data_file = "layers"

    gap: Gap | None
    dataset: xr.Dataset
    interactive: bool = False

    @property
    def incidence(self) -> str:
        """Angle of incidence as text, with the direction of the rows unless it is the usual one."""
        angle = np.degrees(float(self.dataset.attrs["angle"]))
        along = [int(component) for component in self.dataset.attrs["along"]]
        rows = "" if along == [0, 1] else f" of rows along {along}"
        return f"at normal incidence{rows}" if angle == 0 else f"at {angle:.3g}° from the normal{rows}"

    @property
    def families(self) -> list[str]:
        """Kinds of plate waves that propagate towards the rows at the carrier."""
        propagating = np.isfinite(self.dataset["carrier_transmitted"].isel(many=0, outgoing=0))
        return [str(family) for family in self.dataset["incident"].values[propagating]]

    def needed(self, family: str) -> dict[float, int | None]:
        """Number of rows from which the insertion loss exceeds each goal (dB); None if above `MOST_ROWS`."""
        return {goal: first_reaching(self.insulation(family), goal) for goal in GOALS}

    @cached_property
    def at_carrier(self) -> xr.Dataset:
        """(incident, rows) transmission at the carrier; see `haptonic.bloch.mirrors.passed_by_rows`."""
        return passed_by_rows(self.dataset, self.families)

    @property
    def few_rows(self) -> xr.Dataset:
        """`at_carrier` for the numbers of rows in the spectra."""
        return self.at_carrier.isel(rows=slice(self.dataset.sizes["rows"]))

    @property
    def carrier(self) -> float:
        """Carrier frequency, Hz."""
        return float(self.dataset.attrs["carrier_hz"])

    @figure(
        "layers",
        "Simulated energy that rows of cells transmit between two plain plates, against frequency and, at "
        "the carrier, against the number of rows. A curve and a point of one colour have as many rows.",
    )
    def _layers(self, *, incident: str | None = None, ax: Axes | None = None) -> Figure:
        return plots.layers(self.dataset, incident=incident, ax=ax)

    @figure(
        "decay",
        "Simulated decay per row of the slowest-decaying wave, at normal incidence and over all "
        "directions; below it the phase per row of waves that propagate.",
    )
    def _decay(self) -> Figure:
        return plots.decay(self.dataset)

    _page = page("layers.html")

    def view(self) -> InteractiveView:
        """Interactive view of the spectra."""
        return layers_view(self.dataset, self.title, self.summary())

    def summary(self) -> list[str]:
        attributes, rows = self.dataset.attrs, self.dataset.sizes["rows"]
        decay = uncertain(attributes["carrier_attenuation_db"], attributes["carrier_attenuation_error_db"])
        errors = self.dataset["carrier_loss_error"].isel(many=rows - 1)
        losses = [
            f"{family} {uncertain(self.insulation(family)[rows - 1], float(errors.sel(incident=family)))} dB"
            for family in self.families
        ]
        at = f"{hz_text(self.carrier, form='g')} {self.incidence}"
        other = "for comparison, " if attributes["angle"] else ""  # the decay has one angle only
        return [
            f"Insertion loss of {counted(rows, 'row')} at {at}: {', '.join(losses)}.",
            f"In the lattice, {other}the slowest-decaying wave at normal incidence decays by "
            f"{decay} dB per row at the carrier.",
        ]

    def tables(self) -> list[Table]:
        passed = Table.of(
            f"insertion loss at {hz_text(self.carrier, form='g')} {self.incidence}, dB: all transmitted "
            "waves, then only waves of the incident kind",
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
            "rows needed for an insertion loss of at least",
            ("incident", *(f"{goal:g} dB" for goal in GOALS)),
            [(name, *(n or most for n in self.needed(name).values())) for name in self.families],
        )
        return [passed, needed]

    def insulation(self, family: str) -> Array:
        """(rows,) insertion loss at the carrier, dB: incident over all transmitted energy.

        Raises
        ------
        HaptonicError : a wave that does not propagate towards the rows
        """
        if family not in self.families:
            raise HaptonicError.unknown("incident", family, self.families, "no such wave meets the rows")
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
                    **plain(energies),
                }
                for name, energies in split(self.few_rows, "incident").items()
            },
            "spectrum": spectrum,
        }
