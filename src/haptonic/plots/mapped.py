"""Maps of a vibration over a plate: side by side, one above another, and moving."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product

import matplotlib as mpl
import numpy as np
import scipy
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PatchCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.image import AxesImage
from matplotlib.patches import Rectangle
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from haptonic.arrays import AnyComplex, Array
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.sampling import tile_names
from haptonic.plots import style
from haptonic.plots.marks import LINE, Gap
from haptonic.plots.moving import moving
from haptonic.plots.plates import HALO, region_borders, rows_of
from haptonic.plots.stage import Stage, stage
from haptonic.plots.text import LETTER, absolute, driven, label, short
from haptonic.response import FrequencyResponse
from haptonic.response.rasters import point_map
from haptonic.units import hz_text

LOW = 0.45  # height over width of a map, below which maps are one above another
BAR = 0.9  # of the width of a figure, for the text below its colour bar
LETTERS = 26  # in a line above or below one of several maps


def maps(
    response: FrequencyResponse,
    frequencies: Sequence[float],
    layout: Layout | None,
    gap: Gap,
    *,
    drive: float | None = None,
) -> Figure:
    """Normal vibration of the flat face at some frequencies, side by side, as in Fig. 5C of the paper.

    Each map shows the moment at which its largest point is farthest out. All have one scale of colours.

    Parameters
    ----------
    response : with the direction z; of points that lie on no regular grid each place shows the nearest one
    frequencies : one for each map, Hz; the nearest lines are drawn
    layout : its outlines are drawn; without one, the points alone
    gap : edges of the band gap, Hz, or None
    drive : amplitude of the drive, if it is known: then the map shows the motion in place of the response
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
    on = _stage(response, layout, ax)
    _painted([on.axes], [_seen(response.at(frequency), drive, gap)], layout)
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
    slender = _slenderness(next(iter(rows.values())), layout)
    stacked = slender < LOW and len(rows) == 1  # side by side, the maps of a wide plate would be low strips
    grid = (len(frequencies), 1) if stacked else (len(rows), len(frequencies))
    seen = [_seen(response.at(asked), drive, gap) for response in rows.values() for asked in frequencies]
    figure, panels = _many(grid, stacked, slender)
    _painted(panels.ravel().tolist(), seen, layout)
    for axes in panels.ravel():
        axes.label_outer()
    if not stacked:
        for row, name in zip(panels, rows, strict=True):
            row[0].set_ylabel(f"{name}\ny (mm)" if name else "y (mm)")
    return figure


@style.drawn
def maps_of_drives(driven: Mapping[str, tuple[FrequencyResponse, float, Gap]], layout: Layout) -> Figure:
    """Maps of responses to different drives, side by side, each on its own scale; see `maps`.

    driven : by the names of the drives, the response at one frequency, the amplitude to multiply it by, and
        the edges of the gap around it, Hz
    """
    slender = _slenderness(next(iter(driven.values()))[0], layout)
    stacked = slender < LOW
    figure, panels = _many((len(driven), 1) if stacked else (1, len(driven)), stacked, slender)
    for axes, (name, (response, drive, gap)) in zip(panels.ravel(), driven.items(), strict=True):
        seen = replace(_seen(response, drive, gap), heading=textwrap.fill(label(f"{name} alone"), LETTERS))
        ((image, _),) = _painted([axes], [seen], layout)
        axes.label_outer()
        bar = image.colorbar
        assert bar is not None
        bar.set_label(textwrap.fill(bar.ax.get_xlabel(), LETTERS))
    return figure


def _many(grid: tuple[int, int], stacked: bool, slender: float) -> tuple[Figure, NDArray[np.object_]]:
    """A figure for a grid of maps, and its axes (rows, columns); ``stacked`` maps have its whole width."""
    across = 1 if stacked else max(grid[1], 2)
    tall = min(0.85 / across * slender, 1.1)
    figure = style.suited(
        grid[0] * tall, 5.5 * grid[0] + 4, min(1.0, 0.2 + 0.4 * grid[1]) if not stacked else 1.0
    )
    panels = figure.subplots(*grid, sharex=True, sharey=True, squeeze=False)
    return figure, panels


