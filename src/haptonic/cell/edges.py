"""Re-entrant edges of a cell, at which stress is singular, and grading of a mesh towards them."""

from __future__ import annotations

import math

import numpy as np

from haptonic.arrays import Array
from haptonic.cell.outlines.outline import EDGE_GRADING, EDGE_WIDTH
from haptonic.cell.pillar import Pillar
from haptonic.cell.tile import TileShape

CORE_RADIUS = 0.55  # distance of the core square's corners, as a share of the curve around it
FOOT_LAYER = 0.3  # height of the pillar's lowest layer, in diameters: stresses of the foot decay in it
# its least height, in diameters, near a step: errors with polynomials over sections 0.17 from either edge
# were 8e-5, 0.11 from it 2e-3
LEAST_LAYER = 0.15
MOST_APART = 16.0  # largest ratio of the far to the near border of an element beside the thin ones
BRIDGED = 6.0  # approximate ratio with further elements


def foot_reach(cell: TileShape, rings: int) -> Array:
    """Distances from the foot to the borders of the thin rings, outermost first, m."""
    pillar = cell.pillar
    if pillar is None:
        return np.empty(0)
    _, high, radius = pillar.stages[0]
    room = min(radius, cell.depth, high, 2 * cell.clearance)
    if pillar.step is not None:
        room = min(room, (1 - step_share(pillar)) * radius)
    return _reach(room, rings)


def step_reach(pillar: Pillar, rings: int) -> Array:
    """Distances from the edge of the step to the borders of the thin rings, outermost first, m."""
    (start, low, _), (_, high, width) = pillar.stages
    return _reach(min(width, pillar.half_width(low, 0) - width, low - start, high - low), rings)


def _reach(room: float, rings: int) -> Array:
    return np.asarray(EDGE_WIDTH * room * EDGE_GRADING ** np.arange(rings))


def step_share(pillar: Pillar) -> float:
    """Half-width above the step as a share of that below it; the border that ends there has this share."""
    low, _, width = pillar.stages[-1]
    return width / pillar.half_width(low, 0)


def between_edges(tile: TileShape) -> tuple[float, float] | None:
    """Ends of the prism between the neighbourhoods of foot and step, m above the plate.

    None without such a prism: no step or one too near, a pillar with draft, or pillars on both faces.
    """
    pillar = tile.pillar
    if pillar is None or pillar.step is None or pillar.draft or tile.is_mirrored:
        return None
    low, high = float(pillar.arc.at(1.0)[1]) if pillar.arc else 0.0, pillar.step.height
    beside = min(FOOT_LAYER * 2 * pillar.radius, (high - low) / 3)
    return (low + beside, high - beside) if beside >= LEAST_LAYER * 2 * pillar.radius else None


def within_foot(pillar: Pillar) -> float:
    """Half-width of the border next to the foot's thin rings on the inside, as a share of the foot's."""
    return step_share(pillar) if pillar.step else CORE_RADIUS


def beside_foot(cell: TileShape) -> float:
    """Distance that rings beside the foot have to cover, m: to where a plate bends, in a sheet half the neck.

    A sheet bends as powers of the distance from a pillar as thick as itself. The error with a single ring of
    order 7 from 0.15 to 16 thicknesses was 0.2 %, with one more a third of that.
    """
    return cell.clearance if cell.is_sheet else min(cell.clearance, cell.thickness)


def bridges(cell: TileShape, rings: int) -> tuple[int, int, int, int]:
    """Numbers of elements between the foot's thin ones and the rest: rings inside, outside, layers up, down.

    A pillar on a thin plate, or near its neighbour, has thin rings much smaller than itself. From them to its
    own size, stress decreases as a power of the distance: elements that grow with the distance resolve that
    at any ratio, a single element does not.
    """
    if cell.pillar is None or cell.pillar.fillet or not rings:
        return 0, 0, 0, 0
    near = foot_reach(cell, rings)[0]
    _, high, radius = cell.pillar.stages[0]
    above = min(2 * FOOT_LAYER * radius, high)
    far = ((1 - within_foot(cell.pillar)) * radius, beside_foot(cell), above, cell.depth)
    inside, outside, up, down = (_between(reach / near) for reach in far)
    return inside, outside, up, down


def _between(ratio: float) -> int:
    return math.ceil(math.log(ratio) / math.log(BRIDGED)) - 1 if ratio > MOST_APART else 0


def bridged(reach: Array, far: float, count: int) -> Array:
    """Borders of the thin rings, preceded by those of ``count`` rings that grow evenly up to ``far``."""
    if not count:
        return reach
    growth = (far / reach[0]) ** (np.arange(count, 0, -1) / (count + 1))
    return np.concatenate([reach[0] * growth, reach])
