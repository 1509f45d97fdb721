"""Numbers of the nodes and elements of a unit cell's mesh; they do not depend on any size.

Seen from above, a curved core square sits in the middle; rings of four blocks lead from it to the
pillar's foot and on to the sides of the cell. The pillar goes on with the inner ones of these blocks,
above a step with the innermost.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from haptonic.cell.plan import MeshPlan
from haptonic.lattice import Operation

Ints = NDArray[np.int64]


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
    level_start : (levels + 1,) number of the first node of each level, and of all nodes
    families : all elements, grouped by their orders
    rim : (plate levels, 4 side) nodes on the lateral faces, anticlockwise from the first corner
    rim_master : (4 side,) for each place on the rim the place that it repeats, itself included
    rim_shift : (4 side, 2) integer lattice translation from that place to this one
    """

    plan: MeshPlan
    core: Ints
    level_start: Ints
    families: tuple[Elements, ...]
    rim: Ints
    rim_master: Ints
    rim_shift: Ints

    @property
    def nodes(self) -> int:
        return int(self.level_start[-1])

    @property
    def first_above(self) -> int:
        """Number of the first node above the plate's top."""
        return int(self.level_start[self.plan.plate_levels])

    @property
    def top(self) -> Ints:
        """Numbers of the nodes of the highest level."""
        return np.arange(self.level_start[-2], self.nodes)

    def permutation(self, operation: Operation) -> Ints:
        """(nodes,) where a symmetry operation of the cell takes each node."""
        side, around = self.plan.side, 4 * self.plan.side
        grid = np.stack(np.meshgrid(np.arange(side + 1), np.arange(side + 1), indexing="ij"), axis=-1)
        turned = ((2 * grid - side) @ np.array(operation).T + side) // 2
        sizes = np.diff(self.level_start)
        level = np.empty(sizes[0], dtype=np.int64)
        level[self.core] = self.core[turned[..., 0], turned[..., 1]]
        first = (side - 1) ** 2
        turn = level[first : first + around] - first  # of the core's perimeter, the same for every ring
        for start in range(first, sizes[0], around):
            level[start : start + around] = start + turn
        pieces = [start + level[:size] for start, size in zip(self.level_start[:-1], sizes, strict=True)]
        return np.concatenate(pieces)


@lru_cache(maxsize=64)
def topology_of(plan: MeshPlan) -> Topology:
    """The topology that a plan describes; the same object for the same plan."""
    p, side = plan.order, plan.side
    around, inner = 4 * side, (side - 1) ** 2
    core = np.empty((side + 1, side + 1), dtype=np.int64)
    core[1:-1, 1:-1] = np.arange(inner).reshape(side - 1, side - 1)
    core[perimeter(side)] = inner + np.arange(around)

    # quadrilaterals seen from above: (n1, n2) node numbers each, and the ring that they lie in
    step, blocks = np.arange(p + 1), range(plan.blocks)
    faces = [(core[np.ix_(a * p + step, b * p + step)], -1) for a in blocks for b in blocks]
    start = inner
    for ring, order in enumerate(plan.rings):
        across = start + np.arange(order + 1)[:, None] * around
        turns = [(sector * p + step) % around for sector in range(4 * plan.blocks)]
        faces += [(across + turn, ring) for turn in turns]
        start += order * around

    level_start = np.concatenate([[0], np.cumsum(plan.level_sizes)])
    rings_of_layer = [len(plan.rings)] * len(plan.plate_layer_orders)
    rings_of_layer += [len(plan.disc_rings)] * len(plan.foot_layer_orders)
    rings_of_layer += [len(plan.tip_rings)] * len(plan.step_layer_orders)
    families: dict[tuple[int, ...], list[tuple[Ints, bool]]] = {}
    low = 0
    for order, rings in zip(plan.layer_orders, rings_of_layer, strict=True):
        above = low >= plan.plate_levels - 1
        for face, ring in faces:
            if ring < rings:
                nodes = face[..., None] + level_start[low : low + order + 1]
                families.setdefault(nodes.shape, []).append((nodes, above))
        low += order

    x, y = perimeter(side)
    place = {(i, j): k for k, (i, j) in enumerate(zip(x, y, strict=True))}
    shift = np.stack([x == side, y == side], axis=-1).astype(np.int64)
    master = [place[i - side * s, j - side * t] for i, j, (s, t) in zip(x, y, shift, strict=True)]
    per_level = level_start[: plan.plate_levels, None]
    on_side = plan.level_sizes[0] - around + np.arange(around)
    return Topology(
        plan=plan,
        core=core,
        level_start=level_start,
        families=tuple(
            Elements(np.stack([nodes for nodes, _ in members]), np.array([above for _, above in members]))
            for members in families.values()
        ),
        rim=per_level + on_side,
        rim_master=np.array(master),
        rim_shift=shift,
    )


def perimeter(side: int) -> tuple[Ints, Ints]:
    """Positions of a square grid's 4 side outer nodes, anticlockwise from its first corner."""
    go, stay = np.arange(side), np.zeros(side, dtype=np.int64)
    x = np.concatenate([go, stay + side, side - go, stay])
    return x, np.concatenate([stay, go, stay + side, side - go])
