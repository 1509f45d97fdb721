"""The finite plate: tiles of lattice and plain plate, supports, drives, and its vibration."""

from haptonic.plate.holding import Support
from haptonic.plate.layout import Layout
from haptonic.plate.model import PlateModel
from haptonic.plate.modes import PlateModes, modes_between
from haptonic.plate.parts import Actuator, Bond, Finger, Force, Plate
from haptonic.plate.recipes import Fineness
from haptonic.plate.sweep import Band
from haptonic.plate.vibration import Vibration

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
