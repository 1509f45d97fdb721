"""The outline of a section: a closed curve about the origin, from which every point of it is seen.

All users of a shape use its outline: the mesh (`Outline.at`), the body of a prism (`Outline.cubature`),
clearances (`Outline.support`), symmetry, files and pictures (`Outline.polygon`). The parameter of a place
counts the pieces between joints; without joints it is an angle in rad.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from haptonic.arrays import Array, Bools

SAME = 1e-9  # of a half-width: closer places coincide
DIRECTIONS, HALVINGS = 72, 40  # for the search of the direction in which two outlines are farthest apart
EDGE_WIDTH = 0.15  # outermost thin element, as a share of the smallest length at an edge
EDGE_GRADING = 0.2  # ratio of each further thin element's reach to that of the one before
GOLDEN = 0.5 * (np.sqrt(5) - 1)


class Outline:
    """Protocol of all outlines, and derived quantities.

    joints : number of pieces between which curvature or slope jumps; 0 for a smooth curve
    corners : (n, 2) places where the slope jumps, anticlockwise
    flats : (n, 2) outward normals of straight sides
    is_tangential : True if every side touches the circle of radius 1: parallel curves are scaled copies
    warps : True if torsion bends the section out of its plane
    is_convex : True if the curve bends inwards nowhere
    rounding : radius of the arcs in place of corners; 0 for sharp corners, and for a curve without any
    """

    joints: int
    is_tangential: bool
    warps: bool
    is_convex: bool = True
    rounding: float = 0.0

    @property
    def corners(self) -> Array:
        raise NotImplementedError

    @property
    def flats(self) -> Array:
        raise NotImplementedError

    def at(self, place: Array) -> Array:
        """(..., 2) points of the curve at parameters (...), anticlockwise."""
        raise NotImplementedError

    def slope(self, place: Array) -> Array:
        """(..., 2) derivative of the points by the parameter; at a joint, that of the next piece."""
        raise NotImplementedError

    def support(self, direction: Array) -> Array:
        """(n,) farthest extent along unit vectors (n, 2): half-widths of the outline in these directions."""
        raise NotImplementedError

    def bend(self, direction: Array) -> Array:
        """(n,) radius of curvature at normals (n, 2); infinite for any curve with straight sides."""
        raise NotImplementedError

    def image(self, turn: Array) -> Outline:
        """The outline after a rotation or reflection (2, 2)."""
        raise NotImplementedError

    def turned(self, angle: float) -> Outline:
        """The outline turned anticlockwise by an angle, rad."""
        if not angle:
            return self
        cosine, sine = np.cos(angle), np.sin(angle)
        return self.image(np.array([[cosine, -sine], [sine, cosine]]))

    def scaled(self, factor: float) -> Outline:
        """The outline with all its half-widths multiplied."""
        raise NotImplementedError

    @property
    def reach(self) -> float:
        """Distance of the farthest point from the origin."""
        raise NotImplementedError

    @property
    def inradius(self) -> float:
        """Smallest half-width."""
        raise NotImplementedError

    def is_same(self, other: Outline) -> bool:
        """True if two outlines are the same curve up to rounding."""
        raise NotImplementedError

    @property
    def period(self) -> float:
        """Period of the parameter."""
        return self.joints or 2 * np.pi

    @property
    def is_smooth(self) -> bool:
        """True if the outline has neither corners nor straight sides."""
        return not len(self.corners) and not len(self.flats)

    def has_symmetry(self, turn: Array) -> bool:
        """True if a rotation or reflection (2, 2) leaves the outline unchanged."""
        return self.image(turn).is_same(self)

    @property
    def area(self) -> float:
        """Area in squares of the half-width."""
        return float(self.cubature(0)[1].sum())

    @property
    def bulges(self) -> Array:
        """(joints,) tangent of a quarter of the angle that each piece turns through; 0 for a side."""
        return np.array([np.tan(0.25 * self._turning(piece)) for piece in range(self.joints)])

    @property
    def bends(self) -> Array:
        """(joints,) angle of the corner at each joint, or of its arc, rad; positive where it is convex."""
        return np.zeros(self.joints)

    def beside_corners(self, count: int) -> Array:
        """(n,) reach of thin elements on the sides beside corners, farthest first, at most ``count``.

        An arc in place of a corner needs those that reach farther than half its radius: around a square hole
        of 4 mm with arcs of 0.05 and 0.2 mm, errors without them were three to ten times the estimate.
        """
        if not self.bends.any():
            return np.empty(0)
        joint = np.arange(self.joints + 1, dtype=float)
        sides = np.linalg.norm(np.diff(self.at(joint), axis=0), axis=1)[self.is_side]
        shortest = sides.min() if len(sides) else 0.0
        reach = EDGE_WIDTH * shortest * EDGE_GRADING ** np.arange(count)
        return np.asarray(reach[reach > 0.5 * self.rounding])

    @property
    def is_side(self) -> Bools:
        """(joints,) True for straight pieces."""
        return np.array([abs(self._turning(piece)) < SAME for piece in range(self.joints)], dtype=bool)

    @property
    def half_axes(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Larger and smaller half-axis of a smooth outline, and the direction of the larger one."""
        raise NotImplementedError

    def cubature(self, degree: int) -> tuple[Array, Array]:
        """(n, 2) points and (n,) weights: exact integrals of polynomials of a degree over the inside."""
        return _cubature(self, degree)

    def polygon(self, count: int, pieces: int = 1) -> Array:
        """(n, 2) points of the curve, including joints and corners, anticlockwise.

        count : points on a whole turn of a curved part
        pieces : parts of each straight side
        """
        if not self.joints:
            return self.at(2 * np.pi * np.arange(count) / count)
        points = []
        for piece in range(self.joints):
            bent = abs(self._turning(piece)) / (2 * np.pi)
            parts = max(int(np.ceil(count * bent - SAME)), 1) if bent > SAME else pieces
            points.append(self.at(piece + np.arange(parts) / parts))
        return np.concatenate(points)

    def _turning(self, piece: int) -> float:
        """Angle that a piece turns through, rad; 0 for a straight side."""
        raise NotImplementedError


