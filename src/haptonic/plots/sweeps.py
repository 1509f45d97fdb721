"""A row of designs: complete gaps against the swept value, with the resonances of the pillar alone."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from haptonic.arrays import Array
from haptonic.bloch.gap_datasets import certain_gaps
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.looks import colours
from haptonic.plots.marks import above, mark
from haptonic.plots.stage import stage
from haptonic.plots.text import readable, scaled_unit

BESIDE = 0.03  # most room beside the first and the last design, of their range
SUBSCRIPTED = ("f₁", "f₂", "f₃")
CURVES: dict[str, tuple[str, style.Dashes]] = {
    "timoshenko": ("pillar alone, Timoshenko", style.SOLID),
    "euler_bernoulli": ("pillar alone, Euler", style.DOTTED),
}


@style.drawn
def sweep(dataset: xr.Dataset, *, ax: Axes | None = None) -> Figure:
    """Edges of complete gaps as points with their errors, one design above another; the gap shaded between.

    Points of a gap that is not wider than the errors of its edges are hollow. Above the dashed line, the
    highest band that was computed, nothing is known.

    Parameters
    ----------
    dataset : variables ``value`` (step), ``gap_lower``, ``gap_upper``, ``gap_below`` and the errors of the
        edges (step, gap_slot; NaN where there is none), ``searched_up_to`` (step), ``euler_bernoulli`` and
        ``timoshenko`` (step, resonance); attributes ``expression`` and, if known, ``own_value`` and
        ``carrier_hz``
    """
    on = stage(ax, 10.0)
    axes = on.axes
    unit, factor = scaled_unit(dataset["value"].attrs["units"])
    value = dataset["value"].values * factor
    order = np.argsort(value)
    dataset, value = dataset.isel(step=order), value[order]
    half = min(0.5 * float(np.diff(value).min()), BESIDE * float(np.ptp(value))) if len(value) > 1 else 0.5
    searched = dataset["searched_up_to"].values / 1e3
    axes.set_xlim(value[0] - half, value[-1] + half)
    axes.set_ylim(0, 1.04 * float(np.nanmax(searched, initial=0.0)) or 1.0)
    handles = [*_draw_gaps(axes, dataset, value), *_draw_limit(axes, value, searched)]
    handles += _draw_resonances(axes, dataset, value)
    if "own_value" in dataset.attrs:
        own = float(dataset.attrs["own_value"]) * factor
        if value[0] - half <= own <= value[-1] + half:
            axes.axvline(own, color=style.INK, ls=style.DOTTED, lw=1.0, gid="own", zorder=1)
            beside = "" if unit == "dimensionless" else f" {unit}"
            above(axes, [(own, f"this study, {own:.4g}{beside}", style.INK)])
    carrier = dataset.attrs.get("carrier_hz")
    axes.set_xlabel(f"{readable(dataset.attrs['expression'])} ({unit})", parse_math=False)
    axes.set_ylabel("frequency (kHz)")
    on.legend(handles, ncols=3)
    mark(axes, carrier=carrier, along="y")
    return on.figure


def _draw_gaps(axes: Axes, dataset: xr.Dataset, value: Array) -> list[Artist]:
    """Shade each gap along the designs that have it, its edges as points; return handles for the legend."""
    lower, upper = dataset["gap_lower"].values / 1e3, dataset["gap_upper"].values / 1e3
    errors = dataset["gap_lower_error"].values / 1e3, dataset["gap_upper_error"].values / 1e3
    certain = certain_gaps(dataset)
    below = dataset["gap_below"].values
    for band in np.unique(below[np.isfinite(lower)]):
        here = (below == band) & np.isfinite(lower)
        known = here.any(axis=1)
        low, high = (
            np.where(known, edge.max(axis=1, initial=-np.inf, where=here), np.nan) for edge in (lower, upper)
        )
        axes.fill_between(value, low, high, where=known, facecolor=style.GAP, lw=0, zorder=2, gid="gap")
        # a gap of a single design has no area
        axes.vlines(
            value[known], low[known], high[known], color=style.GAP, lw=2, zorder=2, gid="gap of a design"
        )
    color = colours([style.GAP_EDGE])[0]
    handles: list[Artist] = []
    looks = (
        ("certain gap", certain, color, "edges of a complete gap"),
        ("uncertain gap", ~certain & np.isfinite(lower), "white", "gap within its errors"),
    )
    for gid, chosen, face, words in looks:
        if not chosen.any():
            continue
        step = np.nonzero(chosen)[0]
        for edge, error in zip((lower, upper), errors, strict=True):
            points = axes.errorbar(
                value[step], edge[chosen], error[chosen], fmt="o", ms=3, color=color, mfc=face, mew=0.8,
                elinewidth=0.8, zorder=4,
            )  # fmt: skip
            points.lines[0].set_gid(gid)
        (point,) = axes.plot([], [], "o", ms=3, color=color, mfc=face, mew=0.8, label=words)
        handles.append(point)
    return handles


def _draw_limit(axes: Axes, value: Array, searched: Array) -> list[Artist]:
    """Draw the limit of the search for gaps, and crosses for failed designs; return handles for a legend."""
    handles: list[Artist] = []
    computed = np.isfinite(searched)
    if computed.any():
        look: dict[str, Any] = {"color": style.PALE_INK, "ls": style.DASHED, "lw": 0.8}
        handles += axes.plot(value[computed], searched[computed], gid="beyond", **look, zorder=1,
                             label="highest band computed")  # fmt: skip
    if not computed.all():
        failed = value[~computed]
        handles += axes.plot(failed, np.zeros(len(failed)), "x", color=style.RED, clip_on=False, gid="failed",
                             label="could not be computed", zorder=5)  # fmt: skip
    return handles


def _draw_resonances(axes: Axes, dataset: xr.Dataset, value: Array) -> list[Artist]:
    """Draw the resonances of the pillar alone as thin lines, each theory once in the legend."""
    handles: list[Artist] = []
    for variable, (words, dashes) in CURVES.items():
        for k in range(dataset.sizes["resonance"]):
            frequency = dataset[variable].values[:, k] / 1e3
            (line,) = axes.plot(value, frequency, color=style.SKY, ls=dashes, lw=0.9, zorder=3,
                                gid=f"{variable} {k + 1}")  # fmt: skip
        if np.isfinite(dataset[variable].values).any():
            line.set_label(words)
            handles.append(line)
    return handles
