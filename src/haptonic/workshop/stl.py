"""Surface of each material as a watertight triangulation in an STL file, in mm.

OpenCascade would need the extra ``cad``, and NETGEN's copy cannot write STL, so the surface is made here, and
meshio writes the file. Every horizontal outline of a pillar is a multiple of one polygon, so its side is a
grid of levels times corners. The plate's top is a Delaunay triangulation of all corners on it: it contains
the sides of round feet, because the circle through all corners of a foot contains no others; other sides are
halved until it contains them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

import meshio
import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import Delaunay

from haptonic.arrays import Array, Ints
from haptonic.atomic import refuse_overwrite, write_atomically
from haptonic.cell.blocks import VOID
from haptonic.cell.outlines import Outline
from haptonic.errors import GeometryError
from haptonic.materials import Material
from haptonic.workshop.part import Part
from haptonic.workshop.rings import Rings
from haptonic.workshop.shape import MM, PillarShape

CHORD = 5e-6  # m, default for the largest distance between a curved surface and its triangles
SLIGHT = 0.004  # of the narrowest part, for parts below 1.25 mm
HALVINGS = 10  # of a side at most; square feet that nearly touch need none, feet across a notch need two
ROUND = 3  # smallest number of pieces of a fillet, so that they meet at 30 degrees and look round
FLAT = 1e-13  # of the part's size squared: areas of triangles between corners on one line


def surface(part: Part, *, chord: float | None = None, material: Material | None = None) -> meshio.Mesh:
    """Closed surface of all parts of a material, by default the plate's, in m.

    Triangles run anticlockwise seen from outside. Their corners lie on the exact surface; curves deviate by
    at most ``chord`` (m), by default 5 um, and less for parts narrower than 1.25 mm.

    Raises
    ------
    GeometryError : a ``chord`` that is too small or too large
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
    edges, pieces = list(part.outline), 1  # pieces: subdivision of the sides of square feet
    for _ in range(HALVINGS):
        pillars = [
            (*_pillar(PillarShape.of(pillar), chord * MM, pieces), part.solid_of(pillar), places)
            for pillar, places in part.pillars
        ]
        stacks = [(stack, _borders(stack, chord * MM, pieces), places) for stack, places in part.stacks]
        rims = [
            stack.rim.half_width * loops[-1] + place for stack, loops, places in stacks for place in places
        ]
        feet = [body[:around, :2] + place for body, _, around, _, places in pillars for place in places]
        top, missing_above = _inside(edges, [*feet, *rims])
        bottom, missing_below = (top, missing_above) if part.cell.is_mirrored else _inside(edges, rims)
        corners = np.concatenate(edges)
        up = len(corners)
        missing = missing_below[:up] | missing_above[:up]
        at_feet = missing_above[up:].any() or missing_below[up:].any()
        if not missing.any() and not at_feet:
            break
        ends = np.cumsum([len(edge) for edge in edges])
        edges = [_with_middles(*each) for each in zip(edges, np.split(missing, ends[:-1]), strict=True)]
        pieces *= 2 if at_feet else 1
    else:
        raise AssertionError("feet or edges of the plate that cross")
    plate = part.cell.material
    skin = _Skin([np.insert(corners, 2, z, axis=1) for z in (0.0, part.cell.thickness)], 2 * up)
    for loop in _numbered(edges):
        skin.between(plate, None, _strips(np.stack([loop, loop + up])))
    lower, upper = [np.arange(up)], [np.arange(up) + up]  # indices of the corners on the plate's faces
    for sign, numbers in ((1, upper), (-1, lower))[: part.cell.copies]:
        for body, side, around, solid, places in pillars:
            under = _inside([body[:around, :2]], [])[0] if solid != plate else side[:0]
            for x, y in places:
                first = skin.add(body * [1, 1, sign] + [x, y, part.cell.thickness * (sign > 0)])
                skin.between(solid, None, side[:, ::sign] + first)
                skin.between(plate, solid, under[:, ::sign] + first)
                numbers.append(np.arange(around) + first)
    for stack, loops, places in stacks:
        floor, ceiling = (int(np.abs(stack.levels - z).argmin()) for z in (0.0, part.cell.thickness))
        for place in places:
            rim = _add_stack(skin, stack, loops, place)
            lower.append(rim[floor])
            upper.append(rim[ceiling])
    skin.between(plate, None, np.concatenate(upper)[top])
    skin.between(plate, None, np.concatenate(lower)[bottom[:, ::-1]])
    return skin.mesh(material or plate)


