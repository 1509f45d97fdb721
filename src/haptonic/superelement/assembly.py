"""Assembly of folded element matrices, with all index work done once per topology."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Ints
from haptonic.cell import Topology
from haptonic.elements import ElementMatrices, coupled_pairs
from haptonic.later import sparse as sp
from haptonic.solvers import Pattern
from haptonic.superelement.kept import Kept
from haptonic.superelement.symmetry import Folding


@dataclass(frozen=True, eq=False)
class Assembler:
    """Positions of all pairs of element nodes in the folded matrix, as 3 x 3 blocks of its upper triangle.

    kept : for each family, numbers of the contributions used, among (k, elements) raveled
    ends : (2, pairs of all families) numbers of the pair's nodes in the mesh
    weight : (pairs,) number of images that the pair's element represents
    in_pillar : numbers of the pairs above the plate's top
    gather : (blocks, pairs) sparse matrix of ones that adds pairs into blocks
    rows, columns : (blocks,) representatives that a block couples, row <= column
    inner : blocks between interior nodes only; pattern : of these blocks, as a scalar upper triangle
    source : for each entry of the pattern, its position in the raveled inner blocks
    coupling : blocks between interior (row) and boundary (column); outer : blocks between boundary nodes
    """

    folding: Folding
    kept: tuple[Ints, ...]
    ends: Ints
    weight: Array
    in_pillar: Ints
    gather: sp.csr_array
    rows: Ints
    columns: Ints
    inner: Ints
    pattern: Pattern
    source: Ints
    coupling: Ints
    outer: Ints

    @cached_property
    def signs(self) -> tuple[NDArray[np.int8], ...]:
        """For each symmetry class, signs (pairs, 9) of the stiffness between the nodes of a pair."""
        first, second = self.ends
        return tuple(
            np.repeat(sign, 3, axis=1)[first] * np.tile(sign, 3)[second] for sign in self.folding.sign
        )

    def paired(self, elements: tuple[ElementMatrices, ...]) -> Array:
        """(pairs, 9) stiffness between pairs of nodes, images included."""
        ends = np.cumsum([0, *(len(contributions) for contributions in self.kept)])
        paired = np.empty((ends[-1], 9))  # filled in place: copies of it take longer than the sums
        for of_family, contributions, start, stop in zip(elements, self.kept, ends, ends[1:], strict=False):
            between = of_family.stiffness.reshape(-1, 9)
            # NumPy would copy the result once more to raise errors for numbers out of range
            np.take(between, contributions, axis=0, out=paired[start:stop], mode="clip")
        paired *= self.weight[:, None]
        return paired

    def assembled(self, paired: Array, symmetry_class: int) -> FoldedStiffness:
        """Stiffness of one symmetry class from the stiffness between pairs of nodes."""
        blocks = self.gather @ (paired * self.signs[symmetry_class])
        return FoldedStiffness(self, np.asarray(blocks).reshape(-1, 3, 3))

    def assembled_pillar(self, paired: Array, symmetry_class: int) -> sp.csr_array:
        """(3 representatives, 3 representatives) the pillar's share of that stiffness."""
        chosen, (gather, place) = self.in_pillar, self._of_pillar
        blocks = gather @ (paired[chosen] * self.signs[symmetry_class][chosen])
        numbers = np.asarray(blocks).ravel()[place.data]
        return sp.csr_array((numbers, place.indices, place.indptr), shape=place.shape)

    @cached_property
    def _of_pillar(self) -> tuple[sp.csr_array, sp.csr_array]:
        """Matrix that adds the pillar's pairs into blocks, and positions of their entries."""
        gather = self.gather[:, self.in_pillar]
        met = np.flatnonzero(np.diff(gather.indptr))
        number = np.arange(9 * len(met), dtype=np.int32).reshape(-1, 3, 3)  # half the memory of int64
        rows, columns = (
            (3 * ends[met, None] + np.arange(3)).astype(np.int32) for ends in (self.rows, self.columns)
        )
        row, column = rows.repeat(3, axis=1).ravel(), np.tile(columns, 3).ravel()
        off = row // 3 != column // 3  # blocks on the diagonal are complete in the upper triangle
        both = np.concatenate([row, column[off]]), np.concatenate([column, row[off]])
        size = 3 * len(self.folding.origin)
        place = np.concatenate([number.ravel(), number.ravel()[off]])
        return gather[met], sp.csr_array((place, both), shape=(size, size))


