"""From the accuracy asked for to a mesh: nobody has to choose one, and an expert can."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.cell import MeshPlan, Period, Pillar, Stack, TileShape, UnitCell
from haptonic.cell.edges import between_edges, is_unbridged
from haptonic.cell.orders import USUAL_BANDS, orders_for_bands
from haptonic.cell.pieces import Meshed, pieces_of
from haptonic.parallel import threads
from haptonic.superelement.symmetry import THIRD, folds_of
from haptonic.superelement.trace import trace_levels

MEASURED = {(3, 1): 0.55, (4, 1): 0.45, (5, 1): 0.75, (5, 2): 0.35, (6, 2): 0.6}  # see `remaining`
# The same with one ring for tiles that have other than four sides, by order, with a sharp foot and with a
# fillet. Several elements share a quarter turn there, and one order fewer leaves a small smooth part: the
# edge leads earlier. `benchmarks/estimates_hold.py --tiles` measures which factor each order needs.
OF_BLOCKS = {3: 0.45, 4: 0.7, 5: 1.1}
OF_BLOCKS_ROUNDED = {3: 0.3, 4: 0.45, 5: 0.75}
# What these get more from order 4 on, as a share for each order that many bands bring, until the edge leads
FOR_BANDS = 0.6
# Least of these where a fillet leaves out the elements that would lead from its arc to what is far wider: a
# single one from there to the middle of a wide pillar on a thin plate left 1.3 %, of which 0.38 was needed
UNBRIDGED = 0.55
ON_THIN = {3: 0.3, 4: 0.55}  # the same beside a thin plate: the lower mesh of order 3 loses two orders around
# Of square pillars with a gap less than this share of their half width, so many times as much up to order 4:
# where gaps cross at corners motion changes within their width, and one order fewer around a single element
# tells half of what is left. At 0.07 six of a hundred frequencies needed 1.1 in place of 0.75.
CROSSING, CROSSED = 0.11, 1.4
# Of discs without an edge that the mesh is graded towards, see `benchmarks/discs.py`: of the plate's material
# alone, and with interfaces, at whose ends on a surface stress is weakly singular.
WITHOUT_EDGE, AT_INTERFACES = 0.3, 1.0
WITHIN_PLATE = {3: 0.35, 4: 0.35, 5: 0.5}  # and with edges within the plate only, as of a blind hole
OF_SOLIDS = 0.2  # of curved tetrahedra of a CAD file, refined towards edges; see `benchmarks/solids.py`
# Of solids of a CAD file: unknowns for each element and cube of the order, 0.7 to 1.1 were seen; s and bytes
# for powers of their number: 13,700 took 2 s, 140,000 took 90 s and 8.5 GB, the lower order a third more.
SOLID_UNKNOWNS, SOLID_SECONDS, SOLID_COST, SOLID_BYTES, SOLID_GROWTH = 1.0, 6.5e-7, 1.6, 20.0, 1.7
# Of meshes of others, for each unknown and each of the trace: those of 134 hexahedra to 4458 tetrahedra took
# 56 to 59 bytes and 1.0 to 1.1 us at orders 3 and 4.
MESH_SECONDS, MESH_BYTES = 1.1e-6, 75.0
PER_ANSWER, PER_CUBE, TWICE_FOLDED = 4e-7, 1e-8, 1.5  # s, s and a factor, see `seconds`
# Of the memory: numbers for each unknown that waits, each pair of nodes of an element, each unknown's factor
# and the square of a pencil's size; bytes of the program at rest. See benchmarks/answered_in_budget.py.
PER_KEPT, PER_PAIR, PER_FACTOR, PER_PENCIL, RESIDENT = 1.3, 52.0, 52.0, 92.0, 4e8
BY_THIRDS = 1.5  # times the pairs: parts of a tile that a third of a turn leaves have indices of their own
LEAST_ORDER = 2  # that a study can ask for
LEAST_STEPS, WIDEST = 2, 40  # of an interior's blocks: fewest, and the size from which depth counts
UNRESOLVED = 25.0  # see `Resolution.unresolved`
SHARED = 1.0  # of the bands' relative distance to lower orders, its root mean square, that every band gets


@dataclass(frozen=True)
class Resolution:
    """How finely a cell is computed.

    order : polynomial order of the elements; see `MeshPlan.suited`
    foot_rings : thin rings on either side of the pillar's foot
    steps, block : number and size of the blocks of the interior's Krylov space
    bands : how many the mesh has to resolve
    """

    order: int
    foot_rings: int
    steps: int = LEAST_STEPS
    block: int = 10
    bands: int = USUAL_BANDS

    def for_bands(self, cell: Period, count: int) -> Resolution:
        """The same for so many bands of a cell: a mesh that resolves their waves, and more of the interior.

        Depth counts, not width: of a pillar's sixty bands 2 blocks of 90 lost 10 %, 3 of 60 1 %, 5 of 40
        0.1 %. A tile has its share of the bands inside: for 24 of a Lieb lattice, 6 for each of its tiles,
        blocks for 10 left out 1.2e-4, a thirtieth of what the mesh did.
        """
        if count <= self.bands:
            return self
        own = count * max(one.tile.area for one in cell.tiles) / cell.area
        deeper = max(math.ceil(math.log2(own / self.bands)), 0)
        block = max(self.block, min(round(own), WIDEST))
        return replace(self, steps=self.steps + deeper, block=block, bands=count)

    def grown(self, times: int = 1) -> Resolution:
        """The same with more of the interior: what is left out falls by about ten each time."""
        block = self.block
        for _ in range(times):
            block = block * 3 // 2
        return replace(self, steps=self.steps + times, block=block)

    def plan(self, tile: TileShape, share: float = 1.0) -> MeshPlan:
        """Plan of a tile whose area is a share of the cell's."""
        return MeshPlan.suited(tile, self.order, self.foot_rings, self.bands * share)

    def plans(self, cell: Period) -> tuple[MeshPlan, ...]:
        """Plan of each tile of a cell; their sides meet."""
        tiles = [one.tile for one in cell.tiles]
        return meeting(tiles, [self.plan(tile, tile.area / cell.area) for tile in tiles])

    def lowered(self, cell: Period) -> tuple[MeshPlan, ...]:
        """The same blocks with orders one lower, to tell the error by."""
        tiles = [one.tile for one in cell.tiles]
        plans = [plan.lowered(tile) for plan, tile in zip(self.plans(cell), tiles, strict=True)]
        return meeting(tiles, plans)

    def _meshed(self, cell: Period) -> list[Meshed]:
        """What differs of what is meshed, without the bodies of prisms, which take next to nothing."""
        made = {
            id(one.tile): pieces_of(one.tile, plan)
            for one, plan in zip(cell.tiles, self.plans(cell), strict=True)
        }
        return [piece.without_body() for pieces in made.values() for piece in pieces]

    @property
    def projection_goal(self) -> float:
        """Relative error of a frequency that a small basis may add: little beside what the order leaves."""
        return 1e-4 * 0.4 ** max(self.order - 4, 0)

    def remaining(self, cell: Period) -> float:
        """Error of this resolution as a multiple of its distance to the next lower orders.

        That distance is a band's own plus ``SHARED`` times the root mean square of all. At the re-entrant
        edge (270 degrees) stress grows as r^-0.4555, so on a given mesh the error of a frequency falls as
        order^(-4 * 0.5445) once the edge is all that is left of it. Before that the smooth part still counts,
        the error falls faster, and the factors are measured ones. With order 3 none of 62 designs with a
        pillar on a thick plate needed more than 0.44, none of 66 on a thin one more than 0.15, with order 4
        one of 33 0.44, one on a thin plate beside a narrow neck 0.47, the others 0.23; with order 5 one of 19
        0.32, and a stout drafted one on a thick plate, where the edge leads already, 0.61; with two rings one
        of 4 0.19. They get little to twice as much. With two rings or more the edge never leads up to order
        6, which is taken to hold beyond. A step is another re-entrant edge, towards which the mesh is graded
        as towards the foot; close above a fillet it is not, and the edge is taken to lead from the start. A
        plain plate has no edge: of 24 meshes where bands were resolved one needed 0.11; `unresolved` stands
        for others.

        Many bands bring more orders for the smooth part, so the edge leads earlier. The same stout pillar on
        a thick plate needed 0.38 of order 4 for 10 bands, 0.43 for 12, 0.66 for 15, 0.68 for 20 and 0.78 for
        30, another one 0.87 for 20; of order 5 0.53 to 1.01; of order 3 0.23 to 0.27 where 0.55 are told.
        """
        return max(self._remaining(one.tile, one.tile.area / cell.area) for one in cell.tiles)

    def _remaining(self, tile: TileShape, share: float) -> float:
        pillar = tile.pillar
        if tile.solid is not None:
            return self._of_singular if tile.solid.is_mesh else OF_SOLIDS
        if tile.stack is not None:
            return self._of_stack(tile.stack)
        if pillar is None:
            return 0.15
        narrow = bool(len(pillar.outline.flats)) and tile.clearance < CROSSING * pillar.widest
        factor = self._of_edge(tile, pillar)
        if is_unbridged(tile, self.foot_rings):
            factor = max(factor, UNBRIDGED)
        if self.order > 3:
            finer = orders_for_bands(tile, self.bands * share) - orders_for_bands(tile, USUAL_BANDS * share)
            factor = min(factor * (1.0 + FOR_BANDS * max(finer, 0.0)), max(factor, self._of_edge_alone))
        return factor * CROSSED if narrow and self.order < 5 else factor

    def _of_stack(self, stack: Stack) -> float:
        """The same for discs: as of a pillar's foot where stress is singular at an edge."""
        if stack.has_corners:
            return self._of_edge_alone
        if not stack.singular.any():
            return AT_INTERFACES if len(stack.solids) else WITHOUT_EDGE
        rings = min(self.foot_rings, 2)
        if rings == 1 and self.order in WITHIN_PLATE and not stack.singular[:, stack.in_plate :].any():
            return WITHIN_PLATE[self.order]
        return MEASURED.get((self.order, rings), MEASURED[6, 2] if rings == 2 else self._of_edge_alone)

    @property
    def _of_edge_alone(self) -> float:
        """The factor once a re-entrant edge is all that is left of the error."""
        return max(self._of_singular, 1.3)

    @property
    def _of_singular(self) -> float:
        """The factor where orders grow on one mesh and the error falls as order^(-4 * 0.5445).

        Meshes of others with a pillar of 3 mm at a pitch of 7 mm, of elements of 1 mm to 3 mm, needed 0.08
        with order 2, 0.41 with order 3 and 0.71 with order 4.
        """
        return 1.0 / float((self.order / (self.order - 1)) ** (4 * 0.5445) - 1.0)

    def _of_edge(self, tile: TileShape, pillar: Pillar) -> float:
        if pillar.step is not None and pillar.fillet and between_edges(tile) is None:  # it is not graded
            return self._of_edge_alone
        if self.foot_rings >= 2:
            return MEASURED.get((self.order, 2), MEASURED[6, 2])
        if len(tile.corners) != 4 and self.foot_rings:
            factors = OF_BLOCKS_ROUNDED if pillar.fillet else OF_BLOCKS
            return factors.get(self.order, self._of_edge_alone)
        if tile.is_thin and self.order in ON_THIN:
            return ON_THIN[self.order]
        return MEASURED.get((self.order, self.foot_rings), self._of_edge_alone)

    def unresolved(self, cell: Period) -> float:
        """What `remaining` gets more for each relative distance of a plain plate's band.

        Without an edge each order divides the error, by the more the better a wave is resolved. A band that
        was 0.013 from order 4 needed 0.27 of it at order 5, one that was 0.029 from order 3 0.58 at order 4.
        """
        return 0.0 if cell.has_features else UNRESOLVED

    def estimate(self, cell: Period, frequency: Array, distance: Array, moving: Bools) -> Array:
        """(k,) Hz, errors of frequencies (k,) by the mesh, from their distance to the next lower orders.

        moving : which of them are no rigid motion
        """
        # A band may come out alike in both by chance, hence a share of what others are apart. Their mean is
        # too little where few bands are far apart, and the one that is alike is of their kind.
        relative = np.divide(distance, frequency, out=np.zeros_like(distance), where=moving)
        others = math.sqrt(np.sum(relative[moving] ** 2) / max(np.count_nonzero(moving), 1))
        error = self.remaining(cell) * (distance + SHARED * others * frequency)
        return np.asarray(error + self.unresolved(cell) * distance * relative)

    def memory(self, cell: Period) -> float:
        """Estimate of the peak memory, bytes; `benchmarks/answered_in_budget.py` measures it.

        The largest piece has its element matrices and its factors while others wait condensed; the rest is
        for dense matrices of all tiles together.
        """
        if isinstance(cell, UnitCell) and cell.solid is not None:
            if cell.solid.is_mesh:
                return RESIDENT + MESH_BYTES * self._mesh_fields(cell)
            return float(RESIDENT + SOLID_BYTES * self._solid_unknowns(cell) ** SOLID_GROWTH)
        waiting = working = 0.0
        for piece in self._meshed(cell):
            plan, classes = piece.plan, 2 ** len(folds_of(piece.tile))
            of_class = 3 * sum(plan.level_sizes) / classes  # unknowns
            trace = piece.boundary(plan.upward + 1) / classes
            waiting += classes * of_class * (trace + 13 + self.steps * self.block)
            across, along, upward = plan.outward + 1, plan.order + 1, plan.upward + 1
            pairs = of_class * (across * along + along * upward + across * upward)
            pairs *= BY_THIRDS if piece.tile.has_symmetry(THIRD) else 1.0
            factors = min(threads(), classes) * of_class ** (4 / 3)
            working = max(working, PER_PAIR * pairs + PER_FACTOR * factors)
        return RESIDENT + 8.0 * (PER_KEPT * waiting + working + PER_PENCIL * self._pencil(cell) ** 2)

    def _solid_unknowns(self, cell: UnitCell) -> float:
        """Unknowns of the elements of a CAD file or mesh."""
        return SOLID_UNKNOWNS * cell.solid_period.elements * (1 + self.plan(cell).foot_rings) * self.order**3

    def _mesh_fields(self, cell: UnitCell) -> float:
        """Unknowns of the elements of a mesh of others, times those of the trace."""
        plan = self.plan(cell)
        return self._solid_unknowns(cell) * 3 * plan.sides * plan.side * trace_levels(plan)

    def _pencil(self, cell: Period) -> int:
        """Size of the condensed pencil of all tiles."""
        directions = 4 * self.steps * self.block
        return sum(
            plan.sides * 3 * plan.side * trace_levels(plan) // 2 + directions for plan in self.plans(cell)
        )

    def seconds(self, cell: Period) -> float:
        """Estimate of the processor time of a model, its coarse one included, s.

        Static answers to the trace and the interior's blocks lead: as many as there are of these, times the
        nodes of what is meshed. Fourteen cells of orders 3 to 6, plates of 0.005 to 0.35 pitches, took 0.24
        to 0.42 us for each. Six cells with pillars on both faces, and twice as many symmetry classes, took
        1.4 to 1.7 times as long. With many bands it is the condensed pencil, whose modes at two dozen
        wavevectors make the small basis: 6 to 18 ns for the cube of its size, of 600 to 1,600.
        """
        if isinstance(cell, UnitCell) and cell.solid is not None:
            if cell.solid.is_mesh:
                return MESH_SECONDS * self._mesh_fields(cell)
            return float(SOLID_SECONDS * self._solid_unknowns(cell) ** SOLID_COST)
        needed, directions = 0.0, 4 * self.steps * self.block
        for piece in self._meshed(cell):
            answers = piece.boundary(piece.plan.plate_levels) + directions
            # what is folded less has as many answers in all, each of more unknowns
            folded = 4 / 2 ** len(folds_of(piece.tile)) * (TWICE_FOLDED if piece.tile.is_mirrored else 1.0)
            needed += PER_ANSWER * sum(piece.plan.level_sizes) * answers * folded
        return needed + PER_CUBE * self._pencil(cell) ** 3


