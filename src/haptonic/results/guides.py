"""Waveguides that fit between two mirrors."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from threadpoolctl import threadpool_limits

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.bloch.evanescent import bloch_waves, decibels
from haptonic.bloch.gaps import need_gap_at
from haptonic.bloch.guide import Guide, GuidedMode, Wall, along_strip, strip_mode
from haptonic.bloch.layers import Interface
from haptonic.bloch.model import bloch_model
from haptonic.bloch.plate_waves import PlainPlate
from haptonic.bloch.settings import BandSettings, WaveguideSettings
from haptonic.cell import UnitCell
from haptonic.errors import StudyError
from haptonic.results.common import stamped
from haptonic.results.result import Result, figure
from haptonic.results.runner import Runner
from haptonic.results.table import Column, Table
from haptonic.superelement import Superelement

if TYPE_CHECKING:
    from matplotlib.figure import Figure

INSET = 1e-3  # of the gap's width, kept away from its edges
MOST_LENGTHS = 6  # of waveguides that are compared


@dataclass(frozen=True)
class Strip:
    """A waveguide that was computed.

    rows : its length in cells; length : m; mode : across and along it
    fixed_line : how far inside the lattice the plate seems to be held, m
    decay : of the mode in the lattice, dB per row
    """

    rows: int
    length: float
    mode: GuidedMode
    fixed_line: float
    decay: float

    @property
    def frequency(self) -> float:
        """Hz."""
        return self.mode.omega / (2 * np.pi)

    @property
    def spacing(self) -> float:
        """Between nodal lines along the strip, m."""
        return float(np.pi / self.mode.wavenumber)

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        return {
            "width_m": self.mode.width,
            "rows": self.rows,
            "length_m": self.length,
            "frequency_hz": self.frequency,
            "nodal_spacing_m": self.spacing,
            "amplitude_at_edge": self.mode.at_edge,
            "fixed_line_m": self.fixed_line,
            "decay_db_per_row": self.decay,
        }


@dataclass(frozen=True, eq=False, repr=False)
class Guides(Result):
    """Waveguides between two mirrors, and the one whose mode lies nearest to the carrier.

    gap : that holds the carrier (Hz); across, along : nodal lines and intervals of the mode
    dataset : a number of each waveguide, on dimension ``waveguide``
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
        """Nearest to the carrier; of those at the carrier the one with the lowest amplitude at its edge."""
        return min(self.strips, key=lambda s: (round(abs(s.frequency / self.carrier - 1), 6), s.mode.at_edge))

    def summary(self) -> list[str]:
        best = self.best
        return [
            f"Mode {self.across}x{self.along} lies at {best.frequency / 1e3:.3f} kHz in a waveguide "
            f"{best.mode.width * 1e3:.2f} mm wide and {best.length * 1e3:.1f} mm long between two mirrors.",
            f"Its amplitude falls to {best.mode.at_edge:.0%} of its peak at the lattice, and there by "
            f"{best.decay:.1f} dB per row.",
        ]

    def tables(self) -> list[Table]:
        columns = (
            Column("width", "m", "mm", ".2f"), Column("length", "m", "mm", ".1f"), Column("cells"),
            Column("frequency", "Hz", "kHz", ".3f"), Column("nodal spacing", "m", "mm", ".3f"),
            Column("edge / peak", form=".3f"), Column("fixed line", "m", "mm", ".2f"),
            Column("dB per row", form=".1f"),
        )  # fmt: skip
        rows = [
            (one.mode.width, one.length, one.rows, one.frequency, one.spacing, one.mode.at_edge,
             one.fixed_line, one.decay)
            for one in self.strips
        ]  # fmt: skip
        title = (
            f"waveguides for mode {self.across}x{self.along}: nodal lines across, intervals between nodal "
            f"lines along; {self.ends} ends"
        )
        return [Table(title, columns, rows, [self.strips.index(self.best)])]

    @figure("waveguide", "Simulated mode across the waveguide.")
    def _across(self) -> Figure:
        best = self.best
        return plots.guide(best.mode.position, best.mode.amplitude, best.mode.width, best.fixed_line)

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        return {
            "mode": f"{self.across}x{self.along}",
            "ends": self.ends,
            "carrier_hz": self.carrier,
            "waveguides": [strip.to_json() for strip in self.strips],
            "nearest": self.best.to_json(),
        }


