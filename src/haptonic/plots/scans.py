"""Scans: the drive, the contrast and the gap in it, waves along a guide, decay in the lattice, bad points."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from haptonic.arrays import Array
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.spectra import curves, finished, shaded
from haptonic.plots.stage import stage
from haptonic.plots.text import absolute, in_pi
from haptonic.units import hz_text

if TYPE_CHECKING:
    from haptonic.vibrometry import Drive, LatticeGap, MeasuredGap, Quality


FLOOR = -80.0  # dB below the largest line, the lowest that a spectrum of a drive shows
LEAST_COHERENCE = 0.8  # the lowest that colours show, unless there are lower ones
STRONG = 20.0  # dB per row, beyond which colours do not change
ROWS = 600  # of a map of waves at most: more than its picture has
RANGE = 1e-3  # of the largest amplitude, the smallest that a map of waves tells apart
BAD = {
    "saturated": (style.RED, "s"), "dropout": (style.ORANGE, "^"), "low coherence": (style.PURPLE, "v"),
    "repaired": (style.GREEN, "+"),
}  # fmt: skip


@style.drawn
def drive_signal(signal: Drive) -> Figure:
    """One period of a drive, and its amplitude spectrum."""
    figure = style.blank(9.5)
    above, below = figure.subplots(2, 1)
    time = np.arange(len(signal.samples)) / signal.sample_rate
    above.plot(1e3 * time, signal.samples, color=style.BLUE, lw=0.4)
    above.set(
        xlabel="time (ms)", ylabel=f"{signal.quantity} ({signal.unit})", xlim=(0, 1e3 * signal.duration)
    )
    above.set_title(f"{signal.kind}, one period; crest factor {signal.crest_factor:.2f}")
    level = np.abs(np.fft.rfft(signal.samples))
    lines = np.fft.rfftfreq(len(signal.samples), 1 / signal.sample_rate)
    below.plot(lines / 1e3, 20 * np.log10(np.maximum(level / level.max(), 1e-12)), color=style.BLUE, lw=0.8)
    below.set(xlabel="frequency (kHz)", ylabel="amplitude (dB)", xlim=(0, lines[-1] / 1e3), ylim=(FLOOR, 6))
    for number, edge in enumerate(signal.band):
        below.axvline(edge / 1e3, color=style.CARRIER, ls=style.DASHED, lw=1.0,
                      label=None if number else "edges of the band")  # fmt: skip
    below.legend(loc="lower left")
    return figure


@style.drawn
def average_response(
    frequency: Array, amplitude: Array, *, units: str, origin: str, ax: Axes | None = None
) -> Figure:
    """Root mean square over all points of a scan against frequency."""
    on = stage(ax, 7.0)
    axes = on.axes
    unit, factor = absolute(units, float(amplitude.max()), None)
    axes.plot(frequency / 1e3, np.where(amplitude > 0, factor * amplitude, np.nan), color=style.BLUE, lw=0.9)
    style.logarithmic(axes)
    axes.set(xlabel="frequency (kHz)", ylabel=f"rms over all points ({unit})", title=origin,
             xlim=(frequency[0] / 1e3, frequency[-1] / 1e3))  # fmt: skip
    return on.figure


@style.drawn
def measured_contrast(
    frequency: Array,
    contrasts: Mapping[str, Array],
    gap: MeasuredGap | None,
    computed: tuple[float, float] | None,
    *,
    origin: str,
    ax: Axes | None = None,
) -> Figure:
    """Contrasts of a scan (dB; NaN where noise hides it) and the range in which the region stands out."""
    on = stage(ax, 8.6)
    axes = on.axes
    handles = curves(axes, frequency, contrasts, width=0.9)
    axes.axhline(0, color=style.INK, lw=0.7, zorder=1)
    handles += shaded(axes, frequency, computed, "computed gap")
    if gap is not None:
        for edge, error in ((gap.lower, gap.lower_error), (gap.upper, gap.upper_error)):
            axes.axvspan((edge - error) / 1e3, (edge + error) / 1e3, lw=0, facecolor="none",
                         edgecolor=style.PURPLE, hatch="///", zorder=0.5)  # fmt: skip
            line = axes.axvline(edge / 1e3, color=style.PURPLE, lw=1.1, zorder=3)
        line.set_label(f"high contrast, {hz_text(gap.lower, gap.upper, form='.1f')}; standard error hatched")
        handles.append(line)
    axes.set_ylabel("contrast (dB)")
    finished(axes, frequency, origin)
    on.legend(handles, ncols=2)
    return on.figure


@style.drawn
def decay_map(
    fades: xr.DataArray,
    found: LatticeGap | None,
    computed: tuple[float, float] | None,
    *,
    origin: str,
    ax: Axes | None = None,
) -> Figure:
    """How waves of a phase fade from row to row of a lattice (dB per row), and the edges told by it."""
    on = stage(ax, 9.5)
    axes = on.axes
    shown = fades[:: max(1, fades.sizes["frequency"] // ROWS)]
    mesh = axes.pcolormesh(
        shown["phase"].values / np.pi, shown["frequency"].values / 1e3, shown.values,
        cmap=style.perceptual(), vmin=0, vmax=STRONG, shading="nearest", rasterized=True,
    )  # fmt: skip
    on.figure.colorbar(mesh, ax=axes, label="fading (dB/row); white: noise hides it", extend="max")
    handles: list[Artist] = []
    for number, border in enumerate(computed or ()):
        line = axes.axhline(border / 1e3, color=style.RED, ls=style.DASHED, lw=1.2)
        if number == 0:
            line.set_label("computed gap")
            handles.append(line)
    for edge in (found.lower, found.upper) if found else ():
        if edge is not None:
            low, high = (edge.frequency - edge.error) / 1e3, (edge.frequency + edge.error) / 1e3
            axes.axhspan(low, high, facecolor=style.SKY, alpha=0.45, lw=0)
            line = axes.axhline(edge.frequency / 1e3, color=style.PURPLE, lw=1.2)
            line.set_label(f"edge in this scan, {edge}")
            handles.append(line)
    axes.set(xlabel="phase from cell to cell along the rows (π)", ylabel="frequency (kHz)", title=origin)
    if handles:
        on.legend(handles, ncols=2)
    return on.figure


@style.drawn
def wave_map(
    waves: xr.DataArray,
    plain: tuple[Array, Array] | None,
    guided: tuple[Array, Array] | None,
    *,
    region: str,
    origin: str,
    ax: Axes | None = None,
) -> Figure:
    """Amplitude against wavenumber and frequency along a guide; computed dispersion on top.

    Parameters
    ----------
    waves : (frequency, wavenumber)
    plain : frequency (Hz) and wavenumber (rad/m) of the flexural wave of the plate
    guided : the same of the guide's mode without nodal lines along it
    """
    on = stage(ax, 10.5)
    axes = on.axes
    starts = np.unique(np.linspace(0, waves.sizes["frequency"], ROWS, endpoint=False).astype(int))
    amplitude = np.maximum.reduceat(waves.values / waves.values.max(), starts, axis=0)
    frequency, wavenumber = waves["frequency"].values[starts] / 1e3, waves["wavenumber"].values / 1e3
    image = axes.pcolormesh(
        wavenumber, frequency, np.maximum(amplitude, RANGE), norm=LogNorm(RANGE, 1), cmap=style.perceptual(),
        shading="nearest", rasterized=True,
    )  # fmt: skip
    drawn: list[Artist] = []
    looks: tuple[dict[str, Any], ...] = (
        {"color": "white", "ls": style.DASHED, "label": "A0 of the plain plate"},
        {"color": style.ORANGE, "lw": 2.0, "label": "mode of the guide"},
    )
    for curve, look in zip((plain, guided), looks, strict=True):
        if curve is None or not len(curve[0]):
            continue
        for sign in (1, -1):
            drawn += axes.plot(sign * curve[1] / 1e3, curve[0] / 1e3, **look)[: 1 if sign > 0 else 0]
    axes.set(xlabel=f"wavenumber along {region} (rad/mm)", ylabel="frequency (kHz)",
             xlim=(wavenumber[0], wavenumber[-1]), ylim=(frequency[0], frequency[-1]),
             title=f"{region}, {origin}")  # fmt: skip
    on.figure.colorbar(
        image, ax=axes, label="amplitude / its maximum (dimensionless)", format=style.PowersOfTen()
    )
    if drawn:
        legend = on.legend(drawn, ncols=2, title="computed")
        legend.get_frame().set(facecolor="#5a5a5a", alpha=1.0, visible=True)
        for text in (legend.get_title(), *legend.get_texts()):
            text.set_color("white")
    return on.figure


@style.drawn
def measured_decay(
    decay: xr.Dataset,
    computed: xr.Dataset | None,
    gap: tuple[float, float] | None,
    *,
    origin: str,
    ax: Axes | None = None,
) -> Figure:
    """Decay through a lattice in dB per row against frequency, beside the computed evanescent waves."""
    on = stage(ax, 8.6)
    axes = on.axes
    lines = decay["frequency"].values / 1e3
    confidence = float(decay.attrs["confidence"])
    handles: list[Artist] = [
        axes.fill_between(lines, decay["low"], decay["high"], color=style.SKY, alpha=0.5, lw=0,
                          label=f"its {100 * confidence:.0f} % interval"),
        *axes.plot(lines, decay["decay"], color=style.BLUE, lw=1.0, label="decay in the scan, fitted"),
    ]  # fmt: skip
    if computed is not None:
        dashes = (style.SOLID, style.DASHED, style.DOTTED)
        for phase, look in zip(computed["phase"].values, dashes, strict=False):
            level = computed["attenuation"].sel(phase=phase)
            handles += axes.plot(
                computed["frequency"] / 1e3, level, color=style.RED, ls=look, lw=1.2,
                label=f"evanescent, phase {in_pi(float(phase))} per row",
            )  # fmt: skip
    if gap is not None:
        handles.append(axes.axvspan(gap[0] / 1e3, gap[1] / 1e3, facecolor=style.GAP, lw=0, zorder=0,
                                    label="computed gap"))  # fmt: skip
    axes.axhline(0, color=style.INK, lw=0.7, zorder=1)
    axes.set(xlabel="frequency (kHz)", ylabel="decay (dB per row)", title=origin, xlim=(lines[0], lines[-1]))
    on.legend(handles, ncols=2)
    return on.figure


@style.drawn
def point_quality(points: Array, quality: Quality, *, origin: str, ax: Axes | None = None) -> Figure:
    """Median coherence of every point of a scan, and the points with flags."""
    width, height = np.maximum(np.ptp(points, axis=0), 1e-9)
    on = stage(ax, min(max(9.0 * height / width, 2.0), 16.0) + 4.5, 11.0)
    axes = on.axes
    known = np.isfinite(quality.coherence)
    x, y = 1e3 * points.T
    # squares that touch, in points of type squared
    area = max(0.5, 72 * 9.0 / 2.54 * np.sqrt(width * height / len(points)) / width) ** 2
    if known.any():
        least = min(LEAST_COHERENCE, float(quality.coherence[known].min()))
        image = axes.scatter(
            x[known], y[known], area, quality.coherence[known], marker="s", linewidths=0,
            cmap=style.perceptual(), vmin=least, vmax=1, rasterized=True,
        )  # fmt: skip
        bar = on.figure.colorbar(image, ax=axes, location="bottom", aspect=25, pad=0.03)
        bar.set_label("median coherence (dimensionless)")
    else:
        axes.scatter(x, y, area, marker="s", linewidths=0, color=style.PALE_INK, rasterized=True)
    for flag, (colour, marker) in BAD.items():
        here = quality.flagged(flag)
        if here.any():
            edge = {"color": colour} if marker == "+" else {"facecolors": "none", "edgecolors": colour}
            axes.scatter(x[here], y[here], 34, marker=marker, linewidths=1.1, zorder=3,
                         label=f"{flag} ({here.sum()})", **edge)  # type: ignore[arg-type]  # fmt: skip
    axes.set(aspect="equal", xlabel="x (mm)", ylabel="y (mm)", title=f"quality of the points, {origin}")
    if quality.flagged().any():
        on.legend(ncols=4)
    return on.figure
