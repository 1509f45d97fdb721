"""The whole Brillouin zone: contours of equal frequency, and the density of states."""

from __future__ import annotations

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from matplotlib.tri import Triangulation

from haptonic.arrays import Array
from haptonic.bloch.zone import ZoneSurface
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.bands import complete_gaps
from haptonic.plots.marks import above
from haptonic.plots.plates import HALO
from haptonic.plots.stage import stage
from haptonic.plots.text import band_text

LEVELS = 9  # lines of equal frequency
SHARP, OFTEN = np.radians(15.0), 0.2  # least turns to and from, and their share of the points, of a zigzag
EDGE, ROOM = 0.14, 0.12  # of the zone, that a value keeps from its border, and from another value
LEVEL = 0.15  # largest slope of a line where its value is written upright, so that it hides no others
# of the median width, and of the largest density of wider bins: narrower bins may be cut off
NARROW, TALLEST = 0.5, 1.5
FEW = 2  # values on lines, below which also lines between them have theirs


@style.drawn
def iso_frequency(dataset: xr.Dataset, bands: tuple[int, ...] = ()) -> Figure:
    """Contours of equal frequency over the first Brillouin zone, one panel for each band.

    Parameters
    ----------
    dataset : from `haptonic.bloch.bands_dataset` with ``surface=True`` and its lattice in the attributes
    bands : numbers, counted from 1; by default the first band and the one below the widest complete gap
    """
    chosen = bands or _telling_bands(dataset)
    figure = style.suited(0.42, 7, 1.0 if len(chosen) > 1 else 0.55)
    surface = ZoneSurface.of_dataset(dataset)
    below = dataset["gap_below"].values[dataset["gap_complete"].values.astype(bool)]
    panels = figure.subplots(1, len(chosen), squeeze=False, sharey=True)[0]
    for axes, band in zip(panels, chosen, strict=True):
        _contours(figure, axes, surface, band, ", below the gap" if band in below else "")
        axes.set_xlabel(r"$k_x$ (rad/mm)", parse_math=True)
    panels[0].set_ylabel(r"$k_y$ (rad/mm)", parse_math=True)
    return figure


def _contours(figure: Figure, axes: Axes, surface: ZoneSurface, band: int, beside: str) -> None:
    wavevectors, triangles, number = surface.unfolded()
    k = wavevectors / 1e3
    values = surface.frequency[number, band - 1] / 1e3
    plane = Triangulation(k[:, 0], k[:, 1], triangles)
    filled = axes.tripcolor(
        plane, values, shading="gouraud", cmap=style.perceptual(), rasterized=True, gid="frequency"
    )
    labels = surface.zone.corner_phases
    corners = surface.zone.lattice.wavevector(np.array(list(labels.values()))) / 1e3
    _draw_levels(axes, plane, values, corners)
    bar = figure.colorbar(filled, ax=axes, location="bottom", aspect=25, pad=0.03)
    bar.set_label("frequency (kHz)")
    bar.locator = MaxNLocator(3)
    bar.update_ticks()
    outline = np.concatenate([corners, corners[:1]])
    axes.plot(
        outline[:, 0], outline[:, 1], color=style.CARRIER, ls=style.DASHED, lw=1.2, gid="irreducible zone",
        clip_on=False,
    )  # fmt: skip
    middle = corners.mean(axis=0)
    for label, place in zip(labels, corners, strict=True):
        axes.annotate(
            label, place, textcoords="offset points", xytext=7 * np.sign(np.round(place - middle, 6)),
            color=style.INK, ha="center", va="center", gid="corner", annotation_clip=False, path_effects=HALO,
        )  # fmt: skip
    axes.set_aspect("equal")
    axes.set_title(f"band {band}{beside}", pad=15)  # above the labels of corners at the upper border
    axes.xaxis.set_major_locator(MaxNLocator(3, symmetric=True))
    axes.yaxis.set_major_locator(MaxNLocator(3, symmetric=True))


