"""Inputs and costs that analyses of a study's finite plate share: its mesh, its response, gaps around it."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Mapping

from haptonic.analyses.runner import Runner
from haptonic.bloch import Gap
from haptonic.bloch.gaps import common_gap, gap_at
from haptonic.bloch.mesh_levels import MeshLimits, check_memory
from haptonic.bloch.resolution import Resolution
from haptonic.cell import UnitCell
from haptonic.errors import HaptonicWarning
from haptonic.plate import Fineness, Plate
from haptonic.plate.body.reduction import BLOCK, STEPS
from haptonic.plate.layout.sampling import driven_regions, reference_of
from haptonic.plate.vibration.forecast import Counted
from haptonic.plate.vibration.responses import need_loss
from haptonic.plate.vibration.settings import ResponseSettings
from haptonic.results.common import accuracy_remarks
from haptonic.results.cost import Cost
from haptonic.study.schema import Description

# Time of a file's cell as a tile of a plate over that of its bands, because it keeps more of the interior. At
# orders 3 and 4 a drawn pillar took 25 and 85 s; the estimates for its bands are 11 and 44 s.
OF_SOLIDS = 2.1


def has_plate(study: Description) -> bool:
    """True if the study has a finite plate and a carrier."""
    return study.plate_settings is not None and study.carrier is not None


def response_settings(study: Description) -> ResponseSettings:
    """The table [plate.response] of a study that has a plate."""
    assert study.plate_settings is not None
    return study.plate_settings.response


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


def check_driven(plate: Plate) -> None:
    """Raise StudyError for a plate without a drive or without loss."""
    reference_of(plate)
    need_loss(plate)


def check_waves(study: Description, plate: Plate, highest: float) -> None:
    """Raise HaptonicError if bending waves of a frequency, Hz, are too short for the tiles of a plate."""
    (fineness(study) or Fineness()).check_waves(plate.layout, highest)


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


def lattice_gaps(study: Description, plate: Plate, runner: Runner) -> dict[str, tuple[Gap, ...]]:
    """Complete gaps of each lattice beside the driven regions, by its name.

    Without such a lattice it is the first one of the plate.
    """
    layout, settings = plate.layout, study.bands_settings
    names = layout.beside(driven_regions(plate)) or list(layout.cells)[:1]
    return {name: Runner(runner.store).gaps(layout.cells[name], settings) for name in names}


def gaps_around(
    study: Description, known: Mapping[str, Iterable[Gap]], carrier: float
) -> dict[str, Gap | None]:
    """Gap at the carrier (Hz) of each lattice, by its name, among all of its gaps."""
    settings = study.bands_settings
    gaps = {name: gap_at(every, carrier) for name, every in known.items()}
    for gap in gaps.values():
        if gap is not None and settings.resolution is None:
            reached = {"accuracy": settings.accuracy, "largest_error": gap.relative_error}
            for remark in accuracy_remarks(reached):
                warnings.warn(f"gap of the plate's lattice: {remark}", HaptonicWarning, stacklevel=2)
    return gaps


def driven_at(study: Description, at: float | None) -> Plate:
    """The plate with the drives of the carrier ``at`` (Hz), or else of the study's carrier."""
    return study.mounted_plate(at if at in study.carriers else None)


def gap_of_plate(study: Description, plate: Plate, carrier: float, runner: Runner) -> Gap | None:
    """Gap at the carrier (Hz) that all lattices beside the driven regions share; None without one."""
    return common_gap(gaps_around(study, lattice_gaps(study, plate, runner), carrier).values())


def response(study: Description, mounted: Plate, asked: ResponseSettings) -> Cost:
    """Estimated cost of the response of the study's plate."""
    chosen = fineness(study)
    counted = Counted.of(mounted, asked, chosen)
    whole = Cost(counted.seconds, counted.memory)
    for cell in mounted.layout.cells.values():
        if cell.solid is not None:
            mesh = tile_resolution(cell, chosen)
            whole += Cost(OF_SOLIDS * mesh.seconds(cell), mesh.memory(cell))
    return whole
