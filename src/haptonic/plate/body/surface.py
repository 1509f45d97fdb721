"""Values of a field at arbitrary points of the flat face, z = 0, of a meshed tile."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell import HexMesh
from haptonic.cell.quadrature import interpolation, lobatto
from haptonic.errors import GeometryError
from haptonic.later import sparse as sp

FLAT = 1e-9  # of the tile's extent, within which a node lies at z = 0
# Tolerance in local coordinates from -1 to 1 of a point in an element: sizes of tiles are exact to a
# billionth of the thickness, positions to 1e-12 m, and an element may be a hundredth of a tile wide.
OUTSIDE = 1e-6
BULGE = 0.2  # of an element's size, by which its curved sides may leave the box around its nodes
STEPS = 40  # of Newton's method at most; a dozen are usually enough
LONGEST = 0.5  # of a step, in local coordinates
FARTHEST = 1.02  # largest local coordinate of a search: farther out, maps may fold


def flat_faces(mesh: HexMesh) -> list[Ints]:
    """Node numbers (k, n1, n2) of the elements' faces that tile the face z = 0, grouped by their orders."""
    height = np.abs(mesh.points[:, 2])
    at_zero = height <= FLAT * np.ptp(mesh.points, axis=0).max()
    faces = (family.nodes[..., 0] for family in mesh.topology.families)
    flat = (nodes[at_zero[nodes].all(axis=(1, 2))] for nodes in faces)
    return [nodes for nodes in flat if len(nodes)]


def surface_weights(points: Array, faces: Sequence[Ints], where: Array, steps: int = STEPS) -> sp.csr_array:
    """Matrix from nodal values to values at points of the flat face.

    The curved quadrilateral of each point is found by Newton's method on the isoparametric maps; on a common
    border of two, both have the same value.

    Parameters
    ----------
    points : (n, 3) of all nodes, m
    faces : (k, n1, n2) node numbers of quadrilaterals on Gauss-Lobatto-Legendre points, from `flat_faces`
    where : (m, 2) x and y, m, in the frame of the nodes
    steps : of Newton's method at most

    Returns
    -------
    (m, n) sparse; each row has the nodes of one face and sums to 1

    Raises
    ------
    GeometryError : a point lies on none of the faces
    """
    pairs = [_candidates(points[face][..., :2], where) for face in faces]
    group = np.repeat(np.arange(len(faces)), [len(point) for point, _ in pairs])
    point, element = (np.concatenate(some) for some in zip(*pairs, strict=True))
    local = np.concatenate([
        _local_coordinates(points[face][..., :2], element, where[point], steps)
        for face, (point, element) in zip(faces, pairs, strict=True)
    ])  # fmt: skip
    beyond = np.abs(local).max(axis=1)
    inside = np.flatnonzero(beyond <= 1 + OUTSIDE)
    inside = inside[np.lexsort([beyond[inside], point[inside]])]
    located, first = np.unique(point[inside], return_index=True)
    _refuse_missed(located, where)
    chosen = inside[first]  # one pair for each point
    rows, columns, weights = [], [], []
    for number, face in enumerate(faces):
        of_face = np.flatnonzero(group[chosen] == number)
        pair = chosen[of_face]
        (shapes, _), (other_shapes, _) = _shape_functions(face.shape[1:], local[pair])
        weight = (shapes[:, :, None] * other_shapes[:, None, :]).reshape(len(pair), face[0].size)
        rows.append(np.repeat(of_face, weight.shape[1]))
        columns.append(face[element[pair]].ravel())
        weights.append(weight.ravel())
    entries = np.concatenate(weights), (np.concatenate(rows), np.concatenate(columns))
    matrix = sp.csr_array(entries, shape=(len(where), len(points)))
    matrix.eliminate_zeros()
    return matrix


def _candidates(corners: Array, where: Array) -> tuple[Ints, Ints]:
    """Numbers of points and elements, in pairs: the box around an element's nodes (k, n1, n2, 2), slightly
    enlarged, contains the point.
    """
    low, high = corners.min(axis=(1, 2)), corners.max(axis=(1, 2))
    margin = BULGE * (high - low).max(axis=1, keepdims=True)
    near = np.ones((len(where), len(corners)), dtype=bool)
    for axis in range(2):
        place = where[:, axis, None]
        near &= (place >= (low - margin)[:, axis]) & (place <= (high + margin)[:, axis])
    point, element = np.nonzero(near)
    return point, element


