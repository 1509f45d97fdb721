"""Drive and points of a scan on the plate, from its settings."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.errors import ScanError
from haptonic.names import names_in
from haptonic.plate import Plate
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.sampling import grid_points, reference_of, tile_names
from haptonic.plate.vibration.settings import ResponseSettings
from haptonic.response import Reference
from haptonic.vibrometry.chirp import Drive, drive
from haptonic.vibrometry.instrument import lines_of
from haptonic.vibrometry.planning import Rectangle, Region, ScanPlan, visited
from haptonic.vibrometry.settings import CLAMPS, ScanSettings


def drive_for(settings: ScanSettings, plate: Plate | None) -> Drive:
    """One period of the drive, in amplitude and unit like the plate's first drive; 1 V without a plate.

    Raises
    ------
    ScanError : band, rate and record contradict each other
    StudyError : the plate has no drive
    """
    reference, amplitude = (Reference(unit="V"), 1.0) if plate is None else reference_of(plate)
    quality = 1 / plate.loss_factor if plate is not None and plate.loss_factor else None
    return drive(
        low=settings.lowest, high=settings.highest, sample_rate=settings.rate, duration=settings.record,
        amplitude=amplitude, kind=settings.signal, quality_factor=quality,
        unit="N" if reference.unit == "N" else "V",
    )  # fmt: skip


def plan_for(settings: ScanSettings, plate: Plate) -> ScanPlan:
    """The points, in the order of the stage: those at which the plate is computed, without the skipped ones.

    Raises
    ------
    ScanError : an unknown name among the skipped regions, or no point left
    """
    points, _ = grid_points(plate, settings.grid, "scan.grid")
    layout = plate.layout
    names = (*layout.regions, *layout.cells, CLAMPS)
    excluded: list[Region] = []
    for name in names_in(settings.skip, names):
        if name not in names:
            raise ScanError.unknown("scan.skip", name, names, "the plate has no such region or lattice")
        excluded += held_corners(plate) if name == CLAMPS else [Tiles(layout, name)]
    return visited(points, excluded)


def response_for(settings: ScanSettings, tolerance: float, signal: Drive) -> ResponseSettings:
    """Settings for the response of the plate at the lines of a drive."""
    lines = lines_of(signal)
    return ResponseSettings(
        lowest=float(lines[0]),
        highest=float(lines[-1]),
        points=len(lines),
        tolerance=tolerance,
        grid=settings.grid,
    )


@dataclass(frozen=True)
class Tiles:
    """All tiles of one name as a region."""

    layout: Layout
    name: str

    def holds(self, points: Array) -> NDArray[np.bool_]:
        """(point,) True for points, of (point, 2), inside the region."""
        return np.array([name == self.name for name in tile_names(self.layout, points)])


def held_corners(plate: Plate) -> list[Region]:
    """Squares that clamps at the corners cover."""
    layout = plate.layout
    sizes = [support.length for support in plate.supports if support.where == "corners"]
    return [
        Rectangle(x, y, size, size)
        for size in sizes
        if size is not None
        for x in (0.0, layout.x[-1] - size)
        for y in (0.0, layout.y[-1] - size)
    ]
