"""Trace of a field on the lateral faces: the only unknowns that couple cells.

At each place of the rim the trace is a polynomial through the thickness, given by its values on
Gauss-Lobatto-Legendre levels. It does not depend on the layers of the mesh inside. Along each side it is the
polynomial of the mesh's element or elements, or a single one of a lower order if elements are short.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Ints
from haptonic.cell import MeshPlan, TileShape, Topology
from haptonic.cell.mesh import along_rim
from haptonic.later import sparse as sp
from haptonic.superelement.symmetry import THROUGH, Folding


def trace_levels(plan: MeshPlan) -> int:
    """Number of levels of the trace, equal to that of the mesh if the plate has one layer.

    If it has several layers for the foot of the pillar, a polynomial of one order less than theirs, at least
    a parabola, is enough far from the foot.
    """
    layers = len(plan.plate_layer_orders)
    if plan.levels:
        return plan.levels
    if layers == 1:
        return plan.plate_levels + (plan.near_rim if plan.stack else 0)
    return max(plan.upward, 3) + plan.near_rim


@dataclass(frozen=True, eq=False)
class FoldedTrace:
    """Trace unknowns of one symmetry class, and their relation to those of the whole cell.

    The whole trace is ordered (level, place on the rim, component). The class has unknowns at the
    representative places, without the components that are zero in the class; if the middle plane is a
    mirror, on the levels from there up.

    topology, folding : of the mesh; rim : folded places of the trace
    """

    topology: Topology
    folding: Folding
    rim: Folding
    symmetry_class: int
    levels: int

    @property
    def sites(self) -> int:
        """Number of representative places."""
        return len(self.rim.origin)

    @property
    def rim_size(self) -> int:
        """Number of representatives on the rim of the mesh."""
        return len(self.topology.upper_rim) * len(self._nodes)

    @cached_property
    def _nodes(self) -> Ints:
        """(nodes,) numbers around the rim of the representatives of the mesh on its highest level."""
        highest = self.topology.rim[-1]
        representatives = np.unique(self.folding.node[highest])
        return np.asarray(np.searchsorted(highest, self.folding.origin[representatives]))

    @cached_property
    def _along(self) -> Array:
        """(3, nodes, sites) components at these nodes from those at the representative places."""
        on_nodes = along_rim(self.topology.plan)[self._nodes, : self.topology.rim_nodes]
        along = np.zeros((3, self.sites, len(self._nodes)))
        signs = self.rim.sign[self.symmetry_class]
        for component in range(3):
            np.add.at(along[component], self.rim.node, (on_nodes * signs[:, component]).T)
        return along.transpose(0, 2, 1)

    @cached_property
    def _behind(self) -> tuple[Ints, Array]:
        """(levels,) level of the class for each level of the trace, and (levels, 3) signs of components."""
        level, middle = np.arange(self.levels), self.folding.middle[self.symmetry_class]
        if not middle:
            return level, np.ones((self.levels, 3))
        away = level - level[::-1]
        sign = np.where(away[:, None] < 0, self.sign_of_image, 1.0)
        # a component equal to its opposite is zero in the plane itself
        sign[away == 0] = self.sign_of_image > 0
        return np.maximum(level, level[::-1]) - self.levels // 2, sign

    @property
    def sign_of_image(self) -> Array:
        """(3,) signs of the components of the class after the mirror in the middle plane."""
        return np.asarray(self.folding.middle[self.symmetry_class] * THROUGH, dtype=float)

    @property
    def own_levels(self) -> int:
        """Number of levels with unknowns of the class."""
        return int(self._behind[0].max()) + 1

    @cached_property
    def kept(self) -> Ints:
        """(b,) numbers of the class's unknowns among (level, representative place, component)."""
        alive = self.rim.sign[self.symmetry_class][self.rim.origin] != 0
        return np.flatnonzero(alive & (self._behind[1][-self.own_levels :, None] != 0))

    @cached_property
    def number(self) -> Ints:
        """(t,) class's unknown for each unknown of the whole trace (0 where its sign is 0)."""
        numbers = np.zeros(self.own_levels * self.sites * 3, dtype=np.int64)
        numbers[self.kept] = np.arange(len(self.kept))
        return np.asarray(
            numbers.reshape(self.own_levels, self.sites, 3)[self._behind[0]][:, self.rim.node].ravel()
        )

    @cached_property
    def sign(self) -> Array:
        """(t,) sign of each unknown of the whole trace relative to that of the class."""
        sign = self.rim.sign[self.symmetry_class].astype(float)
        return np.asarray((self._behind[1][:, None] * sign).ravel())

    @cached_property
    def images(self) -> Array:
        """(b,) number of unknowns of the whole trace that each unknown of the class represents."""
        return np.bincount(self.number, np.abs(self.sign), minlength=len(self.kept)).astype(float)

    def fold(self, whole: NDArray[Any]) -> NDArray[Any]:
        """(b, k) share of a whole trace (t, k) that has this symmetry."""
        out = np.zeros((len(self.kept), whole.shape[1]), dtype=whole.dtype)
        np.add.at(out, self.number, whole * self.sign[:, None])
        return np.asarray(out / self.images[:, None])

    @cached_property
    def spread(self) -> sp.csr_array:
        """(t, b) linear forms on the whole trace from those on the class, 0 on other classes."""
        size = len(self.number)
        values = self.sign / self.images[self.number]
        return sp.csr_array((values, self.number, np.arange(size + 1)), shape=(size, len(self.kept)))

    def unfold_form(self, own: Array) -> Array:
        """(t, t) symmetric form on the whole trace that equals ``own`` (b, b) on the class, 0 on others."""
        return np.asarray(self.spread @ (self.spread @ own).T)

    def unfold_rows(self, own: Array) -> Array:
        """(t, k) linear forms on the whole trace from (b, k) on the class."""
        return np.asarray(self.spread @ own)

    def on_levels(self, through: Array, own: NDArray[Any]) -> NDArray[Any]:
        """(rim size, 3, k) values on the mesh's rim from the class's trace unknowns (b, k)."""
        trace = np.zeros((self.own_levels * self.sites * 3, own.shape[1]), dtype=own.dtype)
        trace[self.kept] = own
        behind, sign = self._behind
        count = own.shape[1]
        trace = trace.reshape(self.own_levels, self.sites, 3, count)[behind] * sign[:, None, :, None]
        around = np.moveaxis(self._along @ trace.transpose(0, 2, 1, 3), 1, 2)
        upper = through[-len(self.topology.upper_rim) :]
        rim = np.tensordot(upper, around.reshape(self.levels, 3 * len(self._nodes) * count), axes=1)
        return rim.reshape(self.rim_size, 3, count)


@dataclass(frozen=True, eq=False)
class TraceOperation:
    """Mirror or half-turn of whole traces: ``(R b)(x) = turn b(R^-1 x)``.

    sites : (sites,) place of the rim whose motion each place has afterwards; turn : (3, 3)
    levels : nodes through the thickness
    """

    sites: Ints
    turn: Array
    levels: int

    @classmethod
    def of(cls, tile: TileShape, topology: Topology, levels: int, turn: Array) -> TraceOperation:
        """Make it from an operation (3, 3) on space that is its own inverse and leaves the tile unchanged."""
        sides = tile.moved_sides(turn)
        assert sides is not None, "the operation is not a symmetry of this tile"
        return cls(np.argsort(topology.moved_rim(sides)), turn, levels)

    def applied(self, trace: NDArray[Any]) -> NDArray[Any]:
        """Image of (t, k) traces, or of the rows (t, k) of linear forms on them."""
        moved = trace.reshape(self.levels, len(self.sites), 3, -1)[:, self.sites]
        return np.asarray(self.turn @ moved).reshape(trace.shape)
