"""Mesh resolution for a requested accuracy, with its time and memory."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from haptonic.cell import MeshPlan, Period, TileShape, UnitCell
from haptonic.cell.orders import USUAL_BANDS, order_on
from haptonic.cell.pieces import Meshed, pieces_of
from haptonic.parallel import threads
from haptonic.superelement.symmetry import THIRD, folds_of
from haptonic.superelement.trace import trace_levels

# For solids of a CAD file: unknowns per element and cube of the order, measured 0.7 to 1.1; time (s) and
# memory (bytes) for powers of their number: 13,700 took 2 s, 140,000 took 90 s, 22,000 and 52,000 took 1.1
# and 3.7 GB.
SOLID_UNKNOWNS, SOLID_SECONDS, SOLID_COST, SOLID_BYTES, SOLID_GROWTH = 1.0, 6.5e-7, 1.6, 28.0, 1.7
# For meshes from files, per unknown and unknown of the trace: meshes of 134 hexahedra to 4458 tetrahedra took
# 56 to 59 bytes and 1.0 to 1.1 us at orders 3 and 4.
MESH_SECONDS, MESH_BYTES = 1.1e-6, 75.0
PER_ANSWER, PER_NEIGHBOUR, PER_CUBE, TWICE_FOLDED = 3.5e-7, 2.6e-7, 5e-9, 1.5  # s and a factor, see `seconds`
# Memory: numbers for each unknown that waits, each pair of nodes of an element, each unknown's factor
# and the square of a pencil's size; bytes of the program at rest. Models of 39 designs took 0.4 to 7.5 GB,
# 0.5 to 1.05 of the estimate; see benchmarks/answered_in_budget.py.
PER_KEPT, PER_PAIR, PER_FACTOR, PER_PENCIL, RESIDENT = 2.0, 28.0, 55.0, 42.0, 4.5e8
BY_THIRDS = 1.5  # times the pairs: parts of a tile with the third of a turn have separate indices
LEAST_ORDER = 2  # that a study can set
LEAST_STEPS, WIDEST = 2, 40  # of an interior: least number of blocks, and their largest size


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

        More blocks are better than wider ones: for sixty bands of a pillar the error was 10 % with 2 blocks
        of 90, and 0.1 % with 5 of 40. Each tile needs its share of the bands only.
        """
        if count <= self.bands:
            return self
        of_tile = count * max(placed.tile.area for placed in cell.tiles) / cell.area
        deeper = max(math.ceil(math.log2(of_tile / self.bands)), 0)
        block = max(self.block, min(round(of_tile), WIDEST))
        return replace(self, steps=self.steps + deeper, block=block, bands=count)

    def grown(self, times: int = 1) -> Resolution:
        """Enlarge the interior: each time wider blocks, and one more block if they would be too wide.

        Below bodies of pillars wider blocks are better. In other cells further blocks are better, but the
        first wider ones are enough for an accuracy of 2e-3.
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
        """Plans with equal blocks and orders lower by one, for exact counts."""
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
            pairs = of_class * _neighbours(plan)
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
        return self._solid_unknowns(cell) * 3 * plan.rim_nodes * trace_levels(plan)

    def _pencil(self, cell: Period) -> int:
        """Size of the condensed pencil of all tiles."""
        directions = 4 * self.steps * self.block
        return sum(3 * plan.rim_nodes * trace_levels(plan) // 2 + directions for plan in self.plans(cell))

    def seconds(self, cell: Period) -> float:
        """Estimate of the processor time of a model, s.

        Static responses to the trace and the interior's blocks take most of it: their number times the number
        of nodes. Matrices of the elements take a time for each unknown and neighbour. With many bands the
        condensed pencil dominates, whose modes at two dozen wavevectors form the small basis: a time for the
        cube of its size. Models of 38 drawn designs, of 1 to 100 s, took 0.75 to 1.25 of the estimate.
        """
        if isinstance(cell, UnitCell) and cell.solid is not None:
            if cell.solid.is_mesh:
                return MESH_SECONDS * self._mesh_fields(cell)
            return float(SOLID_SECONDS * self._solid_unknowns(cell) ** SOLID_COST)
        needed, directions = 0.0, 4 * self.steps * self.block
        for piece in self._meshed(cell):
            plan, nodes = piece.plan, sum(piece.plan.level_sizes)
            answers = piece.boundary(trace_levels(plan)) + directions
            # with fewer folds the number of responses is equal, each with more unknowns
            folded = 4 / 2 ** len(folds_of(piece.tile)) * (TWICE_FOLDED if piece.tile.is_halved else 1.0)
            needed += nodes * (PER_ANSWER * answers * folded + PER_NEIGHBOUR * 3 * _neighbours(plan))
        return needed + PER_CUBE * self._pencil(cell) ** 3


def _neighbours(plan: MeshPlan) -> int:
    """Nodes that share a plane of an element with a node."""
    across, along, upward = plan.outward + 1, plan.order + 1, plan.upward + 1
    return across * along + along * upward + across * upward


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
    order = max(order_on(blocks, plan.blocks, plan.order) for plan in plans)
    pieces = math.lcm(*(plan.on_sides[0] for plan in plans))
    on_pieces = max(order_on(pieces, *plan.on_sides) for plan in plans)
    levels = max(trace_levels(replace(plan, levels=0)) for plan in plans)
    return tuple(
        replace(
            plan,
            blocks=blocks,
            order=order,
            levels=levels,
            rim=(pieces, on_pieces),
            upward=plan.upward if plan.plate_levels >= levels else levels - 1,
        )
        for plan in plans
    )


def fitted(plain: MeshPlan, other: MeshPlan) -> MeshPlan:
    """Adapt the plan of a plain tile to the nodes of another plan on common sides."""
    levels = trace_levels(other)
    return replace(
        plain, blocks=other.blocks, order=other.order, rim=other.rim, levels=levels, upward=levels - 1
    )


# Mesh levels: each costs about twice the one before, with higher orders and more rings at the foot.
LEVELS = (
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