def meeting(tiles: Sequence[TileShape], plans: Sequence[MeshPlan]) -> tuple[MeshPlan, ...]:
    """Plans of tiles with the same nodes on common sides: as many as any of them needs.

    The same of the levels of their traces; a plain plate gets as many orders through it. Beside solids of a
    file, whose elements can follow no more than their own plan says, plain plate has just as many.
    """
    if len(plans) == 1:
        return tuple(plans)
    given = [plan for tile, plan in zip(tiles, plans, strict=True) if tile.solid is not None]
    if given:
        return tuple(
            plan if tile.solid is not None else fitted(plan, given[0])
            for tile, plan in zip(tiles, plans, strict=True)
        )
    blocks = math.lcm(*(plan.blocks for plan in plans))
    order = max(plan.divided(blocks, 0).order for plan in plans)
    levels = max(trace_levels(replace(plan, levels=0)) for plan in plans)
    return tuple(
        replace(
            plan,
            blocks=blocks,
            order=order,
            levels=levels,
            upward=plan.upward if plan.plate_levels >= levels else levels - 1,
        )
        for plan in plans
    )


def fitted(plain: MeshPlan, other: MeshPlan) -> MeshPlan:
    """The plan of a plain tile with just the nodes on common sides that a tile of another plan has."""
    levels = trace_levels(other)
    return replace(plain, blocks=other.blocks, order=other.order, levels=levels, upward=levels - 1)


# Each rung costs about twice the one before; orders grow, the foot is graded further.
LADDER = (
    Resolution(3, 1),
    Resolution(4, 1),
    Resolution(5, 1),
    Resolution(5, 2, 3),
    Resolution(6, 2, 3, 24),
    Resolution(6, 3, 3, 24),
    Resolution(7, 3, 3, 24),
    Resolution(8, 4, 4, 24),
    Resolution(10, 4, 4, 24),
)
