"""Interactive view of waveguides between two mirrors: their sizes, and the field of each mode."""

from __future__ import annotations

from collections.abc import Sequence

from haptonic.later import xarray as xr
from haptonic.results.ribbon_view import FIELDS
from haptonic.results.steps import in_steps, step_colours
from haptonic.views import InteractiveView


def guides_view(data: xr.Dataset, title: str, summary: Sequence[str], best: int) -> InteractiveView:
    """View of all waveguides with fields; ``best`` is selected first."""
    return InteractiveView(
        kind="guides",
        title=title,
        dataset=data.assign({name: in_steps(data[name]) for name in FIELDS}),
        extra={
            "summary": list(summary),
            "colours": step_colours(),
            "best": best,
            "gap": [float(end) for end in data.attrs["gap"]],
        },
    )
