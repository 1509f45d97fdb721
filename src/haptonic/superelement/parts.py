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
from haptonic.superelement.interior import MISSED_BY_BANDS, Bounded, CraigBampton, reduced
from haptonic.superelement.parallel import KEPT_ENTRIES, with_solver
from haptonic.superelement.symmetry import DIAGONAL, THIRD, Folding
from haptonic.superelement.trace import FoldedTrace

Result = TypeVar("Result")

ROUNDING = 1e-9  # smallest significant entry of fields with components of order one
INDEPENDENT = 1e-9  # share of the largest motion of an end below which a motion depends on others


@dataclass(frozen=True, eq=False)
class ClassPart:
    """Part of a symmetry class, or of two classes that are each other's image; inner unknowns come first.

    fields : for each class, sparse (3 representatives, n) fields of the class from unknowns of the part; the
        first class is solved
    behind : (n,) the representative at which each unknown is a component of displacement
    interior : number of interior representatives; inner : number of inner unknowns
    share : ratio of the part's unknowns to those of its class
    pattern : of the stiffness on the inner unknowns
    gather : for some classes, sparse matrix that adds values on the classes' pattern into values on this
        pattern; empty if the part is a complete class
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
        """For each class, (3 interior, inner) its interior fields from inner unknowns of the part."""
        rows = 3 * self.interior
        return {q: fields[:rows, : self.inner] for q, fields in self.fields.items()}

    @property
    def is_class(self) -> bool:
        """True for a complete class without an image; to unfold it would take 5 % of a model's time."""
        return not self.gather and len(self.fields) == 1


@dataclass(frozen=True)
class PartForms:
    """Matrices of a part before condensation, and its relation to its classes.

    interior : values of the interior stiffness on the part's pattern; body : the other forms
    boundary : for each class, (b, b of the part) transpose of the matrix from the class's boundary to the
        part's
    """

    interior: Array
    body: Bounded
    boundary: dict[int, Array]

    @classmethod
    def of(cls, shared: FoldedMesh, part: ClassPart, ends: Sequence[Array]) -> PartForms:
        """Compute the matrices of a part of a mesh; ``ends`` as for `reduced_by_parts`."""
        folding, first = shared.folding, next(iter(part.fields))
        if part.is_class:
            interior, body = shared.symmetry_class(first, ends[first] if ends else None)
            return cls(interior, body, {first: np.eye(len(body.outer_mass))})
        on_trace = {q: _on_trace(part, shared.traces[q]) for q in part.fields}
        of_trace = {q: _shares(fields, shared.traces[q].images) for q, fields in on_trace.items()}
        # one set of motions of the open ends for all classes of the part
        beyond = folding.interior + shared.traces[first].rim_size
        at_ends = {q: fields[3 * beyond :, part.behind >= beyond] for q, fields in part.fields.items()}
        images = np.repeat(np.bincount(folding.node)[beyond:], 3)
        met = (
            [_shares(of_class, images) @ ends[q] for q, of_class in at_ends.items()]
            if ends
            else [np.zeros((0, 0))] * 2
        )
        motions, size, turn = la.svd(np.hstack(met), full_matrices=False)
        independent = size > INDEPENDENT * size.max(initial=0.0)
        motions, turn = motions[:, independent], (size[:, None] * turn)[independent]
        of_ends = np.split(turn, np.cumsum([share.shape[1] for share in met])[:-1], axis=1)

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


def reduced_by_parts(
    shared: FoldedMesh, ends: Sequence[Array], steps: int, block: int, highest: float | None = None
) -> list[CraigBampton]:
    """Reduce each class of a mesh by its parts.

    ends : for each class the motions of open ends, as for `FoldedMesh.symmetry_class`, or empty
    steps, block : as for a class; each part gets its share of the block
    highest : Hz, up to which few modes suffice; by default all modes are used
    """

    def reduced_classes(part: ClassPart, solver: Solver) -> dict[int, CraigBampton]:
        forms = PartForms.of(shared, part, ends)
        solver.factorise(forms.interior)
        of_part = reduced(solver, forms.body, steps, math.ceil(block * part.share))
        if highest is not None:
            of_part = of_part.with_few_modes(highest, MISSED_BY_BANDS)
        if part.is_class:
            return dict.fromkeys(part.fields, of_part)
        return {q: of_part.unfolded(part.inside[q], boundary) for q, boundary in forms.boundary.items()}

    parts = for_each_part(shared, reduced_classes)
    return [
        CraigBampton.together([of_part[q] for of_part in parts if q in of_part])
        for q in range(shared.folding.classes)
    ]


def for_each_part(shared: FoldedMesh, work: Callable[[ClassPart, Solver], Result]) -> list[Result]:
    """Return ``work(part, solver)`` for all parts of a mesh; no two threads share a solver.

    Parts share read-only arrays only. One thread per part is faster than threads inside the linear algebra,
    whose matrices are small here.
    """

    def work_with_solver(part: ClassPart) -> Result:
        return with_solver(part.pattern, lambda solver: work(part, solver))

    return each(work_with_solver, parts_of_mesh(shared))


def parts_of_mesh(shared: FoldedMesh) -> tuple[ClassPart, ...]:
    """Parts of all classes of a mesh, the larger parts first."""
    folding, topology, has = shared.folding, shared.mesh.topology, shared.cell.has_symmetry
    by_mirrors = folding.component.size and (folding.component[:, :2].prod(axis=1) < 0).all()
    # for a larger pattern the index work needs more memory than the factors
    small = len(shared.assembler.pattern.indices) <= KEPT_ENTRIES
    if by_mirrors and small and has(THIRD):
        return parts_by_thirds(shared.assembler, topology, _sides(shared.cell, THIRD))
    if len(folding.component) == 2 and has(DIAGONAL):
        return parts_by_diagonal(shared.assembler, topology, _sides(shared.cell, DIAGONAL))
    return whole_classes(shared.assembler)


