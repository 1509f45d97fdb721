"""Facts of the paper [daunizeau-haptics], for the comparison. The only numbers that the report is given."""

from __future__ import annotations

import math

from haptonic.materials import IsotropicMaterial
from haptonic.study import Study

CITATION = (
    "T. Daunizeau, D. Gueorguiev, S. Haliyo and V. Hayward, "
    "“Phononic Crystals Applied to Localised Surface Haptics”"
)

PITCH, THICKNESS, DIAMETER, HEIGHT = 7e-3, 1.5e-3, 3.5e-3, 14.7e-3  # m
YOUNGS_MODULUS, POISSON_RATIO, DENSITY = 70e9, 0.33, 2700.0  # Pa, 1, kg/m^3

GAP = (52.9e3, 61.4e3)  # Hz, complete; Fig. 4A
BELOW, ABOVE = (3, 4, 5, 6), (7, 8)  # modes at the lower and at the upper edge of the gap; Fig. 4B
PAIRS = ((1, 2), (4, 6), (7, 8))  # modes that the paper pairs by flexural mode
TRACTION, EXPANSION = 3, 5  # the two modes that it names otherwise
BRAGG_SPEED, BRAGG_FREQUENCY = 3040.0, 60e3  # m/s, Hz
ENOUGH_ROWS = 3  # "almost total reflection"; not detailed there
RESONANCE = 58.8e3  # Hz, of the mode that its waveguides were sized for; Fig. 5
GUIDE_MODE = "0x17"  # that mode's name
GUIDE_WIDTH, GUIDE_LENGTH, NODAL_SPACING = 32e-3, 140e-3, 8e-3  # m

# Reductions of friction on either guide, measured on three people, and "about" the share of it that the three
# rows of cells stop; Fig. 6
FRICTION = {"driven": 0.55, "idle": 0.11, "stopped": 0.80}

# Not the paper's: what quadratic tetrahedra of a size that is common in practice give for its cell, computed
# with an independent finite-element library while haptonic was developed.
COARSE_UPPER_EDGE = 61.5e3  # Hz
TRIED_FILLET = (
    0.3e-3  # m, radius at the foot with which its cell is computed as well: could that be the cause?
)


def is_its_cell(study: Study) -> bool:
    """Whether a study computes the paper's unit cell, to a part in a thousand of every size and constant."""
    cell, material = study.cell, study.cell.material
    if cell.pillar is None or cell.lattice.name != "square" or not isinstance(material, IsotropicMaterial):
        return False
    pairs = (
        (cell.lattice.pitch, PITCH),
        (cell.thickness, THICKNESS),
        (cell.pillar.diameter, DIAMETER),
        (cell.pillar.height, HEIGHT),
        (material.youngs_modulus, YOUNGS_MODULUS),
        (material.poisson_ratio, POISSON_RATIO),
        (material.density, DENSITY),
    )
    return all(math.isclose(ours, theirs, rel_tol=1e-3) for ours, theirs in pairs)
