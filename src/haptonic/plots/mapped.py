"""Maps of a vibration over a plate: side by side, one above another, and moving."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import scipy
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.ticker import MaxNLocator

from haptonic.arrays import AnyComplex, Array
from haptonic.errors import ResponseError
from haptonic.plate.layout import Layout
from haptonic.plots import style
from haptonic.plots.moving import moving
from haptonic.plots.plates import HALO, region_borders, rows_of
from haptonic.plots.stage import stage
from haptonic.plots.text import absolute, driven
from haptonic.response import FrequencyResponse
from haptonic.units import hz_text

Gap = tuple[float, float] | None

FINER = 5  # places of a map along a step of points that lie on no grid
MOST_PLACES = 800  # along either side of such a map
NEAR = 0.75  # of a step, to which a point is shown: the corner of a square around it


def maps(
    response: FrequencyResponse,
    frequencies: Sequence[float],
    layout: Layout | None,
    gap: Gap,
    *,
    drive: float | None = None,
) -> Figure:
    """Normal vibration of the flat face at some frequencies, side by side, as in Fig. 5C of the paper.

    Each map shows the moment at which its largest point is farthest out; its colours end at that point.

    Parameters
    ----------
    response : with the direction z; of points that lie on no regular grid each place shows the nearest one
    frequencies : one for each map, Hz; the nearest lines are drawn
    layout : its outlines are drawn; without one, the points alone
    gap : edges of the band gap, Hz, or None
    drive : amplitude of what the response is divided by, if it is known: then the map is what it moves
    """
    return maps_compared({"": response}, frequencies, layout, gap, drive=drive)


@style.drawn
def map_at(
    response: FrequencyResponse,
    frequency: float,
    layout: Layout | None,
    gap: Gap,
    *,
    drive: float | None = None,
    ax: Axes | None = None,
) -> Figure:
    """Normal vibration at one frequency; see `maps`."""
    on = stage(ax, min(11.0 * _slenderness(response, layout), 16.0) + 4.0, 12.0)
    _draw_map(on.axes, response.at(frequency), layout, gap, drive)
    return on.figure


@style.drawn
def maps_compared(
    rows: Mapping[str, FrequencyResponse],
    frequencies: Sequence[float],
    layout: Layout | None,
    gap: Gap,
    *,
    drive: float | None = None,
) -> Figure:
    """Maps of several responses at the same frequencies, by name one below the other; see `maps`."""
    first = next(iter(rows.values()))
    column = (style.WIDTH - 2.0) / max(len(frequencies), 2)
    tall = min(column * _slenderness(first, layout), 16.0)
    figure = style.blank(len(rows) * (tall + 4.0) + 0.4)
    panels = figure.subplots(len(rows), len(frequencies), sharex=True, sharey=True, squeeze=False)
    for row, (name, response) in zip(panels, rows.items(), strict=True):
        for axes, asked in zip(row, frequencies, strict=True):
            _draw_map(axes, response.at(asked), layout, gap, drive)
            axes.label_outer()
        row[0].set_ylabel(f"{name}\ny (mm)" if name else "y (mm)")
    return figure


def animated(
    response: FrequencyResponse, frequency: float, layout: Layout | None, *, drive: float | None = None
) -> bytes:
    """One cycle of the vibration at a frequency (Hz); see `haptonic.plots.moving`.

    It shows the real part of response times exp(i omega t), with a scale as in `maps`.
    """
    line = response.at(frequency)
    with style.styled():
        figure = style.blank(min(6.5 * _slenderness(response, layout), 16.0) + 4.0, 9.0)
        axes = figure.add_subplot()
        image, shape = _draw_map(axes, line, layout, None, drive)
        if line.frequency[0]:
            cycle = f"one cycle of {1e6 / line.frequency[0]:.3g} µs"
            axes.set_title(f"{axes.get_title()}\n{cycle}", fontsize=9)
        return moving(figure, lambda turn: image.set_data((shape * turn).real))


def _seen(line: FrequencyResponse) -> tuple[AnyComplex, tuple[float, float], tuple[float, float]]:
    """(y, x) normal vibration at one frequency, with its largest point farthest out; its ends, mm.

    Points that lie on no regular grid, as when a stage was turned, are drawn finer than they lie: every place
    shows its nearest point, and nothing where that is too far.
    """
    try:
        grid = line.grid()
    except ResponseError:
        shape, x, y = _nearest(line)
    else:
        shape, x, y = np.asarray(grid.sel(direction="z").values[0]), grid["x"].values, grid["y"].values
    largest = shape.flat[np.nanargmax(np.abs(shape))]
    turned = np.asarray(shape * (np.conj(largest) / abs(largest)) if largest else shape)
    return turned, ends(1e3 * x), ends(1e3 * y)


def _nearest(line: FrequencyResponse) -> tuple[AnyComplex, Array, Array]:
    """(y, x) normal vibration at the nearest point, NaN where there is none near, and these places, m."""
    points, tree = line.points, scipy.spatial.cKDTree(line.points)
    step = float(np.median(tree.query(points, k=2)[0][:, 1]))
    low, high = points.min(axis=0) - 0.5 * step, points.max(axis=0) + 0.5 * step
    count = np.maximum(1, np.minimum(np.rint(FINER * (high - low) / step), MOST_PLACES)).astype(int)
    x, y = (a + (b - a) * (np.arange(n) + 0.5) / n for a, b, n in zip(low, high, count, strict=True))
    distance, number = tree.query(np.stack(np.meshgrid(x, y), axis=-1))
    values = line.values[0, :, list(line.dataset["direction"].values).index("z")]
    return np.where(distance <= NEAR * step, values[number], np.nan), x, y


def _slenderness(response: FrequencyResponse, layout: Layout | None) -> float:
    """Height over width of what a map shows."""
    if layout is not None:
        return (layout.y[-1] - layout.y[0]) / (layout.x[-1] - layout.x[0])
    width, height = np.ptp(response.points, axis=0)
    return float(height / width) if width else 1.0


def _draw_map(
    axes: Axes, line: FrequencyResponse, layout: Layout | None, gap: Gap, drive: float | None
) -> tuple[AxesImage, AnyComplex]:
    """The vibration at one frequency, the regions around it and its scale; the picture and its values."""
    shape, x, y = _seen(line)
    largest, frequency = float(np.nanmax(np.abs(shape))), float(line.frequency[0])
    unit, factor = absolute(line.units, largest, drive)
    shape = np.asarray(factor * shape)
    most = factor * largest or 1.0
    # a simulated field is smooth between its points; measured points are shown as they are
    is_smooth = line.dataset.attrs["origin"] == "simulated" and bool(np.isfinite(shape).all())
    image = axes.imshow(
        shape.real, cmap=style.diverging(), norm=Normalize(-most, most), origin="lower",
        extent=(*x, *y), interpolation="bicubic" if is_smooth else "nearest", gid="map",
    )  # fmt: skip
    outlined(axes, layout)
    axes.set_ylabel("y (mm)")
    figure = axes.get_figure(root=True)
    assert figure is not None
    bar = figure.colorbar(image, ax=axes, location="bottom", aspect=18, pad=0.03)
    bar.set_label(f"normal {line.dataset.attrs['quantity']} ({unit})")
    bar.locator = MaxNLocator(4, symmetric=True)
    bar.update_ticks()
    said = [
        _beside(frequency, gap),
        f"{hz_text(frequency, form='.1f')}, {line.dataset.attrs['origin']}",
    ]
    if frequency and line.dataset.attrs["quantity"] == "velocity":
        moved, times = absolute(line.units.replace("m/s", "m", 1), largest / (2 * np.pi * frequency), drive)
        said.append(
            f"up to {largest / (2 * np.pi * frequency) * times:.3g} {moved}{driven(line.units, drive)}"
        )
    axes.set_title("\n".join(filter(None, said)), fontsize=9)
    return image, shape


def outlined(axes: Axes, layout: Layout | None) -> None:
    """Set axes to a plate's size, in mm, and outline its regions with their names, if the plate is known."""
    axes.set_facecolor(style.BEYOND)
    axes.set_xlabel("x (mm)")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(4))
    if layout is None:
        return
    axes.set(xlim=(1e3 * layout.x[0], 1e3 * layout.x[-1]), ylim=(1e3 * layout.y[0], 1e3 * layout.y[-1]))
    for name in layout.regions:
        border = region_borders(layout, name)
        axes.add_collection(LineCollection(border, colors=style.INK, linewidths=0.9, gid=f"outline {name}"))
        x, _, top = max(rows_of(layout, name), key=lambda row: row[2])
        axes.annotate(
            name, (1e3 * x, 1e3 * top), xytext=(0, -4), textcoords="offset points",
            ha="center", va="top", fontsize=8.5, gid="region name", path_effects=HALO,
        )  # fmt: skip


def ends(middles: Array) -> tuple[float, float]:
    """Where a row of pictured points begins and ends: half a step beyond the outer ones."""
    step = middles[1] - middles[0] if len(middles) > 1 else 1.0
    return float(middles[0] - 0.5 * step), float(middles[-1] + 0.5 * step)


def _beside(frequency: float, gap: Gap) -> str:
    if gap is None:
        return ""
    return "below the gap" if frequency < gap[0] else "above the gap" if frequency > gap[1] else "in the gap"
