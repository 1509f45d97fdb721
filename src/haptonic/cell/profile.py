"""Positions of a mesh's blocks and nodes in a half-plane through the pillar's axis.

A place in the half-plane is a (half-width, height): outlines of that half-width are the borders between the
blocks of rings. Thin rings on both sides of the foot, and thin layers above and below the plate's top, grade
the mesh towards the re-entrant edge, where stress is singular, and others towards the edge at a step. With a
fillet the foot has no such edge: it then lies in the middle of the arc, and the thin rings and layers follow
the halves of the arc.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array
from haptonic.cell.divided import borders, edges_between, half_widths, storeys_of
from haptonic.cell.edges import (
    CORE_RADIUS,
    FOOT_LAYER,
    beside_foot,
    bridged,
    foot_reach,
    step_reach,
    step_share,
    within_foot,
)
from haptonic.cell.pillar import Pillar
from haptonic.cell.plan import MeshPlan
from haptonic.cell.quadrature import lobatto
from haptonic.cell.stack import Stack
from haptonic.cell.tile import TileShape

EDGE_CROWDING = 0.35  # spacing of nodes next to a singular edge, relative to an even one
BESIDE_FILLET = 0.6  # smallest width of all thin rings on the inner side of a fillet, in radii of the arc
MOST_BESIDE = 0.45  # and the largest, as a share of the room there
PLAIN_RADIUS = 0.6  # circle that the ring follows without a pillar, as a share of the inradius


@dataclass(frozen=True)
class Profile:
    """Borders between rings (b of them, from the core's to the last before the cell's sides) and layers (l).

    width : (b, l) half-widths of the borders between rings where they meet those between layers, m
    height : (b, l) heights of these corners above z = 0, m; at the cell's sides as for the last b
    ring_shares, layer_shares : positions of the nodes within each ring and each layer, from 0 to 1
    """

    plan: MeshPlan
    pillar: Pillar | None
    width: Array
    height: Array
    ring_shares: tuple[Array, ...]
    layer_shares: tuple[Array, ...]

    @classmethod
    def of(cls, cell: TileShape, plan: MeshPlan) -> Profile:
        """Profile of a cell."""
        if cell.meshed_stack is not None:
            return cls._of_stack(cell, cell.meshed_stack, plan)
        pillar = cell.pillar
        assert plan.foot_rings or pillar is None or not pillar.fillet, "a fillet needs a ring at the foot"
        assert bool(plan.step_layers) == (pillar is not None and pillar.step is not None), (
            "step and plan differ"
        )
        sharp = pillar is not None and not pillar.fillet and plan.foot_rings > 0
        foot, top = len(plan.disc_rings), len(plan.plate_layer_orders)
        levels = _levels(cell, plan)
        if pillar is None:
            widths = np.array([CORE_RADIUS, 1.0])[:, None] * PLAIN_RADIUS * cell.inradius
            width = np.repeat(widths, len(levels), axis=1)
        else:
            width = _widths(cell, pillar, plan, levels)
        height = np.repeat(levels[None], len(width), axis=0)
        if pillar is not None and pillar.arc is not None:
            for k in range(plan.foot_rings + 1):
                down, up = pillar.arc.at(0.5 * (1 + np.array([-1, 1]) * k / plan.foot_rings))
                width[foot + k, top], height[foot + k, top] = down[0], cell.thickness + down[1]
                width[foot, top + k], height[foot, top + k] = up[0], cell.thickness + up[1]
        at_foot = [(foot, top)] if sharp else []
        at_step = [(len(plan.tip_rings), top + len(plan.foot_layer_orders))] if plan.step_rings else []
        rings, layers = zip(*at_foot, *at_step, strict=True) if at_foot or at_step else ((), ())
        return cls(
            plan, pillar, width, height,
            ring_shares=_shares(plan.rings, rings),
            layer_shares=_shares(plan.layer_orders, layers),
        )  # fmt: skip

    @classmethod
    def _of_stack(cls, cell: TileShape, stack: Stack, plan: MeshPlan) -> Profile:
        blocks = plan.stack
        assert blocks is not None, "a plan without a stack"
        heights = borders(storeys_of(cell, stack, blocks.thin), blocks.storeys)
        width = half_widths(cell, stack, blocks, heights)
        return cls(
            plan, None,
            width, np.repeat(heights[None], len(width), axis=0),
            ring_shares=_shares(plan.rings, edges_between(blocks.annuli)),
            layer_shares=_shares(plan.layer_orders, edges_between(blocks.storeys)),
        )  # fmt: skip

    def between(self, layer: int, share: float) -> tuple[list[Array], list[Array]]:
        """Half-widths and heights on a level of nodes at a share of a layer.

        They are listed for each ring from its inner border (with the first node) to its outer border. The
        outer border of the last ring is the cell's side; its half-widths are those of the inner border.
        """
        low, high = self.width[:, layer], self.width[:, layer + 1]
        width = low + share * (high - low)
        low, high = self.height[:, layer], self.height[:, layer + 1]
        height = low + share * (high - low)
        widths, heights = [], []
        for ring, along in enumerate(self.ring_shares):
            outer = min(ring + 1, len(width) - 1)
            bulge = self._bulge(ring, layer, along, share)
            widths.append(width[ring] + along * (width[outer] - width[ring]) + bulge[:, 0])
            heights.append(height[ring] + along * (height[outer] - height[ring]) + bulge[:, 1])
        return widths, heights

    def _bulge(self, ring: int, layer: int, along: Array, share: float) -> Array:
        """(nodes, 2) deviation of a block with a side on the fillet from one with straight sides."""
        foot, top = len(self.plan.disc_rings), len(self.plan.plate_layer_orders)
        arc, pieces = self.pillar.arc if self.pillar else None, self.plan.foot_rings
        if arc is None:
            return np.zeros((len(along), 2))
        if layer == top - 1 and foot <= ring < foot + pieces:  # below the lower half of the arc
            ends = 0.5 * (1 - np.array([ring - foot, ring - foot + 1]) / pieces)
            return share * _from_chord(arc.at(ends[0] + along * (ends[1] - ends[0])), along)
        if ring == foot - 1 and top <= layer < top + pieces:  # inside its upper half
            ends = 0.5 * (1 + np.array([layer - top, layer - top + 1]) / pieces)
            curve = arc.at(ends[0] + np.array([0.0, share, 1.0]) * (ends[1] - ends[0]))
            return np.outer(along, _from_chord(curve, np.array([0.0, share, 1.0]))[1])
        return np.zeros((len(along), 2))


def _from_chord(curve: Array, along: Array) -> Array:
    """Distances of the points of a curve from its chord; the first and last points are its ends."""
    return np.asarray(curve - (curve[0] + along[:, None] * (curve[-1] - curve[0])))


def _widths(cell: TileShape, pillar: Pillar, plan: MeshPlan, levels: Array) -> Array:
    """(b, l) half-widths of the borders between rings, m, before the fillet's arc is included."""
    reach = foot_reach(cell, plan.foot_rings)
    room = (1 - within_foot(pillar)) * pillar.radius
    inward = bridged(_beside_fillet(reach, room, pillar.fillet), room, plan.bridges[0])
    if pillar.arc is not None:  # the thin rings end where the arc does
        outward = pillar.arc.at(0.5 * (1 - np.arange(1, plan.foot_rings + 1) / plan.foot_rings))[:, 0]
    else:
        outward = pillar.radius + bridged(reach, beside_foot(cell), plan.bridges[1])[::-1]
    inner = [pillar.radius - step for step in inward] + [pillar.radius]
    above = np.maximum(levels - cell.thickness, 0.0)
    last = len(pillar.stages) - 1
    low, _, width = pillar.stages[last]
    foot = np.array([pillar.half_width(z, 0) for z in above])
    tip = np.array(
        [
            pillar.half_width(z, last) if z > low else step_share(pillar) * w
            for z, w in zip(above, foot, strict=True)
        ]
    )
    rows = [CORE_RADIUS * tip]
    if pillar.step is not None:
        beside = step_reach(pillar, plan.step_rings) / width
        rows += [share * tip for share in (*(1 - beside), 1.0, *(1 + beside[::-1]))]
    rows += [width / pillar.radius * foot for width in inner]
    rows += [np.full(len(levels), width) for width in outward]
    return np.stack(rows)


