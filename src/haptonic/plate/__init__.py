"""The finite plate: tiles of lattice and plain plate, supports, drives, and its vibration."""

from haptonic.plate.body.model import PlateModel
from haptonic.plate.body.recipes import Fineness
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.parts import Actuator, Bond, Finger, Force, Plate
from haptonic.plate.layout.supports import Support
from haptonic.plate.vibration.modes import PlateModes, modes_between
from haptonic.plate.vibration.reduced import Vibration
from haptonic.plate.vibration.sweep import Band

__all__ = [
    "Actuator",
    "Band",
    "Bond",
    "Fineness",
    "Finger",
    "Force",
    "Layout",
    "Plate",
    "PlateModel",
    "PlateModes",
    "Support",
    "Vibration",
    "modes_between",
]
