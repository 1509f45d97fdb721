"""Tiles folded further, by a third of a turn: hexagons and triangles have more mirrors than two.

Where a third of a turn R leaves a tile as it is, no stiffness couples fields that R leaves alone with those
whose three turned copies sum to nothing. So each class of the mirrors falls into two parts, of one and of two
thirds of its unknowns. The larger part of a class is the image of another's, even in every mirror in which
this one is odd: ``(R - R^2) / sqrt(3)`` takes either to the other, and back with a minus.

Of a hexagon the smaller parts are the representations A1, A2, B1 and B2 of its group C6v, the larger ones the
rows of E1 and of E2: six problems of a twelfth or a sixth of the tile, in place of four of a quarter.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Ints
from haptonic.cell import Topology
from haptonic.cell.tile import Sides
from haptonic.later import linalg as la, sparse as sp
from haptonic.parallel import each
from haptonic.solvers import Pattern, Solver
from haptonic.superelement.assembly import Assembler
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.interior import Bounded, CraigBampton, reduced
from haptonic.superelement.parallel import KEPT_ENTRIES, with_solver
from haptonic.superelement.trace import FoldedTrace

THIRD = np.array([[-0.5, -math.sqrt(0.75), 0.0], [math.sqrt(0.75), -0.5, 0.0], [0.0, 0.0, 1.0]])
ROUNDING = 1e-9  # of fields whose components are of order one
INDEPENDENT = 1e-9  # share of the largest motion of an end below which one repeats others


@dataclass(frozen=True, eq=False)
class ClassPart:
    """Part of a symmetry class, or of two as each other's image; its inner unknowns come first.

    fields : of each class (3 representatives, n) sparse, its fields from the part's; the first one is solved
    behind : (n,) the representative at which each unknown is a component of displacement
    inner : number of inner unknowns; pattern : of the stiffness on these
    gather : for some classes, sparse: adds the numbers on the classes' pattern into those on this one
    """

    fields: dict[int, sp.csr_array]
    behind: Ints
    inner: int
    pattern: Pattern
    gather: dict[int, sp.csr_array]


def reduced_by_thirds(
    shared: FoldedMesh, ends: Sequence[Array], steps: int, block: int
) -> dict[int, CraigBampton]:
    """Each class of a mesh reduced by its parts; none where it has no parts.

    ends : of each class the motions of open ends, as for `FoldedMesh.symmetry_class`, or nothing
    steps, block : as for a class, of which each part has its share
    """
    folding, sides = shared.folding, shared.cell.moved_sides(THIRD)
    by_mirrors = (folding.component[:, :2].prod(axis=1) < 0).all() and folding.component.size
    small = (
        len(shared.assembler.pattern.indices) <= KEPT_ENTRIES
    )  # the index work takes more memory than factors
    if sides is None or not (by_mirrors and small and shared.cell.has_symmetry(THIRD)):
        return {}
    parts = parts_of(shared.assembler, shared.mesh.topology, sides)

    def one(part: ClassPart) -> dict[int, CraigBampton]:
        size = math.ceil(block * len(part.fields) / 3)
        return with_solver(part.pattern, lambda solver: _reduced(shared, part, solver, ends, steps, size))

    found = each(one, parts)
    return {q: CraigBampton.together([own[q] for own in found if q in own]) for q in range(folding.classes)}


def _reduced(
    shared: FoldedMesh, part: ClassPart, solver: Solver, ends: Sequence[Array], steps: int, block: int
) -> dict[int, CraigBampton]:
    """A part reduced, as fields and forms of its classes."""
    folding, first = shared.folding, next(iter(part.fields))
    traces = {q: FoldedTrace(shared.mesh.topology, folding, q, shared.levels) for q in part.fields}
    on_trace = {q: _on_trace(part, trace) for q, trace in traces.items()}
    of_trace = {q: _shares(own, traces[q].images) for q, own in on_trace.items()}
    # motions of the open ends: one set serves those of all its classes
    beyond = folding.interior + traces[first].rim_size
    at_ends = {q: fields[3 * beyond :, part.behind >= beyond] for q, fields in part.fields.items()}
    images = np.repeat(np.bincount(folding.node)[beyond:], 3)
    met = [_shares(own, images) @ ends[q] for q, own in at_ends.items()] if ends else [np.zeros((0, 0))] * 2
    motions, size, turn = la.svd(np.hstack(met), full_matrices=False)
    kept = size > INDEPENDENT * size.max(initial=0.0)
    motions, turn = motions[:, kept], (size[:, None] * turn)[kept]
    of_ends = np.split(turn, np.cumsum([one.shape[1] for one in met])[:-1], axis=1)

    folded = shared.symmetry_class(first, at_ends[first] @ motions if ends else None)
    body, boundary = folded.body, la.block_diag(on_trace[first].toarray(), np.eye(len(turn)))
    inside = {q: fields[: len(body.mass), : part.inner] for q, fields in part.fields.items()}
    own = Bounded(
        coupling=inside[first].T @ body.coupling @ boundary,
        outer_stiffness=boundary.T @ body.outer_stiffness @ boundary,
        outer_mass=boundary.T @ body.outer_mass @ boundary,
        mass=inside[first].power(2).T @ body.mass,
    )
    numbers = {q: shared.assembler.assembled(shared.paired, q).unsprung() for q in part.gather if q != first}
    numbers[first] = folded.interior
    solver.factorise(np.sum([gather @ numbers[q] for q, gather in part.gather.items()], axis=0))
    found = reduced(solver, own, steps, block)
    return {
        q: found.unfolded(inside[q], la.block_diag(of_trace[q].toarray(), of_end).T)
        for q, of_end in zip(part.fields, of_ends, strict=False)
    }


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
def parts_of(assembler: Assembler, topology: Topology, sides: Sides) -> tuple[ClassPart, ...]:
    """The parts of all classes, the larger ones first.

    sides : where a third of a turn takes the tile's first two
    """
    folding, moved = assembler.folding, topology.permutation(sides)
    nodes, count = topology.nodes, len(folding.origin)
    place = sp.csr_array((np.ones(nodes), (moved, np.arange(nodes))), shape=(nodes, nodes))
    turned = sp.csr_array(sp.kron(place, THIRD))
    unknown = (3 * folding.node[:, None] + np.arange(3)).ravel()
    embed = [
        sp.csr_array(
            (sign.ravel().astype(float), unknown, np.arange(3 * nodes + 1)), shape=(3 * nodes, 3 * count)
        )
        for sign in folding.sign
    ]
    images = np.bincount(folding.node)

    def turn(q: int, other: int) -> sp.csr_array:
        """What a third of a turn makes of fields of one class in another."""
        found = embed[other].T @ turned @ embed[q]
        return sp.csr_array(found.multiply(1 / np.repeat(images, 3)[:, None]))

    # of representatives that it exchanges one, on a mirror if any is: there components just vanish or do not
    orbit = folding.node[np.stack([folding.origin, moved[folding.origin], moved[moved[folding.origin]]])]
    least = (images[orbit] * count + orbit).argmin(axis=0)
    chosen = np.unique(orbit[least, np.arange(count)])
    on_axis = (orbit[:, chosen] == chosen).all(axis=0)
    component = (3 * chosen[:, None] + np.arange(3)).ravel()
    alive = [component[sign[folding.origin].ravel()[component] != 0] for sign in folding.sign]
    both = np.column_stack([folding.parity, folding.middle]).tolist()
    full, same, root = _positions(assembler.pattern), sp.eye_array(3 * count, format="csr"), 2 / math.sqrt(3)
    small, large = [], []
    for q, (*parity, middle) in enumerate(both):
        small.append(_part(full, folding.interior, {q: (same + 2 * turn(q, q)) / 3}, [(q, 1.0, alive[q])]))
        other = both.index([*(-one for one in parity), middle])
        if q < other:
            # by its values at the chosen nodes, and by those of its image; on the axis these are one
            off_axis = alive[other][~np.isin(alive[other] // 3, chosen[on_axis])]
            own = sp.hstack([2 / 3 * (same - turn(q, q)), root * turn(other, q)], format="csr")
            fields = {q: own, other: root * turn(q, other) @ own}
            large.append(_part(full, folding.interior, fields, [(q, 1.0, alive[q]), (other, -1.0, off_axis)]))
    return (*large, *small)


def _positions(pattern: Pattern) -> sp.csr_array:
    """Where each number of the whole symmetric matrix stands among those on its pattern."""
    row = np.repeat(np.arange(pattern.size), np.diff(pattern.indptr))
    off = row != pattern.indices
    ends = (np.concatenate([row, pattern.indices[off]]), np.concatenate([pattern.indices, row[off]]))
    number = np.arange(len(row))
    return sp.csr_array((np.concatenate([number, number[off]]), ends), shape=(pattern.size, pattern.size))


def _part(
    full: sp.csr_array, interior: int, fields: dict[int, sp.csr_array], chosen: list[tuple[int, float, Ints]]
) -> ClassPart:
    """A part that some columns of fields span.

    full : see `_positions`
    chosen : of each block of columns a class, a sign and the numbers of those to take. A column is the share
        that a unit component of the class has in the part, so stiffness on the part is the stiffness of
        that component on fields of the class, times the sign
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
        inner=inner,
        pattern=Pattern(indptr.astype(np.int32), j.astype(np.int32)),
        gather=gather,
    )
