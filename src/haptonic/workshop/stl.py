"""The plate's surface as a watertight triangulation in an STL file, in mm.

Every horizontal outline of a pillar is a multiple of one polygon, so its side is a grid of levels times
corners. The plate's top around a pillar is joined to the four corners of the cell and to nothing between
them: neighbouring cells therefore fit together by their corner numbers alone.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from haptonic.cell import Pillar, UnitCell
from haptonic.errors import GeometryError
from haptonic.store import refuse_overwrite, write_atomically
from haptonic.workshop.shape import MM, Array, centres, corner_grid, in_mm, straight_side

Triangles = NDArray[np.int64]

CHORD = 5e-6  # m, by default the largest distance between a curved surface and its triangles
_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


@dataclass(frozen=True)
class Surface:
    """Closed triangulated surface.

    points : (n, 3), m
    triangles : (m, 3) point numbers, anticlockwise when seen from outside
    """

    points: Array
    triangles: Triangles

    @property
    def volume(self) -> float:
        """Enclosed volume by the divergence theorem, m^3."""
        a, b, c = np.moveaxis(self.points[self.triangles], 1, 0)
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)

    @property
    def is_watertight(self) -> bool:
        """Whether each edge has exactly two triangles, which run along it in opposite directions."""
        edges = np.concatenate([self.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
        directed = set(map(tuple, edges.tolist()))
        return len(directed) == len(edges) and all((b, a) in directed for a, b in directed)


def surface(cell: UnitCell, columns: int = 1, rows: int = 1, *, chord: float = CHORD) -> Surface:
    """Surface of a plate; its corners lie on the true surface, its curves are off by at most ``chord`` (m).

    Raises
    ------
    GeometryError : a number of columns or rows that is not a positive integer, or a useless ``chord``
    """
    scaled = in_mm(cell, columns, rows)
    smallest = min(scaled.lattice.pitch, 2 * scaled.pillar.narrowest if scaled.pillar else math.inf)
    if not 1e-6 * smallest < chord * MM < 0.1 * smallest:
        raise GeometryError(
            argument="chord",
            given=f"{chord} m",
            allowed=f"between {1e-9 * smallest:.3g} m and {1e-4 * smallest:.3g} m for this cell",
            cause="the triangles would be too many, or the pillar would no longer be recognised",
            next_step="leave it out, or choose a tenth of the workshop's tolerance",
        )
    corners = corner_grid(scaled, columns, rows)
    layer = np.arange(corners[..., 0].size).reshape(columns + 1, rows + 1)
    flat = corners.reshape(-1, 2)
    points = [np.insert(flat, 2, z, axis=1) for z in (0.0, scaled.thickness)]
    triangles = [_bottom(layer), _rim(layer, layer.size)]
    quads = _quads(layer) + layer.size
    if scaled.pillar is None:
        triangles.append(_halved(quads))
    else:
        body, side = _pillar(scaled.pillar, chord * MM)
        polygon = body[: side.corners, :2]
        first = 2 * layer.size
        for centre, quad in zip(centres(scaled, columns, rows), quads, strict=True):
            points.append(body + np.append(centre, scaled.thickness))
            triangles.append(side.triangles + first)
            triangles.append(_ring(polygon, flat[quad - layer.size] - centre, first, quad))
            first += len(body)
    return Surface(np.concatenate(points) / MM, np.concatenate(triangles))


def write_stl(
    path: Path,
    cell: UnitCell,
    columns: int = 1,
    rows: int = 1,
    *,
    chord: float = CHORD,
    overwrite: bool = False,
) -> Path:
    """Write the plate of ``columns`` x ``rows`` cells as a binary STL file in mm.

    Raises
    ------
    GeometryError : as `surface`
    ResourceError : the file exists and ``overwrite`` is False, or it cannot be written
    """
    refuse_overwrite(path, overwrite)
    skin = surface(cell, columns, rows, chord=chord)
    facets = np.zeros(len(skin.triangles), dtype=_RECORD)
    corners = (skin.points * MM)[skin.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    facets["normal"] = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    facets["corners"] = corners
    header = b"haptonic: plate in mm, flat face at z = 0".ljust(80) + np.array(len(facets), "<u4").tobytes()
    write_atomically(path, lambda temporary: temporary.write_bytes(header + facets.tobytes()))
    return path


@dataclass(frozen=True)
class _Side:
    """Triangles of a pillar's side and top, and the number of corners of its outline."""

    triangles: Triangles
    corners: int


