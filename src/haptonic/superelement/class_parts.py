"""Further division of symmetry classes, by a third of a turn or by a mirror on a diagonal.

If such an operation R leaves a tile unchanged, two classes of the mirrors are images of each other and one
is solved for both, or a class splits into parts without coupling.

- The mirror on the diagonal of a square exchanges the two classes that are even in one mirror only: the rows
  of the representation E of the group C4v.
- A third of a turn splits each class into fields invariant under R (a third of the unknowns) and fields
  whose sum with their two rotated copies is zero. This larger part is the image of the larger part of
  another class, which is even in every mirror in which this class is odd: ``(R - R^2) / sqrt(3)`` maps either
  to the other, with a minus sign on the way back. For a hexagon, the smaller parts are the representations
  A1, A2, B1 and B2 of its group C6v, and the larger parts the rows of E1 and of E2: six problems of a
  twelfth or a sixth of the tile instead of four of a quarter.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell import TileShape, Topology
from haptonic.cell.tile import Sides
from haptonic.later import sparse as sp
from haptonic.solvers import Pattern
from haptonic.superelement.assembly import Assembler
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.parallel import KEPT_ENTRIES
from haptonic.superelement.symmetry import DIAGONAL, THIRD, Folding

Turning = Callable[[int, int], sp.csr_array]  # from fields of a class to images in another

ROUNDING = 1e-9  # smallest significant entry of fields with components of order one


@dataclass(frozen=True, eq=False)
class ClassPart:
    """Part of a symmetry class, or of two classes that are each other's image; inner unknowns come first.

    fields : for each class, sparse (3 representatives, n) fields of the class from unknowns of the part; the
        first class is solved
    on_rim : for each class, sparse (3 representatives, m) fields at the places of the trace from the part's
        unknowns on one of its levels
    behind : (n,) the representative at which each unknown is a component of displacement
    interior : number of interior representatives; inner : number of inner unknowns
    share : ratio of the part's unknowns to those of its class
    pattern : of the stiffness on the inner unknowns
    gather : for some classes, sparse matrix that adds values on the classes' pattern into values on this
        pattern; empty if the part is a complete class
    """

    fields: dict[int, sp.csr_array]
    on_rim: dict[int, sp.csr_array]
    behind: Ints
    interior: int
    inner: int
    share: float
    pattern: Pattern
    gather: dict[int, sp.csr_array]

    @cached_property
    def inside(self) -> dict[int, sp.csr_array]:
        """For each class, (3 interior, inner) its interior fields from inner unknowns of the part."""
        rows = 3 * self.interior
        return {q: fields[:rows, : self.inner] for q, fields in self.fields.items()}

    @property
    def is_class(self) -> bool:
        """True for a complete class without an image; to unfold it would take 5 % of a model's time."""
        return not self.gather and len(self.fields) == 1


def parts_of_mesh(shared: FoldedMesh) -> tuple[ClassPart, ...]:
    """Parts of all classes of a mesh, the larger parts first."""
    folding, has = shared.folding, shared.cell.has_symmetry
    assembler, topology, rim = shared.assembler, shared.mesh.topology, shared.rim
    by_mirrors = folding.component.size and (folding.component[:, :2].prod(axis=1) < 0).all()
    # for a larger pattern the index work needs more memory than the factors
    small = len(shared.assembler.pattern.indices) <= KEPT_ENTRIES
    if by_mirrors and small and has(THIRD):
        return parts_by_thirds(assembler, topology, rim, _sides(shared.cell, THIRD))
    if len(folding.component) == 2 and has(DIAGONAL):
        return parts_by_diagonal(assembler, topology, rim, _sides(shared.cell, DIAGONAL))
    return whole_classes(assembler, rim)


def whole_classes(assembler: Assembler, rim: Folding) -> tuple[ClassPart, ...]:
    """Every class as one part."""
    same, on_rim = _same(assembler.folding), _same(rim)
    return tuple(_whole(assembler, rim, {q: same}, {q: on_rim}) for q in range(assembler.folding.classes))


def _sides(cell: TileShape, turn: Array) -> Sides:
    sides = cell.moved_sides(turn)
    assert sides is not None, "no symmetry of this tile"
    return sides


