"""The way to a design, and how far the pitch can shrink."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.stage import stage
from haptonic.units import hz_text

STAGES = {
    "look": ("starts", style.PALE_INK, "o"),
    "climb": ("climbs", style.BLUE, "s"),
    "polish": ("corrected by the finer model", style.RED, "D"),
}

MOST_WIDTHS = 14  # written above the bars of a front, side by side


@style.drawn
def search(dataset: xr.Dataset) -> Figure:
    """Every design seen: the gap that it has, and how far inside the carrier lies.

    Parameters
    ----------
    dataset : variables ``lower``, ``upper``, ``margin`` and ``stage`` (visit); attribute ``carrier_hz``
    """
    figure = style.blank(11.0)
    gaps, margins = figure.subplots(2, 1, sharex=True, height_ratios=(3, 2))
    carrier = float(dataset.attrs["carrier_hz"])
    number = np.arange(1, dataset.sizes["visit"] + 1)
    lower, upper = dataset["lower"].values / 1e3, dataset["upper"].values / 1e3
    there = upper > lower
    gaps.use_sticky_edges = False  # else the lowest bar would end on the frame
    if there.any():
        gaps.bar(number[there], (upper - lower)[there], 0.8, lower[there], facecolor=style.GAP,
                 edgecolor=style.GAP_EDGE, lw=0.6, label="gap")  # fmt: skip
    if not there.all():
        gaps.bar(number[~there], (lower - upper)[~there], 0.8, upper[~there], facecolor="white",
                 edgecolor=style.PALE_INK, hatch="/////", lw=0.6, label="no gap: bands overlap")  # fmt: skip
    gaps.axhline(carrier / 1e3, color=style.CARRIER, ls=style.DASHED, lw=1.1,
                 label=f"carrier {hz_text(carrier, form='g')}", gid="carrier")  # fmt: skip
    gaps.set_ylabel("frequency (kHz)")
    margins.axhline(0.0, color=style.CARRIER, ls=style.DASHED, lw=1.1)
    for name, (label, colour, marker) in STAGES.items():
        own = dataset["stage"].values == name
        if own.any():
            margins.plot(number[own], 100 * dataset["margin"].values[own], marker, color=colour, ms=4,
                         label=label, gid=name)  # fmt: skip
    margins.set_ylabel("margin (%)")
    margins.set_xlabel("design, in the order of the search")
    margins.set_xlim(0.25, len(number) + 0.75)
    margins.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
    handles = [handle for axes in (gaps, margins) for handle in axes.get_legend_handles_labels()[0]]
    figure.legend(handles=handles, loc="outside lower center", ncols=3)
    return figure


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
        axes.annotate(f"{high - low:.1f}", (x, high), xytext=(0, 2), textcoords="offset points",
                      ha="center", va="bottom", fontsize=8)  # fmt: skip
    if not held.all():
        axes.plot(pitch[~held], np.full((~held).sum(), carrier), "x", color=style.INK, gid="none", zorder=3,
                  label="no allowed design holds it")  # fmt: skip
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