@dataclass(frozen=True)
class FoldedStiffness:
    """Folded stiffness as values (blocks, 3, 3) on the structure of an assembler, N/m."""

    assembler: Assembler
    blocks: Array

    def interior(self) -> Array:
        """Values on the interior pattern, with springs on components that are zero in the class."""
        data = self.unsprung()
        diagonal = self.assembler.pattern.indptr[:-1]
        pivots = data[diagonal]
        data[diagonal] = np.where(pivots == 0.0, pivots.max(), pivots)
        return data

    def unsprung(self) -> Array:
        """Values on the interior pattern, zero where a component is zero in the class."""
        return self.blocks[self.assembler.inner].ravel()[self.assembler.source]

    def coupling(self) -> sp.csr_array:
        """(3 interior, 3 boundary) stiffness between interior and boundary."""
        return self._between(self.assembler.coupling, 0)

    def boundary(self) -> sp.csr_array:
        """(3 boundary, 3 boundary) stiffness of the boundary, symmetric."""
        upper = self._between(self.assembler.outer, self.assembler.folding.interior)
        return sp.triu(upper) + sp.triu(upper, 1).T

    def _between(self, chosen: Ints, first: int) -> sp.csr_array:
        """Stiffness between representatives, from number ``first`` on, and those on the boundary."""
        folding = self.assembler.folding
        boundary = len(folding.origin) - folding.interior
        rows = boundary if first else folding.interior
        row = 3 * (self.assembler.rows[chosen] - first)[:, None, None] + np.arange(3)[:, None]
        column = 3 * (self.assembler.columns[chosen] - folding.interior)[:, None, None] + np.arange(3)
        places = (np.broadcast_to(numbers, (len(chosen), 3, 3)).ravel() for numbers in (row, column))
        return sp.csr_array((self.blocks[chosen].ravel(), tuple(places)), shape=(3 * rows, 3 * boundary))


# pairs of nodes in all stored assemblers, about 100 bytes each, so 0.4 GB: 9 usual cells with two orders each
KEPT_PAIRS = 4e6
_assemblers = Kept[Assembler](KEPT_PAIRS, lambda assembler: len(assembler.weight))


def assembler_of(topology: Topology, folding: Folding) -> Assembler:
    """Return the assembler of a topology, from the cache if it is there."""
    return _assemblers.of((topology, folding), lambda: _assembler(topology, folding))


def _assembler(topology: Topology, folding: Folding) -> Assembler:
    contributions, ends, keys, weights, above = [], [], [], [], []
    count = len(folding.origin)
    for family, chosen, weight in zip(topology.families, folding.chosen, folding.weight, strict=True):
        nodes = family.nodes[chosen]
        (a, b), _ = coupled_pairs(nodes.shape[1:])
        nodes = nodes.reshape(len(nodes), -1)
        representative = folding.node[nodes]
        pair, e = np.nonzero((representative[:, a] <= representative[:, b]).T)
        contributions.append(pair * len(nodes) + e)
        a, b = a[pair], b[pair]
        ends.append(np.stack([nodes[e, a], nodes[e, b]]))
        keys.append(representative[e, a] * count + representative[e, b])
        weights.append(weight[e])
        above.append(family.in_pillar[chosen][e])
    key = np.concatenate(keys)
    code, block = np.unique(key, return_inverse=True)
    rows, columns = np.divmod(code, count)
    gather = sp.csr_array((np.ones(len(key)), (block, np.arange(len(key)))), shape=(len(code), len(key)))

    is_inner = columns < folding.interior
    inner = np.flatnonzero(is_inner)
    i = (3 * rows[inner, None, None] + np.arange(3)[:, None]) + np.zeros((1, 1, 3), dtype=np.int64)
    j = (3 * columns[inner, None, None] + np.arange(3)[None, :]) + np.zeros((1, 3, 1), dtype=np.int64)
    entry = np.flatnonzero((i <= j).ravel())
    i, j = i.ravel()[entry], j.ravel()[entry]
    order = np.lexsort((j, i))
    size = 3 * folding.interior
    indptr = np.concatenate([[0], np.cumsum(np.bincount(i, minlength=size))])
    i, j = i[order], j[order]
    return Assembler(
        folding=folding,
        kept=tuple(contributions),
        ends=np.concatenate(ends, axis=1),
        weight=np.concatenate(weights).astype(float),
        in_pillar=np.flatnonzero(np.concatenate(above)),
        gather=gather,
        rows=rows,
        columns=columns,
        inner=inner,
        pattern=Pattern(indptr.astype(np.int32), j.astype(np.int32)),
        source=entry[order],
        coupling=np.flatnonzero(~is_inner & (rows < folding.interior)),
        outer=np.flatnonzero(rows >= folding.interior),
    )
