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
from haptonic.cell.pillar_parts import Fillet
from haptonic.errors import ResourceError
from haptonic.materials import Material
from haptonic.workshop.part import Part
from haptonic.workshop.rings import Border, Ring
from haptonic.workshop.shape import MM, PillarShape

# OpenCascade, called by NETGEN, writes its own name instead of the product's and the author's.
_HEADER = re.compile(r"FILE_NAME\(.*?\);", re.DOTALL)
_CONTROL = re.compile(r"[\x00-\x1f\x7f]")
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
        inside = _filled(occ, stack.rim.outline, stack.rim.half_width)
        face = face - occ.Compound([inside.Move(occ.Vec(x, y, 0.0)) for x, y in places])
    return occ.Prism(face, occ.Vec(0.0, 0.0, thickness))


def _pieces(occ: ModuleType, part: Part, material: Material) -> list[Any]:
    """Pillars and rings of a material."""
    pieces = []
    for pillar, places in part.pillars:
        if part.solid_of(pillar) != material:
            continue
        shape = PillarShape.of(pillar)
        body = _body(occ, shape.outline, shape.side, shape.arc)
        pieces += [body.Move(occ.Vec(x, y, part.cell.thickness)) for x, y in places]
        if part.cell.is_mirrored:
            below = body.Mirror(occ.Axes((0, 0, 0), occ.Z))
            pieces += [below.Move(occ.Vec(x, y, 0.0)) for x, y in places]
    for stack, places in part.stacks:
        rings = [_ring(occ, ring) for ring in stack.rings(material)]
        if rings:
            whole = functools.reduce(operator.add, rings)
            pieces += [whole.Move(occ.Vec(x, y, 0.0)) for x, y in places]
    return pieces


def _ring(occ: ModuleType, ring: Ring) -> Any:
    body = _frustum(occ, ring.outer, ring)
    return body - _frustum(occ, ring.inner, ring) if ring.inner else body


def _frustum(occ: ModuleType, border: Border, ring: Ring) -> Any:
    height = ring.high - ring.low
    side = np.array([(border.low, 0.0), (border.high, height)])
    return _body(occ, border.outline, side).Move(occ.Vec(0, 0, ring.low))


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
        text = _in_ascii(temporary.read_text("utf-8"))  # with the names of materials
        text = _HEADER.sub(lambda _: header, text, count=1)
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


def _body(occ: ModuleType, outline: Outline, side: Array, arc: Fillet | None = None) -> Any:
    """Body about an axis as a revolved profile, an intersection of profiles along all sides, or prisms.

    side, arc : see `PillarShape`
    """
    if outline.is_tangential:
        (top, height), reach = side[-1].tolist(), 2 * float(side[:, 0].max()) * outline.reach
        foot = float(side[0, 0])
        flank = _line(occ, *side.tolist())
        if arc is not None:
            ends = [occ.Pnt(width, 0, z) for width, z in arc.at(np.array([0.0, 0.5, 1.0])).tolist()]
            flank, foot = [occ.ArcOfCircle(*ends), *flank], arc.centre[0]
            reach = max(reach, 2 * foot * outline.reach)
        inside = -reach if outline.joints else 0.0
        rest = _line(occ, (top, height), (inside, height), (inside, 0), (foot, 0))
        profile, axis = occ.Face(occ.Wire([*flank, *rest])), occ.Axis((0, 0, 0), occ.Z)
        if not outline.joints:
            return occ.Revolve(profile, axis, 360)
        bar = occ.Prism(profile.Move(occ.Vec(0, -reach, 0)), occ.Vec(0, 2 * reach, 0))
        bars = [bar.Rotate(axis, math.degrees(math.atan2(y, x))) for x, y in outline.flats.tolist()]
        return functools.reduce(operator.mul, bars)
    stages = [
        occ.Prism(_filled(occ, outline, width).Move(occ.Vec(0, 0, low)), occ.Vec(0, 0, high - low))
        for (width, low), (_, high) in list(pairwise(side.tolist()))[::2]
    ]
    return functools.reduce(operator.add, stages)


def _line(occ: ModuleType, *places: tuple[float, float]) -> list[Any]:
    return [occ.Segment(occ.Pnt(a, 0, b), occ.Pnt(c, 0, d)) for (a, b), (c, d) in pairwise(places)]


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
    return f"'{_in_ascii(_CONTROL.sub(lambda match: _code(match[0]), doubled))}'"


def _in_ascii(text: str) -> str:
    """A text of STEP with codes in place of the characters beyond ASCII."""
    return "".join(c if c.isascii() else _code(c) for c in text)


def _code(character: str) -> str:
    return f"\\X2\\{character.encode('utf-16-be').hex().upper()}\\X0\\"
