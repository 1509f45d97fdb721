"""Maps of a vibration over a plate: side by side, one above another, and moving."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import scipy
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.ticker import MaxNLocator
from PIL import Image

from haptonic.arrays import AnyComplex, Array
from haptonic.errors import ResponseError
from haptonic.plate.layout import Layout
from haptonic.plots import style
from haptonic.plots.plates import HALO, region_borders, rows_of
from haptonic.response import FrequencyResponse
from haptonic.store import refuse_overwrite, write_atomically

FRAMES = 24  # of a cycle
FRAME_SECONDS = 0.05
FRAME_DOTS = 110  # per inch
FINER = 5  # places of a map along a step of points that lie on no grid
MOST_PLACES = 800  # along either side of such a map
NEAR = 0.75  # of a step, to which a point is shown: the corner of a square around it


def maps(
    response: FrequencyResponse,
    frequencies: Sequence[float],
    layout: Layout | None,
    gap: tuple[float, float] | None,
) -> Figure:
    """Normal vibration of the flat face at some frequencies, side by side, as in Fig. 5C of the paper.

    Each map shows the moment at which its largest point is farthest out, and is scaled to that point.

    Parameters
    ----------
    response : with the direction z; of points that lie on no regular grid each place shows the nearest one
    frequencies : one for each map, Hz; the nearest lines are drawn
    layout : its outlines are drawn; without one, the points alone
    gap : edges of the band gap, Hz, or None
    """
    return maps_compared({"": response}, frequencies, layout, gap)


@style.drawn
def maps_compared(
    rows: Mapping[str, FrequencyResponse],
    frequencies: Sequence[float],
    layout: Layout | None,
    gap: tuple[float, float] | None,
) -> Figure:
    """Maps of several responses at the same frequencies, by name one below the other; see `maps`."""
    first = next(iter(rows.values()))
    column = (style.WIDTH - 2.0) / max(len(frequencies), 2)
    tall = min(column * _slenderness(first, layout), 16.0)
    figure = style.blank(len(rows) * (tall + 0.9) + 2.9)
    panels = figure.subplots(len(rows), len(frequencies), sharex=True, sharey=True, squeeze=False)
    for row, (name, response) in zip(panels, rows.items(), strict=True):
        for axes, asked in zip(row, frequencies, strict=True):
            line = response.at(asked)
            image = _draw_map(axes, line, layout)
            title = f"{line.frequency[0] / 1e3:.1f} kHz, {response.dataset.attrs['origin']}"
            axes.set_title("\n".join(filter(None, [_beside(line.frequency[0], gap), title])), fontsize=9)
            axes.label_outer()
        row[0].set_ylabel(f"{name}\ny (mm)" if name else "y (mm)")
    _colour_bar(figure, list(panels.flat), image, first)
    return figure


def animated(
    path: Path,
    response: FrequencyResponse,
    frequency: float,
    layout: Layout | None,
    *,
    overwrite: bool = False,
) -> Path:
    """Write one cycle of the vibration at a frequency (Hz) as a moving picture, WebP, that repeats for ever.

    It shows the real part of response times exp(i omega t), in `FRAMES` pictures, over its largest value.

    Raises
    ------
    ResourceError : the name is taken and ``overwrite`` is False, or the folder cannot be written
    """
    refuse_overwrite(path, overwrite)
    with style.styled():
        tall = 6.5 * _slenderness(response, layout)
        figure = style.blank(min(tall, 16.0) + 4.0, 9.0)
        axes = figure.add_subplot()
        line = response.at(frequency)
        image = _draw_map(axes, line, layout)
        shown = line.frequency[0]
        cycle = f"; one cycle of {1e6 / shown:.3g} µs" if shown else ""
        axes.set_title(f"{shown / 1e3:.1f} kHz, {response.dataset.attrs['origin']}{cycle}", fontsize=9)
        axes.set_ylabel("y (mm)")
        _colour_bar(figure, [axes], image, response)
        figure.draw_without_rendering()
        figure.set_layout_engine("none")  # every frame has the same arrangement
        shape, frames = _seen(line)[0], []
        for number in range(FRAMES):
            image.set_data((shape * np.exp(2j * np.pi * number / FRAMES)).real)
            stream = io.BytesIO()
            figure.savefig(stream, format="png", dpi=FRAME_DOTS)
            frames.append(Image.open(stream).convert("RGB"))
    write_atomically(
        path,
        lambda temporary: frames[0].save(
            temporary, format="WEBP", save_all=True, append_images=frames[1:],
            duration=round(1e3 * FRAME_SECONDS), loop=0, quality=80,
        ),
    )  # fmt: skip
    return path


def _seen(line: FrequencyResponse) -> tuple[AnyComplex, tuple[float, float], tuple[float, float]]:
    """(y, x) normal vibration at one frequency over that of its largest point; its ends along x and y, mm.

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
    scaled = np.asarray(shape / largest if largest else shape)
    return scaled, ends(1e3 * x), ends(1e3 * y)


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


def _draw_map(axes: Axes, line: FrequencyResponse, layout: Layout | None) -> AxesImage:
    """The vibration at one frequency when its largest point is farthest out, and the regions around it."""
    shape, x, y = _seen(line)
    image = axes.imshow(
        shape.real, cmap=style.diverging(), norm=Normalize(-1, 1), origin="lower",
        extent=(*x, *y), interpolation="nearest", gid="map",
    )  # fmt: skip
    outlined(axes, layout)
    return image


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


def _colour_bar(figure: Figure, panels: list[Axes], image: AxesImage, response: FrequencyResponse) -> None:
    bar = figure.colorbar(image, ax=panels, location="bottom", shrink=0.6, aspect=30, pad=0.02)
    bar.set_label(f"normal {response.dataset.attrs['quantity']} / its maximum (dimensionless)")
    bar.set_ticks([-1, -0.5, 0, 0.5, 1])


def _beside(frequency: float, gap: tuple[float, float] | None) -> str:
    if gap is None:
        return ""
    return "below the gap" if frequency < gap[0] else "above the gap" if frequency > gap[1] else "in the gap"
