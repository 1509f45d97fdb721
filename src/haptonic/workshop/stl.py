"""The plate's surface as a watertight triangulation in an STL file, in mm.

OpenCascade would need the extra ``cad``, and as NETGEN brings it has no writer of STL, so the surface is made
here, and meshio writes the file. Every horizontal outline of a pillar is a multiple of one polygon, so its
side is a grid of levels times corners. The plate's top is a Delaunay triangulation of all corners on it: the
sides of round feet are among its edges, since the circle through all corners of a foot holds no others; other
sides are halved until they are.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import meshio
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import Delaunay

from haptonic.arrays import Array, Ints
from haptonic.errors import GeometryError
from haptonic.store import refuse_overwrite, write_atomically
from haptonic.workshop.part import Part
from haptonic.workshop.shape import MM, PillarShape

CHORD = 5e-6  # m, by default the largest distance between a curved surface and its triangles
SLIGHT = 0.004  # of the narrowest part, for parts below 1.25 mm
HALVINGS = 10  # of a side; lattices whose square feet nearly touch need none, feet across a notch two
ROUND = 3  # pieces of a fillet at least, so that they meet at 30 degrees and look round
FLAT = 1e-13  # of the part's size squared: areas of triangles between corners on one line


def surface(part: Part, *, chord: float | None = None) -> meshio.Mesh:
    """Closed surface of a part as triangles, anticlockwise from outside, in m.

    Their corners lie on the true surface; its curves are off by at most ``chord`` (m), by default 5 um, and
    less for parts narrower than 1.25 mm.

    Raises
    ------
    GeometryError : a useless ``chord``
    """
    chord = min(CHORD, SLIGHT * part.narrowest / MM) if chord is None else chord
    if not 1e-6 * part.narrowest < chord * MM < 0.1 * part.narrowest:
        raise GeometryError.out_of_range(
            argument="chord",
            given=f"{chord} m",
            allowed=f"between {1e-9 * part.narrowest:.3g} m and {1e-4 * part.narrowest:.3g} m for this cell",
            cause="the triangles would be too many, or the pillar would no longer be recognised",
            next_step="leave it out, or choose a tenth of the workshop's tolerance",
        )
    edges, pieces = list(part.outline), 1  # how finely the sides of the plate and of square feet are cut
    for _ in range(HALVINGS):
        pillars = [
            (*_pillar(PillarShape.of(pillar), chord * MM, pieces), places) for pillar, places in part.standing
        ]
        feet = [body[:around, :2] + place for body, _, around, places in pillars for place in places]
        bottom, missing_below = _inside(edges, [])
        top, missing_above = _inside(edges, feet)
        missing = missing_below | missing_above[: len(missing_below)]
        if not missing.any() and not missing_above.any():
            break
        ends = np.cumsum([len(edge) for edge in edges])
        edges = [_with_middles(*each) for each in zip(edges, np.split(missing, ends[:-1]), strict=True)]
        pieces *= 2 if missing_above[len(missing) :].any() else 1
    else:
        raise AssertionError("feet or edges of the plate that cross")
    corners = np.concatenate(edges)
    up, loops = len(corners), _numbered(edges)  # the numbers of the upper corners are larger by their number
    points = [np.insert(corners, 2, z, axis=1) for z in (0.0, part.cell.thickness)]
    triangles, first = [_strips(np.stack([loop, loop + up])) for loop in loops], 2 * up
    below = (top, pillars) if part.cell.is_mirrored else (bottom, [])
    for way, (face, standing) in ((1, (top, pillars)), (-1, below)):
        numbers, height = [np.arange(up) + up * (way > 0)], part.cell.thickness * (way > 0)
        for body, side, around, places in standing:
            for x, y in places:
                points.append(body * [1, 1, way] + [x, y, height])
                triangles.append(side[:, ::way] + first)
                numbers.append(np.arange(around) + first)
                first += len(body)
        triangles.append(np.concatenate(numbers)[face[:, ::way]])
    return meshio.Mesh(np.concatenate(points) / MM, [("triangle", np.concatenate(triangles))])


def write_stl(path: Path, part: Part, *, chord: float | None = None, overwrite: bool = False) -> Path:
    """Write a part as a binary STL file in mm.

    Raises
    ------
    GeometryError : as `surface`
    ResourceError : the file exists and ``overwrite`` is False, or it cannot be written
    """
    refuse_overwrite(path, overwrite)
    mesh = surface(part, chord=chord)
    mesh.points *= MM
    write_atomically(path, lambda temporary: mesh.write(temporary, file_format="stl", binary=True))
    return path


def _pillar(body: PillarShape, chord: float, pieces: int) -> tuple[Array, Ints, int]:
    """A pillar that stands at the origin.

    Returns
    -------
    points : (n, 3), level by level from the foot, the top's centre last
    side : (m, 3) triangles of its side and top, as numbers of these points
    around : how many points each level has
    """
    half_turn = math.acos(1 - chord / (body.outline.reach * max(body.widest, body.foot)))
    polygon = body.outline.polygon(4 * math.ceil(math.pi / half_turn / 4), pieces)
    bend = math.acos(1 - chord / max(body.arc.radius, chord)) if body.arc else 1.0
    levels = body.flank(max(ROUND, math.ceil(body.arc.opening / (2 * bend))) if body.arc else 0)
    rings = np.empty((len(levels), len(polygon), 3))
    rings[..., :2], rings[..., 2] = levels[:, None, :1] * polygon, levels[:, 1:]
    number = np.arange(rings[..., 0].size).reshape(rings.shape[:2])
    fan = np.stack([number[-1], np.roll(number[-1], -1), np.full(len(polygon), number.size)], axis=1)
    points = np.concatenate([rings.reshape(-1, 3), [[0.0, 0.0, body.height]]])
    return points, np.concatenate([_strips(number), fan]), len(polygon)


def _inside(edges: Sequence[Array], feet: Sequence[Array]) -> tuple[Ints, NDArray[np.bool_]]:
    """What closed loops of (n, 2) corners enclose: ``edges`` to their left, ``feet`` to their right.

    Returns
    -------
    (m, 3) triangles, anticlockwise, as numbers of the corners; and which sides, loop by loop, are no edges of
    triangles: if there are some, there is no answer
    """
    every = _numbered([*edges, *feet])
    inner = [*every[: len(edges)], *(loop[::-1] for loop in every[len(edges) :])]
    corners = np.concatenate([*edges, *feet])
    sides = np.concatenate([np.stack([loop, np.roll(loop, -1)]) for loop in inner], axis=1)
    mesh = Delaunay(corners)
    one, other = (np.roll(mesh.simplices, -k, axis=1).astype(np.int64) for k in (1, 2))
    count = len(corners)
    crossed = np.stack([one * count + other, other * count + one])  # each edge of a triangle, both ways
    wanted = sides[0] * count + sides[1]
    at_side = np.isin(crossed[0], wanted)
    missing = ~np.isin(wanted, crossed[0])
    free = ~(at_side | np.isin(crossed[1], wanted)) & (mesh.neighbors >= 0)
    owner = np.broadcast_to(np.arange(len(one))[:, None], free.shape)
    joined = coo_array((np.ones(free.sum()), (owner[free], mesh.neighbors[free])), shape=(len(one),) * 2)
    region = connected_components(joined, directed=False)[1]
    a, b, c = np.moveaxis(corners[mesh.simplices], 1, 0)
    area = np.abs((b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0]))
    inside = np.isin(region, region[at_side.any(axis=1)]) & (area > FLAT * np.ptp(corners) ** 2)
    return mesh.simplices[inside], missing


def _with_middles(loop: Array, halved: NDArray[np.bool_]) -> Array:
    """A closed loop with a corner more in the middle of some sides."""
    middles = 0.5 * (loop + np.roll(loop, -1, axis=0))
    return np.insert(loop, np.flatnonzero(halved) + 1, middles[halved], axis=0)


def _numbered(loops: Sequence[Array]) -> list[Ints]:
    """Numbers of the corners of loops, one loop after the other."""
    ends = np.cumsum([len(loop) for loop in loops])
    return np.split(np.arange(ends[-1]), ends[:-1])


def _strips(loops: Ints) -> Ints:
    """Triangles between one closed loop of numbers, a row, and the next above it."""
    after = np.roll(loops, -1, axis=1)
    sides = (loops[:-1], after[:-1], after[1:], loops[1:])
    return _halved(np.stack([side.ravel() for side in sides], axis=1))


def _halved(quads: Ints) -> Ints:
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
