"""Small plates, drawn as text, that tests of the whole computation share."""

import numpy as np

from bricks import ALUMINIUM, PITCH, THICKNESS
from haptonic.cell import Pillar, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.plate.body.tile_construction import Fineness
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.parts import Actuator, Bond, Finger, Force, Plate
from haptonic.plate.layout.supports import Support

CELL = UnitCell(Lattice.square(PITCH), THICKNESS, ALUMINIUM, Pillar(3.5e-3, 14.7e-3))
COARSE = Fineness(along=3, through=2, cell=2, rings=0, plain=3)
LOSS = 2e-3


def drawn(text, x=None, y=None, thickness=THICKNESS):
    """A layout from rows of letters, the first one on top: "o" a lattice, others plain, "." nothing."""
    rows = text.split()[::-1]
    x = PITCH * np.arange(len(rows[0]) + 1) if x is None else x
    y = PITCH * np.arange(len(rows) + 1) if y is None else y
    tiles = tuple(tuple(None if letter == "." else letter for letter in row) for row in rows)
    return Layout(tiles, tuple(map(float, x)), tuple(map(float, y)), {"o": CELL}, thickness, ALUMINIUM)


def plain_plate(rows=2, columns=3, **others):
    """Plain tiles of 7 x 7 mm."""
    return Plate(drawn(" ".join(["p" * columns] * rows)), loss_factor=LOSS, **others)


def glued(centre, size=(9e-3, 5e-3, 0.7e-3), name="A", ceramic="sm111"):
    """A patch on 50 um of glue."""
    return Actuator(name, centre, size, material(ceramic), Bond(50e-6, material("silver-epoxy")))


def busy_plate():
    """Something of everything whose loss is not the plate's, and two drives."""
    return plain_plate(
        3,
        4,
        supports=(Support("left", "spring", stiffness=3e11, loss_factor=0.08), Support("right", "clamped")),
        actuators=(glued((9e-3, 10e-3)),),
        forces=(Force("F", (24e-3, 5e-3), (3e-3, 2e-3)),),
        finger=Finger((18e-3, 11e-3), 6e-3, mass=2e-3, stiffness=2e4, damping=3.0),
    )
