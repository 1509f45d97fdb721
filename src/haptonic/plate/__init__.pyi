from .body.model import PlateModel as PlateModel
from .body.tile_construction import Fineness as Fineness
from .layout.grid import Layout as Layout
from .layout.parts import Actuator as Actuator, Bond as Bond, Finger as Finger, Force as Force, Plate as Plate
from .layout.supports import Support as Support
from .vibration.modes import PlateModes as PlateModes, modes_between as modes_between
from .vibration.reduced_plate import Vibration as Vibration
from .vibration.sweep import Band as Band
