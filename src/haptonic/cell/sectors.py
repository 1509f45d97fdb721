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

from haptonic.arrays import Array
from haptonic.cell.block_ends import SAME, ends_at_joints, parameters_of_ends
from haptonic.cell.outlines import CIRCLE, Outline, Scaled
from haptonic.cell.stack import Stack
from haptonic.cell.tile import TileShape, room_in

MOST_BLOCKS, MOST_AROUND_DISCS = 8, 12  # for each side
RINGS = 0.4  # of the clearance, largest share of the rings about a pillar
CORE_BULGE = 0.45  # edges of the core: 0 for chords, 1 for arcs
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


def sectors(tile: TileShape, blocks: int, thin: int) -> tuple[Sectors, ...]:
    """Sectors of each border of a tile with ``blocks`` blocks for each side, see `least_blocks`."""
    borders = tuple(_Seen.of(tile.above))
    for fewer in range(thin, -1, -1):
        if (around := _suited(borders, _widths(tile), blocks, fewer)) is not None:
            return around
    return ()


def least_blocks(tile: TileShape, blocks: int, thin: int) -> int | None:
    """Smallest multiple of a number of blocks for each side that suits all borders; None without any.

    thin : number of thin blocks on either side of a corner with singular stress; fewer if they do not fit
    """
    borders, most = tuple(_Seen.of(tile.above)), max(_most_blocks(tile), blocks)
    choices = ((fewer, n) for fewer in range(thin, -1, -1) for n in range(blocks, most + 1, blocks))
    return next((n for fewer, n in choices if _suited(borders, _widths(tile), n, fewer) is not None), None)


def _most_blocks(tile: TileShape) -> int:
    return MOST_AROUND_DISCS if tile.stack else MOST_BLOCKS


def _widths(tile: TileShape) -> tuple[tuple[float, ...], ...]:
    """Half-widths of the borders of a stack on each level where they bend, rounded, m; none for others."""
    if not isinstance(tile.above.feature, Stack):
        return ()
    widths = np.unique(np.round(tile.above.feature.widths.T, 12), axis=0)
    return tuple(tuple(level) for level in widths.tolist())


@lru_cache(maxsize=256)
def _suited(
    borders: tuple[_Seen, ...], widths: tuple[tuple[float, ...], ...], blocks: int, thin: int
) -> tuple[Sectors, ...] | None:
    """Sectors of all borders with sound rings between them on every level; None if the blocks do not suit."""
    suited = [_sectors(seen, blocks, thin) for seen in borders]
    around = tuple(part for part in suited if part is not None)
    if len(around) < len(suited):
        return None
    curves = [part.points(SHARES).reshape(-1, len(SHARES), 2) for part in around]
    sound = all(
        _is_ring_sound(low * inner, high * outer)
        for level in widths
        for (low, high), (inner, outer) in zip(pairwise(level), pairwise(curves), strict=True)
    )
    return around if sound else None


def unmeshed(tile: TileShape) -> dict[str, str] | None:
    """Parts of the error for a feature that no blocks suit; None if it can be meshed."""
    if tile.feature is None or least_blocks(tile, 1 if len(tile.corners) == 4 else 2, 0) is not None:
        return None
    most = _most_blocks(tile)
    return {
        "given": f"a section that is {tile.feature.section}",
        "allowed": f"a section whose corners the ends of {most} blocks to each side of the tile reach",
        "cause": "the section is long and turned, or has many corners, and its tile leaves little room",
        "next_step": "make it smaller or rounder, turn it along the lattice, or enlarge the pitch",
    }


@dataclass(frozen=True)
class _Seen:
    """Input for the choice of blocks: the outline, the polygon around it in half-widths, and the symmetry.

    angles : of `corner_angles`
    beyond : half-width of the last ring that is a scaled copy of the outline
    operations : indices in `OPERATIONS` of those that leave sides and borders unchanged
    singular : True for the joints of the outline along which stress is singular
    """

    outline: Outline
    corners: tuple[tuple[float, float], ...]
    angles: tuple[float, ...]
    beyond: float
    operations: tuple[int, ...]
    singular: tuple[bool, ...]

    @classmethod
    def of(cls, tile: TileShape) -> list[_Seen]:
        """Inputs for each border of the feature about the axis; for a circle if there is none."""
        borders = tile.feature.borders if tile.feature else (Scaled(CIRCLE, 0.6 * tile.inradius),)
        operations = []
        if any(border.outline.joints for border in borders):
            for number, turn in enumerate(OPERATIONS):
                space = np.eye(3)
                space[:2, :2] = turn
                keeps_borders = all(border.outline.has_symmetry(turn) for border in borders)
                if keeps_borders and tile.moved_sides(space) is not None:
                    operations.append(number)
        seen = []
        smooth = [(False,) * border.outline.joints for border in borders]
        singular = tile.stack.singular_corners if tile.stack else smooth
        for border, corners_of_border in zip(borders, singular, strict=True):
            width = border.half_width
            corners = np.round(tile.corners / width, 12)
            clearance = room_in(tile.corners, border.outline) - width
            seen.append(
                cls(
                    outline=border.outline,
                    corners=tuple((float(x), float(y)) for x, y in corners),
                    angles=tuple(float(angle) for angle in corner_angles(tile)),
                    beyond=round(1 + RINGS * border.outline.is_convex * max(clearance, 0.0) / width, 12),
                    operations=tuple(operations) if border.outline.joints else (),
                    singular=corners_of_border,
                )
            )
        return seen


@lru_cache(maxsize=256)
def _sectors(seen: _Seen, blocks: int, thin: int) -> Sectors | None:
    """Sectors of ``blocks`` blocks, computed directly or by subdivision of fewer blocks that suit."""
    around = _of_blocks(seen, blocks, thin)
    for fewer in range(blocks // 2, 0, -1):
        if around is None and not blocks % fewer and (coarse := _of_blocks(seen, fewer, thin)) is not None:
            number = np.arange(len(seen.corners) * blocks + 1) / (blocks // fewer)
            place = np.interp(number, np.arange(len(coarse.place)), coarse.place)
            around = Sectors(seen.outline, place, blocks)
    return around


def _of_blocks(seen: _Seen, blocks: int, thin: int) -> Sectors | None:
    outline, corner = seen.outline, np.array(seen.angles)
    share = np.arange(blocks) / blocks
    even = np.append((corner[:-1, None] + share * np.diff(corner)[:, None]).ravel(), corner[-1])
    if not outline.joints:
        return Sectors(outline, even, blocks)
    rim = _along(np.array(seen.corners), blocks)[..., 0, :].reshape(-1, 2)
    operations = _group(seen.operations)
    thin_at = len(outline.beside_corners(thin)) * np.array(seen.singular, dtype=int)
    ends = ends_at_joints(outline, seen.beyond, even, rim, blocks, operations, thin_at)
    if ends is None:
        return None
    around = Sectors(outline, parameters_of_ends(outline, ends, len(even) - 1, thin_at), blocks)
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
    return np.asarray((corners[:, None] + share[:, None] * sides[:, None]).reshape(-1, corners.shape[1]))


def _along(corners: Array, blocks: int) -> Array:
    """(sides blocks, shares, 2) points of the tile's sides."""
    share = (np.arange(blocks)[:, None] + SHARES) / blocks
    step = np.roll(corners, -1, axis=0) - corners
    return np.asarray(corners[:, None, None] + share[..., None] * step[:, None, None])
