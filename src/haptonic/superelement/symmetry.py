"""Folding of a mirror-symmetric cell into classes of fields that are even or odd in each mirror.

Within a class the values on a quarter of the cell give the whole field, so one problem becomes four problems
of a quarter of its size with the same sparsity pattern. With pillars on both faces, the middle plane of the
plate is a mirror as well, and an eighth is enough.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import product

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Ints
from haptonic.cell import TileShape, Topology
from haptonic.cell.tile import HALF_TURNED, Sides

# operations, and the signs that each gives to the components
Folds = tuple[tuple[Sides, tuple[int, int, int]], ...]

MIRRORS = np.diag([-1.0, 1.0, 1.0]), np.diag([1.0, -1.0, 1.0])  # across x and across y
THROUGH = np.array([1, 1, -1], dtype=np.int8)  # signs of components after the mirror in the middle plane
DIAGONAL = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])  # exchanges x and y
THIRD = np.array([[-0.5, -np.sqrt(0.75), 0.0], [np.sqrt(0.75), -0.5, 0.0], [0.0, 0.0, 1.0]])  # of a turn


def folds_of(tile: TileShape) -> Folds:
    """Mirrors of a tile across x and y; if there are none its half-turn, or an empty tuple."""
    mirrors = tuple(_fold(tile, turn) for turn in MIRRORS if tile.has_symmetry(turn))
    return mirrors or tuple(_fold(tile, turn) for turn in (HALF_TURNED,) if tile.has_symmetry(turn))


def _fold(tile: TileShape, turn: NDArray[np.float64]) -> tuple[Sides, tuple[int, int, int]]:
    sides, (x, y, z) = tile.moved_sides(turn), np.diag(turn).astype(int)
    assert sides is not None
    return sides, (int(x), int(y), int(z))


@dataclass(frozen=True, eq=False)
class Folding:
    """Representatives of nodes and elements under the operations, and the signs that unfold a field.

    node : (nodes,) number of each node's representative; interior ones come first, then those on lateral
        faces, then those on an open top
    origin : (representatives,) number of each representative in the mesh; for a piece of a pillar, those on
        its lower open end are the first of the boundary
    interior : number of representatives that are not on the boundary
    chosen : for each family of elements (m,) numbers, one of each set of images; weight : sizes of the sets
    sign : (classes, nodes, 3) value at a node = sign times value at its representative, 0 where the
        component is zero in a class
    parity : (classes, operations) +1 even, -1 odd; component : (operations, 3) signs of displacements
    middle : (classes,) +1 symmetric, -1 antisymmetric about the middle plane, 0 if that is not a mirror
    """

    node: Ints
    origin: Ints
    interior: int
    chosen: tuple[Ints, ...]
    weight: tuple[Ints, ...]
    sign: NDArray[np.int8]
    parity: NDArray[np.int8]
    component: NDArray[np.int8]
    middle: NDArray[np.int8]

    @property
    def classes(self) -> int:
        return len(self.sign)


@lru_cache(maxsize=64)
def fold(topology: Topology, folds: Folds, *, open_top: bool = False) -> Folding:
    """Fold a mesh by operations that are their own inverses; without operations there is one class.

    A mesh with an image below the middle plane is folded there as well.

    With an open top the boundary consists of the lateral faces and the highest level of nodes.
    """
    nodes = np.arange(topology.nodes)
    moves = [topology.permutation(op) for op, _ in folds] + [topology.image] * topology.mirrored
    signs_of_folds = _signs_of_components(folds)
    component = np.concatenate([signs_of_folds, THROUGH[None]]) if topology.mirrored else signs_of_folds
    table, sign, parity = _orbits(nodes, moves, component)
    representative = table.min(axis=0)

    outer = np.zeros(len(nodes), dtype=bool)
    outer[topology.rim] = True
    outer[topology.top] |= open_top
    outer[: topology.level_start[1]] |= topology.free  # an open end
    unique = np.unique(representative)
    order = np.concatenate([unique[~outer[unique]], unique[outer[unique]]])
    number = np.empty(len(nodes), dtype=np.int64)
    number[order] = np.arange(len(order))

    picked = [_representative_elements(family.nodes, table) for family in topology.families]
    return Folding(
        node=number[representative],
        origin=order,
        interior=int((~outer[unique]).sum()),
        chosen=tuple(chosen for chosen, _ in picked),
        weight=tuple(weight for _, weight in picked),
        sign=sign,
        parity=parity[:, : len(folds)],
        component=signs_of_folds,
        middle=parity[:, -1] if topology.mirrored else np.zeros(len(parity), dtype=np.int8),
    )


@lru_cache(maxsize=64)
def fold_rim(topology: Topology, folds: Folds) -> Folding:
    """Fold the places of the trace on the rim, with classes as for the mesh; there is no interior."""
    component = _signs_of_components(folds)
    moves = [topology.moved_rim(op) for op, _ in folds]
    table, sign, parity = _orbits(np.arange(topology.rim_nodes), moves, component)
    origin, node = np.unique(table.min(axis=0), return_inverse=True)
    faces = 2 if topology.mirrored else 1
    return Folding(
        node=node,
        origin=origin,
        interior=0,
        chosen=(),
        weight=(),
        sign=np.repeat(sign, faces, axis=0),
        parity=np.repeat(parity, faces, axis=0),
        component=component,
        middle=np.tile(np.array([1, -1] if topology.mirrored else [0], dtype=np.int8), len(parity)),
    )


def _signs_of_components(folds: Folds) -> NDArray[np.int8]:
    """(operations, 3) signs that each operation gives to the components of displacement."""
    return np.array([signs for _, signs in folds], dtype=np.int8).reshape(len(folds), 3)


def _orbits(
    nodes: Ints, moves: Sequence[Ints], component: NDArray[np.int8]
) -> tuple[Ints, NDArray[np.int8], NDArray[np.int8]]:
    """Find the images of nodes under all products of operations; the smallest number represents them.

    moves : image of each node by each operation; component : (operations, 3) signs of displacements

    Returns
    -------
    (products, nodes) images; (classes, nodes, 3) signs and (classes, operations) parities, see `Folding`
    """
    masks = list(product((0, 1), repeat=len(moves)))
    images = []
    for mask in masks:
        image = nodes
        for used, move in zip(mask, moves, strict=True):
            image = move[image] if used else image
        images.append(image)
    table = np.stack(images)
    via = table.argmin(axis=0)  # number of the product that maps the representative to the node
    parities = list(product((1, -1), repeat=len(moves)))
    parity = np.array(parities, dtype=np.int8).reshape(len(parities), len(moves))
    # factor[q, m]: sign that product m gives to each component in class q
    factor = np.ones((len(parity), len(masks), 3), dtype=np.int8)
    for m, mask in enumerate(masks):
        for k in np.flatnonzero(mask):
            factor[:, m] *= parity[:, k, None] * component[k]
    sign = factor[:, via]
    for m in range(len(masks)):
        fixed = table[m] == nodes  # on a mirror a component equals its image or is zero
        sign[:, fixed] *= (factor[:, m] == 1)[:, None, :]
    return table, sign, parity


def _representative_elements(nodes: Ints, table: Ints) -> tuple[Ints, Ints]:
    """One element of each set of images under the operations (images, nodes), and the sizes of the sets."""
    # the set of its nodes identifies an element
    of_element = nodes.reshape(len(nodes), -1)
    keys = np.concatenate([np.sort(image[of_element], axis=1) for image in table])
    codes = np.unique(keys, axis=0, return_inverse=True)[1].reshape(len(table), -1).min(axis=0)
    _, chosen, weight = np.unique(codes, return_index=True, return_counts=True)
    return chosen, weight