@dataclass(frozen=True)
class Scaled:
    """An outline with its size, for the distance between two pillars.

    half_width : m
    """

    outline: Outline
    half_width: float

    def gap_to(self, other: Scaled, away: Array) -> Array:
        """(n,) distance to another outline at displacements (n, 2), m; negative for an overlap.

        It is the largest value, over all directions, of the displacement less both half-widths in the
        direction. The candidates are the normals of straight sides, the displacement itself and a search
        between them; for two circles the displacement is best.
        """
        if all(curve.outline.reach == curve.outline.inradius for curve in (self, other)):
            radii = self.half_width * self.outline.reach + other.half_width * other.outline.reach
            return np.asarray(np.linalg.norm(away, axis=1) - radii)

        def apart(direction: Array) -> Array:
            here = self.half_width * self.outline.support(direction.reshape(-1, 2))
            there = other.half_width * other.outline.support(-direction.reshape(-1, 2))
            free = np.einsum("n...c,nc->n...", direction, away)
            return np.asarray(free - (here + there).reshape(free.shape))

        def of_angle(angle: Array) -> Array:
            return apart(np.stack([np.cos(angle), np.sin(angle)], axis=-1))

        step = 2 * np.pi / DIRECTIONS
        grid = np.broadcast_to(step * np.arange(DIRECTIONS), (len(away), DIRECTIONS))
        best = step * of_angle(grid).argmax(axis=1)
        low, high = best - step, best + step
        for _ in range(HALVINGS):
            inner, outer = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
            rises = of_angle(inner[:, None])[:, 0] < of_angle(outer[:, None])[:, 0]
            low, high = np.where(rises, inner, low), np.where(rises, high, outer)
        normals = np.concatenate([self.outline.flats, -other.outline.flats])
        along = away / np.linalg.norm(away, axis=1)[:, None]
        candidates = [of_angle(0.5 * (low + high)[:, None]), apart(along[:, None])]
        candidates.append(apart(np.broadcast_to(normals, (len(away), *normals.shape))))
        return np.asarray(np.concatenate(candidates, axis=1).max(axis=1))


@lru_cache(maxsize=64)
def _cubature(outline: Outline, degree: int) -> tuple[Array, Array]:
    """Gauss points along rays from the origin to the curve, on Gauss points along each of its pieces."""
    radial, radial_weight = _gauss(degree // 2 + 1)
    if outline.joints:
        # a side needs degree / 2 + 1 points; an arc of less than half a turn needs more
        share, weight = _gauss(degree + 16)
        place = (np.arange(outline.joints)[:, None] + share).ravel()
        along = np.tile(weight, outline.joints)
    else:
        count = 2 * degree + 8  # exact: a trigonometric polynomial of degree + 2
        place, along = 2 * np.pi * np.arange(count) / count, np.full(count, 2 * np.pi / count)
    point, slope = outline.at(place), outline.slope(place)
    swept = along * (point[:, 0] * slope[:, 1] - point[:, 1] * slope[:, 0])
    points = radial[:, None, None] * point
    return points.reshape(-1, 2), np.outer(radial_weight * radial, swept).ravel()


def _gauss(count: int) -> tuple[Array, Array]:
    """Gauss points and weights on the interval from 0 to 1."""
    points, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (1 + points), 0.5 * weights
