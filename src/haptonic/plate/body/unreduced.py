"""Unreduced bodies: stiffness by part, mass and drive of plain plate with glued patches.

Also of a patch alone, and of a brick of a lattice.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise
from math import ceil
from types import MappingProxyType

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from haptonic.arrays import Array, Ints
from haptonic.cell import MeshPlan, TileShape, mesh_cell
from haptonic.cell.quadrature import lobatto
from haptonic.elements import element_matrices
from haptonic.later import sparse as sp
from haptonic.materials import Material, PiezoelectricMaterial
from haptonic.plate.body.piezo import electric_part
from haptonic.plate.body.surface import flat_faces
from haptonic.plate.layout.keys import PLATE, PartKey, bond, ceramic, electric
from haptonic.plate.layout.parts import Actuator, Plate

Window = tuple[tuple[float, float], tuple[float, float]]

SAME = 1e-9  # of the longest element: lines closer than this are equal
BATCH = 64  # number of elements assembled at a time


@dataclass(frozen=True)
class BodyOrders:
    """Polynomial orders. along : in the plane, of every element; plate, bond, ceramic : through each"""

    along: int
    plate: int
    bond: int
    ceramic: int


@dataclass(frozen=True, eq=False)
class Body:
    """Unreduced piece of a plate with glued patches. Unknown 3 i + k is component k at node i.

    Its parts are the plate and, of each actuator, bond, ceramic and electric field (`PartKey`).
    With the voltages V, forces f on a body at rest and the charges Q on the free electrodes obey

        sum(stiffness) u = f + drive V,    Q = capacitance V + drive u.

    points : (n, 3) m; the plate between z = 0 and its thickness, patches above
    stiffness : by part (3 n, 3 n), symmetric, N/m; `loss_factors` has the complex factor of each
    mass : (3 n,) lumped, kg
    drive : by actuator (3 n,) force per volt, N/V
    capacitance : by actuator, of the clamped patch, F
    faces : (k, n1, n2) node numbers of the quadrilaterals on the flat face z = 0, by orders
    rim : nodes on the four lateral sides of the plate, or of a patch alone, ascending
    elements : by part, of a brick by orders, (k, n1, n2, n3) node numbers
    """

    points: Array
    stiffness: Mapping[PartKey, sp.csr_array]
    mass: Array
    drive: Mapping[str, Array]
    capacitance: Mapping[str, float]
    faces: tuple[Ints, ...]
    rim: Ints
    elements: Mapping[PartKey, Ints]


def body(
    x: Sequence[float],
    y: Sequence[float],
    thickness: float,
    material: Material,
    actuators: Sequence[Actuator],
    orders: BodyOrders,
    longest: float,
) -> Body:
    """Mesh a rectangle of plate with its patches and assemble it.

    The lines between tiles and the edges of all patches divide the rectangle into boxes. These are divided
    evenly until no element is longer than ``longest``.

    Parameters
    ----------
    x, y : positions of the lines between tiles, ascending, first and last the ends of the rectangle, m
    thickness, material : of the plate
    actuators : patches that lie within the rectangle and do not overlap
    longest : of an element's sides in the plane, m
    """
    windows = [_window(actuator) for actuator in actuators]
    overlaps = (_overlap(*pair, longest) for pair in combinations(windows, 2))
    assert not any(overlaps), "patches overlap"
    edges_x, edges_y = ([end for window in windows for end in window[axis]] for axis in (0, 1))
    grid = _Grid.of(_breaks(x, edges_x, longest), _breaks(y, edges_y, longest), orders.along)
    plate = _laid(PLATE, material, grid, 0.0, thickness, orders.plate, 0)
    layers, ceramics = [plate], {}
    for actuator, window in zip(actuators, windows, strict=True):
        at = grid.between(window)
        below, height = plate.number[*at, -1], thickness
        start = sum(len(layer.points) for layer in layers)
        if actuator.bond is not None:
            part, glue = bond(actuator.name), actuator.bond
            laid = _laid(
                part, glue.material, grid.cropped(at), height, glue.thickness, orders.bond, start, below
            )
            layers.append(laid)
            below, height, start = laid.number[..., -1], height + glue.thickness, start + len(laid.points)
        ceramics[actuator.name] = _ceramic(actuator, grid.cropped(at), height, orders.ceramic, start, below)
        layers.append(ceramics[actuator.name])
    return _assembled(layers, ceramics)


def body_of_brick(brick: TileShape, plan: MeshPlan, x: tuple[float, float], y: tuple[float, float]) -> Body:
    """Mesh and assemble a rectangle about a pillar between two lines along x and two along y, m."""
    mesh = mesh_cell(brick, plan)
    points = mesh.points.copy()
    rim = np.zeros(len(points), dtype=bool)
    for axis, (start, end) in enumerate((x, y)):
        low, high = points[:, axis].min(), points[:, axis].max()
        first, last = (np.abs(points[:, axis] - border) < SAME * (high - low) for border in (low, high))
        points[:, axis] += start - low
        points[first, axis], points[last, axis] = start, end  # exactly on the lines
        rim |= first | last
    mass, total = np.zeros(len(mesh.points)), sp.csr_array((3 * len(mesh.points),) * 2)
    families = {PartKey("plate", k): family.nodes for k, family in enumerate(mesh.topology.families)}
    for family in mesh.topology.families:
        for region, solid in enumerate(brick.solids):
            total = total + _elastic(mesh.points, family.nodes[family.region == region], solid, mass)
    return Body(
        points=points,
        stiffness=MappingProxyType({PLATE: total}),
        mass=np.repeat(mass, 3),
        drive=MappingProxyType({}),
        capacitance=MappingProxyType({}),
        faces=tuple(flat_faces(mesh)),
        rim=np.flatnonzero(rim),
        elements=MappingProxyType(families),
    )


def free_patch(actuator: Actuator, orders: BodyOrders, longest: float) -> Body:
    """Assemble the ceramic of an actuator without plate and glue, with its lower face at z = 0."""
    x, y = (_breaks(ends, (), longest) for ends in _window(actuator))
    layer = _ceramic(actuator, _Grid.of(x, y, orders.along), 0.0, orders.ceramic, 0)
    return _assembled([layer], {actuator.name: layer})


def loss_factors(plate: Plate) -> dict[PartKey, complex]:
    """Complex factor for each part's stiffness at a motion exp(i omega t), by the parts of `Body`.

    The factor of elastic parts is 1 + i eta. With a loss tangent the permittivity is
    eps^S (1 - i tan delta). The field's stiffness is inverse to it, with the factor 1 / (1 - i tan delta),
    the capacitance is proportional to it; in the drive it cancels, so the drive is real.
    """
    factors = {PLATE: 1 + 1j * plate.loss_factor}
    for actuator in plate.actuators:
        solid = actuator.material
        if actuator.bond is not None:
            factors[bond(actuator.name)] = 1 + 1j * actuator.bond.material.loss_factor
        factors[ceramic(actuator.name)] = 1 + 1j * solid.loss_factor
        factors[electric(actuator.name)] = 1 / (1 - 1j * solid.clamped_loss)
    return factors


def _window(actuator: Actuator) -> Window:
    """Ends of a patch along x and y, m."""
    (x, y), (along_x, along_y, _) = actuator.centre, actuator.size
    return (x - along_x / 2, x + along_x / 2), (y - along_y / 2, y + along_y / 2)


def _overlap(window: Window, other: Window, longest: float) -> bool:
    shared = (min(a[1], b[1]) - max(a[0], b[0]) for a, b in zip(window, other, strict=True))
    return all(length > SAME * longest for length in shared)


def _breaks(lines: Sequence[float], edges: Sequence[float], longest: float) -> Array:
    """Borders of elements, ascending; an edge that equals a line up to rounding is replaced by it."""
    borders = [float(line) for line in lines]
    for edge in edges:
        assert borders[0] - SAME * longest < edge < lines[-1] + SAME * longest, "a patch leaves the block"
        if min(abs(edge - line) for line in borders) > SAME * longest:
            borders.append(edge)
    borders.sort()
    pieces = [
        np.linspace(a, b, max(1, ceil((b - a) / longest - SAME)) + 1)[:-1] for a, b in pairwise(borders)
    ]
    return np.append(np.concatenate(pieces), borders[-1])


@dataclass(frozen=True, eq=False)
class _Grid:
    """Nodes in the plane. x, y : positions of the columns and rows, m; order : of the elements"""

    x: Array
    y: Array
    order: int

    @classmethod
    def of(cls, x: Array, y: Array, order: int) -> _Grid:
        """Make the grid from the borders of the elements."""
        inside = 0.5 * (1 + lobatto(order)[0][:-1])
        columns, rows = (
            np.append((ends[:-1, None] + inside * np.diff(ends)[:, None]).ravel(), ends[-1])
            for ends in (x, y)
        )
        return cls(columns, rows, order)

    def between(self, window: Window) -> tuple[slice, slice]:
        """The columns and the rows from one end of a window to the other."""
        ends = [
            [int(np.abs(nodes - end).argmin()) for end in pair]
            for nodes, pair in zip((self.x, self.y), window, strict=True)
        ]
        return slice(ends[0][0], ends[0][1] + 1), slice(ends[1][0], ends[1][1] + 1)

    def cropped(self, at: tuple[slice, slice]) -> _Grid:
        return _Grid(self.x[at[0]], self.y[at[1]], self.order)


@dataclass(frozen=True, eq=False)
class _Layer:
    """One part of a body: a box of elements over a grid.

    number : (columns, rows, levels) node numbers; points : (fresh, 3) nodes that are not shared, m
    elements : (k, n1, n2, n3) node numbers
    """

    part: PartKey
    material: Material
    number: Ints
    points: Array
    elements: Ints


def _laid(
    part: PartKey,
    material: Material,
    grid: _Grid,
    bottom: float,
    thickness: float,
    order: int,
    start: int,
    below: Ints | None = None,
) -> _Layer:
    """Make a layer above z = ``bottom``; new nodes are numbered from ``start``, ``below`` are shared."""
    levels = bottom + thickness * 0.5 * (1 + lobatto(order)[0])
    fresh = levels if below is None else levels[1:]
    points = np.stack(np.meshgrid(grid.x, grid.y, fresh, indexing="ij"), axis=-1)
    number = start + np.arange(points[..., 0].size).reshape(points.shape[:-1])
    if below is not None:
        number = np.concatenate([below[..., None], number], axis=-1)
    size = (grid.order + 1, grid.order + 1, order + 1)
    elements = sliding_window_view(number, size)[:: grid.order, :: grid.order, 0].reshape(-1, *size)
    return _Layer(
        part=part, material=material, number=number, points=points.reshape(-1, 3), elements=elements
    )


def _ceramic(
    actuator: Actuator, grid: _Grid, bottom: float, order: int, start: int, below: Ints | None = None
) -> _Layer:
    part = ceramic(actuator.name)
    return _laid(part, actuator.material, grid, bottom, actuator.size[2], order, start, below)


def _assembled(layers: Sequence[_Layer], ceramics: Mapping[str, _Layer]) -> Body:
    """Assemble layers in the order of their nodes' numbers; the first one has the flat face."""
    points = np.concatenate([layer.points for layer in layers])
    size = 3 * len(points)
    mass = np.zeros(len(points))
    stiffness, drive, capacitance = {}, {}, {}
    for layer in layers:
        stiffness[layer.part] = _elastic(points, layer.elements, layer.material, mass)
    for name, layer in ceramics.items():
        assert isinstance(layer.material, PiezoelectricMaterial)
        glued, free = layer.number[..., 0], layer.number[..., -1]
        field = electric_part(points, layer.elements, layer.material, glued, free)
        unknowns = (3 * field.nodes[:, None] + np.arange(3)).ravel()
        stiffness[electric(name)] = _spread(field.stiffness, unknowns, size)
        drive[name] = np.zeros(size)
        drive[name][unknowns] = field.drive
        capacitance[name] = field.capacitance
    lowest = layers[0]
    inner = lowest.number[1:-1, 1:-1]
    return Body(
        points=points,
        stiffness=MappingProxyType(stiffness),
        mass=np.repeat(mass, 3),
        drive=MappingProxyType(drive),
        capacitance=MappingProxyType(capacitance),
        faces=(lowest.elements[..., 0],),
        rim=np.setdiff1d(lowest.number, inner),
        elements=MappingProxyType({layer.part: layer.elements for layer in layers}),
    )


