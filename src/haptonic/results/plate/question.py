"""What is asked of a plate, and what its response refers to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import StudyError
from haptonic.plate import Plate
from haptonic.plate.parts import Actuator, Force

Array = NDArray[np.float64]


@dataclass(frozen=True)
class PlateQuestion:
    """What is asked of a plate. lowest, highest : Hz; points : lines; tolerance : field error; grid : m"""

    lowest: float
    highest: float
    points: int
    tolerance: float
    grid: float

    @property
    def frequencies(self) -> Array:
        """Hz"""
        return np.linspace(self.lowest, self.highest, self.points)


def drives_of(plate: Plate) -> list[Actuator | Force]:
    return [*plate.actuators, *plate.forces]


def driven_region(plate: Plate) -> str | None:
    """The region of plain plate that carries the first actuator, or else the first force."""
    layout = plate.layout
    names = [layout.at(layout.under((*one.centre, *one.centre))[0]) for one in drives_of(plate)]
    return next((name for name in names if name is not None and name not in layout.cells), None)


def amplitude_of(drive: Actuator | Force) -> complex:
    return drive.voltage if isinstance(drive, Actuator) else drive.amplitude


def reference_of(plate: Plate) -> tuple[str, float]:
    """What the response is divided by: the first drive's name and unit, and its amplitude."""
    moving = [drive for drive in drives_of(plate) if amplitude_of(drive)]
    if not moving:
        raise StudyError(
            argument="plate.actuator",
            given="nothing that drives the plate",
            allowed="at least one [[plate.actuator]] or [[plate.force]] with an amplitude above zero",
            cause="the plate has no drive, or its amplitude is zero",
            next_step='add [[plate.force]] with region, centre and force = "1 N"',
        )
    first = moving[0]
    return f"{first.name}, {'V' if isinstance(first, Actuator) else 'N'}", abs(amplitude_of(first))


def unit_drives(plate: Plate) -> dict[str, complex]:
    """Complex amplitudes of all drives by name, for a unit of the first that drives the plate."""
    _, unit = reference_of(plate)
    return {drive.name: amplitude_of(drive) / unit for drive in drives_of(plate)}


def grid_points(plate: Plate, spacing: float) -> tuple[Array, list[str]]:
    """Points (k, 2) of the flat face on a grid of squares, at the middle of each, m, and their regions.

    Points of a lattice have no region.
    """
    layout = plate.layout
    axes = []
    for lines in (layout.x, layout.y):
        count = max(1, round((lines[-1] - lines[0]) / spacing))
        axes.append(lines[0] + (lines[-1] - lines[0]) / count * (np.arange(count) + 0.5))
    x, y = (axis.ravel() for axis in np.meshgrid(*axes))
    column = np.searchsorted(layout.x, x, side="right") - 1
    row = np.searchsorted(layout.y, y, side="right") - 1
    names = [layout.at((int(i), int(j))) for i, j in zip(row, column, strict=True)]
    there = [k for k, name in enumerate(names) if name is not None]
    regions = [names[k] or "" for k in there]
    return np.stack([x, y], axis=-1)[there], ["" if name in layout.cells else name for name in regions]


def resonance_of(marked: Array, carrier: float, gap: Sequence[float] | None) -> float:
    """The frequency of the map in the gap, or else of the one nearest to the carrier, Hz."""
    low, high = gap or (0.0, np.inf)
    inside = marked[(marked > low) & (marked < high)]
    return float(min(inside if len(inside) else marked, key=lambda f: abs(f - carrier)))
