"""Interactive view of a ribbon: its projected bands and modes, and the field of each mode."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic import plots
from haptonic.later import xarray as xr
from haptonic.views import InteractiveView

STEPS = np.iinfo(np.int8).max  # of the largest displacement of a mode; a field has as many colours
NUMBERS = [
    "phase", "frequency", "frequency_error", "group_velocity", "group_velocity_error", "guide_share",
    "guided", "decay", "decay_error", "wavevector_phase", "bulk_lower", "bulk_upper",
]  # fmt: skip
FIELDS = ["mode_real", "mode_imag"]


def ribbon_view(data: xr.Dataset, title: str, summary: Sequence[str]) -> InteractiveView:
    """View of all modes; ``data`` as in `haptonic.results.ribbon.RibbonWaves`."""
    seen = data[NUMBERS]
    if "mode_real" in data:
        seen = data[[*NUMBERS, "present", "mode_component"]]
        seen = seen.assign({name: in_steps(data[name]) for name in FIELDS})
    carrier = data.attrs.get("carrier_hz")
    return InteractiveView(
        kind="ribbon",
        title=title,
        dataset=seen.drop_vars("cell_name", errors="ignore"),
        extra={
            "summary": list(summary),
            "colours": field_colours(),
            "shares": plots.shades(64),
            "range": [float(end) for end in data.attrs["range_hz"]],
            "carrier": None if carrier is None else float(carrier),
        },
    )


def in_steps(field: xr.DataArray) -> xr.Variable:
    """Displacements up to 1 in `STEPS`."""
    return xr.Variable(field.dims, np.rint(STEPS * field.values).astype(np.int8), field.attrs)


def field_colours() -> list[list[int]]:
    """A colour for each step, from -1 to 1."""
    return plots.shades(2 * STEPS + 1, signed=True)
