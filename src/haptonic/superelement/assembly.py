"""Assembly of folded element matrices, with all index work done once per topology."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from haptonic.cell import Topology
from haptonic.elements import ElementMatrices
from haptonic.solvers import Pattern
from haptonic.superelement.symmetry import Folding

Array = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class Assembler:
    """Where each pair of element nodes goes in the folded matrix, as 3 x 3 blocks of its upper triangle.

    pairs : (3, k) number among the folding's elements, and the two nodes within the element
    ends : (2, k) node numbers of those two in the mesh
    gather : (blocks, k) sparse matrix of ones that adds pairs into blocks
    rows, columns : (blocks,) representatives that a block couples, row <= column
    inner : blocks among interior nodes only; pattern : these, as a scalar upper triangle
    source : for each entry of the pattern its position among the raveled inner blocks
    diagonal : (3 interior,) position of each diagonal entry in the pattern
    coupling : blocks between interior (row) and boundary (column); outer : blocks among boundary nodes
    """

    folding: Folding
    pairs: tuple[Ints, Ints, Ints]
    ends: tuple[Ints, Ints]
    gather: sp.csr_array
    rows: Ints
    columns: Ints
    inner: Ints
    pattern: Pattern
    source: Ints
    diagonal: Ints
    coupling: Ints
    outer: Ints

    def assembled(self, elements: ElementMatrices, scale: Array, symmetry_class: int) -> FoldedStiffness:
        """Stiffness of one symmetry class; ``scale`` (elements,) weighs them, 0 leaves one out."""
        e, a, b = self.pairs
        sign = self.folding.sign[symmetry_class].astype(float)
        values = elements.stiffness[e, a, b] * scale[e, None, None]
        values *= sign[self.ends[0]][:, :, None]
        values *= sign[self.ends[1]][:, None, :]
        return FoldedStiffness(self, np.asarray(self.gather @ values.reshape(-1, 9)).reshape(-1, 3, 3))


@dataclass(frozen=True)
class FoldedStiffness:
    """Folded stiffness as (blocks, 3, 3) numbers on the structure of an assembler, N/m."""

    assembler: Assembler
    blocks: Array

    def interior(self) -> Array:
        """Numbers on the interior pattern; components that the class forces to vanish hang on springs."""
        data = self.unsprung()
        pivots = data[self.assembler.diagonal]
        data[self.assembler.diagonal] = np.where(pivots == 0.0, pivots.max(), pivots)
        return data

    def unsprung(self) -> Array:
        """Numbers on the interior pattern, zero where a component vanishes."""
        return self.blocks[self.assembler.inner].ravel()[self.assembler.source]

    def coupling(self) -> Array:
        """(3 interior, 3 boundary) dense part between interior and boundary."""
        return self._dense(self.assembler.coupling, 0)

    def boundary(self) -> Array:
        """(3 boundary, 3 boundary) dense part, symmetric."""
        upper = self._dense(self.assembler.outer, self.assembler.folding.interior)
        return np.asarray(np.triu(upper) + np.triu(upper, 1).T)

    def _dense(self, chosen: Ints, first_row: int) -> Array:
        folding = self.assembler.folding
        rows = len(folding.origin) - folding.interior if first_row else folding.interior
        columns = len(folding.origin) - folding.interior
        dense = np.zeros((rows, 3, columns, 3))
        row = self.assembler.rows[chosen] - first_row
        column = self.assembler.columns[chosen] - folding.interior
        dense[row, :, column, :] = self.blocks[chosen]
        return dense.reshape(3 * rows, 3 * columns)


@lru_cache(maxsize=16)
def assembler_of(topology: Topology, folding: Folding) -> Assembler:
    """The index work of a topology; the same object for the same arguments."""
    n = topology.plan.order + 1
    nodes = topology.elements[folding.elements].reshape(-1, n**3)
    place = np.stack(np.unravel_index(np.arange(n**3), (n, n, n)))
    coupled = (place[:, :, None] == place[:, None, :]).any(axis=0)
    a, b = np.nonzero(coupled)
    representative = folding.node[nodes]
    e, pair = np.nonzero(representative[:, a] <= representative[:, b])
    a, b = a[pair], b[pair]
    count = len(folding.origin)
    key = representative[e, a] * count + representative[e, b]
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
        pairs=(e, a, b),
        ends=(nodes[e, a], nodes[e, b]),
        gather=gather,
        rows=rows,
        columns=columns,
        inner=inner,
        pattern=Pattern(indptr.astype(np.int32), j.astype(np.int32)),
        source=entry[order],
        diagonal=np.flatnonzero(i == j),
        coupling=np.flatnonzero(~is_inner & (rows < folding.interior)),
        outer=np.flatnonzero(rows >= folding.interior),
    )
