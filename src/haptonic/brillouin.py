"""The irreducible part of the Brillouin zone: its corners, the path along its edge, and triangles in it.

The point group and time reversal, k -> -k, map every wavevector of the zone to one in this part. The group is
that of lattice, outline and material together.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice, PointGroup
from haptonic.translations import SAME, voronoi_cell

# names of the midpoints of the zone's sides, in the order of the path, and of its corners; Γ is the centre
NAMES = {
    "square": ("XY", "M"),
    "rectangular": ("XY", "S"),
    "triangular": ("M", "K"),
    "centred": ("XS", "HY"),
    "oblique": ("XYC", "H"),
    "honeycomb": ("M", "K"),
    "kagome": ("M", "K"),
    "lieb": ("XY", "M"),
}


@dataclass(frozen=True)
class Path:
    """Wavevectors along the edge of the irreducible zone.

    kappa : (n, 2) phases, rad
    distance : (n,) arc length of the wavevector from the start, rad/m
    corners : indices of the labelled corners in the arrays
    labels : names of the corners
    segment : (n,) segment number of each point (a corner belongs to the next segment)
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
class IrreducibleZone:
    """Convex polygon of wavevectors; the path follows its edge.

    corners : (label, phases in units of pi), the centre of the zone first
    """

    lattice: Lattice
    corners: tuple[tuple[str, tuple[float, float]], ...]

    @classmethod
    def of(cls, lattice: Lattice, group: PointGroup) -> IrreducibleZone:
        """Irreducible zone of a lattice under the operations of a group.

        It is the wedge between two neighbouring mirrors of the group; without mirrors, its angle is that of
        the smallest rotation. If possible it begins at the midpoint of a side of the zone, next to the x
        axis.
        """
        turns = [sign * group.turn(op)[:2, :2] for op in group.operations for sign in (1, -1)]
        mirrors = [turn for turn in turns if np.linalg.det(turn) < 0]
        order = len(np.unique(np.round(np.reshape(turns, (-1, 4)), 6) + 0.0, axis=0))
        border = [(number % 2 == 1, point) for number, point in enumerate(_border(lattice))]
        starts = [
            (is_corner, (_angle(point) + SAME) % (2 * math.pi))
            for is_corner, point in border
            if not mirrors or any(np.allclose(turn @ point, point, rtol=SAME) for turn in mirrors)
        ]
        first = min(starts)[1] - SAME
        away = [(_angle(point) - first + SAME) % (2 * math.pi) for _, point in border]
        inside = [number for number in np.argsort(away) if away[number] < 2 * math.pi / order + 2 * SAME]
        names: dict[bool, list[str]] = {False: [], True: []}  # midpoints, corners
        labelled = [("Γ", (0.0, 0.0))]
        for is_corner, point in (border[number] for number in inside):
            among, used = NAMES[lattice.name][is_corner], names[is_corner]
            used.append(among[len(used) % len(among)] + "\N{PRIME}" * (len(used) // len(among)))
            first_phase, second_phase = (_simple(phase) for phase in lattice.vectors @ point / np.pi)
            labelled.append((used[-1], (first_phase, second_phase)))
        return cls(lattice, tuple(labelled))

    @cached_property
    def corner_phases(self) -> dict[str, Array]:
        """Phases of the labelled corners, rad."""
        return {label: np.pi * np.array(point) for label, point in self.corners}

    @cached_property
    def _borders(self) -> tuple[Array, Array]:
        """(sides, 2) unit normals of the sides in the plane of phases, inwards, and (sides,) offsets."""
        corners = np.array(list(self.corner_phases.values()))
        along = np.roll(corners, -1, axis=0) - corners
        across = np.column_stack([-along[:, 1], along[:, 0]]) / np.linalg.norm(along, axis=1)[:, None]
        middle = corners.mean(axis=0)
        across *= np.sign(((middle - corners) * across).sum(axis=1))[:, None]
        return across, (corners * across).sum(axis=1)

    def depth(self, kappa: Array) -> Array:
        """(n,) distance of phases (n, 2) from the zone's border, rad; negative outside."""
        normals, offsets = self._borders
        return np.asarray((kappa @ normals.T - offsets).min(axis=1))

    def path(self, points: int, also: Sequence[float] = ()) -> Path:
        """Path of ``points`` wavevectors around the irreducible zone, with all corners and both ends.

        The number of points in a segment is proportional to its length, so the spacing is even in rad/m.

        also : positions of further wavevectors on the path, on which corners count 0, 1, 2, ...
        """
        labels = [label for label, _ in self.corners]
        corners = [self.corner_phases[label] for label in [*labels, labels[0]]]
        lengths = [float(np.linalg.norm(self.lattice.wavevector(b - a))) for a, b in pairwise(corners)]
        if points < 2 * len(lengths) + 1:
            raise GeometryError.too_few(
                argument="bands.points",
                given=points,
                allowed=f"at least {2 * len(lengths) + 1} for {len(lengths)} segments",
                cause="too few points to draw the edge of the irreducible zone",
                next_step="ask for more points",
            )
        shares = np.cumsum([0.0, *lengths]) / sum(lengths)
        marks = np.round(shares * (points - 1)).astype(int)
        for j in range(1, len(marks)):  # every segment has at least one inner point
            marks[j] = min(max(marks[j], marks[j - 1] + 2), points - 1 - 2 * (len(marks) - 1 - j))
        inner = [j + np.arange(steps) / steps for j, steps in enumerate(np.diff(marks))]
        places = np.concatenate([*inner, [len(lengths)], also])
        _, first = np.unique(np.round(places / SAME), return_index=True)
        places = places[first]
        segment = np.minimum(places.astype(int), len(lengths) - 1)
        t, ends, sizes = places - segment, np.array(corners), np.array(lengths)
        return Path(
            kappa=ends[segment] + t[:, None] * (ends[segment + 1] - ends[segment]),
            distance=np.concatenate([[0.0], np.cumsum(sizes)])[segment] + t * sizes[segment],
            corners=tuple(np.searchsorted(places, np.arange(len(lengths) + 1)).tolist()),
            labels=(*labels, labels[0]),
        )

    def triangles(self, divisions: int) -> tuple[Array, NDArray[np.int64]]:
        """Triangles that tile the irreducible zone exactly.

        Returns
        -------
        kappa : (n, 2) phases of the vertices, rad
        triangles : (m, 3) vertex numbers
        """
        corners = [self.corner_phases[label] for label, _ in self.corners]
        kappa: list[Array] = []
        number: dict[tuple[int, int, int], int] = {}
        triangles: list[tuple[int, int, int]] = []
        n = divisions
        for fan in range(1, len(corners) - 1):

            def vertex(i: int, j: int, fan: int = fan) -> int:
                # weights (n - i, i - j, j) of the fan's corners; vertices on a shared edge occur twice
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


def _border(lattice: Lattice) -> Array:
    """(2 sides, 2) midpoints of the sides of the Brillouin zone, each with the next corner behind it, rad/m.

    The zone contains the points that are nearer to the origin than to any other reciprocal lattice point.
    """
    reciprocal = 2 * np.pi * np.linalg.inv(lattice.vectors).T
    neighbours, corners = voronoi_cell(reciprocal)
    middles = 0.5 * np.array(neighbours) @ reciprocal
    return np.stack([middles, np.roll(corners, -1, axis=0)], axis=1).reshape(-1, 2)


def _angle(point: Array) -> float:
    return math.atan2(point[1], point[0])


def _simple(phase: float) -> float:
    """A phase in units of pi; a simple fraction, as in symmetric zones, is exact."""
    fraction = float(Fraction(phase).limit_denominator(12))
    return fraction if abs(fraction - phase) < SAME else float(phase)
