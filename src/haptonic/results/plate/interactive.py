"""Interactive view of a plate: its vibration at every frequency, the regions, contrasts and modes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from haptonic.cell.scales import scales
from haptonic.later import xarray as xr
from haptonic.plate.layout.drawing import drawing_of
from haptonic.plots.text import driven
from haptonic.response.measures import along
from haptonic.results.steps import step_colours, stepped
from haptonic.units import format_quantity
from haptonic.views import InteractiveView

if TYPE_CHECKING:
    from haptonic.plate import Plate
    from haptonic.results.plate.value import PlateResult


def plate_view(result: PlateResult) -> InteractiveView:
    """View of the response at all frequencies, for the amplitude of the first drive.

    ``shape_real`` and ``shape_imag`` are the normal displacement (frequency, y, x) in steps of
    ``shape_step`` (m), and 0 where ``present`` is 0.
    """
    drive, moving = result.drive, result.response.displacement()
    grid = drive * moving.grid().sel(direction="z")
    present = np.isfinite(grid.values[0])
    data = xr.Dataset(
        {
            **stepped("shape", grid.values, ("frequency", "y", "x")),
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
            **scales_of(result.plate),
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


def _only(result: PlateResult) -> str:
    """Argument of the analysis for a response at one frequency; empty for a band."""
    lines = result.response.frequency
    return f'at="{format_quantity(lines[0], "Hz", digits=None)}"' if len(lines) == 1 else ""


def scales_of(plate: Plate) -> dict[str, float]:
    """Pitch and speed of shear waves, unless lattices of the plate have different pitches."""
    cells = list(plate.layout.cells.values())
    return scales(cells[0]) if len({cell.lattice.pitch for cell in cells}) == 1 else {}


def _extra(result: PlateResult) -> dict[str, Any]:
    return {
        "summary": result.summary(),
        "colours": step_colours(),
        "gap": list(result.gap.edges) if result.gap else None,
        "carrier": result.carrier,
        "first": result.resonance,
        "first_is": "resonance in the gap",
        "maps": {"shape": ""},
        "python": f"study.plate({_only(result)})",
        "drive": driven(result.response.units, result.drive),
        **drawing_of(result.plate),
    }