def whole_classes(assembler: Assembler) -> tuple[ClassPart, ...]:
    """Every class as one part."""
    same = _same(assembler.folding)
    return tuple(_whole(assembler, {q: same}) for q in range(assembler.folding.classes))


def _sides(cell: TileShape, turn: Array) -> Sides:
    sides = cell.moved_sides(turn)
    assert sides is not None, "no symmetry of this tile"
    return sides


def _on_trace(part: ClassPart, trace: FoldedTrace) -> sp.csr_array:
    """(b, n) unknowns of a class's trace from those of a part, as many on each level."""
    beyond = trace.folding.interior + trace.rim_size
    low = beyond - trace.sites
    on_level = (part.behind >= low) & (part.behind < beyond)
    level = part.fields[trace.symmetry_class][3 * low : 3 * beyond, on_level]
    every = sp.csr_array(sp.kron(sp.eye_array(trace.own_levels), level))[trace.kept]
    return every[:, abs(every).sum(axis=0) > ROUNDING]  # some components are zero in the middle plane


def _shares(fields: sp.csr_array, images: NDArray[Any]) -> sp.csr_array:
    """(n, m) unknowns of a part from those of its class; ``images`` (m,) number of images of each."""
    weighted = sp.csr_array(fields.multiply(images[:, None]))
    return sp.csr_array((weighted / weighted.multiply(fields).sum(axis=0)).T)


@lru_cache(maxsize=4)
def parts_by_diagonal(assembler: Assembler, topology: Topology, sides: Sides) -> tuple[ClassPart, ...]:
    """Parts by the mirror on the diagonal: one part for two classes that the mirror exchanges.

    A class that the mirror maps to itself is not divided into an even and an odd half. Measured: the halves
    took as long as the class with a pillar on one face, and a fifth longer with pillars on two faces.

    sides : images of the tile's first two sides
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
    """Parts of all classes by a third of a turn, the larger parts first.

    sides : images of the tile's first two sides by a third of a turn
    """
    folding, moved = assembler.folding, topology.permutation(sides)
    count, same = len(folding.origin), _same(folding)
    turn = _turning(assembler, topology, sides, THIRD)
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
    full, root = _positions(assembler.pattern), 2 / math.sqrt(3)
    small, large = [], []
    for q, (*parity, middle) in enumerate(both):
        spanned = (same + 2 * turn(q, q)) / 3
        small.append(_part(full, folding.interior, {q: spanned}, [(q, 1.0, alive[q])], 1 / 3))
        other = both.index((*(-sign for sign in parity), middle))
        if q < other:
            # spanned by values at the chosen nodes and by those of the image, which are equal on the axis
            off_axis = alive[other][~np.isin(alive[other] // 3, chosen[on_axis])]
            spanned = sp.hstack([2 / 3 * (same - turn(q, q)), root * turn(other, q)], format="csr")
            fields = {q: spanned, other: root * turn(q, other) @ spanned}
            by = [(q, 1.0, alive[q]), (other, -1.0, off_axis)]
            large.append(_part(full, folding.interior, fields, by, 2 / 3))
    return (*large, *small)


def _parities(folding: Folding) -> list[tuple[int, ...]]:
    """Parities of each class in its operations, and last in the middle plane."""
    return [tuple(row) for row in np.column_stack([folding.parity, folding.middle]).tolist()]


def _turning(
    assembler: Assembler, topology: Topology, sides: Sides, operation: Array
) -> Callable[[int, int], sp.csr_array]:
    """Return ``turn(q, other)``, a function for the matrix from fields of a class to images in another."""
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
    """(3 representatives, 3 representatives) identity."""
    return sp.eye_array(3 * len(folding.origin), format="csr")


def _whole(assembler: Assembler, fields: dict[int, sp.csr_array]) -> ClassPart:
    """Make a part of a complete class, perhaps with an image, with zero components inside retained."""
    folding = assembler.folding
    behind = np.repeat(np.arange(len(folding.origin)), 3)
    retained = (behind < folding.interior) | (folding.sign[next(iter(fields))][folding.origin].ravel() != 0)
    return ClassPart(
        fields={q: of_class[:, retained] for q, of_class in fields.items()},
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


def _part(
    full: sp.csr_array,
    interior: int,
    fields: dict[int, sp.csr_array],
    chosen: list[tuple[int, float, Ints]],
    share: float,
) -> ClassPart:
    """Make the part that some columns of fields span.

    full : see `_positions`
    chosen : for each block of columns a class, a sign and the numbers of the columns to use. A column is the
        share of a unit component of the class in the part, so stiffness on the part is the stiffness of
        that component on fields of the class, times the sign
    share : see `ClassPart`
    """
    size = next(iter(fields.values())).shape[0]
    column = np.concatenate([number * size + numbers for number, (_, _, numbers) in enumerate(chosen)])
    column = column[abs(next(iter(fields.values()))).sum(axis=0)[column] > ROUNDING]
    column = column[np.argsort(column % size, kind="stable")]
    fields = {q: of_class[:, column] for q, of_class in fields.items()}
    for of_class in fields.values():
        of_class.data[np.abs(of_class.data) < ROUNDING] = 0.0
        of_class.eliminate_zeros()
    behind = column % size // 3
    inner = int((behind < interior).sum())
    codes, values, numbers = [], [], []
    for block, (q, sign, _) in enumerate(chosen):
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
