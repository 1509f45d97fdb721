"""What a plate's response costs, before anything is computed."""

from __future__ import annotations

import math

from haptonic.materials import IsotropicMaterial
from haptonic.plate.parts import Plate
from haptonic.plate.sweep import BLOCK, COPIES, FACTORS, LENGTH, MODES, SPACING, pillars_modes

PER_TILE = 39  # unknowns; 38 to 40 seen
FIXED, FIXED_MEMORY = 15.0, 1.2e9  # s and bytes, of the kinds of tiles and of lines answered one by one
EACH = 0.07  # s of a tile; plates of 48 and 196 tiles took 19 and 43 s with a small basis
SINGLE = 0.01  # s of a tile while one frequency is answered
PER_PRODUCT = 7e-7  # s for each unknown of each vector; plates of 90 to 540 pillars took 6.5e-7 to 1e-6


def foreseen(plate: Plate, low: float, high: float, *, single: bool = False) -> tuple[float, float]:
    """Processor time, s, and peak memory, bytes, of a response between two frequencies, Hz.

    The basis has as many vectors as shifts and modes ask for. The pillars' modes are those of
    cantilevers; the plate between them has by Weyl's law

        N = A k^2 / (4 pi),   k^2 = omega sqrt(rho h / D),   D = E h^3 / (12 (1 - nu^2)),

    which the pillars' mass makes a little too few.
    """
    layout = plate.layout
    tiles = len(layout.blocks)
    unknowns = PER_TILE * tiles
    if single:
        return FIXED + SINGLE * tiles, FIXED_MEMORY + FACTORS * tiles
    modes = pillars_modes(plate, high) + _plate_modes(plate, high)
    vectors = BLOCK * LENGTH * ((high - low) / (2 * SPACING) + modes / MODES)
    seconds = FIXED + EACH * tiles + PER_PRODUCT * unknowns * vectors
    return seconds, FIXED_MEMORY + 8.0 * COPIES * unknowns * vectors


def _plate_modes(plate: Plate, high: float) -> float:
    """Of bending, below a frequency, Hz."""
    layout, solid = plate.layout, plate.layout.material
    if not isinstance(solid, IsotropicMaterial):
        return 0.0
    area = sum(layout.area(name) for name in set(layout.there.values()))
    stiffness = solid.youngs_modulus * layout.thickness**2 / (12 * (1 - solid.poisson_ratio**2))
    return area * 2 * math.pi * high * math.sqrt(solid.density / stiffness) / (4 * math.pi)
