"""Waveguides between two mirrors with a length in cells, and their dataset."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.bloch.evanescent import bloch_waves
from haptonic.bloch.gaps import Gap
from haptonic.bloch.guide import Guide, GuidedMode, along_strip, strip_mode
from haptonic.bloch.rows import CondensedRows
from haptonic.bloch.settings import WaveguideSettings
from haptonic.cell import Rows
from haptonic.errors import StudyError
from haptonic.later import xarray as xr

INSET = 1e-3  # share of the gap's width excluded at its edges


@dataclass(frozen=True)
class Strip:
    """Computed waveguide.

    rows : its length in cells; length : m; mode : across and along it
    fixed_line : distance of the equivalent support behind the edge of the lattice, m
    decay : of the mode in the lattice, dB per row; decay_error : estimate of its error
    """

    rows: int
    length: float
    mode: GuidedMode
    fixed_line: float
    decay: float
    decay_error: float

    @property
    def frequency(self) -> float:
        """Frequency of the mode, Hz."""
        return self.mode.omega / (2 * np.pi)

    @property
    def spacing(self) -> float:
        """Distance of nodal lines along the strip, m."""
        return float(np.pi / self.mode.wavenumber)


def closing(rows: Rows) -> tuple[int, int]:
    """Direction of the rows that close the ends of a strip between given rows.

    Raises
    ------
    StudyError : the lattice has no rows at a right angle
    """
    crossing = rows.crossing
    if crossing is None:
        raise StudyError.unsupported(
            argument="waveguide.ends",
            given="mirror",
            allowed="a lattice that has rows at right angles to the strip, or free ends",
            cause=f"no short translation is at a right angle to {list(rows.along)}",
            next_step='write ends = "free", or another direction along',
        )
    return crossing


def strip_of(
    lattice: CondensedRows,
    gap: Gap,
    carrier: float,
    waveguide: WaveguideSettings,
    rows: int,
    closed_by: CondensedRows | None,
    share: float,
    opposite: CondensedRows | None = None,
) -> Strip:
    """Compute the waveguide of a length in cells with its mode at the carrier (Hz), or with a given width.

    The error of the decay is its largest change if the frequencies of the lattice move by their error, and
    in a strip of a given width also the frequency of the mode. The same share of the decay is added, because
    fast decays hardly depend on the frequency. In 54 decays of two lattices on three meshes the difference
    to a finer mesh was at most 0.52 of this estimate; `tests/views/test_guide_page.py` has a few of them.

    Parameters
    ----------
    gap : that contains the carrier; closed_by : rows at the ends, None for free ends
    share : relative error of the lattice's frequencies; opposite : see `Guide.of`
    """
    omega, length = 2 * np.pi * carrier, rows * lattice.rows.period
    (across, along), width = waveguide.nodal_lines, waveguide.width
    if width is None:
        wavenumber = along_strip(omega, length, along, closed_by)
        guided_mode = Guide.of(lattice, wavenumber, opposite).mode_at(omega, across)
    else:
        inside = INSET * (gap.upper - gap.lower)
        between = 2 * np.pi * (gap.lower + inside), 2 * np.pi * (gap.upper - inside)
        guided_mode = strip_mode(
            lattice, width=width, length=length, intervals=along, nodal_lines=across, between=between,
            closed_by=closed_by, opposite=opposite,
        )  # fmt: skip
    guide = Guide.of(lattice, guided_mode.wavenumber, opposite)
    interface = guide.interface
    change = share if width is None else 2 * share  # relative, of the frequency
    decay, *others = (
        lattice.decay(bloch_waves(interface.slab.at(at), at)[0])
        for at in guided_mode.omega * np.array([1.0, 1 - change, 1 + change])
    )
    return Strip(
        rows=rows,
        length=length,
        mode=guided_mode,
        fixed_line=float(np.mean([wall.fixed_line for wall in guide.walls(guided_mode.omega)])),
        decay=decay,
        decay_error=max(abs(other - decay) for other in others) + share * decay,
    )


def strips_dataset(strips: Sequence[Strip]) -> xr.Dataset:
    """Dataset of the sizes, frequencies and decays of waveguides."""
    numbers = {
        "width": ("m", [strip.mode.width for strip in strips]),
        "rows": ("1", [strip.rows for strip in strips]),
        "length": ("m", [strip.length for strip in strips]),
        "frequency": ("Hz", [strip.frequency for strip in strips]),
        "nodal_spacing": ("m", [strip.spacing for strip in strips]),
        "amplitude_at_edge": ("1", [strip.mode.at_edge for strip in strips]),
        "fixed_line": ("m", [strip.fixed_line for strip in strips]),
        "decay": ("dB/row", [strip.decay for strip in strips]),
        "decay_error": ("dB/row", [strip.decay_error for strip in strips]),
    }
    return xr.Dataset(
        {name: ("waveguide", values, {"units": unit}) for name, (unit, values) in numbers.items()}
    )
