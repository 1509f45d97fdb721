"""Inputs that several analyses need: a study's carrier, meshes of its cell, rows of a mirror."""

from __future__ import annotations

from haptonic.bloch.mesh_levels import MeshLimits, check_memory, check_thickness, started
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.rows import rows_need
from haptonic.cell import Rows, UnitCell
from haptonic.errors import StudyError
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
    if study.plate_settings is None:
        return {}
    cells = study.mounted_plate().layout.cells
    return {name: cell for name, cell in cells.items() if cell != study.cell}


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
