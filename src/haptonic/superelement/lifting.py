"""Displacement on the mesh of a condensed cell from its unknowns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from haptonic.arrays import Array, Fields
from haptonic.superelement.surplus import NodeRows, surplus_forms
from haptonic.superelement.trace import FoldedTrace


@dataclass(frozen=True)
class ClassLifting:
    """Fields of one symmetry class: static responses (3 interior, b) and modes (3 interior, m).

    rows : see `haptonic.superelement.surplus`; None if errors of the fields are not estimated
    """

    trace: FoldedTrace
    through: Array
    static: Array
    modes: Array
    rows: list[NodeRows] | None

    @property
    def count(self) -> int:
        """Number of modes."""
        return int(self.modes.shape[1])

    def lifted(self, trace: Fields, amplitudes: Fields) -> Fields:
        """(nodes, 3, k) displacement from a whole trace (t, k) and the class's modal amplitudes (m, k)."""
        of_class = self.trace.fold(trace)
        inside = self.static @ of_class + self.modes @ amplitudes
        return unfolded(self.trace, inside, self.trace.on_levels(self.through, of_class))

    @cached_property
    def surplus(self) -> Array:
        assert self.rows is not None, "a lifting without estimates of errors"
        fields = whole_fields(self.trace, self.through, self.static, self.modes)
        return surplus_forms(self.trace.folding, self.trace.symmetry_class, self.rows, fields)


class Lifting(Protocol):
    """Lifting of a symmetry class; see `ClassLifting`."""

    @property
    def trace(self) -> FoldedTrace: ...

    @property
    def count(self) -> int: ...

    @property
    def surplus(self) -> Array:
        """(3, b + m, b + m) N/m; see `haptonic.superelement.surplus`."""

    def lifted(self, trace: Fields, amplitudes: Fields) -> Fields: ...


def whole_fields(
    trace: FoldedTrace, through: Array, static: Array, modes: Array, on_ends: Array | None = None
) -> Array:
    """(3 representatives, b + m) fields of a reduced class on all representatives.

    on_ends : (3 representatives, s) motions of open ends; the boundary is the trace, then these
    """
    inner, count = static.shape
    lateral, rim = len(trace.kept), 3 * trace.rim_size
    fields = np.zeros((3 * len(trace.folding.origin), count + modes.shape[1]))
    fields[:inner, :count], fields[:inner, count:] = static, modes
    fields[inner : inner + rim, :lateral] = trace.on_levels(through, np.eye(lateral)).reshape(rim, lateral)
    if on_ends is not None:
        fields[inner + rim :, lateral:count] = on_ends
    return fields


def unfolded(trace: FoldedTrace, inside: Fields, *boundary: Fields) -> Fields:
    """(nodes, 3, k) field of a class from values (3 interior, k) inside and (n, 3, k) on the boundary."""
    values = np.concatenate([inside.reshape(-1, 3, inside.shape[1]), *boundary])
    return np.asarray(trace.folding.sign[trace.symmetry_class][:, :, None] * values[trace.folding.node])


def lifted(parts: Sequence[Lifting], trace: Fields, amplitudes: Fields) -> Fields:
    """(nodes, 3, k) displacement from a whole trace (t, k) and the amplitudes (m, k) of all parts' modes."""
    ends = np.cumsum([part.count for part in parts])
    shares = np.split(amplitudes, ends[:-1])
    return np.asarray(sum(part.lifted(trace, share) for part, share in zip(parts, shares, strict=True)))
