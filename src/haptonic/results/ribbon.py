"""Waves along a ribbon: its projected bands, and the modes of its guide, edge, defect or strip."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.names import counted
from haptonic.plots.text import uncertain_hertz
from haptonic.results.result import Result, figure, page
from haptonic.results.ribbon_view import ribbon_view
from haptonic.results.table import Column, Table
from haptonic.units import hz_text, in_percent, uncertain
from haptonic.views import InteractiveView

MOST_TOLD = 40  # modes in the table, those nearest to the middle of the gap
HIDING = 0.1  # of the range; larger errors may hide modes, because these lie between errors of bulk bands
MOST = 0.5  # of the energy; with a larger share a mode belongs to the guide
COLUMNS = (
    Column("frequency", shown="kHz", form=".4f", error="frequency_error"),
    Column("phase / pi", form=".4f", of="phase_share"),
    Column("wavenumber", form=".1f"),
    Column("nodal lines across", form=".0f", of="nodal_lines"),
    Column("intervals along", form=".0f", of="intervals"),
    Column("group velocity", form=".0f", of="group_velocity", error="group_velocity_error"),
    Column("in the guide", shown="%", form=".1f", of="guide_share"),
    Column("decay", form=".1f", error="decay_error"),
)
# columns without meaning for a kind of ribbon
OMITTED = {
    "defect": ("wavenumber", "nodal lines across", "intervals along", "group velocity"),
    "strip": ("nodal lines across", "in the guide", "decay"),
}
AT_EDGES = Column("in the outermost columns", shown="%", form=".1f", of="guide_share")


@dataclass(frozen=True, eq=False, repr=False)
class RibbonWaves(Result):
    """All modes of a ribbon within a range of frequencies, on dimension ``mode`` of ``dataset``."""

    title = "Ribbon"
    data_file = "ribbon"

    dataset: xr.Dataset

    @property
    def guided(self) -> xr.Dataset:
        """Modes between the bulk bands with more energy in the guide than at the outer edges, or all of a
        strip."""
        modes = self.dataset.drop_dims(["node", "triangle", "across"], errors="ignore")
        modes = modes.isel(mode=np.flatnonzero(modes["guided"].values))
        return modes.isel(mode=np.argsort(modes["frequency"].values))

    @property
    def best(self) -> xr.Dataset | None:
        """The mode of `guided` nearest to the `target`, if possible with most of its energy in the guide.

        Any mode of a strip, because it has no guide.
        """
        modes = self.guided
        if not modes.sizes["mode"]:
            return None
        inside = np.arange(0) if self.is_strip else np.flatnonzero(modes["guide_share"].values >= MOST)
        modes = modes.isel(mode=inside) if len(inside) else modes
        return modes.isel(mode=int(np.abs(modes["frequency"].values - self.target).argmin()))

    @property
    def target(self) -> float:
        """The carrier if it lies in the range, or else the middle of the range, Hz."""
        low, high = self.dataset.attrs["range_hz"]
        carrier = self.dataset.attrs.get("carrier_hz", 0.0)
        return float(carrier if low < carrier < high else 0.5 * (low + high))

    @property
    def is_strip(self) -> bool:
        """True for a strip that is crystal up to its free edges."""
        return bool(self.dataset.attrs["kind"] == "strip")

    @property
    def stop_band(self) -> tuple[float, float] | None:
        """Widest interval of the range without a wave, Hz; None if waves cover the range.

        Each mode covers its error, and its slope times half of the distance to the next phase. This covers
        straight bands, and the maxima of quadratic ones between two phases.
        """
        data = self.dataset
        low, high = data.attrs["range_hz"]
        step = float(np.diff(data["wavevector_phase"].values).max(initial=0.0)) or np.pi
        slope = np.abs(data["group_velocity"].values) / (2 * np.pi * data.attrs["period"])
        reach = data["frequency_error"].values + 0.5 * step * slope
        order = np.argsort(data["frequency"].values - reach)
        frequency, reach = data["frequency"].values[order], reach[order]
        starts = np.maximum.accumulate(np.concatenate([[low], frequency + reach]))
        ends = np.concatenate([frequency - reach, [high]])
        widest = int((ends - starts).argmax())
        return (float(starts[widest]), float(ends[widest])) if ends[widest] > starts[widest] else None

    def summary(self) -> list[str]:
        modes = self.guided
        low, high = self.dataset.attrs["range_hz"]
        where = f"from {hz_text(low, high, form='.4g')}"
        best = self.best
        if best is None and self.is_strip:
            return [f"The strip has no wave {where}."]
        if best is None:
            largest = float(self.dataset["frequency_error"].values.max(initial=0.0))
            unsure = f" Errors of up to {hz_text(largest, form='.2g')} may hide one: increase the accuracy."
            none = (
                f"No wave of the {self.dataset.attrs['kind']} lies outside of the bulk bands in the searched "
                f"range {where}."
            )
            return [none + unsure if largest > HIDING * (high - low) else none, *self._of_outer_edges()]
        kind = f"The {self.dataset.attrs['kind']}"
        intervals = float(best["intervals"])
        across = float(best["nodal_lines"])
        name = f"{across:.0f}x{intervals:.0f}, " if np.isfinite(intervals) and np.isfinite(across) else ""
        decay, speed = (
            uncertain(float(best[name]), float(best[f"{name}_error"])) for name in ("decay", "group_velocity")
        )
        near, inside = (float(best[name]) for name in ("frequency", "guide_share"))
        decays = f", and it decays by {decay} dB per row" if np.isfinite(best["decay"]) else ""
        there = "outermost columns" if self.is_strip else f"{self.dataset.attrs['kind']}"
        return [
            self._of_strip(where)
            or self._of_defect(where)
            or f"{kind} has {counted(modes.sizes['mode'], 'mode')} outside of the bulk bands at "
            f"{self.dataset.sizes['wavevector']} wavevectors together, in the searched range {where}.",
            f"Nearest to {hz_text(self.target, form='.4g')}{self._among(near)}: "
            f"{uncertain_hertz(near, float(best['frequency_error']))} ({name}phase "
            f"{float(best['phase_share']):.3f} π per period): {in_percent(inside)} of its energy "
            f"is in the {there}{decays}; group velocity {speed} m/s.",
            *self._of_copies(near),
            *self._of_outer_edges(),
        ]

    def _among(self, near: float) -> str:
        """Which modes `best` was selected from, if one of the others is nearer to the target."""
        nearest = np.abs(self.guided["frequency"].values - self.target).min()
        if self.is_strip or nearest >= abs(near - self.target):
            return ""
        return f" of the modes with at least half of their energy in the {self.dataset.attrs['kind']}"

    def _of_strip(self, where: str) -> str:
        """Sentences on the waves of a strip, and on its widest interval without one."""
        if not self.is_strip:
            return ""
        sizes = self.dataset.sizes
        count = f"The strip has {sizes['mode']} waves {where}, at {sizes['wavevector']} wavevectors"
        apart = int(self.dataset["in_gap"].values.sum())
        bulk = f", {apart} of them between the bulk bands of its crystal" if sizes["crystal"] else ""
        gap = self.stop_band
        none = f" It has no wave from {hz_text(*gap, form='.4g')}." if gap else ""
        return f"{count}{bulk}.{none}"

    def _of_defect(self, where: str) -> str:
        """Sentence on modes with most of their energy in a defect, for copies of it in phase."""
        modes = self.guided
        most = (modes["phase"].values == 0) & (modes["guide_share"].values >= MOST)
        if self.dataset.attrs["kind"] != "defect" or not most.any():
            return ""
        at = ", ".join(f"{frequency / 1e3:.2f}" for frequency in modes["frequency"].values[most])
        return (
            f"Modes of the defect between the bulk bands {where}, with most of their energy in it: {at} kHz."
        )

    def _of_outer_edges(self) -> list[str]:
        """Sentence on modes outside of the bulk bands that are not those of the guide."""
        apart = int((self.dataset["in_gap"].values > self.dataset["guided"].values).sum())
        if self.is_strip or not apart:
            return []
        verb = "runs" if apart == 1 else "run"
        return [
            f"{counted(apart, 'wave')} outside of the bulk bands {verb} along the ribbon's outer edges, and "
            f"{'is' if apart == 1 else 'are'} in no table."
        ]

    def _of_copies(self, near: float) -> list[str]:
        """Sentence on the effect of a defect's copies on its mode at a frequency (Hz), and on its damping."""
        lines = self.dataset.sizes["line"]
        if self.dataset.attrs["kind"] != "defect":
            return []
        modes = self.guided
        apart = np.abs(modes["frequency"].values - near)
        nearest = [apart[modes["phase"].values == phase].min() for phase in np.unique(modes["phase"].values)]
        losses = np.atleast_1d(self.dataset.attrs["loss_factor"])
        damped = ""
        if losses.max() > 0:
            least = "" if len(losses) == 1 else "at least "
            damped = f"; losses of the material limit its quality to {least}{1 / losses.max():.0f}"
        return [
            f"The mode moves by up to {hz_text(max(nearest), form='.2g')} with the phase between copies of "
            f"the defect, {lines} cells apart{damped}."
        ]

    def tables(self) -> list[Table]:
        modes = self.guided
        near = np.sort(np.argsort(np.abs(modes["frequency"].values - self.target))[:MOST_TOLD])
        rows = self.dataset.attrs["rows"]
        kind = self.dataset.attrs["kind"]
        what, modes_of = ("strip", "waves of the strip") if self.is_strip else ("guide", "guided modes")
        title = f"resonances of a {what} {rows} cells long with free ends" if rows else modes_of
        left = modes.sizes["mode"] - len(near)
        more = f"; {left} farther from {hz_text(self.target, form='.4g')} are in the file" if left else ""
        columns = [column for column in COLUMNS if column.name not in OMITTED.get(kind, ())]
        columns += [AT_EDGES] * self.is_strip
        return [Table.of(f"{title}{more}", modes.isel(mode=near), "mode", columns)]

    @figure(
        "ribbon",
        "Simulated projected bands of the ribbon. Bulk bands of the crystals are shaded, for all phases "
        "across; dashes are modes of the ribbon, their slope the group velocity, their colour the share of "
        "energy in the guide, at the edge or in the outermost columns of a strip.",
    )
    def _projected(self, *, ax: Axes | None = None) -> Figure:
        return plots.projected(self.dataset, ax=ax)

    @figure(
        "field",
        "Simulated field of one guided mode on the flat face, at the moment of its largest displacement.",
        when=lambda result: "field_real" in result.dataset,
    )
    def _field(self, *, ax: Axes | None = None) -> Figure:
        return plots.ribbon_field(self.dataset, ax=ax)

    _page = page("ribbon.html", when=lambda result: "mode_real" in result.dataset)

    def view(self) -> InteractiveView:
        """Interactive view of the projected bands; its modes move if their fields were computed."""
        return ribbon_view(self.dataset, self.title, self.summary())

    def facts(self) -> dict[str, Any]:
        modes = self.guided
        return {"guided": modes[[name for name in modes if modes[name].dims == ("mode",)]]}
