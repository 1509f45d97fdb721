"""Finite plates: plan of the parts, and maps of the vibration of the flat face."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import cycle
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PatchCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Patch, Polygon, Rectangle
from matplotlib.patheffects import withStroke

from haptonic.arrays import Array
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.outline import held, outline
from haptonic.plate.layout.parts import Plate
from haptonic.plate.layout.supports import WORDS, Hold
from haptonic.plots import style
from haptonic.plots.stage import stage
from haptonic.plots.text import LETTER, label, short

AROUND = 48  # points on a curved outline
HALO = [withStroke(linewidth=2.2, foreground="white")]  # keeps text readable on any colour
TALLER = 1.4  # height of a line with its distance to others, over the size of the type
MARK = 7.0  # points, size of the mark of a force
PLACES = 9  # places for a name along each side of a tile
MOST_TILES = 500  # of a region, in which places for its name are compared
REGION = "#d6e8f5"
LATTICES = ("#f3f3f3", "#f6dfa4", "#d9c9e3", "#c9e3cf", "#f2cfc4")  # tints, in the order of the lattices
HOLDS: dict[Hold, tuple[str, style.Dashes]] = {
    "clamped": (style.CARRIER, style.SOLID),
    "simple": (style.GREEN, style.DASHED),
    "spring": (style.PURPLE, style.DOTTED),
}


@style.drawn
def plate_plan(plate: Plate, visited: Array | None = None, *, ax: Axes | None = None) -> Figure:
    """The plate seen from above: lattices with their pillars, regions, supports, drives, a finger.

    visited : (point, 2) of a scan in the order of its stage, m; its way is drawn too
    """
    layout = plate.layout
    ratio = (layout.y[-1] - layout.y[0]) / (layout.x[-1] - layout.x[0])
    on = stage(ax, min(max(11.5 * ratio, 3.0), 18.0) + 3.5)
    axes = on.axes
    handles = [*_draw_tiles(axes, layout), *_draw_supports(axes, plate), *_draw_parts(axes, plate)]
    if visited is not None:
        handles += _draw_way(axes, 1e3 * visited)
    margin = 0.04 * 1e3 * max(layout.x[-1] - layout.x[0], layout.y[-1] - layout.y[0])
    axes.set(
        aspect="equal",
        xlim=(1e3 * layout.x[0] - margin, 1e3 * layout.x[-1] + margin),
        ylim=(1e3 * layout.y[0] - margin, 1e3 * layout.y[-1] + margin),
        xlabel="x (mm)",
        ylabel="y (mm)",
    )
    on.legend(handles, ncols=3)
    parts = _boxes_of_parts(axes, plate)
    for name in layout.regions:
        shown = short(name)
        x, y = _free_place(layout, name, parts, _half_size(axes, shown))
        axes.text(1e3 * x, 1e3 * y, shown, ha="center", va="center", gid="region name")
    return on.figure


def rows_of(layout: Layout, name: str) -> Iterator[tuple[float, float, float]]:
    """Middle (x, y) and top of the widest run of a region's tiles in each of its rows, m."""
    tiles = layout.of(name)
    for row in sorted({i for i, _ in tiles}):
        columns = sorted(j for i, j in tiles if i == row)
        runs = np.split(np.array(columns), np.flatnonzero(np.diff(columns) > 1) + 1)
        first, last = max(
            ((run[0], run[-1]) for run in runs), key=lambda r: layout.x[r[1] + 1] - layout.x[r[0]]
        )
        low, top = layout.y[row], layout.y[row + 1]
        yield 0.5 * (layout.x[first] + layout.x[last + 1]), 0.5 * (low + top), top


def _half_size(axes: Axes, text: str) -> Array:
    """Half the width and height of a text in axes with their limits, estimated, m."""
    axes.apply_aspect()
    (start, _), (end, _) = axes.transData.transform([(0.0, 0.0), (1.0, 1.0)]).tolist()
    figure = axes.get_figure(root=True)
    assert figure is not None, "axes that belong to no figure"
    height: float = TALLER * mpl.rcParams["font.size"] * 1e-3 * figure.dpi / 72 / (end - start)
    return 0.5 * height * np.array([LETTER * len(text), 1.0])


