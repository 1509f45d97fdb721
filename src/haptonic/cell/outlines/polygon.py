"""Polygons that are stars about their axis, sharp or with rounded corners."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from haptonic.arrays import Array
from haptonic.cell.outlines.outline import SAME, Outline
from haptonic.cell.outlines.oval import CIRCLE

Vertices = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Polygon(Outline):
    """A polygon about the origin, from which every point of it is seen; corners may point inwards.

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
    def _bend(self) -> Array:
        """(n,) turn to the left at each vertex, rad; negative where the polygon bends inwards."""
        before = np.roll(self._normal, 1, axis=0)
        sine = before[:, 0] * self._normal[:, 1] - before[:, 1] * self._normal[:, 0]
        return np.asarray(np.arctan2(sine, np.einsum("nc,nc->n", before, self._normal)))

    @cached_property
    def _radius(self) -> Array:
        """(n,) radius of each arc, negative where the polygon bends inwards and the centre is outside."""
        return np.where(self._bend < 0, -self.rounding, self.rounding)

    @cached_property
    def _centre(self) -> Array:
        """(n, 2) centres of the arcs: vertices of the parallel polygon."""
        before = np.roll(self._normal, 1, axis=0)
        share = 1 + np.einsum("nc,nc->n", before, self._normal)
        return np.asarray(self._corner - (self._radius / share)[:, None] * (before + self._normal))

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
            before, after, following = self._normal[k - 1], self._normal[k], (k + 1) % len(self._corner)
            start = self._centre[k] + self._radius[k] * after
            end = self._centre[following] + self._radius[following] * after
            if self.rounding:
                beside = np.array([-before[1], before[0]])
                pieces.append([self._centre[k], self._radius[k] * before, self._radius[k] * beside, zero])
                angles.append(float(self._bend[k]))
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
    def bends(self) -> Array:
        if not self.rounding:
            return self._bend
        # an arc has its angle at both ends
        return self._angles + np.roll(self._angles, 1)

    @property
    def flats(self) -> Array:
        return self._normal

    def bend(self, direction: Array) -> Array:
        return np.full(len(direction), np.inf)

    @property
    def is_tangential(self) -> bool:  # type: ignore[override]
        return not self.rounding and self.is_convex and bool(np.ptp(self.support(self._normal)) < SAME)

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
        outer = self._centre[self._bend > 0]
        return np.asarray((direction @ outer.T).max(axis=-1) + self.rounding)

    @property
    def inradius(self) -> float:
        if self.is_convex:
            return float(self.support(self._normal).min())
        piece, straight = self._pieces, self._angles == 0
        start, step = piece[straight, 0], piece[straight, 3]
        share = -np.einsum("nc,nc->n", start, step) / np.einsum("nc,nc->n", step, step)
        nearest = np.linalg.norm(start + np.clip(share, 0, 1)[:, None] * step, axis=1).min()
        # the nearest point of an arc that bends inwards, if it lies between the ends of the arc
        inwards = self._angles < 0
        centre, first, second = np.moveaxis(piece[inwards, :3], 1, 0)
        away, radius = np.linalg.norm(centre, axis=1), np.linalg.norm(first, axis=1)
        turn = np.arctan2(*(np.einsum("nc,nc->n", centre, axis) for axis in (-second, -first)))
        within = (turn < 0) & (turn > self._angles[inwards])
        return float(min(nearest, (away - radius)[within].min(initial=np.inf)))

    @property
    def reach(self) -> float:
        return float(np.linalg.norm(self._centre[self._bend > 0], axis=1).max() + self.rounding)

    def scaled(self, factor: float) -> Polygon:
        return Polygon(tuple((factor * x, factor * y) for x, y in self.vertices), factor * self.rounding)

    def rounded(self, radius: float) -> Outline:
        """The polygon with arcs instead of its corners; a circle if no straight side is left."""
        if not radius:
            return self
        arcs = Polygon(self.vertices, radius)
        centre = arcs._centre.mean(axis=0)
        if self.is_convex and arcs._angles.all() and np.abs(centre).max() < SAME:
            return CIRCLE.scaled(radius)
        return arcs

    def image(self, turn: Array) -> Polygon:
        corner = self._corner @ turn.T
        corner = corner[:: 1 if np.linalg.det(turn) > 0 else -1]
        return Polygon(tuple((float(x), float(y)) for x, y in corner), self.rounding)

    def is_same(self, other: Outline) -> bool:
        if not isinstance(other, Polygon) or len(other.vertices) != len(self.vertices):
            return False
        apart = np.linalg.norm(self._corner[:, None] - other._corner, axis=2).min(axis=1).max()
        return bool(apart < SAME * np.abs(self._corner).max()) and abs(self.rounding - other.rounding) < SAME

    @property
    def interior_angles(self) -> Array:
        """(n,) interior angles at the vertices, rad."""
        return np.asarray(np.pi - self._bend)

    @property
    def most_rounding(self) -> float:
        """Radius of the arcs at which the first straight side vanishes, in half-widths."""
        # an arc of radius 1 takes tan(turn / 2) off either side at a vertex
        taken = np.tan(0.5 * np.abs(self._bend))
        sides = np.linalg.norm(np.roll(self._corner, -1, axis=0) - self._corner, axis=1)
        return float((sides / (taken + np.roll(taken, -1))).min())

    @property
    def is_convex(self) -> bool:  # type: ignore[override]
        return bool((self._bend > SAME).all())

    @property
    def is_star(self) -> bool:
        """True if the vertices go once about the origin, which is on the left of every side."""
        corner, following = self._corner, np.roll(self._corner, -1, axis=0)
        left = (corner[:, 0] * following[:, 1] - corner[:, 1] * following[:, 0]) > SAME
        angles = np.arctan2(corner[:, 1], corner[:, 0])
        once = np.diff(np.append(angles, angles[0])) % (2 * np.pi)
        return bool(left.all() and abs(once.sum() - 2 * np.pi) < SAME and (np.abs(self._bend) > SAME).all())
