"""Errors for files of solids and meshes that form no period of a plate."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, get_args

import numpy as np

from haptonic.arrays import Array
from haptonic.errors import GeometryError, shown
from haptonic.fields import problem
from haptonic.names import counted
from haptonic.units import format_quantity, in_percent, to_si

IN_COMSOL = "in COMSOL: Mesh, Export, file type Nastran (.bdf), one property for each domain"
EXPORTED = {
    ".mphtxt": IN_COMSOL,
    ".mphbin": IN_COMSOL,
    ".cdb": "in Ansys: export the mesh as Nastran or Abaqus input, or by Gmsh",
}
OTHERWISE = "export the cell as STEP, or its mesh as .msh, .bdf, .inp or .vtu, from the program that made it"
Unit = Literal["m", "cm", "mm", "µm", "in"]  # of lengths in a mesh


def metres_of(unit: str) -> float:
    """Length of the unit of a mesh, m."""
    return to_si(f"1 {unit}", "m", "cell.solid.unit")


def other_format(file: str, ending: str, endings: Sequence[str]) -> Exception:
    """The error for a file of an unknown format."""
    return problem(
        "unsupported",
        shown(file, 100),
        f"a file whose name ends in {', '.join(endings[:-1])} or {endings[-1]}",
        "cells are read from STEP files (ISO 10303-21), and from meshes of formats that are published",
        EXPORTED.get(ending, OTHERWISE),
        at="file",
    )


def no_period(answer: dict[str, Any], thickness: float, unit: str) -> GeometryError:
    """The error for a file that forms no period of a plate.

    Parameters
    ----------
    answer : result of `haptonic.foreign.solids.inspected`
    thickness : of the plate, m
    unit : of a mesh; empty for solids
    """
    kind, share, length = answer["problem"], answer["number"], format_quantity(answer["number"], "m")
    if kind == "thickness":
        return GeometryError.mismatch(
            argument="cell.thickness",
            given=format_quantity(thickness, "m"),
            allowed=f"{length}, as in the file",
            cause="the plate of the file has another thickness along the sides of the cell",
            next_step=f'write thickness = "{length}" in [cell], or check the unit of the file',
        )
    extent = " x ".join(format_quantity(float(f"{size:.6g}"), "m") for size in np.ravel(answer["place"]))
    words = _of_mesh(answer, unit) if unit else {
        "empty": (
            "a file without a solid", "at least one solid",
            "it has surfaces or curves only", "export the cell as solids",
        ),
        "period": (
            f"solids whose copies fill {share:.4g} times their volume", "solids that fill one period",
            "the lattice of [cell] is not that of the file, so that copies overlap or leave gaps, or the "
            "file has more than one period",
            "check lattice, pitch and pitch_y against the drawing, and the unit of the file",
        ),
        "sides": (
            f"solids of {extent} in x, y and z, whose plate is not whole along the sides of the cell",
            "a flat plate of one thickness there, normal to z",
            "the pitch, the unit or the direction of the axes is another one; or around every place tried, "
            "holes or pillars reach a side of the cell",
            "compare these sizes with [cell]; draw one period with its pillar or hole in the middle",
        ),
        "pieces": (
            f"{answer['number']:.0f} pieces that no faces join", "solids that touch along faces",
            "a gap between two solids, perhaps too small to be seen, or solids that touch at an edge only",
            "close the gap in the program that drew them; solids that touch exactly are joined",
        ),
        "unmeshed": (
            f"solids that Netgen cannot mesh: {answer['text']}", "surfaces without tips and slivers",
            "a surface ends in a point, such as the tip of a cone, or has parts far smaller than the plate",
            "cut off the tip, or remove the small parts, in the program that drew them",
        ),
        "materials": (
            "several solids along the sides of the cell", "one solid along all sides",
            "the plate consists of layers, or solids meet where cells do",
            "join the solids along the sides into one, or draw the period about another place",
        ),
        "overlap": (
            "solids that overlap", "solids that touch at most",
            "the same space belongs to two solids", "cut one out of the other in the program that drew them",
        ),
    }  # fmt: skip
    given, allowed, cause, next_step = words[kind]
    family = GeometryError.missing if kind == "bare" else GeometryError.mismatch
    return family(
        argument="cell.solid.part" if kind in ("bare", "twice") else "cell.solid.file",
        given=given,
        allowed=allowed,
        cause=cause,
        next_step=next_step,
    )


def _of_mesh(answer: dict[str, Any], unit: str) -> dict[str, tuple[str, str, str, str]]:
    """Parts of the error for each kind of problem of a mesh: given, allowed, cause, next step."""
    number, text, place = answer["number"], answer["text"], np.asarray(answer["place"])
    count, at = f"{number:.0f}", _places(place)
    sizes = place if answer["problem"] == "extent" else np.zeros((2, 2))
    of_mesh, of_cell = (" x ".join(format_quantity(each, "m") for each in row) for row in sizes.tolist())
    again = "mesh the cell again as one body, or join the nodes in the program that made the mesh"
    return {
        "empty": (
            f"a mesh without volume elements (it has: {text})", "tetrahedra, hexahedra, prisms or pyramids",
            "the mesh is that of a surface, or only surfaces are in a group that was saved",
            "mesh the volumes; in Gmsh put them into a physical group, or save all elements",
        ),
        "element": (
            f"elements of the kind {shown(text)}",
            "linear elements, or quadratic ones of 10, 13, 15 or 20 nodes",
            "elements of another order or kind are not read",
            "mesh with linear or quadratic elements; in Gmsh set Mesh.ElementOrder = 1, or "
            "Mesh.SecondOrderIncomplete = 1",
        ),
        "text": (
            text, "one flat mesh: nodes, elements, and groups of these",
            "the file needs other files, parts or coordinate systems to define its nodes",
            "export the mesh as one part in global coordinates, or read and save it with Gmsh",
        ),
        "curved": (
            f"curved elements: {text}, near {at}", "curved tetrahedra, or elements with straight edges",
            "only quadratic tetrahedra keep their curved edges here",
            "mesh with quadratic tetrahedra alone, or with linear and smaller elements",
        ),
        "degenerate": (
            f"{counted(int(count), 'element')} without volume or turned inside out, the first at {at}",
            "elements of positive volume",
            "nodes were moved or joined after meshing, or curved edges cross the element",
            "repair the mesh in the program that made it; quadratic elements may be smaller or straight",
        ),
        "doubled": (
            f"{count} nodes at the place of another, the first at {at}", "one node at each place",
            "parts were meshed one by one, so that the mesh has a crack where they meet", again,
        ),
        "hanging": (
            f"{count} nodes or faces on an element's face that are not joined to it, the first at {at}",
            "elements that share whole faces with their neighbours",
            "parts were meshed one by one, or tetrahedra meet hexahedra without pyramids between them", again,
        ),
        "overlap": (
            f"{counted(int(count), 'face')} of more than two elements, the first at {at}",
            "elements that touch at most",
            "elements are there twice, or fill the same space", "remove double elements from the mesh",
        ),
        "pieces": (
            f"{count} pieces that no faces join, one at {at}", "one body",
            "a part is loose, touches others along an edge only, or was meshed by itself", again,
        ),
        "extent": (
            f"a mesh of {of_mesh} in x and y", f"{of_cell}, the size of the cell",
            "the mesh is of another lattice or pitch, has more than one period, or is in another unit than "
            f'unit = "{unit}"',
            _fitting(sizes, unit),
        ),
        "outside": (
            f"a mesh that reaches {format_quantity(number, 'm')} beyond a side of the cell, at {at}",
            "a mesh within the sides of the cell, which are halfway to its neighbours",
            "a mesh cannot be cut: it has to fill a rectangle, or on a triangular lattice a hexagon, not a "
            "rhombus; or it is turned about z",
            "draw the period with its sides halfway between neighbours; corners that it can have are in "
            "`UnitCell.corners`; or export it as STEP, which is cut",
        ),
        "side": (
            f"faces on {in_percent(number, form='.1f')} of a side of the cell, that from {at}",
            "a plate that fills all sides from its lower to its upper face",
            "a hole or a pillar reaches the side, the mesh has a gap there, or is not flat",
            "draw the period about another place, with its pillar or hole in the middle",
        ),
        "coarse": (
            f"one element along a side of the cell, that from {at}", "at least two elements along each side",
            "the mesh is too coarse for the waves of the plate", "mesh with smaller elements",
        ),
        "uneven": (
            f"a plate with sides of different heights: {at}", "a flat plate of one thickness along all sides",
            "the plate is curved or its thickness varies", "draw a period whose sides are alike",
        ),
        "groups": (
            f"groups that meet the sides of the cell: {text}", "one group along all sides",
            "the plate consists of layers, or groups meet where cells do",
            "put the plate into one group, or draw the period about another place",
        ),
        "bare": (
            f"no material for {shown(text, 100)}", "a material for each group but that along the sides",
            "the group has no table in the study, or elements are in no group",
            f'add [[cell.solid.part]] with name = "{text}" and a material',
        ),
        "twice": (
            f"elements in several groups with a material: {text}", "one material for each element",
            "the groups overlap", "give a material to one of these groups only",
        ),
    }  # fmt: skip


def _places(places: Array) -> str:
    """Places (..., 3) in m, as text."""
    rows = places.reshape(-1, 3) if places.size % 3 == 0 else np.zeros((0, 3))
    texts = [
        "(" + ", ".join(format_quantity(round(x, 9) + 0.0, "m") for x in row) + ")" for row in rows.tolist()
    ]
    return " to ".join(texts)


def _fitting(extents: Array, unit: str) -> str:
    """Next step for a mesh of another extent than the cell: (2, 2) m, in a unit."""
    for other in get_args(Unit):
        if np.allclose(extents[0] / metres_of(unit) * metres_of(other), extents[1], rtol=1e-3):
            return f'write unit = "{other}" in [cell.solid]: the sizes agree then'
    return "check lattice, pitch and pitch_y in [cell] and unit in [cell.solid] against the mesh"
