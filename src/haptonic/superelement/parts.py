"""Tiles folded further than by mirrors along their axes: by a third of a turn, or by a mirror on a diagonal.

Where such an operation R leaves a tile as it is, classes of the mirrors are images of each other, of which
one is solved for both, or fall into parts that no stiffness couples.

- The mirror on the diagonal of a square exchanges the two classes that are even in one mirror only: the rows
  of the representation E of the group C4v.
- By a third of a turn each class falls into what R leaves alone, a third of its unknowns, and what sums to
  nothing with its two turned copies. The larger part is the image of another class's, even in every mirror
  in which this one is odd: ``(R - R^2) / sqrt(3)`` takes either to the other, and back with a minus. Of a
  hexagon the smaller parts are the representations A1, A2, B1 and B2 of its group C6v, the larger ones the
  rows of E1 and of E2: six problems of a twelfth or a sixth of the tile, in place of four of a quarter.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Ints
from haptonic.cell import TileShape, Topology
from haptonic.cell.tile import Sides
from haptonic.later import linalg as la, sparse as sp
from haptonic.parallel import each
from haptonic.solvers import Pattern, Solver
from haptonic.superelement.assembly import Assembler
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.interior import Bounded, CraigBampton, reduced
from haptonic.superelement.parallel import KEPT_ENTRIES, with_solver
from haptonic.superelement.symmetry import DIAGONAL, THIRD, Folding
from haptonic.superelement.trace import FoldedTrace

Result = TypeVar("Result")

ROUNDING = 1e-9  # of fields whose components are of order one
INDEPENDENT = 1e-9  # share of the largest motion of an end below which one repeats others


@dataclass(frozen=True, eq=False)
class ClassPart:
    """Part of a symmetry class, or of two as each other's image; its inner unknowns come first.

    fields : of each class (3 representatives, n) sparse, its fields from the part's; the first one is solved
    behind : (n,) the representative at which each unknown is a component of displacement
    interior : of the representatives; inner : of the unknowns; share : these in those of its class
    pattern : of the stiffness on the inner ones
    gather : for some classes, sparse: adds the numbers on the classes' pattern into those on this one; none
        where a class is a part as it is
    """

    fields: dict[int, sp.csr_array]
    behind: Ints
    interior: int
    inner: int
    share: float
    pattern: Pattern
    gather: dict[int, sp.csr_array]

    @cached_property
    def inside(self) -> dict[int, sp.csr_array]:
        """Of each class (3 interior, inner) its fields inside from the part's."""
        rows = 3 * self.interior
        return {q: fields[:rows, : self.inner] for q, fields in self.fields.items()}

    @property
    def is_class(self) -> bool:
        """Whether this is a class as it is, and nobody's image; unfolded too it would cost 5 % of a model."""
        return not self.gather and len(self.fields) == 1