class _Skin:
    """Points in mm, and triangles around each material, while they are collected."""

    def __init__(self, points: list[Array], count: int) -> None:
        self.points, self.count = points, count
        self.triangles: dict[Material, list[Ints]] = {}

    def add(self, points: Array) -> int:
        """Add points, and return the index of the first."""
        self.points.append(points)
        self.count += len(points)
        return self.count - len(points)

    def between(self, inside: Material | None, outside: Material | None, triangles: Ints) -> None:
        """Add triangles anticlockwise seen from ``outside``; none if both materials are the same."""
        if inside == outside:
            return
        for solid, step in ((inside, 1), (outside, -1)):
            if solid is not None:
                self.triangles.setdefault(solid, []).append(triangles[:, ::step])

    def mesh(self, material: Material) -> meshio.Mesh:
        triangles = np.concatenate(self.triangles[material])
        used, number = np.unique(triangles, return_inverse=True)
        points = np.concatenate(self.points)[used] / MM
        return meshio.Mesh(points, [("triangle", number.reshape(triangles.shape))])


def _borders(stack: Rings, chord: float, pieces: int) -> list[Array]:
    """Borders of a stack at the origin as polygons, for a half-width of 1."""
    return [
        _polygon(outline, float(widths.max()), chord, pieces)
        for outline, widths in zip(stack.outlines, stack.widths, strict=True)
    ]


def _add_stack(skin: _Skin, stack: Rings, loops: list[Array], place: Array) -> list[Ints]:
    """Add the faces of all rings about a place; return indices of the widest border's corners by level."""
    cuts = [[width * loop for width, loop in zip(widths, loops, strict=True)] for widths in stack.widths.T]
    first = [
        skin.add(np.insert(np.concatenate(cut) + place, 2, z, axis=1))
        for cut, z in zip(cuts, stack.levels, strict=True)
    ]
    numbers = _numbered(loops)
    solids = np.array([*stack.materials, None], dtype=object)[
        np.pad(np.where(stack.grid == VOID, -1, stack.grid), ((1, 1), (0, 0)), constant_values=-1)
    ]  # of each ring, and None below and above
    for row, (low, high) in zip(solids[1:-1], pairwise(first), strict=True):
        for k, loop in enumerate(numbers):
            skin.between(row[k], row[k + 1], _strips(np.stack([loop + low, loop + high])))
    for k, loop in enumerate(numbers):
        inner = slice(max(k - 1, 0), k)
        corners = np.concatenate([loop, *numbers[inner]])
        for cut, start, below, above in zip(cuts, first, solids[:-1, k], solids[1:, k], strict=True):
            if below != above:
                ring, missing = _inside([cut[k]], cut[inner])
                assert not missing.any(), "borders that cross"
                skin.between(below, above, corners[ring] + start)
    return [numbers[-1] + start for start in first]


def write_stl(
    path: Path,
    part: Part,
    *,
    chord: float | None = None,
    material: Material | None = None,
    overwrite: bool = False,
) -> Path:
    """Write all parts of a material, by default the plate's, as a binary STL file in mm.

    Raises
    ------
    GeometryError : as `surface`
    ResourceError : the file exists and ``overwrite`` is False, or it cannot be written
    """
    refuse_overwrite(path, overwrite)
    mesh = surface(part, chord=chord, material=material)
    mesh.points *= MM
    write_atomically(path, lambda temporary: mesh.write(temporary, file_format="stl", binary=True))
    return path


