"""Waveguides of a length in cells between two mirrors, and their numbers as a labelled dataset."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.bloch.evanescent import bloch_waves
from haptonic.bloch.gaps import Gap
from haptonic.bloch.guide import Guide, GuidedMode, Wall, along_strip, strip_mode
from haptonic.bloch.layers import Interface
from haptonic.bloch.rows import CondensedRows
from haptonic.bloch.settings import WaveguideSettings
from haptonic.cell import Rows
from haptonic.errors import StudyError
from haptonic.later import xarray as xr

INSET = 1e-3  # of the gap's width, kept away from its edges


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


def strip_of(
    lattice: CondensedRows,
    gap: Gap,
    carrier: float,
    waveguide: WaveguideSettings,
    rows: int,
    closed_by: CondensedRows | None,
) -> Strip:
    """The waveguide so many cells long whose mode is at the carrier (Hz), or that of the width asked for.

    Parameters
    ----------
    gap : that holds the carrier; closed_by : rows at the ends, which are free without them
    """
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
    return Strip(
        rows=rows, length=length, mode=found, fixed_line=wall.fixed_line, decay=lattice.decay(into_lattice)
    )


def strips_dataset(strips: Sequence[Strip]) -> xr.Dataset:
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