@threadpool_limits.wrap(limits=1)  # these matrices are too small for threads inside the linear algebra
def compute_guides(
    cell: UnitCell,
    settings: BandSettings,
    waveguide: WaveguideSettings,
    *,
    carrier: float,
    inputs: Mapping[str, Any],
    runner: Runner,
) -> Guides:
    """Waveguides whose mode lies in the gap around the carrier (Hz).

    Parameters
    ----------
    inputs : plain values of what was asked, for the result's attributes

    Raises
    ------
    StudyError : no complete gap around the carrier, or no such waveguide
    """
    gap = need_gap_at(runner.gaps(cell, settings), carrier)
    superelement = bloch_model(cell, settings.count, settings.accuracy, settings.resolution).fine.superelement
    across, along = waveguide.nodal_lines
    period = float(np.linalg.norm(cell.lattice.vectors[1]))
    plate = PlainPlate.of(cell, superelement.levels)
    wavenumber = plate.wavenumber(2 * np.pi * carrier, 0.0, "A0")
    assert wavenumber is not None
    shortest = max(1, int((along + 0.5) * np.pi / (wavenumber * period)))
    lengths = [waveguide.rows] if waveguide.rows else range(shortest, shortest + MOST_LENGTHS + 1)
    strips, refusal = [], None
    for count in lengths:
        try:
            strips.append(_strip(superelement, gap, carrier, waveguide, count, period))
        except StudyError as error:
            refusal = error
    if not strips:
        assert refusal is not None
        raise refusal
    dataset = _dataset(strips).assign_attrs(
        carrier_hz=carrier, mode=f"{across}x{along}", ends=waveguide.ends,
        mesh=json.dumps(asdict(superelement.mesh.topology.plan)),
    )  # fmt: skip
    return Guides(carrier, gap, across, along, waveguide.ends, tuple(strips), stamped(dataset, inputs))


def _dataset(strips: Sequence[Strip]) -> xr.Dataset:
    """A number of each waveguide, and the amplitude across it."""
    units = {"width": "m", "rows": "1", "length": "m", "frequency": "Hz", "nodal_spacing": "m",
             "amplitude_at_edge": "1", "fixed_line": "m", "decay": "dB/row"}  # fmt: skip
    columns = zip(*(one.to_json().values() for one in strips), strict=True)
    named = zip(units.items(), columns, strict=True)
    return xr.Dataset(
        {name: ("waveguide", np.array(column), {"units": unit}) for (name, unit), column in named}
    )


def _strip(
    superelement: Superelement,
    gap: Gap,
    carrier: float,
    waveguide: WaveguideSettings,
    rows: int,
    period: float,
) -> Strip:
    omega, length = 2 * np.pi * carrier, rows * period
    (across, along), width, ends = waveguide.nodal_lines, waveguide.width, waveguide.ends
    if width is None:
        wavenumber = along_strip(superelement, omega, length, along, ends)
        found = Guide.of(superelement, wavenumber).mode_at(omega, across)
    else:
        inside = INSET * (gap.upper - gap.lower)
        between = 2 * np.pi * (gap.lower + inside), 2 * np.pi * (gap.upper - inside)
        found = strip_mode(
            superelement, width=width, length=length, intervals=along, nodal_lines=across, between=between,
            ends=ends,
        )  # fmt: skip
    interface = Interface.of(superelement, found.wavenumber)
    wall = Wall.of(interface, found.omega)
    assert wall is not None
    into_lattice, _ = bloch_waves(interface.slab.at(found.omega), found.omega)
    return Strip(rows, length, found, wall.fixed_line, decibels(into_lattice))
