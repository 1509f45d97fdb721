"""Mesh resolution for a requested accuracy, with its error, time and memory."""

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
# The same with one ring for tiles without four sides, by order, with a sharp foot and with a fillet. Several
# elements share a quarter turn there, and the next lower order has a small smooth error: the edge dominates
# earlier. `benchmarks/estimates_hold.py --tiles` measures which factor each order needs.
OF_BLOCKS = {3: 0.45, 4: 0.7, 5: 1.1}
OF_BLOCKS_ROUNDED = {3: 0.3, 4: 0.45, 5: 0.75}
# Increase of these factors from order 4 on, as a share per order added for many bands, until the edge
# dominates
FOR_BANDS = 0.6
# Least factor if a fillet has no elements of intermediate size between its arc and much wider elements: a
# single element to the middle of a wide pillar on a thin plate had an error of 1.3 %, and a factor of 0.38
UNBRIDGED = 0.55
ON_THIN = {3: 0.3, 4: 0.55}  # for a thin plate: the mesh below order 3 has two orders less around the axis
# For square pillars with a gap below this share of their half width, factors up to order 4 are multiplied:
# where gaps cross at corners motion changes within their width, and the difference to the lower order is half
# of the error. At 0.07, six of a hundred frequencies needed 1.1 instead of 0.75.
CROSSING, CROSSED = 0.11, 1.4
# For discs without an edge with a graded mesh, see `benchmarks/discs.py`: of the plate's material only, and
# with interfaces, at whose ends on a surface stress is weakly singular.
WITHOUT_EDGE, AT_INTERFACES = 0.3, 1.0
WITHIN_PLATE = {3: 0.35, 4: 0.35, 5: 0.5}  # with edges within the plate only, as for a blind hole
OF_SOLIDS = 0.2  # for curved tetrahedra of a CAD file, refined towards edges; see `benchmarks/solids.py`
# For solids of a CAD file: unknowns per element and cube of the order, measured 0.7 to 1.1; time (s) and
# memory (bytes) for powers of their number: 13,700 took 2 s, 140,000 took 90 s and 8.5 GB, the lower order a
# third more.
SOLID_UNKNOWNS, SOLID_SECONDS, SOLID_COST, SOLID_BYTES, SOLID_GROWTH = 1.0, 6.5e-7, 1.6, 20.0, 1.7
# For meshes from files, per unknown and unknown of the trace: meshes of 134 hexahedra to 4458 tetrahedra took
# 56 to 59 bytes and 1.0 to 1.1 us at orders 3 and 4.
MESH_SECONDS, MESH_BYTES = 1.1e-6, 75.0
PER_ANSWER, PER_CUBE, TWICE_FOLDED = 4e-7, 1e-8, 1.5  # s, s and a factor, see `seconds`
# Memory: numbers for each unknown that waits, each pair of nodes of an element, each unknown's factor
# and the square of a pencil's size; bytes of the program at rest. See benchmarks/answered_in_budget.py.
PER_KEPT, PER_PAIR, PER_FACTOR, PER_PENCIL, RESIDENT = 1.3, 52.0, 52.0, 92.0, 4e8
BY_THIRDS = 1.5  # times the pairs: parts of a tile with the third of a turn have separate indices
LEAST_ORDER = 2  # that a study can set
LEAST_STEPS, WIDEST = 2, 40  # of an interior: least number of blocks, and their largest size
UNRESOLVED = 25.0  # see `Resolution.unresolved`
SHARED = 1.0  # share of the root mean square of all relative distances to lower orders, added to each band