@dataclass(frozen=True)
class PartForms:
    """The matrices of a part before condensation, and how its classes follow from it.

    interior : numbers of the interior stiffness on the part's pattern; body : the other forms
    boundary : of each class (b, own b), the transpose of what gives the part's boundary from the class's
    """

    interior: Array
    body: Bounded
    boundary: dict[int, Array]

    @classmethod
    def of(cls, shared: FoldedMesh, part: ClassPart, ends: Sequence[Array]) -> PartForms:
        """Of a mesh; ``ends`` as for `reduced_by_parts`."""
        folding, first = shared.folding, next(iter(part.fields))
        if part.is_class:
            interior, body = shared.symmetry_class(first, ends[first] if ends else None)
            return cls(interior, body, {first: np.eye(len(body.outer_mass))})
        on_trace = {q: _on_trace(part, shared.traces[q]) for q in part.fields}
        of_trace = {q: _shares(own, shared.traces[q].images) for q, own in on_trace.items()}
        # motions of the open ends: one set serves those of all its classes
        beyond = folding.interior + shared.traces[first].rim_size
        at_ends = {q: fields[3 * beyond :, part.behind >= beyond] for q, fields in part.fields.items()}
        images = np.repeat(np.bincount(folding.node)[beyond:], 3)
        met = (
            [_shares(own, images) @ ends[q] for q, own in at_ends.items()] if ends else [np.zeros((0, 0))] * 2
        )
        motions, size, turn = la.svd(np.hstack(met), full_matrices=False)
        kept = size > INDEPENDENT * size.max(initial=0.0)
        motions, turn = motions[:, kept], (size[:, None] * turn)[kept]
        of_ends = np.split(turn, np.cumsum([one.shape[1] for one in met])[:-1], axis=1)

        interior, body = shared.symmetry_class(first, at_ends[first] @ motions if ends else None)
        boundary = la.block_diag(on_trace[first].toarray(), np.eye(len(turn)))
        if part.gather:
            numbers = {
                q: shared.assembler.assembled(shared.paired, q).unsprung() for q in part.gather if q != first
            }
            numbers[first] = interior
            interior = np.sum([gather @ numbers[q] for q, gather in part.gather.items()], axis=0)
        return cls(
            interior=interior,
            body=Bounded(
                coupling=part.inside[first].T @ body.coupling @ boundary,
                outer_stiffness=boundary.T @ body.outer_stiffness @ boundary,
                outer_mass=boundary.T @ body.outer_mass @ boundary,
                mass=part.inside[first].power(2).T @ body.mass,
            ),
            boundary={
                q: la.block_diag(of_trace[q].toarray(), of_end).T
                for q, of_end in zip(part.fields, of_ends, strict=False)
            },
        )


def reduced_by_parts(shared: FoldedMesh, ends: Sequence[Array], steps: int, block: int) -> list[CraigBampton]:
    """Each class of a mesh, reduced by its parts.

    ends : of each class the motions of open ends, as for `FoldedMesh.symmetry_class`, or nothing
    steps, block : as for a class, of which each part has its share
    """

    def one(part: ClassPart, solver: Solver) -> dict[int, CraigBampton]:
        forms = PartForms.of(shared, part, ends)
        solver.factorise(forms.interior)
        found = reduced(solver, forms.body, steps, math.ceil(block * part.share))
        if part.is_class:
            return dict.fromkeys(part.fields, found)
        return {q: found.unfolded(part.inside[q], own) for q, own in forms.boundary.items()}

    found = for_each_part(shared, one)
    return [
        CraigBampton.together([own[q] for own in found if q in own]) for q in range(shared.folding.classes)
    ]


def for_each_part(shared: FoldedMesh, work: Callable[[ClassPart, Solver], Result]) -> list[Result]:
    """``work(part, solver)`` for all parts of a mesh; no two at a time share a solver.

    Parts share nothing but read-only arrays. Threads of our own on them beat threads inside the linear
    algebra, whose matrices are small here.
    """

    def one(part: ClassPart) -> Result:
        return with_solver(part.pattern, lambda solver: work(part, solver))

    return each(one, parts_of_mesh(shared))


def parts_of_mesh(shared: FoldedMesh) -> tuple[ClassPart, ...]:
    """Of all classes, the larger ones first."""
    folding, topology, has = shared.folding, shared.mesh.topology, shared.cell.has_symmetry
    by_mirrors = folding.component.size and (folding.component[:, :2].prod(axis=1) < 0).all()
    # beyond that the index work takes more memory than factors do
    small = len(shared.assembler.pattern.indices) <= KEPT_ENTRIES
    if by_mirrors and small and has(THIRD):
        return parts_by_thirds(shared.assembler, topology, _sides(shared.cell, THIRD))
    if len(folding.component) == 2 and has(DIAGONAL):
        return parts_by_diagonal(shared.assembler, topology, _sides(shared.cell, DIAGONAL))
    return whole_classes(shared.assembler)


def whole_classes(assembler: Assembler) -> tuple[ClassPart, ...]:
    """Every class as it is."""
    same = _same(assembler.folding)
    return tuple(_whole(assembler, {q: same}) for q in range(assembler.folding.classes))


def _sides(cell: TileShape, turn: Array) -> Sides:
    sides = cell.moved_sides(turn)
    assert sides is not None, "no symmetry of this tile"
    return sides


