"""A plate ready to be computed: blocks, tiles, supports and drives on one assembly."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
import scipy.sparse as sp
from numpy.polynomial.legendre import leggauss
from numpy.typing import NDArray

from haptonic.cell import MeshPlan, UnitCell
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.plate.assembly import Assembly
from haptonic.plate.body import BodyOrders, body, loss_factors
from haptonic.plate.damping import Extra
from haptonic.plate.layout import Layout
from haptonic.plate.parts import Actuator, Finger, Force, Plate
from haptonic.plate.skeleton import Block, Skeleton, TraceOrders
from haptonic.plate.supports import Bed, supported
from haptonic.plate.surface import surface_weights
from haptonic.plate.tile import Tile, block_tile, cell_tile
from haptonic.superelement.parallel import threads

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

ON_LINE = 1e-6  # of a tile's size, by which the edge of a patch may miss the line that it lies on
FORCE_POINTS = 12  # along either side of a force's rectangle
FINGER_POINTS = 37  # of equal area on the disc below a finger

Attached = Actuator | Force


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
        GeometryError : things glued to the plate so close to a lattice that no block of plain tiles holds them
        """
        fineness = fineness or Fineness()
        layout = plate.layout
        blocks = _blocks(plate)
        makers: dict[Hashable, Callable[[], Tile]] = {}
        which = []
        for block, attached in blocks.items():
            key, maker = _maker(plate, block, attached, highest, fineness)
            makers.setdefault(key, maker)
            which.append(list(makers).index(key))
        with ThreadPoolExecutor(threads()) as pool:
            tiles = list(pool.map(lambda maker: maker(), makers.values()))
        skeleton = Skeleton.of(layout, list(blocks), fineness.trace)
        held, beds = supported(skeleton, plate.supports)
        total = sp.csr_array(sum((bed.stiffness for bed in beds), start=sp.csr_array((skeleton.size,) * 2)))
        assembly = Assembly.of(skeleton, tiles, which, held, total)
        drives = {}
        for group in assembly.groups:
            for name, drive in group.tile.drive.items():
                (unknowns,) = group.unknowns  # a block with a drive is one of its kind
                drives[name] = np.zeros(assembly.size + 1)
                drives[name][unknowns] = drive
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

    def blocked(self, actuator: str) -> complex:
        """Capacitance of an actuator at rest with its dielectric loss, F."""
        (loss,) = (a.material.dielectric_loss for a in self.plate.actuators if a.name == actuator)
        return self.capacitance[actuator] * (1 - 1j * loss)

    def observed(self, where: Array) -> sp.csr_array:
        """(k, size) what gives the normal displacement of points (k, 2) of the flat face, m."""
        assembly, layout = self.assembly, self.plate.layout
        x, y = np.array(layout.x), np.array(layout.y)
        column = np.clip(np.searchsorted(x, where[:, 0], side="right") - 1, 0, layout.columns - 1)
        row = np.clip(np.searchsorted(y, where[:, 1], side="right") - 1, 0, layout.rows - 1)
        block_of = np.full((layout.rows, layout.columns), -1)
        corners = np.zeros((len(assembly.skeleton.blocks), 2))
        for number, block in enumerate(assembly.skeleton.blocks):
            block_of[slice(*block.rows), slice(*block.columns)] = number
            corners[number] = x[block.columns[0]], y[block.rows[0]]
        block_at = block_of[row, column]
        rows, columns, values = [], [], []
        for group in assembly.groups:
            place = np.full(len(corners), -1)
            place[group.blocks] = np.arange(len(group.blocks))
            points = np.flatnonzero(place[block_at] >= 0)
            if not len(points):
                continue
            weights = group.tile.normal_at(where[points] - corners[block_at[points]])
            unknowns = group.unknowns[place[block_at[points]]]
            rows.append(np.repeat(points, weights.shape[1]))
            columns.append(unknowns.ravel())
            values.append(weights.ravel())
        entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
        return sp.csr_array(entries, shape=(len(where), assembly.size + 1))[:, :-1]

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
        return spring
    inertia = -(omega**2) * finger.mass
    return np.asarray(spring * inertia / (spring + inertia))


def sunflower(count: int) -> Array:
    """(count, 2) points that share the unit disc evenly (Vogel 1979, doi 10.1016/0025-5564(79)90080-4)."""
    number = np.arange(count) + 0.5
    angle, radius = np.pi * (3 - np.sqrt(5)) * number, np.sqrt(number / count)
    return np.asarray(radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=-1))