def _levels(cell: TileShape, plan: MeshPlan) -> Array:
    """(l,) heights of the borders between layers away from a fillet, m."""
    reach, top, pillar = foot_reach(cell, plan.foot_rings), cell.thickness, cell.pillar
    floor = top - cell.depth
    if pillar is None:
        return np.linspace(floor, top, plan.plate_layers + 1)
    downward = bridged(_beside_fillet(reach, cell.depth, pillar.fillet), cell.depth, plan.bridges[3])
    breaks = [*np.linspace(floor, top - (downward[0] if len(reach) else 0.0), plan.plate_layers + 1)]
    breaks += [top - w for w in downward[1:]] + [top] * bool(len(reach))
    _, high, radius = pillar.stages[0]
    lowest = min(2 * FOOT_LAYER * radius, high / plan.pillar_layers)
    if pillar.arc is None:
        breaks += [top + w for w in bridged(reach, lowest, plan.bridges[2])[::-1]]
    else:
        arc = pillar.arc.at(0.5 * (1 + np.arange(1, plan.foot_rings + 1) / plan.foot_rings))[:, 1]
        breaks += [top + z for z in arc]
        lowest = arc[-1] + min(2 * FOOT_LAYER * radius, (high - arc[-1]) / plan.pillar_layers)
    if pillar.step is None:
        return np.array([*breaks, *_upwards(top + lowest, top + high, plan.pillar_layers)])
    beside = step_reach(pillar, plan.step_rings)
    ledge, end, within = top + high, top + pillar.height, beside[0] if len(beside) else 0.0
    if plan.pillar_layers > 2:  # with a short layer below the step as well
        below = min(2 * FOOT_LAYER * pillar.half_width(high, 0), (high - lowest) / plan.pillar_layers)
        breaks += [*_upwards(top + lowest, ledge - below, plan.pillar_layers - 1), ledge - within]
    else:
        breaks += [*_upwards(top + lowest, ledge - within, plan.pillar_layers)]
    breaks += [*(ledge - beside[1:]), ledge, *(ledge + beside[::-1])][: 2 * len(beside)]
    first = ledge + min(FOOT_LAYER * 2 * pillar.stages[-1][2], (pillar.height - high) / plan.step_layers)
    return np.array([*breaks, *_upwards(first, end, plan.step_layers)])


