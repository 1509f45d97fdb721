"""Kinds of cells that an analysis supports.

Every analysis has a function of the cell and its options. It returns None, or the error for an unsupported
cell. `Analysis.admit` calls it before work starts, for every command, method and report. So each analysis
supports a new feature of a cell or refuses it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from haptonic.cell import UnitCell
from haptonic.errors import HaptonicError, StudyError

Supports = Callable[[UnitCell, Any], HaptonicError | None]


def every_cell(cell: UnitCell, options: Any) -> HaptonicError | None:
    """None: every outline, material, lattice and face of a cell is supported."""
    return None


def no_cell(cell: UnitCell, options: Any) -> HaptonicError | None:
    """None: the result does not depend on a cell."""
    return None


def one_loss_factor(cell: UnitCell, options: Any) -> HaptonicError | None:
    """Error for a cell with two loss factors."""
    of_plate = cell.material.loss_factor
    others = {at: solid.loss_factor for at, solid in cell.materials.items() if solid.loss_factor != of_plate}
    if not others:
        return None
    at, loss = next(iter(others.items()))
    return StudyError.unsupported(
        argument=f"cell.{at}",
        given=f"a loss factor of {loss:g}, and {of_plate:g} in the plate",
        allowed="the same loss factor in all materials of the cell",
        cause="this analysis multiplies the stiffness of the whole lattice by a single complex factor",
        next_step=f"give cell.{at} by its constants, with the plate's loss_factor among them",
    )


def made_of_parts(cell: UnitCell, options: Any) -> HaptonicError | None:
    """Error for a cell from a CAD file or a mesh, whose sizes and outlines an analysis would need."""
    if cell.solid is None:
        return None
    return StudyError.unsupported(
        argument="cell.solid",
        given="a cell from a CAD file or mesh",
        allowed="a cell of pillars or discs, or plain plate",
        cause="this analysis needs outlines or sizes by name, which a file does not give",
        next_step="compute bands, a sweep of materials, layers, a ribbon or a plate, or write [cell.pillar]",
    )


def whole_lower_face(cell: UnitCell, options: Any) -> HaptonicError | None:
    """Error for a hole in the face that a finger touches, or for something below that face."""
    if cell.solid is not None and not cell.solid_period.whole_below:
        return StudyError.unsupported(
            argument="cell.solid",
            given="a cell whose lower face is not a whole plane",
            allowed="solids above a plane face that fills the cell, at the plate's lower side",
            cause="a finger touches the lower face everywhere, and the scan's points lie on it; the file has "
            "a hole there, or something below it",
            next_step="turn the drawing upside down if its upper face is whole, or compute bands, layers or "
            "a ribbon",
        )
    if (path := cell.hole_below) is None:
        return None
    return StudyError.unsupported(
        argument=f"cell.{path}",
        given="a hole through the plate",
        allowed="discs that leave the lower face of a finite plate whole, such as blind holes",
        cause="a finger touches the lower face everywhere, and the scan's points lie on it",
        next_step="give the hole a low above the lower face, or compute bands, a sweep or layers",
    )
