"""Tiles: blocks of the plate reduced to their rims and a few modes, one tile for all equal blocks."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Protocol

import numpy as np

from haptonic.arrays import Array, Fields, Ints
from haptonic.later import linalg as la
from haptonic.plate.body.bonds import Bond3
from haptonic.plate.body.surface import surface_weights
from haptonic.plate.layout.keys import PLATE, PartKey
from haptonic.superelement import CraigBampton

SAME_PLACE = 12  # decimals of distinct positions, m


def applied(matrix: Fields, share: Fields) -> Fields:
    """(m, blocks, k) product of a matrix (m, n) and parts (n, blocks, k) of vectors on equal blocks."""
    blocks, columns = share.shape[1:]
    flat = matrix @ share.reshape(len(share), blocks * columns)
    return np.asarray(flat.reshape(len(matrix), blocks, columns))


def _with_modes(matrix: Array, diagonal: Array, share: Fields) -> Fields:
    """Apply a matrix as `applied`, with only a diagonal (m,) between the last unknowns, the modes."""
    trace = len(matrix) - len(diagonal)
    own, inner = share[:trace], share[trace:]
    coupling, apart = matrix[trace:, :trace], diagonal[:, None, None] * inner
    if coupling.any():
        return np.concatenate([applied(matrix[:trace], share), apart + applied(coupling, own)])
    return np.concatenate([applied(matrix[:trace, :trace], own), apart])


@dataclass(frozen=True, eq=False)
class Eliminated:
    """Equations of a tile with its modes eliminated.

    on_trace : (trace, trace) dynamic stiffness; follow : (modes, trace) amplitudes of the modes for a trace
    inverse : (modes,) inverse of the modes' dynamic stiffness, which is diagonal
    """

    on_trace: Array
    follow: Array
    inverse: Array


class Inside(Protocol):
    """Displacement inside a tile from its unknowns; positions relative to its lower left corner, m."""

    @property
    def points(self) -> Array:
        """(nodes, 3) of its mesh."""

    @property
    def subcells(self) -> Ints:
        """(cells, 8) corners of the elements, in VTK's order."""

    def lifted(self, unknowns: Fields) -> Fields:
        """(nodes, 3, k) displacement from unknowns (n, k)."""

    def normal_at(self, where: Array) -> Array:
        """(k, n) normal displacement of points (k, 2) of the flat face per unknown."""


@dataclass(frozen=True, eq=False)
class Tile:
    """Reduced tile. Unknowns: trace (place on the rim, level, component), then amplitudes of modes.

    Among the modes stiffness and mass are diagonal; products use only the diagonal.

    stiffness : by part (n, n), N/m; mass : (n, n), kg
    values : (m,) squares of the modes' angular frequencies with the rim at rest; modal masses are 1
    drive : by name (n,) force per unit of drive
    capacitance : by actuator, F
    inside : displacement on a mesh from the unknowns
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
    def plain(cls, body: CraigBampton, inside: Inside) -> Tile:
        """Make a tile without attached parts from a reduced body, whose boundary is the trace."""
        return cls(
            stiffness={PLATE: la.block_diag(body.stiffness, np.diag(body.values))},
            mass=np.block([[body.mass, body.to_modes], [body.to_modes.T, np.eye(len(body.values))]]),
            values=body.values,
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
        """Eliminate the modes from K - shift M."""
        matrix = self.elastic - shift * self.mass
        trace, inverse = self.trace_size, 1 / (self.values - shift)
        coupling = matrix[trace:, :trace]
        follow = -inverse[:, None] * coupling
        return Eliminated(matrix[:trace, :trace] + coupling.T @ follow, follow, inverse)


@dataclass(frozen=True, eq=False)
class OnMesh:
    """Inside of a tile with a mesh. size : number of unknowns; faces : of the mesh, on the flat face"""

    size: int
    points: Array
    subcells: Ints
    faces: tuple[Ints, ...]
    lift: Callable[[Fields], Fields]

    def lifted(self, unknowns: Fields) -> Fields:
        return self.lift(unknowns)

    @cached_property
    def _flat(self) -> tuple[Ints, Array]:
        """Nodes of the flat face, and their normal displacement (nodes, n)."""
        nodes = np.unique(np.concatenate([face.ravel() for face in self.faces]))
        return nodes, self.lift(np.eye(self.size))[nodes, 2]

    def normal_at(self, where: Array) -> Array:
        nodes, values = self._flat
        # points of a grid have equal positions on many tiles
        places, back = np.unique(np.round(where, SAME_PLACE), axis=0, return_inverse=True)
        weights = surface_weights(self.points, self.faces, places)[:, nodes]
        return np.asarray((weights @ values)[back])


@dataclass(frozen=True, eq=False)
class Turned:
    """Inside of a tile with other unknowns. whole : (old, n) old unknowns from new ones"""

    inside: Inside
    whole: Array

    @property
    def points(self) -> Array:
        return np.asarray(self.inside.points)

    @property
    def subcells(self) -> Ints:
        return np.asarray(self.inside.subcells)

    def lifted(self, unknowns: Fields) -> Fields:
        return np.asarray(self.inside.lifted(self.whole @ unknowns))

    def normal_at(self, where: Array) -> Array:
        return np.asarray(self.inside.normal_at(where) @ self.whole)
