"""Block-structured hexahedral meshes of a unit cell: topology from the plan, points from the sizes.

A sweep changes sizes, not topology.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell.plan import MeshPlan
from haptonic.cell.profile import Profile
from haptonic.cell.quadrature import interpolation, lobatto
from haptonic.cell.sectors import along_sides, sectors, transfinite
from haptonic.cell.stack import Stack
from haptonic.cell.tile import TileShape
from haptonic.cell.topology import Topology, topology_of


@dataclass(frozen=True)
class HexMesh:
    """Hexahedra on Gauss-Lobatto-Legendre points.

    topology : numbers of nodes and elements
    points : (nodes, 3) coordinates, m
    """

    topology: Topology
    points: Array

    @property
    def rim_points(self) -> Array:
        """(places, 3) lowest places of the trace, anticlockwise from the first corner, m."""
        plan = self.topology.plan
        return along_sides(self.points[self.topology.rim[0, :: plan.side]], trace_shares(plan))

    @property
    def unknowns(self) -> int:
        """Number of displacement components."""
        return 3 * len(self.points)

    def grids(self) -> list[tuple[int, ...]]:
        """(elements, p1, p2, p3) for each family: number of elements and their orders."""
        return [(len(family), *(n - 1 for n in family.nodes.shape[1:])) for family in self.topology.families]

    def linear_subcells(self) -> Ints:
        """(cells, 8) corners of the small hexahedra between neighbouring nodes, in VTK's order.

        They are listed by family and element, with the last of the three local axes running fastest.
        """
        low, high = slice(None, -1), slice(1, None)
        turn = [(low, low), (high, low), (high, high), (low, high)]
        return np.concatenate([
            np.stack([e.nodes[:, a, b, c] for c in (low, high) for a, b in turn], axis=-1).reshape(-1, 8)
            for e in self.topology.families
        ])  # fmt: skip


@dataclass(frozen=True, eq=False)
class SurfaceMesh:
    """Surface of a tile whose inside is not shown.

    points : (nodes, 3) m
    cells : (m, 4) quadrilaterals, anticlockwise as seen from outside
    lower : (k, n, n) nodes on Gauss-Lobatto-Legendre points of the quadrilaterals at z = 0
    rim_points : (places, 3) see `HexMesh`
    unknowns : number of displacement components of the elements inside
    topology : topology of a plate in blocks with the same lateral faces
    """

    points: Array
    cells: Ints
    lower: Ints
    rim_points: Array
    unknowns: int
    topology: Topology

    def grids(self) -> list[tuple[int, ...]]:
        """(cells,), because the cells belong to no element."""
        return [(len(self.cells),)]

    def linear_subcells(self) -> Ints:
        """(cells, 8) flat hexahedra; the lower face is visible and the upper one has no extent."""
        return np.hstack([self.cells[:, ::-1], np.repeat(self.cells[:, -1:], 4, axis=1)])


def side_shares(plan: MeshPlan) -> Array:
    """(side,) positions of the nodes along a side of a tile, from 0, without the last corner."""
    return _shares(plan.blocks, plan.order)


def trace_shares(plan: MeshPlan) -> Array:
    """(places on a side,) positions of the places of the trace along a side, see `side_shares`."""
    return _shares(*plan.on_sides)


def _shares(pieces: int, order: int) -> Array:
    """(pieces * order,) nodes of polynomials on equal pieces of a side, from 0, without the last one."""
    along = 0.5 * (1 + lobatto(order)[0])
    return np.asarray((np.arange(pieces)[:, None] + along[:-1]).ravel() / pieces)


@lru_cache(maxsize=64)
def along_rim(plan: MeshPlan) -> Array:
    """(around, places) interpolation from the places of the trace to the nodes of a mesh on the rim."""
    if not plan.rim[0]:
        return np.eye(plan.around)
    pieces, order = plan.rim
    piece, place = np.divmod(pieces * side_shares(plan), 1.0)
    on_piece = interpolation(0.5 * (1 + lobatto(order)[0]), place)
    whole = np.zeros((plan.sides, plan.side, plan.rim_nodes))
    for side in range(plan.sides):
        columns = order * (side * pieces + piece.astype(int))[:, None] + np.arange(order + 1)
        np.put_along_axis(whole[side], columns % plan.rim_nodes, on_piece, axis=1)
    return whole.reshape(plan.around, plan.rim_nodes)


def mesh_cell(cell: TileShape, plan: MeshPlan) -> HexMesh:
    """Mesh a unit cell: topology from the plan, points from the sizes.

    If a cell is its own image in the middle plane, the plan is that of the half above it.
    """
    profile, outlines = Profile.of(cell, plan), _Outlines.of(cell, plan)
    levels = []
    for layer, shares in enumerate(profile.layer_shares):
        for share in shares[1 if layer else 0 :]:
            levels.append(_level(profile, outlines, layer, share))
    topology = topology_of(plan, mirrored=cell.is_halved, free=cell.free_width is not None)
    half = np.concatenate([level[chosen] for level, chosen in zip(levels, topology.positions, strict=True)])
    if not cell.is_halved:
        return HexMesh(topology, half)
    image = half[topology.level_start[1] :] * np.array([1.0, 1.0, -1.0]) + np.array(
        [0.0, 0.0, cell.thickness]
    )
    return HexMesh(topology, np.concatenate([half, image]))


@dataclass(frozen=True)
class _Outlines:
    """Curves around the axis, (around, 2) points each in the order of the rim.

    core : around the core, for a half-width of 1
    rings : each border about the axis, for a half-width of 1
    stack : discs whose borders these are, if any
    rim : around the cell, or around the pillar for a piece of a pillar, m
    side : half-width of the rim where the last border is next to it, m
    shares : positions of the nodes along a side of a patch of the core
    """

    core: Array
    rings: tuple[Array, ...]
    stack: Stack | None
    rim: Array
    side: float
    shares: Array

    @classmethod
    def of(cls, cell: TileShape, plan: MeshPlan) -> _Outlines:
        along = 0.5 * (1 + lobatto(plan.order)[0])
        share = side_shares(plan)
        corners, borders = cell.corners, sectors(cell, plan.blocks, plan.thin_around)
        rings = tuple(around.points(along[:-1]) for around in borders)
        core = borders[0].core(along[:-1])
        whole = np.append(share, 1.0)
        shares = whole if len(corners) == 4 else 2 * whole[: plan.side // 2 + 1]
        rim = along_sides(corners, share) if cell.free_width is None else cell.free_width * rings[0]
        return cls(core=core, rings=rings, stack=cell.meshed_stack, rim=rim, side=cell.room, shares=shares)

    def ring(self, width: float, height: float) -> Array:
        """Curve for a half-width at a height, m: between two borders, beyond them like the nearest one.

        If the last border bends inwards, curves beyond it are between it and the rim.
        """
        borders = self.stack.widths_at(height) if self.stack else np.empty(0)
        number = int(np.searchsorted(borders, width))
        if number and number == len(borders) and self.stack and not self.stack.outline.is_convex:
            share = (width - borders[-1]) / (self.side - borders[-1])
            return np.asarray((1 - share) * borders[-1] * self.rings[-1] + share * self.rim)
        if number in (0, len(borders)):
            return width * self.rings[min(number, len(self.rings) - 1)]
        low, high = borders[number - 1 : number + 1]
        share = (width - low) / (high - low)
        inner, outer = low * self.rings[number - 1], high * self.rings[number]
        return np.asarray((1 - share) * inner + share * outer)


def _level(profile: Profile, outlines: _Outlines, layer: int, share: float) -> Array:
    """(nodes, 3) positions of all possible nodes of a level, m; a pillar's level has only the first ones."""
    plan = profile.plan
    widths, heights = profile.between(layer, share)
    edge = widths[0][0] * outlines.core
    core = np.concatenate([np.zeros((plan.core_size, 2)), edge])
    for patch in topology_of(plan).core:
        if plan.sides != 4:  # it begins at the centre, with straight sides to the core's outline
            core[patch[:, 0]] = outlines.shares[:, None] * core[patch[-1, 0]]
            core[patch[0]] = outlines.shares[:, None] * core[patch[0, -1]]
        core[patch[1:-1, 1:-1]] = transfinite(core[patch], outlines.shares)[1:-1, 1:-1]
    pieces = [_at_height(core, heights[0][0])]
    for ring, (width, height) in enumerate(zip(widths, heights, strict=True)):
        along = profile.ring_shares[ring]
        for s, w, z in list(zip(along, width, height, strict=True))[1:]:
            if ring == 0:  # from the core's outline to that of the other rings
                inner = outlines.ring(width[0], z)
                curve = outlines.ring(w, z) + (1 - s) * (width[0] * outlines.core - inner)
            elif ring == len(widths) - 1:
                curve = (1 - s) * outlines.ring(w, z) + s * outlines.rim
            else:
                curve = outlines.ring(w, z)
            pieces.append(_at_height(curve, z))
    return np.concatenate(pieces)


def _at_height(points: Array, height: float) -> Array:
    return np.column_stack([points, np.full(len(points), height)])
