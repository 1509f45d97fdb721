"""Choice of the ends of blocks at the joints of an outline, and their places between two joints."""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array, Bools, Ints
from haptonic.cell.outlines import Outline

SAME = 1e-6  # of a radius: closer places coincide
TIE, SAME_COST = 1e-6, 1e-12  # relative to the square of a shift
SHORT = 1e-6  # of a piece: shortly before its end
FARTHEST = 1.2  # largest shift of a block's end from its even position to a joint, in even spacings


def ends_at_joints(
    outline: Outline,
    beyond: float,
    even: Array,
    rim: Array,
    blocks: int,
    operations: list[Array],
    thin_at: Ints,
) -> Ints | None:
    """(joints,) number of the block's end for each joint, counted on over a whole turn; None without any.

    They keep the order and have the least squares of shifts. A joint on the axis of a mirror has an end on
    it, and no other joint has one. The line from a joint to the end at the tile's side leaves the outline.

    Parameters
    ----------
    outline, beyond : its scaled copy at the half-width ``beyond`` must not be crossed
    even : (ends + 1,) even directions of the ends, rad; rim : (ends, 2) the ends, in half-widths
    blocks : for each side of the tile
    operations : rotations and mirrors that the ends must keep
    thin_at : (joints,) number of thin blocks on either side of each joint
    """
    count, joints = len(even) - 1, outline.joints
    low, high = thin_on_pieces(outline, thin_at)
    least = 1 + low + high
    if least.sum() > count:
        return None
    place = outline.at(np.arange(joints, dtype=float))
    angle = np.unwrap(np.arctan2(place[:, 1], place[:, 0]))
    if np.ptp(angle) >= 2 * np.pi:
        return None
    gap = 2 * np.pi / count
    mirrors = [turn for turn in operations if np.linalg.det(turn) < 0]
    on_joint = np.array([_on_axis(place, turn) for turn in mirrors]).reshape(-1, joints)
    on_end = np.array([_on_axis(rim, turn) for turn in mirrors]).reshape(-1, count)
    leaving = _leaving(outline, beyond * place, rim)
    mirrored, is_even = _mirrored(place, rim, mirrors)
    least = least + mirrored * ((least + ~is_even) % 2)
    best: tuple[float, list[int]] | None = None
    first = int(np.argmin(np.abs(np.angle(np.exp(1j * (even[:-1] - angle[0]))))))
    turns = round(float(angle[0] - even[first]) / (2 * np.pi))
    for start in range(first - 2, first + 3):
        number = np.arange(start, start + count)
        direction = even[number % count] + 2 * np.pi * (number // count + turns)
        shift = (direction - angle[:, None]) / gap
        # of two equally near ends, the one nearer to a corner of the tile, so that all images agree
        cost = shift**2 + TIE * np.minimum(number % blocks, -number % blocks)
        cost[(np.abs(shift) > FARTHEST) | ~leaving[:, number % count]] = np.inf
        cost[(on_joint[:, :, None] != on_end[:, None, number % count]).any(axis=0)] = np.inf
        cost[0, 1:] = np.inf
        cost[-1, count - least[-1] + 1 :] = np.inf
        cheapest = _cheapest(cost, least, 1 + mirrored)
        if cheapest is not None and (best is None or cheapest[0] < best[0] - SAME_COST):
            best = cheapest[0], [int(number[k]) for k in cheapest[1]]
    return None if best is None else np.array(best[1])


def _on_axis(points: Array, turn: Array) -> Array:
    return np.asarray(np.linalg.norm(points @ turn.T - points, axis=1) < SAME)


def _leaving(outline: Outline, place: Array, rim: Array) -> Bools:
    """(joints, ends) True if the line from a joint to an end at the tile's side lies outside the outline."""
    joint = np.arange(outline.joints, dtype=float)
    away = rim - place[:, None]
    slopes = outline.slope(joint), outline.slope((joint - SHORT) % outline.period)
    turns = [away[..., 0] * slope[:, None, 1] - away[..., 1] * slope[:, None, 0] for slope in slopes]
    return np.asarray((turns[0] > 0) & (turns[1] > 0))


def _mirrored(place: Array, rim: Array, mirrors: list[Array]) -> tuple[Bools, Bools]:
    """(joints,) True for pieces that a mirror maps to themselves; those with an even number of blocks.

    The number of blocks on such a piece is odd unless an end at the tile's side is on the mirror's axis.
    """
    following = np.roll(place, -1, axis=0)
    mirrored, is_even = np.zeros(len(place), dtype=bool), np.zeros(len(place), dtype=bool)
    for turn in mirrors:
        pieces = np.linalg.norm(place @ turn.T - following, axis=1) < SAME
        mirrored |= pieces
        is_even |= pieces & ((place + following) @ rim[_on_axis(rim, turn)].T > 0).any(axis=1)
    return mirrored, is_even


def _cheapest(cost: Array, least: Ints, steps: Ints) -> tuple[float, list[int]] | None:
    """Increasing columns, one for each row, with the least sum of costs; None if all are infinite.

    least : (rows,) smallest distance of each row's column to that of the next row
    steps : (rows,) of these distances, which are the least one and any number of steps
    """
    rows, columns = cost.shape
    total = np.full((rows, columns), np.inf)
    total[0] = cost[0]
    came = np.zeros((rows, columns), dtype=int)
    for row in range(1, rows):
        gap = int(least[row - 1])
        before = np.concatenate([np.full(gap, np.inf), total[row - 1, :-gap]])
        for start in range(steps[row - 1]):
            every = np.s_[start :: steps[row - 1]]
            lowest = np.minimum.accumulate(before[every])
            reached = np.where(before[every] == lowest, np.arange(columns)[every] - gap, 0)
            came[row, every] = np.maximum.accumulate(reached)
            total[row, every] = cost[row, every] + lowest
    last = int(np.argmin(total[-1]))
    if not np.isfinite(total[-1, last]):
        return None
    path = [last]
    for row in range(rows - 1, 0, -1):
        path.append(int(came[row, path[-1]]))
    return float(total[-1, last]), path[::-1]


def thin_on_pieces(outline: Outline, thin_at: Ints) -> tuple[Ints, Ints]:
    """(joints,) number of thin blocks at the first and at the last end of each piece; an arc has none."""
    return thin_at * outline.is_side, np.roll(thin_at, -1) * outline.is_side


def parameters_of_ends(outline: Outline, ends: Ints, count: int, thin_at: Ints) -> Array:
    """(count + 1,) parameters of all ends from those (joints,) at joints: even between two of them.

    thin_at : (joints,) number of thin blocks on either side of each joint
    """
    joints, fixed = outline.joints, np.append(ends, ends[0] + count)
    whole = outline.at(np.arange(joints + 1, dtype=float))
    length = np.linalg.norm(np.diff(whole, axis=0), axis=1)
    reach = outline.beside_corners(int(thin_at.max(initial=0)))
    place = []
    for piece, (blocks, low, high) in enumerate(
        zip(np.diff(fixed), *thin_on_pieces(outline, thin_at), strict=True)
    ):
        near, other = (reach[:thin] / length[piece] for thin in (low, high))
        start, stop = near.max(initial=0.0), 1 - other.max(initial=0.0)
        between = np.linspace(start, stop, blocks - low - high + 1)
        borders = np.concatenate([[0.0] * bool(low), near[:0:-1], between, 1 - other[1:]])
        place.append(piece + borders[:blocks])
    number, place_of = np.arange(count + 1) - fixed[0], np.concatenate(place)
    return np.asarray(place_of[number % count] + joints * (number // count))
