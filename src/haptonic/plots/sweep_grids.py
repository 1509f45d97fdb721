"""The widest complete gap of every design of a sweep over two expressions, as a map."""

from __future__ import annotations

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from haptonic.bloch.gap_datasets import carrier_margins, certain_gaps
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.stage import stage
from haptonic.plots.text import readable, scaled_unit
from haptonic.units import hz_text

TICKED = 7  # values of an axis that all get a tick
CIRCLE, STAR = 5, 16  # points; the circle fits into the middle of the star
AXES = (("value", "expression", "own_value"), ("second_value", "second_expression", "own_second_value"))


@style.drawn
def sweep_grid(dataset: xr.Dataset, *, ax: Axes | None = None) -> Figure:
    """Width of the widest certain gap by colour; a circle where a gap has the carrier inside.

    The star of the study lies below the circle and is larger, so that both are seen. The legend lists only
    marks that occur.

    Parameters
    ----------
    dataset : as for `haptonic.plots.sweep`, with ``second_value`` (step) and the attributes
        ``second_expression`` and ``own_second_value``
    """
    on = stage(ax, 10.5)
    axes = on.axes
    units = [scaled_unit(dataset[name].attrs["units"]) for name, *_ in AXES]
    places = [dataset[name].values * factor for (name, *_), (_, factor) in zip(AXES, units, strict=True)]
    values = [np.unique(place) for place in places]
    column, row = (np.searchsorted(value, place) for value, place in zip(values, places, strict=True))
    lower, upper = dataset["gap_lower"].values, dataset["gap_upper"].values
    certain = certain_gaps(dataset)
    width = np.zeros((len(values[1]), len(values[0])))
    width[row, column] = np.where(certain, upper - lower, 0.0).max(axis=1, initial=0.0) / 1e3
    image = axes.pcolormesh(
        *values, np.ma.masked_equal(width, 0.0), cmap=style.perceptual(), vmin=0.0, shading="nearest",
        rasterized=True, gid="width",
    )  # fmt: skip
    for axis, value in zip((axes.xaxis, axes.yaxis), values, strict=True):
        if len(value) <= TICKED:
            axis.set_ticks(value, [f"{number:.4g}" for number in value])
    # marks outside the map do not widen it
    axes.set_xlim(axes.get_xlim())
    axes.set_ylim(axes.get_ylim())
    on.figure.colorbar(image, ax=axes, label="width of the widest complete gap (kHz)")
    axes.set_facecolor(style.BEYOND)
    handles: list[Artist] = []
    inside = np.isfinite(carrier_margins(dataset))
    if inside.any():
        label = f"carrier {hz_text(dataset.attrs['carrier_hz'], form='g')} inside a gap"
        handles += axes.plot(
            places[0][inside], places[1][inside], ls="", marker="o", ms=CIRCLE, mfc="white", mec=style.INK,
            mew=0.8, label=label, gid="carrier", zorder=3,
        )  # fmt: skip
    failed = np.isnan(dataset["searched_up_to"].values)
    if failed.any():
        handles += axes.plot(
            places[0][failed], places[1][failed], ls="", marker="x", color=style.INK, ms=6,
            label="could not be computed", gid="failed",
        )  # fmt: skip
    if not certain[~failed].any(axis=1).all():
        handles.append(
            Line2D([], [], ls="", marker="s", color=style.BEYOND, ms=8, label="no certain complete gap")
        )
    own = [dataset.attrs[own] * factor for (*_, own), (_, factor) in zip(AXES, units, strict=True)]
    (star,) = axes.plot(
        [own[0]], [own[1]], ls="", marker="*", ms=STAR, mfc=style.CARRIER, mec="white", mew=0.7,
        label="this study", gid="own", zorder=2.5,
    )  # fmt: skip
    ends = axes.get_xlim(), axes.get_ylim()
    if all(low <= place <= high for place, (low, high) in zip(own, ends, strict=True)):
        handles.append(star)
    names = [
        f"{readable(dataset.attrs[expression])} ({unit})"
        for (_, expression, _), (unit, _) in zip(AXES, units, strict=True)
    ]
    axes.set_xlabel(names[0], parse_math=False)
    axes.set_ylabel(names[1], parse_math=False)
    on.legend(handles, ncols=2)
    return on.figure