def _spread(dense: Array, own: Ints, size: int) -> sp.csr_array:
    """(size, size) matrix that couples the unknowns ``own``, ascending, by a dense one."""
    starts = np.zeros(size + 1, dtype=np.int32)
    starts[own + 1] = len(own)
    columns = np.tile(own.astype(np.int32), len(own))
    return sp.csr_array((dense.ravel(), columns, starts.cumsum(dtype=np.int32)), shape=(size, size))


def _elastic(points: Array, elements: Ints, material: Material, mass: Array) -> sp.csr_array:
    """(3 n, 3 n) stiffness of elements (k, n1, n2, n3); their lumped mass is added to ``mass`` (n,)."""
    count = len(points)
    total = sp.csr_array((3 * count,) * 2)
    for start in range(0, len(elements), BATCH):
        nodes = elements[start : start + BATCH]
        matrices = element_matrices(points, nodes, material)
        flat = nodes.reshape(len(nodes), -1)
        first, second = matrices.pairs
        code, block = np.unique((flat.T[first] * count + flat.T[second]).ravel(), return_inverse=True)
        entries = (np.ones(len(block)), (block, np.arange(len(block))))
        gather = sp.csr_array(entries, shape=(len(code), len(block)))
        blocks = (gather @ matrices.stiffness.reshape(-1, 9)).reshape(-1, 3, 3)
        rows, columns = np.divmod(code, count)
        starts = np.concatenate([[0], np.cumsum(np.bincount(rows, minlength=count))])
        total = total + sp.bsr_array((blocks, columns, starts), shape=total.shape).tocsr()
        mass += np.bincount(flat.ravel(), matrices.mass.ravel(), count)
    return total