@lru_cache(maxsize=4)
def parts_by_diagonal(
    assembler: Assembler, topology: Topology, rim: Folding, sides: Sides
) -> tuple[ClassPart, ...]:
    """Parts by the mirror on the diagonal: one part for two classes that the mirror exchanges.

    A class that the mirror maps to itself is not divided: its even and odd halves take as long or longer.

    rim : folded places of the trace; sides : images of the tile's first two sides
    """
    folding, both = assembler.folding, _parities(assembler.folding)
    on_mesh = _turning(folding, topology.permutation(sides), DIAGONAL)
    on_rim = _turning(rim, topology.moved_rim(sides), DIAGONAL)

    def spanned(of: Folding, turn: Turning, q: int, image: int) -> dict[int, sp.csr_array]:
        return {q: _same(of)} if q == image else {q: _same(of), image: turn(q, image)}

    images = {q: both.index((*parity[::-1], middle)) for q, (*parity, middle) in enumerate(both)}
    return tuple(
        _whole(assembler, rim, spanned(folding, on_mesh, q, image), spanned(rim, on_rim, q, image))
        for q, image in images.items()
        if q <= image
    )


@lru_cache(maxsize=4)
def parts_by_thirds(
    assembler: Assembler, topology: Topology, rim: Folding, sides: Sides
) -> tuple[ClassPart, ...]:
    """Parts of all classes by a third of a turn, the larger parts first.

    rim : folded places of the trace; sides : images of the tile's first two sides by a third of a turn
    """
    folding = assembler.folding
    on_mesh = _spans_by_thirds(folding, topology.permutation(sides))
    on_rim = _spans_by_thirds(rim, topology.moved_rim(sides))
    full = _positions(assembler.pattern)
    return tuple(
        _part(full, folding.interior, span, _columns(span_on_rim)[1])
        for span, span_on_rim in zip(on_mesh, on_rim, strict=True)
    )


@dataclass(frozen=True)
class _Span:
    """Part of some classes, spanned by some columns of fields.

    fields : for each class, sparse (3 representatives, n)
    chosen : for each block of columns a class, a sign and the numbers of the columns to use. A column is the
        share of a unit component of the class in the part, so stiffness on the part is the stiffness of
        that component on fields of the class, times the sign
    share : see `ClassPart`
    """

    fields: dict[int, sp.csr_array]
    chosen: list[tuple[int, float, Ints]]
    share: float


