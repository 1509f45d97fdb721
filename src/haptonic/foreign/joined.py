"""Connections between elements of a mesh: faces, groups, and reasons why they are not one body."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.foreign.elements import CORNERS, EDGES, SHAPES, RefusedMesh
from haptonic.foreign.periods import SAME

# faces of elements, anticlockwise seen from outside, and at each corner its neighbours along edges, in
# right-handed order
FACES = {
    "tetra": ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)),
    "pyramid": ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
    "wedge": ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
    "hexahedron": ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)),
}
AROUND = {
    "tetra": ((0, 1, 2, 3),),
    "pyramid": ((0, 1, 3, 4), (1, 2, 0, 4), (2, 3, 1, 4), (3, 0, 2, 4)),
    "wedge": ((0, 1, 2, 3), (1, 2, 0, 4), (2, 0, 1, 5), (3, 5, 4, 0), (4, 3, 5, 1), (5, 4, 3, 2)),
    "hexahedron": (
        *((0, 1, 3, 4), (1, 2, 0, 5), (2, 3, 1, 6), (3, 0, 2, 7)),
        *((4, 7, 5, 0), (5, 4, 6, 1), (6, 5, 7, 2), (7, 6, 4, 3)),
    ),
}
MIRRORED = {"tetra": (0, 2, 1, 3), "tetra10": (0, 2, 1, 3, 6, 5, 4, 7, 9, 8), "pyramid": (0, 3, 2, 1, 4),
            "wedge": (3, 4, 5, 0, 1, 2), "hexahedron": (4, 5, 6, 7, 0, 1, 2, 3)}  # fmt: skip
FLAT = 1e-7  # smallest volume at a corner of an element, relative to the cube of its longest edge there
STRAIGHT = 1e-4  # distance of a midpoint node from the midpoint of its edge, relative to the edge's length


def turned(
    points: NDArray[Any], kind: str, nodes: NDArray[np.int64], refused: Any
) -> tuple[str, NDArray[np.int64]]:
    """Make a block of elements right-handed, and remove midpoint nodes of straight edges.

    Raises
    ------
    RefusedMesh : elements without volume or turned inside out; curved elements other than tetrahedra
    """
    shape = SHAPES[kind]
    corners = points[nodes[:, : CORNERS[shape]]]
    at = corners[:, np.array(AROUND[shape])]
    edges = at[:, :, 1:] - at[:, :, :1]
    longest = np.linalg.norm(edges, axis=3).max(axis=2)
    volume = np.linalg.det(edges) / np.maximum(longest, 1e-300) ** 3
    left = bool((volume < 0.0).all())  # some programs number nodes in the opposite sense
    bad = (volume * (-1.0 if left else 1.0)).min(axis=1) < FLAT
    if bad.any():
        raise refused("degenerate", corners[bad.argmax()].mean(axis=0), np.count_nonzero(bad))
    if kind != shape:
        pairs = np.array(EDGES[shape])
        ends = corners[:, pairs]
        away = np.linalg.norm(points[nodes[:, CORNERS[shape] :]] - ends.mean(axis=2), axis=2)
        curved = away > STRAIGHT * np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2)
        if not curved.any():
            kind, nodes = shape, nodes[:, : CORNERS[shape]]
        elif shape != "tetra":
            raise refused("curved", corners[curved.any(axis=1).argmax()].mean(axis=0), text=shape)
    return kind, nodes[:, MIRRORED[kind]] if left else nodes


def faces_of(
    blocks: Sequence[tuple[str, NDArray[np.int64]]], refused_at: Any
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Outer faces (n, 4), with -1 for a missing fourth corner, their elements, and (m, 2) joined elements.

    Raises
    ------
    RefusedMesh : faces of more than two elements
    """
    faces, owner = (np.concatenate(each) for each in zip(*_faces(blocks), strict=True))
    _, of_face, count = np.unique(np.sort(faces, axis=1), axis=0, return_inverse=True, return_counts=True)
    of_face = of_face.ravel()
    if count.max() > 2:
        raise refused_at("overlap", owner[(count[of_face] > 2).argmax()], np.count_nonzero(count > 2))
    order = np.argsort(of_face, kind="stable")
    shared = order[count[of_face[order]] == 2].reshape(-1, 2)
    outer = count[of_face] == 1
    return faces[outer], owner[outer], owner[shared]


