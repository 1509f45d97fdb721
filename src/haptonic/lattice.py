"""Bravais lattices of the plate: integer translations, point group, irreducible zone and its path.

Wavevectors are given by the phases ``kappa = (k . a1, k . a2)`` in radians, so that everything but the
physical length of a wavevector is independent of the size of the cell.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from haptonic.errors import GeometryError
from haptonic.fields import described, problem, remade, size
from haptonic.units import format_quantity

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
class Symmetry:
    """What leaves a kind of lattice unchanged.

    point_group : the operations as integer matrices on lattice coordinates
    zone : the irreducible zone as a convex polygon of (label, phases in units of pi), walked in order by the
        path
    """

    point_group: tuple[Operation, ...]
    zone: tuple[tuple[str, tuple[float, float]], ...]


MIRRORS = (IDENTITY, MIRROR_X, MIRROR_Y, HALF_TURN)
SYMMETRIES = {
    "square": Symmetry(
        (*MIRRORS, DIAGONAL, ((0, -1), (1, 0)), ((0, 1), (-1, 0)), ((0, -1), (-1, 0))),
        (("Γ", (0.0, 0.0)), ("X", (1.0, 0.0)), ("M", (1.0, 1.0))),
    ),
    "rectangular": Symmetry(
        MIRRORS, (("Γ", (0.0, 0.0)), ("X", (1.0, 0.0)), ("S", (1.0, 1.0)), ("Y", (0.0, 1.0)))
    ),
}


@described("cell", GeometryError, kw_only=True)
class Lattice:
    """Two translations ``a1``, ``a2`` in the plane of the plate (m) and what leaves them unchanged.

    ``pitch`` is also the yardstick of every geometric tolerance.

    Raises
    ------
    GeometryError : a period that is not positive, or one too many or too few
    """

    name: Literal["square", "rectangular"] = Field(
        alias="lattice", default="square", title="Lattice", description="How the cells repeat in the plane."
    )
    pitch: Annotated[float, size(100e-6, 100e-3)] = Field(
        title="Pitch", description="Period of the lattice; along x for a rectangular one."
    )
    pitch_y: Annotated[float, size(100e-6, 100e-3)] | None = Field(
        default=None, title="Pitch along y", description="Of a rectangular lattice only."
    )

    def __post_init__(self) -> None:
        if (self.name == "rectangular") != (self.pitch_y is not None):
            missing = self.pitch_y is None
            raise problem(
                "nothing" if missing else format_quantity(self.pitch_y or 0.0, "m"),
                "pitch_y for a rectangular lattice, and for no other",
                "the second period was left out" if missing else f"a {self.name} lattice has one period only",
                'add pitch_y = "7 mm"' if missing else 'remove pitch_y, or write lattice = "rectangular"',
                at="pitch_y",
            )

    @classmethod
    def square(cls, pitch: float) -> Lattice:
        """Square lattice of period ``pitch`` (m)."""
        return cls(lattice="square", pitch=pitch)

    @classmethod
    def rectangular(cls, pitch: float, pitch_y: float) -> Lattice:
        """Rectangular lattice of periods ``pitch`` along x and ``pitch_y`` along y (m)."""
        return cls(lattice="rectangular", pitch=pitch, pitch_y=pitch_y)

    @property
    def a1(self) -> tuple[float, float]:
        """First translation, m."""
        return self.pitch, 0.0

    @property
    def a2(self) -> tuple[float, float]:
        """Second translation, m."""
        return 0.0, self.pitch_y or self.pitch

    @property
    def point_group(self) -> tuple[Operation, ...]:
        """The operations that leave the lattice unchanged, as integer matrices on lattice coordinates."""
        return SYMMETRIES[self.name].point_group

    @property
    def zone(self) -> tuple[tuple[str, tuple[float, float]], ...]:
        """(label, phases in units of pi) of each corner of the irreducible zone, in the order of the path."""
        return SYMMETRIES[self.name].zone

    def scaled(self, factor: float) -> Lattice:
        """The same lattice with both periods multiplied by ``factor``."""
        return remade(self, pitch=self.pitch * factor, pitch_y=self.pitch_y and self.pitch_y * factor)

    @cached_property
    def vectors(self) -> Array:
        """(2, 2): the rows are a1 and a2, m."""
        return np.array([self.a1, self.a2], dtype=float)

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