@dataclass(frozen=True)
class Resolution:
    """Mesh and interior resolution of a cell.

    order : polynomial order of the elements; see `MeshPlan.suited`
    foot_rings : thin rings on either side of the pillar's foot
    steps, block : number and size of the blocks of the interior's Krylov space
    bands : number of bands that the mesh must resolve
    """

    order: int
    foot_rings: int
    steps: int = LEAST_STEPS
    block: int = 10
    bands: int = USUAL_BANDS

    def for_bands(self, cell: Period, count: int) -> Resolution:
        """Adapt the resolution to a number of bands: finer mesh for their waves, and larger interior.

        More blocks are better than wider ones: for sixty bands of a pillar 2 blocks of 90 had an error of 10
        %, 3 of 60 1 %, 5 of 40 0.1 %. Each tile needs its share of the bands only: for 24 bands of a Lieb
        lattice, 6 per tile, blocks for 10 had a truncation error of 1.2e-4, a thirtieth of the mesh error.
        """
        if count <= self.bands:
            return self
        of_tile = count * max(placed.tile.area for placed in cell.tiles) / cell.area
        deeper = max(math.ceil(math.log2(of_tile / self.bands)), 0)
        block = max(self.block, min(round(of_tile), WIDEST))
        return replace(self, steps=self.steps + deeper, block=block, bands=count)

    def grown(self, times: int = 1) -> Resolution:
        """Enlarge the interior: each time wider blocks, and one more block if they would be too wide.

        Around wide holes and below caps, where the first interior omits most, wider blocks are better: around
        a hole the truncation error fell from 1.8e-2 to 4.9e-4 with 2 blocks of 33, and to 6.8e-4 with 4 of 22
        and a larger pencil. In other cells further blocks are better, but the first wider ones were enough
        for an accuracy of 2e-3: 4.6e-4 instead of 2.3e-3 for pillars on a triangular lattice.
        """
        steps, block = self.steps, self.block
        for _ in range(times):
            steps, block = (steps, block * 3 // 2) if block * 3 // 2 <= WIDEST else (steps + 1, block)
        return replace(self, steps=steps, block=block)

    def plan(self, tile: TileShape, share: float = 1.0) -> MeshPlan:
        """Plan of a tile whose area is a share of the cell's."""
        return MeshPlan.suited(tile, self.order, self.foot_rings, self.bands * share)

    def plans(self, cell: Period) -> tuple[MeshPlan, ...]:
        """Plan of each tile of a cell, with equal nodes on common sides."""
        tiles = [placed.tile for placed in cell.tiles]
        return meeting(tiles, [self.plan(tile, tile.area / cell.area) for tile in tiles])

    def lowered(self, cell: Period) -> tuple[MeshPlan, ...]:
        """Plans with equal blocks and orders lower by one, for the error estimate."""
        tiles = [placed.tile for placed in cell.tiles]
        plans = [plan.lowered(tile) for plan, tile in zip(self.plans(cell), tiles, strict=True)]
        return meeting(tiles, plans)

    def _meshed(self, cell: Period) -> list[Meshed]:
        """Different meshed pieces, without the bodies of prisms, whose cost is negligible."""
        by_tile = {
            id(placed.tile): pieces_of(placed.tile, plan)
            for placed, plan in zip(cell.tiles, self.plans(cell), strict=True)
        }
        return [piece.without_body() for pieces in by_tile.values() for piece in pieces]

    @property
    def projection_goal(self) -> float:
        """Allowed relative error of a frequency due to the small basis, well below that of the mesh."""
        return 1e-4 * 0.4 ** max(self.order - 4, 0)

    def remaining(self, cell: Period) -> float:
        """Error of this resolution as a multiple of its distance to the next lower orders.

        That distance is a band's own plus ``SHARED`` times the root mean square of all. At the re-entrant
        edge (270 degrees) stress grows as r^-0.4555, so on a given mesh the error of a frequency falls as
        order^(-4 * 0.5445) once the edge dominates it. Before that the smooth part contributes, the
        error falls faster, and the factors are measured. Largest ratios of error to distance with order 3:
        0.44 in 62 designs with a pillar on a thick plate, 0.15 in 66 on a thin plate; with order 4: 0.44 in
        33 designs, usually 0.23, and 0.47 on a thin plate with a narrow neck; with order 5: 0.32 in 19
        designs, and 0.61 for a stout pillar with draft on a thick plate, where the edge dominates already;
        with two rings: 0.19 in 4. The factors are up to twice as large. With two rings or more the edge does
        not dominate up to order 6, and this is assumed for higher orders. A step is another re-entrant edge
        with a graded mesh; close above a fillet the mesh is not graded, and the edge is assumed to dominate
        for all orders. A plain plate has no edge: the largest ratio was 0.11 in 24 meshes that resolve the
        bands; `unresolved` covers other meshes.

        Many bands add orders for the smooth part, so the edge dominates earlier. For a stout pillar on a
        thick plate the ratio at order 4 was 0.38 for 10 bands, 0.43 for 12, 0.66 for 15, 0.68 for 20 and 0.78
        for 30, for another pillar 0.87 for 20; at order 5 it was 0.53 to 1.01; at order 3 0.23 to 0.27, with
        a factor of 0.55.
        """
        return max(self._remaining(placed.tile, placed.tile.area / cell.area) for placed in cell.tiles)

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
        """Factor for discs, that of a pillar's foot if stress is singular at an edge."""
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
        """Factor if a re-entrant edge dominates the error."""
        return max(self._of_singular, 1.3)

    @property
    def _of_singular(self) -> float:
        """Factor for an error that falls as order^(-4 * 0.5445) on a given mesh.

        Measured on meshes from files with elements of 1 mm to 3 mm, a pillar of 3 mm and a pitch of 7 mm:
        0.08 with order 2, 0.41 with order 3 and 0.71 with order 4.
        """
        return 1.0 / float((self.order / (self.order - 1)) ** (4 * 0.5445) - 1.0)

    def _of_edge(self, tile: TileShape, pillar: Pillar) -> float:
        if (
            pillar.step is not None and pillar.fillet and between_edges(tile) is None
        ):  # the mesh is not graded
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
        """Increase of `remaining` per relative distance of a plain plate's band.

        Without an edge each order divides the error, by a factor that grows with the resolution of the wave.
        The ratio of error to distance was 0.27 at order 5 for a band at a distance of 0.013 from order 4, and
        0.58 at order 4 for a band at 0.029 from order 3.
        """
        return 0.0 if cell.has_features else UNRESOLVED

    def estimate(self, cell: Period, frequency: Array, distance: Array, moving: Bools) -> Array:
        """(k,) mesh errors of frequencies (k,), from their distance to the next lower orders, Hz.

        moving : (k,) False for rigid motions
        """
        # A band may be equal in both by chance, so a share of the distances of other bands is added. Their
        # mean is too small if few bands differ much, and the equal one is of their kind.
        relative = np.divide(distance, frequency, out=np.zeros_like(distance), where=moving)
        others = math.sqrt(np.sum(relative[moving] ** 2) / max(np.count_nonzero(moving), 1))
        error = self.remaining(cell) * (distance + SHARED * others * frequency)
        return np.asarray(error + self.unresolved(cell) * distance * relative)

    def memory(self, cell: Period) -> float:
        """Estimate of the peak memory, bytes; `benchmarks/answered_in_budget.py` measures it.

        The largest piece needs its element matrices and factors while the other pieces are stored condensed;
        dense matrices of all tiles together need the rest.
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
        """Number of unknowns of the elements of a CAD file or mesh."""
        return SOLID_UNKNOWNS * cell.solid_period.elements * (1 + self.plan(cell).foot_rings) * self.order**3

    def _mesh_fields(self, cell: UnitCell) -> float:
        """Number of unknowns of the elements of a mesh from a file, times those of the trace."""
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

        Static responses to the trace and the interior's blocks dominate: their number times the number of
        nodes. Fourteen cells of orders 3 to 6 with plates of 0.005 to 0.35 pitches took 0.24 to 0.42 us for
        each. Six cells with pillars on both faces, and twice as many symmetry classes, took 1.4 to 1.7 times
        as long. With many bands the condensed pencil dominates, whose modes at two dozen wavevectors form
        the small basis: 6 to 18 ns times the cube of its size, for sizes of 600 to 1,600.
        """
        if isinstance(cell, UnitCell) and cell.solid is not None:
            if cell.solid.is_mesh:
                return MESH_SECONDS * self._mesh_fields(cell)
            return float(SOLID_SECONDS * self._solid_unknowns(cell) ** SOLID_COST)
        needed, directions = 0.0, 4 * self.steps * self.block
        for piece in self._meshed(cell):
            answers = piece.boundary(piece.plan.plate_levels) + directions
            # with fewer folds the number of responses is equal, each with more unknowns
            folded = 4 / 2 ** len(folds_of(piece.tile)) * (TWICE_FOLDED if piece.tile.is_halved else 1.0)
            needed += PER_ANSWER * sum(piece.plan.level_sizes) * answers * folded
        return needed + PER_CUBE * self._pencil(cell) ** 3


def meeting(tiles: Sequence[TileShape], plans: Sequence[MeshPlan]) -> tuple[MeshPlan, ...]:
    """Adapt plans of tiles to equal nodes on common sides: the largest number that any tile needs.

    Levels of the traces are equal too; plain plate gets equal orders through its thickness. Next to solids of
    a file, whose elements are limited to their plan, plain plate gets the nodes of that plan.
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
    """Adapt the plan of a plain tile to the nodes of another plan on common sides."""
    levels = trace_levels(other)
    return replace(plain, blocks=other.blocks, order=other.order, levels=levels, upward=levels - 1)


# Mesh levels: each costs about twice the one before, with higher orders and more rings at the foot.
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
