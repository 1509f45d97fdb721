"""Bravais lattices of the plate: integer translations, point group, irreducible zone and its path.

Wavevectors are given by the phases ``kappa = (k . a1, k . a2)`` in radians, so that everything but the
physical length of a wavevector is independent of the size of the cell.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import GeometryError

Array = NDArray[np.float64]
Operation = tuple[tuple[int, int], tuple[int, int]]

IDENTITY: Operation = ((1, 0), (0, 1))
MIRROR_X: Operation = ((-1, 0), (0, 1))
MIRROR_Y: Operation = ((1, 0), (0, -1))
HALF_TURN: Operation = ((-1, 0), (0, -1))
DIAGONAL: Operation = ((0, 1), (1, 0))


@dataclass(frozen=True)
class Path:
    """Wavevectors along the edge of the irreducible zone.

    kappa : (n, 2) phases, rad
    distance : (n,) arc length of the wavevector from the start, rad/m
    corners : positions of the labelled corners in the arrays
    labels : their names, one each
    segment : (n,) number of the segment that a point belongs to (a corner opens the next one)
    """

    kappa: Array
    distance: Array
    corners: tuple[int, ...]
    labels: tuple[str, ...]

    @cached_property
    def segment(self) -> NDArray[np.int64]:
        inner = np.asarray(self.corners[1:-1])
        return np.searchsorted(inner, np.arange(len(self.kappa)), side="right")


@dataclass(frozen=True)
class Lattice:
    """Two translations ``a1``, ``a2`` in the plane of the plate (m) and what leaves them unchanged.

    ``point_group`` holds the operations as integer matrices on lattice coordinates; a cell that has less
    symmetry than its lattice passes only the operations that it shares. ``zone`` is the irreducible zone
    as a convex polygon of (label, phases in units of pi), walked in order by the path.
    """

    name: str
    a1: tuple[float, float]
    a2: tuple[float, float]
    point_group: tuple[Operation, ...]
    zone: tuple[tuple[str, tuple[float, float]], ...]

    def __post_init__(self) -> None:
        if not (np.isfinite(self.vectors).all() and abs(np.linalg.det(self.vectors)) > 0):
            raise GeometryError(
                argument="cell.lattice",
                given=f"a1 = {self.a1}, a2 = {self.a2}",
                allowed="two finite translations that are not parallel",
                cause="a pitch is zero or not a number",
                next_step="give positive pitches",
            )

    @classmethod
    def square(cls, pitch: float) -> Lattice:
        """Square lattice of period ``pitch`` (m)."""
        mirrors = (IDENTITY, MIRROR_X, MIRROR_Y, HALF_TURN)
        turned = (DIAGONAL, ((0, -1), (1, 0)), ((0, 1), (-1, 0)), ((0, -1), (-1, 0)))
        zone = (("Γ", (0.0, 0.0)), ("X", (1.0, 0.0)), ("M", (1.0, 1.0)))
        return cls("square", (pitch, 0.0), (0.0, pitch), mirrors + turned, zone)

    @classmethod
    def rectangular(cls, pitch: float, pitch_y: float) -> Lattice:
        """Rectangular lattice of periods ``pitch`` along x and ``pitch_y`` along y (m)."""
        zone = (("Γ", (0.0, 0.0)), ("X", (1.0, 0.0)), ("S", (1.0, 1.0)), ("Y", (0.0, 1.0)))
        mirrors = (IDENTITY, MIRROR_X, MIRROR_Y, HALF_TURN)
        return cls("rectangular", (pitch, 0.0), (0.0, pitch_y), mirrors, zone)

    @cached_property
    def vectors(self) -> Array:
        """(2, 2): the rows are a1 and a2, m."""
        return np.array([self.a1, self.a2], dtype=float)

    @property
    def pitch(self) -> float:
        """Length of the first translation, m; the yardstick of every geometric tolerance."""
        return float(np.hypot(*self.a1))

    @property
    def area(self) -> float:
        """Area of the cell, m^2."""
        return float(abs(np.linalg.det(self.vectors)))

    def operations(self) -> list[Array]:
        """The point group as orthogonal maps (3, 3) of space that keep the plate's normal."""
        maps = []
        for op in self.point_group:
            space = np.eye(3)
            space[:2, :2] = self.vectors.T @ np.array(op) @ np.linalg.inv(self.vectors.T)
            maps.append(space)
        return maps

    def wavevector(self, kappa: Array) -> Array:
        """(..., 2) wavevectors in rad/m from (..., 2) phases: k . a_j = kappa_j."""
        return np.asarray(kappa) @ np.linalg.inv(self.vectors).T

    def mirrors(self) -> dict[str, Operation]:
        """The reflections among the point group, by name."""
        names = {"x": MIRROR_X, "y": MIRROR_Y, "d": DIAGONAL}
        return {name: op for name, op in names.items() if op in self.point_group}

    def little_group(self, kappa: tuple[float, float]) -> tuple[Operation, ...]:
        """Operations that leave the wavevector unchanged up to a reciprocal lattice vector."""
        here = np.asarray(kappa)
        kept = []
        for op in self.point_group:
            turns = (np.linalg.inv(np.array(op)).T @ here - here) / (2 * np.pi)
            if np.allclose(turns, np.round(turns), atol=1e-9):
                kept.append(op)
        return tuple(kept)

    @cached_property
    def corner_phases(self) -> dict[str, Array]:
        """Phases of the labelled corners of the irreducible zone, rad."""
        return {label: np.pi * np.array(point) for label, point in self.zone}

    def path(self, points: int) -> Path:
        """``points`` wavevectors once round the irreducible zone, corners included, ends counted both.

        Each segment gets a share in proportion to its length, so the spacing is even in rad/m.
        """
        labels = [label for label, _ in self.zone]
        corners = [self.corner_phases[label] for label in [*labels, labels[0]]]
        lengths = [float(np.linalg.norm(self.wavevector(b - a))) for a, b in pairwise(corners)]
        if points < 2 * len(lengths) + 1:
            raise GeometryError(
                argument="bands.points",
                given=points,
                allowed=f"at least {2 * len(lengths) + 1} for {len(lengths)} segments",
                cause="too few points to draw the edge of the irreducible zone",
                next_step="ask for more points",
            )
        shares = np.cumsum([0.0, *lengths]) / sum(lengths)
        marks = np.round(shares * (points - 1)).astype(int)
        for j in range(1, len(marks)):  # every segment keeps at least one inner point
            marks[j] = min(max(marks[j], marks[j - 1] + 2), points - 1 - 2 * (len(marks) - 1 - j))
        pieces, distances, start = [], [], 0.0
        for j, length in enumerate(lengths):
            steps = marks[j + 1] - marks[j]
            t = np.arange(steps + (j == len(lengths) - 1)) / steps
            pieces.append(corners[j] + t[:, None] * (corners[j + 1] - corners[j]))
            distances.append(start + t * length)
            start += length
        return Path(
            kappa=np.concatenate(pieces),
            distance=np.concatenate(distances),
            corners=tuple(int(m) for m in marks),
            labels=(*labels, labels[0]),
        )

    def zone_triangles(self, divisions: int) -> tuple[Array, NDArray[np.int64]]:
        """Triangles that tile the irreducible zone exactly.

        Returns
        -------
        kappa : (n, 2) phases of the vertices, rad
        triangles : (m, 3) vertex numbers
        """
        corners = [self.corner_phases[label] for label, _ in self.zone]
        kappa: list[Array] = []
        number: dict[tuple[int, int, int], int] = {}
        triangles: list[tuple[int, int, int]] = []
        n = divisions
        for fan in range(1, len(corners) - 1):

            def vertex(i: int, j: int, fan: int = fan) -> int:
                # weights (n - i, i - j, j) of the fan's corners; vertices on a shared edge are met twice
                key = (fan + 1, 0, i) if j == i else (fan, i - j, j)
                key = (fan, 0, i) if j == 0 else key
                key = (0, 0, 0) if i == 0 else key
                if key not in number:
                    number[key] = len(kappa)
                    a, b, c = corners[0], corners[fan], corners[fan + 1]
                    kappa.append(a + (i - j) / n * (b - a) + j / n * (c - a))
                return number[key]

            for i in range(n):
                for j in range(i + 1):
                    triangles.append((vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)))
                    if j < i:
                        triangles.append((vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)))
        return np.array(kappa), np.array(triangles, dtype=np.int64)
