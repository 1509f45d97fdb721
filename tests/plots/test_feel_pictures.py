"""Reductions of friction against the drive: what the legend explains."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from seeing import artists, assert_readable

from haptonic import plots

DRIVES = np.linspace(0.0, 200.0, 21)


def curve() -> xr.Dataset:
    """Reductions of two regions whose plausible ranges overlap."""
    value = np.stack([1 - np.exp(-((DRIVES / scale) ** 2)) for scale in (100.0, 450.0)])
    ends = {"value": value, "low": np.clip(value - 0.3, 0, 1), "high": np.clip(value + 0.1, 0, 1)}
    return xr.Dataset(
        {name: (("region", "drive"), values) for name, values in ends.items()},
        coords={"region": ["left", "right"], "drive": ("drive", DRIVES, {"units": "V"})},
    )


def marks_of_ranges(legend) -> list[str]:
    """Colours in the entry for the plausible range, which is a patch; the other entries are lines."""
    return [to_hex(patch.get_facecolor()) for patch in legend.findobj(Rectangle)]


def test_the_legend_shows_the_plausible_ranges_in_their_colours():
    figure = plots.reduction_curve(curve(), 100.0, 0.11)
    assert_readable(figure)
    (legend,) = figure.legends
    assert [text.get_text() for text in legend.get_texts()] == ["left", "right", "plausible range"]
    bands = [to_hex(band.get_facecolor()[0]) for band in artists(figure, "band")]
    assert marks_of_ranges(legend) == bands
    assert len(set(bands)) == 2
    axes = Figure().add_subplot()
    plots.reduction_curve(curve(), 100.0, 0.11, ax=axes)
    assert marks_of_ranges(axes.get_legend()) == bands
