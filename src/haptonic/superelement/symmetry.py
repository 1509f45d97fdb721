"""Folding a mirror-symmetric cell: every field splits into classes that are even or odd in each mirror.

Within a class the values on a quarter of the cell give the whole field, so one problem becomes four of a
quarter of the size, on one and the same sparsity pattern. Where pillars stand on both faces, the plate's
middle plane is a mirror as well, and an eighth is enough.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from itertools import product

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Ints
from haptonic.cell import TileShape, Topology
from haptonic.cell.tile import HALF_TURNED, Sides

Folds = tuple[tuple[Sides, tuple[int, int, int]], ...]  # operations, and what each does to components

MIRRORS = np.diag([-1.0, 1.0, 1.0]), np.diag([1.0, -1.0, 1.0])  # across x and across y
THROUGH = np.array([1, 1, -1], dtype=np.int8)  # what the mirror in the middle plane does to components
DIAGONAL = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])  # exchanges x and y
THIRD = np.array([[-0.5, -np.sqrt(0.75), 0.0], [np.sqrt(0.75), -0.5, 0.0], [0.0, 0.0, 1.0]])  # of a turn


def folds_of(tile: TileShape) -> Folds:
    """The mirrors across x and y that a tile has, or else its half-turn, or else nothing."""
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
    origin : (representatives,) node that each of them is in the mesh
        faces, then those on an open top; of a piece of a pillar those on its open end below are the first
        of the boundary
    interior : how many of the representatives are not on the boundary
    chosen : for each family of elements (m,) numbers, one of each set of images; weight : sizes of the sets
    sign : (classes, nodes, 3) value at a node = sign times value at its representative, 0 where a class
        forces the component to vanish
    parity : (classes, operations) +1 even, -1 odd; component : (operations, 3) signs of displacements
    middle : (classes,) +1 symmetric, -1 antisymmetric about the middle plane, 0 where that is no mirror
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
    """Fold a mesh by operations that are their own inverses (none: one class, nothing folded).

    One that has a lower half is folded in the middle plane as well.

    With an open top the highest level of nodes belongs to the boundary, beside the lateral faces.
    """
    nodes = np.arange(topology.nodes)
    # images of every node under all products of the operations; the smallest number represents them
    moves = [topology.permutation(op) for op, _ in folds] + [topology.image] * topology.mirrored
    masks = list(product((0, 1), repeat=len(moves)))
    images = []
    for mask in masks:
        image = nodes
        for used, move in zip(mask, moves, strict=True):
            image = move[image] if used else image
        images.append(image)
    table = np.stack(images)
    representative = table.min(axis=0)
    via = table.argmin(axis=0)  # which product leads there

    outer = np.zeros(len(nodes), dtype=bool)
    outer[topology.rim] = True
    outer[topology.top] |= open_top
    outer[: topology.level_start[1]] |= topology.free  # an open end
    unique = np.unique(representative)
    order = np.concatenate([unique[~outer[unique]], unique[outer[unique]]])
    number = np.empty(len(nodes), dtype=np.int64)
    number[order] = np.arange(len(order))

    parities = list(product((1, -1), repeat=len(moves)))
    parity = np.array(parities, dtype=np.int8).reshape(len(parities), len(moves))
    own = np.array([signs for _, signs in folds], dtype=np.int8).reshape(len(folds), 3)
    component = np.concatenate([own, THROUGH[None]]) if topology.mirrored else own
    # factor[q, m]: what product m of them does to each component in class q
    factor = np.ones((len(parity), len(masks), 3), dtype=np.int8)
    for m, mask in enumerate(masks):
        for k in np.flatnonzero(mask):
            factor[:, m] *= parity[:, k, None] * component[k]
    sign = factor[:, via]
    for m in range(len(masks)):
        fixed = table[m] == nodes  # on a mirror a component must equal its own image, or vanish
        sign[:, fixed] *= (factor[:, m] == 1)[:, None, :]

    picked = [_representative_elements(family.nodes, table) for family in topology.families]
    return Folding(
        node=number[representative],
        origin=order,
        interior=int((~outer[unique]).sum()),
        chosen=tuple(chosen for chosen, _ in picked),
        weight=tuple(weight for _, weight in picked),
        sign=sign,
        parity=parity[:, : len(folds)],
        component=own,
        middle=parity[:, -1] if topology.mirrored else np.zeros(len(parity), dtype=np.int8),
    )


def _representative_elements(nodes: Ints, table: Ints) -> tuple[Ints, Ints]:
    """One element of each set of images under the operations (images, nodes), and the sizes of the sets."""
    # an element is known by the set of its nodes
    of_element = nodes.reshape(len(nodes), -1)
    keys = np.concatenate([np.sort(image[of_element], axis=1) for image in table])
    codes = np.unique(keys, axis=0, return_inverse=True)[1].reshape(len(table), -1).min(axis=0)
    _, chosen, weight = np.unique(codes, return_index=True, return_counts=True)
    return chosen, weight
