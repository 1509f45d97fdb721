"""A plate ready to be computed: blocks, tiles, supports and drives on one assembly."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import scipy.sparse as sp
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from haptonic.cell import MeshPlan, UnitCell
from haptonic.lattice import Lattice
from haptonic.plate.assembly import Assembly
from haptonic.plate.blocks import Attached, blocks_of
from haptonic.plate.body import Body, BodyOrders, body, body_of_cell, loss_factors
from haptonic.plate.damping import Extra
from haptonic.plate.joined import joined_tile
from haptonic.plate.layout import Layout
from haptonic.plate.parts import Actuator, Finger, Force, Plate
from haptonic.plate.reduction import block_tile, cell_tile
from haptonic.plate.skeleton import Block, Skeleton, TraceOrders
from haptonic.plate.supports import Bed, supported
from haptonic.plate.surface import surface_weights
from haptonic.plate.tile import Tile
from haptonic.superelement.parallel import threads

Array = NDArray[np.float64]
Ints = NDArray[np.int64]
Complex = NDArray[np.complex128]

FORCE_POINTS = 12  # along either side of a force's rectangle
FINGER_POINTS = 37  # of equal area on the disc below a finger


@dataclass(frozen=True)
class Fineness:
    """Polynomial orders of everything.

    along, through : of what tiles share, along an edge and through the thickness
    cell, rings : of a lattice's cells, as in `haptonic.cell.MeshPlan.suited`
    plain : of tiles of plain plate and of blocks with something glued to them
    """

    along: int = 4
    through: int = 2
    cell: int = 4
    rings: int = 1
    plain: int = 4

    @property
    def trace(self) -> TraceOrders:
        return TraceOrders(self.along, self.through)


@dataclass(frozen=True, eq=False)
class PlateModel:
    """Vectors are those of the assembly.

    plate : what it was made from; fineness : how
    highest : frequency up to which tiles were reduced, Hz
    assembly : stiffness and mass without losses
    beds : of the supports, on the free unknowns of the skeleton
    drives : by name of actuators and forces, (size,) force per volt or newton
    capacitance : by actuator, F
    """

    plate: Plate
    fineness: Fineness
    highest: float
    assembly: Assembly
    beds: tuple[Bed, ...]
    drives: Mapping[str, Array]
    capacitance: Mapping[str, float]

    @classmethod
    def of(cls, plate: Plate, highest: float, fineness: Fineness | None = None) -> PlateModel:
        """Reduce the tiles of a plate for frequencies up to ``highest`` (Hz) and put them together.

        Raises
        ------
        GeometryError : things glued so close to a lattice that no block of plain tiles holds them
        """
        fineness = fineness or Fineness()
        layout = plate.layout
        blocks = blocks_of(plate)
        recipes = [_recipe(plate, block, attached) for block, attached in blocks.items()]
        unique = list(dict.fromkeys(recipes))
        tiles = _tiles(plate, unique, highest, fineness)
        which = [unique.index(recipe) for recipe in recipes]
        skeleton = Skeleton.of(layout, list(blocks), fineness.trace)
        held, beds = supported(skeleton, plate.supports)
        total = sp.csr_array(sum((bed.stiffness for bed in beds), start=sp.csr_array((skeleton.size,) * 2)))
        assembly = Assembly.of(skeleton, tiles, which, held, total)
        drives: dict[str, Array] = {}
        for group in assembly.groups:
            for name, drive in group.tile.drive.items():
                (unknowns,) = group.unknowns  # a block with a drive is one of its kind
                drives.setdefault(name, np.zeros(assembly.size + 1))[unknowns] += drive
        return cls(
            plate=plate,
            fineness=fineness,
            highest=highest,
            assembly=assembly,
            beds=tuple(bed.on(assembly.is_free) for bed in beds),
            drives={name: drive[:-1] for name, drive in drives.items()},
            capacitance={name: c for tile in tiles for name, c in tile.capacitance.items()},
        )

    @property
    def factors(self) -> Mapping[str, complex]:
        """Complex factor of each part's stiffness."""
        return loss_factors(self.plate)

    def load(self, drives: Mapping[str, complex]) -> Complex:
        """(size,) forces of drives of given complex amplitudes, V or N."""
        total = sum(amplitude * self.drives[name] for name, amplitude in drives.items())
        return np.asarray(total, np.complex128)

    def blocked(self, actuator: str) -> complex:
        """Capacitance of an actuator at rest with its dielectric loss, F."""
        (loss,) = (a.material.dielectric_loss for a in self.plate.actuators if a.name == actuator)
        return self.capacitance[actuator] * (1 - 1j * loss)

    def observed(self, where: Array) -> sp.csr_array:
        """(k, size) what gives the normal displacement of points (k, 2) of the flat face, m."""
        rows, columns, values = [np.zeros(0, int)], [np.zeros(0, int)], [np.zeros(0)]
        for points, unknowns, weights in self._seen_on_blocks(where):
            rows.append(np.repeat(points, len(unknowns)))
            columns.append(np.tile(unknowns, len(points)))
            values.append(weights.ravel())
        entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
        return sp.csr_array(entries, shape=(len(where), self.assembly.size + 1))[:, :-1]

    def displaced(self, where: Array, vectors: Array) -> Array:
        """(k, n) normal displacement of points (k, 2) of the flat face, m, for many vectors (size, n)."""
        padded = np.vstack([vectors, np.zeros((1, vectors.shape[1]))])
        seen = np.empty((len(where), vectors.shape[1]))
        for points, unknowns, weights in self._seen_on_blocks(where):
            seen[points] = weights @ padded[unknowns]
        return seen

    def _seen_on_blocks(self, where: Array) -> Iterator[tuple[Ints, Ints, Array]]:
        """Points (m,) on each block, its unknowns (n,), and the (m, n) weights of these in what is seen."""
        assembly, layout = self.assembly, self.plate.layout
        x, y = np.array(layout.x), np.array(layout.y)
        column = np.clip(np.searchsorted(x, where[:, 0], side="right") - 1, 0, layout.columns - 1)
        row = np.clip(np.searchsorted(y, where[:, 1], side="right") - 1, 0, layout.rows - 1)
        block_of = np.full((layout.rows, layout.columns), -1)
        corners, sizes = np.zeros((2, len(assembly.skeleton.blocks), 2))
        for number, block in enumerate(assembly.skeleton.blocks):
            block_of[slice(*block.rows), slice(*block.columns)] = number
            corners[number] = x[block.columns[0]], y[block.rows[0]]
            sizes[number] = np.array([x[block.columns[1]], y[block.rows[1]]]) - corners[number]
        block_at = block_of[row, column]
        assert (block_at >= 0).all(), "points beside the plate"
        local = np.clip(where - corners[block_at], 0.0, sizes[block_at])
        for group in assembly.groups:
            own = [np.flatnonzero(block_at == block) for block in group.blocks]
            together = np.concatenate(own)
            if not len(together):
                continue
            weights = group.tile.inside.normal_at(local[together])
            ends = np.cumsum([len(points) for points in own])[:-1]
            yield from zip(own, group.unknowns, np.split(weights, ends), strict=True)

    @cached_property
    def pad(self) -> sp.csr_array:
        """(points, size) what gives the normal displacement of points of equal area below the finger."""
        finger = self.plate.finger
        if finger is None:
            return sp.csr_array((0, self.assembly.size))
        return self.observed(np.array(finger.centre) + 0.5 * finger.diameter * sunflower(FINGER_POINTS))

    @cached_property
    def extras(self) -> tuple[Extra, ...]:
        """All whose loss is not the plate's, and the finger."""
        assembly, factors = self.assembly, self.factors
        plain = factors["plate"]
        found = []
        for group in assembly.groups:
            for name, part in group.tile.stiffness.items():
                if name != "plate":
                    for unknowns in group.unknowns:
                        free = unknowns < assembly.size
                        rows, form = unknowns[free], part[np.ix_(free, free)]
                        found.append(Extra.of_form(rows, form, factors[name] - plain))
        for bed in self.beds:
            rows = np.flatnonzero(np.diff(bed.stiffness.indptr))
            form = bed.stiffness[rows][:, rows].toarray()
            found.append(Extra.of_form(rows, form, 1 + 1j * bed.loss_factor - plain))
        if (finger := self.plate.finger) is not None:
            rows = np.unique(self.pad.indices)
            share = 1 / self.pad.shape[0]
            axes = self.pad[:, rows].toarray().T
            found.append(Extra(rows, axes, lambda omega: share * impedance(finger, omega)))
        return tuple(found)


