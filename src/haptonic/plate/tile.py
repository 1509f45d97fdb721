"""A block of the plate reduced to its rim and a few modes: one tile for all blocks that are alike."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Protocol

import numpy as np

from haptonic.arrays import Array, Fields, Ints
from haptonic.later import linalg as la
from haptonic.plate.bonds import Bond3
from haptonic.plate.keys import PLATE, PartKey
from haptonic.plate.surface import surface_weights

SAME_PLACE = 12  # decimals to which positions, m, are told apart


def applied(matrix: Fields, share: Fields) -> Fields:
    """(m, blocks, k) a matrix (m, n) times the parts (n, blocks, k) of vectors on like blocks."""
    blocks, columns = share.shape[1:]
    flat = matrix @ share.reshape(len(share), blocks * columns)
    return np.asarray(flat.reshape(len(matrix), blocks, columns))


def _with_modes(matrix: Array, diagonal: Array, share: Fields) -> Fields:
    """As `applied`, if the last unknowns, modes, have nothing but a diagonal (m,) among themselves."""
    trace = len(matrix) - len(diagonal)
    own, inner = share[:trace], share[trace:]
    coupling, apart = matrix[trace:, :trace], diagonal[:, None, None] * inner
    if coupling.any():
        return np.concatenate([applied(matrix[:trace], share), apart + applied(coupling, own)])
    return np.concatenate([applied(matrix[:trace, :trace], own), apart])


@dataclass(frozen=True, eq=False)
class Eliminated:
    """The modes of a tile, taken out of its equations.

    on_trace : (trace, trace) dynamic stiffness that is left; follow : (modes, trace) the modes behind a trace
    inverse : (modes,) of their own dynamic stiffness, which is diagonal
    """

    on_trace: Array
    follow: Array
    inverse: Array


class Inside(Protocol):
    """From the unknowns of a tile to displacement inside it; positions are from its lower left corner, m."""

    @property
    def points(self) -> Array:
        """(nodes, 3) of its mesh."""
        ...

    @property
    def subcells(self) -> Ints:
        """(cells, 8) corners of the elements, in VTK's order."""
        ...

    def lifted(self, unknowns: Fields) -> Fields:
        """(nodes, 3, k) displacement from unknowns (n, k)."""
        ...

    def normal_at(self, where: Array) -> Array:
        """(k, n) what gives the normal displacement of points (k, 2) of the flat face."""
        ...


@dataclass(frozen=True, eq=False)
class Tile:
    """Unknowns: the trace (place on the rim, level, component), then amplitudes of modes that have none.

    Among the modes stiffness and mass are diagonal; products use only the diagonal.

    stiffness : by part (n, n), N/m; mass : (n, n), kg
    values : (m,) squares of the modes' angular frequencies with the rim at rest; modal masses are 1
    drive : by name (n,) force per unit of drive
    capacitance : by actuator, F
    inside : what the unknowns mean on a mesh
    bonds : by actuator, bonds whose thickness may change
    """

    stiffness: Mapping[PartKey, Array]
    mass: Array
    values: Array
    drive: Mapping[str, Array]
    capacitance: Mapping[str, float]
    inside: Inside
    bonds: Mapping[str, Bond3] = field(default_factory=dict)

    @classmethod
    def plain(cls, stiffness: Array, mass: Array, trace: int, inside: Inside) -> Tile:
        """With nothing glued on; ``trace`` unknowns whose static answers have no share in the modes."""
        values = np.diag(stiffness)[trace:].copy()
        return cls(
            stiffness={PLATE: la.block_diag(stiffness[:trace, :trace], np.diag(values))},
            mass=mass,
            values=values,
            drive={},
            capacitance={},
            inside=inside,
        )

    @property
    def size(self) -> int:
        return len(self.mass)

    @property
    def trace_size(self) -> int:
        return self.size - len(self.values)

    @cached_property
    def elastic(self) -> Array:
        """(n, n) stiffness of all parts together."""
        return np.asarray(sum(self.stiffness.values()))

    def mass_times(self, share: Fields) -> Fields:
        """(n, blocks, k) M times the parts of vectors on blocks."""
        return _with_modes(self.mass, np.ones(len(self.values)), share)

    def stiffness_times(self, share: Fields) -> Fields:
        """(n, blocks, k) K of all parts times the parts of vectors on blocks."""
        return _with_modes(self.elastic, self.values, share)

    def part_times(self, part: PartKey, share: Fields) -> Fields:
        """(n, blocks, k) K of one part times the parts of vectors on blocks."""
        if len(self.stiffness) == 1:
            return self.stiffness_times(share)
        return applied(self.stiffness[part], share)

    def dynamic(self, shift: float) -> Eliminated:
        """K - shift M with the modes eliminated."""
        matrix = self.elastic - shift * self.mass
        trace, inverse = self.trace_size, 1 / (self.values - shift)
        coupling = matrix[trace:, :trace]
        follow = -inverse[:, None] * coupling
        return Eliminated(matrix[:trace, :trace] + coupling.T @ follow, follow, inverse)


@dataclass(frozen=True, eq=False)
class OnMesh:
    """A tile with a mesh of its own. size : unknowns; faces : of the mesh, on the flat face"""

    size: int
    points: Array
    subcells: Ints
    faces: tuple[Ints, ...]
    lift: Callable[[Fields], Fields]

    def lifted(self, unknowns: Fields) -> Fields:
        """(nodes, 3, k) displacement from unknowns (n, k)."""
        return self.lift(unknowns)

    @cached_property
    def _flat(self) -> tuple[Ints, Array]:
        """Nodes of the flat face, and their normal displacement (nodes, n)."""
        nodes = np.unique(np.concatenate([face.ravel() for face in self.faces]))
        return nodes, self.lift(np.eye(self.size))[nodes, 2]

    def normal_at(self, where: Array) -> Array:
        """(k, n) what gives the normal displacement of points (k, 2) of the flat face."""
        nodes, values = self._flat
        # points of a grid lie alike on many tiles
        places, back = np.unique(np.round(where, SAME_PLACE), axis=0, return_inverse=True)
        weights = surface_weights(self.points, self.faces, places)[:, nodes]
        return np.asarray((weights @ values)[back])


@dataclass(frozen=True, eq=False)
class Turned:
    """Inside a tile whose unknowns are others. whole : (old, n) old unknowns from new ones"""

    inside: Inside
    whole: Array

    @property
    def points(self) -> Array:
        """(nodes, 3) of its mesh."""
        return np.asarray(self.inside.points)

    @property
    def subcells(self) -> Ints:
        """(cells, 8) corners of the elements, in VTK's order."""
        return np.asarray(self.inside.subcells)

    def lifted(self, unknowns: Fields) -> Fields:
        """(nodes, 3, k) displacement from unknowns (n, k)."""
        return np.asarray(self.inside.lifted(self.whole @ unknowns))

    def normal_at(self, where: Array) -> Array:
        """(k, n) what gives the normal displacement of points (k, 2) of the flat face."""
        return np.asarray(self.inside.normal_at(where) @ self.whole)
