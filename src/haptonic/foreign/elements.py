"""Volume elements and named groups of mesh files, read by meshio.

Abaqus files are read here: meshio 5.3 assigns an element set of several *ELEMENT blocks to wrong elements.
Files of which meshio would silently ignore a part are refused (`RefusedMesh`).
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

# edges of each supported element, with the order of their midpoint nodes as in meshio
EDGES = {
    "tetra": ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)),
    "pyramid": ((0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)),
    "wedge": ((0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)),
    "hexahedron": (
        *((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6)), *((6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)),
    ),
}  # fmt: skip
CORNERS = {"tetra": 4, "pyramid": 5, "wedge": 6, "hexahedron": 8}
SHAPES = {kind: kind for kind in CORNERS} | {
    f"{kind}{n + len(EDGES[kind])}": kind for kind, n in CORNERS.items()
}
FLAT = ("vertex", "line", "triangle", "quad", "polygon")  # beginnings of names of elements without volume
MOST_GROUPS = 64  # different numbers in an array; an array with more numbers elements instead of groups


class RefusedMesh(Exception):  # noqa: N818  it is reported in the answer and does not end the program
    """A mesh that is not one period of a plate: kind of the problem, and details for its message."""

    def __init__(self, kind: str, *, number: float = 0.0, place: Any = (), text: str = "") -> None:
        super().__init__(kind)
        self.kind, self.number, self.text = kind, number, text
        self.place = np.asarray(place, dtype=float)


@dataclass
class NamedElements:
    """Points (n, 3) in the file's unit; nodes of elements by meshio's names; element numbers of groups.

    Elements are numbered over all blocks, in order.
    """

    points: NDArray[Any]
    blocks: list[tuple[str, NDArray[np.int64]]]
    groups: dict[str, NDArray[np.int64]] = field(default_factory=dict)


def read_elements(path: str) -> NamedElements:
    """Volume elements of a file, and the groups that contain any.

    Raises
    ------
    RefusedMesh : no volume elements, unsupported elements, or unsupported statements on positions of nodes
    Exception : any exception of the parser for a damaged file
    """
    ending = Path(path).suffix.lower()
    readers = {".inp": _abaqus, ".bdf": _nastran, ".nas": _nastran, ".msh": _gmsh}
    whole = readers.get(ending, _vtk)(path)
    if not np.isfinite(whole.points).all() or whole.points.ndim != 2 or whole.points.shape[1] != 3:
        raise ValueError("positions that are not three finite numbers")
    return _of_volume(whole)


def _of_volume(whole: NamedElements) -> NamedElements:
    """Volume elements of a file, their groups and their points."""
    starts = np.cumsum([0, *(len(nodes) for _, nodes in whole.blocks)])
    kinds = [kind for kind, _ in whole.blocks]
    if other := next((kind for kind in kinds if kind not in SHAPES and not kind.startswith(FLAT)), None):
        raise RefusedMesh("element", text=other)
    blocks = [(kind, nodes) for kind, nodes in whole.blocks if kind in SHAPES and len(nodes)]
    if not blocks:
        raise RefusedMesh("empty", text=", ".join(dict.fromkeys(kinds)) or "none")
    is_solid = np.repeat([kind in SHAPES for kind in kinds], np.diff(starts))
    number = np.cumsum(is_solid) - 1
    groups = {name: number[members[is_solid[members]]] for name, members in whole.groups.items()}
    groups = {name: np.unique(members) for name, members in groups.items() if len(members)}
    return NamedElements(*of_elements(whole.points, blocks), groups)


def of_elements(
    points: NDArray[Any], blocks: list[tuple[str, NDArray[np.int64]]]
) -> tuple[NDArray[Any], list[tuple[str, NDArray[np.int64]]]]:
    """Points of elements, and the elements with new numbers of these points."""
    used = np.unique(np.concatenate([nodes.ravel() for _, nodes in blocks]))
    if used[0] < 0:
        raise ValueError("an element has a node that is not in the file")
    return points[used], [(kind, np.searchsorted(used, nodes)) for kind, nodes in blocks]


def _meshio() -> Any:
    """Import meshio; its readers know quadratic prisms and pyramids, its table of dimensions lacks them."""
    import meshio

    meshio._mesh.topological_dimension.update(wedge15=3, pyramid13=3)
    return meshio


def _of_meshio(mesh: Any, labels: dict[str, str]) -> NamedElements:
    """Convert meshio's result; numbers of groups get the label of their array, ``material 3``."""
    blocks = [(block.type, np.asarray(block.data, dtype=np.int64)) for block in mesh.cells]
    whole = NamedElements(np.asarray(mesh.points, dtype=float), blocks)
    for array, values in mesh.cell_data.items():
        numbers = np.concatenate([np.asarray(each) for each in values])
        values = np.unique(numbers)
        is_real = numbers.ndim == 1 and numbers.dtype.kind in "iuf"
        # some programs write whole numbers as decimals
        if is_real and len(values) <= MOST_GROUPS and np.array_equal(values, np.trunc(values)):
            for value in values.tolist():
                whole.groups[f"{labels.get(array, array)} {value:.0f}"] = np.flatnonzero(numbers == value)
    return whole


