"""Circles and ellipses."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from haptonic.arrays import Array
from haptonic.cell.outlines.outline import SAME, Outline


@dataclass(frozen=True)
class Oval(Outline):
    """Image of the unit circle under a stretch, a symmetric matrix ((a, b), (b, c))."""

    stretch: tuple[tuple[float, float], tuple[float, float]]

    joints = 0

    @classmethod
    def of_axes(cls, along: float, across: float, turn: float = 0.0) -> Oval:
        """Ellipse with two half-axes, the first in direction ``turn`` (rad)."""
        axis = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        (a, b), (_, d) = ((axis * [along, across]) @ axis.T).tolist()
        return cls(((a, b), (b, d)))

    @cached_property
    def _matrix(self) -> Array:
        return np.array(self.stretch)

    @cached_property
    def _half_axes(self) -> tuple[float, float]:
        """The smaller and the larger half-axis."""
        small, large = np.linalg.eigvalsh(self._matrix).tolist()
        return small, large

    @property
    def half_axes(self) -> tuple[tuple[float, float], tuple[float, float]]:
        if self.is_circle:
            return (self._half_axes[1],) * 2, (1.0, 0.0)
        small, large = self._half_axes
        a, b = np.linalg.eigh(self._matrix)[1][:, 1].tolist()
        return (large, small), (a, b)

    @property
    def is_circle(self) -> bool:
        """True if both half-axes are equal."""
        small, large = self._half_axes
        return large - small < SAME * large

    @property
    def corners(self) -> Array:
        return np.empty((0, 2))

    @property
    def flats(self) -> Array:
        return np.empty((0, 2))

    def bend(self, direction: Array) -> Array:
        small, large = self._half_axes
        return np.asarray((small * large) ** 2 / self.support(direction) ** 3)

    @property
    def is_tangential(self) -> bool:  # type: ignore[override]
        return self.is_circle

    @property
    def warps(self) -> bool:  # type: ignore[override]
        return not self.is_circle

    def at(self, place: Array) -> Array:
        return np.asarray(np.stack([np.cos(place), np.sin(place)], axis=-1) @ self._matrix)

    def slope(self, place: Array) -> Array:
        return np.asarray(np.stack([-np.sin(place), np.cos(place)], axis=-1) @ self._matrix)

    def support(self, direction: Array) -> Array:
        return np.asarray(np.linalg.norm(direction @ self._matrix, axis=-1))

    @property
    def inradius(self) -> float:
        return self._half_axes[0] if self.stretch != CIRCLE.stretch else 1.0

    @property
    def reach(self) -> float:
        return self._half_axes[1]

    def scaled(self, factor: float) -> Oval:
        (a, b), (_, d) = self.stretch
        return Oval(((factor * a, factor * b), (factor * b, factor * d)))

    def image(self, turn: Array) -> Oval:
        (a, b), (_, d) = (turn @ self._matrix @ turn.T).tolist()
        return Oval(((a, b), (b, d)))

    def is_same(self, other: Outline) -> bool:
        return isinstance(other, Oval) and bool(np.abs(self._matrix - other._matrix).max() < SAME)


CIRCLE = Oval(((1.0, 0.0), (0.0, 1.0)))
