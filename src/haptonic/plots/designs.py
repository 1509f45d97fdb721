"""Designs of a search, and the widest gap against the pitch."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from haptonic.arrays import Array
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.stage import below, stage
from haptonic.plots.text import readable, scaled_unit
from haptonic.units import hz_text

STAGES = {
    "look": ("starts", "o"),
    "climb": ("climbs", "s"),
    "polish": ("corrected by the finer model", "D"),
}
MOST_PANELS = 3  # of sizes against the one that varies most
MOST_WIDTHS = 14  # written above the bars of a front, side by side


@style.drawn
def search(dataset: xr.Dataset, units: Mapping[str, str]) -> Figure:
    """Sizes of every design seen against each other, with the margin of the drive frequency as colour.

    With one size, the height shows the margin. With more than two, each of the others has a panel against the
    first.

    Parameters
    ----------
    dataset : variables ``value`` (visit, parameter; SI), ``margin`` and ``stage`` (visit); attribute
        ``carrier_hz``
    units : SI units of the parameters
    """
    margin = 100 * dataset["margin"].values
    sizes = {str(path): dataset["value"].sel(parameter=path).values for path in dataset["parameter"].values}
    first, *others = sorted(sizes, key=lambda path: -_spread(sizes[path]))
    others = others[:MOST_PANELS]
    figure = style.blank(8.6, style.WIDTH if len(others) > 1 else 0.75 * style.WIDTH)
    panels = figure.subplots(1, max(len(others), 1), sharey=True, squeeze=False)[0]
    # designs far from the carrier share the end of the scale, so that good ones differ in colour
    limit = max(min(float(np.abs(margin).max()), 2 * abs(float(margin.max()))), 0.1)
    best, handles = int(np.argmax(margin)), dict[str, Artist]()
    name, heights = _axis(first, sizes[first], units[first]) if others else ("margin (%)", margin)
    for axes, path in zip(panels, others or [first], strict=True):
        across, places = _axis(path, sizes[path], units[path])
        for stage_name, (words, marker) in STAGES.items():
            own = dataset["stage"].values == stage_name
            if not own.any():
                continue
            points = axes.scatter(
                places[own], heights[own], 24, margin[own], marker=marker, cmap=style.diverging().reversed(),
                vmin=-limit, vmax=limit, edgecolors=style.INK, linewidths=0.5, gid=stage_name, zorder=3,
            )  # fmt: skip
            (handles[words],) = axes.plot(
                [], [], marker, mfc="white", mec=style.INK, mew=0.5, ms=5, label=words
            )
        axes.plot(places[best], heights[best], "o", mfc="none", mec=style.CARRIER, mew=1.4, ms=11, gid="best",
                  zorder=4)  # fmt: skip
        axes.set_xlabel(across)
        axes.margins(0.1)
    (handles["best"],) = panels[0].plot([], [], "o", mfc="none", mec=style.CARRIER, mew=1.4, ms=8,
                                        label=f"best, margin {margin[best]:.1f} %")  # fmt: skip
    panels[0].set_ylabel(name)
    carrier = hz_text(float(dataset.attrs["carrier_hz"]), form="g")
    figure.colorbar(
        points, ax=list(panels), label=f"margin of {carrier} in the gap (%)",
        extend="min" if margin.min() < -limit else "neither",
    )  # fmt: skip
    below(figure, list(handles.values()), ncols=4)
    return figure


def _spread(values: Array) -> float:
    """Range of a size over its mean."""
    return float(np.ptp(values) / (np.abs(values).mean() or 1.0))


def _axis(path: str, values: Array, si_unit: str) -> tuple[str, Array]:
    """Name of an axis with its unit, and the values in it."""
    unit, factor = scaled_unit(si_unit)
    return f"{readable(path)} ({unit})", factor * values


@style.drawn
def front(dataset: xr.Dataset, *, ax: Axes | None = None) -> Figure:
    """The widest gap around the carrier that each pitch allows.

    Parameters
    ----------
    dataset : variables ``pitch``, ``lower``, ``upper``, ``margin`` (design), NaN where no design is allowed;
        attribute ``carrier_hz``
    """
    on = stage(ax, 9.0)
    axes = on.axes
    pitch, carrier = dataset["pitch"].values * 1e3, float(dataset.attrs["carrier_hz"]) / 1e3
    lower, upper = dataset["lower"].values / 1e3, dataset["upper"].values / 1e3
    held = dataset["margin"].values > 0
    step = np.diff(pitch).min()
    axes.use_sticky_edges = False  # else the lowest bar would end on the frame
    if held.any():
        axes.bar(pitch[held], (upper - lower)[held], 0.55 * step, lower[held], facecolor=style.GAP,
                 edgecolor=style.GAP_EDGE, lw=0.6, label="best gap around it; its width in kHz")  # fmt: skip
    every = -(-len(pitch) // MOST_WIDTHS)
    for x, low, high in list(zip(pitch[held], lower[held], upper[held], strict=True))[::-every]:
        axes.annotate(f"{high - low:.1f}", (x, high), gid="width", xytext=(0, 2), textcoords="offset points",
                      ha="center", va="bottom")  # fmt: skip
    if not held.all():
        axes.plot(pitch[~held], np.full((~held).sum(), carrier), "x", color=style.INK, gid="none", zorder=3,
                  label="no allowed design has a gap there")  # fmt: skip
    name = f"carrier {hz_text(1e3 * carrier, form='g')}"
    axes.axhline(carrier, color=style.CARRIER, ls=style.DASHED, lw=1.1, label=name,
                 gid="carrier")  # fmt: skip
    room = 0.3 * step + 0.04 * (pitch[-1] - pitch[0])
    axes.set_xlim(pitch[0] - room, pitch[-1] + room)
    axes.margins(y=0.15)
    axes.set_xlabel("pitch (mm)")
    axes.set_ylabel("frequency (kHz)")
    on.legend(ncols=2)
    return on.figure
