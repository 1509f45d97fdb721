"""Resolution and topology of a mesh, chosen before any length is known."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from haptonic.arrays import Bools
from haptonic.cell.blocks import VOID, Grid, StackBlocks, curves_of_levels
from haptonic.cell.divided import blocks_of
from haptonic.cell.edges import bridges
from haptonic.cell.orders import (
    ROUNDING,
    around_quarter,
    divided_order,
    is_thick,
    layers_along,
    levels_near_rim,
    neck_of,
    order_on,
    orders_for_bands,
    pieces_of_sides,
    trace_error,
)
from haptonic.cell.pillar import Pillar
from haptonic.cell.sectors import least_blocks
from haptonic.cell.stack import Stack
from haptonic.cell.tile import TileShape

# Factor on the orders around the pillar on a thin plate, because waves between pillars are shorter. With
# eight orders the error of a tenth band was 2.5 %, with nine 0.2 %: fields of its parity gain nothing from an
# even order.
SHORT_WAVES = 3 / 2
SHEET_WAVES = 5 / 3  # the same on a sheet
SHEET_NECK = 0.7  # like `WIDE_NECK`, on a sheet
THIN_NECK = 0.46  # and on a thin plate: with one order fewer the error was 0.7 %, for an estimate of 0.3 %
# Length of the neck between two pillars, in half pitches, that a quarter turn's order is enough for. At 0.36
# the error with seven orders was 0.2 %, with eight 0.07 %.
WIDE_NECK = 0.5
# Additional orders along a pillar that is meshed to its top, where three leave errors of at most 0.015 %
ALONG_MORE = 5
# Largest length of an element through the plate, whose strain below the foot decays over the pillar's width,
# in diameters. With one layer in a plate of 1.8 diameters the error at orders 3 and 4 was 0.1 %, with two
# 0.03 %. If layers grow from the foot's thin ones downwards, the error of two is 3e-5 for six diameters.
PLATE_LAYER, MOST_BELOW_BRIDGES = 1.0, 2
# Like `WIDE_NECK`, between discs of a stack where the whole plate bends: between holes, or on a thin plate.
# For eleven plates of 0.02 to 0.14 pitches with holes of 0.5 to 0.9 pitches, errors of this direction were
# 4e-5 to 6e-4 at order 4, and at most 1e-3 for four inclusions in plates of 0.02 pitches.
BENT_NECK = 0.9
# Like `WIDE_NECK`, for discs of other materials in the plate. For inclusions and rings of epoxy and steel the
# estimated error of this direction was 1.3e-3 to 1.9e-3 at order 4 with 0.5, four to ten times that of the
# others, and that of all was down to 1.3 times the true error. With 0.76 they are similar.
FILLED_NECK = 0.76
LEAST_DIVIDED = 3  # order of elements divided at an outline's corners
# The same around discs. With 4 the two polynomials of a kind that the estimate compares are of degree 4 and
# 2, and it was 50 times the error around a square hole.
LEAST_COMPARED = 5


@dataclass(frozen=True)
class MeshPlan:
    """Resolution and topology of a mesh, without any lengths.

    order : polynomial order of each element around the pillar and in the core; see `per_quarter`
    foot_rings : thin rings on either side of the pillar's foot, and as many thin layers
    pillar_layers : layers of elements along the pillar above the thin ones, up to its step if it has one; 0
        for no pillar
    step_layers : layers above the step; 0 for no step
    step_rings : thin rings on either side of the step's edge, and as many thin layers
    bridges : rings inside and outside, layers above and below, between the foot's thin ones and the rest
    blocks : elements along each side of the cell, and along each quarter of every ring
    plate_layers : layers through the plate below the thin ones
    near_rim : additional levels of the trace on the rim through the plate, see `trace_levels`
    sides : number of sides of the polygon
    stack : blocks of a stack of discs, instead of a pillar's
    levels : nodes of the trace through the thickness, if tiles of other plans have to match; 0 for its own
    rim : number of equal pieces of each side and order of the trace on them; (0, 0) for those of the mesh
    outward : polynomial order across the rings; 0 for ``order``
    upward : along z through the plate; 0 for ``order``
    along : along z in the pillar; 0 for ``upward``
    thin : across thin rings and thin layers; 0 for ``order``
    """

    order: int
    foot_rings: int
    pillar_layers: int
    step_layers: int = 0
    step_rings: int = 0
    bridges: tuple[int, int, int, int] = (0, 0, 0, 0)
    blocks: int = 1
    plate_layers: int = 1
    outward: int = 0
    upward: int = 0
    thin: int = 0
    along: int = 0
    near_rim: int = 0
    sides: int = 4
    levels: int = 0
    rim: tuple[int, int] = (0, 0)
    stack: StackBlocks | None = None

    def __post_init__(self) -> None:
        for name in ("outward", "upward", "thin"):
            object.__setattr__(self, name, getattr(self, name) or self.order)
        object.__setattr__(self, "along", self.along or self.upward)
        if math.prod(self.rim) >= self.side:
            object.__setattr__(self, "rim", (0, 0))

    @classmethod
    def suited(cls, cell: TileShape, order: int, foot_rings: int, bands: float | None = None) -> MeshPlan:
        """Choose a plan for a cell with any number of sides.

        If the cell does not have four sides, each has two blocks, because patches of the core end in the
        middle of sides. They span less than a quarter turn, for which a polynomial of their share of a
        quarter's order plus one has the same error.
        """
        if cell.solid is not None:  # a plan of the lateral faces; the inside is meshed elsewhere
            sides = len(cell.corners)
            if cell.solid.is_mesh:  # it is never refined; elements may cross the middles of sides
                return cls(2 * order, 0, 0, upward=order, sides=sides, levels=order + 1)
            return cls(order, foot_rings, 0, blocks=2, sides=sides, levels=order + 1)
        plan = cls._of_quarters(cell, order, foot_rings, bands)
        sides = len(cell.corners)
        if sides != 4:
            share = plan.side * 4 / sides / 2
            plan = replace(plan, sides=sides, blocks=2, order=math.ceil(share) + 1)
        blocks = least_blocks(cell, plan.blocks, plan.thin_around) or plan.blocks
        least = max(plan.outward, LEAST_COMPARED) if plan.stack else LEAST_DIVIDED
        if blocks == plan.blocks:
            return plan
        return replace(plan.divided(blocks, least), rim=pieces_of_sides(cell, order, plan.side))

    @property
    def foot(self) -> MeshPlan:
        """A copy with one layer along the pillar above the thin ones; a prism continues without a mesh."""
        return replace(self, pillar_layers=1)

    def divided(self, pieces: int, least: int) -> MeshPlan:
        """A copy with elements and a trace that end at equal pieces of each side, of at least some order."""
        blocks = math.lcm(self.blocks, pieces)
        if blocks == self.blocks:
            bends_there = self.on_sides[0] % pieces == 0
            return self if bends_there else replace(self, rim=(0, 0))
        return replace(
            self, blocks=blocks, order=max(order_on(blocks, self.blocks, self.order), least), rim=(0, 0)
        )

    @classmethod
    def _of_quarters(cls, cell: TileShape, order: int, foot_rings: int, bands: float | None) -> MeshPlan:
        """Plan with similar errors in all directions, and elements not much longer than the pillar is wide.

        More bands than usual have shorter waves: a polynomial needs pi orders for each wave along it before
        it resolves anything, and gets as many more. Across the rings it gets half of them, rounded up: with
        one fewer, the error of a tenth band on a thin rectangular plate was 0.4 %, because fields of one
        parity gain nothing from every other order.

        Around the pillar an element spans a quarter turn and gets two orders more, and still more if a neck
        between round pillars that nearly touch is a small part of it. Away from the edge, order 3 has quartic
        elements: cubic ones are too stiff along a pillar that bends and across the plate beside it, by more
        than all other errors together; the same holds for plain plate beside tiles with pillars. With five
        orders instead of six around it, the error of the tenth band of every third design was 0.7 to 3 %;
        with six 0.2 to 0.5 %. On a thin plate elements have one order more, because low orders lock. Along a
        pillar that is not a prism, and therefore is meshed to its top, all elements get `ALONG_MORE` orders
        more, because bending of a slender pillar has the largest error there.
        """
        shorter = orders_for_bands(cell, bands) if bands else 0.0
        more = math.ceil(shorter - ROUNDING)
        if cell.meshed_stack is not None:
            return cls._of_stack(cell, cell.meshed_stack, order, foot_rings, shorter)
        smooth = 4 if order == 3 else order
        if cell.pillar is None:
            sheet = cell.is_sheet  # its error was 1.5 % in order 4, and 0.6 % in one more
            around = round((order + 2) * SHEET_WAVES) if sheet else order + 2
            around, blocks = divided_order(around + more + bool(more))
            outward = (order + 3 if sheet else smooth) + more // 2
            # For a plate as thick as half its pitch, with Poisson ratio 0.44, the error was 2.8e-2 with order
            # 3 through it, 6e-4 with 4, 2.4e-4 with 5 and nothing with 6.
            upward = order + order % 2 if order > 4 else smooth
            return cls(around, 0, 0, blocks=blocks, outward=outward, upward=upward, thin=order)
        if cell.is_sheet:
            return cls._of_sheet(cell, cell.pillar, order, foot_rings, shorter)
        neck = (THIN_NECK if cell.is_thin else WIDE_NECK) / neck_of(cell, cell.pillar)
        turn = (smooth + 2) * max(1.0, neck) * (SHORT_WAVES if cell.is_thin else 1.0)
        around, blocks = around_quarter(turn, more)
        layers = layers_along(cell.pillar)
        rings = max(foot_rings, 1) if cell.pillar.fillet else foot_rings  # the arc is an edge of elements
        bridging = bridges(cell, rings)
        below = math.ceil((1 - ROUNDING) * cell.thickness / (PLATE_LAYER * 2 * cell.pillar.radius))
        return cls(
            around,
            rings,
            layers[0],
            layers[1] if cell.pillar.step else 0,
            step_rings=foot_rings if cell.pillar.step and not cell.pillar.fillet else 0,
            bridges=bridging,
            blocks=blocks,
            plate_layers=min(below, MOST_BELOW_BRIDGES) if bridging[3] else below,
            outward=smooth + cell.is_thin + math.ceil(more / 2),
            upward=smooth,
            along=smooth if cell.pillar.is_prism else smooth + ALONG_MORE,
            thin=order,
            near_rim=levels_near_rim(cell),
        )

    @classmethod
    def _of_sheet(
        cls, cell: TileShape, pillar: Pillar, order: int, foot_rings: int, shorter: float
    ) -> MeshPlan:
        """Plan for a plate that is thin relative to everything else: fine in its plane, coarse through it.

        With the plans of thicker plates, the smooth part has the error. On a plate of 1/200 of the pitch the
        error of the plan of order 4 was 0.3 %, with seven orders across the rings instead of five 0.1 %, with
        ten around instead of eight 0.025 %. Through the plate the order is at least four: on a plate of 0.04
        pitches the error with three was 0.04 %, because low orders lock. The error of twenty bands with ten
        orders around was 0.5 %; ``shorter`` is the number of additional orders that their waves need.
        """
        layers = layers_along(pillar)
        neck = neck_of(cell, pillar, 0.5 * cell.inradius)
        around, blocks = around_quarter((order + 2) * SHEET_WAVES * max(1.0, SHEET_NECK / neck), shorter)
        return cls(
            around,
            foot_rings,
            layers[0],
            layers[1] if pillar.step else 0,
            step_rings=foot_rings if pillar.step else 0,
            bridges=bridges(cell, foot_rings),
            blocks=blocks,
            outward=order + 3 + int(shorter) // 2,
            upward=max(order - 1, 4),
            thin=order,
            along=max(order, 4) + (0 if pillar.is_prism else ALONG_MORE),
        )

    @classmethod
    def _of_stack(
        cls, cell: TileShape, stack: Stack, order: int, foot_rings: int, shorter: float
    ) -> MeshPlan:
        """Plan for a stack of discs, which is meshed to its top.

        Away from edges it has one order more than thin elements: around a hole stress varies faster than
        below a pillar.
        """
        smooth = order + 1
        is_bent = stack.is_void_at_rim or cell.is_thin
        wide = BENT_NECK if is_bent else FILLED_NECK if stack.fills_plate else WIDE_NECK
        neck = wide / neck_of(cell, stack, 0.5 * cell.inradius if cell.is_sheet else 0.0)
        around, blocks = around_quarter((smooth + 2) * max(1.0, neck), math.ceil(shorter - ROUNDING))
        upward = smooth - (stack.mirrored and not cell.is_mirrored)  # half of a plate needs one order less
        return cls(
            around,
            0,
            0,
            blocks=blocks,
            outward=smooth + math.ceil(shorter / 2),
            upward=upward,
            along=smooth + 1,
            thin=order,
            near_rim=max(
                levels_near_rim(cell) if stack.singular.any() else 0,
                0 if cell.is_thin else smooth - upward,
            )
            + is_thick(cell),
            stack=blocks_of(cell, stack, foot_rings),
        )

    def lowered(self, cell: TileShape) -> MeshPlan:
        """The same blocks with orders one lower."""
        if cell.solid is not None:
            return MeshPlan.suited(cell, self.upward - 1, self.foot_rings)
        orders = {name: getattr(self, name) for name in ("order", "outward", "upward", "along", "thin")}
        return replace(self, **{name: max(order - 1, 1) for name, order in orders.items()})

    @property
    def thin_around(self) -> int:
        """Thin blocks on either side of a corner of an outline with singular stress."""
        return self.stack.around if self.stack else 0

    @property
    def side(self) -> int:
        """Steps from node to node along a side of the cell."""
        return self.order * self.blocks

    @property
    def rim_nodes(self) -> int:
        """Number of places of the trace around the rim."""
        return self.sides * math.prod(self.on_sides)

    @property
    def on_sides(self) -> tuple[int, int]:
        """Number of equal pieces of each side and order of the trace on them."""
        return self.rim if self.rim[0] else (self.blocks, self.order)

    @property
    def rim_error(self) -> float:
        """Relative error of frequencies due to fewer places on the rim than the mesh has nodes there."""
        return trace_error(self.thin) if self.rim[0] else 0.0

    @property
    def per_quarter(self) -> int:
        """Order around a quarter turn of the single element there that resolves as much as its blocks.

        It is the inverse of `suited`, `divided` and `divided_order`: blocks have their share of it plus one.
        """
        blocks = self.blocks * self.sides
        return self.order if blocks == 4 else (self.order - 1) * blocks // 4

    @property
    def around(self) -> int:
        """Nodes on every ring, and of the mesh on the rim."""
        return self.side * self.sides

    @property
    def core_size(self) -> int:
        """Nodes within the core's outline: of a square grid, or of a patch for each corner of the cell."""
        return 1 + self.sides * self.side * (self.side - 2) // 4

    @property
    def tip_rings(self) -> tuple[int, ...]:
        """Order across each ring from the core to the side of the pillar above its step."""
        return (self.outward, *(self.thin,) * self.step_rings) if self.step_layers else ()

    @property
    def disc_rings(self) -> tuple[int, ...]:
        """Order across each ring from the core to the foot."""
        inside = self.bridges[0] + self.foot_rings
        return (*self.tip_rings, *(self.thin,) * self.step_rings, self.outward, *(self.thin,) * inside)

    @property
    def rings(self) -> tuple[int, ...]:
        """Order across each ring from the core to the sides of the cell."""
        if self.stack:
            return tuple(
                order for annulus in self.stack.annuli for order in annulus.orders(self.outward, self.thin)
            )
        return (*self.disc_rings, *(self.thin,) * (self.foot_rings + self.bridges[1]), self.outward)

    @property
    def plate_layer_orders(self) -> tuple[int, ...]:
        """Order through each layer of the plate, from the flat face up."""
        if self.stack:
            storeys = self.stack.storeys[: self.stack.in_plate]
            return tuple(order for storey in storeys for order in storey.orders(self.upward, self.thin))
        return (*(self.upward,) * self.plate_layers, *(self.thin,) * (self.bridges[3] + self.foot_rings))

    @property
    def foot_layer_orders(self) -> tuple[int, ...]:
        """Order through each layer from the plate's top to the pillar's step, or to its top."""
        if self.stack:
            storeys = self.stack.storeys[self.stack.in_plate :]
            return tuple(order for storey in storeys for order in storey.orders(self.along, self.thin))
        if not self.pillar_layers:
            return ()
        thin = self.foot_rings + self.bridges[2]
        return (*(self.thin,) * thin, *(self.along,) * self.pillar_layers, *(self.thin,) * self.step_rings)

    @property
    def step_layer_orders(self) -> tuple[int, ...]:
        """Order through each layer above the step."""
        return (*(self.thin,) * self.step_rings, *(self.along,) * self.step_layers)

    @property
    def layer_orders(self) -> tuple[int, ...]:
        """Order through every layer, from the flat face up."""
        return (*self.plate_layer_orders, *self.foot_layer_orders, *self.step_layer_orders)

    @property
    def plate_levels(self) -> int:
        """Node levels from the flat face up to the plate's top, both counted."""
        return sum(self.plate_layer_orders) + 1

    @property
    def grid(self) -> Grid:
        """(layers, 1 + rings) numbers of all blocks, see `haptonic.cell.blocks`; 1 is a pillar's material."""
        if self.stack:
            return self.stack.divided()
        count = len(self.rings)

        def layer(inner: int) -> tuple[int, ...]:
            return (*(1,) * (1 + inner), *(VOID,) * (count - inner))

        return (
            *((0,) * (1 + count),) * len(self.plate_layer_orders),
            *(layer(len(self.disc_rings)),) * len(self.foot_layer_orders),
            *(layer(len(self.tip_rings)),) * len(self.step_layer_orders),
        )

    @property
    def curves(self) -> Bools:
        """(levels, curves) True where a level has nodes; see `curves_of_levels`."""
        return curves_of_levels(self.grid, self.rings, self.layer_orders)

    @property
    def level_sizes(self) -> tuple[int, ...]:
        """Number of nodes on each level."""
        core, around = self.curves[:, 0], self.curves[:, 1:].sum(axis=1)
        return tuple((self.core_size * core + self.around * around).tolist())