def _extent(attached: Attached) -> tuple[float, float]:
    """Of what is attached, along x and y, m."""
    return (0.0, 0.0) if attached.size is None else (attached.size[0], attached.size[1])


def _covering(layout: Layout, attached: Attached) -> Block:
    """The smallest block of tiles below something."""
    ranges = []
    for lines, centre, size in zip((layout.y, layout.x), attached.centre[::-1], _extent(attached)[::-1], strict=True):
        slack = ON_LINE * float(np.diff(lines).min())
        start = int(np.searchsorted(lines, centre - size / 2 + slack, side="right")) - 1
        end = int(np.searchsorted(lines, centre + size / 2 - slack, side="left"))
        ranges.append((max(start, 0), min(max(end, start + 1), len(lines) - 1)))
    return Block(ranges[0], ranges[1])


def _blocks(plate: Plate) -> dict[Block, tuple[Attached, ...]]:
    """Blocks that cover the plate, with what is attached to each."""
    layout = plate.layout
    special: list[tuple[Block, tuple[Attached, ...]]] = []
    for attached in (*plate.actuators, *plate.forces):
        block, members = _covering(layout, attached), (attached,)
        while meeting := [one for one in special if one[0].meets(block)]:
            for one in meeting:
                special.remove(one)
                block, members = block.joined(one[0]), (*one[1], *members)
        special.append((block, members))
    for block, members in special:
        for i, j in block.tiles:
            name = layout.tiles[i][j]
            if name is None or name in layout.cells:
                raise GeometryError(
                    argument="plate",
                    given=" and ".join(member.name for member in members) + " on one block of tiles that "
                    + ("leaves the plate" if name is None else f'holds a cell of "{name}"'),
                    allowed="blocks of plain plate below what is glued to it",
                    cause="what shares a tile with something else lies in different regions",
                    next_step="move them apart, so that they share no tile",
                )
    taken = {tile for block, _ in special for tile in block.tiles}
    single = {
        Block((i, i + 1), (j, j + 1)): ()
        for i, row in enumerate(layout.tiles)
        for j, tile in enumerate(row)
        if tile is not None and (i, j) not in taken
    }
    return {**single, **dict(special)}


def _maker(
    plate: Plate, block: Block, attached: tuple[Attached, ...], highest: float, fineness: Fineness
) -> tuple[Hashable, Callable[[], Tile]]:
    """What tells a block's tile from others, and how to make it."""
    layout, trace = plate.layout, fineness.trace
    if attached:
        return block, partial(_attached_tile, plate, block, attached, highest, fineness)
    (i, j) = block.tiles[0]
    name = layout.tiles[i][j]
    assert name is not None
    if name in layout.cells:
        cell = layout.cells[name]
        plan = MeshPlan.suited(cell, fineness.cell, fineness.rings)
        return name, partial(cell_tile, cell, plan, trace, highest)
    width, height = layout.x[j + 1] - layout.x[j], layout.y[i + 1] - layout.y[i]
    cell = UnitCell(Lattice.rectangular(width, height), layout.thickness, layout.material)
    plan = MeshPlan.suited(cell, max(fineness.plain, fineness.along - 1), 0)
    key = tuple(round(size / layout.thickness, 9) for size in (width, height))
    return key, partial(cell_tile, cell, plan, trace, highest)


def _attached_tile(
    plate: Plate, block: Block, attached: tuple[Attached, ...], highest: float, fineness: Fineness
) -> Tile:
    layout = plate.layout
    x = layout.x[block.columns[0] : block.columns[1] + 1]
    y = layout.y[block.rows[0] : block.rows[1] + 1]
    actuators = [one for one in attached if isinstance(one, Actuator)]
    forces = [one for one in attached if isinstance(one, Force)]
    orders = BodyOrders(max(fineness.plain, fineness.along), fineness.plain, 2, 3)
    longest = 1.01 * max(np.diff(x).max(), np.diff(y).max())
    piece = body(x, y, layout.thickness, layout.material, actuators, orders, float(longest))
    loads = {}
    for force in forces:
        points = np.array([force.centre])
        weights = np.ones(1)
        if force.size is not None:
            nodes, share = leggauss(FORCE_POINTS)
            points = points + 0.5 * np.stack(
                np.meshgrid(nodes * force.size[0], nodes * force.size[1], indexing="ij"), axis=-1
            ).reshape(-1, 2)
            weights = np.outer(share, share).ravel() / 4
        loads[force.name] = np.zeros(len(piece.mass))
        loads[force.name][2::3] = surface_weights(piece.points, piece.faces, points).T @ weights
    return block_tile(piece, x, y, layout.thickness, loads, fineness.trace, highest)
