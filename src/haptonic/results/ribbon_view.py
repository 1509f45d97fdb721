"""Interactive view of a ribbon: its projected bands and modes, and the field of each mode."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic import plots
from haptonic.later import xarray as xr
from haptonic.views import InteractiveView

STEPS = np.iinfo(np.int8).max  # of the largest displacement of a mode; a field has as many colours
NUMBERS = [
    "phase", "frequency", "frequency_error", "group_velocity", "guide_share", "guided", "decay",
    "wavevector_phase", "bulk_lower", "bulk_upper",
]  # fmt: skip
FIELDS = ["mode_real", "mode_imag"]


def ribbon_view(data: xr.Dataset, title: str, summary: Sequence[str]) -> InteractiveView:
    """View of all modes; ``data`` as in `haptonic.results.ribbon.RibbonWaves`."""
    seen = data[NUMBERS]
    if "mode_real" in data:
        seen = data[[*NUMBERS, "present", "mode_component"]]
        for name in FIELDS:
            seen[name] = data[name].dims, np.rint(STEPS * data[name].values).astype(np.int8), data[name].attrs
    carrier = data.attrs.get("carrier_hz")
    return InteractiveView(
        kind="ribbon",
        title=title,
        dataset=seen.drop_vars("cell_name", errors="ignore"),
        extra={
            "summary": list(summary),
            "colours": plots.shades(2 * STEPS + 1, signed=True),
            "shares": plots.shades(64),
            "range": [float(end) for end in data.attrs["range_hz"]],
            "carrier": None if carrier is None else float(carrier),
        },
    )
