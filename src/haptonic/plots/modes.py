"""Mode shapes: the deformed cell, seen from one place, coloured by how far it moves."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
import scipy
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from haptonic.arrays import Array, Ints
from haptonic.bloch.bands import mode_names
from haptonic.cell.skin import drawing_cells, outer_faces, outline_edges
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.moving import moments, moving
from haptonic.units import hz_text

SHOWN = 8  # modes, as in Fig. 4B of the paper
COLUMNS = 4
MOMENTS = 12  # moments of a cycle in a film
FINER = 4  # most patches of one colour along the side of a face
SHADES = 60  # steps of the scale of colours, too small to be distinguished side by side
LARGEST = 0.2  # drawn displacement, as a share of the period
FLAT, LARGEST_OF_FLAT = 0.4, 0.1  # the same of a cell that is lower than this share; a hole would close
APART = 0.45  # of the clear distance of two pillars, so that they do not pass through each other
SMOOTH = 2  # pixels painted for one that is shown, along x and y, so that edges are smooth
INKED = 0.65  # brightness of a line relative to the colour below it
AZIMUTH, ELEVATION = np.radians(-62), np.radians(20)  # direction of the camera


@style.drawn
def mode_shapes(dataset: xr.Dataset) -> Figure:
    """The lowest eight modes at one wavevector, numbered from 1 to 8.

    The displacement is the real part, at the moment when it is largest; every mode is scaled to the same
    largest displacement, because the size of a free vibration means nothing. All share camera and scale.

    Parameters
    ----------
    dataset : from `haptonic.bloch.bands_dataset`
    """
    return _bodies(dataset, (1.0,))[0]


def moving_modes(dataset: xr.Dataset) -> bytes:
    """Film of one cycle of the same modes, all at one pace; see `haptonic.plots.moving`."""
    with style.styled():
        figure, turned = _bodies(dataset, moments(MOMENTS))
        return moving(figure, turned, MOMENTS)


def _bodies(dataset: xr.Dataset, turns: Sequence[complex]) -> tuple[Figure, Callable[[complex], None]]:
    """Figure with room for these moments of a cycle, and a function that moves its bodies to a moment."""
    count = min(SHOWN, dataset.sizes["mode"])
    columns = min(COLUMNS, count)
    position = dataset["node_position"].values * 1e3
    cells, on_edge = drawing_cells(dataset["subcell"].values, json.loads(dataset.attrs["element_grids"]))
    faces = outer_faces(cells)
    sides = np.unique(np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], -1).reshape(-1, 2)), axis=0)
    borders = sides[np.isin(sides, on_edge).all(axis=1)]
    outline = outline_edges(position, faces)
    period, _, height = np.ptp(position, axis=0).tolist()
    largest = LARGEST_OF_FLAT if height < FLAT * period else LARGEST
    swing = min(largest * period, APART * clearance(position, faces))
    names = [name.replace(", ", "\n") for name in mode_names(dataset)[:SHOWN]]
    fields = (dataset["mode_real"].values + 1j * dataset["mode_imag"].values)[:count].astype(complex)
    amounts = np.linalg.norm(fields, axis=2)
    amounts /= amounts.max(axis=1, keepdims=True)
    reached = [position + swing * (turn * field).real for field in fields for turn in turns]
    seen = np.concatenate([_projected(points)[:, :2] for points in [position, *reached]])
    low, high = seen.min(axis=0), seen.max(axis=0)
    rows = -(-count // columns)
    column = (style.WIDTH - 1.0) / columns
    tall = (column - 0.2) * (high - low)[1] / (high - low)[0]
    figure = style.blank(rows * (min(tall, 7.0) + 1.2 + 0.4 * ("\n" in names[0])) + 1.9)
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes in panels:
        axes.set_axis_off()
        axes.set(xticks=[], yticks=[])  # otherwise they take room below every title
    # one line with breaks: a line for each edge would double the time and the size of the file
    ends = _projected(position)[:, :2][outline]
    rest = np.pad(ends, ((0, 0), (0, 1), (0, 0)), constant_values=np.nan).reshape(-1, 2).T
    for k in range(count):
        axes = panels[k]
        axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
        axes.plot(*rest, color=style.PALE_INK, lw=0.5, zorder=0, gid="undeformed")
        frequency = float(dataset["mode_frequency"][k]) / 1e3
        axes.set_title(f"{k + 1}:  {hz_text(1e3 * frequency, form='.2f')}\n{names[k]}")
    figure.suptitle(f"modes at {dataset.attrs['modes_at']}", gid="wavevector")
    bar = figure.colorbar(
        ScalarMappable(Normalize(0, 1), style.perceptual()),
        ax=list(panels), location="bottom", shrink=0.5, aspect=35, pad=0.02,
    )  # fmt: skip
    bar.set_label("displacement, relative to its maximum")
    scale = min((column - 0.2) / (high - low)[0], 7.0 / (high - low)[1]) * style.DOTS_PER_INCH / 2.54

    def bodies(turn: complex) -> list[NDArray[np.uint8]]:
        return [
            _painted(_projected(position + swing * (turn * field).real), amount, faces, borders,
                     Window(low, high, scale))
            for field, amount in zip(fields, amounts, strict=True)
        ]  # fmt: skip

    images = [
        axes.imshow(body, extent=(low[0], high[0], low[1], high[1]), zorder=1, gid="deformed")
        for axes, body in zip(panels, bodies(1.0), strict=False)
    ]

    def turned(turn: complex) -> None:
        for image, body in zip(images, bodies(turn), strict=True):
            image.set_data(body)

    return figure, turned


@dataclass(frozen=True)
class Window:
    """Visible part of the plane of projection.

    low, high : its lower left and upper right corner; scale : pixels of a unit
    """

    low: Array
    high: Array
    scale: float

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of its picture, pixels."""
        wide, tall = np.ceil((self.high - self.low) * self.scale).astype(int).tolist()
        return wide, tall

    def pixels(self, points: Array) -> Array:
        """Places of points (..., 2) in pixels from the upper left corner of the picture."""
        share = (points - self.low) / (self.high - self.low)
        return np.asarray(np.stack([share[..., 0], 1 - share[..., 1]], axis=-1) * self.size)


