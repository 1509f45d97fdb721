"""Ends of the blocks of a mesh around a pillar, seen from above.

Blocks lead from the pillar to the sides of its tile. At the sides they end at equal parts; at the pillar they
have to end at the joints of its outline, so that every element has one smooth side. `least_blocks` finds the
smallest number of blocks for each side with a block's end near each joint, in an order that keeps every
symmetry of the tile, and with no element inside out.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell.outlines import CIRCLE, Outline, Scaled
from haptonic.cell.stack import Stack
from haptonic.cell.tile import TileShape, room_in

MOST_BLOCKS = 8  # for each side
SAME = 1e-6  # of a radius: closer places coincide
FARTHEST = 1.2  # largest shift of a block's end from its even position to a joint, in even spacings
RINGS = 0.4  # of the clearance, largest share of the rings about a pillar
CORE_BULGE = 0.45  # edges of the core: 0 for chords, 1 for arcs
TIE, SAME_COST = 1e-6, 1e-12  # relative to the square of a shift
SHARES = np.array([0.0, 0.25, 0.5, 0.75, 1.0])  # of a block, positions of the check of elements
# rotations and mirrors by which meshes are folded, see `superelement.symmetry`
OPERATIONS = tuple(
    np.array(op)
    for op in (
        ((-1.0, 0.0), (0.0, 1.0)),
        ((1.0, 0.0), (0.0, -1.0)),
        ((-1.0, 0.0), (0.0, -1.0)),
        ((0.0, 1.0), (1.0, 0.0)),
        ((-0.5, -math.sqrt(0.75)), (math.sqrt(0.75), -0.5)),
    )
)


def corner_angles(tile: TileShape) -> Array:
    """(sides + 1,) directions of the corners, the first one repeated; even quarters for a rectangle."""
    corners = np.sign(tile.corners) if tile.is_upright else tile.corners
    angles = np.unwrap(np.arctan2(corners[:, 1], corners[:, 0]))
    return np.append(angles, angles[0] + 2 * np.pi)


@dataclass(frozen=True, eq=False)
class Sectors:
    """Ends of the blocks around a pillar.

    outline : outline of the pillar
    place : (all blocks + 1,) parameters on it, increasing by its period
    blocks : number of blocks for each side of the tile
    """

    outline: Outline
    place: Array
    blocks: int

    @property
    def sides(self) -> int:
        """Number of sides of the tile."""
        return (len(self.place) - 1) // self.blocks

    @property
    def is_aligned(self) -> bool:
        """True if the outline has its corners in the directions of the tile's; so may the core."""
        place = self.place[:: self.blocks]
        return self.sides == self.outline.joints and bool(np.array_equal(place, np.round(place)))

    def points(self, share: Array) -> Array:
        """(blocks n, 2) points of the curve at shares (n,) of every block."""
        start, step = self.place[:-1, None], np.diff(self.place)[:, None]
        return self.outline.at((start + share * step).ravel())

    def core(self, share: Array) -> Array:
        """(blocks n, 2) points of the outline of the mesh's core, for a half-width of 1.

        It lies between chords of a curve and the curve itself. The curve is smooth unless its corners are
        those of the outline: the core would fold with a corner where a patch has none, or none where it has
        one.
        """
        curve = self.points(share)
        if self.outline.joints and not self.is_aligned:
            ends = self.points(np.zeros(1))
            angle = np.unwrap(np.arctan2(ends[:, 1], ends[:, 0]))
            step = np.diff(np.append(angle, angle[0] + 2 * np.pi))
            between = (angle[:, None] + share * step[:, None]).ravel()
            curve = np.stack([np.cos(between), np.sin(between)], axis=-1)
        along = ((np.arange(self.blocks)[:, None] + share) / self.blocks).ravel()
        return CORE_BULGE * curve + (1 - CORE_BULGE) * along_sides(curve[:: len(along)], along)


def sectors(tile: TileShape, blocks: int) -> tuple[Sectors, ...]:
    """Sectors of each border of a tile with ``blocks`` blocks for each side, see `least_blocks`."""
    suited = [_sectors(seen, blocks) for seen in _Seen.of(tile.above)]
    return tuple(around for around in suited if around is not None)


