"""Block-structured hexahedral meshes of a unit cell, numbered by integers alone.

Seen from above, a curved core square sits in the middle; rings of four blocks lead from it to the
pillar's foot and on to the sides of the cell. Thin rings on both sides of the foot, and thin layers
above and below the plate's top, grade the mesh towards the re-entrant edge, where stress is singular.
The numbering depends only on the `MeshPlan`, never on the sizes: a sweep changes numbers, not topology.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from haptonic.cell.geometry import UnitCell
from haptonic.cell.quadrature import lobatto
from haptonic.lattice import Operation

Array = NDArray[np.float64]
Ints = NDArray[np.int64]

CORNERS = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])  # of the cell, anticlockwise, in half translations
LAYER_LENGTH = 1.4  # of an element along the pillar, in diameters
FOOT_LAYER = 0.3  # height of the pillar's lowest layer, in diameters: stresses of the foot die out in it
FOOT_WIDTH = 0.15  # outermost thin ring, as a share of the smallest length at the foot
FOOT_GRADING = 0.2  # each further ring reaches to this share of the one before
FOOT_CROWDING = 0.35  # spacing of nodes next to the foot, as a share of an even one: stress is singular there
CORE_RADIUS = 0.55  # core square's corners, as a share of the circle around it
CORE_BULGE = 0.45  # its edges: 0 straight, 1 arcs
PLAIN_RADIUS = 0.6  # circle that the ring follows where there is no pillar, as a share of the inradius


@dataclass(frozen=True)
class MeshPlan:
    """Resolution and topology of a mesh, free of any length.

    order : polynomial order of the elements around the pillar and in the core
    foot_rings : thin rings on either side of the pillar's foot, and as many thin layers
    pillar_layers : layers of elements along the pillar above the thin ones; 0 means no pillar
    blocks : elements along each side of the cell, and along each quarter of every ring
    plate_layers : layers through the plate below the thin ones
    outward : polynomial order across the rings; upward : along z; thin : across thin rings and thin
        layers; 0 means as ``order``
    """

    order: int
    foot_rings: int
    pillar_layers: int
    blocks: int = 1
    plate_layers: int = 1
    outward: int = 0
    upward: int = 0
    thin: int = 0

    def __post_init__(self) -> None:
        for name in ("outward", "upward", "thin"):
            object.__setattr__(self, name, getattr(self, name) or self.order)

    @classmethod
    def suited(cls, cell: UnitCell, order: int, foot_rings: int) -> MeshPlan:
        """Plan of similar errors in all directions, its elements not much longer than the pillar is wide.

        Around the pillar an element spans a quarter turn and gets two orders more.
        """
        orders = {"outward": order, "upward": order, "thin": order}
        if cell.pillar is None:
            return cls(order + 2, 0, 0, **orders)
        beyond = cell.pillar.height / (LAYER_LENGTH * cell.pillar.diameter)
        return cls(order + 2, foot_rings, 1 + max(1, round(beyond)), **orders)

    def lowered(self) -> MeshPlan:
        """The same blocks with orders one lower, around the pillar two.

        Fields that are even along a quarter of a turn gain nothing from an odd order more: two orders show
        what one would hide.
        """
        return replace(
            self,
            order=max(self.order - 2, 1),
            outward=max(self.outward - 1, 1),
            upward=max(self.upward - 1, 1),
            thin=max(self.thin - 1, 1),
        )

    @property
    def side(self) -> int:
        """Steps from node to node along a side of the cell."""
        return self.order * self.blocks

    @property
    def disc_rings(self) -> tuple[int, ...]:
        """Order across each ring from the core to the foot."""
        return (self.outward, *(self.thin,) * self.foot_rings)

    @property
    def rings(self) -> tuple[int, ...]:
        """Order across each ring from the core to the sides of the cell."""
        return (*self.disc_rings, *(self.thin,) * self.foot_rings, self.outward)

    @property
    def plate_layer_orders(self) -> tuple[int, ...]:
        """Order through each layer of the plate, from the flat face up."""
        return (*(self.upward,) * self.plate_layers, *(self.thin,) * self.foot_rings)

    @property
    def pillar_layer_orders(self) -> tuple[int, ...]:
        """Order through each layer above the plate's top."""
        if not self.pillar_layers:
            return ()
        return (*(self.thin,) * self.foot_rings, *(self.upward,) * self.pillar_layers)

    @property
    def plate_levels(self) -> int:
        """Node levels from the flat face up to the plate's top, both counted."""
        return sum(self.plate_layer_orders) + 1

    @property
    def pillar_levels(self) -> int:
        """Node levels above the plate's top."""
        return sum(self.pillar_layer_orders)


