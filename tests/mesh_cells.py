"""Cells as meshes of other programs: hexahedra over a grid, and Netgen's tetrahedra."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import meshio
import numpy as np

Named = dict[str, np.ndarray]  # numbers of the elements of each group


def hexahedra(
    across: np.ndarray, upward: np.ndarray, group: Callable[[float, float, float], str]
) -> tuple[np.ndarray, np.ndarray, Named]:
    """Places (n, 3), elements (m, 8) and groups over a grid, where ``group`` of a middle is not empty."""
    places = np.stack(np.meshgrid(across, across, upward, indexing="ij"), axis=-1)
    number = np.arange(places[..., 0].size).reshape(places.shape[:3])
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    nodes, names = [], []
    for i in range(len(across) - 1):
        for j in range(len(across) - 1):
            for k in range(len(upward) - 1):
                name = group(*(0.5 * (places[i, j, k] + places[i + 1, j + 1, k + 1])))
                if name:
                    nodes.append([number[i + a, j + b, k + c] for c in (0, 1) for a, b in corners])
                    names.append(name)
    sets = {name: np.flatnonzero(np.array(names) == name) for name in dict.fromkeys(names)}
    return places.reshape(-1, 3), np.array(nodes), sets


def tetrahedra(body: Any, size: float, *, quadratic: bool = False) -> tuple[np.ndarray, np.ndarray, Named]:
    """The same of a body of Netgen's OCC; its solids' names are the groups."""
    from netgen import occ

    mesh = occ.OCCGeometry(body).GenerateMesh(maxh=size)
    if quadratic:
        mesh.SecondOrder()
    places = np.array([point.p for point in mesh.Points()])
    elements = list(mesh.Elements3D())
    nodes = np.array([[point.nr - 1 for point in element.points] for element in elements])
    if quadratic:  # Netgen's order of middle nodes to meshio's
        nodes = nodes[:, [0, 1, 2, 3, 4, 7, 5, 6, 8, 9]]
    index = np.array([element.index for element in elements])
    sets = {mesh.GetMaterial(n): np.flatnonzero(index == n) for n in range(1, index.max() + 1)}
    return places, nodes, sets


def write(path: Path, places: np.ndarray, nodes: np.ndarray, sets: Named, kind: str = "hexahedron") -> Path:
    """Write a mesh in the format that the path's ending names, with its groups."""
    blocks = [(kind, nodes[members]) for members in sets.values()]
    tags = [np.full(len(members), n) for n, members in enumerate(sets.values(), start=1)]
    ending = path.suffix
    if ending == ".msh":
        data = {"gmsh:physical": tags, "gmsh:geometrical": tags}
        names = {name: np.array([n, 3]) for n, name in enumerate(sets, start=1)}
        meshio.gmsh.write(path, meshio.Mesh(places, blocks, cell_data=data, field_data=names), "2.2")
    elif ending == ".bdf":
        meshio.nastran.write(path, meshio.Mesh(places, blocks, cell_data={"nastran:ref": tags}))
    elif ending == ".inp":
        each = [
            [np.arange(len(b[1])) if a == c else [] for c, b in enumerate(blocks)] for a in range(len(sets))
        ]
        meshio.abaqus.write(path, meshio.Mesh(places, blocks, cell_sets=dict(zip(sets, each, strict=True))))
    else:
        meshio.Mesh(places, blocks, cell_data={"material": tags}).write(path)
    return path
