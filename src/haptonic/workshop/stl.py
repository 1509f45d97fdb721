"""The plate's surface as a watertight triangulation in an STL file, in mm.

OpenCascade would need the extra ``cad``, and as NETGEN brings it has no writer of STL, so the surface is made
here; ezdxf cuts the plate's top around a pillar into triangles, and meshio writes the file. Every horizontal
outline of a pillar is a multiple of one polygon, so its side is a grid of levels times corners. The plate's
top is cut cell by cell and has no corners on a cell's sides: neighbours fit together.
"""

from __future__ import annotations

import math
from pathlib import Path

import meshio
import numpy as np
from ezdxf.math.triangulation import mapbox_earcut_2d

from haptonic.arrays import Array, Ints
from haptonic.cell import UnitCell
from haptonic.errors import GeometryError
from haptonic.store import refuse_overwrite, write_atomically
from haptonic.workshop.shape import MM, TRIANGLES, PillarShape, centres, corner_grid, in_mm

CHORD = 5e-6  # m, by default the largest distance between a curved surface and its triangles


def surface(cell: UnitCell, columns: int = 1, rows: int = 1, *, chord: float = CHORD) -> meshio.Mesh:
    """Closed surface of a plate as triangles, anticlockwise from outside, in m.

    Their corners lie on the true surface; its curves are off by at most ``chord`` (m).

    Raises
    ------
    GeometryError : a number of columns or rows that is not a positive integer, or a useless ``chord``
    """
    scaled = in_mm(cell, columns, rows)
    scaled.check_one_site(TRIANGLES)
    smallest = min(scaled.lattice.pitch, 2 * scaled.pillar.narrowest if scaled.pillar else math.inf)
    if not 1e-6 * smallest < chord * MM < 0.1 * smallest:
        raise GeometryError.out_of_range(
            argument="chord",
            given=f"{chord} m",
            allowed=f"between {1e-9 * smallest:.3g} m and {1e-4 * smallest:.3g} m for this cell",
            cause="the triangles would be too many, or the pillar would no longer be recognised",
            next_step="leave it out, or choose a tenth of the workshop's tolerance",
        )
    corners = corner_grid(scaled, columns, rows)
    layer = np.arange(corners[..., 0].size).reshape(columns + 1, rows + 1)
    quads = np.stack([k.ravel() for k in (layer[:-1, :-1], layer[1:, :-1], layer[1:, 1:], layer[:-1, 1:])], 1)
    around = np.concatenate([layer[:-1, 0], layer[-1, :-1], layer[:0:-1, -1], layer[0, :0:-1]])
    up = layer.size  # the numbers of the plate's upper corners are larger by this
    points = [np.insert(corners.reshape(-1, 2), 2, z, axis=1) for z in (0.0, scaled.thickness)]
    triangles = [_halved(quads)[:, ::-1], _strips(np.stack([around, around + up]))]
    if scaled.pillar is None:
        triangles.append(_halved(quads + up))
    else:
        middle = centres(scaled, columns, rows)
        standing, side, top = _pillar(
            PillarShape.of(scaled.pillar), points[1][quads[0], :2] - middle[0], chord * MM
        )
        for k, (centre, quad) in enumerate(zip(middle, quads, strict=True)):
            points.append(standing + np.append(centre, scaled.thickness))
            first = 2 * up + k * len(standing)
            triangles += [side + first, np.concatenate([quad + up, np.arange(len(standing)) + first])[top]]
    return meshio.Mesh(np.concatenate(points) / MM, [("triangle", np.concatenate(triangles))])


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
    mesh = surface(cell, columns, rows, chord=chord)
    mesh.points *= MM
    write_atomically(path, lambda temporary: mesh.write(temporary, file_format="stl", binary=True))
    return path


def _pillar(body: PillarShape, cell: Array, chord: float) -> tuple[Array, Ints, Ints]:
    """A pillar that stands at the origin, on a cell with these (4, 2) corners.

    Returns
    -------
    points : (n, 3), level by level, the top's centre last
    side : (m, 3) triangles of its side and top, as numbers of these points
    top : (m, 3) triangles of the plate's top around it; 0 to 3 are the cell's corners, the points follow
    """
    half_turn = math.acos(1 - chord / max(body.widest, body.foot))
    polygon = body.form.polygon(4 * math.ceil(math.pi / half_turn / 4))
    bend = math.acos(1 - chord / max(body.arc.radius, chord)) if body.arc else 1.0
    levels = body.flank(math.ceil(body.arc.opening / (2 * bend)) if body.arc else 0)
    rings = np.empty((len(levels), len(polygon), 3))
    rings[..., :2], rings[..., 2] = levels[:, None, :1] * polygon, levels[:, 1:]
    number = np.arange(rings[..., 0].size).reshape(rings.shape[:2])
    fan = np.stack([number[-1], np.roll(number[-1], -1), np.full(len(polygon), number.size)], axis=1)
    points = np.concatenate([rings.reshape(-1, 3), [[0.0, 0.0, body.height]]])
    border = [tuple(point) for point in np.concatenate([cell, rings[0, :, :2]]).tolist()]
    place = {point: k for k, point in enumerate(border)}
    cut = mapbox_earcut_2d(border[:4], [border[4:]])
    top = np.array([[place[corner.x, corner.y] for corner in triangle] for triangle in cut])
    return points, np.concatenate([_strips(number), fan]), top


def _strips(loops: Ints) -> Ints:
    """Triangles between one closed loop of numbers, a row, and the next above it."""
    after = np.roll(loops, -1, axis=1)
    sides = (loops[:-1], after[:-1], after[1:], loops[1:])
    return _halved(np.stack([side.ravel() for side in sides], axis=1))


def _halved(quads: Ints) -> Ints:
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