def least_blocks(tile: TileShape, blocks: int) -> int | None:
    """Smallest multiple of a number of blocks for each side that suits all borders; None if there is none."""
    borders, most = _Seen.of(tile.above), max(MOST_BLOCKS, blocks)
    widths = _widths(tile)
    suited = (n for n in range(blocks, most + 1, blocks) if _suit(tuple(borders), widths, n))
    return next(suited, None)


def _widths(tile: TileShape) -> tuple[tuple[float, ...], ...]:
    """Half-widths of the borders of a stack on each level where they bend, rounded, m; none for others."""
    if not isinstance(tile.above.feature, Stack):
        return ()
    widths = np.unique(np.round(tile.above.feature.widths.T, 12), axis=0)
    return tuple(tuple(level) for level in widths.tolist())


@lru_cache(maxsize=256)
def _suit(borders: tuple[_Seen, ...], widths: tuple[tuple[float, ...], ...], blocks: int) -> bool:
    """True if a number of blocks suits all borders, and the rings between them are sound on every level."""
    around = [_sectors(seen, blocks) for seen in borders]
    if None in around:
        return False
    curves = [part.points(SHARES).reshape(-1, len(SHARES), 2) for part in around if part is not None]
    return all(
        _is_ring_sound(low * inner, high * outer)
        for level in widths
        for (low, high), (inner, outer) in zip(pairwise(level), pairwise(curves), strict=True)
    )


def unmeshed(tile: TileShape) -> dict[str, str] | None:
    """Parts of the error for a feature that no blocks suit; None if it can be meshed."""
    if tile.feature is None or least_blocks(tile, 1 if len(tile.corners) == 4 else 2) is not None:
        return None
    return {
        "given": f"a section that is {tile.feature.section}",
        "allowed": f"a section whose corners the ends of {MOST_BLOCKS} blocks to each side of the tile reach",
        "cause": "the section is long and turned, or has many corners, and its tile leaves little room",
        "next_step": "make it smaller or rounder, turn it along the lattice, or enlarge the pitch",
    }


@dataclass(frozen=True)
class _Seen:
    """Input for the choice of blocks: the outline, the polygon around it in half-widths, and the symmetry.

    angles : of `corner_angles`
    beyond : half-width of the last ring, which is a scaled copy of the outline
    operations : indices in `OPERATIONS` of those that leave the tile unchanged
    """

    outline: Outline
    corners: tuple[tuple[float, float], ...]
    angles: tuple[float, ...]
    beyond: float
    operations: tuple[int, ...]

    @classmethod
    def of(cls, tile: TileShape) -> list[_Seen]:
        """Inputs for each border of the feature about the axis; for a circle if there is none."""
        borders = tile.feature.borders if tile.feature else (Scaled(CIRCLE, 0.6 * tile.inradius),)
        operations = []
        if any(border.outline.joints for border in borders):
            for number, turn in enumerate(OPERATIONS):
                space = np.eye(3)
                space[:2, :2] = turn
                if tile.has_symmetry(space):
                    operations.append(number)
        seen = []
        for border in borders:
            width = border.half_width
            corners = np.round(tile.corners / width, 12)
            clearance = room_in(tile.corners, border.outline) - width
            seen.append(
                cls(
                    outline=border.outline,
                    corners=tuple((float(x), float(y)) for x, y in corners),
                    angles=tuple(float(angle) for angle in corner_angles(tile)),
                    beyond=round(1 + RINGS * max(clearance, 0.0) / width, 12),
                    operations=tuple(operations) if border.outline.joints else (),
                )
            )
        return seen


