"""Convex polygons, sharp or with rounded corners."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from haptonic.arrays import Array
from haptonic.cell.outlines.outline import SAME, Outline
from haptonic.cell.outlines.oval import CIRCLE

Vertices = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Convex(Outline):
    """A convex polygon about the origin.

    vertices : anticlockwise
    rounding : radius of the arcs that replace its corners, in half-widths
    """

    vertices: Vertices
    rounding: float = 0.0

    warps = True

    @cached_property
    def _corner(self) -> Array:
        return np.array(self.vertices)

    @cached_property
    def _normal(self) -> Array:
        """(n, 2) outward normal of the side that begins at each vertex."""
        along = np.roll(self._corner, -1, axis=0) - self._corner
        return np.asarray(
            np.stack([along[:, 1], -along[:, 0]], axis=1) / np.linalg.norm(along, axis=1)[:, None]
        )

    @cached_property
    def _centre(self) -> Array:
        """(n, 2) centres of the arcs: vertices of the parallel polygon inside."""
        before = np.roll(self._normal, 1, axis=0)
        share = 1 + np.einsum("nc,nc->n", before, self._normal)
        return np.asarray(self._corner - self.rounding * (before + self._normal) / share[:, None])

    @cached_property
    def _pieces(self) -> Array:
        """(joints, 4, 2) centre, radius in two directions, and step of each piece; arcs have no step.

        A point at a share s is centre + cos(s angle) first + sin(s angle) second + s step; see `_angles`.
        """
        return self._pieces_and_angles[0]

    @cached_property
    def _angles(self) -> Array:
        """(joints,) angle that each piece turns through, rad; 0 for a straight side."""
        return self._pieces_and_angles[1]

    @cached_property
    def _pieces_and_angles(self) -> tuple[Array, Array]:
        pieces, angles = [], []
        zero = np.zeros(2)
        for k in range(len(self._corner)):
            before, after = self._normal[k - 1], self._normal[k]
            start = self._centre[k] + self.rounding * after
            end = self._centre[(k + 1) % len(self._corner)] + self.rounding * after
            if self.rounding:
                beside = np.array([-before[1], before[0]])
                pieces.append([self._centre[k], self.rounding * before, self.rounding * beside, zero])
                angles.append(float(np.arctan2(beside @ after, before @ after)))
            if np.linalg.norm(end - start) > SAME:
                pieces.append([start, zero, zero, end - start])
                angles.append(0.0)
        return np.array(pieces), np.array(angles)

    def _turning(self, piece: int) -> float:
        return float(self._angles[piece])

    @property
    def joints(self) -> int:  # type: ignore[override]
        return len(self._angles)

    @property
    def corners(self) -> Array:
        return np.empty((0, 2)) if self.rounding else self._corner

    @property
    def flats(self) -> Array:
        return self._normal

    def bend(self, direction: Array) -> Array:
        return np.full(len(direction), np.inf)

    @property
    def is_tangential(self) -> bool:  # type: ignore[override]
        return not self.rounding and bool(np.ptp(self.support(self._normal)) < SAME)

    def _share(self, place: Array) -> tuple[Array, Array, Array]:
        piece = np.floor(np.asarray(place) + SAME)
        number = piece.astype(int) % self.joints
        return self._pieces[number], self._angles[number], np.asarray(place) - piece

    def at(self, place: Array) -> Array:
        piece, angle, share = self._share(place)
        turned = share * angle
        along = np.cos(turned)[..., None] * piece[..., 1, :] + np.sin(turned)[..., None] * piece[..., 2, :]
        return np.asarray(piece[..., 0, :] + along + share[..., None] * piece[..., 3, :])

    def slope(self, place: Array) -> Array:
        piece, angle, share = self._share(place)
        turned = share * angle
        along = np.cos(turned)[..., None] * piece[..., 2, :] - np.sin(turned)[..., None] * piece[..., 1, :]
        return np.asarray(angle[..., None] * along + piece[..., 3, :])

    def support(self, direction: Array) -> Array:
        return np.asarray((direction @ self._centre.T).max(axis=-1) + self.rounding)

    @property
    def inradius(self) -> float:
        return float(self.support(self._normal).min())

    @property
    def reach(self) -> float:
        return float(np.linalg.norm(self._centre, axis=1).max() + self.rounding)

    def scaled(self, factor: float) -> Convex:
        return Convex(tuple((factor * x, factor * y) for x, y in self.vertices), factor * self.rounding)

    def rounded(self, radius: float) -> Outline:
        """The polygon with arcs instead of its corners; a circle if no straight side is left."""
        if not radius:
            return self
        arcs = Convex(self.vertices, radius)
        centre = arcs._centre.mean(axis=0)
        if arcs._angles.all() and np.abs(centre).max() < SAME:
            return CIRCLE.scaled(radius)
        return arcs

    def image(self, turn: Array) -> Convex:
        corner = self._corner @ turn.T
        corner = corner[:: 1 if np.linalg.det(turn) > 0 else -1]
        return Convex(tuple((float(x), float(y)) for x, y in corner), self.rounding)

    def is_same(self, other: Outline) -> bool:
        if not isinstance(other, Convex) or len(other.vertices) != len(self.vertices):
            return False
        apart = np.linalg.norm(self._corner[:, None] - other._corner, axis=2).min(axis=1).max()
        return bool(apart < SAME * np.abs(self._corner).max()) and abs(self.rounding - other.rounding) < SAME

    @property
    def interior_angles(self) -> Array:
        """(n,) interior angles at the vertices, rad."""
        before = np.roll(self._normal, 1, axis=0)
        sine = before[:, 0] * self._normal[:, 1] - before[:, 1] * self._normal[:, 0]
        return np.asarray(np.pi - np.arctan2(sine, np.einsum("nc,nc->n", before, self._normal)))

    @property
    def most_rounding(self) -> float:
        """Radius of the arcs at which the first straight side vanishes, in half-widths."""
        before = np.roll(self._normal, 1, axis=0)
        cosine = np.einsum("nc,nc->n", before, self._normal)
        # an arc of radius 1 takes tan(turn / 2) off either side at a vertex
        taken = np.sqrt(np.maximum(1 - cosine, 0.0) / (1 + cosine))
        sides = np.linalg.norm(np.roll(self._corner, -1, axis=0) - self._corner, axis=1)
        return float((sides / (taken + np.roll(taken, -1))).min())

    @property
    def is_convex(self) -> bool:
        """True if the vertices turn to the left everywhere, once about the origin."""
        angles = np.arctan2(self._corner[:, 1], self._corner[:, 0])
        once = np.diff(np.append(angles, angles[0])) % (2 * np.pi)
        left = np.sin(self.interior_angles) > SAME
        return bool(
            left.all() and abs(once.sum() - 2 * np.pi) < SAME and (self.support(self._normal) > 0).all()
        )
