"""The surface of a mesh for drawing: outer faces, and the edges of the body."""

from __future__ import annotations

from itertools import pairwise, product

import numpy as np

from haptonic.arrays import Array, Ints

PIECES = 8  # faces drawn along an element's side, at most
SHARP = np.cos(np.radians(35))  # faces that meet at a larger angle make an edge of the outline

VTK_CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
# a hexahedron's faces by its corners, anticlockwise seen from outside
FACES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])


def drawing_cells(subcells: Ints, grids: list[list[int]]) -> tuple[Ints, Ints]:
    """Hexahedra that are large enough to draw, and the nodes of their borders.

    Parameters
    ----------
    subcells : (cells, 8) corners of the small cells between nodes, in VTK's order
    grids : for each family of elements (elements, p1, p2, p3), their number and how many cells each has
        along its axes; see `haptonic.cell.HexMesh.linear_subcells`

    Returns
    -------
    cells : (n, 8) corners, at most `PIECES` cells along an element's side
    on_edge : nodes on the edges of elements
    """
    cells, on_edge = [], []
    start = 0
    for elements, *orders in grids:
        if not orders:  # cells that belong to no element
            cells.append(subcells[start : start + elements])
            start += elements
            continue
        stop = start + elements * int(np.prod(orders))
        small = subcells[start:stop].reshape(elements, *orders, 8)
        start = stop
        marks = [
            np.unique(np.round(np.linspace(0, order, min(PIECES, order) + 1)).astype(int)).tolist()
            for order in orders
        ]
        for ends in product(*(pairwise(along) for along in marks)):
            block = []
            for number, corner in enumerate(VTK_CORNERS):
                place = [ends[axis][corner[axis]] for axis in range(3)]
                i, j, k = (mark - side for mark, side in zip(place, corner, strict=True))
                nodes = small[:, i, j, k, number]
                block.append(nodes)
                if sum(mark in (0, order) for mark, order in zip(place, orders, strict=True)) >= 2:
                    on_edge.append(nodes)
            cells.append(np.stack(block, axis=-1))
    edges = np.concatenate(on_edge) if on_edge else np.empty(0, dtype=np.int64)
    return np.concatenate(cells), np.unique(edges)


def outer_faces(cells: Ints) -> Ints:
    """(m, 4) corners of the faces that belong to one cell only."""
    faces = cells[:, FACES].reshape(-1, 4)
    ordered = np.sort(faces, axis=1)
    extended = (np.diff(ordered, axis=1) > 0).all(axis=1)  # flat cells of a surface have one such face only
    faces, ordered = faces[extended], ordered[extended]
    _, first, times = np.unique(ordered, axis=0, return_index=True, return_counts=True)
    return np.asarray(faces[first[times == 1]])


def outline_edges(position: Array, faces: Ints) -> Ints:
    """(n, 2) ends of the edges at which two of the faces meet at a marked angle, or which only one face has.

    The faces at z = 0 of a solid from a file are finer than the others, so both have own edges there.
    """
    corners = position[faces]
    normal = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    edges = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
    order = np.lexsort(edges.T[::-1])
    owner = np.repeat(np.arange(len(faces)), 4)[order]
    every, first, times = np.unique(edges[order], axis=0, return_index=True, return_counts=True)
    assert times.max() <= 2, "at an edge of an outer surface meet one or two faces"
    meet = (normal[owner[first]] * normal[owner[first + times - 1]]).sum(axis=1)
    return np.asarray(every[(times == 1) | (meet < SHARP)])
