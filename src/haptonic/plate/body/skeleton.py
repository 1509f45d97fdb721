"""Unknowns on the lines between tiles, which couple the tiles: polynomials along each edge and
through the thickness, given by their values on Gauss-Lobatto-Legendre points.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial.legendre import legder, legval

from haptonic.arrays import Array, Ints
from haptonic.cell.quadrature import interpolation, lobatto
from haptonic.plate.layout.grid import Block, Layout, Side


@dataclass(frozen=True)
class TraceOrders:
    """Polynomial orders of the unknowns between tiles: along an edge of a tile, and through the thickness.

    shear : along an edge, of a further profile of the motion in the plane, one order higher through the
        thickness, for transverse shear. It varies less along the edge. 0 for none
    """

    along: int
    through: int
    shear: int = 0

    @property
    def levels(self) -> int:
        return self.through + 1

    @property
    def per_node(self) -> int:
        """Unknowns at each place seen from above, ordered (level, component)."""
        return 3 * self.levels

    def unknowns(self, places: Ints) -> Ints:
        """Numbers of the unknowns at some places, ordered (place, level, component)."""
        return np.asarray(places[:, None] * self.per_node + np.arange(self.per_node)).ravel()

    def profile(self, height: Array) -> Array:
        """Further profile at shares of the thickness: 0 on all levels, of the next order between them."""
        place, slope = 2 * height - 1, legder(np.eye(self.through + 1)[-1])
        return np.asarray((1 - place**2) * legval(place, slope))

    @property
    def components(self) -> Ints:
        """Components of the unknowns of one edge, ordered as in `OuterEdge`."""
        main = np.tile(np.arange(3), self.levels * (self.along + 1))
        return np.concatenate([main, np.tile([0, 1], self.shear + 1 if self.shear else 0)])


@dataclass(frozen=True)
class OuterEdge:
    """Edge of a tile at the border of the plate.

    nodes : (order + 1,) from its start, left or low, to its end
    unknowns : of the skeleton, ordered (place, level, component), then those of the further profile
        (place, component)
    start, end : m; side : its direction
    """

    nodes: Ints
    unknowns: Ints
    start: tuple[float, float]
    end: tuple[float, float]
    side: Side

    @property
    def length(self) -> float:
        """m"""
        return float(np.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1]))


@dataclass(frozen=True, eq=False)
class Skeleton:
    """Numbers of the places on the lines between blocks, as seen from above.

    layout, orders : of the skeleton; blocks : that cover every tile once
    rims : for each block the places on its rim, anticlockwise from its lower left corner
    traces : for each block its unknowns, ordered (place, level, component), then those of the further
        profile (place, component)
    points : (places, 2), m
    size : number of unknowns, supports not considered
    """

    layout: Layout
    orders: TraceOrders
    blocks: tuple[Block, ...]
    rims: tuple[Ints, ...]
    traces: tuple[Ints, ...]
    points: Array
    size: int

    @classmethod
    def of(cls, layout: Layout, blocks: Sequence[Block], orders: TraceOrders) -> Skeleton:
        x, y = np.array(layout.x), np.array(layout.y)
        rims, points = numbered(x, y, blocks, orders.along)
        traces, size = traced(x, y, blocks, orders)
        return cls(
            layout=layout,
            orders=orders,
            blocks=tuple(blocks),
            rims=rims,
            traces=traces,
            points=points,
            size=size,
        )

    def unknowns(self, places: Ints) -> Ints:
        """Numbers of unknowns at places, ordered (place, level, component), without the further profile."""
        return self.orders.unknowns(places)

    def alone(self, needed: Ints, kept: Sequence[Block]) -> list[Ints]:
        """For each block, unknowns of its trace that belong to no other block and are not ``needed``.

        The list of ``kept`` blocks is empty.
        """
        shared = np.bincount(np.concatenate(self.traces), minlength=self.size) > 1
        shared[needed] = True
        return [
            np.zeros(0, dtype=np.int64) if block in kept else np.flatnonzero(~shared[trace])
            for block, trace in zip(self.blocks, self.traces, strict=True)
        ]

    @cached_property
    def outer_edges(self) -> tuple[OuterEdge, ...]:
        """All edges with plate on one side only."""
        layout, orders = self.layout, self.orders
        along, shear = orders.along, orders.shear
        edges = []
        for block, rim, trace in zip(self.blocks, self.rims, self.traces, strict=True):
            further = trace[len(rim) * orders.per_node :].reshape(-1, 2)
            for k, (i, j, side) in enumerate(_around(block)):
                di, dj = {"bottom": (-1, 0), "right": (0, 1), "top": (1, 0), "left": (0, -1)}[side]
                i, j = i + di, j + dj
                if 0 <= i < layout.rows and 0 <= j < layout.columns and layout.tiles[i][j] is not None:
                    continue  # plate on either side
                nodes = rim[(k * along + np.arange(along + 1)) % len(rim)]
                profile = further[(k * shear + np.arange(shear + 1)) % len(further)] if shear else further
                if side in ("top", "left"):
                    nodes, profile = nodes[::-1], profile[::-1]
                (x0, y0), (x1, y1) = self.points[nodes[0]], self.points[nodes[-1]]
                unknowns = np.concatenate([self.unknowns(nodes), profile.ravel()])
                ends = (float(x0), float(y0)), (float(x1), float(y1))
                edges.append(OuterEdge(nodes, unknowns, *ends, side))
        return tuple(edges)


def _around(block: Block) -> list[tuple[int, int, Side]]:
    """(row, column, side) of the edges on a block's rim, anticlockwise from its lower left corner."""
    (r0, r1), (c0, c1) = block.rows, block.columns
    return [
        *((r0, j, "bottom") for j in range(c0, c1)),
        *((i, c1 - 1, "right") for i in range(r0, r1)),
        *((r1 - 1, j, "top") for j in reversed(range(c0, c1))),
        *((i, c0, "left") for i in reversed(range(r0, r1))),
    ]  # fmt: skip


