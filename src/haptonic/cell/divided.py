"""Division of a stack of discs into blocks: numbers of elements, and positions of their borders.

Thin rings and layers grade the mesh towards every edge with singular stress. Away from them, and outwards
from the axis, elements grow with the distance, because stress decreases as a power of it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.cell.blocks import Division, StackBlocks
from haptonic.cell.edges import BRIDGED, CORE_RADIUS, MOST_APART
from haptonic.cell.orders import ROUNDING, rounded
from haptonic.cell.outlines.outline import EDGE_GRADING, EDGE_WIDTH
from haptonic.cell.stack import TURNS, Stack
from haptonic.cell.tile import TileShape, sides_of

RING_GROWTH = 2.0  # ratio of outer to inner half-width of a ring
# length of an element in the plate, and above it, in diameters of the narrowest disc, as for a pillar
IN_PLATE, ABOVE_PLATE = 1.0, 1.4
SAMPLES = 400  # of an interval, for the sum of the element density


@dataclass(frozen=True)
class Interval:
    """An annulus or a storey, m, and rules for its elements.

    low, high : its ends
    near_low, near_high : reach of the thin elements at each end, farthest first
    growth : largest ratio of the outer to the inner end of an element, measured from zero; 0 for no limit
    length : length of the longest element
    """

    low: float
    high: float
    near_low: Array
    near_high: Array
    growth: float = 0.0
    length: float = math.inf

    @property
    def middle(self) -> tuple[float, float]:
        """Ends of the part between the thin elements."""
        return self.low + float(self.near_low.max(initial=0.0)), self.high - float(
            self.near_high.max(initial=0.0)
        )

    def _elements(self) -> tuple[Array, Array]:
        """Positions between the thin elements, and number of elements below each position."""
        start, end = self.middle
        place = start + (end - start) * 0.5 * (1 - np.cos(np.linspace(0.0, np.pi, SAMPLES)))
        density = np.full(SAMPLES, 1 / self.length)
        if self.growth:
            density = np.maximum(density, 1 / (place * math.log(self.growth)))
        for near, distance in ((self.near_low, place - self.low), (self.near_high, self.high - place)):
            if len(near):
                density = np.maximum(density, 1 / (distance * math.log(BRIDGED)))
        density = np.maximum(density, 1e-3 / (end - start))
        steps = 0.5 * (density[1:] + density[:-1]) * np.diff(place)
        return place, np.concatenate([[0.0], np.cumsum(steps)])

    @property
    def division(self) -> Division:
        """Numbers of elements."""
        whole = float(self._elements()[1][-1])
        # a single element extends from the thin elements up to `MOST_APART` times their width
        alone = math.log(MOST_APART) / math.log(BRIDGED) if len(self.near_low) + len(self.near_high) else 1.0
        between = 1 if whole <= alone * (1 + ROUNDING) else max(rounded(whole), 2)
        return Division(len(self.near_low), between, len(self.near_high))

    def borders(self, division: Division) -> list[float]:
        """Positions of the borders between elements, and of both ends, m."""
        place, below = self._elements()
        inner = np.interp(below[-1] * np.arange(division.between + 1) / division.between, below, place)
        thin_low = [self.low, *(self.low + self.near_low[::-1])] if division.low else [self.low]
        thin_high = [*(self.high - self.near_high), self.high] if division.high else [self.high]
        return [*thin_low, *inner[1:-1].tolist(), *thin_high]


def annuli_of(tile: TileShape, stack: Stack, rings: int) -> list[Interval]:
    """The annuli of a stack with ``rings`` thin ones at every singular edge; the first begins at the core.

    Each is taken at the level where its outer border is farthest beyond its inner one; on other levels its
    elements have the same shares of its width. Thin rings are thin enough for the edges on every level.
    """
    ends, rooms = _ends(tile, stack, stack.widths), _rooms(tile, stack)
    singular = stack.singular | np.array([any(corners) for corners in stack.singular_corners])[:, None]
    annuli = []
    for number, (low, high) in enumerate(pairwise(ends)):
        level, width = int((high / low).argmax()), high - low
        near_low, near_high = (
            width[level] * _reach(rooms[border] / width, singular[border], rings)
            if 0 <= border < len(rooms) else np.empty(0)
            for border in (number - 1, number)
        )  # fmt: skip
        growth = RING_GROWTH if number else 0.0
        if number == len(rooms) and not stack.outline.is_convex:
            # as many elements as from the notches of the border to the corners of the tile
            growth **= math.log(high[level] / low[level]) / math.log(_farthest(tile, stack))
        annuli.append(Interval(float(low[level]), float(high[level]), near_low, near_high, growth=growth))
    return annuli


def half_widths(tile: TileShape, stack: Stack, blocks: StackBlocks, heights: Array) -> Array:
    """(borders, heights) half-widths of all borders between rings, without the tile's side, m."""
    annuli = annuli_of(tile, stack, blocks.thin)
    rows = []
    for annulus, division, (low, high) in zip(
        annuli, blocks.annuli, pairwise(_ends(tile, stack, stack.widths_at(heights))), strict=True
    ):
        share = (np.array(annulus.borders(division)) - annulus.low) / (annulus.high - annulus.low)
        rows.append(low + share[:-1, None] * (high - low))
    return np.concatenate(rows)


