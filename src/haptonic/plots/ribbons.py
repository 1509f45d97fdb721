"""Projected bands of a ribbon, and the field of one of its modes."""

from __future__ import annotations

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.tri import Triangulation

from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.stage import stage
from haptonic.units import hz_text

LONG, MOST_PERIODS = 1.5, 30  # of a drawn field: its length over its width, and the most periods of it
FADED = 0.12  # opacity of a bulk band's shade: where bands overlap it is darker
SAME = 1e-4  # of the highest frequency: two crystals whose bulk bands differ less are mirror images
PALEST = 0.6  # place on viridis above which colours have a contrast of less than 3 with white
DIRECTIONS = ("across the ribbon", "along the ribbon", "normal to the plate")


@style.drawn
def projected(dataset: xr.Dataset, *, ax: Axes | None = None) -> Figure:
    """Frequency against phase along the ribbon: bulk bands shaded, modes as dashes along their slope.

    Above the last bulk band that was computed all is shaded.

    Parameters
    ----------
    dataset : from `haptonic.results.ribbon`
    """
    on = stage(ax, 11.5)
    axes = on.axes
    low, high = np.array(dataset.attrs["range_hz"]) / 1e3
    phase = dataset["wavevector_phase"].values / np.pi
    lower, upper = (dataset[f"bulk_{end}"].values / 1e3 for end in ("lower", "upper"))
    mirrored = len(lower) == 2 and max(np.ptp(edges, axis=0).max() for edges in (lower, upper)) < SAME * high
    shown = 1 if mirrored else len(lower)
    opacity = 2.5 * FADED if shown == 1 else 1.5 * FADED
    handles: list[Artist] = []
    for number in range(shown):
        below, above = lower[number], upper[number]
        colour = (style.SKY, style.ORANGE, style.PALE_INK)[number % 3]
        for band in range(below.shape[1]):
            if above[:, band].max() > low and below[:, band].min() < high:
                axes.fill_between(
                    phase, below[:, band], above[:, band], color=colour, lw=0, alpha=opacity, gid="bulk"
                )
        axes.fill_between(phase, below[:, -1], max(high, below[:, -1].max()), facecolor=style.BEYOND, lw=0)
        crystal = " of both crystals" if mirrored else f" of crystal {number + 1}" if shown > 1 else ""
        handles.append(Patch(color=colour, lw=0, alpha=opacity, label=f"bulk bands{crystal}"))
    if any((below[:, -1] < high).any() for below in lower):
        handles.append(Patch(facecolor=style.BEYOND, lw=0, label="not computed"))
    at, frequency = dataset["phase"].values / np.pi, dataset["frequency"].values / 1e3
    step = 0.45 * (float(np.diff(phase).min()) if len(phase) > 1 else 0.02)
    rise = dataset["group_velocity"].values / (2 * dataset.attrs["period"]) / 1e3 * step
    ends = np.stack(
        [np.column_stack([at - step, frequency - rise]), np.column_stack([at + step, frequency + rise])], 1
    )
    order = np.argsort(dataset["guide_share"].values)
    lines = LineCollection(list(ends[order]), cmap=dark_on_white(), lw=1.6, gid="modes")
    lines.set_array(dataset["guide_share"].values[order])
    lines.set_clim(0.0, 1.0)
    axes.add_collection(lines)
    kind = dataset.attrs["kind"]
    there = {"strip": "in the outermost columns", "edge": "at the edge"}.get(kind, f"in the {kind}")
    on.figure.colorbar(lines, ax=axes, label=f"share of energy {there} (dimensionless)")
    axes.set_xlim(0, 1)
    axes.set_ylim(low, high)
    carrier = dataset.attrs.get("carrier_hz")
    if carrier is not None and low < carrier / 1e3 < high:
        name = f"carrier {hz_text(carrier, form='g')}"  # below the axes: the scale of colours is beside them
        handles.append(
            axes.axhline(
                carrier / 1e3, color=style.CARRIER, ls=style.DASHED, lw=1.1, gid="carrier", label=name
            )
        )
    on.legend(handles)
    axes.set_xlabel("phase along the ribbon / π (dimensionless)")
    axes.set_ylabel("frequency (kHz)")
    return on.figure


def dark_on_white() -> ListedColormap:
    """Colours for a share, from green for 0 to violet for 1; each is clear as a line on white."""
    return ListedColormap(style.perceptual()(np.linspace(PALEST, 0, 256)))


@style.drawn
def ribbon_field(dataset: xr.Dataset, *, ax: Axes | None = None) -> Figure:
    """The field of one mode over a few periods of the ribbon, which runs from left to right here.

    Parameters
    ----------
    dataset : from `haptonic.results.ribbon`
    """
    points = 1e3 * dataset["field_position"].values
    field = dataset["field_real"].values + 1j * dataset["field_imag"].values
    turn, period = float(dataset["field_phase"]), 1e3 * float(dataset.attrs["period"])
    wide = float(np.ptp(points[:, 0]))
    least = 1 if dataset.attrs["kind"] == "defect" else 2
    periods = min(MOST_PERIODS, max(least, round(LONG * wide / period)))
    first = float(points[:, 1].min())
    leaning = round((float(np.ptp(points[:, 1])) - period) / period)  # periods of an oblique ribbon
    on = stage(ax, min(17.0, 2.8 + (style.WIDTH - 4.5) * wide / (periods * period)))
    axes = on.axes
    axes.set_aspect("equal")
    drawn = None
    for number in range(-leaning, periods):  # all copies that reach into the drawn rectangle
        there = Triangulation(points[:, 1] + number * period, points[:, 0], dataset["field_triangle"].values)
        drawn = axes.tripcolor(
            there, (field * np.exp(1j * number * turn)).real, shading="gouraud", cmap=style.diverging(),
            vmin=-1, vmax=1, rasterized=True,
        )  # fmt: skip
    assert drawn is not None
    axes.set_xlim(first, first + periods * period)
    axes.set_ylim(points[:, 0].min(), points[:, 0].max())
    if dataset.attrs["kind"] == "edge":
        names = dataset["cell_name"].values[0]
        place = points[:, 0].min() + wide * (1 + int((names[1:] != names[:-1]).argmax())) / len(names)
        line = axes.axhline(place, color=style.INK, ls=style.DASHED, lw=0.9, gid="edge", label="edge")
        on.legend([line])
    axes.set_xlabel("position along the ribbon (mm)")
    axes.set_ylabel("position across (mm)")
    what = DIRECTIONS[int(dataset["field_component"])]
    axes.set_title(
        f"{hz_text(float(dataset['field_frequency']), form='.2f')}, phase {turn / np.pi:.3f} π; {what}"
    )
    bar = axes.inset_axes((1.03, 0.0, 0.03, 1.0))  # as high as the axes
    on.figure.colorbar(drawn, cax=bar, label="displacement (dimensionless)")
    return on.figure
