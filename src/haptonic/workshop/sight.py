"""Edges of a surface as somebody sees them from a direction: the isometric view of a drawing."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Ints

SHARP = math.cos(math.radians(35))  # facets of a round body meet at less, those of a small fillet too
PIECES = 24  # stretches of an edge that are seen, or hidden, as a whole
IN_FRONT = 1e-3  # of the body's size: what hides a point is nearer by at least this


def seen_edges(points: Array, triangles: Ints, towards: tuple[float, float, float]) -> list[Array]:
    """Sharp edges and outlines of a closed surface, without what lies behind it.

    Parameters
    ----------
    towards : direction from the body to the eye, which is not the vertical one

    Returns
    -------
    (2, 2) stretches: their ends to the right and up, in the unit of the points
    """
    eye = np.array(towards) / np.linalg.norm(towards)
    right = np.cross([0.0, 0.0, 1.0], eye) / np.linalg.norm(np.cross([0.0, 0.0, 1.0], eye))
    points = points @ np.stack([right, np.cross(eye, right), eye], axis=1)  # right, up, nearer
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    edges = _edges(triangles)
    front, (one, other) = normals[:, 2] > 1e-9, edges[:, 2:].T
    bent = np.einsum("ij,ij->i", normals[one], normals[other]) < SHARP
    edges = edges[(front[one] | front[other]) & (bent | (front[one] != front[other]))]
    shares = np.arange(PIECES + 1) / PIECES
    start, end = points[edges[:, 0], None], points[edges[:, 1], None]
    ends = start + shares[:, None] * (end - start)  # (edges, PIECES + 1, 3)
    middles = 0.5 * (ends[:, :-1] + ends[:, 1:])
    seen = ~_hidden(middles.reshape(-1, 3), corners[front], IN_FRONT * np.ptp(points))
    found = []
    for line, pieces in zip(ends[..., :2], seen.reshape(-1, PIECES), strict=True):
        changes = np.flatnonzero(np.diff(np.concatenate([[False], pieces, [False]])))
        found += [line[[first, last]] for first, last in changes.reshape(-1, 2)]
    return found


def _edges(triangles: Ints) -> Ints:
    """(n, 4) edges of a closed surface: two points, and the triangles on both sides."""
    sides = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    owner = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort(np.sort(sides, axis=1).T)
    pairs = order.reshape(-1, 2)
    return np.concatenate([sides[pairs[:, 0]], owner[pairs]], axis=1)


def _hidden(points: Array, triangles: Array, margin: float) -> NDArray[np.bool_]:
    """Whether some triangle, which turns to the eye, lies before a point by more than ``margin``."""
    order = np.argsort(points[:, 0])
    points, hidden = points[order], np.zeros(len(points), dtype=bool)
    first = np.searchsorted(points[:, 0], triangles[..., 0].min(axis=1) - margin)
    last = np.searchsorted(points[:, 0], triangles[..., 0].max(axis=1) + margin)
    bottom, top = triangles[..., 1].min(axis=1) - margin, triangles[..., 1].max(axis=1) + margin
    for k, (a, b, c) in enumerate(triangles):
        near = points[first[k] : last[k]]
        beside = np.flatnonzero(
            ~hidden[first[k] : last[k]] & (near[:, 1] > bottom[k]) & (near[:, 1] < top[k])
        )
        u, v, away = b - a, c - a, near[beside] - a
        area = u[0] * v[1] - u[1] * v[0]
        along = (away[:, 0] * v[1] - away[:, 1] * v[0]) / area
        across = (u[0] * away[:, 1] - u[1] * away[:, 0]) / area
        inside = (along > -1e-9) & (across > -1e-9) & (along + across < 1 + 1e-9)
        hidden[first[k] + beside[inside & (along * u[2] + across * v[2] - away[:, 2] > margin)]] = True
    return hidden[np.argsort(order)]
