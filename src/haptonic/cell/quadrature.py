"""Gauss-Lobatto-Legendre points, which are both nodes and quadrature points of the spectral elements."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.polynomial import legendre

from haptonic.arrays import Array


@cache
def lobatto(order: int) -> tuple[Array, Array, Array]:
    """Points and weights on [-1, 1], and the matrix of derivatives at the points.

    Returns
    -------
    points : (order + 1,) ascending, ends included
    weights : (order + 1,) exact for polynomials up to degree 2 order - 1
    derivative : (order + 1, order + 1), ``derivative[q, i]`` = slope of Lagrange polynomial i at point q
    """
    top = np.zeros(order + 1)
    top[order] = 1.0
    slope = legendre.legder(top)
    inner = np.sort(np.real(legendre.legroots(slope))) if order > 1 else np.empty(0)
    for _ in range(2):  # refine the roots, because the companion matrix loses digits at high order
        inner = inner - legendre.legval(inner, slope) / legendre.legval(inner, legendre.legder(slope))
    points = np.concatenate([[-1.0], inner, [1.0]])
    points = 0.5 * (points - points[::-1])
    at_points = legendre.legval(points, top)
    weights = 2.0 / (order * (order + 1) * at_points**2)
    distance = points[:, None] - points[None, :]
    np.fill_diagonal(distance, 1.0)
    derivative = at_points[:, None] / (at_points[None, :] * distance)
    np.fill_diagonal(derivative, 0.0)
    np.fill_diagonal(derivative, -derivative.sum(axis=1))
    for array in (points, weights, derivative):
        array.setflags(write=False)
    return points, weights, derivative


def interpolation(points: Array, targets: Array) -> Array:
    """(targets, points) Lagrange polynomials on ``points``, evaluated at ``targets`` (barycentric form)."""
    apart = points[:, None] - points[None, :]
    np.fill_diagonal(apart, 1.0)
    weights = 1.0 / np.prod(apart, axis=1)
    distance = targets[:, None] - points[None, :]
    hit = np.abs(distance) < 1e-12 * np.ptp(points)
    terms = weights / np.where(hit, 1.0, distance)
    terms[hit.any(axis=1)] = 0.0
    terms[hit] = 1.0
    return np.asarray(terms / terms.sum(axis=1, keepdims=True))
