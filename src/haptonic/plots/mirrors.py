"""Decay of waves in the lattice, transmission of its rows, and the mode between two mirrors."""

from __future__ import annotations

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from haptonic.arrays import Array
from haptonic.errors import HaptonicError
from haptonic.later import xarray as xr
from haptonic.names import counted
from haptonic.plots import style
from haptonic.plots.looks import colours
from haptonic.plots.marks import above, mark
from haptonic.plots.stage import below, stage
from haptonic.units import hz_text, uncertain

FLAT = 1e-6  # rad, imaginary part of a phase below which a wave propagates
DECIBELS = 20 / np.log(10)  # per row, of an imaginary part of 1 rad
FLOOR = -100.0  # dB
CUT = 0.03  # of the height, of the mark of a curve that goes on below the axis
LEAST = 0.01  # amplitude down to which a mode is shown in the lattice
ROOM = 0.025  # of the axis beyond zero and the end, so that lines on them are visible
FAMILIES = ("A0", "S0", "SH0")


@style.drawn
def decay(dataset: xr.Dataset) -> Figure:
    """Decay per row against frequency, with its number at the drive frequency, above the propagating waves.

    Upper panel: the slowest-decaying wave at normal incidence, the range of all directions along the
    rows, and all evanescent waves at normal incidence as points. Lower panel: phase per row of those that
    propagate.

    Parameters
    ----------
    dataset : variables ``kappa_real``, ``kappa_imag`` (frequency, wave) and ``attenuation`` (frequency,
        phase); attributes ``gap`` (edges in Hz, or empty), ``carrier_hz`` and, if it is known, the bound
        ``carrier_attenuation_error_db`` of the decay
    """
    figure = style.blank(12.0)
    depth, phases = figure.subplots(2, 1, sharex=True, height_ratios=(5, 2))
    frequency = dataset["frequency"].values / 1e3
    across = np.repeat(frequency[:, None], dataset.sizes["wave"], axis=1)
    imaginary, real = dataset["kappa_imag"].values, np.abs(dataset["kappa_real"].values)
    moving = imaginary < FLAT
    reach = dataset["attenuation"].values
    top = max(1.15 * float(np.nanmax(reach)), 1.0)
    shown = ~moving & (DECIBELS * imaginary < top)
    color = colours([style.BLUE])[0]
    handles: list[Artist] = [
        *depth.plot(frequency, reach[:, 0], color=color, lw=1.6, label="normal incidence", gid="normal"),
        depth.fill_between(frequency, reach.min(axis=1), reach.max(axis=1), color=color, alpha=0.2, lw=0,
                           label="all directions", gid="range"),
        *depth.plot(across[shown], DECIBELS * imaginary[shown], ".", ms=2, color=style.PALE_INK, zorder=1,
                    label="other waves at normal incidence", gid="others"),
    ]  # fmt: skip
    carrier = float(dataset.attrs["carrier_hz"])
    if frequency.min() <= carrier / 1e3 <= frequency.max():
        there = float(np.interp(carrier, dataset["frequency"].values, reach[:, 0]))
        error = dataset.attrs.get("carrier_attenuation_error_db")
        depth.plot(carrier / 1e3, there, "o", color=color, ms=5, zorder=5, gid="number")
    depth.set_ylim(0, top)
    depth.set_ylabel("decay (dB per row)")
    phases.plot(across[moving], real[moving] / np.pi, ".", ms=2, color=style.INK, gid="propagating")
    phases.set_ylabel("|Re κ| / π\n(dimensionless)")
    phases.set_ylim(-ROOM, 1 + ROOM)
    phases.set_yticks([0, 0.5, 1], ["0", "0.5", "1"])
    phases.set_xlim(frequency.min(), frequency.max())
    phases.set_xlabel("frequency (kHz)")
    for axes in (phases, depth):
        _mark(axes, dataset, named=axes is depth)
    if frequency.min() <= carrier / 1e3 <= frequency.max():
        text = f"{there:.1f}" if error is None else uncertain(there, error)
        above(depth, [(carrier / 1e3, f"{text} dB per row", color)], first=2)
    below(figure, handles)
    return figure


