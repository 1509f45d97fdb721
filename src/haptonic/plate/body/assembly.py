"""Assembly of a plate's tiles: one matrix on the skeleton, with the tiles' modes eliminated at each shift.

A tile has a trace b on the skeleton and modes m of eigenvalues lambda, which are not coupled to other
tiles. At a shift s it adds to the matrix of the skeleton

    D(s) = K_bb - s M_bb - s^2 M_bm (Lambda - s)^-1 M_mb,

to it. The number of eigenvalues of the plate below s is that of the negative eigenvalues of the sum of all
D(s), plus that of the tiles' modes with lambda < s (Wittrick and Williams 1971, doi 10.1093/qjmam/24.3.263).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Ints
from haptonic.later import sparse as sp
from haptonic.parallel import each
from haptonic.plate.body.elimination import elimination_order
from haptonic.plate.body.skeleton import Skeleton
from haptonic.plate.body.tile import Eliminated, Tile, applied
from haptonic.solvers import Pattern, Solver, chosen

AT_ONCE = 64  # number of vectors per product


@dataclass(frozen=True, eq=False)
class TileGroup:
    """All blocks with the same tile.

    blocks : (k,) their numbers
    unknowns : (k, n) positions of the tile's unknowns in a vector of the assembly; unknowns at rest have the
        number of an additional last entry, which is 0
    """

    tile: Tile
    blocks: Ints
    unknowns: Ints


@dataclass(frozen=True, eq=False)
class Assembly:
    """Assembled tiles. Vectors contain the free unknowns of the skeleton, then the modes of all tiles.

    skeleton : unknowns between tiles
    number : (skeleton.size,) position of each of its unknowns in a vector; unknowns at rest, or condensed
        into a tile, have number ``size``
    free : number of the others
    groups : the tiles; size : of a vector
    foundations : stiffness of the supports (free, free), sparse, N/m
    """

    skeleton: Skeleton
    number: Ints
    free: int
    groups: tuple[TileGroup, ...]
    size: int
    foundations: sp.csr_array

    @classmethod
    def of(
        cls,
        skeleton: Skeleton,
        tiles: Sequence[Tile],
        which: Sequence[int],
        held: Ints,
        foundations: sp.csr_array,
        opened: Sequence[Ints],
    ) -> Assembly:
        """Assemble blocks.

        Parameters
        ----------
        which : the tile of each block; held : unknowns at rest; foundations : on all unknowns of the skeleton
        opened : for each block, unknowns of its trace that are condensed into its tile
        """
        is_free = np.ones(skeleton.size, dtype=bool)
        is_free[held] = False
        for trace, own in zip(skeleton.traces, opened, strict=True):
            is_free[trace[own]] = False
        free = int(is_free.sum())
        kinds = np.asarray(which)
        size = free + sum(len(tiles[kind].values) for kind in kinds)
        number = np.full(skeleton.size, size)
        number[is_free] = np.arange(free)
        groups, start = [], free
        for kind, tile in enumerate(tiles):
            blocks = np.flatnonzero(kinds == kind)
            if not len(blocks):
                continue
            traces = np.stack([number[np.delete(skeleton.traces[k], opened[k])] for k in blocks.tolist()])
            modes = start + np.arange(len(blocks) * len(tile.values)).reshape(len(blocks), -1)
            start += modes.size
            groups.append(TileGroup(tile, blocks, np.hstack([traces, modes])))
        inside = np.flatnonzero(is_free)
        return cls(
            skeleton=skeleton,
            number=number,
            free=free,
            groups=tuple(groups),
            size=size,
            foundations=sp.csr_array(foundations[inside][:, inside]),
        )

    @property
    def is_free(self) -> NDArray[np.bool_]:
        """(skeleton.size,) True for unknowns that are neither at rest nor condensed."""
        return np.asarray(self.number < self.size)

    # -- products ---------------------------------------------------------------------------------

    def shares(self, vectors: NDArray[Any]) -> Iterator[tuple[TileGroup, NDArray[Any]]]:
        """(n, blocks, k) parts of vectors (size, k) on the tiles of each group."""
        padded = np.concatenate([vectors, np.zeros((1, vectors.shape[1]), vectors.dtype)])
        for group in self.groups:
            yield group, padded[group.unknowns.T]

    def gathered(self, pieces: Sequence[NDArray[Any]]) -> NDArray[Any]:
        """(size, k) sum of contributions (n, blocks, k) of the groups."""
        flat = [piece.reshape(-1, piece.shape[-1]) for piece in pieces]
        return np.asarray(self._gather @ np.concatenate(flat))

    @cached_property
    def _gather(self) -> sp.csr_array:
        """Matrix that sums the contributions of all groups, one below the other."""
        to = np.concatenate([group.unknowns.T.ravel() for group in self.groups])
        inside = np.flatnonzero(to < self.size)
        entries = (np.ones(len(inside)), (to[inside], inside))
        return sp.csr_array(entries, shape=(self.size, len(to)))

    def mass_times(self, vectors: Array) -> Array:
        """M times vectors (size, k)."""
        return self._times(
            vectors, lambda part: self.gathered([g.tile.mass_times(share) for g, share in self.shares(part)])
        )

    def stiffness_times(self, vectors: Array) -> Array:
        """K of all parts, supports included, times vectors (size, k)."""

        def product(part: Array) -> Array:
            pieces = [group.tile.stiffness_times(share) for group, share in self.shares(part)]
            forces = self.gathered(pieces)
            forces[: self.free] += self.foundations @ part[: self.free]
            return forces

        return self._times(vectors, product)

    def _times(self, vectors: Array, product: Callable[[Array], Array]) -> Array:
        """Apply a product to groups of columns in parallel threads."""
        out = np.empty_like(vectors)

        def some(start: int) -> None:
            columns = slice(start, start + AT_ONCE)
            out[:, columns] = product(np.ascontiguousarray(vectors[:, columns]))

        self.prepare()
        each(some, range(0, vectors.shape[1], AT_ONCE))
        return out

    # -- the matrix on the skeleton ---------------------------------------------------------------

    @cached_property
    def _places(self) -> tuple[Pattern, list[tuple[Ints, Ints]], tuple[Ints, Array]]:
        """Pattern of the upper triangle, and positions of the blocks' and the foundations' entries in it.

        For each block, in the order of the groups: entries of its matrix (trace, trace) that are used, and
        their positions. For the foundations' upper triangle: positions and entries.
        """
        blocks = []  # their free unknowns, ascending, and the positions of these in the trace
        for group in self.groups:
            for trace in group.unknowns[:, : group.tile.trace_size]:
                order = np.argsort(trace)[: int((trace < self.size).sum())]
                blocks.append((trace[order], order, len(trace)))
        foundation = sp.coo_array(sp.triu(self.foundations))
        rows, columns = [foundation.row, np.arange(self.free)], [foundation.col, np.arange(self.free)]
        for unknowns, _, _ in blocks:
            first, second = np.triu_indices(len(unknowns))
            rows.append(unknowns[first])
            columns.append(unknowns[second])
        at = np.concatenate(rows).astype(np.int32), np.concatenate(columns).astype(np.int32)
        number = sp.csr_array((np.ones(len(at[0]), dtype=np.int32), at), shape=(self.free,) * 2)
        number.sort_indices()
        number.data = np.arange(number.nnz, dtype=np.int64)
        places = []
        for unknowns, order, trace in blocks:
            first, second = np.triu_indices(len(unknowns))
            entry_numbers = number[unknowns][:, unknowns].toarray()
            places.append((order[first] * trace + order[second], entry_numbers[first, second]))
        entries = number[np.unique(foundation.row)].tocoo()
        keys = np.unique(foundation.row)[entries.row] * self.free + entries.col  # ascending
        on_them = foundation.row.astype(np.int64) * self.free + foundation.col
        of_foundations = entries.data[np.searchsorted(keys, on_them)]
        order = elimination_order(self.free, [unknowns for unknowns, _, _ in blocks])
        pattern = Pattern(*(array.astype(np.int32) for array in (number.indptr, number.indices, order)))
        return pattern, places, (of_foundations, foundation.data)

    def prepare(self) -> None:
        """Do the index work before several threads need it."""
        assert self._gather is not None
        assert self._places

    @property
    def pattern(self) -> Pattern:
        """Pattern of the upper triangle on the free unknowns of the skeleton."""
        return self._places[0]

    def numbers(self, parts: Sequence[Array]) -> Array:
        """Values on the pattern from a symmetric matrix (trace, trace) for each group, and foundations."""
        pattern, places, (of_foundations, foundations) = self._places
        data = np.zeros(len(pattern.indices))
        data[of_foundations] = foundations
        block = iter(places)
        for group, part in zip(self.groups, parts, strict=True):
            flat = part.ravel()
            for _ in group.blocks:
                entries, where = next(block)
                data[where] += flat[entries]  # entries of one block never coincide
        return data

    @cached_property
    def _idle(self) -> list[Solver]:
        """Unused solvers that have analysed the pattern."""
        return []

    def shifted(self, shift: float) -> Shifted:
        """Factorise K - shift M; the caller releases the result after use."""
        solver = self._idle.pop() if self._idle else chosen()(self.pattern)
        return Shifted.of(self, shift, solver)


@dataclass(frozen=True, eq=False)
class Shifted:
    """K - shift M of an assembly, factorised on the skeleton with the modes eliminated.

    below : number of eigenvalues below the shift
    """

    assembly: Assembly
    shift: float
    solver: Solver
    eliminated: tuple[Eliminated, ...]
    below: int

    @classmethod
    def of(cls, assembly: Assembly, shift: float, solver: Solver) -> Shifted:
        eliminated = tuple(group.tile.dynamic(shift) for group in assembly.groups)
        numbers = assembly.numbers([modes.on_trace for modes in eliminated])
        below = solver.factorise(numbers, definite=shift <= 0)
        below += sum(len(g.blocks) * int((g.tile.values < shift).sum()) for g in assembly.groups)
        return cls(assembly=assembly, shift=shift, solver=solver, eliminated=eliminated, below=below)

    def release(self) -> None:
        """Return the solver for the next shift."""
        self.assembly._idle.append(self.solver)

    def solve(self, right: Array) -> Array:
        """(size, k) solutions of (K - shift M) x = right, (size, k)."""
        assembly = self.assembly
        pieces, inner = [], []
        for (group, share), modes in zip(assembly.shares(right), self.eliminated, strict=True):
            of_modes = share[group.tile.trace_size :]
            inner.append(modes.inverse[:, None, None] * of_modes)
            pieces.append(np.concatenate([applied(modes.follow.T, of_modes), np.zeros_like(of_modes)]))
        reduced = right[: assembly.free] + assembly.gathered(pieces)[: assembly.free]
        out = np.zeros((assembly.size + 1, right.shape[1]))
        out[: assembly.free] = self.solver.solve(reduced)
        for group, modes, of_modes in zip(assembly.groups, self.eliminated, inner, strict=True):
            trace = group.tile.trace_size
            out[group.unknowns.T[trace:]] = of_modes + applied(modes.follow, out[group.unknowns.T[:trace]])
        return out[:-1]