def numbered(x: Array, y: Array, blocks: Sequence[Block], order: int) -> tuple[tuple[Ints, ...], Array]:
    """Places on the rims of blocks between lines, numbered without gaps, and the (places, 2) points, m."""
    grid = _GridNumbers(x, y, order)
    rims = [grid.rim(block) for block in blocks]
    used, number = np.unique(np.concatenate(rims), return_inverse=True)
    ends = np.cumsum([len(rim) for rim in rims])
    return tuple(np.split(number, ends[:-1])), grid.points[used]


def traced(x: Array, y: Array, blocks: Sequence[Block], orders: TraceOrders) -> tuple[tuple[Ints, ...], int]:
    """For each block between lines, numbers of its trace's unknowns, ordered as in `Skeleton`.

    Also the number of all unknowns.
    """
    rims, points = numbered(x, y, blocks, orders.along)
    size = len(points) * orders.per_node
    traces = [orders.unknowns(rim) for rim in rims]
    if not orders.shear:
        return tuple(traces), size
    rims, points = numbered(x, y, blocks, orders.shear)
    further = [(size + 2 * rim[:, None] + np.arange(2)).ravel() for rim in rims]
    joined = tuple(np.concatenate(pair) for pair in zip(traces, further, strict=True))
    return joined, size + 2 * len(points)


class _GridNumbers:
    """Numbers of all places on lines."""

    def __init__(self, x: Array, y: Array, order: int) -> None:
        rows, columns, inner = len(y) - 1, len(x) - 1, order - 1
        crossings = (rows + 1) * (columns + 1)
        along_x = crossings + np.arange((rows + 1) * columns * inner)
        along_y = crossings + len(along_x) + np.arange(rows * (columns + 1) * inner)
        self.crossing = np.arange(crossings).reshape(rows + 1, columns + 1)
        self.along_x = along_x.reshape(rows + 1, columns, inner)
        self.along_y = along_y.reshape(rows, columns + 1, inner)
        share = 0.5 * (1 + lobatto(order)[0][1:-1])
        self.points = np.empty((crossings + len(along_x) + len(along_y), 2))
        self.points[self.crossing] = np.stack(np.broadcast_arrays(x, y[:, None]), axis=-1)
        between = x[:-1, None] + share * np.diff(x)[:, None]
        self.points[self.along_x] = np.stack(np.broadcast_arrays(between, y[:, None, None]), axis=-1)
        between = (y[:-1, None] + share * np.diff(y)[:, None])[:, None]
        self.points[self.along_y] = np.stack(np.broadcast_arrays(x[:, None], between), axis=-1)

    def rim(self, block: Block) -> Ints:
        """Places around a block, anticlockwise from its lower left corner."""
        pieces = []
        for i, j, side in _around(block):
            if side == "bottom":
                pieces += [self.crossing[i, j : j + 1], self.along_x[i, j]]
            elif side == "right":
                pieces += [self.crossing[i, j + 1 : j + 2], self.along_y[i, j + 1]]
            elif side == "top":
                pieces += [self.crossing[i + 1, j + 1 : j + 2], self.along_x[i + 1, j, ::-1]]
            else:
                pieces += [self.crossing[i + 1, j : j + 1], self.along_y[i, j, ::-1]]
        return np.concatenate(pieces)


def rim_fields(edges: int, orders: TraceOrders, where: Array, height: Array) -> Array:
    """Displacement at points of a rim.

    Parameters
    ----------
    edges : of tiles, on the rim
    where : (n,) positions along the rim in edges, from 0 to ``edges``
    height : (n,) share of the thickness, 0 at the flat face

    Returns
    -------
    (3 n, trace) from the unknowns of the rim, ordered as in `Skeleton`
    """
    return _fields(
        orders, height, *(_around_rim(edges, order, where) for order in (orders.along, orders.shear))
    )


def edge_fields(orders: TraceOrders, share: Array, height: Array) -> Array:
    """(3 n, unknowns of an edge) displacement at points of one, at a share of its length and thickness."""
    return _fields(orders, height, *(_along_edge(order, share) for order in (orders.along, orders.shear)))


def _fields(orders: TraceOrders, height: Array, main: Array, further: Array) -> Array:
    """From values along a rim or edge of the polynomials of both orders."""
    up = interpolation(lobatto(orders.through)[0], 2 * height - 1)
    levels = (main[:, :, None] * up[:, None]).reshape(len(main), -1)
    profile = further * orders.profile(height)[:, None]
    return np.hstack([np.kron(levels, np.eye(3)), np.kron(profile, np.eye(3)[:, :2])])


def _along_edge(order: int, share: Array) -> Array:
    """(n, order + 1) values of the polynomials of an order along an edge; none for order 0."""
    if not order:
        return np.zeros((len(share), 0))
    return interpolation(lobatto(order)[0], 2 * share - 1)


def _around_rim(edges: int, order: int, where: Array) -> Array:
    """(n, edges * order) values of the functions that are polynomials on each edge of a rim."""
    edge = np.minimum(np.floor(where).astype(np.int64), edges - 1)
    along = _along_edge(order, where - edge)
    weights = np.zeros((len(where), edges * order))
    place = (edge[:, None] * order + np.arange(along.shape[1])) % max(edges * order, 1)
    np.add.at(weights, (np.arange(len(where))[:, None], place), along)
    return weights