def _quads(layer: Triangles) -> Triangles:
    """(cells, 4) corner numbers of each cell, anticlockwise from above."""
    parts = (layer[:-1, :-1], layer[1:, :-1], layer[1:, 1:], layer[:-1, 1:])
    return np.stack([part.ravel() for part in parts], axis=1)


def _halved(quads: Triangles) -> Triangles:
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def _bottom(layer: Triangles) -> Triangles:
    return _halved(_quads(layer))[:, ::-1]


def _rim(layer: Triangles, up: int) -> Triangles:
    """The plate's four sides; ``up`` is what the numbers of the upper corners are larger by."""
    around = np.concatenate([layer[:-1, 0], layer[-1, :-1], layer[:0:-1, -1], layer[0, :0:-1]])
    following = np.roll(around, -1)
    return _halved(np.stack([around, following, following + up, around + up], axis=1))


def _polygon(pillar: Pillar, chord: float) -> Array:
    """(n, 2) outline of a pillar of half-width 1, anticlockwise."""
    if pillar.section == "square":
        return np.array([[1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0]])
    count = 4 * math.ceil(math.pi / math.acos(1 - chord / pillar.widest) / 4)
    angle = 2 * math.pi * np.arange(count) / count
    return np.stack([np.cos(angle), np.sin(angle)], axis=1)


def _levels(pillar: Pillar, chord: float) -> Array:
    """(n, 2) half-width and height of the outlines between which a pillar's side is drawn."""
    straight = straight_side(pillar)
    if pillar.arc is None:
        return straight
    half_step = math.acos(1 - chord / max(pillar.arc.radius, chord))
    count = math.ceil(pillar.arc.opening / (2 * half_step))
    return np.concatenate([pillar.arc.at(np.arange(count) / count), straight])


def _pillar(pillar: Pillar, chord: float) -> tuple[Array, _Side]:
    """Points of a pillar that stands at the origin, level by level and its top's centre last."""
    polygon, levels = _polygon(pillar, chord), _levels(pillar, chord)
    n = len(polygon)
    points = np.empty((len(levels), n, 3))
    points[..., :2] = levels[:, None, :1] * polygon
    points[..., 2] = levels[:, 1:]
    number = np.arange(len(levels) * n).reshape(len(levels), n)
    turned = np.roll(number, -1, axis=1)
    sides = [number[:-1], turned[:-1], turned[1:], number[1:]]
    top = np.stack([number[-1], turned[-1], np.full(n, number.size)], axis=1)
    triangles = np.concatenate([_halved(np.stack([s.ravel() for s in sides], axis=1)), top])
    return np.concatenate([points.reshape(-1, 3), [[0.0, 0.0, pillar.height]]]), _Side(triangles, n)


def _ring(polygon: Array, cell: Array, first: int, quad: Triangles) -> Triangles:
    """The plate's top between a pillar's outline (its numbers start at ``first``) and its cell's corners.

    Every edge of the outline is joined to the corner that lies farthest in the direction of its normal, so
    in front of it; along a convex outline these corners follow one another, and where they change a side
    of the cell is joined to the point between.
    """
    n = len(polygon)
    along = np.roll(polygon, -1, axis=0) - polygon
    outward = np.stack([along[:, 1], -along[:, 0]], axis=1)
    farthest = np.argmax(outward @ cell.T, axis=1)
    triangles = []
    for i in range(n):
        after = (i + 1) % n
        triangles.append((quad[farthest[i]], first + after, first + i))
        corner = int(farthest[i])
        while corner != farthest[after]:
            following = (corner + 1) % 4
            triangles.append((quad[corner], quad[following], first + after))
            corner = following
    return np.array(triangles, dtype=np.int64)
