"""How waves fade in the lattice, what its rows let through, and the mode between two mirrors."""

from __future__ import annotations

from typing import Literal

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from haptonic.arrays import Array
from haptonic.errors import HaptonicError
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.stage import Stage, stage
from haptonic.plots.text import in_pi
from haptonic.units import hz_text

FLAT = 1e-6  # rad, imaginary part of a phase below which a wave propagates
DEEPEST = 1.2 * np.pi  # rad per row, imaginary part up to which waves are shown
FLOOR = -100.0  # dB
ROOM = 0.025  # of the axis beyond zero and the end, so that what lies on them can be seen
FAMILIES = ("A0", "S0", "SH0")


@style.drawn
def decay(dataset: xr.Dataset) -> Figure:
    """Complex band structure at normal incidence, and the decay per row for several phases along the rows.

    Parameters
    ----------
    dataset : variables ``kappa_real``, ``kappa_imag`` (frequency, wave) and ``attenuation`` (frequency,
        phase); attributes ``gap`` (edges in Hz, or empty) and ``carrier_hz``
    """
    figure = style.blank(12.0)
    real, imaginary, depth = figure.subplots(1, 3, sharey=True, width_ratios=(3, 3, 5))
    frequency = dataset["frequency"].values / 1e3
    height = np.repeat(frequency[:, None], dataset.sizes["wave"], axis=1)
    phase, fading = dataset["kappa_real"].values, dataset["kappa_imag"].values
    moving, shown = fading < FLAT, fading < DEEPEST
    folded = np.abs(phase) / np.pi
    real.plot(folded[shown & ~moving], height[shown & ~moving], ".", ms=2, color=style.PALE_INK)
    real.plot(folded[moving], height[moving], ".", ms=3, color=style.INK)
    imaginary.plot(fading[shown & ~moving] / np.pi, height[shown & ~moving], ".", ms=2, color=style.PALE_INK)
    real.set_xlabel("|Re κ| / π\n(dimensionless)")
    imaginary.set_xlabel("Im κ / π\n(dimensionless)")
    for axes, end in ((real, 1.0), (imaginary, DEEPEST / np.pi)):
        axes.set_xlim(-ROOM * end, (1 + ROOM) * end)
        axes.set_xticks([0, 0.5, 1], ["0", "0.5", "1"])
    real.set_ylabel("frequency (kHz)")
    real.set_ylim(frequency.min(), frequency.max())
    looks = zip(
        (style.BLUE, style.SKY, style.GREEN, style.ORANGE, style.RED),
        (style.SOLID, style.DASHED, style.DOTTED, style.DASH_DOTTED, style.DASH_DOT_DOTTED),
        strict=True,
    )
    for (colour, dashes), column in zip(looks, range(dataset.sizes["phase"]), strict=False):
        label = f"decay, phase {in_pi(float(dataset['phase'][column]))} along the rows"
        depth.plot(dataset["attenuation"].values[:, column], frequency, color=colour, ls=dashes, label=label)
    depth.set_xlabel("decay (dB per row)")
    deepest = max(float(np.nanmax(dataset["attenuation"].values)), 1.0)
    depth.set_xlim(-ROOM * deepest, (1 + ROOM) * deepest)
    handles: list[Artist] = [
        *real.plot([], [], ".", color=style.INK, label="propagating waves, normal incidence"),
        *real.plot([], [], ".", color=style.PALE_INK, label="fading waves, normal incidence"),
        *depth.get_legend_handles_labels()[0],
    ]
    marks = [_mark(axes, dataset, "y") for axes in (real, imaginary, depth)]
    figure.legend(handles=[*handles, *marks[0]], loc="outside lower center", ncols=2)
    return figure


