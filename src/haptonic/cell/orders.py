"""Orders, elements and layers that a tile's lengths ask for, which `MeshPlan` puts together."""

from __future__ import annotations

import math

import numpy as np

from haptonic.cell.pillar import Pillar
from haptonic.cell.stack import Feature
from haptonic.cell.tile import TileShape, sides_of

ROUNDING = 1e-9  # of a ratio of lengths, which must not change the plan of a scaled cell
# Length of an element along a prism, and along other pillars, whose order is higher, in diameters: of one of
# 1 deg draft, twelve diameters high, 1.4 and order 6 lost 1e-7, 2.8 lost 1e-5.
PRISM_LAYER, LAYER_LENGTH = 1.4, 2.8
SHORT_STAGE = 1.4  # diameters up to which two layers lead from the foot to a step
# Levels more through the rim, by the width of plate between it and the foot, in thicknesses. At 0.1 the cubic
# of order 4 lost 0.18 % that no other direction mended and no lower order told, two more mended it;
# at 0.4 one more took 0.05 % to 0.03 %, and from 0.48 on they brought nothing.
NEAR_RIM = {0.2: 2, 0.45: 1}
# Bands whose waves the orders of an accuracy were chosen for, and the most that a single element should have
# around a quarter turn: two of half as much, and one more, cost a third of it.
USUAL_BANDS, MOST_AROUND = 10, 10


def layers_along(pillar: Pillar) -> list[int]:
    """Layers of each of a pillar's stages, the lowest of them short, and the highest below a step.

    Without that one 2.8 diameters below a step's edge lost 0.06 %, of which no lower order told.
    """
    longest = PRISM_LAYER if pillar.is_prism else LAYER_LENGTH
    lengths = [(high - low) / (2 * width) for low, high, width in pillar.stages]
    layers = [1 + max(1, rounded(length / longest)) for length in lengths]
    if pillar.step is not None and lengths[0] > SHORT_STAGE:
        layers[0] += 1
    return layers


def neck_of(cell: TileShape, pillar: Feature, least: float = 0.0) -> float:
    """Half the length on which two pillars are near each other, as a share of half the side it lies on.

    That is the longer side. On a cell of 1 to 1.7 whose pillar leaves 0.15 of the shorter one nine orders
    around, a square's, lost 3 %.
    A pillar of a radius below ``least`` (m) is taken for one of that radius.
    """
    normal, away = sides_of(cell.corners)
    free = np.maximum(away - pillar.widest * pillar.outline.support(normal), ROUNDING * cell.extent)
    bend = pillar.outline.bend(normal) * max(pillar.widest, least)
    return float(np.sqrt(2 * free * bend).min()) / (0.5 * cell.extent)


def levels_near_rim(cell: TileShape) -> int:
    """Levels more on the rim for what the foot does there."""
    share = cell.clearance / cell.thickness
    return next((more for near, more in NEAR_RIM.items() if share < near * (1 - ROUNDING)), 0)


def orders_for_bands(cell: TileShape, bands: float) -> float:
    """Orders more than usual that so many bands need along the longer side of the cell.

    They are pi for each wavelength that the last band of a plain plate has there beyond those of the usual
    bands. As many flexural waves fit into a circle about Gamma whose area is that of as many zones.
    """
    waves = math.sqrt(bands / math.pi * cell.elongation)
    return math.pi * max(waves - math.sqrt(USUAL_BANDS / math.pi), 0.0)


def around_quarter(turn: float, more: float) -> tuple[int, int]:
    """Order and number of elements around a quarter turn that needs ``turn`` orders, and more for bands."""
    return divided_order(rounded(turn + more)) if more else (rounded(turn), 1)


def rounded(value: float) -> int:
    """The nearest whole number; of a half the upper one, whatever rounding errors it has."""
    return round((1 + ROUNDING) * value)


def divided_order(order: int) -> tuple[int, int]:
    """Order and number of the elements that resolve as much as a single one of ``order``."""
    return (order, 1) if order <= MOST_AROUND else ((order + 1) // 2 + 1, 2)
