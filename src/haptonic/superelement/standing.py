"""Motions of a tile's boundary in standing waves, from which the Krylov space of its interior starts.

Among equal tiles, opposite sides of a tile move equally or oppositely in the waves at Gamma and at the
middles of the zone's edges. Motions of a free boundary are less suitable, because neighbours exert forces:
around a hole that nearly reaches the sides, three blocks of 33 directions of free motions left an error of
1.0e-3, three of 10 directions of standing waves 1.3e-4. Waves at middles that the mirrors of a tile exchange,
two of three for a hexagon, are in no class of these mirrors and left out.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell import TileShape
from haptonic.later import linalg as la
from haptonic.superelement.bounded import orthonormal
from haptonic.superelement.trace import FoldedTrace

SAME = 1e-6  # difference of sides, relative to the tile's extent, that count as equal
EQUAL = 1e-6  # relative difference of eigenvalues that count as equal
TIED = 1e-9  # square of the distance of places that move equally

Pairs = tuple[Ints, Ints, Ints]  # places on a side, those opposite of them, and the pair of sides


def standing_motions(tile: TileShape, trace: FoldedTrace, stiffness: Array, mass: Array, count: int) -> Array:
    """Compute the softest motions of the boundary of a class in standing waves.

    Parameters
    ----------
    stiffness, mass : (b, b) of the boundary for the static response of the interior
    count : number of motions, of which some may be alike

    Returns
    -------
    (b, n) orthonormal in the mass; of a tile without opposite sides, motions of its free boundary
    """
    values, motions = [], []
    for space in _spaces(tile, trace):
        few = min(count, space.shape[1])
        if few:
            forms = (space.T @ form @ space for form in (stiffness, mass))
            of_space, turn = la.eigh(*forms, subset_by_index=(0, few - 1))
            values.append(of_space)
            motions.append(space @ turn)
    every = np.concatenate(values)
    last = np.sort(every)[:count][-1]
    softest = every <= (1 + EQUAL) * last  # equal values are not divided: rounding determines their order
    return orthonormal(np.hstack(motions)[:, softest], mass)


def _spaces(tile: TileShape, trace: FoldedTrace) -> Iterator[Array]:
    """Yield bases (b, n) of the boundary's motions in standing waves, for each sign of the translations."""
    pairs = _opposite(tile, trace)
    if pairs is None:
        yield np.eye(len(trace.kept))
        return
    for first in (1, -1):
        for last in (1, -1):
            # of the translations across three pairs of sides, the middle one is the sum of the others
            signs = [first, last] if pairs[2].max() == 1 else [first, first * last, last]
            yield _tied(trace, pairs, np.array(signs, dtype=float))


def _opposite(tile: TileShape, trace: FoldedTrace) -> Pairs | None:
    """Places on opposite sides of a tile; None if it has no two or three pairs of such sides."""
    sides = np.roll(tile.corners, -1, axis=0) - tile.corners
    half, odd = divmod(len(sides), 2)
    if odd or half not in (2, 3) or np.abs(sides[:half] + sides[half:]).max() > SAME * tile.extent:
        return None
    along = len(trace.rim.node) // len(sides)  # places of a side, without its last one
    side, place = (grid.ravel() for grid in np.indices((half, along + 1)))
    number, total = side * along + place, 2 * half * along
    return number, (number + half * along + along - 2 * place) % total, side


def _tied(trace: FoldedTrace, pairs: Pairs, signs: Array) -> Array:
    """(b, n) basis of motions whose components on opposite sides are equal up to the signs of the pairs."""
    places, opposite, pair = pairs
    node, sign = trace.rim.node, trace.rim.sign[trace.symmetry_class].astype(float)
    motions = []
    for component in range(3):
        alive = np.flatnonzero(sign[trace.rim.origin, component])
        on_places = (node[:, None] == alive) * sign[:, component, None]
        apart = on_places[places] - signs[pair, None] * on_places[opposite]
        distance, turn = la.eigh(apart.T @ apart)
        of_component = np.zeros((trace.sites, 3, int((distance < TIED).sum())))
        of_component[alive, component] = turn[:, distance < TIED]
        motions.append(of_component.reshape(3 * trace.sites, -1))
    on_levels = np.kron(np.eye(trace.own_levels), np.hstack(motions))[trace.kept]
    return np.asarray(on_levels[:, on_levels.any(axis=0)])
