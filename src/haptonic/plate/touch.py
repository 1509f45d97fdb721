"""Vibration below a finger at any place of the flat face.

On a reduced plate with dynamic stiffness A, a finger of dynamic stiffness Z,
spread evenly over the n points of a disc that it covers, turns the displacement u of these points into
``(1 + Z/n C)^-1 u`` with their compliance ``C = S A^-1 S^T``, S being the matrix of their displacement, as
in `haptonic.plate.damping`. Only C among the points of one disc is needed, so no place of the face needs a
factorisation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy

from haptonic.arrays import Array, Bools, Complex, Ints
from haptonic.later import linalg as la
from haptonic.parallel import each
from haptonic.plate.damping import real_times
from haptonic.plate.keys import PLATE
from haptonic.plate.layout import Layout
from haptonic.plate.vibration import ReducedPlate
from haptonic.response.measures import discs

TOGETHER = 32  # number of places solved at once


@dataclass(frozen=True, eq=False)
class Sites:
    """Points of the flat face, and discs of a finger around them.

    points : (k, 2) m, as evenly spread as a grid; diameter : of the disc, m
    """

    points: Array
    diameter: float

    @property
    def discs(self) -> list[list[int]]:
        """For each point, the points below a finger there: those within its radius."""
        return discs(self.points, self.diameter)


def whole_finger_on(points: Array, inside: Bools, layout: Layout, diameter: float) -> Bools:
    """(point,) places (point, 2) of a region at which a whole finger lies on it and on the plate.

    They are all of its points if it is too small for one, or if there is no other region.

    inside : (point,) which points lie in the region
    """
    if inside.all():
        return inside
    clear = scipy.spatial.cKDTree(points[~inside]).query(points)[0] > 0.5 * diameter
    edges = np.array([layout.x[0], layout.y[0]]), np.array([layout.x[-1], layout.y[-1]])
    room = np.minimum(points - edges[0], edges[1] - points).min(axis=1) >= 0.5 * diameter
    whole = inside & clear & room
    return whole if whole.any() else inside


def below_finger(
    reduced: ReducedPlate,
    places: Sites,
    displacement: Complex,
    omega: float,
    impedances: Sequence[complex],
) -> Array:
    """Amplitude below a finger at every place: root mean square over its disc, m.

    Parameters
    ----------
    reduced : the plate without a finger
    displacement : (k,) normal to the face at all places, without a finger, m
    omega : rad/s
    impedances : (p,) dynamic stiffnesses of whole fingers, N/m: force over displacement, 0 for none

    Returns
    -------
    (p, k) m
    """
    discs = places.discs
    most = max(len(disc) for disc in discs)
    # short discs, at the plate's rim, are padded with a point at rest
    still = len(places.points)
    index = np.array([disc + [still] * (most - len(disc)) for disc in discs])
    count = np.array([len(disc) for disc in discs])
    seen = reduced.model.displaced(places.points, reduced.basis.raw) @ reduced.basis.turn
    seen = np.vstack([seen, np.zeros(seen.shape[1])])
    compliance = _Compliance(reduced, seen, omega)
    moved = np.append(displacement, 0.0)
    stiffness = np.asarray(impedances)
    amplitudes = np.empty((len(stiffness), len(index)))
    unit = np.eye(most)

    def some(start: int) -> None:
        picked = slice(start, start + TOGETHER)
        among = compliance.among(index[picked])
        for row, stiff in enumerate(stiffness):
            share = (stiff / count[picked])[:, None, None]
            left = np.linalg.solve(unit + share * among, moved[index[picked]][..., None])[..., 0]
            amplitudes[row, picked] = np.sqrt((np.abs(left) ** 2).sum(axis=1) / count[picked])

    each(some, range(0, len(index), TOGETHER))
    return amplitudes


class _Compliance:
    """Displacement per force between points of a reduced plate at one frequency."""

    def __init__(self, reduced: ReducedPlate, seen: Array, omega: float) -> None:
        line = np.array([omega])
        stiffness = reduced.model.factors[PLATE] * reduced.basis.values - omega**2
        for one in reduced.extras:
            stiffness = stiffness + one.alone[:, 0] * one.extra.impedance(line)[0]
        self.seen, self.flexible = seen, 1.0 / stiffness
        directions = np.hstack([np.zeros((len(stiffness), 0)), *(one.kept for one in reduced.extras)])
        weights = [np.full(one.kept.shape[1], one.extra.impedance(line)[0]) for one in reduced.extras]
        stiff = np.concatenate([np.zeros(0), *weights])
        self.through = real_times(seen, self.flexible[:, None] * directions)
        inner = np.diag(1.0 / stiff) + real_times(directions.T, self.flexible[:, None] * directions)
        self.inner = la.inv(inner) if len(inner) else inner

    def among(self, points: Ints) -> Complex:
        """(m, n, n) compliance among each of m sets of n points, given by their numbers (m, n)."""
        near, through = self.seen[points], self.through[points]
        transposed = near.transpose(0, 2, 1)
        real = (near * self.flexible.real) @ transposed
        imaginary = (near * self.flexible.imag) @ transposed
        own = real + 1j * imaginary
        return np.asarray(own - through @ self.inner @ through.transpose(0, 2, 1))
