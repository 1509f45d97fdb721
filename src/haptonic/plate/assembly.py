"""All tiles of a plate together: one matrix on the skeleton, modes of the tiles eliminated at every shift."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from haptonic.plate.skeleton import Skeleton
from haptonic.plate.tile import Tile
from haptonic.solvers import Pattern, Solver, chosen

Array = NDArray[np.float64]
Ints = NDArray[np.int64]

AT_ONCE = 64  # vectors that a product takes on at once


@dataclass(frozen=True, eq=False)
class Group:
    """All blocks that are the same tile.

    blocks : (k,) their numbers
    unknowns : (k, n) where the tile's unknowns lie in a vector of the assembly; those held have the number
        of the vector's last entry, which is always 0
    """

    tile: Tile
    blocks: Ints
    unknowns: Ints


@dataclass(frozen=True, eq=False)
class Assembly:
    """Vectors hold the free unknowns of the skeleton, then the modes of all tiles.

    skeleton : what carries the unknowns between tiles
    number : (skeleton.size,) place of each of its unknowns in a vector; held ones have number ``size``
    free : how many of them are not held
    groups : the tiles; size : of a vector
    beds : stiffness of the supports (free, free), sparse, N/m
    """

    skeleton: Skeleton
    number: Ints
    free: int
    groups: tuple[Group, ...]
    size: int
    beds: sp.csr_array

    @classmethod
    def of(
        cls, skeleton: Skeleton, tiles: Sequence[Tile], which: Sequence[int], held: Ints, beds: sp.csr_array
    ) -> Assembly:
        """Assemble blocks; ``which`` gives the tile of each block, ``held`` the unknowns at rest.

        ``beds`` is on all unknowns of the skeleton.
        """
        is_free = np.ones(skeleton.size, dtype=bool)
        is_free[held] = False
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
            traces = np.stack([number[skeleton.unknowns(skeleton.rims[block])] for block in blocks])
            modes = start + np.arange(len(blocks) * len(tile.values)).reshape(len(blocks), -1)
            start += modes.size
            groups.append(Group(tile, blocks, np.hstack([traces, modes])))
        inside = np.flatnonzero(is_free)
        return cls(skeleton, number, free, tuple(groups), size, sp.csr_array(beds[inside][:, inside]))

    @property
    def is_free(self) -> NDArray[np.bool_]:
        """(skeleton.size,) unknowns that are not held."""
        return np.asarray(self.number < self.size)

    # -- products ---------------------------------------------------------------------------------

    def shares(self, vectors: NDArray[Any]) -> Iterator[tuple[Group, NDArray[Any]]]:
        """(blocks, n, k) the part of vectors (size, k) on the tiles of each group."""
        padded = np.concatenate([vectors, np.zeros((1, vectors.shape[1]), vectors.dtype)])
        for group in self.groups:
            yield group, padded[group.unknowns]

    def gathered(self, pieces: Sequence[NDArray[Any]]) -> NDArray[Any]:
        """(size, k) sum of contributions (blocks, n, k) of the groups."""
        return np.asarray(
            sum(
                gather @ piece.reshape(-1, piece.shape[-1])
                for gather, piece in zip(self._gathers, pieces, strict=True)
            )
        )

    @cached_property
    def _gathers(self) -> list[sp.csr_array]:
        gathers = []
        for group in self.groups:
            to = group.unknowns.ravel()
            kept = np.flatnonzero(to < self.size)
            entries = (np.ones(len(kept)), (to[kept], kept))
            gathers.append(sp.csr_array(entries, shape=(self.size, len(to))))
        return gathers

    def mass_times(self, vectors: Array, out: Array | None = None) -> Array:
        """M times vectors (size, k)."""
        return self._times(
            vectors,
            out,
            lambda part: self.gathered([group.tile.mass @ share for group, share in self.shares(part)]),
        )

    def stiffness_times(self, vectors: Array, out: Array | None = None) -> Array:
        """K of all parts, supports included, times vectors (size, k)."""

        def product(part: Array) -> Array:
            pieces = [group.tile.elastic @ share for group, share in self.shares(part)]
            found = self.gathered(pieces)
            found[: self.free] += self.beds @ part[: self.free]
            return found

        return self._times(vectors, out, product)

    def _times(self, vectors: Array, out: Array | None, product: Callable[[Array], Array]) -> Array:
        """A product of some columns after the others: fresh memory is slow."""
        out = np.empty_like(vectors) if out is None else out
        for start in range(0, vectors.shape[1], AT_ONCE):
            columns = slice(start, start + AT_ONCE)
            out[:, columns] = product(np.ascontiguousarray(vectors[:, columns]))
        return out

    # -- the matrix on the skeleton ---------------------------------------------------------------

    @cached_property
    def _places(self) -> tuple[Pattern, list[Ints], Ints]:
        """Pattern of the upper triangle, and where each group's entries, and those of the beds, go."""
        rows, columns, sizes = [], [], []
        for group in self.groups:
            trace = group.unknowns[:, : group.tile.trace_size]
            low = np.minimum(trace[:, :, None], trace[:, None, :])
            high = np.maximum(trace[:, :, None], trace[:, None, :])
            upper = np.triu(np.ones((trace.shape[1],) * 2, dtype=bool))
            rows.append(low[:, upper].ravel())
            columns.append(high[:, upper].ravel())
            sizes.append(len(rows[-1]))
        bed = sp.coo_array(sp.triu(self.beds))
        rows.append(bed.row.astype(np.int64))
        columns.append(bed.col.astype(np.int64))
        rows.append(np.arange(self.free))
        columns.append(np.arange(self.free))
        row, column = np.concatenate(rows), np.concatenate(columns)
        kept = column < self.free
        key = row * self.free + column
        unique, place = np.unique(key[kept], return_inverse=True)
        where = np.full(len(key), len(unique))
        where[kept] = place
        counts = np.bincount(unique // self.free, minlength=self.free)
        indptr = np.concatenate([[0], np.cumsum(counts)])
        pattern = Pattern(indptr.astype(np.int32), (unique % self.free).astype(np.int32))
        pieces = np.split(where, np.cumsum([*sizes, bed.nnz])[: len(sizes) + 1])
        return pattern, pieces[: len(sizes)], pieces[len(sizes)]

    def prepare(self) -> None:
        """Do the index work before threads ask for it at once."""
        assert self._gathers
        assert self._places

    @property
    def pattern(self) -> Pattern:
        """Of the upper triangle on the free unknowns of the skeleton."""
        return self._places[0]

    def numbers(self, parts: Sequence[Array]) -> Array:
        """Numbers on the pattern from one matrix (trace, trace) for each group; the beds are added."""
        pattern, places, of_beds = self._places
        data = np.zeros(len(pattern.indices) + 1)
        for group, place, part in zip(self.groups, places, parts, strict=True):
            upper = part[np.triu_indices(len(part))]
            weights = np.broadcast_to(upper, (len(group.blocks), len(upper))).ravel()
            data += np.bincount(place, weights, minlength=len(data))
        data += np.bincount(of_beds, sp.coo_array(sp.triu(self.beds)).data, minlength=len(data))
        return data[:-1]

    def shifted(self, shift: float, solver: Solver | None = None) -> Shifted:
        """K - shift M, factorised."""
        return Shifted.of(self, shift, solver or chosen()(self.pattern))


@dataclass(frozen=True, eq=False)
class Shifted:
    """K - shift M of an assembly, factorised on the skeleton with the modes eliminated.

    below : eigenvalues below the shift
    """

    assembly: Assembly
    shift: float
    solver: Solver
    answers: tuple[Array, ...]
    below: int

    @classmethod
    def of(cls, assembly: Assembly, shift: float, solver: Solver) -> Shifted:
        matrices, answers = zip(*(group.tile.dynamic(shift) for group in assembly.groups), strict=True)
        below = solver.factorise(assembly.numbers(matrices), definite=shift <= 0)
        below += sum(len(g.blocks) * int((g.tile.values < shift).sum()) for g in assembly.groups)
        return cls(assembly, shift, solver, answers, below)

    def solve(self, right: Array) -> Array:
        """(size, k) solutions of (K - shift M) x = right."""
        assembly = self.assembly
        pieces, inner = [], []
        for (group, share), answer in zip(assembly.shares(right), self.answers, strict=True):
            trace = group.tile.trace_size
            own = share[:, trace:]
            inner.append(own / (group.tile.values - self.shift)[:, None])
            pieces.append(np.concatenate([answer.T @ own, np.zeros_like(own)], axis=1))
        reduced = right[: assembly.free] + assembly.gathered(pieces)[: assembly.free]
        out = np.zeros((assembly.size + 1, right.shape[1]))
        out[: assembly.free] = self.solver.solve(reduced)
        for group, answer, own in zip(assembly.groups, self.answers, inner, strict=True):
            trace = group.tile.trace_size
            on_trace = out[group.unknowns[:, :trace]]
            out[group.unknowns[:, trace:]] = own + answer @ on_trace
        return out[:-1]