def animated(
    response: FrequencyResponse, frequency: float, layout: Layout | None, *, drive: float | None = None
) -> bytes:
    """One cycle of the vibration at a frequency (Hz); see `haptonic.plots.moving`.

    It shows the real part of response times exp(i omega t), with a scale as in `maps`.
    """
    seen = _seen(response.at(frequency), drive, None)
    with style.styled():
        on = _stage(response, layout, None)
        ((image, shape),) = _painted([on.axes], [seen], layout)
        if seen.frequency:
            # `set_title` would reset the distance that leaves room for the names of the regions
            on.axes.title.set_text(f"{on.axes.get_title()}, one cycle of {1e6 / seen.frequency:.3g} µs")
        return moving(on.figure, lambda turn: image.set_data((shape * turn).real))


@dataclass(frozen=True)
class Seen:
    """Normal vibration at one frequency (Hz), with its largest point farthest out.

    shape : (y, x), NaN where there is none; x, y : its ends, mm
    quantity, units : of the shape; drive : amplitude that it is multiplied by, if it is known
    gap : edges, Hz, or None; heading : first line above the map
    """

    shape: AnyComplex
    x: tuple[float, float]
    y: tuple[float, float]
    frequency: float
    quantity: str
    units: str
    drive: float | None
    origin: str
    gap: Gap
    heading: str = ""

    @property
    def largest(self) -> float:
        """Largest amplitude, SI."""
        return float(np.nanmax(np.abs(self.shape)))


def _stage(response: FrequencyResponse, layout: Layout | None, ax: Axes | None) -> Stage:
    """Axes for a single map."""
    if ax is not None:
        return stage(ax, 0.0)
    return Stage(
        style.suited(min(0.55 * _slenderness(response, layout), 1.1), 9, 0.7).add_subplot(), own=True
    )


def _seen(line: FrequencyResponse, drive: float | None, gap: Gap) -> Seen:
    """Vibration at the single frequency of a response, as displacement if velocity is given.

    Each place of the map shows the point that `point_map` gives.
    """
    number, x, y = point_map(line.points)
    values = line.values[0, :, list(line.dataset["direction"].values).index("z")]
    shape = np.where(number >= 0, values[number], np.nan)
    largest = shape.flat[np.nanargmax(np.abs(shape))]
    turned = np.asarray(shape * (np.conj(largest) / abs(largest)) if largest else shape)
    frequency, quantity, units = float(line.frequency[0]), str(line.dataset.attrs["quantity"]), line.units
    if frequency and quantity == "velocity":
        turned, quantity = turned / (2 * np.pi * frequency), "displacement"
        units = units.replace("m/s", "m", 1)
    origin = str(line.dataset.attrs["origin"])
    return Seen(
        shape=turned, x=ends(1e3 * x), y=ends(1e3 * y), frequency=frequency, quantity=quantity, units=units,
        drive=drive, origin=origin, gap=gap,
    )  # fmt: skip


def _painted(
    panels: Sequence[Axes], seen: Sequence[Seen], layout: Layout | None
) -> list[tuple[AxesImage, AnyComplex]]:
    """Maps on one scale of colours, the regions around them; each picture with its values as drawn."""
    first, most = seen[0], max(shape.largest for shape in seen)
    unit, factor = absolute(first.units, most, first.drive)
    limit = factor * most or 1.0
    images = []
    for axes, line in zip(panels, seen, strict=True):
        shape, absent = _continued(replace(line, shape=factor * line.shape), layout)
        # a simulated field is smooth between its points; measured points are shown as they are
        is_smooth = line.origin == "simulated" and bool(np.isfinite(shape).all())
        image = axes.imshow(
            shape.real, cmap=style.diverging(), norm=Normalize(-limit, limit), origin="lower",
            extent=(*line.x, *line.y), interpolation="bicubic" if is_smooth else "nearest", gid="map",
        )  # fmt: skip
        axes.add_collection(PatchCollection(absent, facecolor=style.BEYOND, linewidth=0, gid="absent tiles"))
        lines = outlined(axes, layout)
        axes.set_ylabel("y (mm)")
        # all numbers of a figure in one unit, so that they can be compared
        words = [line.heading, _beside(line.frequency, line.gap), hz_text(line.frequency, form=".1f"),
                 f"up to {factor * line.largest:.3g} {unit}"]  # fmt: skip
        axes.set_title("\n".join(filter(None, words)), pad=6 + lines * LINE * mpl.rcParams["font.size"])
        images.append((image, shape))
    figure = panels[0].get_figure(root=True)
    assert figure is not None
    bar = figure.colorbar(images[0][0], ax=list(panels), location="bottom", aspect=30, pad=0.03, shrink=0.8)
    origin = first.origin if all(line.origin == first.origin for line in seen) else ""
    text = f"{origin} normal {first.quantity} ({unit}){driven(first.units, first.drive)}".strip()
    letter = LETTER * bar.ax.xaxis.label.get_fontproperties().get_size_in_points()
    bar.set_label(textwrap.fill(text, max(LETTERS, int(72 * BAR * figure.get_figwidth() / letter))))
    bar.locator = MaxNLocator(4, symmetric=True)
    bar.update_ticks()
    return images


