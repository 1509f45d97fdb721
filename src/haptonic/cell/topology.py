"""Numbering of the nodes and elements of a unit cell's mesh, independent of all sizes.

A cell is a polygon. Seen from above, a curved core is in its middle: one square patch in a cell of four
sides, else a patch for each corner, and these meet at the centre. Rings of blocks, as many for each side of
the cell, lead from the core to the pillar's foot and on to the sides. The grid of the plan gives the blocks
of each layer and their materials: a pillar continues the inner blocks, above a step the innermost. For a cell
that is its own image in the plate's middle plane, all this is its upper half; the nodes and elements of the
lower half follow. A piece of a pillar about its step is meshed like a cell: the part below the step replaces
the plate, and its sides are free.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import scipy
from numpy.typing import NDArray

from haptonic.arrays import Array, Ints
from haptonic.cell.blocks import VOID, level_positions
from haptonic.cell.plan import MeshPlan
from haptonic.cell.tile import Sides

SAME = 1e-9  # of a polygon with corners on the unit circle: closer places coincide


@dataclass(frozen=True, eq=False)
class Elements:
    """Elements of the same polynomial orders.

    nodes : (m, n1, n2, n3) node numbers in a right-handed local frame, last axis along z
    in_pillar : (m,) True above the plate's top, and below its other face
    region : (m,) number of the material, see `TileShape.solids`
    """

    nodes: Ints
    in_pillar: NDArray[np.bool_]
    region: Ints

    def __len__(self) -> int:
        return len(self.nodes)

    def with_images(self, image: Ints) -> Elements:
        """These elements and their images, upside down, so that their frames are right-handed."""
        nodes = np.concatenate([self.nodes, image[self.nodes][..., ::-1]])
        return Elements(nodes, np.concatenate([self.in_pillar] * 2), np.concatenate([self.region] * 2))


@dataclass(frozen=True, eq=False)
class Topology:
    """All of a mesh that is independent of sizes; one object for each plan.

    The nodes of a level run from the core outwards.

    plan : plan of the mesh
    core : (patches, m + 1, m + 1) numbers of the core's nodes; patches that meet at the centre begin there
    mirrored : True if a lower half follows, the image of all this in the lowest level
    free : True for a piece of a pillar, which has no lateral faces, and an open end below
    level_start : (levels + 1,) number of the first node of each level, and number of all nodes
    families : all elements, grouped by their orders
    rim : (plate levels, around) nodes on the lateral faces, anticlockwise from the first corner; the lowest
        level first
    """

    plan: MeshPlan
    core: Ints
    mirrored: bool
    free: bool
    level_start: Ints
    families: tuple[Elements, ...]
    rim: Ints

    @property
    def nodes(self) -> int:
        return len(self.image)

    @cached_property
    def image(self) -> Ints:
        """(nodes,) image of each node in the middle plane; itself without a lower half."""
        return _images(self.level_start) if self.mirrored else np.arange(self.level_start[-1])

    @cached_property
    def positions(self) -> tuple[Ints, ...]:
        """For each level, indices of its nodes among all possible nodes of a level, ascending."""
        return tuple(
            level_positions(curves, self.plan.core_size, self.plan.around) for curves in self.plan.curves
        )

    @property
    def faces(self) -> int:
        """Number of faces of the plate with pillars."""
        return 2 if self.mirrored else 1

    @property
    def upper_rim(self) -> Ints:
        """(levels, around) rim of the meshed half, from the middle plane up, or the whole rim."""
        return self.rim[len(self.rim) // 2 :] if self.mirrored else self.rim

    @property
    def pillar_start(self) -> Ints:
        """(levels + 1,) numbers of the first nodes of levels above the plate's top, and of all nodes."""
        return self.level_start[0 if self.free else self.plan.plate_levels :]

    @property
    def foot(self) -> Topology:
        """Part below the second of the pillar's layers above its thin ones."""
        return topology_of(self.plan.foot, mirrored=self.mirrored, free=self.free)

    @property
    def top(self) -> Ints:
        """Numbers of the nodes of the highest level, and of the lowest level of a lower half."""
        top = np.arange(self.level_start[-2], self.level_start[-1])
        return np.unique(np.concatenate([top, self.image[top]]))

    @property
    def of_foot(self) -> Ints:
        """Numbers of the foot's nodes: the lowest of all, and their images."""
        upper = np.arange(self.foot.level_start[-1])
        return np.concatenate([upper, self.image[upper[self.level_start[1] :]]]) if self.mirrored else upper

    def permutation(self, moved: Sides) -> Ints:
        """(nodes,) image of each node by a rotation or mirror, given by the images of the first two sides."""
        inner, around = self.plan.core_size, self.plan.around
        rim = _rim_points(self.plan.sides, self.plan.side)
        level = _moved(np.concatenate([_core_points(self.plan)[:inner], rim]), self.plan.sides, moved)
        for start in range(inner + around, inner + around * (self.plan.curves.shape[1] - 1), around):
            level = np.append(level, start + level[inner : inner + around] - inner)
        pieces = [
            start + np.searchsorted(places, level[places])
            for start, places in zip(self.level_start[:-1], self.positions, strict=True)
        ]
        upper = np.concatenate(pieces)
        lower = upper[self.level_start[1] :]
        return np.concatenate([upper, self.image[lower]]) if self.mirrored else upper

    @property
    def rim_nodes(self) -> int:
        """Number of places of the trace around the rim."""
        return 0 if self.free else self.plan.rim_nodes

    def moved_rim(self, moved: Sides) -> Ints:
        """(places,) image of each place of the trace, as in `permutation`."""
        points = _rim_points(self.plan.sides, math.prod(self.plan.on_sides))
        return _moved(points[: self.rim_nodes], self.plan.sides, moved)


