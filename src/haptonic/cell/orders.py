"""Orders, elements and layers that a tile's lengths require, for `MeshPlan`."""

from __future__ import annotations

import math

import numpy as np

from haptonic.cell.pillar import Pillar
from haptonic.cell.stack import Feature
from haptonic.cell.tile import TileShape, sides_of

ROUNDING = 1e-9  # tolerance of ratios of lengths, so that a scaled cell has the same plan
# Length of an element along a prism, and along other pillars, whose order is higher, in diameters. For a
# pillar with 1 deg draft, twelve diameters high, the error was 1e-7 with 1.4 and order 6, and 1e-5 with 2.8.
PRISM_LAYER, LAYER_LENGTH = 1.4, 2.8
SHORT_STAGE = 1.4  # diameters; up to this length, two layers are enough between foot and step
# Additional levels through the rim, by the width of plate between it and the foot, in thicknesses. At 0.1 the
# error with the cubic of order 4 was 0.18 %, which no other direction reduced; two more levels removed it. At
# 0.4 one more reduced 0.05 % to 0.03 %, and from 0.48 on they had no effect. With two more, the rest of the
# error beside pillars on thick plates was 0.3 to 0.8 times the estimate at 0.06, and 0.06 times at 0.1.
NEAR_RIM = {0.08: 3, 0.2: 2, 0.45: 1}
# Thickness, in diameters of the circle in the cell, above which the rim gets one more level in any case.
# Without it the error of this direction beside pillars was 0.3 times their estimate at 0.4, 0.9 times at 0.5
# and 2.4 times at 0.65; with it at most 0.1 times.
THICK = 0.3
# Bands whose waves determined the orders of an accuracy, and the highest order of a single element around a
# quarter turn: two elements of half the order plus one cost a third.
USUAL_BANDS, MOST_AROUND = 10, 10
# Largest number of equal pieces of a side, more orders than any side needs, and orders in addition to those
# of a mesh: eight bands beside a square hole had errors of up to 2e-4 with as many, and of 3e-6 with two more
MOST_PIECES, MOST_ON_SIDE, FOR_WAVES = 4, 200, 2
# Relative error of a frequency as a multiple of rho^(-2 n), see `pieces_of_sides`: 1.3 for a snowflake
OVER_DECAY = 3.0


def pieces_of_sides(cell: TileShape, order: int, least: int) -> tuple[int, int]:
    """Number of equal pieces of each side and order of the trace on them, for outlines with corners.

    The field beside a side is singular at the corners of the outlines. On a piece from -1 to 1, with a corner
    at the complex place z whose imaginary part is its distance, a polynomial of order n has an error of
    rho^-n, ``rho = |z + sqrt(z^2 - 1)|`` (Trefethen 2019, doi 10.1137/1.9781611975949, theorem 8.2), and a
    frequency one of its square. A circle of radius r at a distance d acts like a point at a distance of
    ``sqrt(d^2 + 2 r d)``.

    order : of the mesh, see `trace_error`; least : orders of a mesh around a smooth outline
    """
    normal, away = sides_of(cell.corners)
    length = np.linalg.norm(np.roll(cell.corners, -1, axis=0) - cell.corners, axis=1)[:, None]
    ahead = np.stack([-normal[:, 1], normal[:, 0]], axis=1)
    from_corner = np.einsum("nc,nc->n", ahead, cell.corners)[:, None]
    poles = []
    assert cell.feature is not None, "a plate without features needs no further blocks"
    for border in cell.feature.borders:
        outline, width = border.outline, border.half_width
        if outline.joints:
            points = width * outline.at(np.arange(outline.joints, dtype=float))
            along, distance = ahead @ points.T - from_corner, away[:, None] - normal @ points.T
            radius = np.full_like(distance, width * outline.rounding)
        else:
            along, distance = -from_corner, (away - width * outline.support(normal))[:, None]
            radius = width * outline.bend(normal)[:, None]
        poles.append((along + 1j * np.sqrt(distance**2 + 2 * radius * distance)) / length)
    near, best = np.hstack(poles), (1, MOST_ON_SIDE)
    for pieces in range(1, MOST_PIECES + 1):
        at = 2 * (pieces * near - np.arange(pieces)[:, None, None]) - 1
        decay = np.log(np.abs(at + np.sqrt(at - 1) * np.sqrt(at + 1))).min()
        needed = max(
            math.ceil(math.log(OVER_DECAY / trace_error(order)) / (2 * decay)),
            order_on(pieces, 1, least + FOR_WAVES),
        )
        best = min(best, (pieces, needed), key=math.prod)
    return best


