"""Tiles of a plate: groups of equal blocks, and the construction of the tile of each group."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial.legendre import leggauss

from haptonic.arrays import Array
from haptonic.cell import MeshPlan, Solid, TileShape, UnitCell
from haptonic.cell.brickwork import Steps, equal_pieces
from haptonic.lattice import Lattice
from haptonic.parallel import one_thread, threads
from haptonic.plate.body.bending_waves import check_resolved, highest_resolved
from haptonic.plate.body.bonds import Bonded
from haptonic.plate.body.joined_tile import joined_tile, opened_tile
from haptonic.plate.body.reduction import block_tile, cell_tile
from haptonic.plate.body.skeleton import TraceOrders
from haptonic.plate.body.surface import surface_weights
from haptonic.plate.body.tile import Tile
from haptonic.plate.body.unreduced import Body, BodyOrders, body, body_of_brick
from haptonic.plate.layout.blocks import Attached
from haptonic.plate.layout.grid import Block, Layout
from haptonic.plate.layout.parts import Actuator, Force, Plate

FORCE_POINTS = 12  # along each side of a force's rectangle


@dataclass(frozen=True)
class Fineness:
    """Polynomial orders of tiles and traces.

    along, through, shear : of the traces between tiles, as in `haptonic.plate.body.skeleton.TraceOrders`
    cell, rings : of a lattice's cells, as in `haptonic.cell.MeshPlan.suited`
    drawn : in place of ``cell`` of those of a STEP file, whose elements are refined towards all edges
    plain : of tiles of plain plate and of blocks with something glued to them
    """

    along: int = 4
    through: int = 2
    cell: int = 4
    rings: int = 1
    plain: int = 4
    shear: int = 2
    drawn: int = 3

    def of_cell(self, solid: Solid | None) -> int:
        """Order of the elements of a cell, which may be of a file."""
        return self.cell if solid is None or solid.is_mesh else self.drawn

    @property
    def trace(self) -> TraceOrders:
        """Orders of the traces between tiles, within the orders of the meshes."""
        shear = self.shear if min(self.cell, self.plain) > self.through else 0
        return TraceOrders(self.along, self.through, shear)

    @property
    def is_coarse(self) -> bool:
        """True for a mesh that is coarser than usual, which the study chooses."""
        return self.along < Fineness.along

    def highest_resolved(self, layout: Layout) -> float:
        """Frequency of the shortest bending wave that the tiles of a plate resolve, Hz."""
        return highest_resolved(layout, self.trace, roughly=self.is_coarse)

    def check_waves(self, layout: Layout, highest: float) -> None:
        """Raise HaptonicError if bending waves of a frequency, Hz, are too short for the tiles of a plate.

        With a coarse mesh, only waves that it does not represent at all are refused.
        """
        check_resolved(layout, self.trace, highest, roughly=self.is_coarse)


def _spread(force: Force, bounds: tuple[float, float, float, float]) -> tuple[Array, Array]:
    """Points (k, 2) of the flat face that a force acts on within bounds, m, and the share (k,) of each."""
    if force.size is None:
        return np.array([force.centre]), np.ones(1)
    nodes, share = leggauss(FORCE_POINTS)
    places, shares = [], []
    for axis in (0, 1):
        whole, middle = force.size[axis], force.centre[axis]
        low, high = max(middle - whole / 2, bounds[axis]), min(middle + whole / 2, bounds[axis + 2])
        places.append(0.5 * (low + high) + 0.5 * (high - low) * nodes)
        shares.append(0.5 * share * (high - low) / whole)
    grid = np.meshgrid(*places, indexing="ij")
    return np.stack(grid, axis=-1).reshape(-1, 2), np.outer(*shares).ravel()


@dataclass(frozen=True)
class Recipe:
    """Parameters of a block's tile; equal for equal blocks.

    brick : name and number of a lattice's brick, or None for plain plate
    steps : widths and heights of the tiles that a brick covers, or of one tile
    shape : rows and columns of bricks or tiles that are joined
    attached : parts on a separate block, or empty; block : only with attached parts
    open_trace : unknowns of the trace that are condensed into the tile, see `haptonic.plate.body.joined_tile`
    """

    brick: tuple[str, int] | None
    steps: Steps
    shape: tuple[int, int]
    attached: tuple[Attached, ...] = ()
    block: Block | None = None
    open_trace: tuple[int, ...] = ()

    def of_shape(self, shape: tuple[int, int]) -> Recipe:
        return replace(self, shape=shape, open_trace=())

    @property
    def closed(self) -> Recipe:
        """Recipe of the tile with its whole trace."""
        return self.of_shape(self.shape)

    @property
    def size(self) -> tuple[float, float]:
        """Size of one brick or tile, m."""
        return sum(self.steps[0]), sum(self.steps[1])

    @property
    def span(self) -> tuple[int, int]:
        """Rows and columns of tiles that one brick covers."""
        return len(self.steps[1]), len(self.steps[0])


def recipe_of(
    plate: Plate, block: Block, attached: tuple[Attached, ...], open_trace: tuple[int, ...]
) -> Recipe:
    layout, corner = plate.layout, block.tiles[0]
    single, laid = layout.block(corner), layout.bricks.get(corner)
    brick = None if laid is None else (str(layout.at(corner)), laid.number)
    shape = block.shape[0] // single.shape[0], block.shape[1] // single.shape[1]
    return Recipe(
        brick=brick,
        steps=layout.steps(single),
        shape=shape,
        attached=attached,
        block=block if attached else None,
        open_trace=open_trace,
    )


def tiles_of(
    plate: Plate,
    recipes: list[Recipe],
    highest: float,
    fineness: Fineness,
    bonds: Mapping[str, tuple[float, float]],
) -> list[Tile]:
    """Make the tiles of recipes: single tiles first, then rows, then rectangles, each step in threads."""
    tiles: dict[Recipe, Tile] = {}

    def make(recipe: Recipe) -> Tile:
        rows, columns = recipe.shape
        if recipe.open_trace:
            return opened_tile(tiles[recipe.closed], np.array(recipe.open_trace), highest)
        if recipe.shape == (1, 1):
            return _single_tile(plate, recipe, highest, fineness)
        (width, height), (high, wide) = recipe.size, recipe.span
        if rows == 1:
            single = tiles[recipe.of_shape((1, 1))]
            return joined_tile(single, recipe.size, recipe.shape, fineness.trace, highest, recipe.span)
        row, size = tiles[recipe.of_shape((1, columns))], (width * columns, height)
        return joined_tile(row, size, (rows, 1), fineness.trace, highest, (high, wide * columns))

    plain = [recipe for recipe in recipes if not recipe.attached]
    steps = [
        [recipe.of_shape((1, 1)) for recipe in plain],
        [recipe.of_shape((1, recipe.shape[1])) for recipe in plain],
        [recipe.closed for recipe in plain],
        plain,
    ]
    with one_thread(), ThreadPoolExecutor(threads()) as pool:
        attached = {
            recipe: pool.submit(_attached_tile, plate, recipe, highest, fineness, bonds)
            for recipe in recipes if recipe.attached
        }  # fmt: skip
        for step in steps:
            missing = [recipe for recipe in dict.fromkeys(step) if recipe not in tiles]
            tiles |= dict(zip(missing, pool.map(make, missing), strict=True))
        tiles |= {recipe: future.result() for recipe, future in attached.items()}
    return [tiles[recipe] for recipe in recipes]


def _single_tile(plate: Plate, recipe: Recipe, highest: float, fineness: Fineness) -> Tile:
    layout = plate.layout
    if recipe.brick is None:
        plain = UnitCell(Lattice.rectangular(*recipe.size), layout.thickness, layout.material)
        plan = MeshPlan.suited(plain, max(fineness.plain, fineness.along - 1), 0)
        return cell_tile(plain, plan, recipe.steps, fineness.trace, highest)
    brick = layout.brick(*recipe.brick)
    return cell_tile(brick, _plan(brick, recipe, fineness), recipe.steps, fineness.trace, highest)


def _plan(brick: TileShape, recipe: Recipe, fineness: Fineness) -> MeshPlan:
    """Mesh plan of a brick with elements that end at the borders of adjacent tiles."""
    plan = MeshPlan.suited(brick, fineness.of_cell(brick.solid), fineness.rings)
    return plan.divided(equal_pieces(recipe.steps), fineness.along)


def _attached_tile(
    plate: Plate,
    recipe: Recipe,
    highest: float,
    fineness: Fineness,
    bonds: Mapping[str, tuple[float, float]],
) -> Tile:
    layout, block, attached = plate.layout, recipe.block, recipe.attached
    assert block is not None
    x, y = layout.lines(block)
    actuators = [part for part in attached if isinstance(part, Actuator)]
    if recipe.brick is None:
        piece = _plain_body(layout, x, y, actuators, fineness)
    else:
        brick = layout.brick(*recipe.brick)
        assert brick.solid is None, "a force on solids of a file"
        piece = body_of_brick(brick, _plan(brick, recipe, fineness), (x[0], x[-1]), (y[0], y[-1]))
    loads = {}
    for force in attached:
        if isinstance(force, Force):
            points, weights = _spread(force, (x[0], y[0], x[-1], y[-1]))
            loads[force.name] = np.zeros(len(piece.mass))
            loads[force.name][2::3] = surface_weights(piece.points, piece.faces, points).T @ weights
    bonded = {}
    for actuator in actuators:
        if actuator.name in bonds and actuator.bond is not None:
            thicknesses = np.geomspace(*bonds[actuator.name], 3)
            bodies = []
            for thickness in thicknesses:
                thicker = replace(actuator, bond=replace(actuator.bond, thickness=thickness))
                varied = [thicker if other is actuator else other for other in actuators]
                bodies.append(_plain_body(layout, x, y, varied, fineness))
            bonded[actuator.name] = Bonded(thicknesses, tuple(bodies), actuator.bond.thickness)
    return block_tile(piece, x, y, layout.thickness, loads, fineness.trace, highest, bonded)


def _plain_body(
    layout: Layout, x: Sequence[float], y: Sequence[float], actuators: list[Actuator], fineness: Fineness
) -> Body:
    # in the plane as fine as a tile without attached parts, so that a force does not change the stiffness;
    # the edges of a patch divide a tile into smaller elements, which need a lower order
    finer = 1 if actuators else 2
    orders = BodyOrders(max(fineness.plain, fineness.along - 1) + finer, fineness.plain, 2, 3)
    longest = 1.01 * max(np.diff(x).max(), np.diff(y).max())
    return body(x, y, layout.thickness, layout.material, actuators, orders, float(longest))