def _continued(line: Seen, layout: Layout | None) -> tuple[AnyComplex, list[Rectangle]]:
    """The values of a map, and the places that the plate does not have, to be covered.

    There the values are those of the nearest points, so that smooth maps need no value beyond the plate.
    """
    missing = np.isnan(line.shape)
    if layout is None or not missing.any():
        return line.shape, []
    x, y = (
        1e-3 * (low + (high - low) / count * (np.arange(count) + 0.5))
        for (low, high), count in zip((line.x, line.y), line.shape.shape[::-1], strict=True)
    )
    there = tile_names(layout, np.stack(np.meshgrid(x, y), axis=-1)[missing])
    if any(name is not None for name in there):
        return line.shape, []  # points of the plate that were not scanned
    nearest = scipy.ndimage.distance_transform_edt(missing, return_distances=False, return_indices=True)
    tiles = product(range(layout.rows), range(layout.columns))
    boxes = [1e3 * np.array(layout.bounds(tile)) for tile in tiles if layout.at(tile) is None]
    covers = [Rectangle((a, b), right - a, top - b) for a, b, right, top in boxes]
    return line.shape[tuple(nearest)], covers


def _slenderness(response: FrequencyResponse, layout: Layout | None) -> float:
    """Height over width of the content of a map."""
    if layout is not None:
        return (layout.y[-1] - layout.y[0]) / (layout.x[-1] - layout.x[0])
    width, height = np.ptp(response.points, axis=0)
    return float(height / width) if width else 1.0


def outlined(axes: Axes, layout: Layout | None, *, named: bool = True) -> int:
    """Set axes to a plate's size, in mm, and outline its regions, ``named`` or not, if the plate is known.

    Names are beside the data where there is room; the number of their lines above the axes is returned.
    """
    axes.set_facecolor(style.BEYOND)
    axes.set_xlabel("x (mm)")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(3, min_n_ticks=2))
    if layout is None:
        return 0
    axes.set(xlim=(1e3 * layout.x[0], 1e3 * layout.x[-1]), ylim=(1e3 * layout.y[0], 1e3 * layout.y[-1]))
    spans = {}
    for name in layout.regions:
        border = region_borders(layout, name)
        axes.add_collection(LineCollection(border, colors=style.INK, linewidths=0.9, gid=f"outline {name}"))
        corners = np.concatenate(border)
        spans[name] = corners.min(axis=0), corners.max(axis=0)
    if not named:
        return 0
    size, width = mpl.rcParams["font.size"], axes.get_window_extent().width * 72 / axes.figure.dpi
    if all(
        span[1][0] <= other[0][0] or other[1][0] <= span[0][0]
        for span, other in combinations(spans.values(), 2)
    ):
        room = min((high[0] - low[0] for low, high in spans.values()), default=0.0)
        across = room / (1e3 * (layout.x[-1] - layout.x[0])) * width
        turned = any(0.65 * size * len(short(name)) > 1.3 * across for name in spans)
        for name, (low, high) in spans.items():
            axes.annotate(
                short(name), (0.5 * (low[0] + high[0]), 1e3 * layout.y[-1]), xytext=(0, 2),
                textcoords="offset points", ha="left" if turned else "center", va="bottom",
                rotation=30 if turned else 0, annotation_clip=False, gid="region name",
            )  # fmt: skip
        return (2 if turned else 1) if spans else 0
    for name in layout.regions:
        x, _, top = max(rows_of(layout, name), key=lambda row: row[2])
        axes.annotate(
            short(name), (1e3 * x, 1e3 * top), xytext=(0, -4), textcoords="offset points",
            ha="center", va="top", gid="region name", path_effects=HALO,
        )  # fmt: skip
    return 0


def ends(middles: Array) -> tuple[float, float]:
    """Ends of a row of points in a picture: half a step beyond the outer points."""
    step = middles[1] - middles[0] if len(middles) > 1 else 1.0
    return float(middles[0] - 0.5 * step), float(middles[-1] + 0.5 * step)


def _beside(frequency: float, gap: Gap) -> str:
    if gap is None:
        return ""
    return "below the gap" if frequency < gap[0] else "above the gap" if frequency > gap[1] else "in the gap"
