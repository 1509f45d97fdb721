"""Waveguides that fit between two mirrors."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.bloch.evanescent import bloch_waves
from haptonic.bloch.gaps import need_gap_at
from haptonic.bloch.guide import Guide, GuidedMode, Wall, along_strip, strip_mode
from haptonic.bloch.layers import Interface, plain_plate
from haptonic.bloch.mirrors import condensed_rows
from haptonic.bloch.model import bloch_model
from haptonic.bloch.rows import CondensedRows
from haptonic.bloch.settings import BandSettings, WaveguideSettings
from haptonic.cell import Rows, UnitCell
from haptonic.errors import StudyError
from haptonic.later import Axes, Figure
from haptonic.later import xarray as xr
from haptonic.parallel import one_thread
from haptonic.results.common import stamped
from haptonic.results.plain import split
from haptonic.results.result import Result, figure
from haptonic.results.runner import Runner
from haptonic.results.table import Column, Table

INSET = 1e-3  # of the gap's width, kept away from its edges
COLUMNS = (
    Column("width", shown="mm", form=".2f"), Column("length", shown="mm", form=".1f"),
    Column("cells", of="rows"), Column("frequency", shown="kHz", form=".3f"),
    Column("nodal spacing", shown="mm", form=".3f", of="nodal_spacing"),
    Column("edge / peak", form=".3f", of="amplitude_at_edge"),
    Column("fixed line", shown="mm", form=".2f", of="fixed_line"), Column("decay", form=".1f"),
)  # fmt: skip
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
        title = (
            f"waveguides for mode {self.across}x{self.along}: nodal lines across, intervals between nodal "
            f"lines along; {self.ends} ends"
        )
        return [Table.of(title, self.dataset, "waveguide", COLUMNS, [self.strips.index(self.best)])]

    @figure("waveguide", "Simulated mode across the waveguide.")
    def _across(self, *, ax: Axes | None = None) -> Figure:
        best, mode = self.best, self.best.mode
        return plots.guide(mode.position, mode.amplitude, mode.at_edge, mode.width, best.fixed_line, ax=ax)

    def facts(self) -> dict[str, Any]:
        found = split(self.dataset, "waveguide")
        return {"waveguides": found, "nearest": found[self.strips.index(self.best)]}


@one_thread()
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
    resolution = bloch_model(cell, settings).resolution
    lattice = condensed_rows(cell, resolution, waveguide.direction)
    closed_by = None
    if waveguide.ends == "mirror":
        closed_by = condensed_rows(cell, resolution, closing(lattice.rows))
    across, along = waveguide.nodal_lines
    period = lattice.rows.period
    wavenumber = plain_plate(lattice).wavenumber(2 * np.pi * carrier, 0.0, "A0")
    assert wavenumber is not None
    shortest = max(1, int((along + 0.5) * np.pi / (wavenumber * period)))
    lengths = [waveguide.rows] if waveguide.rows else range(shortest, shortest + MOST_LENGTHS + 1)
    strips, refusal = [], None
    for count in lengths:
        try:
            strips.append(_strip(lattice, gap, carrier, waveguide, count, closed_by))
        except StudyError as error:
            refusal = error
    if not strips:
        assert refusal is not None
        raise refusal
    dataset = _dataset(strips).assign_attrs(
        carrier_hz=carrier, mode=f"{across}x{along}", ends=waveguide.ends,
        mesh=json.dumps(asdict(lattice.plan)),
    )  # fmt: skip
    return Guides(carrier, gap, across, along, waveguide.ends, tuple(strips), stamped(dataset, inputs))


def closing(rows: Rows) -> tuple[int, int]:
    """The direction of the rows that close a strip beside others.

    Raises
    ------
    StudyError : there are none
    """
    found = rows.crossing
    if found is None:
        raise StudyError.unsupported(
            argument="waveguide.ends",
            given="mirror",
            allowed="a lattice that has rows at right angles to the strip, or free ends",
            cause=f"no few translations lead at a right angle to {list(rows.along)}",
            next_step='write ends = "free", or another direction along',
        )
    return found


def _dataset(strips: Sequence[Strip]) -> xr.Dataset:
    """A number of each waveguide, and the amplitude across it."""
    numbers = {
        "width": ("m", [one.mode.width for one in strips]),
        "rows": ("1", [one.rows for one in strips]),
        "length": ("m", [one.length for one in strips]),
        "frequency": ("Hz", [one.frequency for one in strips]),
        "nodal_spacing": ("m", [one.spacing for one in strips]),
        "amplitude_at_edge": ("1", [one.mode.at_edge for one in strips]),
        "fixed_line": ("m", [one.fixed_line for one in strips]),
        "decay": ("dB/row", [one.decay for one in strips]),
    }
    return xr.Dataset(
        {name: ("waveguide", values, {"units": unit}) for name, (unit, values) in numbers.items()}
    )


def _strip(
    lattice: CondensedRows,
    gap: Gap,
    carrier: float,
    waveguide: WaveguideSettings,
    rows: int,
    closed_by: CondensedRows | None,
) -> Strip:
    omega, length = 2 * np.pi * carrier, rows * lattice.rows.period
    (across, along), width = waveguide.nodal_lines, waveguide.width
    if width is None:
        wavenumber = along_strip(omega, length, along, closed_by)
        found = Guide.of(lattice, wavenumber).mode_at(omega, across)
    else:
        inside = INSET * (gap.upper - gap.lower)
        between = 2 * np.pi * (gap.lower + inside), 2 * np.pi * (gap.upper - inside)
        found = strip_mode(
            lattice, width=width, length=length, intervals=along, nodal_lines=across, between=between,
            closed_by=closed_by,
        )  # fmt: skip
    interface = Interface.of(lattice, found.wavenumber)
    wall = Wall.of(interface, found.omega)
    assert wall is not None
    into_lattice, _ = bloch_waves(interface.slab.at(found.omega), found.omega)
    return Strip(rows, length, found, wall.fixed_line, lattice.decay(into_lattice))