def _spans_by_thirds(folding: Folding, moved: Ints) -> list[_Span]:
    """Parts of all classes by a third of a turn, which moves each node to ``moved``; larger parts first."""
    count, same = len(folding.origin), _same(folding)
    turn = _turning(folding, moved, THIRD)
    images = np.bincount(folding.node)
    # choose one of the representatives that the rotation exchanges, on a mirror if possible: there each
    # component is either free or zero
    orbit = folding.node[np.stack([folding.origin, moved[folding.origin], moved[moved[folding.origin]]])]
    least = (images[orbit] * count + orbit).argmin(axis=0)
    chosen = np.unique(orbit[least, np.arange(count)])
    on_axis = (orbit[:, chosen] == chosen).all(axis=0)
    component = (3 * chosen[:, None] + np.arange(3)).ravel()
    alive = [component[sign[folding.origin].ravel()[component] != 0] for sign in folding.sign]
    both = _parities(folding)
    root = 2 / math.sqrt(3)
    small, large = [], []
    for q, (*parity, middle) in enumerate(both):
        spanned = (same + 2 * turn(q, q)) / 3
        small.append(_Span({q: spanned}, [(q, 1.0, alive[q])], 1 / 3))
        other = both.index((*(-sign for sign in parity), middle))
        if q < other:
            # spanned by values at the chosen nodes and by those of the image, which are equal on the axis
            off_axis = alive[other][~np.isin(alive[other] // 3, chosen[on_axis])]
            spanned = sp.hstack([2 / 3 * (same - turn(q, q)), root * turn(other, q)], format="csr")
            fields = {q: spanned, other: root * turn(q, other) @ spanned}
            by = [(q, 1.0, alive[q]), (other, -1.0, off_axis)]
            large.append(_Span(fields, by, 2 / 3))
    return [*large, *small]


def _parities(folding: Folding) -> list[tuple[int, ...]]:
    """Parities of each class in its operations, and last in the middle plane."""
    return [tuple(row) for row in np.column_stack([folding.parity, folding.middle]).tolist()]


def _turning(folding: Folding, moved: Ints, operation: Array) -> Turning:
    """Return ``turn(q, other)``, a function for the matrix from fields of a class to images in another.

    moved : (nodes,) image of each node by the operation (3, 3)
    """
    nodes = len(moved)
    size, count = 3 * nodes, 3 * len(folding.origin)
    place = sp.csr_array((np.ones(nodes), (moved, np.arange(nodes))), shape=(nodes, nodes))
    turned = sp.csr_array(sp.kron(place, operation))
    unknown = (3 * folding.node[:, None] + np.arange(3)).ravel()
    embed = [
        sp.csr_array((sign.ravel().astype(float), unknown, np.arange(size + 1)), shape=(size, count))
        for sign in folding.sign
    ]
    images = np.repeat(np.bincount(folding.node), 3)[:, None]

    def turn(q: int, other: int) -> sp.csr_array:
        return sp.csr_array((embed[other].T @ turned @ embed[q]).multiply(1 / images))

    return turn


def _same(folding: Folding) -> sp.csr_array:
    """(3 representatives, 3 representatives) identity."""
    return sp.eye_array(3 * len(folding.origin), format="csr")


def _whole(
    assembler: Assembler, rim: Folding, fields: dict[int, sp.csr_array], on_rim: dict[int, sp.csr_array]
) -> ClassPart:
    """Make a part of a complete class, perhaps with an image, with zero components inside retained."""
    folding, first = assembler.folding, next(iter(fields))
    behind = np.repeat(np.arange(len(folding.origin)), 3)
    alive = [of.sign[first][of.origin].ravel() != 0 for of in (folding, rim)]
    retained = (behind < folding.interior) | alive[0]
    return ClassPart(
        fields={q: of_class[:, retained] for q, of_class in fields.items()},
        on_rim={q: of_class[:, alive[1]] for q, of_class in on_rim.items()},
        behind=behind[retained],
        interior=folding.interior,
        inner=3 * folding.interior,
        share=1.0,
        pattern=assembler.pattern,
        gather={},
    )


def _positions(pattern: Pattern) -> sp.csr_array:
    """Position of each entry of the whole symmetric matrix in the values on its pattern."""
    row = np.repeat(np.arange(pattern.size), np.diff(pattern.indptr))
    off = row != pattern.indices
    ends = (np.concatenate([row, pattern.indices[off]]), np.concatenate([pattern.indices, row[off]]))
    number = np.arange(len(row))
    return sp.csr_array((np.concatenate([number, number[off]]), ends), shape=(pattern.size, pattern.size))


def _columns(span: _Span) -> tuple[Ints, dict[int, sp.csr_array]]:
    """Numbers of the columns that a part uses, in the order of the representatives, and its fields."""
    first = next(iter(span.fields.values()))
    size = first.shape[0]
    column = np.concatenate([number * size + numbers for number, (_, _, numbers) in enumerate(span.chosen)])
    column = column[abs(first).sum(axis=0)[column] > ROUNDING]
    column = column[np.argsort(column % size, kind="stable")]
    fields = {q: of_class[:, column] for q, of_class in span.fields.items()}
    for of_class in fields.values():
        of_class.data[np.abs(of_class.data) < ROUNDING] = 0.0
        of_class.eliminate_zeros()
    return column, fields


def _part(full: sp.csr_array, interior: int, span: _Span, on_rim: dict[int, sp.csr_array]) -> ClassPart:
    """Make a part; ``full`` as in `_positions`, ``on_rim`` as in `ClassPart`."""
    column, fields = _columns(span)
    size = next(iter(fields.values())).shape[0]
    behind = column % size // 3
    inner = int((behind < interior).sum())
    codes, values, numbers = [], [], []
    for block, (q, sign, _) in enumerate(span.chosen):
        of_block = np.flatnonzero(column[:inner] // size == block)
        rows, inside = full[column[of_block] % size].tocoo(), fields[q][: 3 * interior, :inner]
        # each entry of these rows times the entries of the fields in its column
        length = np.diff(inside.indptr)[rows.col]
        at = np.repeat(inside.indptr[rows.col] - np.cumsum(length) + length, length) + np.arange(length.sum())
        i, j = np.repeat(of_block[rows.row], length), inside.indices[at]
        upper = i <= j
        codes.append((i * inner + j)[upper])
        values.append(sign * inside.data[at[upper]])
        numbers.append(np.repeat(rows.data, length)[upper])
    code, place = np.unique(np.concatenate(codes), return_inverse=True)
    places = np.split(place, np.cumsum([len(code) for code in codes])[:-1])
    shape = (len(code), int(full.data.max()) + 1)
    gather = {
        q: sp.csr_array((value, (place, number)), shape=shape)
        for (q, _, _), value, place, number in zip(span.chosen, values, places, numbers, strict=True)
    }
    i, j = np.divmod(code, inner)
    indptr = np.concatenate([[0], np.cumsum(np.bincount(i, minlength=inner))])
    return ClassPart(
        fields=fields,
        on_rim=on_rim,
        behind=behind,
        interior=interior,
        inner=inner,
        share=span.share,
        pattern=Pattern(indptr.astype(np.int32), j.astype(np.int32)),
        gather=gather,
    )
