from .cell import Disc, Pillar, Solid, SolidPart, UnitCell
from .errors import HaptonicError, HaptonicWarning
from .lattice import Lattice
from .study import Study, load
from .vibrometry import read_scan

__version__: str

__all__ = [
    "Disc",
    "HaptonicError",
    "HaptonicWarning",
    "Lattice",
    "Pillar",
    "Solid",
    "SolidPart",
    "Study",
    "UnitCell",
    "__version__",
    "load",
    "read_scan",
]
