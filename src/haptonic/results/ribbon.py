"""Waves along a ribbon: its projected bands, and the modes that its guide, its edge or a defect holds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.plots.text import uncertain_hertz
from haptonic.results.result import Result, figure
from haptonic.results.table import Column, Table
from haptonic.units import hz_text

MOST_TOLD = 40  # modes in the table, those nearest to the middle of the gap
HIDING = 0.1  # of the range, from which errors are said to hide modes: these lie between errors of bulk bands
MOST = 0.5  # share of the energy from which a mode belongs to the guide more than to what is around it
COLUMNS = (
    Column("frequency", shown="kHz", form=".4f", error="frequency_error"),
    Column("phase / pi", form=".4f", of="phase_share"),
    Column("wavenumber", form=".1f"),
    Column("nodal lines across", form=".0f", of="nodal_lines"),
    Column("intervals along", form=".0f", of="intervals"),
    Column("group velocity", form=".0f", of="group_velocity"),
    Column("in the guide", shown="%", form=".1f", of="guide_share"),
    Column("decay", form=".1f"),
)
# what a defect's modes have not
ALONG = ("wavenumber", "nodal lines across", "intervals along", "group velocity")


@dataclass(frozen=True, eq=False, repr=False)
class RibbonWaves(Result):
    """All modes of a ribbon within a range of frequencies; ``dataset`` holds them on dimension ``mode``."""

    title = "Ribbon"
    data_file = "ribbon"

    dataset: xr.Dataset

    @property
    def guided(self) -> xr.Dataset:
        """Those between the bulk bands with more energy in the guide than at the outer edges."""
        found = self.dataset.drop_dims(["node", "triangle"], errors="ignore")
        found = found.isel(mode=np.flatnonzero(found["guided"].values))
        return found.isel(mode=np.argsort(found["frequency"].values))

    @property
    def best(self) -> xr.Dataset | None:
        """Of `guided` the mode nearest to the `target`, if possible with most of its energy there."""
        found = self.guided
        if not found.sizes["mode"]:
            return None
        most = np.flatnonzero(found["guide_share"].values >= MOST)
        found = found.isel(mode=most) if len(most) else found
        return found.isel(mode=int(np.abs(found["frequency"].values - self.target).argmin()))

    @property
    def target(self) -> float:
        """Hz, the carrier if it lies in the range, else the middle of this."""
        low, high = self.dataset.attrs["range_hz"]
        carrier = self.dataset.attrs.get("carrier_hz", 0.0)
        return float(carrier if low < carrier < high else 0.5 * (low + high))

    def summary(self) -> list[str]:
        found = self.guided
        low, high = self.dataset.attrs["range_hz"]
        where = f"from {hz_text(low, high, form='.4g')}"
        best = self.best
        if best is None:
            largest = float(self.dataset["frequency_error"].values.max(initial=0.0))
            unsure = f" Errors of up to {hz_text(largest, form='.2g')} may hide one: ask for more accuracy."
            none = f"The ribbon holds no wave between the bulk bands {where}."
            return [none + unsure if largest > HIDING * (high - low) else none]
        kind = f"The {self.dataset.attrs['kind']}"
        intervals = float(best["intervals"])
        across = float(best["nodal_lines"])
        name = f"{across:.0f}x{intervals:.0f}, " if np.isfinite(intervals) and np.isfinite(across) else ""
        fading = float(best["decay"])
        near, speed, inside = (float(best[name]) for name in ("frequency", "group_velocity", "guide_share"))
        fades = f", and it fades by {fading:.1f} dB per row" if np.isfinite(fading) else ""
        return [
            self._of_defect(where)
            or f"{kind} holds {found.sizes['mode']} modes between the bulk bands {where}, at "
            f"{self.dataset.sizes['wavevector']} wavevectors.",
            f"Nearest to {hz_text(self.target, form='.4g')}: "
            f"{uncertain_hertz(near, float(best['frequency_error']))} ({name}phase "
            f"{float(best['phase_share']):.3f} pi per period): {inside:.0%} of its energy "
            f"is there{fades}; group velocity {speed:.0f} m/s.",
            *self._of_copies(near),
        ]

    def _of_defect(self, where: str) -> str:
        """Modes that have most of their energy in a defect, where copies of it are in phase."""
        found = self.guided
        most = (found["phase"].values == 0) & (found["guide_share"].values >= MOST)
        if self.dataset.attrs["kind"] != "defect" or not most.any():
            return ""
        at = ", ".join(f"{one / 1e3:.2f}" for one in found["frequency"].values[most])
        return f"The defect holds {at} kHz between the bulk bands {where}, with most of their energy in it."

    def _of_copies(self, near: float) -> list[str]:
        """What the repetition of a defect whose mode is at a frequency (Hz) changes, and what damps it."""
        lines = self.dataset.sizes["line"]
        if self.dataset.attrs["kind"] != "defect":
            return []
        found = self.guided
        apart = np.abs(found["frequency"].values - near)
        nearest = [apart[found["phase"].values == phase].min() for phase in np.unique(found["phase"].values)]
        losses = np.atleast_1d(self.dataset.attrs["loss_factor"])
        damped = ""
        if losses.max() > 0:
            least = "" if len(losses) == 1 else "at least "
            damped = f"; losses of the material limit its quality to {least}{1 / losses.max():.0f}"
        return [f"Copies of it {lines} cells apart move it by {hz_text(max(nearest), form='.2g')}{damped}."]

    def tables(self) -> list[Table]:
        found = self.guided
        near = np.sort(np.argsort(np.abs(found["frequency"].values - self.target))[:MOST_TOLD])
        rows = self.dataset.attrs["rows"]
        what = f"resonances of a guide {rows} cells long with free ends" if rows else "modes that are held"
        left = found.sizes["mode"] - len(near)
        more = f"; {left} farther from {hz_text(self.target, form='.4g')} are in the file" if left else ""
        columns = [one for one in COLUMNS if one.name not in ALONG or self.dataset.attrs["kind"] != "defect"]
        return [Table.of(f"{what}{more}", found.isel(mode=near), "mode", columns)]

    @figure(
        "ribbon",
        "Simulated projected bands of the ribbon. Bulk bands of the crystals are shaded, for all phases "
        "across; dashes are modes of the ribbon, their slope the group velocity, their colour the share of "
        "energy in the guide or at the edge.",
    )
    def _projected(self, *, ax: Axes | None = None) -> Figure:
        return plots.projected(self.dataset, ax=ax)

    @figure(
        "field",
        "Simulated field of one mode that is held, on the flat face, at the moment when it is largest.",
        when=lambda result: "field_real" in result.dataset,
    )
    def _field(self, *, ax: Axes | None = None) -> Figure:
        return plots.ribbon_field(self.dataset, ax=ax)

    def facts(self) -> dict[str, Any]:
        found = self.guided
        return {"guided": found[[name for name in found if found[name].dims == ("mode",)]]}
