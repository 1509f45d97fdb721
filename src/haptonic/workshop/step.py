"""Exact solid as a STEP file, by the OpenCascade of ``netgen-mesher``.

The solid has exact surfaces: cylinders, cones and circular fillets. OpenCascade works in millimetres here,
and the file gives this unit.
"""

from __future__ import annotations

import functools
import math
import operator
import re
from itertools import pairwise
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from haptonic.arrays import Array
from haptonic.atomic import refuse_overwrite, write_atomically
from haptonic.cell.outlines import Outline
from haptonic.errors import ResourceError
from haptonic.materials import Material
from haptonic.workshop.part import Part
from haptonic.workshop.rings import Ring
from haptonic.workshop.shape import MM, PillarShape

# OpenCascade, called by NETGEN, writes its own name instead of the product's and the author's.
_HEADER = re.compile(r"FILE_NAME\(.*?\);", re.DOTALL)
_PRODUCT = re.compile(r"PRODUCT\('[^']*',\s*'[^']*',")


def solid(part: Part) -> Any:
    """Solid of the plate with all its pillars and discs in mm; its lower face lies at z = 0.

    For one material it is one OpenCascade solid, for several a compound of solids with the materials' names.

    Raises
    ------
    ResourceError : OpenCascade is missing
    """
    occ, shapes = _occ(), []
    for material in part.materials:
        pieces = _pieces(occ, part, material)
        if material == part.cell.material:
            plate = _plate(occ, part)
            pieces = [plate + occ.Compound(pieces) if pieces else plate]
        for shape in pieces:
            for body in shape.solids:
                body.name = material.name
        shapes += pieces
    return shapes[0] if len(shapes) == 1 else occ.Compound(shapes)


def _plate(occ: ModuleType, part: Part) -> Any:
    """Plate without the space of stacks of discs."""
    thickness = part.cell.thickness

    def filled(loop: Array) -> Any:
        corners = [occ.Pnt(x, y, 0.0) for x, y in loop]
        return occ.Face(occ.Wire([occ.Segment(a, b) for a, b in pairwise([*corners, corners[0]])]))

    edge, *holes = part.outline
    face = filled(edge)
    for hole in holes:
        face = face - filled(hole[::-1])
    for stack, places in part.stacks:
        widest = stack.borders[-1]
        inside = _filled(occ, widest.outline, widest.half_width)
        face = face - occ.Compound([inside.Move(occ.Vec(x, y, 0.0)) for x, y in places])
    return occ.Prism(face, occ.Vec(0.0, 0.0, thickness))


def _pieces(occ: ModuleType, part: Part, material: Material) -> list[Any]:
    """Pillars and rings of a material."""
    pieces = []
    for pillar, places in part.pillars:
        if part.solid_of(pillar) != material:
            continue
        body = _pillar(occ, PillarShape.of(pillar))
        pieces += [body.Move(occ.Vec(x, y, part.cell.thickness)) for x, y in places]
        if part.cell.is_mirrored:
            below = body.Mirror(occ.Axes((0, 0, 0), occ.Z))
            pieces += [below.Move(occ.Vec(x, y, 0.0)) for x, y in places]
    for stack, places in part.stacks:
        rings = [_prism(occ, ring) for ring in stack.rings(material)]
        if rings:
            whole = functools.reduce(operator.add, rings)
            pieces += [whole.Move(occ.Vec(x, y, 0.0)) for x, y in places]
    return pieces


def _prism(occ: ModuleType, ring: Ring) -> Any:
    face = _filled(occ, ring.outer.outline, ring.outer.half_width)
    if ring.inner:
        face = face - _filled(occ, ring.inner.outline, ring.inner.half_width)
    return occ.Prism(face.Move(occ.Vec(0, 0, ring.low)), occ.Vec(0, 0, ring.high - ring.low))


