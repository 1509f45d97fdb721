"""Pictures of friction under a finger: its map over the flat face, and reductions against the drive."""

from __future__ import annotations

from itertools import cycle
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.container import Container
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.legend_handler import HandlerTuple
from matplotlib.patches import Patch

from haptonic.later import xarray as xr
from haptonic.plate.layout.grid import Layout
from haptonic.plots import style
from haptonic.plots.labels import label_right
from haptonic.plots.looks import colours
from haptonic.plots.mapped import LOW, ends, outlined
from haptonic.plots.marks import LINE, above
from haptonic.plots.spectra import LOOKS
from haptonic.plots.stage import Handle, stage
from haptonic.plots.text import label
from haptonic.units import in_percent

RANGE = 0.18  # opacity of a plausible range
PANELS = {
    "value": "prediction",
    "high": "smallest plausible",
    "low": "largest plausible",
}


@style.drawn
def friction_map(friction: xr.Dataset, layout: Layout, *, title: str = "") -> Figure:
    """Reduction of friction for a finger with its middle at each point, with both plausible ends.

    White is no reduction.

    Parameters
    ----------
    friction : ``value``, ``low`` and ``high`` (point,) mu / mu0; ``x`` and ``y`` of a grid, m
    title : of all three maps: frequency, drive, origin
    """
    slenderness = (layout.y[-1] - layout.y[0]) / (layout.x[-1] - layout.x[0])
    if slenderness < LOW:  # side by side, the maps of a wide plate would be low strips
        figure = style.suited(3 * 0.8 * slenderness, 14)
        panels = figure.subplots(3, 1, sharex=True)
    else:
        figure = style.suited(min(0.5 * slenderness, 1.1), 8)
        named = figure.subplot_mosaic([["value", "high"], ["value", "low"]], width_ratios=(2.1, 1))
        panels = np.array([named[end] for end in PANELS])
    for axes, (end, words) in zip(panels, PANELS.items(), strict=True):
        small = slenderness >= LOW and end != "value"
        image, lines = _draw_friction(axes, friction, end, layout, named=not small)
        largest = f"up to {in_percent(1 - float(friction[end].min()))}"
        heading = f"{words},\n{largest}" if small else f"{words}, {largest}"
        axes.set_title(heading, pad=6 + lines * LINE * mpl.rcParams["font.size"])
        if small:
            axes.set(xlabel="", xticks=[], yticks=[])
        else:
            axes.set_ylabel("y (mm)")
            axes.label_outer()
    bar = figure.colorbar(image, ax=list(panels), location="bottom", shrink=0.8, aspect=30, pad=0.02)
    bar.set_label(f"reduction of friction (%){', ' if title else ''}{title}")
    return figure


def _draw_friction(
    axes: Axes, friction: xr.Dataset, end: str, layout: Layout, *, named: bool
) -> tuple[AxesImage, int]:
    x, column = np.unique(np.round(friction["x"].values, 9), return_inverse=True)
    y, row = np.unique(np.round(friction["y"].values, 9), return_inverse=True)
    grid = np.full((len(y), len(x)), np.nan)
    grid[row, column] = 100 * (1 - friction[end].values)
    image = axes.imshow(
        grid, cmap=style.amount(), norm=Normalize(0, 100), origin="lower",
        extent=(*ends(1e3 * x), *ends(1e3 * y)), gid="friction",
        interpolation="bilinear" if np.isfinite(grid).all() else "nearest",
    )  # fmt: skip
    return image, outlined(axes, layout, named=named)


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
    handles: list[Handle] = []
    drives, unit = curve["drive"].values, curve["drive"].attrs["units"]
    tints = colours([colour for colour, _ in LOOKS])
    names = curve["region"].values.tolist()
    for name, colour, (_, dashes) in zip(names, cycle(tints), cycle(LOOKS), strict=False):
        region = curve.sel(region=name)
        low, high = 100 * region["low"].values, 100 * region["high"].values
        axes.fill_between(drives, low, high, color=colour, alpha=RANGE, lw=0, gid="band")
        handles += axes.plot(
            drives, 100 * region["value"].values, color=colour, ls=dashes, label=label(name), gid="curve"
        )
    # in all colours of the ranges, side by side: grey would be the colour of two that overlap
    patches = [Patch(facecolor=colour, alpha=RANGE) for colour, _ in zip(cycle(tints), names, strict=False)]
    handles.append(Container(patches, label="plausible range"))
    look: dict[str, Any] = {"color": style.INK, "lw": 0.9}
    axes.axhline(100 * noticed, ls=style.DOTTED, gid="noticed", **look)
    axes.axvline(drive, ls=style.DASHED, gid="drive", **look)
    axes.set(
        xlim=(0, drives[-1]), ylim=(0, 100), xlabel=f"amplitude of the drive ({unit})",
        ylabel=f"reduction of friction (%)\n{title}".strip(),
    )  # fmt: skip
    above(axes, [(drive, f"drive in use {drive:g} {unit}", style.INK)])
    label_right(axes, [(100 * noticed, f"just noticed\n{in_percent(noticed)}", style.INK)])
    on.legend(handles, ncols=4, handler_map={tuple: HandlerTuple(ndivide=None, pad=0)})
    return on.figure
