"""Scans: the drive, the contrast and the gap in it, waves along a guide, decay in the lattice, bad points."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from haptonic.arrays import Array
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.looks import choice, colours
from haptonic.plots.marks import above, span_on_top
from haptonic.plots.spectra import averaged, finished, running_mean
from haptonic.plots.stage import Stage, stage
from haptonic.plots.text import absolute, gap_text, in_pi
from haptonic.units import in_percent

if TYPE_CHECKING:
    from haptonic.vibrometry import Drive, LatticeGap, MeasuredGap, Quality


FLOOR = -80.0  # dB below the largest line, the lowest that a spectrum of a drive shows
LEAST_NOISE = 1e-6  # of 1 less the coherence, for its logarithm
TENFOLD = 10.0  # the least range of the scale of noise
ROWS = 600  # of a map of waves at most: more than its picture has
COLUMNS = 1200  # of a map of waves at least
BEYOND = 1.5  # times the largest computed wavenumber that are in view
RANGE = 1e-2  # of the largest amplitude, the smallest in a map of waves
DARK_PURPLE = "#8a4a70"  # of text
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
    style.logarithmic(axes)
    there = np.where(amplitude > 0, factor * amplitude, np.nan)
    handles = averaged(axes, frequency, {"all points": there}, logarithmic=True)
    axes.set_ylabel(f"{origin}\nrms velocity ({unit})")
    finished(axes, frequency)
    on.legend(handles if len(handles) > 1 else [])
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
    """Contrasts of a scan (dB; NaN where noise hides it) and the range of high contrast.

    The computed gap is shaded; the range of the scan is a bar on the upper edge, its errors thinner.
    """
    on = stage(ax, 8.6)
    axes = on.axes
    handles = averaged(axes, frequency, contrasts)
    axes.axhline(0, color=style.INK, lw=0.7, zorder=1)
    axes.set_ylabel(f"{origin} contrast (dB)")
    finished(axes, frequency, computed, name="computed gap")
    if gap is not None:
        ends = (gap.lower / 1e3, gap.lower_error / 1e3), (gap.upper / 1e3, gap.upper_error / 1e3)
        span_on_top(axes, *ends, style.PURPLE)
        text = f"high contrast {gap_text(gap)}"
        above(axes, [(0.5 * (ends[0][0] + ends[1][0]), text, DARK_PURPLE)], int(bool(computed)))
    on.legend(handles, ncols=2)
    return on.figure


@style.drawn
def decay_map(
    fades: xr.DataArray,
    gap: LatticeGap | None,
    computed: tuple[float, float] | None,
    *,
    origin: str,
    ax: Axes | None = None,
) -> Figure:
    """Decay of waves from row to row of a lattice, and the experimental edges of the gap that follow from it.

    Means over frequency of the slowest-decaying wave, and the middle half of all phases along the rows.
    Values hidden by noise are left out.
    """
    on = stage(ax, 8.6)
    axes = on.axes
    frequency = fades["frequency"].values
    smooth = np.stack([running_mean(column) for column in fades.values.T], axis=1)
    known = np.isfinite(smooth).any(axis=1)
    least, low, high = (np.full(len(frequency), np.nan) for _ in range(3))
    least[known] = np.nanmin(smooth[known], axis=1)
    low[known], high[known] = np.nanquantile(smooth[known], (0.25, 0.75), axis=1)
    color = colours([style.BLUE])[0]
    handles: list[Artist] = [
        *axes.plot(frequency / 1e3, least, color=color, lw=1.6, label="slowest-decaying wave",
                   gid="least"),
        axes.fill_between(frequency / 1e3, low, high, color=color, alpha=0.2, lw=0, gid="half",
                          label="half of the phases along the rows"),
    ]  # fmt: skip
    axes.set_ylabel(f"{origin}\ndecay (dB per row)")
    axes.set_ylim(0, 1.05 * max(float(np.nanmax(high, initial=0.0)), 1.0))
    finished(axes, frequency, computed, name="computed gap")
    edges = [edge for edge in (gap.lower, gap.upper) if edge] if gap else []
    for number, edge in enumerate(edges, start=int(bool(computed))):
        end = edge.frequency / 1e3, edge.error / 1e3
        span_on_top(axes, end, end, style.PURPLE)
        side = "lower" if gap and edge is gap.lower else "upper"
        above(axes, [(end[0], f"{side} edge (experimental) {edge}", DARK_PURPLE)], number)
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
    waves : (frequency, wavenumber) from `haptonic.vibrometry.wavenumber_map`
    plain : frequency (Hz) and wavenumber (rad/m) of the flexural wave of the plate
    guided : the same of the guide's mode without nodal lines along it; empty if it has none in the gap
    """
    on = stage(ax, 10.5)
    axes = on.axes
    starts = np.unique(np.linspace(0, waves.sizes["frequency"], ROWS, endpoint=False).astype(int))
    frequency = waves["frequency"].values[starts] / 1e3
    amplitude, wavenumber = _finer(waves.values, waves["wavenumber"].values / 1e3)
    amplitude = np.maximum.reduceat(amplitude / amplitude.max(), starts, axis=0)
    image = axes.pcolormesh(
        wavenumber, frequency, np.maximum(amplitude, RANGE), norm=LogNorm(RANGE, 1), cmap=style.amount(),
        shading="nearest", rasterized=True,
    )  # fmt: skip
    drawn: list[Artist] = []
    known = [curve[1].max() / 1e3 for curve in (plain, guided) if curve is not None and len(curve[1])]
    reach = min(float(wavenumber[-1]), BEYOND * max(known)) if known else float(wavenumber[-1])
    looks: tuple[dict[str, Any], ...] = (
        {"color": style.RED, "ls": style.DASHED, "lw": 1.0, "label": "A0 of the plain plate, computed"},
        {"color": style.ORANGE, "lw": 1.6, "label": "mode of the guide, computed"},
    )
    for curve, look in zip((plain, guided), looks, strict=True):
        if curve is None or not len(curve[0]):
            continue
        for sign in (1, -1):
            drawn += axes.plot(sign * curve[1] / 1e3, curve[0] / 1e3, **look)[: 1 if sign > 0 else 0]
    if guided is not None and not len(guided[0]):
        drawn.append(Line2D([], [], ls="none", label="no mode of the guide in the gap"))
    axes.set(xlabel=f"wavenumber along the region {region} (rad/mm)", ylabel="frequency (kHz)",
             xlim=(-reach, reach), ylim=(frequency[0], frequency[-1]))  # fmt: skip
    on.figure.colorbar(
        image, ax=axes, label=f"{origin} amplitude\n/ its maximum (dimensionless)", format=style.PowersOfTen()
    )
    on.legend(drawn, ncols=2)
    return on.figure


