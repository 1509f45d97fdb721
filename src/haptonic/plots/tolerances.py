"""Edges of a gap on plates of different sizes within tolerances, and the numbers that move them."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.text import readable
from haptonic.units import hz_text

SIDES = (("lower edge", style.BLUE), ("upper edge", style.ORANGE))


@style.drawn
def tolerance(dataset: xr.Dataset) -> Figure:
    """Distributions of both edges around the carrier, and the share of each parameter in their variance.

    Parameters
    ----------
    dataset : variables ``drawn`` (plate, side), ``total_index`` and ``first_order_share`` (parameter, side);
        attributes ``carrier_hz`` and ``margin_hz``
    """
    count = dataset.sizes["parameter"]
    figure = style.blank(9.5 + 1.1 * count)
    edges, shares = figure.subplots(2, 1, height_ratios=(5.0, 1.2 + 0.9 * count))
    _draw_edges(edges, dataset)
    _draw_shares(shares, dataset)
    handles = [handle for axes in (edges, shares) for handle in axes.get_legend_handles_labels()[0]]
    figure.legend(handles=handles, loc="outside lower center", ncols=3)
    return figure


def _draw_edges(axes: Axes, dataset: xr.Dataset) -> None:
    drawn = dataset["drawn"].values / 1e3
    carrier, margin = (float(dataset.attrs[name]) / 1e3 for name in ("carrier_hz", "margin_hz"))
    bins = np.linspace(min(drawn.min(), carrier), max(drawn.max(), carrier), 90).tolist()
    for side, (label, colour) in enumerate(SIDES):
        axes.hist(drawn[:, side], bins=bins, color=colour, alpha=0.85, label=label, gid=label)
    name = f"carrier {hz_text(1e3 * carrier, form='g')}"
    axes.axvline(carrier, color=style.CARRIER, ls=style.DASHED, lw=1.2, label=name,
                 gid="carrier")  # fmt: skip
    if margin:
        axes.axvspan(carrier - margin, carrier + margin, color=style.CARRIER, alpha=0.12, lw=0,
                     label=f"margin {hz_text(1e3 * margin, form='g')}", gid="margin")  # fmt: skip
    axes.set_xlabel("frequency (kHz)")
    axes.set_ylabel("plates in each bin")


def _draw_shares(axes: Axes, dataset: xr.Dataset) -> None:
    names = [readable(str(path)) for path in dataset["parameter"].values]
    place = np.arange(len(names), dtype=float)
    for side, (_, colour) in enumerate(SIDES):
        shift = 0.2 * (1 if side else -1)
        axes.barh(place + shift, 100 * dataset["total_index"].values[:, side], 0.36, color=colour)
        axes.plot(100 * dataset["first_order_share"].values[:, side], place + shift, "D", color=style.INK,
                  ms=3.5, clip_on=False, zorder=3, label=None if side else "to first order")  # fmt: skip
    axes.set_yticks(place, names)
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.set_xlabel("share of variance, total Sobol index (%)")
    axes.set_xlim(0, 105)