def _upwards(first: float, last: float, layers: int) -> Array:
    """Upper borders of some layers, from those of the lowest and the highest layer."""
    return np.append(np.linspace(first, last, layers)[:-1], last)


def _beside_fillet(reach: Array, room: float, fillet: float) -> Array:
    """Reach of the thin rings on the side of a foot without the fillet: even, and as large as the fillet."""
    if not fillet:
        return reach
    whole = min(max(reach[0], BESIDE_FILLET * fillet), MOST_BESIDE * room)
    return np.asarray(whole * np.arange(len(reach), 0, -1) / len(reach))


def _shares(orders: tuple[int, ...], edges: tuple[int, ...]) -> tuple[Array, ...]:
    """Positions of the nodes within intervals of some orders, 0 to 1.

    On the two intervals that meet at a border in ``edges``, the nodes are denser towards it.
    """
    shares = [0.5 * (1 + lobatto(order)[0]) for order in orders]
    for edge in edges:
        before, after = 1 - shares[edge - 1][::-1], shares[edge]
        shares[edge - 1] = 1 - (EDGE_CROWDING * before + (1 - EDGE_CROWDING) * before**2)[::-1]
        shares[edge] = EDGE_CROWDING * after + (1 - EDGE_CROWDING) * after**2
    return tuple(shares)
