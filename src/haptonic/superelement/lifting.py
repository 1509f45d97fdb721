"""From the unknowns of a condensed cell back to displacement on its mesh."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Fields
from haptonic.cell import TileShape, Topology
from haptonic.superelement.symmetry import DIAGONAL
from haptonic.superelement.trace import FoldedTrace, TraceOperation


@dataclass(frozen=True)
class DiagonalImage:
    """The mirror on the diagonal of a square cell: on traces, and where it takes each node."""

    trace: TraceOperation
    moved: NDArray[np.int64]

    @classmethod
    def of(cls, tile: TileShape, levels: int, *meshes: Topology) -> DiagonalImage:
        """On the nodes of some meshes, one after the other; the first has the rim."""
        sides = tile.moved_sides(DIAGONAL)
        assert sides is not None, "no square"
        starts = np.cumsum([0, *(one.nodes for one in meshes[:-1])])
        moved = [start + one.permutation(sides) for start, one in zip(starts, meshes, strict=True)]
        return cls(TraceOperation.of(tile, meshes[0], levels, DIAGONAL), np.concatenate(moved))

    def applied(self, field: Fields) -> Fields:
        """Mirror image of a field (nodes, 3, k)."""
        return np.asarray(field[self.moved][:, [1, 0, 2]])


@dataclass(frozen=True)
class ClassLifting:
    """How one symmetry class is lifted back: static answers (3 interior, b) and modes (3 interior, m).

    ``image`` is for a class that is the diagonal's mirror image of the one that all this belongs to.
    """

    trace: FoldedTrace
    through: Array
    static: Array
    modes: Array
    image: DiagonalImage | None = None

    @property
    def count(self) -> int:
        """Number of modes."""
        return int(self.modes.shape[1])

    def mirrored(self, mirror: DiagonalImage) -> ClassLifting:
        """How the class of this one's mirror images is lifted back."""
        return replace(self, image=mirror)

    def lifted(self, trace: Fields, amplitudes: Fields) -> Fields:
        """(nodes, 3, k) displacement from a whole trace (t, k) and the class's modal amplitudes (m, k)."""
        own = self.trace.fold(self.image.trace.applied(trace) if self.image else trace)
        inside = self.static @ own + self.modes @ amplitudes
        field = unfolded(self.trace, inside, self.trace.on_levels(self.through, own))
        return self.image.applied(field) if self.image else field


class Lifting(Protocol):
    """How a symmetry class is lifted back; see `ClassLifting`."""

    @property
    def trace(self) -> FoldedTrace: ...

    @property
    def count(self) -> int: ...

    def mirrored(self, mirror: DiagonalImage) -> Lifting: ...

    def lifted(self, trace: Fields, amplitudes: Fields) -> Fields: ...


def unfolded(trace: FoldedTrace, inside: Fields, *boundary: Fields) -> Fields:
    """(nodes, 3, k) field of a class from its values (3 interior, k) inside and (n, 3, k) on the boundary."""
    values = np.concatenate([inside.reshape(-1, 3, inside.shape[1]), *boundary])
    return np.asarray(trace.folding.sign[trace.symmetry_class][:, :, None] * values[trace.folding.node])


def lifted(parts: Sequence[Lifting], trace: Fields, amplitudes: Fields) -> Fields:
    """(nodes, 3, k) displacement from a whole trace (t, k) and the amplitudes (m, k) of all parts' modes."""
    ends = np.cumsum([part.count for part in parts])
    shares = np.split(amplitudes, ends[:-1])
    return np.asarray(sum(part.lifted(trace, share) for part, share in zip(parts, shares, strict=True)))