def _painted(seen: Array, amount: Array, faces: Ints, borders: Ints, window: Window) -> NDArray[np.uint8]:
    """Picture (y, x, 4) of the faces towards the camera and the borders of the elements, back to front.

    matplotlib would paint it again for each format of a file, and more slowly.
    """
    corners = seen[faces]
    first, second = corners[:, 2, :2] - corners[:, 0, :2], corners[:, 3, :2] - corners[:, 1, :2]
    front = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0] > 0
    patches = _finer(np.concatenate([corners[front], amount[faces[front], None]], axis=2))
    used = np.isin(borders, np.unique(faces[front])).all(axis=1)
    lines = seen[borders[used]]
    # a line lies on its faces; drawn a little nearer, it is not hidden by them
    lift = 0.02 * np.ptp(seen[:, 1])
    nearness = np.concatenate([patches[..., 2].mean(axis=1), lines[..., 2].mean(axis=1) + lift])
    shades = style.perceptual()(np.concatenate([patches[..., 3].mean(1), amount[borders[used]].mean(1)]))
    shades[len(patches) :, :3] *= INKED
    colours = list(map(tuple, np.rint(255 * shades).astype(int).tolist()))
    fine = replace(window, scale=SMOOTH * window.scale)
    shapes = [
        fine.pixels(part[..., :2]).reshape(len(part), 2 * part.shape[1]).tolist() for part in (patches, lines)
    ]
    picture = Image.new("RGBA", fine.size, (255, 255, 255, 0))
    pen = ImageDraw.Draw(picture)
    for number in np.argsort(nearness, kind="stable").tolist():
        if number < len(patches):
            pen.polygon(shapes[0][number], fill=colours[number])
        else:
            pen.line(shapes[1][number - len(patches)], fill=colours[number], width=SMOOTH)
    return np.asarray(Image.fromarray(_whole(np.array(picture))).reduce(SMOOTH))


def _whole(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Picture (y, x, 4) in which single pixels left out between adjacent polygons are filled."""
    there = pixels[..., 3] > 0
    beside = there[:-2, 1:-1] & there[2:, 1:-1] | there[1:-1, :-2] & there[1:-1, 2:]
    y, x = np.nonzero(~there[1:-1, 1:-1] & beside)
    above = there[y, x + 1]
    pixels[y + 1, x + 1] = pixels[np.where(above, y, y + 1), np.where(above, x + 1, x)]
    return pixels


def _finer(corners: Array) -> Array:
    """Quadrilaterals (m, 4, c) that divide those with the corners (n, 4, c), bilinearly.

    Each is divided until the colour, its last component, changes too little within a part to be seen.
    """
    parts = np.clip(np.ceil(SHADES * np.ptp(corners[..., -1], axis=1)), 1, FINER).astype(int)
    patches = []
    for count in np.unique(parts):
        u, v = np.meshgrid(*[np.linspace(0, 1, count + 1)] * 2, indexing="ij")
        shares = np.stack([(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v], axis=-1)
        around = np.stack([shares[:-1, :-1], shares[1:, :-1], shares[1:, 1:], shares[:-1, 1:]], axis=2)
        filled = np.einsum("ijkl,nlc->nijkc", around, corners[parts == count])
        patches.append(filled.reshape(-1, 4, corners.shape[2]))
    return np.concatenate(patches)


def _projected(points: Array) -> Array:
    """Coordinates (n, 3) to the right, upwards and towards the camera, without perspective."""
    right = np.array([-np.sin(AZIMUTH), np.cos(AZIMUTH), 0.0])
    towards = np.array(
        [np.cos(AZIMUTH) * np.cos(ELEVATION), np.sin(AZIMUTH) * np.cos(ELEVATION), np.sin(ELEVATION)]
    )
    return np.asarray(points @ np.stack([right, np.cross(towards, right), towards], axis=1))


def clearance(position: Array, faces: Ints) -> float:
    """Smallest distance between two pillars, unconnected parts of the upper half; infinite for one pillar."""
    middle = 0.5 * (position[:, 2].min() + position[:, 2].max())
    upper = faces[(position[faces, 2] > middle).all(axis=1)]
    joins = np.concatenate([upper[:, [k, (k + 1) % 4]] for k in range(4)])
    count = len(position)
    graph = scipy.sparse.coo_array((np.ones(len(joins)), joins.T), shape=(count, count))
    part = scipy.sparse.csgraph.connected_components(graph, directed=False)[1]
    nodes = np.unique(upper)
    pillars = [nodes[part[nodes] == number] for number in np.unique(part[nodes])]
    if len(pillars) < 2:
        return float("inf")  # without the import of scipy.spatial, which takes 0.2 s
    trees = [scipy.spatial.cKDTree(position[own]) for own in pillars]
    return min(float(a.query(b.data)[0].min()) for a, b in combinations(trees, 2))
