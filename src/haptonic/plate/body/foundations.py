"""Supports of a plate: unknowns at rest, and elastic foundations on its outer side faces."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from haptonic.arrays import Array, Ints
from haptonic.later import sparse as sp
from haptonic.plate.body.skeleton import OuterEdge, Skeleton, TraceOrders, edge_fields
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.outline import held
from haptonic.plate.layout.supports import Support

WHOLE = 1e-9  # of an edge's length, tolerance of a support on the whole edge
CLAMPED = 100.0  # stiffness of a clamp on a part of an edge, relative to a layer as thick as the plate


@dataclass(frozen=True, eq=False)
class Foundation:
    """Springs of a support. stiffness : sparse, N/m; loss_factor : of the springs; number : of the support"""

    stiffness: sp.csr_array
    loss_factor: float
    number: int

    def on(self, kept: NDArray[np.bool_]) -> Foundation:
        """Restrict the foundation to some of the unknowns."""
        inside = np.flatnonzero(kept)
        return Foundation(sp.csr_array(self.stiffness[inside][:, inside]), self.loss_factor, self.number)


def supported(skeleton: Skeleton, supports: Sequence[Support]) -> tuple[Ints, list[Foundation]]:
    """Unknowns of the skeleton at rest, and foundations on all of its unknowns.

    A support of a whole edge of a tile sets its unknowns to rest. A clamp on a part of an edge is replaced by
    springs much stiffer than the plate, because the polynomials along the edge cannot resolve its end.
    """
    at_rest: list[Ints] = []
    foundations = []
    for number, support in enumerate(supports):
        springs = []
        for edge, span in _spans(skeleton, support):
            if support.hold == "spring" or span != (0.0, 1.0):
                springs.append((edge, span))
            elif support.hold == "simple":
                normal = 0 if edge.side in ("left", "right") else 1
                at_rest.append(edge.unknowns[skeleton.orders.components != normal])
            else:
                at_rest.append(edge.unknowns)
        if springs:
            stiffness = foundation_stiffness(skeleton.layout, support)
            form = _foundation(skeleton, springs, stiffness)
            foundations.append(Foundation(form, support.loss_factor, number))
    return np.unique(np.concatenate([np.zeros(0, dtype=np.int64), *at_rest])), foundations


def total_stiffness(foundations: Iterable[Foundation], size: int) -> sp.csr_array:
    """(size, size) sparse stiffness of all foundations together, N/m."""
    return sp.csr_array(sum((springs.stiffness for springs in foundations), start=sp.csr_array((size, size))))


def foundation_stiffness(layout: Layout, support: Support) -> float:
    """Stiffness of the springs of a support, N/m^3."""
    if support.stiffness is not None:
        return support.stiffness
    return CLAMPED * float(layout.material.stiffness[0, 0]) / layout.thickness


def _spans(skeleton: Skeleton, support: Support) -> list[tuple[OuterEdge, tuple[float, float]]]:
    """Edges of tiles with a support, and the supported range as shares of their length."""
    spans = []
    for side, ends in held(skeleton.layout, support):
        axis = 0 if side in ("bottom", "top") else 1
        for edge in skeleton.outer_edges:
            if edge.side != side or edge.start[1 - axis] != ends[0, 1 - axis]:
                continue
            share = np.sort(ends[:, axis] - edge.start[axis]) / edge.length
            near = np.round(share)
            share = np.clip(np.where(np.abs(share - near) < WHOLE, near, share), 0.0, 1.0)
            if share[1] - share[0] > WHOLE:
                spans.append((edge, (float(share[0]), float(share[1]))))
    return spans


def _foundation(
    skeleton: Skeleton, spans: Sequence[tuple[OuterEdge, tuple[float, float]]], stiffness: float
) -> sp.csr_array:
    """Springs on parts of edges, over the whole thickness and equal in all directions."""
    rows, columns, values = [], [], []
    for edge, (low, high) in spans:
        area = edge.length * skeleton.layout.thickness
        form = stiffness * area * _products(skeleton.orders, low, high)
        rows.append(np.repeat(edge.unknowns, len(form)))
        columns.append(np.tile(edge.unknowns, len(form)))
        values.append(form.ravel())
    entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
    return sp.csr_array(entries, shape=(skeleton.size,) * 2)


def _products(orders: TraceOrders, low: float, high: float) -> Array:
    """(unknowns of an edge, same) means of products of displacements over a part of an edge's length, times
    that part.
    """
    points, weights = leggauss(orders.along + 1)
    up, up_weights = leggauss(orders.through + 2)
    share = low + (high - low) * 0.5 * (1 + points)
    at = np.meshgrid(share, 0.5 * (1 + up), indexing="ij")
    fields = edge_fields(orders, *(shares.ravel() for shares in at))
    area = np.repeat(0.25 * (high - low) * np.outer(weights, up_weights).ravel(), 3)
    return np.asarray(fields.T @ (area[:, None] * fields))
