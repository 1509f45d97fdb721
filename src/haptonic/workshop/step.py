"""The exact solid as a STEP file, by OpenCascade as it comes with ``netgen-mesher``.

The solid has its true surfaces: cylinders, cones and fillets of circular section. OpenCascade counts in
millimetres here, and the file says so.
"""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path
from types import ModuleType
from typing import Any

from haptonic.cell import Pillar, UnitCell
from haptonic.errors import ResourceError
from haptonic.store import refuse_overwrite, write_atomically
from haptonic.workshop.shape import MM, Array, centres, in_mm, plate_outline, straight_side

# The date of writing and a running number are all that differs between two files of one solid.
_TIME_STAMP = re.compile(rb"'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d'")
_RUNNING_NUMBER = re.compile(rb"(Open CASCADE STEP translator [\d.]+) \d+")


def solid(cell: UnitCell, columns: int = 1, rows: int = 1) -> Any:
    """The plate with its pillars as one OpenCascade solid, in mm; its flat face lies at z = 0.

    Raises
    ------
    GeometryError : a number of columns or rows that is not a positive integer
    ResourceError : OpenCascade is missing
    """
    cell = in_mm(cell, columns, rows)
    occ = _occ()
    corners = [occ.Pnt(x, y, 0.0) for x, y in plate_outline(cell, columns, rows)]
    edges = [occ.Segment(a, b) for a, b in zip(corners, [*corners[1:], corners[0]], strict=True)]
    plate = occ.Prism(occ.Face(occ.Wire(edges)), occ.Vec(0.0, 0.0, cell.thickness))
    if cell.pillar is None:
        return plate
    pillar = (
        _round_body(occ, cell.pillar) if cell.pillar.section == "round" else _square_body(occ, cell.pillar)
    )
    places = [occ.Vec(x, y, cell.thickness) for x, y in centres(cell, columns, rows)]
    return plate + occ.Compound([pillar.Move(place) for place in places])


def write_step(
    path: Path, cell: UnitCell, columns: int = 1, rows: int = 1, *, overwrite: bool = False
) -> Path:
    """Write the plate of ``columns`` x ``rows`` cells as a STEP file in mm; the same plate is the same file.

    Raises
    ------
    GeometryError : a number of columns or rows that is not a positive integer
    ResourceError : OpenCascade is missing, the file exists and ``overwrite`` is False, or writing it fails
    """
    refuse_overwrite(path, overwrite)
    shape = solid(cell, columns, rows)

    def write(temporary: Path) -> None:
        shape.WriteStep(str(temporary))
        content = _TIME_STAMP.sub(b"'1970-01-01T00:00:00'", temporary.read_bytes(), count=1)
        temporary.write_bytes(_RUNNING_NUMBER.sub(rb"\1", content))

    write_atomically(path, write)
    return path


def volume_of_step(path: Path) -> float:
    """Volume of the solids in a STEP file, m^3.

    Raises
    ------
    ResourceError : OpenCascade is missing, or there is no such file, or it holds no solid
    """
    occ = _occ()
    from netgen.meshing import NgException

    try:
        solids = list(occ.OCCGeometry(str(path)).shape.solids) if path.is_file() else []
    except NgException:
        solids = []
    if not solids:
        raise ResourceError(
            argument="STEP file",
            given=path,
            allowed="a STEP file with a solid in it",
            cause="it is missing, of another format, or holds surfaces only",
            next_step="export the part as a solid, in the format STEP (ISO 10303-21)",
        )
    return float(sum(body.mass for body in solids)) / MM**3  # OpenCascade's mass is of density 1


def _occ() -> ModuleType:
    try:
        from netgen import occ
    except ImportError as error:
        raise ResourceError(
            argument="STEP file",
            given="a Python without netgen.occ",
            allowed="a Python with the package netgen-mesher, which brings OpenCascade",
            cause="the extra for CAD files is not installed",
            next_step='run: pip install "haptonic[cad]"',
        ) from error
    module: ModuleType = occ
    return module


def _flank(occ: ModuleType, pillar: Pillar, side: int) -> list[Any]:
    """Edges of the pillar's flank in the plane y = 0, from the plate upwards; ``side`` is 1 or -1."""

    def at(point: Array) -> Any:
        return occ.Pnt(side * float(point[0]), 0.0, float(point[1]))

    straight = [occ.Segment(at(a), at(b)) for a, b in pairwise(straight_side(pillar))]
    if pillar.arc is None:
        return straight
    return [occ.ArcOfCircle(*(at(pillar.arc.at(share)) for share in (0.0, 0.5, 1.0))), *straight]


def _foot(pillar: Pillar) -> float:
    """Half-width where the pillar meets the plate, the fillet counted."""
    return pillar.arc.centre[0] if pillar.arc else pillar.radius


def _round_body(occ: ModuleType, pillar: Pillar) -> Any:
    top = float(straight_side(pillar)[-1, 0])
    ends = [occ.Pnt(top, 0, pillar.height), occ.Pnt(0, 0, pillar.height), occ.Pnt(0, 0, 0)]
    ends.append(occ.Pnt(_foot(pillar), 0, 0))
    edges = [*_flank(occ, pillar, 1), *(occ.Segment(a, b) for a, b in pairwise(ends))]
    return occ.Revolve(occ.Face(occ.Wire(edges)), occ.Axis((0, 0, 0), occ.Z), 360)


def _square_body(occ: ModuleType, pillar: Pillar) -> Any:
    """Where two bars of the pillar's profile, one along x and one along y, cross each other."""
    top, foot = float(straight_side(pillar)[-1, 0]), _foot(pillar)
    edges = [
        *_flank(occ, pillar, 1),
        occ.Segment(occ.Pnt(top, 0, pillar.height), occ.Pnt(-top, 0, pillar.height)),
        *reversed(_flank(occ, pillar, -1)),
        occ.Segment(occ.Pnt(-foot, 0, 0), occ.Pnt(foot, 0, 0)),
    ]
    reach = 2 * pillar.widest
    profile = occ.Face(occ.Wire(edges)).Move(occ.Vec(0, -reach, 0))
    along_y = occ.Prism(profile, occ.Vec(0, 2 * reach, 0))
    return along_y * along_y.Rotate(occ.Axis((0, 0, 0), occ.Z), 90)