@style.drawn
def layers(dataset: xr.Dataset, *, incident: str | None = None, ax: Axes | None = None) -> Figure:
    """Transmitted energy for each incident wave, against frequency and, at the carrier, against rows.

    A curve for each number of rows, in the colour of its point in the panel on the right.

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
    given = None if ax is None else stage(ax, 0.0)
    if given is None:
        figure = style.blank(3.0 + 4.2 * len(there))
        panels = figure.subplots(len(there), 2, sharex="col", squeeze=False, width_ratios=(4, 1))
    else:
        panels = np.array([[given.axes, None]], dtype=object)
    rows, frequency = dataset["rows"].values, dataset["frequency"].values / 1e3
    shades = colours([to_hex(shade) for shade in style.perceptual()(np.linspace(0.72, 0.05, len(rows)))])
    carrier = float(dataset.attrs["carrier_hz"]) / 1e3
    cut: list[Artist] = []
    for (axes, beside), family in zip(panels, there, strict=True):
        total = dataset["transmitted"].sel(incident=family).sum("outgoing", skipna=False).values
        level = 10 * np.log10(np.maximum(total, 1e-30))
        lowest = min(max(FLOOR, 10 * np.floor(np.nanmin(level) / 10)), -10)
        for k, (count, shade) in enumerate(zip(rows, shades, strict=False)):
            axes.plot(frequency, level[:, k], color=shade, lw=1.2, label=counted(count, "row"), gid="rows")
            if beside is not None and frequency[0] <= carrier <= frequency[-1]:
                at = float(np.interp(carrier, frequency, level[:, k]))
                beside.plot(count, at, "o", color=shade, ms=5, gid="at carrier")
        axes.set_ylim(1.06 * lowest, 3)
        axes.set_xlim(frequency[0], frequency[-1])
        cut += _mark_cut(axes, frequency, level, shades, first=not cut)
        axes.set_ylabel(f"{family} (dB)" if len(there) > 1 else f"{family}: transmitted (dB)")
        _mark(axes, dataset, named=axes is panels[0][0])
        if beside is not None:
            beside.set_ylim(1.06 * lowest, 3)
            beside.set_xlim(0.3, rows[-1] + 0.7)
            beside.xaxis.set_major_locator(MaxNLocator(4, integer=True))
            beside.tick_params(labelleft=False)
            beside.axhline(0, color=style.PALE_INK, lw=0.6, zorder=1)
    panels[-1][0].set_xlabel("frequency (kHz)")
    if given is not None:
        given.legend()
        return given.figure
    below(figure, cut[:1])
    panels[-1][1].set_xlabel("rows")
    above(
        panels[0][1], [(0.5 * (rows[0] + rows[-1]), f"at {hz_text(1e3 * carrier, form='g')}", style.CARRIER)]
    )
    angle = np.degrees(float(dataset.attrs["angle"]))
    along = [int(number) for number in dataset.attrs["along"]]
    words = [
        "transmitted" if len(there) > 1 else "",
        "" if along == [0, 1] else f"rows along {along}",
        "normal incidence" if angle == 0 else f"incident at {angle:.3g}° from the normal",
    ]
    figure.supylabel(", ".join(filter(None, words)), fontsize="medium")
    return figure


def _mark_cut(axes: Axes, frequency: Array, level: Array, shades: list[str], *, first: bool) -> list[Artist]:
    """Mark curves (frequency, rows) that leave the axes at the bottom, each where it is lowest."""
    drawn: list[Artist] = []
    for curve, shade in zip(level.T, shades, strict=False):
        if np.nanmin(curve, initial=0.0) < axes.get_ylim()[0]:
            drawn += axes.plot(
                frequency[np.nanargmin(curve)], CUT, "v", color=shade, ms=5.5, mec="white", mew=0.5, zorder=6,
                transform=axes.get_xaxis_transform(), gid="cut",
                label="the curve goes on below the axis" if first and not drawn else None,
            )  # fmt: skip
    return drawn


@style.drawn
def guide(
    position: Array,
    amplitude: Array,
    at_edge: float,
    width: float,
    fixed_line: float,
    *,
    lattice: tuple[Array, Array] | None = None,
    title: str = "",
    ax: Axes | None = None,
) -> Figure:
    """Amplitude of the guided mode across the strip, between and in the two lattices.

    Parameters
    ----------
    position : (s,) from the middle of the strip, m; amplitude : (s,) its peak 1
    at_edge : amplitude where the lattices begin, on average; beside zigzags the curve ends before
    width : of the strip, m; fixed_line : distance inside the lattices at which the plate seems to be fixed, m
    lattice : positions (l,) from the middle, m, and amplitudes there; those in the lattices are drawn
    title : above a figure of its own
    """
    on = stage(ax, 7.5)
    axes = on.axes
    edge, line = 500 * width, 1e3 * (0.5 * width + fixed_line)
    reach = max(1.25 * edge, 1.15 * line)
    axes.plot(1e3 * position, amplitude, color=style.BLUE, label="amplitude of the mode")
    if lattice is not None:
        for side in (-1, 1):
            beyond = side * lattice[0] > position[-1]
            x, y = (
                np.concatenate([end, part[beyond]] if side > 0 else [part[beyond], end])
                for end, part in zip(((side * position[-1:]), amplitude[-1:]), lattice, strict=True)
            )
            axes.plot(1e3 * x, y, color=style.BLUE, gid="in the lattice")
            seen = np.abs(x[y >= LEAST])
            reach = max(reach, 1.05e3 * float(seen.max(initial=0.0)))
    elif position[-1] < (1 - 1e-9) * 0.5 * width:
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
    axes.set_ylabel("amplitude\n(dimensionless)")
    if title and on.own:
        axes.set_title(title)
    on.legend(ncols=3)
    return on.figure


def _mark(axes: Axes, dataset: xr.Dataset, *, named: bool) -> None:
    """Shade the gap and draw the drive frequency, if they are in view."""
    edges = np.atleast_1d(dataset.attrs["gap"])
    gap = (float(edges[0]), float(edges[1])) if len(edges) == 2 else None
    mark(axes, gap, carrier=float(dataset.attrs["carrier_hz"]), name="complete gap", named=named)