@lru_cache(maxsize=256)
def _sectors(seen: _Seen, blocks: int) -> Sectors | None:
    """Sectors of ``blocks`` blocks, computed directly or by subdivision of fewer blocks that suit."""
    around = _of_blocks(seen, blocks)
    for fewer in range(blocks // 2, 0, -1):
        if around is None and not blocks % fewer and (coarse := _of_blocks(seen, fewer)) is not None:
            number = np.arange(len(seen.corners) * blocks + 1) / (blocks // fewer)
            place = np.interp(number, np.arange(len(coarse.place)), coarse.place)
            around = Sectors(seen.outline, place, blocks)
    return around


def _of_blocks(seen: _Seen, blocks: int) -> Sectors | None:
    outline, corner = seen.outline, np.array(seen.angles)
    share = np.arange(blocks) / blocks
    even = np.append((corner[:-1, None] + share * np.diff(corner)[:, None]).ravel(), corner[-1])
    if not outline.joints:
        return Sectors(outline, even, blocks)
    rim = _along(np.array(seen.corners), blocks)[..., 0, :].reshape(-1, 2)
    operations = _group(seen.operations)
    ends = _ends(outline, even, blocks, rim, operations)
    if ends is None:
        return None
    around = Sectors(outline, _filled(outline.joints, ends, len(even) - 1), blocks)
    sound = _keeps(around, rim, operations) and _is_sound(around, seen)
    return around if sound else None


@lru_cache(maxsize=32)
def _group(numbers: tuple[int, ...]) -> list[Array]:
    """Group of rotations and mirrors generated by some of `OPERATIONS`."""
    group = [np.eye(2)]
    for turn in group:  # the list grows in the loop
        for number in numbers:
            product = OPERATIONS[number] @ turn
            if not any(np.abs(product - other).max() < SAME for other in group):
                group.append(product)
    return group


def _ends(outline: Outline, even: Array, blocks: int, rim: Array, operations: list[Array]) -> Ints | None:
    """(joints,) number of the block's end for each joint, counted on over a whole turn; None without any.

    They keep the order and have the least squares of shifts. A joint on the axis of a mirror has an end on
    it, and no other joint has one.
    """
    count, joints = len(even) - 1, outline.joints
    if joints > count:
        return None
    place = outline.at(np.arange(joints, dtype=float))
    angle = np.unwrap(np.arctan2(place[:, 1], place[:, 0]))
    if np.ptp(angle) >= 2 * np.pi:
        return None
    gap = 2 * np.pi / count
    mirrors = [turn for turn in operations if np.linalg.det(turn) < 0]
    on_joint = np.array([_on_axis(place, turn) for turn in mirrors]).reshape(-1, joints)
    on_end = np.array([_on_axis(rim, turn) for turn in mirrors]).reshape(-1, count)
    best: tuple[float, list[int]] | None = None
    first = int(np.argmin(np.abs(np.angle(np.exp(1j * (even[:-1] - angle[0]))))))
    turns = round(float(angle[0] - even[first]) / (2 * np.pi))
    for start in range(first - 2, first + 3):
        number = np.arange(start, start + count)
        direction = even[number % count] + 2 * np.pi * (number // count + turns)
        shift = (direction - angle[:, None]) / gap
        # of two equally near ends, the one nearer to a corner of the tile, so that all images agree
        cost = shift**2 + TIE * np.minimum(number % blocks, -number % blocks)
        cost[np.abs(shift) > FARTHEST] = np.inf
        cost[(on_joint[:, :, None] != on_end[:, None, number % count]).any(axis=0)] = np.inf
        cost[0, 1:] = np.inf
        cheapest = _cheapest(cost)
        if cheapest is not None and (best is None or cheapest[0] < best[0] - SAME_COST):
            best = cheapest[0], [int(number[k]) for k in cheapest[1]]
    return None if best is None else np.array(best[1])


def _on_axis(points: Array, turn: Array) -> Array:
    return np.asarray(np.linalg.norm(points @ turn.T - points, axis=1) < SAME)


def _cheapest(cost: Array) -> tuple[float, list[int]] | None:
    """Increasing columns, one for each row, with the least sum of costs; None if all are infinite."""
    rows, columns = cost.shape
    total = np.full((rows, columns), np.inf)
    total[0] = cost[0]
    came = np.zeros((rows, columns), dtype=int)
    for row in range(1, rows):
        before = np.concatenate([[np.inf], total[row - 1, :-1]])
        least = np.minimum.accumulate(before)
        reached = np.where(before == least, np.arange(columns) - 1, 0)
        came[row] = np.maximum.accumulate(np.where(before <= least, reached, 0))
        total[row] = cost[row] + least
    last = int(np.argmin(total[-1]))
    if not np.isfinite(total[-1, last]):
        return None
    path = [last]
    for row in range(rows - 1, 0, -1):
        path.append(int(came[row, path[-1]]))
    return float(total[-1, last]), path[::-1]


def _filled(joints: int, ends: Ints, count: int) -> Array:
    """(count + 1,) parameters of all ends from those (joints,) at joints: even between two of them."""
    fixed, place = np.append(ends, ends[0] + count), np.arange(joints + 1, dtype=float)
    number = np.arange(count + 1)
    below = number < fixed[0]
    place_of = np.interp(number + count * below, fixed, place) - joints * below
    beyond = number > fixed[-1]
    place_of[beyond] = np.interp(number[beyond] - count, fixed, place) + joints
    return np.asarray(place_of)


def _keeps(around: Sectors, rim: Array, operations: list[Array]) -> bool:
    """True if every operation maps the ends at the pillar like those at the tile's sides."""
    ends = around.points(np.zeros(1))
    for turn in operations:
        apart = np.linalg.norm((rim @ turn.T)[:, None] - rim, axis=2)
        if np.abs(ends @ turn.T - ends[apart.argmin(axis=1)]).max() > SAME:
            return False
    return True


def _is_sound(around: Sectors, seen: _Seen) -> bool:
    """True if no element is inside out."""
    inner, outer = seen.beyond * around.points(SHARES), _along(np.array(seen.corners), around.blocks)
    inner, outer = inner.reshape(-1, len(SHARES), 2), outer.reshape(-1, len(SHARES), 2)
    return _is_ring_sound(inner, outer) and _is_core_sound(around)


def _is_ring_sound(inner: Array, outer: Array) -> bool:
    """True if no element between two curves (blocks, shares, 2) around the axis is inside out."""
    for part in (0.0, 0.5, 1.0):
        curve = (1 - part) * inner + part * outer
        along, across = np.gradient(curve, axis=1), outer - inner
        if (across[..., 0] * along[..., 1] - across[..., 1] * along[..., 0]).min() <= 0:
            return False
    return True


def _is_core_sound(around: Sectors) -> bool:
    """True if no element of the core is inside out; see `cell.topology` for its patches."""
    core = around.core(SHARES[:-1])
    side, half = len(core) // around.sides, len(core) // around.sides // 2
    patches = []
    if around.sides == 4:
        loop = np.concatenate([core, core[:1]])
        low, right, high, left = (loop[n * side : (n + 1) * side + 1] for n in range(4))
        patches.append((low, right, high[::-1], left[::-1]))
    else:
        share = np.arange(half + 1)[:, None] / half
        for corner in range(0, len(core), side):
            beside = np.take(core, corner + np.arange(-half, half + 1), axis=0, mode="wrap")
            straight = (share * beside[0], share * beside[-1])
            patches.append((straight[0], beside[: half + 1], beside[half:][::-1], straight[1]))
    return all(_turns(_coons(*edges)).min() > 0 for edges in patches)


def _coons(low: Array, right: Array, high: Array, left: Array) -> Array:
    """(n, n, 2) grid within four edges (n, 2), with the first index along the low and the high edge."""
    n = len(low)
    grid = np.empty((n, n, 2))
    grid[:, 0], grid[:, -1], grid[0], grid[-1] = low, high, left, right
    return transfinite(grid, np.linspace(0.0, 1.0, n))


def _turns(grid: Array) -> Array:
    """Areas of the triangles at the corners of the small quadrilaterals of a grid."""
    along, across = np.diff(grid, axis=0), np.diff(grid, axis=1)
    return np.stack([
        along[:, a:b, 0] * across[c:d, :, 1] - along[:, a:b, 1] * across[c:d, :, 0]
        for a, b in ((0, -1), (1, None)) for c, d in ((0, -1), (1, None))
    ])  # fmt: skip


def transfinite(square: Array, share: Array) -> Array:
    """Fill a grid (n, n, 2) from its four edges (Gordon and Hall's blending)."""
    s, t = share[:, None, None], share[None, :, None]
    left, right, low, high = square[:1], square[-1:], square[:, :1], square[:, -1:]
    edges = (1 - s) * left + s * right + (1 - t) * low + t * high
    corners = (
        (1 - s) * (1 - t) * square[0, 0]
        + s * (1 - t) * square[-1, 0]
        + (1 - s) * t * square[0, -1]
        + s * t * square[-1, -1]
    )
    return np.asarray(edges - corners)


def along_sides(corners: Array, share: Array) -> Array:
    """Points on the sides of a polygon, each side from its first corner."""
    sides = np.roll(corners, -1, axis=0) - corners
    return np.asarray((corners[:, None] + share[:, None] * sides[:, None]).reshape(-1, 2))


def _along(corners: Array, blocks: int) -> Array:
    """(sides blocks, shares, 2) points of the tile's sides."""
    share = (np.arange(blocks)[:, None] + SHARES) / blocks
    step = np.roll(corners, -1, axis=0) - corners
    return np.asarray(corners[:, None, None] + share[..., None] * step[:, None, None])
