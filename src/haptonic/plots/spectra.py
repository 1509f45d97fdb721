"""A plate at every frequency: contrast between regions, their velocities, the admittance of the drive."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import cycle
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from haptonic.arrays import AnyComplex, Array
from haptonic.plots import style
from haptonic.plots.looks import colours
from haptonic.plots.marks import Gap, mark
from haptonic.plots.stage import stage
from haptonic.plots.text import absolute, driven, label, prefixed
from haptonic.units import hz_text

Looks = Sequence[tuple[str, Any]]

LOOKS = tuple(
    zip(
        (style.BLUE, style.RED, style.GREEN, style.PURPLE, style.ORANGE),
        (style.SOLID, style.DASHED, style.DASH_DOTTED, style.DOTTED, style.DASH_DOT_DOTTED),
        strict=True,
    )
)
DENSE = 150  # lines, above which a curve is a pale one with its mean on top
WINDOWS = 40  # of a mean, side by side along the axis
PALE = 0.4  # opacity of a curve below its mean


@style.drawn
def contrast_spectrum(
    frequency: Array,
    contrast: Mapping[str, Array],
    gaps: Sequence[tuple[float, float]],
    *,
    carrier: float | None = None,
    origin: str = "",
    ax: Axes | None = None,
) -> Figure:
    """Contrast between regions against frequency.

    With many lines each curve is pale, with its running mean on top.

    Parameters
    ----------
    frequency : (frequency,) Hz
    contrast : label of each curve and its values (frequency,), dB
    gaps : edges of the band gaps, Hz; carrier : Hz
    origin : of the data, "simulated" or "measured"
    """
    on = stage(ax, _height(len(contrast)))
    axes = on.axes
    handles = averaged(axes, frequency, contrast)
    axes.axhline(0, color=style.INK, lw=0.7, zorder=1, gid="zero")
    axes.set_ylabel(f"{origin} contrast (dB)".strip())
    finished(axes, frequency, *gaps, carrier=carrier)
    on.legend(handles, ncols=2)
    return on.figure


@style.drawn
def velocity_spectrum(
    frequency: Array,
    velocity: Mapping[str, Array],
    gaps: Sequence[tuple[float, float]],
    *,
    units: str = "m/s/V",
    drive: float | None = None,
    carrier: float | None = None,
    origin: str = "",
    ax: Axes | None = None,
) -> Figure:
    """Root-mean-square velocity of regions against frequency, on a logarithmic scale.

    With many lines each curve is pale, with the running mean of its level on top.

    Parameters
    ----------
    frequency : (frequency,) Hz
    velocity : name of each region and its values (frequency,), in ``units``; zeros are not drawn
    drive : amplitude of the drive by which the velocity is divided, if it is known
    gaps : edges of the band gaps, Hz; carrier : Hz
    origin : of the data, "simulated" or "measured"
    """
    on = stage(ax, _height(len(velocity)))
    axes = on.axes
    largest = max((float(np.nanmax(values, initial=0.0)) for values in velocity.values()), default=0.0)
    unit, factor = absolute(units, largest, drive)
    positive = {name: np.where(values > 0, factor * values, np.nan) for name, values in velocity.items()}
    style.logarithmic(axes)
    handles = averaged(axes, frequency, positive, logarithmic=True)
    axes.set_ylabel(f"{origin} rms velocity\n({unit}){driven(units, drive)}".strip())
    finished(axes, frequency, *gaps, carrier=carrier)
    on.legend(handles, ncols=4)
    return on.figure


@style.drawn
def impedance_spectrum(
    frequency: Array, impedance: AnyComplex, gaps: Sequence[tuple[float, float]], *, origin: str = ""
) -> Figure:
    """Electrical admittance of an actuator: conductance, which takes up power, above capacitance.

    The magnitude of an impedance is hidden below that of the capacitor, which falls as 1 / omega.

    Parameters
    ----------
    frequency : (frequency,) Hz, above 0
    impedance : (frequency,) ohm
    gaps : edges of the band gaps, Hz
    origin : of the data, "simulated" or "measured"
    """
    figure = style.blank(10.5)
    above, below = figure.subplots(2, 1, sharex=True)
    admittance = 1 / impedance
    color = colours([style.BLUE])[0]
    for axes, values, name in (
        (above, admittance.real, "conductance"),
        (below, admittance.imag / (2 * np.pi * frequency), "capacitance"),
    ):
        largest = float(np.nanmax(np.abs(values)))
        unit, factor = prefixed(largest, "S" if axes is above else "F")
        axes.plot(frequency / 1e3, factor * values, color=color, lw=1.0, gid="curve")
        axes.set_ylabel(f"{name} ({unit})")
        if axes is above and (values > 0).all():  # below zero is an error of measurement, and has to be seen
            style.logarithmic(axes)
    finished(above, frequency, *gaps)
    finished(below, frequency, *gaps, named=False)
    above.set_xlabel("")
    below.set_xlabel(f"frequency (kHz){', ' if origin else ''}{origin}")
    return figure


def _height(curves: int) -> float:
    """Height of a figure with a number of curves and their legend, cm."""
    return 7.6 + 0.5 * (-(-curves // 2))


def curves(
    axes: Axes, frequency: Array, values: Mapping[str, Array], looks: Looks = LOOKS, width: float = 1.2
) -> list[Artist]:
    """Draw curves by name; return handles for the legend."""
    tints = colours([colour for colour, _ in looks])
    return [
        axes.plot(frequency / 1e3, curve, color=colour, ls=dashes, lw=width, label=label(name), gid="curve")[
            0
        ]
        for (name, curve), colour, (_, dashes) in zip(
            values.items(), cycle(tints), cycle(looks), strict=False
        )
    ]


def averaged(
    axes: Axes, frequency: Array, values: Mapping[str, Array], *, logarithmic: bool = False
) -> list[Artist]:
    """Draw curves by name, pale with running means if they have many lines; return handles for a legend."""
    if len(frequency) <= DENSE:
        return curves(axes, frequency, values)
    pale = [(colour, style.SOLID) for colour, _ in LOOKS]
    for line in curves(axes, frequency, values, pale, 0.5):
        line.set(alpha=PALE, label=None)
    means = {
        name: np.exp(running_mean(np.log(curve))) if logarithmic else running_mean(curve)
        for name, curve in values.items()
    }
    handles = curves(axes, frequency, means, width=1.6)
    for line in handles:
        line.set_gid("mean")
    window = (frequency[-1] - frequency[0]) / WINDOWS
    (every,) = axes.plot([], [], color=style.PALE_INK, lw=0.5, label="pale: every frequency")
    (mean,) = axes.plot(
        [], [], color=style.PALE_INK, lw=1.6, label=f"mean over {hz_text(window, form='.2g')}"
    )
    return [*handles, every, mean]


def running_mean(values: Array) -> Array:
    """Mean over a window about each line, of the values that are known there; NaN where none is known."""
    half = max(1, len(values) // (2 * WINDOWS))
    known = np.isfinite(values)
    sums = [
        np.convolve(part, np.ones(2 * half + 1), "same") for part in (np.where(known, values, 0.0), known)
    ]
    return np.asarray(np.divide(sums[0], sums[1], out=np.full(len(values), np.nan), where=sums[1] > 0))


def finished(
    axes: Axes,
    frequency: Array,
    *gaps: Gap,
    carrier: float | None = None,
    name: str = "band gap",
    named: bool = True,
) -> None:
    """The axis of frequencies, with the gaps and the carrier (Hz) in it."""
    axes.set_xlabel("frequency (kHz)")
    axes.set_xlim(frequency[0] / 1e3, frequency[-1] / 1e3)
    mark(axes, *gaps, carrier=carrier, name=name, named=named)
