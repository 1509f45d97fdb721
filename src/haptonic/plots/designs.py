"""The way to a design, and how far the pitch can shrink."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from haptonic.plots import style

STAGES = {
    "look": ("starts", style.PALE_INK, "o"),
    "climb": ("climbs", style.BLUE, "s"),
    "polish": ("corrected by the finer model", style.RED, "D"),
}


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
    gaps.bar(number[there], (upper - lower)[there], 0.8, lower[there], facecolor=style.GAP,
             edgecolor=style.GAP_EDGE, lw=0.6, label="gap")  # fmt: skip
    gaps.bar(number[~there], (lower - upper)[~there], 0.8, upper[~there], facecolor="white",
             edgecolor=style.PALE_INK, hatch="/////", lw=0.6, label="no gap: the bands overlap")  # fmt: skip
    gaps.axhline(carrier / 1e3, color=style.CARRIER, ls=style.DASHED, lw=1.1, label="carrier")
    gaps.set_ylabel("frequency (kHz)")
    margins.axhline(0.0, color=style.CARRIER, ls=style.DASHED, lw=1.1)
    for stage, (label, colour, marker) in STAGES.items():
        own = dataset["stage"].values == stage
        margins.plot(
            number[own], 100 * dataset["margin"].values[own], marker, color=colour, ms=4, label=label
        )
    margins.set_ylabel("margin (%)")
    margins.set_xlabel("design, in the order of the search")
    margins.xaxis.set_major_locator(MaxNLocator(integer=True))
    handles = [handle for axes in (gaps, margins) for handle in axes.get_legend_handles_labels()[0]]
    figure.legend(handles=handles, loc="outside lower center", ncols=3)
    return figure


@style.drawn
def front(dataset: xr.Dataset) -> Figure:
    """The widest gap around the carrier that each pitch allows.

    Parameters
    ----------
    dataset : variables ``pitch``, ``lower``, ``upper``, ``margin`` (design); attribute ``carrier_hz``
    """
    figure = style.blank(9.0)
    axes = figure.add_subplot()
    pitch, carrier = dataset["pitch"].values * 1e3, float(dataset.attrs["carrier_hz"]) / 1e3
    lower, upper = dataset["lower"].values / 1e3, dataset["upper"].values / 1e3
    held = dataset["margin"].values > 0
    step = np.diff(pitch).min()
    axes.bar(pitch[held], (upper - lower)[held], 0.55 * step, lower[held], facecolor=style.GAP,
             edgecolor=style.GAP_EDGE, lw=0.6, label="best gap around the carrier")  # fmt: skip
    for x, low, high in zip(pitch[held], lower[held], upper[held], strict=True):
        axes.annotate(f"{high - low:.1f}", (x, high), xytext=(0, 2), textcoords="offset points",
                      ha="center", va="bottom", fontsize=8)  # fmt: skip
    axes.plot(pitch[~held], np.full((~held).sum(), carrier), "x", color=style.PALE_INK,
              label="no allowed design holds the carrier")  # fmt: skip
    axes.axhline(carrier, color=style.CARRIER, ls=style.DASHED, lw=1.1, label=f"carrier {carrier:g} kHz")
    axes.margins(y=0.15)
    axes.set_xlabel("pitch (mm)")
    axes.set_ylabel("frequency (kHz); widths above the bars")
    figure.legend(loc="outside lower center", ncols=2)
    return figure