def _finer(amplitude: Array, wavenumber: Array) -> tuple[Array, Array]:
    """Amplitudes (f, k) and their wavenumbers (k,), so many that they are not seen one by one.

    The transform was padded with zeros. Its square is then that of an autocorrelation with zeros at its end;
    more of these give the values between the computed wavenumbers exactly.
    """
    count = len(wavenumber)
    times = -(-COLUMNS // count)
    lags = np.fft.rfft(amplitude**2, axis=1)
    if count % 2 == 0:
        lags[:, -1] *= 0.5  # it counts for both signs
    squared = times * np.fft.irfft(lags, n=times * count, axis=1)
    # periodic: the values beyond the last wavenumber lie between it and the first one
    finer = wavenumber[0] + (wavenumber[1] - wavenumber[0]) * np.arange(times * count) / times
    return np.sqrt(np.maximum(squared, 0.0)), finer


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
    lines = decay["frequency"].values
    confidence = float(decay.attrs["confidence"])
    color = colours([style.BLUE])[0]
    handles: list[Artist] = [
        *axes.plot(lines / 1e3, decay["decay"], color=color, lw=1.0, label="in the scan, fitted"),
        axes.fill_between(lines / 1e3, decay["low"], decay["high"], color=color, alpha=0.25, lw=0,
                          label=f"its {in_percent(confidence)} interval"),
    ]  # fmt: skip
    if computed is not None:
        dashes = (style.SOLID, style.DASHED, style.DOTTED)
        for phase, look in zip(computed["phase"].values, dashes, strict=False):
            level = computed["attenuation"].sel(phase=phase)
            handles += axes.plot(
                computed["frequency"] / 1e3, level, color=style.RED, ls=look, lw=1.2,
                label=f"computed, phase {in_pi(float(phase))}",
            )  # fmt: skip
    axes.axhline(0, color=style.INK, lw=0.7, zorder=1)
    axes.set_ylabel(f"{origin}\ndecay (dB per row)")
    finished(axes, lines, gap, name="computed gap")
    on.legend(handles, ncols=2)
    return on.figure


@style.drawn
def point_quality(points: Array, quality: Quality, *, origin: str, ax: Axes | None = None) -> Figure:
    """Share of noise at every point of a scan, 1 less the median coherence, and the points with flags."""
    width, height = np.maximum(np.ptp(points, axis=0), 1e-9)
    across = 0.8
    on = Stage(style.suited(min(max(0.62 * height / width, 0.2), 1.1), 9, across).add_subplot(), own=True)
    if ax is not None:
        on = stage(ax, 0.0)
    axes = on.axes
    known = np.isfinite(quality.coherence)
    x, y = 1e3 * points.T
    # squares that touch, in points of type squared
    wide = 0.75 * across * choice().look.width / 2.54 * 72
    area = max(0.5, wide * np.sqrt(width * height / len(points)) / width) ** 2
    if known.any():
        noise = np.maximum(1 - quality.coherence[known], LEAST_NOISE)
        norm = LogNorm(
            max(LEAST_NOISE, 0.9 * float(noise.min())), max(float(noise.max()), TENFOLD * noise.min())
        )
        image = axes.scatter(
            x[known], y[known], area, noise, marker="s", linewidths=0, cmap=style.amount(), norm=norm,
            rasterized=True,
        )  # fmt: skip
        bar = on.figure.colorbar(
            image, ax=axes, location="bottom", aspect=25, pad=0.03, format=style.PowersOfTen()
        )
        bar.set_label(f"{origin} 1 - median coherence\n(dimensionless)")
    else:
        axes.scatter(x, y, area, marker="s", linewidths=0, color=style.PALE_INK, rasterized=True)
    for flag, (colour, marker) in BAD.items():
        here = quality.flagged(flag)
        if here.any():
            edge = {"color": colour} if marker == "+" else {"facecolors": "none", "edgecolors": colour}
            axes.scatter(x[here], y[here], 34, marker=marker, linewidths=1.1, zorder=3,
                         label=f"{flag} ({here.sum()})", **edge)  # type: ignore[arg-type]  # fmt: skip
    axes.set(aspect="equal", xlabel="x (mm)", ylabel="y (mm)")
    if quality.flagged().any():
        on.legend(ncols=4)
    return on.figure
