"""Lattices of small cells, and plates of them that are drawn as text."""

import numpy as np

from haptonic.cell import Brickwork, Pillar, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial
from haptonic.plate.layout.grid import Layout

ALUMINIUM = IsotropicMaterial(youngs_modulus=70e9, poisson_ratio=0.33, density=2700.0, name="aluminium")
PITCH, THICKNESS = 7e-3, 1.5e-3
THIN, TALL = Pillar(1.5e-3, 9e-3), Pillar(1.7e-3, 11e-3)
CELLS = {
    "square": UnitCell(Lattice.square(PITCH), THICKNESS, ALUMINIUM, THIN),
    "rectangular": UnitCell(Lattice.rectangular(PITCH, 5e-3), THICKNESS, ALUMINIUM, THIN),
    "triangular": UnitCell(Lattice.triangular(PITCH), THICKNESS, ALUMINIUM, THIN),
    "centred": UnitCell(Lattice.centred(PITCH, 9e-3), THICKNESS, ALUMINIUM, THIN),
    "upright": UnitCell(  # the triangular one turned by a right angle
        Lattice.centred(np.sqrt(3) * PITCH, PITCH), THICKNESS, ALUMINIUM, THIN
    ),
    "thirds": UnitCell(
        Lattice.oblique(PITCH, float(np.hypot(PITCH / 3, 6e-3)), float(np.arctan2(6e-3, PITCH / 3))),
        THICKNESS, ALUMINIUM, THIN,
    ),
    "honeycomb": UnitCell(
        Lattice(lattice="honeycomb", pitch=PITCH), THICKNESS, ALUMINIUM,
        site=({"pillar": THIN}, {"pillar": TALL}),
    ),
    "askew": UnitCell(  # bricks whose pillar is not in the middle, beside lines that are not either
        Lattice.square(PITCH), THICKNESS, ALUMINIUM,
        site=({"at": (0.0, 0.0), "pillar": THIN}, {"at": (0.25, 0.4), "pillar": TALL}),
    ),
    "kagome": UnitCell(Lattice(lattice="kagome", pitch=PITCH), THICKNESS, ALUMINIUM, THIN),
    "lieb": UnitCell(Lattice(lattice="lieb", pitch=PITCH), THICKNESS, ALUMINIUM, THIN),
}  # fmt: skip


def laid(text, cell):
    """A plate from letters, the first line on top: "o" the lattice, others plain, "." nothing."""
    rows = [tuple(None if letter == "." else letter for letter in row) for row in text.split()[::-1]]
    work = Brickwork.of(cell)
    widths = [work.width] * len(rows[0])
    return Layout.laid(rows, widths, [work.height] * len(rows), {"o": cell}, THICKNESS, ALUMINIUM)