@style.drawn
def layers(dataset: xr.Dataset, *, incident: str | None = None, ax: Axes | None = None) -> Figure:
    """Transmitted energy against frequency: a panel for each incident wave, a curve for each number of rows.

    Parameters
    ----------
    dataset : variable ``transmitted`` (frequency, rows, incident, outgoing); attributes as for `decay`, and
        ``angle`` and ``along``, the translations that a row repeats after
    incident : the one wave to show; by default all, or on given axes the first
    """
    there = [f for f in FAMILIES if np.isfinite(dataset["transmitted"].sel(incident=f).values).any()]
    if incident is not None and incident not in there:
        cause = "there is no such wave, or it does not propagate at these frequencies"
        raise HaptonicError.unknown("incident", incident, there, cause)
    there = [incident] if incident else there[: None if ax is None else 1]
    height = 3.5 + 4.6 * len(there)
    panels = (
        np.atleast_1d(style.blank(height).subplots(len(there), 1, sharex=True))
        if ax is None
        else [stage(ax, height).axes]
    )
    on = Stage(panels[-1], own=ax is None)
    frequency = dataset["frequency"].values / 1e3
    shades = style.perceptual()(np.linspace(0.75, 0.05, dataset.sizes["rows"]))
    handles: list[Artist] = []
    for axes, family in zip(panels, there, strict=True):
        total = dataset["transmitted"].sel(incident=family).sum("outgoing", skipna=False).values
        lines = [
            axes.plot(frequency, 10 * np.log10(np.maximum(total[:, k], 1e-30)), color=shade, lw=1.2,
                      label=f"{rows} row{'s' if rows > 1 else ''}")[0]
            for k, (rows, shade) in enumerate(zip(dataset["rows"].values, shades, strict=True))
        ]  # fmt: skip
        handles = [*lines, *_mark(axes, dataset, "x")]
        lowest = np.nanmin(10 * np.log10(np.maximum(total, 1e-30)))
        axes.set_ylim(min(max(FLOOR, 10 * np.floor(lowest / 10)), -10), 3)
        axes.set_ylabel(f"{family}: transmitted (dB)")
    angle = np.degrees(float(dataset.attrs["angle"]))
    direction = "normal incidence" if angle == 0 else f"incident at {angle:.3g}° from the normal"
    along = [int(one) for one in dataset.attrs["along"]]
    of_rows = "" if along == [0, 1] else f"rows along {along}, "
    panels[0].set_title(f"{of_rows}{direction}; all transmitted waves")
    panels[-1].set_xlabel("frequency (kHz)")
    panels[-1].set_xlim(frequency.min(), frequency.max())
    on.legend(handles, ncols=4)
    return on.figure


@style.drawn
def guide(
    position: Array,
    amplitude: Array,
    at_edge: float,
    width: float,
    fixed_line: float,
    *,
    ax: Axes | None = None,
) -> Figure:
    """Amplitude of the guided mode across the strip, between the two lattices.

    Parameters
    ----------
    position : (s,) from the middle of the strip, m; amplitude : (s,) its peak 1
    at_edge : amplitude where the lattices begin, on average; beside zigzags the curve ends before
    width : of the strip, m; fixed_line : how far inside the lattices the plate seems to be held, m
    """
    on = stage(ax, 7.5)
    axes = on.axes
    edge, line = 500 * width, 1e3 * (0.5 * width + fixed_line)
    reach = max(1.25 * edge, 1.15 * line)
    axes.plot(1e3 * position, amplitude, color=style.BLUE, label="amplitude of the mode")
    if position[-1] < (1 - 1e-9) * 0.5 * width:
        ends = [-edge, edge], [at_edge, at_edge]
        axes.plot(*ends, "o", color=style.BLUE, ms=4, clip_on=False, label="on the lattice's faces")
    for side in (-1, 1):
        axes.axvspan(side * edge, side * reach, facecolor=style.BEYOND, edgecolor="white", hatch="////", lw=0,
                     label="lattice" if side > 0 else None)  # fmt: skip
        axes.axvline(side * line, color=style.RED, ls=style.DASHED, lw=1.1,
                     label="equivalent fixed line" if side > 0 else None)  # fmt: skip
    axes.set_xlim(-reach, reach)
    axes.set_ylim(0, 1.08)
    axes.set_xlabel("position across the waveguide (mm)")
    axes.set_ylabel("amplitude (dimensionless)")
    on.legend(ncols=3)
    return on.figure


def _mark(axes: Axes, dataset: xr.Dataset, along: Literal["x", "y"]) -> list[Artist]:
    """Shade the gap and draw the carrier on an axis of frequencies, if they are in view; legend handles."""
    low, high = float(dataset["frequency"].min()) / 1e3, float(dataset["frequency"].max()) / 1e3
    handles: list[Artist] = []
    edges = np.atleast_1d(dataset.attrs["gap"]) / 1e3
    if len(edges) == 2 and edges[0] < high and edges[1] > low:
        span = axes.axvspan if along == "x" else axes.axhspan
        shade = span(edges[0], edges[1], facecolor=style.GAP, edgecolor="none", zorder=0)
        shade.set(label="complete gap", gid="gap")
        handles.append(shade)
    carrier = float(dataset.attrs["carrier_hz"]) / 1e3
    if low <= carrier <= high:
        line = axes.axvline if along == "x" else axes.axhline
        dashes = line(carrier, color=style.CARRIER, ls=style.DASHED, lw=1.1)
        dashes.set(label=f"carrier {hz_text(1e3 * carrier, form='g')}", gid="carrier")
        handles.append(dashes)
    return handles