def _on_trace(part: ClassPart, trace: FoldedTrace) -> sp.csr_array:
    """(b, n) own unknowns of a class's trace from a part's, as many on each level."""
    beyond = trace.folding.interior + trace.rim_size
    low = beyond - trace.sites
    on_level = (part.behind >= low) & (part.behind < beyond)
    level = part.fields[trace.symmetry_class][3 * low : 3 * beyond, on_level]
    every = sp.csr_array(sp.kron(sp.eye_array(trace.own_levels), level))[trace.kept]
    return every[:, abs(every).sum(axis=0) > ROUNDING]  # in the middle plane components vanish


def _shares(fields: sp.csr_array, images: NDArray[Any]) -> sp.csr_array:
    """(n, m) unknowns of a part from those (m,) of its class, each of which stands for so many images."""
    weighted = sp.csr_array(fields.multiply(images[:, None]))
    return sp.csr_array((weighted / weighted.multiply(fields).sum(axis=0)).T)


@lru_cache(maxsize=4)
def parts_by_diagonal(assembler: Assembler, topology: Topology, sides: Sides) -> tuple[ClassPart, ...]:
    """The classes, of two that the mirror on the diagonal exchanges one for both.

    A class that it takes to itself would fall into an even and an odd half. Tried, these took as long as the
    class with a pillar on one face, and a fifth longer with two, whose classes are small already.

    sides : where it takes the tile's first two
    """
    both = _parities(assembler.folding)
    turn, same = _turning(assembler, topology, sides, DIAGONAL), _same(assembler.folding)
    images = {q: both.index((*parity[::-1], middle)) for q, (*parity, middle) in enumerate(both)}
    return tuple(
        _whole(assembler, {q: same} if q == image else {q: same, image: turn(q, image)})
        for q, image in images.items()
        if q <= image
    )