def _local_coordinates(corners: Array, element: Ints, target: Array, steps: int) -> Array:
    """(pairs, 2) local coordinates of targets (pairs, 2) in elements; infinite where the search failed."""
    nodes = corners[element]
    orders = nodes.shape[1:3]
    distance = ((nodes - target[:, None, None]) ** 2).sum(axis=-1).reshape(len(nodes), orders[0] * orders[1])
    start = np.unravel_index(distance.argmin(axis=1), orders)
    local = np.stack([lobatto(n - 1)[0][k] for n, k in zip(orders, start, strict=True)], axis=-1)
    size = np.sqrt(distance.max(axis=1))
    todo = np.arange(len(nodes))
    missed = np.full(len(nodes), np.inf)
    for _ in range(steps):
        if not len(todo):
            break
        (first, slope1), (second, slope2) = _shape_functions(orders, local[todo])
        here = nodes[todo]
        along = [
            np.einsum("mi,mj,mijc->mc", a, b, here)
            for a, b in ((first, second), (slope1, second), (first, slope2))
        ]
        rest = target[todo] - along[0]
        error = np.abs(rest).max(axis=1) / size[todo]
        better = error < missed[todo]  # stop at rounding, where the error does not decrease
        missed[todo] = np.minimum(missed[todo], error)
        step = _solved(along[1], along[2], rest)
        longest = np.abs(step).max(axis=1, keepdims=True)
        step *= np.minimum(1.0, LONGEST / np.maximum(longest, LONGEST))
        going = better | (error > FLAT)
        local[todo[going]] += _held_back(local[todo], step, (along[1], along[2]), rest)[going]
        todo = todo[going]
    local[missed > FLAT] = np.inf
    return local


def _held_back(local: Array, step: Array, slopes: tuple[Array, Array], rest: Array) -> Array:
    """(m, 2) steps that end within `FARTHEST`; if one coordinate is limited, the other is optimised.

    Without this, the search takes dozens of steps in a thin curved ring.
    """
    room = np.clip(local + step, -FARTHEST, FARTHEST) - local
    held = np.abs(local + step) > FARTHEST
    for own, other in ((0, 1), (1, 0)):
        left = rest - room[:, own, None] * slopes[own]
        nearest = (left * slopes[other]).sum(axis=1) / (slopes[other] ** 2).sum(axis=1)
        alone = held[:, own] & ~held[:, other]
        reach = np.clip(nearest, -LONGEST, LONGEST)
        room[alone, other] = (np.clip(local[:, other] + reach, -FARTHEST, FARTHEST) - local[:, other])[alone]
    return np.asarray(room)


def _shape_functions(orders: tuple[int, ...], local: Array) -> list[tuple[Array, Array]]:
    """Values and slopes (pairs, n) of the Lagrange polynomials along either axis at local coordinates."""
    functions = []
    for n, place in zip(orders, local.T, strict=True):
        nodes, _, derivative = lobatto(n - 1)
        values = interpolation(nodes, place)
        functions.append((values, values @ derivative))
    return functions


def _solved(first: Array, second: Array, right: Array) -> Array:
    """Solutions (m, 2) of systems with the columns ``first`` and ``second`` (m, 2)."""
    determinant = _cross(first, second)
    least = 1e-3 * np.linalg.norm(first, axis=1) * np.linalg.norm(second, axis=1)
    determinant = np.where(np.abs(determinant) < least, least, determinant)
    return np.stack([_cross(right, second), _cross(first, right)], axis=-1) / determinant[:, None]


def _cross(a: Array, b: Array) -> Array:
    return np.asarray(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0])


def _refuse_missed(located: Ints, where: Array) -> None:
    """Raise GeometryError unless all points of ``where`` are among the located ones, given by number."""
    missed = np.setdiff1d(np.arange(len(where)), located)
    if len(missed):
        x, y = where[missed[0]] * 1e3
        raise GeometryError.out_of_range(
            argument="points of the flat face",
            given=f"{len(missed)} of {len(where)} beside it, the first at x = {x:.6g} mm, y = {y:.6g} mm",
            allowed="points on the tile, its border included",
            cause="positions are relative to another corner, or in mm",
            next_step="give positions in m, in the frame of the tile",
        )
