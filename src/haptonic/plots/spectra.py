"""What a plate does at every frequency: contrast between regions, their velocities, the drive's impedance."""

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
from haptonic.plots.stage import stage
from haptonic.plots.text import absolute, driven, label
from haptonic.units import hz_text

Gap = tuple[float, float] | None
Looks = Sequence[tuple[str, Any]]

PASSIVE = 95.0  # deg, phase of an impedance that takes up power, rounding included
LOOKS = tuple(
    zip(
        (style.BLUE, style.RED, style.GREEN, style.PURPLE, style.ORANGE),
        (style.SOLID, style.DASHED, style.DASH_DOTTED, style.DOTTED, style.DASH_DOT_DOTTED),
        strict=True,
    )
)


@style.drawn
def contrast_spectrum(
    frequency: Array,
    contrast: Mapping[str, Array],
    gap: Gap,
    *,
    origin: str = "",
    ax: Axes | None = None,
) -> Figure:
    """By how much one region vibrates more than another one, against frequency.

    Parameters
    ----------
    frequency : (frequency,) Hz
    contrast : label of each curve and its values (frequency,), dB
    gap : edges of the band gap, Hz, or None
    origin : of the data, "simulated" or "measured", the title
    """
    on = stage(ax, _height(len(contrast)))
    axes = on.axes
    handles = curves(axes, frequency, contrast)
    axes.axhline(0, color=style.INK, lw=0.7, zorder=1, gid="zero")
    axes.set_ylabel("contrast (dB)")
    finished(axes, frequency, origin)
    on.legend([*handles, *shaded(axes, frequency, gap)], ncols=2)
    return on.figure


@style.drawn
def velocity_spectrum(
    frequency: Array,
    velocity: Mapping[str, Array],
    gap: Gap,
    *,
    units: str = "m/s/V",
    drive: float | None = None,
    origin: str = "",
    ax: Axes | None = None,
) -> Figure:
    """Root-mean-square velocity of regions against frequency, on a logarithmic scale.

    Parameters
    ----------
    frequency : (frequency,) Hz
    velocity : name of each region and its values (frequency,), in ``units``; zeros are not drawn
    drive : amplitude of what the velocity is divided by, if it is known
    gap : edges of the band gap, Hz, or None
    origin : of the data, "simulated" or "measured", the title
    """
    on = stage(ax, _height(len(velocity)))
    axes = on.axes
    largest = max((float(values.max()) for values in velocity.values()), default=0.0)
    unit, factor = absolute(units, largest, drive)
    positive = {name: np.where(values > 0, factor * values, np.nan) for name, values in velocity.items()}
    handles = curves(axes, frequency, positive)
    style.logarithmic(axes)
    axes.set_ylabel(f"rms normal velocity of the region\n({unit}){driven(units, drive)}")
    finished(axes, frequency, origin)
    on.legend([*handles, *shaded(axes, frequency, gap)], ncols=2)
    return on.figure


@style.drawn
def impedance_spectrum(frequency: Array, impedance: AnyComplex, gap: Gap, *, origin: str = "") -> Figure:
    """Electrical impedance of an actuator: magnitude above phase.

    Parameters
    ----------
    frequency : (frequency,) Hz, above 0
    impedance : (frequency,) ohm
    gap : edges of the band gap, Hz, or None
    origin : of the data, "simulated" or "measured", the title
    """
    figure = style.blank(10.5)
    magnitude, phase = figure.subplots(2, 1, sharex=True, height_ratios=(3, 2))
    handles = curves(
        magnitude,
        frequency,
        {"electrical impedance of the actuator": np.asarray(np.abs(impedance), dtype=float)},
    )
    style.logarithmic(magnitude)
    magnitude.set_ylabel("magnitude (Ω)")
    degrees = np.asarray(np.angle(impedance, deg=True), dtype=float)
    curves(phase, frequency, {"phase": degrees})
    phase.set_ylabel("phase (deg)")
    passive = np.abs(degrees).max() <= PASSIVE  # more is an error of measurement, and has to be seen
    phase.set_ylim(*((-100, 100) if passive else (-190, 190)))
    phase.set_yticks([-90, -45, 0, 45, 90] if passive else [-180, -90, 0, 90, 180])
    shades = [shaded(axes, frequency, gap) for axes in (magnitude, phase)]
    finished(phase, frequency)
    magnitude.set_title(origin)
    figure.legend(handles=[*handles, *shades[0]], loc="outside lower center", ncols=2)
    return figure


def _height(curves: int) -> float:
    """Of a figure with so many curves, the gap and their legend, cm."""
    return 7.6 + 0.5 * (-(-(curves + 1) // 2))


def curves(
    axes: Axes, frequency: Array, values: Mapping[str, Array], looks: Looks = LOOKS, width: float = 1.2
) -> list[Artist]:
    """Draw curves by name; what the legend needs."""
    return [
        axes.plot(frequency / 1e3, curve, color=colour, ls=dashes, lw=width, label=label(name), gid="curve")[
            0
        ]
        for (name, curve), (colour, dashes) in zip(values.items(), cycle(looks), strict=False)
    ]


def shaded(axes: Axes, frequency: Array, gap: Gap, name: str = "band gap") -> list[Artist]:
    """Shade the gap where it is in view; what the legend needs."""
    if gap is None or gap[0] >= frequency[-1] or gap[1] <= frequency[0]:
        return []
    low, high = gap[0] / 1e3, gap[1] / 1e3
    shade = axes.axvspan(low, high, facecolor=style.GAP, edgecolor="none", zorder=0, gid="gap")
    shade.set_label(f"{name}, {hz_text(1e3 * low, 1e3 * high, form='.1f')}")
    return [shade]


def finished(axes: Axes, frequency: Array, title: str = "") -> None:
    """Title and the axis of frequencies."""
    axes.set_title(title)
    axes.set_xlabel("frequency (kHz)")
    axes.set_xlim(frequency[0] / 1e3, frequency[-1] / 1e3)
