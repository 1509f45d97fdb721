"""A row of designs: complete gaps against the swept value, with the resonances of the pillar alone."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.stage import stage
from haptonic.plots.text import readable, scaled_unit
from haptonic.units import hz_text

BAR = 0.8  # width of a bar, as a share of the step
SUBSCRIPTED = ("f₁", "f₂", "f₃")
CURVES = {
    "euler_bernoulli": ("cantilever, Euler-Bernoulli", style.BLUE, style.SOLID),
    "timoshenko": ("cantilever, Timoshenko", style.RED, style.DASHED),
}


@style.drawn
def sweep(dataset: xr.Dataset, *, ax: Axes | None = None) -> Figure:
    """Complete gaps as bars, one column for each design.

    A gap that is not wider than the errors of its edges is drawn pale and hatched. Above the highest band
    that was computed nothing is known; that is grey.

    Parameters
    ----------
    dataset : variables ``value`` (step), ``gap_lower``, ``gap_upper`` and their errors (step, gap_slot; NaN
        where there is none), ``searched_up_to`` (step), ``euler_bernoulli`` and ``timoshenko`` (step,
        resonance); attributes ``expression`` and, if known, ``own_value`` and ``carrier_hz``
    """
    on = stage(ax, 10.5)
    axes = on.axes
    unit, factor = scaled_unit(dataset["value"].attrs["units"])
    value = dataset["value"].values * factor
    half = 0.5 * float(np.abs(np.diff(value)).min())
    searched = dataset["searched_up_to"].values / 1e3
    axes.set_xlim(value.min() - half, value.max() + half)
    axes.set_ylim(0, 1.06 * float(np.nanmax(searched, initial=0.0)) or 1.0)
    handles: list[Artist] = [
        *_draw_limit(axes, value, searched, half),
        *_draw_gaps(axes, dataset, value, 2 * BAR * half),
    ]
    names = _draw_resonances(axes, dataset, value)
    for name, (label, colour, dashes) in CURVES.items():
        if np.isfinite(dataset[name].values).any():
            handles += axes.plot([], [], color=colour, ls=dashes, label=label)
    if "own_value" in dataset.attrs:
        own = float(dataset.attrs["own_value"]) * factor
        beside = "" if unit == "dimensionless" else f" {unit}"
        if value.min() - half <= own <= value.max() + half:
            handles.append(axes.axvline(own, color=style.INK, ls=style.DOTTED, lw=1.2, gid="own",
                                        label=f"this study ({own:.4g}{beside})"))  # fmt: skip
    carrier = dataset.attrs.get("carrier_hz")
    if carrier is not None:
        axes.axhline(carrier / 1e3, color=style.CARRIER, ls=style.DASHED, lw=1.1, gid="carrier", zorder=4)
        names.append((carrier / 1e3, f"carrier {hz_text(carrier, form='g')}", style.CARRIER))
    axes.set_xlabel(f"{readable(dataset.attrs['expression'])} ({unit})", parse_math=False)
    axes.set_ylabel("frequency (kHz)")
    on.legend(handles, ncols=2, handlelength=2.6)
    style.label_right(axes, [name for name in names if name[0] <= axes.get_ylim()[1]])
    return on.figure


def _draw_gaps(axes: Axes, dataset: xr.Dataset, value: Array, width: float) -> list[Artist]:
    lower, upper = dataset["gap_lower"].values, dataset["gap_upper"].values
    doubt = dataset["gap_lower_error"].values + dataset["gap_upper_error"].values
    there = np.isfinite(lower)
    certain = there & (upper - lower > doubt)
    looks: dict[str, tuple[NDArray[np.bool_], str, dict[str, Any]]] = {
        "certain": (certain, "complete gap", {"facecolor": style.GAP, "edgecolor": style.GAP_EDGE}),
        "uncertain": (
            there & ~certain,
            "gap not wider than its errors",
            {"facecolor": "#fbf4e4", "edgecolor": "#cdb27f", "hatch": "/////"},
        ),
    }
    handles: list[Artist] = []
    for name, (chosen, label, look) in looks.items():
        if chosen.any():
            step = np.nonzero(chosen)[0]
            bars = axes.bar(
                value[step],
                (upper - lower)[chosen] / 1e3,
                width,
                lower[chosen] / 1e3,
                lw=0.6,
                zorder=2,
                **look,
            )
            for bar in bars:
                bar.set_gid(f"{name} gap")
            handles.append(Patch(label=label, lw=0.6, **look))
    return handles


def _draw_limit(axes: Axes, value: Array, searched: Array, half: float) -> list[Artist]:
    top = axes.get_ylim()[1]
    computed = np.isfinite(searched)
    look: dict[str, Any] = {"facecolor": style.BEYOND, "edgecolor": style.BEYOND, "lw": 0.4}
    if computed.any():
        axes.bar(
            value[computed],
            top - searched[computed],
            2 * half,
            searched[computed],
            zorder=1,
            gid="beyond",
            **look,
        )
    handles: list[Artist] = [Patch(label="above the bands that were computed", **look)]
    if not computed.all():
        failed: dict[str, Any] = {"facecolor": "white", "edgecolor": style.PALE_INK, "hatch": "xxx"}
        for bar in axes.bar(value[~computed], top, 2 * BAR * half, lw=0, zorder=1, **failed):
            bar.set_gid("failed")
        handles.append(Patch(label="could not be computed", lw=0, **failed))
    return handles


def _draw_resonances(axes: Axes, dataset: xr.Dataset, value: Array) -> list[tuple[float, str, str]]:
    """Draw the pillar's own resonances; names for the right-hand side, where a curve ends there."""
    top = axes.get_ylim()[1]
    names = []
    for variable, (_, colour, dashes) in CURVES.items():
        for k in range(dataset.sizes["resonance"]):
            frequency = dataset[variable].values[:, k] / 1e3
            axes.plot(value, frequency, color=colour, ls=dashes, lw=1.3, zorder=3, gid=f"{variable} {k + 1}")
    variable, (_, colour, _) = next(iter(CURVES.items()))
    order = np.argsort(value)
    for k in range(dataset.sizes["resonance"]):
        frequency = dataset[variable].values[order, k] / 1e3
        if frequency[-1] <= top:
            names.append((float(frequency[-1]), SUBSCRIPTED[k], colour))
        elif frequency[0] <= top:  # leaves through the top on its way to the right
            leaves = float(np.interp(top, frequency, value[order]))
            axes.annotate(
                SUBSCRIPTED[k], (leaves, 1.0), xycoords=("data", "axes fraction"), xytext=(0, 3),
                textcoords="offset points", ha="center", va="bottom", color=colour,
            )  # fmt: skip
    return names
