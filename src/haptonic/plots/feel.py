"""What a finger feels: friction over the flat face, and reductions against the drive."""

from __future__ import annotations

from itertools import cycle
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from haptonic.later import xarray as xr
from haptonic.plate.layout import Layout
from haptonic.plots import style
from haptonic.plots.mapped import ends, outlined
from haptonic.plots.spectra import LOOKS
from haptonic.plots.stage import stage
from haptonic.plots.text import label

PANELS = {
    "low": "least friction\nthat is plausible",
    "value": "prediction",
    "high": "most friction\nthat is plausible",
}


@style.drawn
def friction_map(friction: xr.Dataset, layout: Layout, *, title: str = "") -> Figure:
    """Friction that a finger meets with its middle at each point, over that without vibration.

    Parameters
    ----------
    friction : ``value``, ``low`` and ``high`` (point,) mu / mu0; ``x`` and ``y`` of a grid, m
    title : of all three maps: frequency, drive, origin
    """
    slenderness = (layout.y[-1] - layout.y[0]) / (layout.x[-1] - layout.x[0])
    stacked = slenderness < 0.5  # side by side, the maps of a wide plate would be low strips
    if stacked:
        figure = style.blank(3 * (11.0 * slenderness + 1.2) + 3.6)
        panels = figure.subplots(3, 1, sharex=True)
    else:
        figure = style.blank(min((style.WIDTH - 2.0) / 3 * slenderness, 16.0) + 3.6)
        panels = figure.subplots(1, 3, sharey=True)
    for axes, (end, words) in zip(panels, PANELS.items(), strict=True):
        image = _draw_friction(axes, friction, end, layout)
        axes.set_title(words.replace("\n", " ") if stacked else words, fontsize=9)
        axes.set_ylabel("y (mm)")
        axes.label_outer()
    figure.suptitle(title, fontsize=9.5)
    bar = figure.colorbar(image, ax=list(panels), location="bottom", shrink=0.6, aspect=30, pad=0.02)
    bar.set_label("friction over that without vibration, finger's middle at each point (dimensionless)")
    return figure


def _draw_friction(axes: Axes, friction: xr.Dataset, end: str, layout: Layout) -> AxesImage:
    x, column = np.unique(np.round(friction["x"].values, 9), return_inverse=True)
    y, row = np.unique(np.round(friction["y"].values, 9), return_inverse=True)
    grid = np.full((len(y), len(x)), np.nan)
    grid[row, column] = friction[end].values
    image = axes.imshow(
        grid, cmap=style.perceptual().reversed(), norm=Normalize(0, 1), origin="lower",
        extent=(*ends(1e3 * x), *ends(1e3 * y)), interpolation="nearest", gid="friction",
    )  # fmt: skip
    outlined(axes, layout)
    return image


@style.drawn
def reduction_curve(
    curve: xr.Dataset, drive: float, noticed: float, *, title: str = "", ax: Axes | None = None
) -> Figure:
    """Mean reduction of friction over each region against the amplitude of the drive.

    Parameters
    ----------
    curve : ``value``, ``low`` and ``high`` (region, drive); drive : the one in use, in the curve's units
    noticed : smallest reduction that people notice, as a share
    """
    on = stage(ax, 9.0)
    axes = on.axes
    handles: list[Line2D | Patch] = []
    drives, unit = curve["drive"].values, curve["drive"].attrs["units"]
    for name, (colour, dashes) in zip(curve["region"].values.tolist(), cycle(LOOKS), strict=False):
        region = curve.sel(region=name)
        low, high = 100 * region["low"].values, 100 * region["high"].values
        axes.fill_between(drives, low, high, color=colour, alpha=0.18, lw=0, gid="band")
        handles += axes.plot(
            drives, 100 * region["value"].values, color=colour, ls=dashes, label=label(name), gid="curve"
        )
    handles.append(Patch(facecolor=style.PALE_INK, alpha=0.3, label="band of models and parameters"))
    look: dict[str, Any] = {"color": style.INK, "lw": 0.9}
    handles.append(
        axes.axhline(100 * noticed, ls=style.DOTTED, label=f"just noticed, {100 * noticed:.0f} %", **look)
    )
    handles.append(axes.axvline(drive, ls=style.DASHED, label=f"drive in use, {drive:g} {unit}", **look))
    axes.set(
        xlim=(0, drives[-1]), ylim=(0, 100), title=title, xlabel=f"amplitude of the drive ({unit})",
        ylabel="reduction of friction (%)",
    )  # fmt: skip
    on.legend(handles, ncols=3)
    return on.figure
