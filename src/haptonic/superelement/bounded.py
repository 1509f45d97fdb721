"""A body with a boundary: its forms, and the static response of its interior."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from haptonic.arrays import Array
from haptonic.later import linalg as la, sparse as sp

COLUMNS_AT_ONCE = 128  # fields that are copied at a time
# Share of a motion's inertia below which it depends on others; those of several wavevectors are alike.
ALIKE = 1e-4


def portions(count: int) -> Iterator[slice]:
    """At least one slice of few columns each, whose copies need little memory."""
    starts = range(0, max(count, 1), COLUMNS_AT_ONCE)
    return (slice(first, min(first + COLUMNS_AT_ONCE, count)) for first in starts)


class Factorised(Protocol):
    """Solver with the factorised stiffness of an interior."""

    def solve(self, right: Array) -> Array:
        """(n, m) static responses to forces (n, m)."""


@dataclass(frozen=True)
class Bounded:
    """Forms of a body with n interior unknowns and b on its boundary.

    coupling : (n, b) stiffness between the two, sparse where few unknowns inside meet the boundary
    outer_stiffness, outer_mass : (b, b)
    mass : (n,) diagonal, or (n, n) sparse; mass_coupling : (n, b), or None where mass is lumped
    """

    coupling: Array | sp.csr_array
    outer_stiffness: Array
    outer_mass: Array
    mass: Array | sp.csr_array
    mass_coupling: Array | None = None

    def inertia(self, fields: Array) -> Array:
        """(n, k) mass times fields (n, k)."""
        lumped = isinstance(self.mass, np.ndarray)
        return np.asarray(self.mass[:, None] * fields if lumped else self.mass @ fields)

    def mass_with(self, static: Array) -> Array:
        """(b, b) mass of the boundary if the interior responds with ``static`` (n, b)."""
        along = [static.T @ self.inertia(static[:, few]) for few in portions(static.shape[1])]
        mass = self.outer_mass + np.hstack(along)
        if self.mass_coupling is not None:
            crossed = self.mass_coupling.T @ static
            mass += crossed + crossed.T
        return np.asarray(mass)

    def stiffness_with(self, static: Array) -> Array:
        """(b, b) stiffness of the boundary if the interior responds with ``static`` (n, b)."""
        along = [self.coupling.T @ static[:, few] for few in portions(static.shape[1])]
        return np.asarray(self.outer_stiffness + np.hstack(along))

    def static(self, solver: Factorised) -> Array:
        """(n, b) motion inside for unit motions of the boundary; ``solver`` has factorised the interior."""
        if isinstance(self.coupling, np.ndarray):
            return solver.solve(-self.coupling)
        motion = np.empty(self.coupling.shape, order="F")
        for few in portions(motion.shape[1]):
            motion[:, few] = solver.solve(-self.coupling[:, few].toarray(order="F"))
        return motion


@dataclass(frozen=True)
class StaticResponse:
    """Body whose interior responds statically to its boundary.

    static : (n, b) motion inside; stiffness, mass : (b, b)
    """

    body: Bounded
    static: Array
    stiffness: Array
    mass: Array

    @classmethod
    def of(cls, solver: Factorised, body: Bounded) -> StaticResponse:
        """Compute the response with a solver that has factorised the interior stiffness."""
        static = body.static(solver)
        return cls(body, static, body.stiffness_with(static), body.mass_with(static))

    def softest(self, count: int) -> Array:
        """(b, count) softest motions of the boundary, orthonormal in the mass; all if there are fewer."""
        few = min(count, len(self.mass))
        return np.asarray(la.eigh(self.stiffness, self.mass, subset_by_index=(0, few - 1))[1])


def orthonormal(motions: Array, mass: Array) -> Array:
    """(b, n) orthonormal combinations of motions (b, k) of unit mass, without dependent ones."""
    weight, turn = la.eigh(motions.T @ (mass @ motions))
    apart = weight > ALIKE
    return np.asarray(motions @ (turn[:, apart] / np.sqrt(weight[apart])))
