"""The same plate with one thing changed: what moves the mode of its guides, how many rows keep it there."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from haptonic.plate import Band, Fineness, Layout, Plate, PlateModel, modes_between
from haptonic.plate.keys import PLATE
from haptonic.response import contrast, rms
from haptonic.results.plate.answer import responded
from haptonic.results.plate.datasets import mode_names
from haptonic.results.plate.question import grid_points

Array = NDArray[np.float64]

LINE = 20.0  # Hz between the lines among which a resonance is looked for


@dataclass(frozen=True)
class Look:
    """Where to look for a mode. low, high : Hz; name : its nodal lines; grid : m; tolerance : field error"""

    low: float
    high: float
    name: str
    grid: float
    tolerance: float


def with_rows(plate: Plate, first: str, second: str, rows: int) -> Plate:
    """A plate with so many columns of lattice between two regions that span all of its height.

    What is attached right of the first region is left away.
    """
    layout = plate.layout
    left = max(j for _, j in layout.of(first)) + 1
    right = min(j for _, j in layout.of(second))
    assert left < right, f"no lattice between {first} and {second}"
    columns = [*range(left), *([left] * rows), *range(right, layout.columns)]
    widths = np.diff(layout.x)[columns]
    tiles = tuple(tuple(row[j] for j in columns) for row in layout.tiles)
    x = tuple(np.concatenate([[0.0], np.cumsum(widths)]).tolist())
    border = layout.x[left]
    return replace(
        plate,
        layout=Layout(tiles, x, layout.y, layout.cells, layout.thickness, layout.material),
        actuators=tuple(one for one in plate.actuators if one.centre[0] < border),
        forces=tuple(one for one in plate.forces if one.centre[0] < border),
        finger=None,
    )


def guide_mode(plate: Plate, region: str, look: Look, fineness: Fineness | None = None) -> float:
    """Frequency, Hz, of the mode of that name with most energy in a region; NaN if there is none."""
    model = PlateModel.of(plate, look.high, fineness)
    found = modes_between(Band.of(model, look.low, look.high), look.low, look.high)
    points, regions = grid_points(plate, look.grid)
    shapes = model.displaced(points, found.vectors)
    names = mode_names(plate, model, found, shapes, points, regions)
    inside = [plate.layout.at(block.tiles[0]) == region for block in model.assembly.skeleton.blocks]
    shares = found.stored[PLATE][:, inside].sum(axis=1)
    called = [k for k, name in enumerate(names) if name == look.name]
    return float(found.frequency[max(called, key=lambda k: shares[k])]) if called else float("nan")


def resonance(plate: Plate, look: Look, over: str, under: str) -> tuple[float, float]:
    """Frequency, Hz, at which a region moves most, and its contrast over another one there, dB."""
    lines = np.arange(look.low, look.high + LINE / 2, LINE)
    response = responded(plate, lines, *grid_points(plate, look.grid), look.tolerance)
    loudest = int(rms(response, over).values.argmax())
    return float(lines[loudest]), float(contrast(response, over, under).values[loudest])