@dataclass(frozen=True, eq=False)
class Elements:
    """Elements of the same polynomial orders.

    nodes : (m, n1, n2, n3) node numbers in a right-handed local frame, last axis along z
    in_pillar : (m,) True above the plate's top
    """

    nodes: Ints
    in_pillar: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.nodes)


@dataclass(frozen=True, eq=False)
class Topology:
    """All of a mesh that the sizes do not touch; one object for each plan.

    The nodes of a level run from the core outwards, so the pillar's come first.

    plan : what it was made from
    core : (side+1, side+1) numbers of the core square's nodes, first axis along a1
    level_nodes, disc_nodes : nodes of a level of the plate, and those of them that the pillar goes on with
    families : all elements, grouped by their orders
    rim : (plate levels, 4 side) nodes on the lateral faces, anticlockwise from the first corner
    rim_master : (4 side,) for each place on the rim the place that it repeats, itself included
    rim_shift : (4 side, 2) integer lattice translation from that place to this one
    """

    plan: MeshPlan
    core: Ints
    level_nodes: int
    disc_nodes: int
    families: tuple[Elements, ...]
    rim: Ints
    rim_master: Ints
    rim_shift: Ints

    @property
    def nodes(self) -> int:
        return self.plan.plate_levels * self.level_nodes + self.plan.pillar_levels * self.disc_nodes

    def permutation(self, operation: Operation) -> Ints:
        """(nodes,) where a symmetry operation of the cell takes each node."""
        side, around = self.plan.side, 4 * self.plan.side
        grid = np.stack(np.meshgrid(np.arange(side + 1), np.arange(side + 1), indexing="ij"), axis=-1)
        turned = ((2 * grid - side) @ np.array(operation).T + side) // 2
        level = np.empty(self.level_nodes, dtype=np.int64)
        level[self.core] = self.core[turned[..., 0], turned[..., 1]]
        first = (side - 1) ** 2
        turn = level[first : first + around] - first  # of the core's perimeter, the same for every ring
        for start in range(first, self.level_nodes, around):
            level[start : start + around] = start + turn
        plate = np.arange(self.plan.plate_levels)[:, None] * self.level_nodes + level
        above = np.arange(self.plan.pillar_levels)[:, None] * self.disc_nodes + level[: self.disc_nodes]
        return np.concatenate([plate.ravel(), self.plan.plate_levels * self.level_nodes + above.ravel()])


@dataclass(frozen=True)
class HexMesh:
    """Hexahedra on Gauss-Lobatto-Legendre points.

    topology : numbers of nodes and elements
    points : (nodes, 3) coordinates, m
    """

    topology: Topology
    points: Array

    @property
    def unknowns(self) -> int:
        """Number of displacement components."""
        return 3 * len(self.points)

    def grids(self) -> list[tuple[int, ...]]:
        """(elements, p1, p2, p3) for each family: how many elements of which orders."""
        return [(len(family), *(n - 1 for n in family.nodes.shape[1:])) for family in self.topology.families]

    def linear_subcells(self) -> Ints:
        """(cells, 8) corners of the small hexahedra between neighbouring nodes, in VTK's order.

        Family by family, element by element, the last of the three local axes running fastest.
        """
        low, high = slice(None, -1), slice(1, None)
        turn = [(low, low), (high, low), (high, high), (low, high)]
        return np.concatenate([
            np.stack([e.nodes[:, a, b, c] for c in (low, high) for a, b in turn], axis=-1).reshape(-1, 8)
            for e in self.topology.families
        ])  # fmt: skip


