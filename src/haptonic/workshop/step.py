"""The exact solid as a STEP file, by OpenCascade as it comes with ``netgen-mesher``.

The solid has its true surfaces: cylinders, cones and fillets of circular section. OpenCascade counts in
millimetres here, and the file says so.
"""

from __future__ import annotations

import math
import re
from itertools import pairwise
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from haptonic.arrays import Array
from haptonic.errors import ResourceError
from haptonic.store import refuse_overwrite, write_atomically
from haptonic.workshop.part import Part
from haptonic.workshop.shape import MM, PillarShape

# OpenCascade, as NETGEN calls it, puts its own name where the product's and the author's belong.
_HEADER = re.compile(r"FILE_NAME\(.*?\);", re.DOTALL)
_PRODUCT = re.compile(r"PRODUCT\('[^']*',\s*'[^']*',")


def solid(part: Part) -> Any:
    """The plate with its pillars as one OpenCascade solid, in mm; its lower face lies at z = 0.

    Raises
    ------
    ResourceError : OpenCascade is missing
    """
    occ, thickness = _occ(), part.cell.thickness

    def filled(loop: Array) -> Any:
        corners = [occ.Pnt(x, y, 0.0) for x, y in loop]
        return occ.Face(occ.Wire([occ.Segment(a, b) for a, b in pairwise([*corners, corners[0]])]))

    edge, *holes = part.outline
    face = filled(edge)
    for hole in holes:
        face = face - filled(hole[::-1])
    plate, pillars = occ.Prism(face, occ.Vec(0.0, 0.0, thickness)), []
    for pillar, places in part.standing:
        body = _pillar(occ, PillarShape.of(pillar))
        pillars += [body.Move(occ.Vec(x, y, thickness)) for x, y in places]
        if part.cell.is_mirrored:  # half a turn about x makes of a form its image, too
            below = body.Rotate(occ.Axis((0, 0, 0), occ.X), 180)
            pillars += [below.Move(occ.Vec(x, y, 0.0)) for x, y in places]
    return plate + occ.Compound(pillars) if pillars else plate


def write_step(path: Path, part: Part, *, title: str = "Plate", overwrite: bool = False) -> Path:
    """Write a part as a STEP file in mm; the same part is the same file.

    Parameters
    ----------
    title : name of the product

    Raises
    ------
    ResourceError : OpenCascade is missing, the file exists and ``overwrite`` is False, or writing it fails
    """
    refuse_overwrite(path, overwrite)
    shape, name = solid(part), _quoted(title)
    header = f"FILE_NAME({name},'1970-01-01T00:00:00',(''),(''),'Open CASCADE','haptonic','');"

    def write(temporary: Path) -> None:
        shape.WriteStep(str(temporary))
        text = _HEADER.sub(lambda _: header, temporary.read_text("ascii"), count=1)
        text = _PRODUCT.sub(lambda _: f"PRODUCT({name},{name},", text, count=1)
        temporary.write_text(text, "ascii", newline="\n")

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
        raise ResourceError.unreadable(
            argument="STEP file",
            given=path,
            allowed="a STEP file with a solid in it",
            cause="it is missing, of another format, or holds surfaces only",
            next_step="export the part as a solid, in the format STEP (ISO 10303-21)",
        )
    return float(sum(body.mass for body in solids)) / MM**3  # OpenCascade's mass is of density 1


def need_opencascade() -> None:
    """Refuse to go on where no STEP file can be written.

    Raises
    ------
    ResourceError : OpenCascade is missing
    """
    _occ()


def _occ() -> ModuleType:
    try:
        from netgen import occ
    except ImportError as error:
        raise ResourceError.not_installed(
            argument="STEP file",
            given="a Python without netgen.occ",
            allowed="a Python with the package netgen-mesher, which brings OpenCascade",
            cause="the extra for CAD files is not installed",
            next_step='run: pip install "haptonic[cad]", or ask for the other files: --dxf --stl --drawing',
        ) from error
    module: ModuleType = occ
    return module


def _pillar(occ: ModuleType, body: PillarShape) -> Any:
    """Its profile turned about the axis, or what the bars across each pair of a polygon's sides share."""

    def line(*places: tuple[float, float]) -> list[Any]:
        return [occ.Segment(occ.Pnt(a, 0, b), occ.Pnt(c, 0, d)) for (a, b), (c, d) in pairwise(places)]

    def flank(side: int) -> list[Any]:
        places = [(side * width, height) for width, height in body.side.tolist()]
        if body.arc is None:
            return line(*places)
        arc = body.arc.at(np.array([0.0, 0.5, 1.0])).tolist()
        return [occ.ArcOfCircle(*(occ.Pnt(side * width, 0, z) for width, z in arc)), *line(*places)]

    axis, top, foot = occ.Axis((0, 0, 0), occ.Z), float(body.side[-1, 0]), body.foot
    if not body.form.corners:
        wire = [*flank(1), *line((top, body.height), (0, body.height), (0, 0), (foot, 0))]
        return occ.Revolve(occ.Face(occ.Wire(wire)), axis, 360)
    across = line((top, body.height), (-top, body.height))
    wire = [*flank(1), *across, *reversed(flank(-1)), *line((-foot, 0), (foot, 0))]
    reach = 2 * max(foot, body.widest)
    bar = occ.Prism(occ.Face(occ.Wire(wire)).Move(occ.Vec(0, -reach, 0)), occ.Vec(0, 2 * reach, 0))
    shape = bar
    for angle in body.form.normals()[1:]:
        shape = shape * bar.Rotate(axis, math.degrees(angle))
    return shape


def _quoted(text: str) -> str:
    """A string of STEP (ISO 10303-21): quotes and backslashes doubled, what is not ASCII by its number."""
    doubled = text.replace("\\", "\\\\").replace("'", "''")
    codes = (c if " " <= c <= "~" else f"\\X2\\{c.encode('utf-16-be').hex().upper()}\\X0\\" for c in doubled)
    return f"'{''.join(codes)}'"