def storeys_of(tile: TileShape, stack: Stack, rings: int) -> list[Interval]:
    """The storeys of a stack with ``rings`` thin layers at every end with a singular edge."""
    rooms, singular = _rooms(tile, stack), stack.singular
    near = [_reach(rooms[:, end], singular[:, end], rings) for end in range(len(stack.heights))]
    diameter = stack.widths[0, :-1] + stack.widths[0, 1:]  # of the narrowest disc, amid each storey
    return [
        Interval(
            float(low),
            float(high),
            near[number],
            near[number + 1],
            length=float(diameter[number]) * (IN_PLATE if number < stack.in_plate else ABOVE_PLATE),
        )
        for number, (low, high) in enumerate(pairwise(stack.heights))
    ]


def blocks_of(tile: TileShape, stack: Stack, rings: int) -> StackBlocks:
    """Blocks of a stack with ``rings`` thin elements at every singular edge, one more with upright edges."""
    has_upright = any(map(any, stack.singular_corners))
    rings += has_upright
    return StackBlocks(
        grid=stack.grid,
        in_plate=stack.in_plate,
        storeys=tuple(storey.division for storey in storeys_of(tile, stack, rings)),
        annuli=tuple(annulus.division for annulus in annuli_of(tile, stack, rings)),
        around=rings if has_upright else 0,
    )


def borders(intervals: Sequence[Interval], divisions: Sequence[Division]) -> Array:
    """Positions of all borders of consecutive intervals, each once, m."""
    places = [interval.borders(division) for interval, division in zip(intervals, divisions, strict=True)]
    return np.array([places[0][0], *(place for within in places for place in within[1:])])


def edges_between(divisions: Sequence[Division]) -> tuple[int, ...]:
    """Indices of the elements that follow on a singular edge between two intervals."""
    ends = np.cumsum([division.count for division in divisions])
    return tuple(int(end) for end, division in zip(ends[:-1], divisions[:-1], strict=True) if division.high)


def _ends(tile: TileShape, stack: Stack, widths: Array) -> Array:
    """(annuli + 1, ...) half-widths from the core to the tile's side, for those of the borders, m."""
    side = np.full_like(widths[:1], stack.widest + tile.clearance)
    return np.concatenate([CORE_RADIUS * widths[:1], widths, side])


def _farthest(tile: TileShape, stack: Stack) -> float:
    """Largest ratio of the distances of the tile's sides and of the last border from the axis."""
    border = stack.widest * stack.outline.polygon(TURNS, 8)
    normal, away = sides_of(tile.corners)
    return float((1 / (border @ normal.T / away).max(axis=1)).max())


def _rooms(tile: TileShape, stack: Stack) -> Array:
    """(borders, ends) smallest length at each edge: of both annuli and both storeys beside it, m."""
    width = np.diff(_ends(tile, stack, stack.widths), axis=0)
    width[0], width[-1] = stack.widths[0], 2 * width[-1]
    height = np.concatenate([[np.inf], np.diff(stack.heights), [np.inf]])
    beside = np.minimum(width[:-1], width[1:])
    return np.asarray(np.minimum(beside, np.minimum(height[:-1], height[1:])))


def _reach(rooms: Array, singular: Bools, rings: int) -> Array:
    """Distances from an edge to the borders of thin elements, farthest first, m; empty without an edge."""
    if not singular.any():
        return np.empty(0)
    return np.asarray(EDGE_WIDTH * rooms[singular].min() * EDGE_GRADING ** np.arange(rings))
