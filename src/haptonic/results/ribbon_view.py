"""Interactive view of a ribbon: its projected bands and modes, and the field of each mode."""

from __future__ import annotations

from collections.abc import Sequence

from haptonic import plots
from haptonic.later import xarray as xr
from haptonic.results.steps import in_steps, step_colours
from haptonic.views import InteractiveView

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
            "colours": step_colours(),
            "shares": plots.shades(64),
            "range": [float(end) for end in data.attrs["range_hz"]],
            "carrier": None if carrier is None else float(carrier),
        },
    )