def _draw_levels(axes: Axes, plane: Triangulation, values: Array, corners: Array) -> None:
    """Lines of equal frequency, every second one with its value if there is room.

    A line beside a plateau may zigzag between the samples of the zone, which do not resolve it; such a
    line is left out.
    """
    every = np.asarray(MaxNLocator(LEVELS).tick_values(values.min(), values.max()))
    drawn = axes.tricontour(plane, values, levels=every)
    paths = [np.asarray(path.vertices) for path in drawn.get_paths()]
    drawn.remove()
    chosen = [n for n, path in enumerate(paths) if len(path) > 2 and not _zigzags(path)]
    if not chosen:
        return
    levels = every[chosen]
    drawn = axes.tricontour(plane, values, levels=levels, colors="white", linewidths=0.6)
    drawn.set_gid("levels")
    size = float(np.abs(corners).max())
    taken = [*corners, *np.linspace(corners, np.roll(corners, 1, axis=0), 9)[1:-1].reshape(-1, 2)]
    angle = np.linspace(0, 2 * np.pi, 72, endpoint=False)
    normals = np.stack([np.cos(angle), np.sin(angle)])
    border = (np.column_stack([plane.x, plane.y]) @ normals).max(axis=0)
    placed = 0
    for number, n in enumerate([*chosen[::-2], *chosen[-2::-2]]):
        if number >= len(chosen[::-2]) and placed >= FEW:
            break
        line = paths[n]
        along = np.gradient(line, axis=0)
        level = np.abs(along[:, 1]) < LEVEL * np.abs(along[:, 0])
        inside = (line @ normals < border - EDGE * size).all(axis=1)
        inner = line[inside & level] if (inside & level).any() else line[inside]
        if not len(inner):
            continue
        free = np.linalg.norm(inner[:, None] - np.array(taken), axis=2).min(axis=1)
        if free.max() < ROOM * size:
            continue
        place = inner[free.argmax()]
        taken.append(place)
        placed += 1
        drawn.clabel([every[n]], fmt="%g", inline=True, inline_spacing=1, manual=[tuple(place)],
                     colors=style.INK, fontsize=style.FINE * mpl.rcParams["font.size"])  # fmt: skip
        drawn.labelTexts[-1].set(path_effects=HALO, gid="level", rotation=0, clip_on=False)


def _zigzags(line: Array) -> bool:
    """Whether a line (n, 2) turns one way and then back at many of its points."""
    step = np.diff(line, axis=0)
    step = step[np.linalg.norm(step, axis=1) > 0]
    heading = np.arctan2(step[:, 1], step[:, 0])
    turn = (np.diff(heading) + np.pi) % (2 * np.pi) - np.pi
    back = (turn[1:] * turn[:-1] < 0) & (np.minimum(np.abs(turn[1:]), np.abs(turn[:-1])) > SHARP)
    return bool(back.mean() > OFTEN) if len(back) else False


@style.drawn
def density_of_states(dataset: xr.Dataset, *, ax: Axes | None = None) -> Figure:
    """States per cell and kHz against frequency; complete gaps shaded.

    Above the lowest frequency of the highest band, states of bands that were not computed are missing: that
    range is grey. Bands that are much narrower than a bin may reach beyond the top.
    """
    on = stage(ax, 7.5)
    axes = on.axes
    middle, width = (dataset[name].values / 1e3 for name in ("density_frequency", "density_width"))
    density = dataset["density_of_states"].values * 1e3
    edges = np.append(middle - 0.5 * width, middle[-1] + 0.5 * width[-1])
    end = edges[-1]
    whole = float(dataset["zone_frequency"][:, -1].min()) / 1e3
    common = density[width > NARROW * np.median(width)].max()
    axes.set_xlim(0, end)
    axes.set_ylim(0, 1.08 * min(density.max(), TALLEST * common or np.inf))
    names = []
    for lower, upper, lower_error, upper_error in complete_gaps(dataset):
        axes.axvspan(
            lower / 1e3, upper / 1e3, facecolor=style.GAP, edgecolor="none", zorder=0, gid="gap",
        )  # fmt: skip
        text = f"complete gap {band_text(lower, lower_error, upper, upper_error)}"
        names.append((0.5 * (lower + upper) / 1e3, text, style.GAP_EDGE))
    above(axes, names)
    axes.axvspan(whole, end, facecolor=style.BEYOND, edgecolor="none", zorder=0, gid="beyond",
                 label="states of bands that were not computed are missing")  # fmt: skip
    axes.stairs(density, edges, fill=True, color=style.SKY, alpha=0.55, lw=0, zorder=2)
    axes.stairs(density, edges, color=style.BLUE, lw=0.9, zorder=3, gid="density")
    axes.set_xlabel("frequency (kHz)")
    axes.set_ylabel("density of states\n(per cell and kHz)")
    on.legend(ncols=1)
    return on.figure


def _telling_bands(dataset: xr.Dataset) -> tuple[int, ...]:
    complete = dataset["gap_complete"].values.astype(bool)
    if not complete.any():
        return (1, min(2, dataset.sizes["band"]))
    width = (dataset["gap_upper"] - dataset["gap_lower"]).values[complete]
    below = int(dataset["gap_below"].values[complete][width.argmax()])
    return (1, below) if below > 1 else (1, 2)