def trace_error(order: int) -> float:
    """Relative error of frequencies that a trace on fewer places may have, a fifth of that of such a mesh."""
    return float(10 ** -(2 + 0.5 * order))


def order_on(pieces: int, blocks: int, order: int) -> int:
    """Order on each of some pieces of a side that resolve as much as blocks of an order.

    As for cells without four sides, a polynomial of their share of the order plus one has the same error
    along shorter elements.
    """
    return order if pieces == blocks else math.ceil(order * blocks / pieces) + 1


def layers_along(pillar: Pillar) -> list[int]:
    """Layers of each of a pillar's stages, the lowest of them short, and the highest below a step.

    Without a short layer, the error of one 2.8 diameters below a step's edge was 0.06 %.
    """
    longest = PRISM_LAYER if pillar.is_prism else LAYER_LENGTH
    lengths = [(high - low) / (2 * width) for low, high, width in pillar.stages]
    layers = [1 + max(1, rounded(length / longest)) for length in lengths]
    if pillar.step is not None and lengths[0] > SHORT_STAGE:
        layers[0] += 1
    return layers


def neck_of(cell: TileShape, pillar: Feature, least: float = 0.0) -> float:
    """Half the length over which two pillars are near each other, as a share of half the side it lies on.

    That is the longer side. On a cell of 1 to 1.7 whose pillar leaves 0.15 of the shorter side, the error
    with nine orders around, as for a square, was 3 %. A radius of a pillar below ``least`` (m) is replaced by
    ``least``.
    """
    normal, away = sides_of(cell.corners)
    free = np.maximum(away - pillar.widest * pillar.outline.support(normal), ROUNDING * cell.extent)
    bend = pillar.outline.bend(normal) * max(pillar.widest, least)
    return float(np.sqrt(2 * free * bend).min()) / (0.5 * cell.extent)


def levels_near_rim(cell: TileShape) -> int:
    """Additional levels on the rim because of the foot's stress, or of a thick plate."""
    share = cell.clearance / cell.thickness
    return next(
        (more for near, more in NEAR_RIM.items() if share < near * (1 - ROUNDING)), int(is_thick(cell))
    )


def is_thick(cell: TileShape) -> bool:
    """True if waves vary through the plate about as much as along a side."""
    return cell.thickness > THICK * 2 * cell.inradius * (1 + ROUNDING)


def orders_for_bands(cell: TileShape, bands: float) -> float:
    """Additional orders for so many bands along the longer side of the cell.

    They are pi for each wavelength along this side by which the last band of a plain plate exceeds the usual
    bands. As many flexural waves fit into a circle about Gamma whose area is that of as many zones.
    """
    waves = math.sqrt(bands / math.pi * cell.elongation)
    return math.pi * max(waves - math.sqrt(USUAL_BANDS / math.pi), 0.0)


def around_quarter(turn: float, more: float) -> tuple[int, int]:
    """Order and number of elements around a quarter turn that needs ``turn`` orders, and more for bands."""
    return divided_order(rounded(turn + more)) if more else (rounded(turn), 1)


def rounded(value: float) -> int:
    """Nearest integer; a half is rounded up, also with a rounding error."""
    return round((1 + ROUNDING) * value)


def divided_order(order: int) -> tuple[int, int]:
    """Order and number of elements with the resolution of a single element of ``order``."""
    return (order, 1) if order <= MOST_AROUND else ((order + 1) // 2 + 1, 2)
