"""Even grid on the flat face of a period, for views that move."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product
from typing import Self

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.superelement import Tiling

STEPS = 16  # of the grid along a period; a guided wave has a few per wavelength at the end of the zone
EDGE = 1e-9  # share by which a point may lie outside a triangle due to rounding


@dataclass(frozen=True)
class FlatFace:
    """Flat face of a tiling, in axes turned by ``turn`` (2, 2).

    nodes : (n,) on the face; position : (n, 2) m; triangles : (t, 3)
    """

    tiling: Tiling
    turn: Array
    nodes: Ints
    position: Array
    triangles: Ints

    @classmethod
    def of(cls, tiling: Tiling, turn: Array) -> Self:
        """Find the face."""
        points = tiling.points
        faces = tiling.linear_subcells()[:, :4]
        faces = faces[(np.abs(points[faces, 2]) < EDGE * np.ptp(points)).all(axis=1)]
        nodes, corners = np.unique(faces, return_inverse=True)
        corners = corners.reshape(-1, 4)
        triangles = np.concatenate([corners[:, :3], corners[:, [0, 2, 3]]])
        return cls(
            tiling=tiling, turn=turn, nodes=nodes, position=points[nodes, :2] @ turn.T, triangles=triangles
        )

    def motion(self, unknowns: Complex) -> Complex:
        """(n, 3, k) displacement along the turned axes and normal, from unknowns (u, k) of the tiling."""
        motion = self.tiling.lifted(unknowns)[self.nodes]
        motion[:, :2] = np.einsum("xy,nyk->nxk", self.turn, motion[:, :2])
        return np.asarray(motion)


def strongest(motion: Complex) -> tuple[Complex, Ints]:
    """(n, k) component with the largest norm of motions (n, 3, k), largest 1, and its number (k,)."""
    number = np.linalg.norm(motion, axis=0).argmax(axis=0)
    chosen = np.take_along_axis(motion, number[None, None], axis=1)[:, 0]
    place = np.abs(chosen).argmax(axis=0)
    return chosen / np.take_along_axis(chosen, place[None], axis=0), number


@dataclass(frozen=True)
class FaceGrid:
    """Grid over a face that continues by translations, with linear interpolation from the nodes of a period.

    across, along : positions of the grid, m
    nodes, weights : (g, 3) corners of the triangle around each of g points, and their weights; 0 outside
    shift : (g, t) translations from the point to this triangle
    """

    across: Array
    along: Array
    nodes: Ints
    weights: Array
    shift: Ints

    @classmethod
    def of_strip(cls, position: Array, triangles: Ints, period: float) -> Self:
        """Make the grid of one period of a strip, which runs along the second axis."""
        start, stop = position[:, 0].min(), position[:, 0].max()
        across = middles(start, stop - start, max(2, round((stop - start) / period * STEPS)))
        along = middles(position[:, 1].min(), period, STEPS)
        return cls.of(across, along, position, triangles, np.array([[0.0, period]]))

    @classmethod
    def of(cls, across: Array, along: Array, position: Array, triangles: Ints, vectors: Array) -> Self:
        """Make the grid at given positions.

        Parameters
        ----------
        position : (n, 2) of the nodes of a period, across and along, m; triangles : (m, 3)
        vectors : (t, 2) translations to the other periods, m
        """
        points = np.stack(np.meshgrid(across, along, indexing="ij"), axis=-1).reshape(-1, 2)
        nodes = np.zeros((len(points), 3), dtype=np.int64)
        weights, shift = np.zeros((len(points), 3)), np.zeros((len(points), len(vectors)), dtype=np.int64)
        margin = EDGE * np.ptp(position)
        corners = position[triangles]
        lows, highs = corners.min(axis=1) - margin, corners.max(axis=1) + margin
        inverses = np.linalg.inv(np.moveaxis(corners[:, 1:] - corners[:, :1], 1, 2))
        for steps in product(*(range(-far, far + 1) for far in farthest(points, position, vectors))):
            moved = points + np.array(steps) @ vectors
            beside = ((moved >= lows.min(axis=0)) & (moved <= highs.max(axis=0))).all(axis=1)
            chosen = np.flatnonzero(beside & ~weights.any(axis=1))
            if not len(chosen):
                continue
            there = moved[chosen]
            meets = (lows <= there.max(axis=0)) & (highs >= there.min(axis=0))
            for number in np.flatnonzero(meets.all(axis=1)):
                near = ((there >= lows[number]) & (there <= highs[number])).all(axis=1)
                two = (there[near] - corners[number, 0]) @ inverses[number].T
                shares = np.column_stack([1 - two.sum(axis=1), two])
                within = (shares >= -EDGE).all(axis=1)
                inside = chosen[near][within]
                nodes[inside], shift[inside], weights[inside] = triangles[number], steps, shares[within]
        return cls(across=across, along=along, nodes=nodes, weights=weights, shift=shift)

    @property
    def present(self) -> Ints:
        """(across, along) 1 where the face is, otherwise 0."""
        return self.weights.any(axis=1).reshape(len(self.across), -1).astype(np.int8)

    def values(self, field: Complex, exponents: Complex) -> Complex:
        """(k, across, along) values of fields (n, k) that each translation multiplies by exp(exponents).

        exponents : (t,) or (t, k)
        """
        there = np.einsum("gc,gck->gk", self.weights, field[self.nodes])
        there = there * np.exp(-self.shift @ np.asarray(exponents).reshape(self.shift.shape[1], -1))
        return np.moveaxis(there.reshape(len(self.across), len(self.along), -1), -1, 0)


def farthest(points: Array, position: Array, vectors: Array) -> Ints:
    """(t,) most translations along each vector from any point to a place of the period, which may lean."""
    lows, highs = position.min(axis=0) - points.max(axis=0), position.max(axis=0) - points.min(axis=0)
    steps = np.array(list(product(*zip(lows, highs, strict=True)))) @ np.linalg.pinv(vectors)
    return np.asarray(np.ceil(np.abs(steps).max(axis=0) - EDGE).astype(int))


def middles(start: float, length: float, count: int) -> Array:
    """(count,) middles of equal parts of a length from a start."""
    return np.asarray(start + (np.arange(count) + 0.5) * length / count)
