"""Inputs that several analyses need: a study's carrier, its plate's mesh, the gap of the plate's lattice."""

from __future__ import annotations

import math
import warnings

from haptonic.analyses.runner import Runner
from haptonic.bloch import Gap
from haptonic.bloch.gaps import common_gap, gap_at
from haptonic.bloch.mesh_levels import MeshLimits, check_memory, check_thickness, started
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.rows import rows_need
from haptonic.cell import Rows, UnitCell
from haptonic.errors import HaptonicWarning, StudyError
from haptonic.plate import Fineness, Plate
from haptonic.plate.body.reduction import BLOCK, STEPS
from haptonic.plate.layout.sampling import driven_regions
from haptonic.plate.vibration.settings import ResponseSettings
from haptonic.results.common import accuracy_remarks
from haptonic.study.schema import Description


def need_carrier(study: Description) -> float:
    """The carrier, Hz.

    Raises
    ------
    StudyError : the study has no carrier
    """
    if study.carrier is None:
        raise StudyError.missing(
            argument="carrier",
            allowed="the frequency of the drive",
            cause="the study does not give the frequency that the gap has to contain",
            next_step='add carrier = "60 kHz" at the top of the study',
        )
    return study.carrier


def response_settings(study: Description) -> ResponseSettings:
    """The table [plate.response] of a study that has a plate."""
    assert study.finite_plate is not None
    return study.finite_plate.response


def fineness(study: Description) -> Fineness | None:
    """Fineness of the finite plate's mesh, if [mesh] gives it."""
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
    """`fineness` after a check of the memory.

    Raises
    ------
    ResourceError : the estimated memory for the mesh of a cell exceeds that of this machine
    """
    chosen = fineness(study)
    for cell in study.mounted_plate().layout.cells.values():
        if chosen is not None or cell.solid is not None:
            mesh = tile_resolution(cell, chosen)
            check_memory(cell, mesh, mesh.bands, MeshLimits.of(math.inf))
    return chosen


def tile_resolution(cell: UnitCell, chosen: Fineness | None) -> Resolution:
    """Resolution of a cell as a tile of a finite plate."""
    fine = chosen or Fineness()
    return Resolution(fine.of_cell(cell.solid), fine.rings, STEPS, BLOCK)


def meshes_of(study: Description) -> list[Resolution]:
    """First mesh for a study's cell, and the next one if it is within the limits too.

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
    check_memory(cell, chosen, settings.count, limits)
    return [chosen.for_bands(cell, settings.count)]


def further_lattices(study: Description) -> dict[str, UnitCell]:
    """Cells of the plate's lattices other than the study's own cell, by name."""
    if study.finite_plate is None:
        return {}
    cells = study.mounted_plate().layout.cells
    return {name: cell for name, cell in cells.items() if cell != study.cell}


def gaps_around(study: Description, plate: Plate, carrier: float, runner: Runner) -> dict[str, Gap | None]:
    """Gap at the carrier (Hz) of each lattice beside the driven regions, by its name.

    Without such a lattice it is the first one of the plate.
    """
    layout, settings = plate.layout, study.bands_settings
    names = layout.beside(driven_regions(plate)) or list(layout.cells)[:1]
    gaps = {name: gap_at(Runner(runner.store).gaps(layout.cells[name], settings), carrier) for name in names}
    for gap in gaps.values():
        if gap is not None and settings.resolution is None:
            reached = {"accuracy": settings.accuracy, "largest_error": gap.relative_error}
            for remark in accuracy_remarks(reached):
                warnings.warn(f"gap of the plate's lattice: {remark}", HaptonicWarning, stacklevel=2)
    return gaps


def gap_of_plate(study: Description, plate: Plate, carrier: float, runner: Runner) -> Gap | None:
    """Gap at the carrier (Hz) that all lattices beside the driven regions share; None without one."""
    return common_gap(gaps_around(study, plate, carrier, runner).values())


def has_mirror(study: Description) -> bool:
    """True if the study allows a mirror, and a waveguide between two mirrors.

    It needs a carrier and pillars or discs; the kind of lattice does not matter.
    """
    return study.carrier is not None and study.cell.has_features


def need_rows(study: Description, table: str = "layers") -> tuple[int, float]:
    """Unknowns on a face and memory (bytes) of a study's mirror on its first mesh; see `rows_need`.

    table : table of the study that gives the direction
    """
    first = meshes_of(study)[0]
    along = (study.layers_settings if table == "layers" else study.waveguide_settings).direction
    return rows_need(Rows(study.cell, along, table=table), first)


def has_plate(study: Description) -> bool:
    """True if the study has a finite plate and a carrier."""
    return study.finite_plate is not None and study.carrier is not None
