"""Computed waves for comparison with a scan: waves of plain plate and guides, and evanescent waves."""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.bloch.candidates import best_model
from haptonic.bloch.guide import Guide
from haptonic.bloch.mirrors import condensed_rows
from haptonic.bloch.plate_waves import PlainPlate
from haptonic.bloch.rows import CondensedRows, attenuation
from haptonic.bloch.settings import BandSettings
from haptonic.cell.directed import along_axis
from haptonic.errors import StudyError
from haptonic.gate import WORD
from haptonic.later import xarray as xr
from haptonic.parallel import one_thread
from haptonic.plate.layout.grid import Layout
from haptonic.vibrometry.guides import Guiding, Mirror
from haptonic.vibrometry.maps.waves import Axis

PLAIN = 41  # frequencies of the plain plate's wave
DECAYS = 33  # frequencies of evanescent waves
PHASES = (0.0, 0.5 * np.pi, np.pi)  # along the rows of the mirror
STEPS = 9  # wavenumbers of a guide's mode
REACH = (0.9, 1.04)  # range of these wavenumbers, over that of the flexural wave in the gap
INSET = 1e-3  # of the gap's width, left out at its edges


@one_thread()
def computed_waves(
    layout: Layout,
    settings: BandSettings,
    span: tuple[float, float],
    gap: Gap | None,
    guides: list[Guiding],
    mirror: Mirror | None,
) -> xr.Dataset:
    """Compute the waves of a plate's parts.

    Parameters
    ----------
    span : lowest and highest frequency, Hz

    Returns
    -------
    ``wavenumber`` (frequency) of A0 in plain plate, rad/m; ``attenuation`` (mirror_frequency, phase), dB per
    row; ``guided_frequency`` and ``guided_wavenumber`` (guide, step), NaN where a guide has no mode
    """
    cell = layout.cells[mirror.name] if mirror else next(iter(layout.cells.values()))
    widths = sorted(
        {(guide.width, guide.along) for guide in guides if mirror and guide.lattice == mirror.name}
    )
    best = best_model(cell, settings)
    resolution = best.model.resolution

    def rows(along: Axis) -> CondensedRows:
        direction = along_axis(cell.lattice, 0 if along == "x" else 1)
        assert direction is not None, "lattices of plates have rows along both axes"
        return condensed_rows(cell, resolution, direction)

    side: Axis = "y" if mirror is not None and mirror.depth == "x" else "x"  # of the mirror's rows
    plain = PlainPlate.of(cell, rows(side).levels)
    low = max(span[0], 1e-3 * span[1])
    frequency = np.linspace(low, span[1], PLAIN)
    wavenumber = [plain.wavenumber(2 * np.pi * f, 0.0, "A0") or np.nan for f in frequency]
    waves = xr.Dataset(
        {
            "wavenumber": (
                "frequency",
                np.array(wavenumber),
                {"units": "rad/m", WORD: "the wave does not propagate"},
            )
        },
        coords={"frequency": ("frequency", frequency, {"units": "Hz"})},
    )
    if mirror is not None:
        around = (
            (low, span[1]) if gap is None else (max(low, 0.85 * gap.lower), min(span[1], 1.15 * gap.upper))
        )
        at = np.linspace(*around, DECAYS)
        decay = attenuation(rows(side), 2 * np.pi * at, np.array(PHASES))
        waves["attenuation"] = ("mirror_frequency", "phase"), decay, {"units": "dB/row"}
        waves = waves.assign_coords(
            mirror_frequency=("mirror_frequency", at, {"units": "Hz"}), phase=("phase", list(PHASES))
        )
    modes, none_there = np.full((2, len(widths), STEPS), np.nan), "the guide has no mode in the gap"
    if gap is not None:
        inside = INSET * (gap.upper - gap.lower)
        between = 2 * np.pi * (gap.lower + inside), 2 * np.pi * (gap.upper - inside)
        middle = plain.wavenumber(0.5 * sum(between), 0.0, "A0") or 0.0
        for row, (width, along) in enumerate(widths):
            for step, k in enumerate(middle * np.linspace(*REACH, STEPS)):
                if width <= 2 * rows(along).setback:
                    continue  # the transition layers at its faces take up all of the strip
                try:
                    mode = Guide.of(rows(along), float(k)).mode(width, 0, between)
                except StudyError:
                    continue  # at this wavenumber the guide has no mode in the gap
                modes[:, row, step] = mode.omega / (2 * np.pi), k
    waves["guided_frequency"] = ("guide", "step"), modes[0], {"units": "Hz", WORD: none_there}
    waves["guided_wavenumber"] = ("guide", "step"), modes[1], {"units": "rad/m", WORD: none_there}
    waves.attrs |= best.attributes(settings, best.model.worst_error)
    return waves.assign_coords(
        width=("guide", [w for w, _ in widths]), along=("guide", [a for _, a in widths])
    )


def guided(waves: xr.Dataset, guide: Guiding) -> tuple[Array, Array] | None:
    """Frequencies (Hz) and wavenumbers (rad/m) of a guide's mode without nodal lines along it.

    They are empty if the guide has no such mode in the gap; None if its modes were not computed.
    """
    for row in range(waves.sizes["guide"]):
        if (float(waves["width"][row]), str(waves["along"].values[row])) == (guide.width, guide.along):
            at = waves["guided_frequency"].values[row]
            propagates = np.isfinite(at)
            return at[propagates], waves["guided_wavenumber"].values[row][propagates]
    return None