def mesh_cell(cell: UnitCell, plan: MeshPlan) -> HexMesh:
    """Mesh of a unit cell: its topology from the plan, its points from the sizes."""
    topology = topology_of(plan)
    seen_from_above, heights = _level_points(cell, plan), _heights(cell, plan)
    plate = np.empty((plan.plate_levels, topology.level_nodes, 3))
    pillar = np.empty((plan.pillar_levels, topology.disc_nodes, 3))
    plate[..., :2], pillar[..., :2] = seen_from_above, seen_from_above[: topology.disc_nodes]
    plate[..., 2] = heights[: plan.plate_levels, None]
    pillar[..., 2] = heights[plan.plate_levels :, None]
    return HexMesh(topology, np.concatenate([plate.reshape(-1, 3), pillar.reshape(-1, 3)]))


@lru_cache(maxsize=64)
def topology_of(plan: MeshPlan) -> Topology:
    """The topology that a plan describes; the same object for the same plan."""
    p, side = plan.order, plan.side
    around, inner = 4 * side, (side - 1) ** 2
    core = np.empty((side + 1, side + 1), dtype=np.int64)
    core[1:-1, 1:-1] = np.arange(inner).reshape(side - 1, side - 1)
    core[_perimeter(side)] = inner + np.arange(around)

    # quadrilaterals seen from above, (n1, n2) node numbers each, and whether the pillar stands on them
    step, blocks = np.arange(p + 1), range(plan.blocks)
    faces = [(core[np.ix_(a * p + step, b * p + step)], True) for a in blocks for b in blocks]
    start = inner
    for ring, order in enumerate(plan.rings):
        across = start + np.arange(order + 1)[:, None] * around
        turns = [(sector * p + step) % around for sector in range(4 * plan.blocks)]
        faces += [(across + turn, ring < len(plan.disc_rings)) for turn in turns]
        start += order * around
    level_nodes = start + around
    disc_nodes = inner + around * (1 + sum(plan.disc_rings))

    levels = plan.plate_levels + plan.pillar_levels
    first = np.arange(levels) * level_nodes
    first[plan.plate_levels :] = plan.plate_levels * level_nodes + np.arange(plan.pillar_levels) * disc_nodes
    families: dict[tuple[int, ...], list[tuple[Ints, bool]]] = {}
    low = 0
    for order in (*plan.plate_layer_orders, *plan.pillar_layer_orders):
        above = low >= plan.plate_levels - 1
        for face, on_disc in faces:
            if on_disc or not above:
                nodes = face[..., None] + first[low : low + order + 1]
                families.setdefault(nodes.shape, []).append((nodes, above))
        low += order

    x, y = _perimeter(side)
    place = {(i, j): k for k, (i, j) in enumerate(zip(x, y, strict=True))}
    shift = np.stack([x == side, y == side], axis=-1).astype(np.int64)
    master = [place[i - side * s, j - side * t] for i, j, (s, t) in zip(x, y, shift, strict=True)]
    per_level = np.arange(plan.plate_levels)[:, None] * level_nodes
    return Topology(
        plan=plan,
        core=core,
        level_nodes=level_nodes,
        disc_nodes=disc_nodes,
        families=tuple(
            Elements(np.stack([nodes for nodes, _ in members]), np.array([above for _, above in members]))
            for members in families.values()
        ),
        rim=per_level + level_nodes - around + np.arange(around),
        rim_master=np.array(master),
        rim_shift=shift,
    )


def _perimeter(side: int) -> tuple[Ints, Ints]:
    """Positions of a square grid's 4 side outer nodes, anticlockwise from its first corner."""
    go, stay = np.arange(side), np.zeros(side, dtype=np.int64)
    x = np.concatenate([go, stay + side, side - go, stay])
    return x, np.concatenate([stay, go, stay + side, side - go])