def write_step(path: Path, part: Part, *, title: str = "Plate", overwrite: bool = False) -> Path:
    """Write a part as a STEP file in mm; the same part always gives the same file.

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
    ResourceError : OpenCascade is missing, or the file does not exist or has no solid
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
            cause="it is missing, of another format, or has surfaces only",
            next_step="export the part as a solid, in the format STEP (ISO 10303-21)",
        )
    return float(sum(body.mass for body in solids)) / MM**3  # OpenCascade's mass is of density 1


def need_opencascade() -> None:
    """Refuse to continue if no STEP file can be written.

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
    """Pillar as a revolved profile, an intersection of profiles along all sides, or prisms on each other."""
    if body.outline.is_tangential:
        return _cut(occ, body) if body.outline.joints else _turned(occ, body)
    shape = None
    for (width, low), (_, high) in list(pairwise(body.side.tolist()))[::2]:
        face = _filled(occ, body.outline, width).Move(occ.Vec(0, 0, low))
        stage = occ.Prism(face, occ.Vec(0, 0, high - low))
        shape = stage if shape is None else shape + stage
    return shape


def _line(occ: ModuleType, *places: tuple[float, float]) -> list[Any]:
    return [occ.Segment(occ.Pnt(a, 0, b), occ.Pnt(c, 0, d)) for (a, b), (c, d) in pairwise(places)]


def _flank(occ: ModuleType, body: PillarShape) -> list[Any]:
    """The profile from the plate to the top's edge."""
    if body.arc is None:
        return _line(occ, *body.side.tolist())
    arc = body.arc.at(np.array([0.0, 0.5, 1.0])).tolist()
    return [occ.ArcOfCircle(*(occ.Pnt(width, 0, z) for width, z in arc)), *_line(occ, *body.side.tolist())]


def _turned(occ: ModuleType, body: PillarShape) -> Any:
    """Profile revolved about the axis."""
    top = float(body.side[-1, 0])
    rest = _line(occ, (top, body.height), (0, body.height), (0, 0), (body.foot, 0))
    return occ.Revolve(occ.Face(occ.Wire([*_flank(occ, body), *rest])), occ.Axis((0, 0, 0), occ.Z), 360)


def _cut(occ: ModuleType, body: PillarShape) -> Any:
    """Intersection of bars with the profile on one side, one bar along each side of the outline."""
    axis, top = occ.Axis((0, 0, 0), occ.Z), float(body.side[-1, 0])
    reach = 2 * max(body.foot, body.widest) * body.outline.reach
    rest = _line(occ, (top, body.height), (-reach, body.height), (-reach, 0), (body.foot, 0))
    face = occ.Face(occ.Wire([*_flank(occ, body), *rest])).Move(occ.Vec(0, -reach, 0))
    bar, shape = occ.Prism(face, occ.Vec(0, 2 * reach, 0)), None
    for x, y in body.outline.flats.tolist():
        side = bar.Rotate(axis, math.degrees(math.atan2(y, x)))
        shape = side if shape is None else shape * side
    return shape


def _filled(occ: ModuleType, outline: Outline, half_width: float) -> Any:
    """Inside of an outline as a face at z = 0."""
    if not outline.joints:
        (large, small), (a, b) = outline.half_axes
        plane = occ.WorkPlane(occ.Axes((0, 0, 0), occ.Z, occ.Dir(a, b, 0)))
        return plane.Ellipse(half_width * large, half_width * small).Face()
    edges = []
    for piece, bulge in enumerate(outline.bulges.tolist()):
        places = half_width * outline.at(piece + np.array([0.0, 0.5, 1.0]))
        first, middle, last = (occ.Pnt(x, y, 0) for x, y in places.tolist())
        edges.append(occ.ArcOfCircle(first, middle, last) if bulge else occ.Segment(first, last))
    return occ.Face(occ.Wire(edges))


def _quoted(text: str) -> str:
    """A string of STEP (ISO 10303-21): quotes and backslashes doubled, other characters by their codes."""
    doubled = text.replace("\\", "\\\\").replace("'", "''")
    codes = (c if " " <= c <= "~" else f"\\X2\\{c.encode('utf-16-be').hex().upper()}\\X0\\" for c in doubled)
    return f"'{''.join(codes)}'"