def impedance(finger: Finger, omega: Array) -> Complex:
    """Dynamic stiffness of a whole finger: force over displacement, N/m."""
    spring = finger.stiffness + 1j * omega * finger.damping
    if np.isinf(finger.mass):
        return np.asarray(spring)
    inertia = -(omega**2) * finger.mass
    return np.asarray(spring * inertia / (spring + inertia))


def sunflower(count: int) -> Array:
    """(count, 2) points that share the unit disc evenly (Vogel 1979, doi 10.1016/0025-5564(79)90080-4)."""
    number = np.arange(count) + 0.5
    angle, radius = np.pi * (3 - np.sqrt(5)) * number, np.sqrt(number / count)
    return np.asarray(radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=-1))


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
class _Recipe:
    """How a block's tile is made; the same for blocks that are alike.

    cell : name of a lattice's cell, or None for plain plate; size : of one tile, m
    shape : rows and columns that are joined
    attached : what a block of its own carries, else nothing; block : only then
    """

    cell: str | None
    size: tuple[float, float]
    shape: tuple[int, int]
    attached: tuple[Attached, ...] = ()
    block: Block | None = None

    def of_shape(self, shape: tuple[int, int]) -> _Recipe:
        return replace(self, shape=shape)


def _recipe(plate: Plate, block: Block, attached: tuple[Attached, ...]) -> _Recipe:
    layout = plate.layout
    name = layout.at(block.tiles[0])
    left, bottom, right, top = layout.bounds(block.tiles[0])
    size = tuple(
        layout.thickness * round(length / layout.thickness, 9) for length in (right - left, top - bottom)
    )
    shape = (block.rows[1] - block.rows[0], block.columns[1] - block.columns[0])
    cell = name if name in layout.cells else None
    return _Recipe(cell, (size[0], size[1]), shape, attached, block if attached else None)


