"""Width, length and frequency of waveguides between two mirrors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.bloch.waveguides import Strip
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.results.guides_view import guides_view
from haptonic.results.plain import split
from haptonic.results.result import Result, figure, page
from haptonic.results.table import Column, Table
from haptonic.units import hz_text, in_percent, uncertain
from haptonic.views import InteractiveView

COLUMNS = (
    Column("width", shown="mm", form=".2f"), Column("length", shown="mm", form=".1f"),
    Column("cells", of="rows"), Column("frequency", shown="kHz", form=".3f"),
    Column("nodal spacing", shown="mm", form=".3f", of="nodal_spacing"),
    Column("edge / peak", form=".3f", of="amplitude_at_edge"),
    Column("fixed line", shown="mm", form=".2f", of="fixed_line"),
    Column("decay", form=".1f", error="decay_error"),
)  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False)
class Guides(Result):
    """Waveguides between two mirrors; `best` is the one whose mode is nearest to the carrier.

    gap : the gap that contains the carrier (Hz); across, along : nodal lines and intervals of the mode
    dataset : numbers of each waveguide, on dimension ``waveguide``
    """

    title = "Waveguide"
    data_file = "waveguide"

    carrier: float
    gap: Gap
    across: int
    along: int
    ends: str
    strips: tuple[Strip, ...]
    dataset: xr.Dataset

    @property
    def best(self) -> Strip:
        """Waveguide nearest to the carrier; among equal ones that with the lowest amplitude at its edge."""
        return min(self.strips, key=lambda s: (round(abs(s.frequency / self.carrier - 1), 6), s.mode.at_edge))

    def summary(self) -> list[str]:
        best = self.best
        return [
            f"Mode {self.across}x{self.along} lies at {hz_text(best.frequency, form='.3f')} in a waveguide "
            f"{best.mode.width * 1e3:.2f} mm wide and {best.length * 1e3:.1f} mm long between two mirrors.",
            f"Its amplitude at the edge of the lattice is {in_percent(best.mode.at_edge)} of its peak; in "
            f"the lattice it decays by {uncertain(best.decay, best.decay_error)} dB per row.",
        ]

    def tables(self) -> list[Table]:
        title = (
            f"waveguides for mode {self.across}x{self.along}: nodal lines across, intervals between nodal "
            f"lines along; {self.ends} ends"
        )
        return [Table.of(title, self.dataset, "waveguide", COLUMNS, [self.strips.index(self.best)])]

    @figure("waveguide", "Simulated mode across the waveguide.")
    def _across(self, *, ax: Axes | None = None) -> Figure:
        best, mode = self.best, self.best.mode
        title = f"mode {self.across}x{self.along} at {hz_text(best.frequency, form='.2f')}"
        return plots.guide(
            mode.position, mode.amplitude, mode.at_edge, mode.width, best.fixed_line, ax=ax, title=title,
            lattice=self._profile(),
        )  # fmt: skip

    def _profile(self) -> tuple[Array, Array] | None:
        """Positions across the `best` waveguide and its lattices, m, and the amplitude there, its peak 1.

        The amplitude is the root mean square over a period. None if the fields were not computed.
        """
        if "mode_real" not in self.dataset:
            return None
        field = self.dataset[["mode_real", "mode_imag"]].isel(waveguide=self.strips.index(self.best))
        squared = (field["mode_real"] ** 2 + field["mode_imag"] ** 2).mean("along").values
        return self.dataset["across"].values, np.sqrt(squared / squared.max())

    _page = page("waveguide.html", when=lambda result: "mode_real" in result.dataset)

    def remarks(self) -> list[str]:
        if self.dataset.attrs["equal_sides"]:
            return []
        return [
            "the crystals on the two sides of the strip are not mirror images, and no half turn maps one "
            "onto the other: the width is the mean of those of two strips with equal sides, and no page "
            "shows the wave; `haptonic ribbon` draws it"
        ]

    def view(self) -> InteractiveView | None:
        """Interactive view of the waveguides; None if the fields of their modes were not computed."""
        if "mode_real" not in self.dataset:
            return None
        return guides_view(self.dataset, self.title, self.summary(), self.strips.index(self.best))

    def facts(self) -> dict[str, Any]:
        numbers = self.dataset[[name for name in self.dataset if self.dataset[name].dims == ("waveguide",)]]
        waveguides = split(numbers, "waveguide")
        return {"waveguides": waveguides, "nearest": waveguides[self.strips.index(self.best)]}