@lru_cache(maxsize=4)
def parts_by_thirds(assembler: Assembler, topology: Topology, sides: Sides) -> tuple[ClassPart, ...]:
    """The parts of all classes, the larger ones first.

    sides : where a third of a turn takes the tile's first two
    """
    folding, moved = assembler.folding, topology.permutation(sides)
    count, same = len(folding.origin), _same(folding)
    turn = _turning(assembler, topology, sides, THIRD)
    images = np.bincount(folding.node)
    # of representatives that it exchanges one, on a mirror if any is: there components just vanish or do not
    orbit = folding.node[np.stack([folding.origin, moved[folding.origin], moved[moved[folding.origin]]])]
    least = (images[orbit] * count + orbit).argmin(axis=0)
    chosen = np.unique(orbit[least, np.arange(count)])
    on_axis = (orbit[:, chosen] == chosen).all(axis=0)
    component = (3 * chosen[:, None] + np.arange(3)).ravel()
    alive = [component[sign[folding.origin].ravel()[component] != 0] for sign in folding.sign]
    both = _parities(folding)
    full, root = _positions(assembler.pattern), 2 / math.sqrt(3)
    small, large = [], []
    for q, (*parity, middle) in enumerate(both):
        own = (same + 2 * turn(q, q)) / 3
        small.append(_part(full, folding.interior, {q: own}, [(q, 1.0, alive[q])], 1 / 3))
        other = both.index((*(-one for one in parity), middle))
        if q < other:
            # by its values at the chosen nodes, and by those of its image; on the axis these are one
            off_axis = alive[other][~np.isin(alive[other] // 3, chosen[on_axis])]
            own = sp.hstack([2 / 3 * (same - turn(q, q)), root * turn(other, q)], format="csr")
            fields = {q: own, other: root * turn(q, other) @ own}
            by = [(q, 1.0, alive[q]), (other, -1.0, off_axis)]
            large.append(_part(full, folding.interior, fields, by, 2 / 3))
    return (*large, *small)


def _parities(folding: Folding) -> list[tuple[int, ...]]:
    """Of each class in its operations, and last in the middle plane."""
    return [tuple(one) for one in np.column_stack([folding.parity, folding.middle]).tolist()]


def _turning(
    assembler: Assembler, topology: Topology, sides: Sides, operation: Array
) -> Callable[[int, int], sp.csr_array]:
    """What an operation makes of fields of one class (3 representatives) in another."""
    folding, moved, nodes = assembler.folding, topology.permutation(sides), topology.nodes
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
    """(3 representatives,) * 2 fields as they are."""
    return sp.eye_array(3 * len(folding.origin), format="csr")


def _whole(assembler: Assembler, fields: dict[int, sp.csr_array]) -> ClassPart:
    """A class that is a part as it is, perhaps with another as its image; inside, what vanishes stays."""
    folding = assembler.folding
    behind = np.repeat(np.arange(len(folding.origin)), 3)
    kept = (behind < folding.interior) | (folding.sign[next(iter(fields))][folding.origin].ravel() != 0)
    return ClassPart(
        fields={q: own[:, kept] for q, own in fields.items()},
        behind=behind[kept],
        interior=folding.interior,
        inner=3 * folding.interior,
        share=1.0,
        pattern=assembler.pattern,
        gather={},
    )


def _positions(pattern: Pattern) -> sp.csr_array:
    """Where each number of the whole symmetric matrix stands among those on its pattern."""
    row = np.repeat(np.arange(pattern.size), np.diff(pattern.indptr))
    off = row != pattern.indices
    ends = (np.concatenate([row, pattern.indices[off]]), np.concatenate([pattern.indices, row[off]]))
    number = np.arange(len(row))
    return sp.csr_array((np.concatenate([number, number[off]]), ends), shape=(pattern.size, pattern.size))


def _part(
    full: sp.csr_array,
    interior: int,
    fields: dict[int, sp.csr_array],
    chosen: list[tuple[int, float, Ints]],
    share: float,
) -> ClassPart:
    """A part that some columns of fields span.

    full : see `_positions`
    chosen : of each block of columns a class, a sign and the numbers of those to take. A column is the share
        that a unit component of the class has in the part, so stiffness on the part is the stiffness of
        that component on fields of the class, times the sign
    share : as of a `ClassPart`
    """
    size = next(iter(fields.values())).shape[0]
    column = np.concatenate([number * size + own for number, (_, _, own) in enumerate(chosen)])
    column = column[abs(next(iter(fields.values()))).sum(axis=0)[column] > ROUNDING]
    column = column[np.argsort(column % size, kind="stable")]
    fields = {q: own[:, column] for q, own in fields.items()}
    for own in fields.values():
        own.data[np.abs(own.data) < ROUNDING] = 0.0
        own.eliminate_zeros()
    behind = column % size // 3
    inner = int((behind < interior).sum())
    codes, values, numbers = [], [], []
    for block, (q, sign, _) in enumerate(chosen):
        mine = np.flatnonzero(column[:inner] // size == block)
        rows, inside = full[column[mine] % size].tocoo(), fields[q][: 3 * interior, :inner]
        # each number of these rows times the entries of the fields in its column
        length = np.diff(inside.indptr)[rows.col]
        at = np.repeat(inside.indptr[rows.col] - np.cumsum(length) + length, length) + np.arange(length.sum())
        i, j = np.repeat(mine[rows.row], length), inside.indices[at]
        upper = i <= j
        codes.append((i * inner + j)[upper])
        values.append(sign * inside.data[at[upper]])
        numbers.append(np.repeat(rows.data, length)[upper])
    code, place = np.unique(np.concatenate(codes), return_inverse=True)
    places = np.split(place, np.cumsum([len(one) for one in codes])[:-1])
    shape = (len(code), int(full.data.max()) + 1)
    gather = {
        q: sp.csr_array((value, (place, number)), shape=shape)
        for (q, _, _), value, place, number in zip(chosen, values, places, numbers, strict=True)
    }
    i, j = np.divmod(code, inner)
    indptr = np.concatenate([[0], np.cumsum(np.bincount(i, minlength=inner))])
    return ClassPart(
        fields=fields,
        behind=behind,
        interior=interior,
        inner=inner,
        share=share,
        pattern=Pattern(indptr.astype(np.int32), j.astype(np.int32)),
        gather=gather,
    )
