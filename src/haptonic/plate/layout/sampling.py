"""Sampling points of a plate, and the reference of its response."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.errors import ResourceError, StudyError
from haptonic.later import psutil
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.parts import Actuator, Plate
from haptonic.response import Reference
from haptonic.units import format_quantity

MOST_POINTS = 4_000_000  # of a grid
BYTES = 30.0  # of a point at a line: complex numbers of double and of single precision, and copies
ON_LINE = 1e-6  # of the smallest tile, within which a point lies on a line between tiles


def driven_regions(plate: Plate) -> tuple[str, ...]:
    """Regions of plain plate with an actuator or a force of nonzero amplitude, actuators first."""
    layout, drives = plate.layout, plate.drives
    moving = [drive for drive in drives if drive.amplitude] or drives
    names = [layout.at(layout.under((*drive.centre, *drive.centre))[0]) for drive in moving]
    return tuple(dict.fromkeys(name for name in names if name is not None and name not in layout.cells))


def driven_region(plate: Plate) -> str | None:
    """First driven region: that of the drive to which a response refers."""
    return next(iter(driven_regions(plate)), None)


def reference_of(plate: Plate) -> tuple[Reference, float]:
    """Reference of the response: name and unit of the first drive, and its amplitude."""
    moving = [drive for drive in plate.drives if drive.amplitude]
    if not moving:
        raise StudyError.missing(
            argument="plate.actuator",
            given="no drive with an amplitude above zero",
            allowed="at least one [[plate.actuator]] or [[plate.force]] with an amplitude above zero",
            cause="the plate has no drive, or its amplitude is zero",
            next_step='add [[plate.force]] with region, centre and force = "1 N"',
        )
    first = moving[0]
    return Reference(first.name, "V" if isinstance(first, Actuator) else "N"), abs(first.amplitude)


def unit_drives(plate: Plate) -> dict[str, complex]:
    """Complex amplitudes of all drives by name, for a unit of the first that drives the plate."""
    _, unit = reference_of(plate)
    return {drive.name: drive.amplitude / unit for drive in plate.drives}


def check_grid(plate: Plate, spacing: float, lines: int, at: str = "plate.response.grid") -> None:
    """Raise ResourceError if a grid of squares, m, has more points than fit into the memory.

    Raises
    ------
    ResourceError : the argument is ``at``
    """
    area = (plate.layout.x[-1] - plate.layout.x[0]) * (plate.layout.y[-1] - plate.layout.y[0])
    there = psutil.virtual_memory().total
    most = min(MOST_POINTS, there / (BYTES * lines))
    count = area / spacing**2
    if count > most:
        fits = float(np.sqrt(area / most))
        raise ResourceError.too_large(
            argument=at,
            given=f"{format_quantity(spacing, 'm')}, which makes {count:.2g} points of {lines} lines",
            allowed=f"at least {format_quantity(fits, 'm')} on this plate and machine",
            cause="a grid finer than any wave on the plate, or a slip in its unit",
            next_step=f'write grid = "{1.05e3 * fits:.2g} mm" or more, or ask for fewer frequencies',
        )


def grid_points(plate: Plate, spacing: float, at: str = "plate.response.grid") -> tuple[Array, list[str]]:
    """Points (k, 2) of the flat face on a grid of squares, at the middle of each, m, and their regions.

    Points of a lattice have no region.

    Raises
    ------
    ResourceError : more points than fit into the memory; the argument is ``at``
    """
    check_grid(plate, spacing, 1, at)
    layout = plate.layout
    axes = []
    for lines in (layout.x, layout.y):
        count = max(1, round((lines[-1] - lines[0]) / spacing))
        axes.append(lines[0] + (lines[-1] - lines[0]) / count * (np.arange(count) + 0.5))
    x, y = (axis.ravel() for axis in np.meshgrid(*axes))
    points = np.stack([x, y], axis=-1)
    regions = {k: name for k, name in enumerate(region_names(layout, points)) if name is not None}
    return points[list(regions)], list(regions.values())


def region_names(layout: Layout, points: Array) -> list[str | None]:
    """Name of the region of plain plate below each point (n, 2); "" on a lattice, None beside the plate."""
    return ["" if name in layout.cells else name for name in tile_names(layout, points)]


def tile_names(layout: Layout, points: Array) -> list[str | None]:
    """Name of the tile below each point (n, 2); None beside the plate.

    A point on a line between tiles belongs to the one on the right or above, within a tolerance for rounding.
    """
    slack = ON_LINE * min(*np.diff(layout.x), *np.diff(layout.y))
    indices = []
    for lines, place in ((layout.y, points[:, 1]), (layout.x, points[:, 0])):
        number = np.searchsorted(lines[1:-1], place + slack, side="right")
        indices.append(np.where((place < lines[0] - slack) | (place > lines[-1] + slack), -1, number))
    return [layout.at((int(i), int(j))) for i, j in zip(*indices, strict=True)]


def points_of(regions: Sequence[str], name: str | None) -> Bools:
    """(points,) True for points in a region; all True if no point lies in it."""
    there = np.array([region == name for region in regions])
    return there if there.any() else np.ones(len(there), dtype=bool)