def _tiles(plate: Plate, recipes: list[_Recipe], highest: float, fineness: Fineness) -> list[Tile]:
    """The tiles of recipes: single ones first, rows of them, then rectangles; like steps side by side."""
    made: dict[_Recipe, Tile] = {}

    def make(recipe: _Recipe) -> Tile:
        rows, columns = recipe.shape
        if recipe.shape == (1, 1):
            return _single_tile(plate, recipe, highest, fineness)
        row, width = recipe.of_shape((1, columns)), recipe.size[0] * columns
        if rows == 1:
            one = made[recipe.of_shape((1, 1))]
            return joined_tile(one, recipe.size, recipe.shape, fineness.trace, highest)
        size = (width, recipe.size[1])
        return joined_tile(made[row], size, (rows, 1), fineness.trace, highest, (1, columns))

    plain = [recipe for recipe in recipes if not recipe.attached]
    steps = [
        [recipe.of_shape((1, 1)) for recipe in plain],
        [recipe.of_shape((1, recipe.shape[1])) for recipe in plain],
        plain,
    ]
    with threadpool_limits(1), ThreadPoolExecutor(threads()) as pool:
        attached = {
            recipe: pool.submit(_attached_tile, plate, recipe, highest, fineness)
            for recipe in recipes if recipe.attached
        }  # fmt: skip
        for step in steps:
            missing = [recipe for recipe in dict.fromkeys(step) if recipe not in made]
            made |= dict(zip(missing, pool.map(make, missing), strict=True))
        made |= {recipe: future.result() for recipe, future in attached.items()}
    return [made[recipe] for recipe in recipes]


def _single_tile(plate: Plate, recipe: _Recipe, highest: float, fineness: Fineness) -> Tile:
    layout = plate.layout
    if recipe.cell is not None:
        cell = layout.cells[recipe.cell]
        plan = MeshPlan.suited(cell, fineness.cell, fineness.rings)
    else:
        cell = UnitCell(Lattice.rectangular(*recipe.size), layout.thickness, layout.material)
        plan = MeshPlan.suited(cell, max(fineness.plain, fineness.along - 1), 0)
    return cell_tile(cell, plan, fineness.trace, highest)


def _attached_tile(plate: Plate, recipe: _Recipe, highest: float, fineness: Fineness) -> Tile:
    layout, block, attached = plate.layout, recipe.block, recipe.attached
    assert block is not None
    x = layout.x[block.columns[0] : block.columns[1] + 1]
    y = layout.y[block.rows[0] : block.rows[1] + 1]
    actuators = [one for one in attached if isinstance(one, Actuator)]
    if recipe.cell is not None:
        cell = layout.cells[recipe.cell]
        plan = MeshPlan.suited(cell, fineness.cell, fineness.rings)
        piece = body_of_cell(cell, plan, (x[0], x[-1]), (y[0], y[-1]))
    else:
        piece = _plain_body(layout, x, y, actuators, fineness)
    loads = {}
    for force in attached:
        if isinstance(force, Force):
            points, weights = _spread(force, (x[0], y[0], x[-1], y[-1]))
            loads[force.name] = np.zeros(len(piece.mass))
            loads[force.name][2::3] = surface_weights(piece.points, piece.faces, points).T @ weights
    return block_tile(piece, x, y, layout.thickness, loads, fineness.trace, highest)


def _plain_body(
    layout: Layout, x: Sequence[float], y: Sequence[float], actuators: list[Actuator], fineness: Fineness
) -> Body:
    # in the plane as fine as a tile without anything on it: a force must not soften or stiffen the plate;
    # the edges of a patch divide a tile into smaller elements, which need less
    finer = 1 if actuators else 2
    orders = BodyOrders(max(fineness.plain, fineness.along - 1) + finer, fineness.plain, 2, 3)
    longest = 1.01 * max(np.diff(x).max(), np.diff(y).max())
    return body(x, y, layout.thickness, layout.material, actuators, orders, float(longest))