def _level_points(cell: UnitCell, plan: MeshPlan) -> Array:
    """(level nodes, 2) positions of one level's nodes, m."""
    radius = cell.pillar.radius if cell.pillar else PLAIN_RADIUS * cell.inradius
    reach = _foot_reach(cell, plan)
    along = 0.5 * (1 + lobatto(plan.order)[0])
    share = (np.arange(plan.blocks)[:, None] + along[:-1]).ravel() / plan.blocks

    vectors = cell.lattice.vectors
    diagonals = CORNERS @ (vectors / np.linalg.norm(vectors, axis=1, keepdims=True))
    angles = np.unwrap(np.arctan2(diagonals[:, 1], diagonals[:, 0]))
    turn = np.append(angles, angles[0] + 2 * np.pi)
    corners = 0.5 * CORNERS @ vectors
    ends = np.stack([np.cos(turn), np.sin(turn)], axis=-1)
    angle = (turn[:-1, None] + share * np.diff(turn)[:, None]).ravel()
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    chords = (ends[:-1, None] + share[:, None] * np.diff(ends, axis=0)[:, None]).reshape(-1, 2)
    sides = np.roll(corners, -1, axis=0) - corners
    rim = (corners[:, None] + share[:, None] * sides[:, None]).reshape(-1, 2)

    edge = CORE_RADIUS * radius * (CORE_BULGE * circle + (1 - CORE_BULGE) * chords)
    radii = [radius - w for w in reach] + [radius] + [radius + w for w in reversed(reach)]
    curves = [edge, *(r * circle for r in radii), rim]
    square = np.empty((plan.side + 1, plan.side + 1, 2))
    square[_perimeter(plan.side)] = edge
    points = [_transfinite(square, np.append(share, 1.0))[1:-1, 1:-1].reshape(-1, 2), edge]
    shares = _shares(plan.rings, len(plan.disc_rings) if reach else None)
    for (a, b), share in zip(pairwise(curves), shares, strict=True):
        points += [a + s * (b - a) for s in share[1:]]
    return np.concatenate(points)


def _transfinite(square: Array, share: Array) -> Array:
    """Fill a grid (n, n, 2) from its four edges (Gordon and Hall's blending)."""
    s, t = share[:, None, None], share[None, :, None]
    left, right, low, high = square[:1], square[-1:], square[:, :1], square[:, -1:]
    edges = (1 - s) * left + s * right + (1 - t) * low + t * high
    corners = (
        (1 - s) * (1 - t) * square[0, 0]
        + s * (1 - t) * square[-1, 0]
        + (1 - s) * t * square[0, -1]
        + s * t * square[-1, -1]
    )
    return np.asarray(edges - corners)


def _foot_reach(cell: UnitCell, plan: MeshPlan) -> list[float]:
    """How far from the foot the borders of the thin rings lie, outermost first, m."""
    if cell.pillar is None:
        return []
    room = min(cell.pillar.radius, cell.thickness, cell.pillar.height, 2 * cell.clearance)
    return [FOOT_WIDTH * room * FOOT_GRADING**ring for ring in range(plan.foot_rings)]


def _heights(cell: UnitCell, plan: MeshPlan) -> Array:
    """(levels,) heights of the node levels, m."""
    reach, top = _foot_reach(cell, plan), cell.thickness
    reach_in = reach[0] if reach else 0.0
    breaks = list(np.linspace(0.0, top - reach_in, plan.plate_layers + 1))
    breaks += [top - w for w in reach[1:]] + [top] * bool(reach)
    if cell.pillar is not None:
        breaks += [top + w for w in reversed(reach)]
        end = top + cell.pillar.height
        first = top + min(FOOT_LAYER * cell.pillar.diameter, cell.pillar.height / plan.pillar_layers)
        breaks += [*np.linspace(first, end, plan.pillar_layers)[:-1], end]
    orders = (*plan.plate_layer_orders, *plan.pillar_layer_orders)
    shares = _shares(orders, len(plan.plate_layer_orders) if reach else None)
    levels = [np.array(breaks[:1])]
    levels += [a + s[1:] * (b - a) for (a, b), s in zip(pairwise(breaks), shares, strict=True)]
    return np.concatenate(levels)


def _shares(orders: tuple[int, ...], foot: int | None) -> list[Array]:
    """Positions of the nodes within intervals of some orders, 0 to 1.

    On the two intervals that meet at break number ``foot`` the nodes crowd towards it.
    """
    shares = [0.5 * (1 + lobatto(order)[0]) for order in orders]
    if foot is not None:
        before, after = 1 - shares[foot - 1][::-1], shares[foot]
        shares[foot - 1] = 1 - (FOOT_CROWDING * before + (1 - FOOT_CROWDING) * before**2)[::-1]
        shares[foot] = FOOT_CROWDING * after + (1 - FOOT_CROWDING) * after**2
    return shares