def _vtk(path: str) -> NamedElements:
    meshio = _meshio()
    read = meshio.vtu.read if path.lower().endswith(".vtu") else meshio.vtk.read
    return _of_meshio(read(path), {})


def _gmsh(path: str) -> NamedElements:
    """Read Gmsh; physical groups of volumes by name, such as ``core``, or ``group 3`` without a name.

    Geometrical entities are groups only if there are no physical ones: ``volume 1``.
    """
    mesh = _meshio().gmsh.read(path)
    labels = {"gmsh:physical": "group", "gmsh:geometrical": "volume"}
    if any(np.any(tags) for tags in mesh.cell_data.get("gmsh:physical", [])):
        del mesh.cell_data["gmsh:geometrical"]
    whole = _of_meshio(mesh, labels)
    whole.groups.pop("group 0", None)  # 0 means "no group" in the format
    for name, (tag, dimension) in mesh.field_data.items():
        members = whole.groups.pop(f"group {tag}", None) if dimension == 3 else None
        sets = mesh.cell_sets.get(name)
        if dimension == 3 and sets is not None:  # an entity may be in several groups
            starts = np.cumsum([0, *(len(nodes) for _, nodes in whole.blocks)])
            members = np.concatenate(
                [np.asarray(at, dtype=np.int64) + start for at, start in zip(sets, starts, strict=False)]
            )
        if members is not None:
            whole.groups[name] = members
    return whole


def _nastran(path: str) -> NamedElements:
    """Read Nastran; properties are groups, ``property 3``. A file may contain only the bulk data."""
    text = Path(path).read_text("latin-1").upper()
    if re.search(r"^C(TETRA|HEXA|PENTA|PYRAM?)\*", text, re.MULTILINE):
        raise RefusedMesh("text", text="elements in the large field format (CTETRA*)")
    if re.search(r"^INCLUDE", text, re.MULTILINE):
        raise RefusedMesh("text", text="INCLUDE, which reads another file")
    start = re.search(r"^\s*BEGIN\s+BULK.*$", text, re.MULTILINE)
    bulk = text[start.end() :] if start else text
    mesh = _meshio().nastran.read(io.StringIO(f"BEGIN BULK\n{bulk}\nENDDATA\n"))
    if np.any(mesh.point_data.get("nastran:ref", 0)):
        raise RefusedMesh("text", text="nodes (GRID) in a separate coordinate system (CP)")
    return _of_meshio(mesh, {"nastran:ref": "property"})


KINDS_OF_ABAQUS = {"4": "tetra", "10": "tetra10", "5": "pyramid", "13": "pyramid13", "6": "wedge",
                   "15": "wedge15", "8": "hexahedron", "20": "hexahedron20"}  # fmt: skip