def _polygon(outline: Outline, half_width: float, chord: float, pieces: int) -> Array:
    """Polygon of an outline of half-width 1, with deviations below ``chord`` at ``half_width``."""
    half_turn = math.acos(1 - chord / (outline.reach * half_width))
    return outline.polygon(4 * math.ceil(math.pi / half_turn / 4), pieces)


def _pillar(body: PillarShape, chord: float, pieces: int) -> tuple[Array, Ints, int]:
    """Make a pillar at the origin.

    Returns
    -------
    points : (n, 3), level by level from the foot, the top's centre last
    side : (m, 3) triangles of its side and top, as indices of these points
    around : number of points on each level
    """
    polygon = _polygon(body.outline, max(body.widest, body.foot), chord, pieces)
    bend = math.acos(1 - chord / max(body.arc.radius, chord)) if body.arc else 1.0
    levels = body.flank(max(ROUND, math.ceil(body.arc.opening / (2 * bend))) if body.arc else 0)
    rings = np.empty((len(levels), len(polygon), 3))
    rings[..., :2], rings[..., 2] = levels[:, None, :1] * polygon, levels[:, 1:]
    number = np.arange(rings[..., 0].size).reshape(rings.shape[:2])
    fan = np.stack([number[-1], np.roll(number[-1], -1), np.full(len(polygon), number.size)], axis=1)
    points = np.concatenate([rings.reshape(-1, 3), [[0.0, 0.0, body.height]]])
    return points, np.concatenate([_strips(number), fan]), len(polygon)


def _inside(edges: Sequence[Array], feet: Sequence[Array]) -> tuple[Ints, NDArray[np.bool_]]:
    """Triangulate the inside of closed loops of (n, 2) corners: ``edges`` to their left, ``feet`` right.

    Returns
    -------
    (m, 3) triangles, anticlockwise, as indices of the corners; and for all sides, loop by loop, True if a
    side is not an edge of a triangle: then the triangulation is invalid
    """
    every = _numbered([*edges, *feet])
    inner = [*every[: len(edges)], *(loop[::-1] for loop in every[len(edges) :])]
    corners = np.concatenate([*edges, *feet])
    sides = np.concatenate([np.stack([loop, np.roll(loop, -1)]) for loop in inner], axis=1)
    mesh = Delaunay(corners)
    first, second = (np.roll(mesh.simplices, -k, axis=1).astype(np.int64) for k in (1, 2))
    count = len(corners)
    crossed = np.stack([first * count + second, second * count + first])  # each edge of a triangle, both ways
    wanted = sides[0] * count + sides[1]
    at_side = np.isin(crossed[0], wanted)
    missing = ~np.isin(wanted, crossed[0])
    free = ~(at_side | np.isin(crossed[1], wanted)) & (mesh.neighbors >= 0)
    owner = np.broadcast_to(np.arange(len(first))[:, None], free.shape)
    joined = coo_array((np.ones(free.sum()), (owner[free], mesh.neighbors[free])), shape=(len(first),) * 2)
    region = connected_components(joined, directed=False)[1]
    a, b, c = np.moveaxis(corners[mesh.simplices], 1, 0)
    area = np.abs((b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0]))
    inside = np.isin(region, region[at_side.any(axis=1)]) & (area > FLAT * np.ptp(corners) ** 2)
    return mesh.simplices[inside], missing


def _with_middles(loop: Array, halved: NDArray[np.bool_]) -> Array:
    """A closed loop with an additional corner in the middle of some sides."""
    middles = 0.5 * (loop + np.roll(loop, -1, axis=0))
    return np.insert(loop, np.flatnonzero(halved) + 1, middles[halved], axis=0)


def _numbered(loops: Sequence[Array]) -> list[Ints]:
    """Indices of the corners of loops, one loop after the other."""
    ends = np.cumsum([len(loop) for loop in loops])
    return np.split(np.arange(ends[-1]), ends[:-1])


def _strips(loops: Ints) -> Ints:
    """Triangles between one closed loop of indices, a row, and the next above it."""
    after = np.roll(loops, -1, axis=1)
    sides = (loops[:-1], after[:-1], after[1:], loops[1:])
    quads = np.stack([side.ravel() for side in sides], axis=1)
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
