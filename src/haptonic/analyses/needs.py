"""What several analyses need of a study: its carrier, its plate's mesh, the gap of the plate's lattice."""

from __future__ import annotations

import math
import warnings

from haptonic.analyses.runner import Runner
from haptonic.bloch import Gap
from haptonic.bloch.gaps import gap_at
from haptonic.bloch.reach import MeshLimits, check_memory, check_thickness, started
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.rows import rows_need
from haptonic.cell import Rows, UnitCell
from haptonic.errors import HaptonicWarning, StudyError
from haptonic.plate import Fineness, Plate
from haptonic.plate.reduction import BLOCK, STEPS
from haptonic.plate.settings import ResponseSettings
from haptonic.results.common import accuracy_remarks
from haptonic.study.schema import Description


def need_carrier(study: Description) -> float:
    """The carrier, Hz.

    Raises
    ------
    StudyError : the study does not give it
    """
    if study.carrier is None:
        raise StudyError.missing(
            argument="carrier",
            allowed="the frequency of the drive",
            cause="the study does not say which frequency the gap has to hold",
            next_step='add carrier = "60 kHz" at the top of the study',
        )
    return study.carrier


def response_settings(study: Description) -> ResponseSettings:
    """The table [plate.response] of a study that has a plate."""
    assert study.finite_plate is not None
    return study.finite_plate.response


def fineness(study: Description) -> Fineness | None:
    """Of the finite plate's mesh, if [mesh] says one."""
    mesh = study.bands_settings.mesh
    order, rings = mesh.order, mesh.foot_rings
    if order is None and rings is None:
        return None
    usual = Fineness()
    order = usual.cell if order is None else order
    rings = usual.rings if rings is None else rings
    drawn = usual.drawn if mesh.order is None else order
    return Fineness(min(order, usual.along), usual.through, cell=order, rings=rings, plain=order, drawn=drawn)


def checked_fineness(study: Description) -> Fineness | None:
    """The same, once it is sure that it can be had.

    Raises
    ------
    ResourceError : a mesh of a cell that this machine cannot hold, foreseen before anything is computed
    """
    chosen = fineness(study)
    for cell in study.mounted_plate().layout.cells.values():
        if chosen is not None or cell.solid is not None:
            check_memory(cell, tile_resolution(cell, chosen), MeshLimits.of(math.inf))
    return chosen


def tile_resolution(cell: UnitCell, chosen: Fineness | None) -> Resolution:
    """Of a cell as a tile of a finite plate."""
    fine = chosen or Fineness()
    return Resolution(fine.of_cell(cell.solid), fine.rings, STEPS, BLOCK)


def meshes_of(study: Description) -> list[Resolution]:
    """The mesh that a study's cell is computed on first, and the next if it fits as well.

    Raises
    ------
    ResourceError : not even the coarsest mesh fits the budget and the memory
    GeometryError : a plate too thin to be computed
    """
    cell, settings = study.cell, study.bands_settings
    limits, chosen = MeshLimits.of(settings.budget), settings.resolution
    if chosen is None:
        return started(cell, settings.count, settings.accuracy, limits)
    check_thickness(cell)
    chosen = chosen.for_bands(cell, settings.count)
    check_memory(cell, chosen, limits)
    return [chosen]


def gap_of_plate(study: Description, plate: Plate, carrier: float, runner: Runner) -> Gap | None:
    """The gap of the plate's lattice that holds the carrier (Hz), if there is one."""
    cells, settings = list(plate.layout.cells.values()), study.bands_settings
    if not cells:
        return None
    gap = gap_at(Runner(runner.store).gaps(cells[0], settings), carrier)
    if gap is not None and settings.resolution is None:
        reached = {"accuracy": settings.accuracy, "largest_error": gap.relative_error}
        for remark in accuracy_remarks(reached):
            warnings.warn(f"gap of the plate's lattice: {remark}", HaptonicWarning, stacklevel=2)
    return gap


def has_mirror(study: Description) -> bool:
    """Whether a mirror, and a waveguide between two of them, can be asked for.

    There is a carrier, and something that reflects; on which lattice does not matter.
    """
    return study.carrier is not None and study.cell.has_features


def need_rows(study: Description, table: str = "layers") -> tuple[int, float]:
    """What the rows of a study's mirror take on the mesh that is tried first; see `rows_need`.

    table : of the study that gives their direction
    """
    first = meshes_of(study)[0]
    along = (study.layers_settings if table == "layers" else study.waveguide_settings).direction
    return rows_need(Rows(study.cell, along, table=table), first)


def has_plate(study: Description) -> bool:
    """Whether a finite plate can be asked for."""
    return study.finite_plate is not None and study.carrier is not None