def _boxes_of_parts(axes: Axes, plate: Plate) -> Array:
    """(n, 4) left, bottom, right, top of actuators and forces with their names, and of a finger, m."""
    named = [(part.centre, part.size[:2], part.name) for part in plate.actuators]
    mark = tuple(2 * _half_size(axes, "X"))
    named += [(part.centre, part.size or mark, part.name) for part in plate.forces]
    boxes = []
    for (x, y), size, name in named:
        half, written = 0.5 * np.array(size), _half_size(axes, name)
        across = max(half[0], written[0])
        boxes.append((x - across, y - half[1], x + across, y + half[1] + 2 * written[1]))
    if plate.finger is not None:
        (x, y), radius = plate.finger.centre, 0.5 * plate.finger.diameter
        boxes.append((x - radius, y - radius, x + radius, y + radius))
    return np.reshape(boxes, (-1, 4))


def _free_place(layout: Layout, name: str, parts: Array, half: Array) -> tuple[float, float]:
    """Place (x, y) for the name of a region: in the middle of a row if parts leave room, or beside them, m.

    Parameters
    ----------
    parts : boxes as of `_boxes_of_parts`
    half : half the size of the name, m
    """

    def room(places: Array, boxes: Array, unit: Array | float) -> Array:
        """Half the size of the largest box about each place that is free of others, in shares of a unit."""
        middles, sizes = 0.5 * (boxes[:, :2] + boxes[:, 2:]), boxes[:, 2:] - boxes[:, :2]
        away = (np.abs(places[:, None] - middles) - 0.5 * sizes) / unit
        return np.asarray(away.max(axis=2).min(axis=1, initial=np.inf))

    middles = np.array([(x, y) for x, y, _ in rows_of(layout, name)])
    best = int(room(middles, parts, 1.0).argmax())
    if room(middles[[best]], parts, half)[0] < 1:
        edges = np.concatenate([np.hstack([loop, np.roll(loop, -1, 0)]) for loop in outline(layout, {name})])
        edges = np.hstack([np.minimum(edges[:, :2], edges[:, 2:]), np.maximum(edges[:, :2], edges[:, 2:])])
        own = layout.of(name)
        tiles = np.array([layout.bounds(tile) for tile in own[:: 1 + len(own) // MOST_TILES]])
        shares = (np.mgrid[:PLACES, :PLACES].reshape(2, -1).T + 0.5) / PLACES
        middles = (tiles[:, None, :2] + shares * (tiles[:, None, 2:] - tiles[:, None, :2])).reshape(-1, 2)
        best = int(room(middles, np.vstack([parts, edges]), half).argmax())
    x, y = middles[best].tolist()
    return x, y


def region_borders(layout: Layout, name: str) -> list[Array]:
    """The edges of a region, closed lines of (n, 2) corners, mm."""
    return _closed(outline(layout, {name}))


def _closed(loops: Iterable[Array]) -> list[Array]:
    return [1e3 * np.concatenate([loop, loop[:1]]) for loop in loops]


def _draw_tiles(axes: Axes, layout: Layout) -> list[Artist]:
    """Draw tiles, pillars and the outlines of regions and plate; return handles for the legend."""
    pillars: list[Patch] = []
    lattices = dict(zip(layout.cells, cycle(LATTICES)))
    shades: dict[str, list[Rectangle]] = {shade: [] for shade in (*lattices.values(), REGION)}
    for block in layout.blocks:
        x, y = (1e3 * np.array(lines) for lines in layout.lines(block))
        shade = lattices.get(str(layout.at(block.tiles[0])), REGION)
        shades[shade].append(Rectangle((x[0], y[0]), x[-1] - x[0], y[-1] - y[0]))
    for across, up, feature in layout.features:
        middle, half = (1e3 * across, 1e3 * up), 1e3 * feature.broadest
        corners = middle + half * feature.outline.polygon(AROUND)
        pillars.append(Polygon(corners) if feature.outline.joints else Circle(middle, half))
    for shade, tiles in shades.items():
        axes.add_collection(PatchCollection(tiles, facecolor=shade, edgecolor="white", linewidth=0.4))
    axes.add_collection(
        PatchCollection(pillars, facecolor="#bdbdbd", edgecolor=style.INK, linewidth=0.5, gid="pillars")
    )
    edges = [({name}, 0.8) for name in layout.regions] + [(set(layout.there.values()), 1.3)]
    for names, width in edges:
        lines = _closed(outline(layout, names))
        axes.add_collection(LineCollection(lines, colors=style.INK, linewidths=width, joinstyle="miter"))
    handles: list[Artist] = []
    if pillars:
        marker = "o" if isinstance(pillars[0], Circle) else "s"
        handles.append(
            Line2D([], [], ls="", marker=marker, ms=6, mfc="#bdbdbd", mec=style.INK, mew=0.5,
                   label=f"pillars on the back ({len(pillars)})")
        )  # fmt: skip
    if len(layout.bricks) > len(layout.features):
        handles.append(Patch(facecolor=LATTICES[0], edgecolor=style.INK, lw=0.4, label="cells of a file"))
    if len(lattices) > 1:
        handles += [
            Patch(
                facecolor=shade,
                edgecolor=style.INK,
                lw=0.4,
                label=label(name if name == "lattice" else f"lattice {name}"),
            )
            for name, shade in lattices.items()
        ]
    if layout.regions:
        handles.append(Patch(facecolor=REGION, edgecolor=style.INK, lw=0.8, label="region of plain plate"))
    return handles


def _draw_supports(axes: Axes, plate: Plate) -> list[Artist]:
    """Draw the supported parts of the outer sides; return handles for the legend."""
    handles: dict[Hold, Artist] = {}
    for support in plate.supports:
        lines = [1e3 * ends for _, ends in held(plate.layout, support)]
        colour, dashes = HOLDS[support.hold]
        axes.add_collection(
            LineCollection(lines, colors=colour, linewidths=4, linestyles=[dashes], capstyle="butt",
                           zorder=4, gid=f"held {support.hold}")
        )  # fmt: skip
        handles[support.hold] = Line2D([], [], color=colour, ls=dashes, lw=4, label=WORDS[support.hold])
    return list(handles.values())


def _draw_parts(axes: Axes, plate: Plate) -> list[Artist]:
    """Draw actuators, forces and a finger with their names; return handles for the legend."""
    handles: dict[str, Artist] = {}
    for actuator in plate.actuators:
        look: dict[str, Any] = {"facecolor": style.ORANGE, "edgecolor": style.INK, "lw": 0.8, "zorder": 5}
        axes.add_patch(
            _rectangle(actuator.centre, actuator.size[:2], gid=f"actuator {actuator.name}", **look)
        )
        _name(axes, actuator.centre, 0.5 * actuator.size[1], actuator.name)
        handles["actuator"] = Patch(**look, label="actuator on the back")
    for force in plate.forces:
        if force.size is not None:
            axes.add_patch(_rectangle(force.centre, force.size, fill=False, edgecolor=style.RED, zorder=5))
        spot = {
            "marker": "X",
            "ms": MARK,
            "mfc": style.RED,
            "mec": style.INK,
            "mew": 0.6,
            "ls": "",
            "zorder": 6,
        }
        axes.plot(1e3 * force.centre[0], 1e3 * force.centre[1], gid=f"force {force.name}", **spot)  # type: ignore[arg-type]
        _name(axes, force.centre, 0.5 * force.size[1] if force.size else 0.0, force.name, 0.5 * MARK)
        handles["force"] = Line2D([], [], **spot, label="normal force")  # type: ignore[arg-type]
    if plate.finger is not None:
        look = {"fill": False, "edgecolor": style.PURPLE, "lw": 1.8, "ls": style.DASHED, "zorder": 5}
        centre = (1e3 * plate.finger.centre[0], 1e3 * plate.finger.centre[1])
        axes.add_patch(Circle(centre, 0.5e3 * plate.finger.diameter, gid="finger", **look))
        handles["finger"] = Line2D([], [], color=style.PURPLE, lw=1.8, ls=style.DASHED, label="finger")
    return list(handles.values())


def _draw_way(axes: Axes, points: Array) -> list[Artist]:
    """Draw the path of a scan over points (point, 2), mm, and its start; return handles for the legend."""
    (way,) = axes.plot(*points.T, color=style.BLUE, lw=0.5, alpha=0.8, zorder=3, gid="way",
                       label=f"path over {len(points)} points")  # fmt: skip
    (start,) = axes.plot(
        *points[0], marker="o", ms=5, ls="", color=style.GREEN, zorder=8, label="first point"
    )
    return [way, start]


def _rectangle(centre: tuple[float, float], size: tuple[float, float], **look: Any) -> Rectangle:
    corner = (1e3 * (centre[0] - 0.5 * size[0]), 1e3 * (centre[1] - 0.5 * size[1]))
    return Rectangle(corner, 1e3 * size[0], 1e3 * size[1], **look)


def _name(axes: Axes, centre: tuple[float, float], above: float, name: str, mark: float = 0.0) -> None:
    """Write a name above a part; ``above`` is from its middle to its upper side, m, ``mark`` more, points."""
    axes.annotate(
        name, (1e3 * centre[0], 1e3 * (centre[1] + above)), xytext=(0, 3 + mark), textcoords="offset points",
        ha="center", va="bottom", zorder=7, gid="name",
        bbox={"boxstyle": "round,pad=0.1", "facecolor": "white", "edgecolor": "none", "alpha": 0.8},
    )  # fmt: skip
