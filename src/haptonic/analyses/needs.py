"""What several analyses need of a study: its carrier, its plate's mesh, the gap of the plate's lattice."""

from __future__ import annotations

from haptonic.analyses.runner import Runner
from haptonic.bloch import Gap
from haptonic.bloch.gaps import gap_at
from haptonic.bloch.reach import check_memory, started
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.rows import rows_need
from haptonic.cell import Rows, UnitCell
from haptonic.errors import StudyError
from haptonic.plate import Fineness, Plate
from haptonic.plate.reduction import BLOCK, STEPS
from haptonic.plate.settings import ResponseSettings
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


def need_one_loss(cell: UnitCell, analysis: str) -> None:
    """Refuse a cell whose materials have different losses, in an analysis with one loss factor for all.

    Raises
    ------
    StudyError : a pillar's material has another loss factor than the plate's
    """
    if len(cell.loss_factors) == 1:
        return
    of_plate = cell.material.loss_factor
    losses = {at: solid.loss_factor for at, solid in cell.materials.items()}
    at = next(at for at, loss in losses.items() if loss != of_plate)
    raise StudyError.unsupported(
        argument=f"cell.{at}",
        given=f"a loss factor of {losses[at]:g}, and {of_plate:g} in the plate",
        allowed=f"the same loss factor in plate and pillars, for `haptonic {analysis}`",
        cause="this analysis multiplies the stiffness of the whole lattice by a single complex factor",
        next_step=f"give this material by its constants in a [cell.{at}] table, with the plate's loss_factor",
    )


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
    return Fineness(min(order, usual.along), usual.through, cell=order, rings=rings, plain=order)


def checked_fineness(study: Description) -> Fineness | None:
    """The same, once it is sure that it can be had.

    Raises
    ------
    ResourceError : a mesh of a cell that this machine cannot hold, foreseen before anything is computed
    """
    chosen = fineness(study)
    if chosen is not None:
        for cell in study.mounted_plate().layout.cells.values():
            check_memory(cell, Resolution(chosen.cell, chosen.rings, STEPS, BLOCK))
    return chosen


def gap_of_plate(study: Description, plate: Plate, carrier: float, runner: Runner) -> Gap | None:
    """The gap of the plate's lattice that holds the carrier (Hz), if there is one."""
    cells = list(plate.layout.cells.values())
    return gap_at(Runner(runner.store).gaps(cells[0], study.bands_settings), carrier) if cells else None


def has_mirror(study: Description) -> bool:
    """Whether a mirror, and a waveguide between two of them, can be asked for.

    There is a carrier, and something that reflects; on which lattice does not matter.
    """
    return study.carrier is not None and study.cell.has_pillars


def need_rows(study: Description, table: str = "layers") -> tuple[int, float]:
    """What the rows of a study's mirror take on the mesh that is tried first; see `rows_need`.

    table : of the study that gives their direction
    """
    settings = study.bands_settings
    first = settings.resolution or started(study.cell, settings.count, settings.accuracy)[0]
    along = (study.layers_settings if table == "layers" else study.waveguide_settings).direction
    return rows_need(Rows(study.cell, along, table=table), first)


def has_plate(study: Description) -> bool:
    """Whether a finite plate can be asked for."""
    return study.finite_plate is not None and study.carrier is not None
