"""Interactive view of a plate: its vibration at every frequency, the regions, contrasts and modes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from haptonic import plots
from haptonic.cell.scales import scales
from haptonic.later import xarray as xr
from haptonic.plate.layout.drawing import drawing_of
from haptonic.plots.text import driven
from haptonic.response.measures import along
from haptonic.views import InteractiveView

if TYPE_CHECKING:
    from haptonic.results.plate.value import PlateResult

STEPS = np.iinfo(np.int8).max  # of the largest displacement at a frequency; a map has as many colours


def plate_view(result: PlateResult) -> InteractiveView:
    """View of the response at all frequencies, for the amplitude of the first drive.

    ``shape_real`` and ``shape_imag`` are the normal displacement (frequency, y, x) in steps of
    ``shape_step`` (m), and 0 where ``present`` is 0.
    """
    drive, moving = result.drive, result.response.displacement()
    grid = drive * moving.grid().sel(direction="z")
    present = np.isfinite(grid.values[0])
    field = np.where(present, grid.values, 0.0)
    largest = np.abs(field).max(axis=(1, 2))
    step = np.where(largest > 0, largest, 1.0) / STEPS
    of_map = ("frequency", "y", "x")
    data = xr.Dataset(
        {
            "shape_real": (of_map, np.rint(field.real / step[:, None, None]).astype(np.int8)),
            "shape_imag": (of_map, np.rint(field.imag / step[:, None, None]).astype(np.int8)),
            "shape_step": ("frequency", step, {"units": "m", "long_name": "step of the displacement"}),
            "present": (("y", "x"), present.astype(np.int8), {"units": "1", "long_name": "plate"}),
            "mode_frequency": ("mode", result.modes["frequency"].values, {"units": "Hz"}),
            "mode_quality": ("mode", result.modes["quality_factor"].values, {"units": "1"}),
            "mode_name": ("mode", result.modes["name"].values.astype("U")),
        },
        coords={
            "frequency": ("frequency", result.response.frequency, {"units": "Hz", "long_name": "frequency"}),
            "x": ("x", grid["x"].values, {"units": "m", "long_name": "x"}),
            "y": ("y", grid["y"].values, {"units": "m", "long_name": "y"}),
        },
        attrs={
            **{name: result.lines.attrs[name] for name in ("haptonic_version", "origin")},
            **_scales(result),
        },
    )
    if result.levels:
        levels = along({name: drive * level for name, level in result.levels.items()}, "region")
        data["level"] = levels.assign_attrs(units="m/s", long_name="RMS velocity of the regions")
    if contrasts := result.contrasts(result.response):
        data["contrast"] = along(contrasts, "pair").assign_attrs(
            units="dB", long_name="contrast of the driven region"
        )
    return InteractiveView(kind="plate", title=result.title, dataset=data, extra=_extra(result))


def _scales(result: PlateResult) -> dict[str, float]:
    """Pitch and speed of shear waves, unless lattices of the plate have different pitches."""
    cells = list(result.plate.layout.cells.values())
    return scales(cells[0]) if len({cell.lattice.pitch for cell in cells}) == 1 else {}


def _extra(result: PlateResult) -> dict[str, Any]:
    return {
        "summary": result.summary(),
        "colours": plots.shades(2 * STEPS + 1, signed=True),
        "gap": None if result.gap is None else [result.gap.lower, result.gap.upper],
        "carrier": result.carrier,
        "first": result.resonance,
        "drive": driven(result.response.units, result.drive),
        **drawing_of(result.plate),
    }