def refuse_pieces(joined: NDArray[np.int64], count: int, refused_at: Any) -> None:
    """Refuse elements that are not joined by faces: separate ones, or joined by an edge or node only."""
    import scipy.sparse as sp
    from scipy.sparse.csgraph import connected_components

    pairs = sp.coo_matrix((np.ones(len(joined)), tuple(joined.T)), shape=(count, count))
    pieces, of_element = connected_components(pairs, directed=False)
    if pieces > 1:
        smallest = np.bincount(of_element).argmin()
        raise refused_at("pieces", (of_element == smallest).argmax(), pieces)


def padded(blocks: Sequence[tuple[str, NDArray[np.int64]]]) -> NDArray[np.int64]:
    """(elements, 8) corners of all elements, -1 for missing ones."""
    padded = np.full((sum(len(nodes) for _, nodes in blocks), 8), -1)
    first = 0
    for kind, nodes in blocks:
        corners = CORNERS[SHAPES[kind]]
        padded[first : first + len(nodes), :corners] = nodes[:, :corners]
        first += len(nodes)
    return padded


def _faces(
    blocks: Sequence[tuple[str, NDArray[np.int64]]],
) -> Iterator[tuple[NDArray[np.int64], NDArray[np.int64]]]:
    """(n, 4) faces of the elements of each block, and the numbers of their elements."""
    first = 0
    for kind, nodes in blocks:
        for face in FACES[SHAPES[kind]]:
            corners = np.full((len(nodes), 4), -1)
            corners[:, : len(face)] = nodes[:, face]
            yield corners, first + np.arange(len(nodes))
        first += len(nodes)


def on_faces(triangles: NDArray[Any], places: NDArray[Any]) -> Any:
    """True for places (n, 3) on triangles (n, 3, 3), including their edges."""
    a, b = triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    normal = np.cross(a, b)
    area = np.linalg.norm(normal, axis=1)
    normal /= np.maximum(area, 1e-300)[:, None]
    to = places - triangles[:, 0]
    s = np.einsum("ni,ni->n", np.cross(to, b), normal) / area
    t = np.einsum("ni,ni->n", np.cross(a, to), normal) / area
    near = np.abs(np.einsum("ni,ni->n", to, normal)) < SAME
    return near & (s > -1e-6) & (t > -1e-6) & (s + t < 1 + 1e-6)


def parts_of(
    groups: dict[str, NDArray[np.int64]], with_material: Sequence[str], count: int
) -> tuple[NDArray[np.int64], list[str]]:
    """Part number of each element, and names of the parts: elements of the same groups form one part.

    The name of a part is that of its group with a material, otherwise those of all its groups.

    Raises
    ------
    RefusedMesh : elements in two groups with different materials
    """
    names = list(groups)
    member = np.zeros((count, len(names)), dtype=bool)
    for column, members in enumerate(groups.values()):
        member[members, column] = True
    kinds, part = np.unique(member, axis=0, return_inverse=True)
    parts = []
    for kind in kinds:
        of_part = [name for name, is_member in zip(names, kind, strict=True) if is_member]
        given = [name for name in of_part if name in with_material]
        if len(given) > 1:
            raise RefusedMesh("twice", text=" and ".join(given))
        parts.append(given[0] if given else ", ".join(of_part) or "elements in no group")
    labels = list(dict.fromkeys(parts))
    return np.array([labels.index(name) for name in parts])[part.ravel()], labels