@lru_cache(maxsize=64)
def topology_of(plan: MeshPlan, *, mirrored: bool = False, free: bool = False) -> Topology:
    """Topology of a plan, which for a mirrored mesh is that of the upper half; one object for each plan."""
    p, inner, around = plan.order, plan.core_size, plan.around
    tree = scipy.spatial.cKDTree(np.concatenate([_core_points(plan), _rim_points(plan.sides, plan.side)]))
    core = np.stack([np.asarray(tree.query(patch)[1], dtype=np.int64) for patch in _patches(plan)])
    # quadrilaterals seen from above: (n1, n2) node numbers of each, and its ring
    step, blocks = np.arange(p + 1), range((core.shape[1] - 1) // p)
    pieces = [(patch, a * p + step, b * p + step) for patch in core for a in blocks for b in blocks]
    faces = [(patch[np.ix_(first, second)], -1) for patch, first, second in pieces]
    start = inner
    for ring, order in enumerate(plan.rings):
        across = start + np.arange(order + 1)[:, None] * around
        turns = [(sector * p + step) % around for sector in range(around // p)]
        faces += [(across + turn, ring) for turn in turns]
        start += order * around

    level_start = np.concatenate([[0], np.cumsum(plan.level_sizes)])
    number = np.full((len(plan.curves), start + around), -1, dtype=np.int64)
    for level, curves in enumerate(plan.curves):
        places = level_positions(curves, inner, around)
        number[level, places] = level_start[level] + np.arange(len(places))
    families: dict[tuple[int, ...], list[tuple[Ints, bool, int]]] = {}
    low = 0
    for order, blocks_of_layer in zip(plan.layer_orders, plan.grid, strict=True):
        above = free or low >= plan.plate_levels - 1
        for face, ring in faces:
            region = blocks_of_layer[1 + ring]
            if region != VOID:
                nodes = np.moveaxis(number[low : low + order + 1, face], 0, -1)
                families.setdefault(nodes.shape, []).append((nodes, above, 1 if free else region))
        low += order

    rim = number[: plan.plate_levels, start : start + (0 if free else around)]
    grouped = [
        Elements(*(np.array(column) for column in zip(*members, strict=True)))
        for members in families.values()
    ]
    if mirrored:
        image = _images(level_start)
        rim = np.concatenate([image[rim[:0:-1]], rim])
        grouped = [family.with_images(image) for family in grouped]
    return Topology(
        plan=plan,
        core=core,
        mirrored=mirrored,
        free=free,
        level_start=level_start,
        families=tuple(grouped),
        rim=rim,
    )


def _images(level_start: Ints) -> Ints:
    """(nodes,) images in the lowest level of the nodes of a mesh and of the half below it, which follow."""
    first, upper = level_start[1], level_start[-1]
    above = np.arange(first, upper)
    return np.concatenate([np.arange(first), above + upper - first, above])


def _corners(sides: int) -> Array:
    """(sides, 2) corners of a regular polygon, anticlockwise; its first side is the lowest and level."""
    angle = np.pi * (2 * np.arange(sides) - 1) / sides - 0.5 * np.pi
    return np.stack([np.cos(angle), np.sin(angle)], axis=-1)


def _middles(sides: int) -> Array:
    """(sides, 2) middles of the sides of this polygon."""
    corners = _corners(sides)
    return np.asarray(0.5 * (corners + np.roll(corners, -1, axis=0)))


def _rim_points(sides: int, steps: int) -> Array:
    """(sides * steps, 2) places of a rim on a regular polygon that replaces the cell, evenly spaced."""
    corners = _corners(sides)
    along = np.arange(steps)[:, None] / steps
    following = np.roll(corners, -1, axis=0)
    return np.concatenate([
        first + along * (second - first) for first, second in zip(corners, following, strict=True)
    ])  # fmt: skip


def _moved(points: Array, sides: int, moved: Sides) -> Ints:
    """(n,) image of each of the points (n, 2) in a regular polygon."""
    middles = _middles(sides)
    turn = middles[list(moved)].T @ np.linalg.inv(middles[:2].T)
    distance, image = scipy.spatial.cKDTree(points).query(points @ turn.T)
    assert distance.max(initial=0.0) < SAME, "the operation does not leave the mesh as it is"
    return np.asarray(image, dtype=np.int64)


def _patches(plan: MeshPlan) -> list[Array]:
    """(m + 1, m + 1, 2) positions of the nodes of each patch of the core, in the same polygon."""
    corners, middles = _corners(plan.sides), _middles(plan.sides)
    if len(corners) == 4:
        outlines, steps = [corners], plan.side
    else:
        assert not plan.side % 2, "patches of the core end in the middle of a side"
        centre = np.zeros((len(corners), 2))
        outlines = list(np.stack([centre, np.roll(middles, 1, axis=0), corners, middles], axis=1))
        steps = plan.side // 2
    s, t = np.meshgrid(*2 * [np.arange(steps + 1) / steps], indexing="ij")
    shares = np.stack([(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t], axis=-1)
    return [shares @ outline for outline in outlines]


def _core_points(plan: MeshPlan) -> Array:
    """(core, 2) positions of the core's nodes within its outline, in the order of their numbers."""
    points = np.concatenate([patch.reshape(-1, 2) for patch in _patches(plan)])
    away, _ = scipy.spatial.cKDTree(_rim_points(plan.sides, plan.side)).query(points)
    points = points[away > SAME]
    _, first = np.unique(np.round(points / SAME), axis=0, return_index=True)
    return np.asarray(points[np.sort(first)])