def _abaqus(path: str) -> NamedElements:
    """Read Abaqus; element sets are groups. The file may have one part, without moved instances."""
    place: dict[int, int] = {}
    points: list[list[float]] = []
    blocks: list[tuple[str, NDArray[np.int64]]] = []
    number: dict[int, int] = {}  # number of an element of the file among the elements that are read
    sets: dict[str, list[int | str]] = {}
    for keyword, options, rows in _cards(Path(path).read_text("latin-1")):
        if keyword in ("INCLUDE", "SYSTEM") or (keyword == "INSTANCE" and rows):
            raise RefusedMesh("text", text=f"*{keyword}, which may move nodes")
        if keyword == "NODE":
            if options.get("SYSTEM", "R").upper() != "R":
                raise RefusedMesh("text", text="*NODE in a separate coordinate system (SYSTEM)")
            for node, *at in rows:
                if int(node) in place:
                    raise RefusedMesh("text", text=f"two nodes with the number {node}: several parts")
                place[int(node)] = len(points)
                points.append([float(x) for x in at[:3]])
        elif keyword == "ELEMENT":
            solid = re.fullmatch(r"(?:D?C3D|SC)(\d+)\w*", options.get("TYPE", "").upper())
            if solid is None:
                continue
            kind = KINDS_OF_ABAQUS.get(solid[1])
            if kind is None:
                raise RefusedMesh("element", text=options["TYPE"])
            shape = SHAPES[kind]
            count = CORNERS[shape] + (len(EDGES[shape]) if kind != shape else 0)
            numbers = np.array([int(entry) for row in rows for entry in row]).reshape(-1, count + 1)
            first = sum(len(nodes) for _, nodes in blocks)
            number |= {element: first + n for n, element in enumerate(numbers[:, 0].tolist())}
            nodes = np.array([place[node] for node in numbers[:, 1:].ravel().tolist()]).reshape(-1, count)
            blocks.append((kind, nodes))
            if name := options.get("ELSET"):
                sets.setdefault(name, []).extend(numbers[:, 0].tolist())
        elif keyword == "ELSET":
            if "GENERATE" in options:
                ranges = [[int(entry) for entry in row] for row in rows]
                members: list[int | str] = [m for low, high, *step in ranges
                                            for m in range(low, high + 1, *(step or [1]))]  # fmt: skip
            else:
                members = [int(entry) if entry.isdecimal() else entry for row in rows for entry in row]
            sets.setdefault(options["ELSET"], []).extend(members)
    groups = {name: np.array(sorted(_members(name, sets, number)), dtype=np.int64) for name in sets}
    return NamedElements(np.array(points), blocks, groups)


def _members(name: str, sets: dict[str, list[int | str]], number: dict[int, int], depth: int = 0) -> set[int]:
    """Elements of a set, including those of nested sets."""
    if depth > len(sets):
        raise ValueError("a set contains itself")
    members: set[int] = set()
    for entry in sets[name]:
        if isinstance(entry, str):
            members |= _members(entry, sets, number, depth + 1)
        elif entry in number:
            members.add(number[entry])
    return members


def _cards(text: str) -> Iterator[tuple[str, dict[str, str], list[list[str]]]]:
    """Keyword, options and rows of each card of an Abaqus file."""
    keyword, options, rows = "", dict[str, str](), list[list[str]]()
    for line in [*text.splitlines(), "*END"]:
        if line.startswith("**") or not line.strip():
            continue
        if line.startswith("*"):
            if keyword:
                yield keyword, options, rows
            first, *others = line[1:].split(",")
            keyword, rows = first.strip().upper(), []
            pairs = (option.partition("=") for option in others)
            options = {name.strip().upper(): value.strip().strip('"') for name, _, value in pairs}
        else:
            rows.append([entry.strip() for entry in line.split(",") if entry.strip()])
