"""Resolution and topology of a mesh, chosen before any length is known."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from haptonic.cell.geometry import UnitCell

LAYER_LENGTH = 1.4  # of an element along the pillar, in diameters
# Orders more along a pillar that is meshed to its top. With none, a pillar of 6 deg draft, 1.4 diameters to
# an element, lost 0.23 % at orders 3 and 4, four fifths of it there; a shaft's polynomials are finer than
# that anyway.
ALONG_MORE = 2
# Most of the same through the plate, whose strain below the foot dies out over the pillar's width. A plate of
# 1.8 diameters in one layer lost 0.1 % at orders 3 and 4, which no lower order told; two layers leave 0.03 %.
PLATE_LAYER = 1.0


@dataclass(frozen=True)
class MeshPlan:
    """Resolution and topology of a mesh, free of any length.

    order : polynomial order of the elements around the pillar and in the core
    foot_rings : thin rings on either side of the pillar's foot, and as many thin layers
    pillar_layers : layers of elements along the pillar above the thin ones, up to its step if it has one; 0
        means no pillar
    step_layers : layers above the step; 0 means no step
    blocks : elements along each side of the cell, and along each quarter of every ring
    plate_layers : layers through the plate below the thin ones
    outward : polynomial order across the rings; upward : along z through the plate; along : along z in the
        pillar; thin : across thin rings and thin layers; 0 means as ``order``, along as ``upward``
    """

    order: int
    foot_rings: int
    pillar_layers: int
    step_layers: int = 0
    blocks: int = 1
    plate_layers: int = 1
    outward: int = 0
    upward: int = 0
    thin: int = 0
    along: int = 0

    def __post_init__(self) -> None:
        for name in ("outward", "upward", "thin"):
            object.__setattr__(self, name, getattr(self, name) or self.order)
        object.__setattr__(self, "along", self.along or self.upward)

    @classmethod
    def suited(cls, cell: UnitCell, order: int, foot_rings: int) -> MeshPlan:
        """Plan of similar errors in all directions, its elements not much longer than the pillar is wide.

        Around the pillar an element spans a quarter turn and gets two orders more. Cubic elements are too
        stiff along a pillar that bends and across the plate beside it, by more than all the rest together:
        there order 3 has quartic ones. Along a pillar that is no prism, and so has no shaft, all get two
        orders more: bending of a slender one would err most of all there.
        """
        orders = {"outward": order, "upward": order, "thin": order}
        if cell.pillar is None:
            return cls(order + 2, 0, 0, **orders)
        if order == 3:
            orders |= {"outward": 4, "upward": 4}
        layers = [
            max(1, round((high - low) / (LAYER_LENGTH * 2 * width)))
            for low, high, width in cell.pillar.stages
        ]
        if cell.pillar.draft or cell.pillar.step:
            orders["along"] = orders["upward"] + ALONG_MORE
        deep = math.ceil(cell.thickness / (PLATE_LAYER * cell.pillar.diameter))
        rings = max(foot_rings, 1) if cell.pillar.fillet else foot_rings  # the arc is an edge of elements
        plan = cls(order + 2, rings, *(1 + count for count in layers), **orders)
        return replace(plan, plate_layers=deep)

    def lowered(self, cell: UnitCell) -> MeshPlan:
        """The same blocks with orders one lower, to tell the error by.

        With a single thin ring the order along z stays through the plate and, where the pillar is a prism,
        along it: what the foot leaves is most of the error then, the thin layer sees it, and thicker elements
        of lower order would err by far more. A pillar with draft or a step is meshed along z up to its top,
        and what that leaves shows at a lower order only. Above a step there is no thin layer either.
        """
        pillar = cell.pillar
        foot_leads = self.foot_rings == 1 and pillar is not None and not pillar.step
        tapered = pillar is not None and pillar.draft != 0
        lower = max(self.upward - 1, 1)
        return replace(
            self,
            order=max(self.order - 1, 1),
            outward=max(self.outward - 1, 1),
            upward=self.upward if foot_leads else lower,
            along=self.along if foot_leads and not tapered else max(self.along - 1, 1),
            thin=max(self.thin - 1, 1),
        )

    @property
    def side(self) -> int:
        """Steps from node to node along a side of the cell."""
        return self.order * self.blocks

    @property
    def step_rings(self) -> tuple[int, ...]:
        """Order across each ring from the core to the side of the pillar above its step."""
        return (self.outward,) if self.step_layers else ()

    @property
    def disc_rings(self) -> tuple[int, ...]:
        """Order across each ring from the core to the foot."""
        return (*self.step_rings, self.outward, *(self.thin,) * self.foot_rings)

    @property
    def rings(self) -> tuple[int, ...]:
        """Order across each ring from the core to the sides of the cell."""
        return (*self.disc_rings, *(self.thin,) * self.foot_rings, self.outward)

    @property
    def plate_layer_orders(self) -> tuple[int, ...]:
        """Order through each layer of the plate, from the flat face up."""
        return (*(self.upward,) * self.plate_layers, *(self.thin,) * self.foot_rings)

    @property
    def foot_layer_orders(self) -> tuple[int, ...]:
        """Order through each layer from the plate's top to the pillar's step, or to its top."""
        if not self.pillar_layers:
            return ()
        return (*(self.thin,) * self.foot_rings, *(self.along,) * self.pillar_layers)

    @property
    def step_layer_orders(self) -> tuple[int, ...]:
        """Order through each layer above the step."""
        return (self.along,) * self.step_layers

    @property
    def layer_orders(self) -> tuple[int, ...]:
        """Order through every layer, from the flat face up."""
        return (*self.plate_layer_orders, *self.foot_layer_orders, *self.step_layer_orders)

    @property
    def plate_levels(self) -> int:
        """Node levels from the flat face up to the plate's top, both counted."""
        return sum(self.plate_layer_orders) + 1

    @property
    def level_sizes(self) -> tuple[int, ...]:
        """Number of nodes on each level; they get fewer above the plate, and above the step."""
        core, around = (self.side + 1) ** 2, 4 * self.side
        pieces = (
            (self.plate_levels, self.rings),
            (sum(self.foot_layer_orders), self.disc_rings),
            (sum(self.step_layer_orders), self.step_rings),
        )
        return tuple(core + around * sum(rings) for levels, rings in pieces for _ in range(levels))
