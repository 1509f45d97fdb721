from .plate_tables import PlateSection
from .runs import Study, load, load_trials, loads
from .scan_tables import ScanSection
from .schema import SweepSection
from .sections import BandsSection, CellSection, MeshSection
from .trial_tables import Trials
from .vary import solve

__all__ = [
    "BandsSection",
    "CellSection",
    "MeshSection",
    "PlateSection",
    "ScanSection",
    "Study",
    "SweepSection",
    "Trials",
    "load",
    "load_trials",
    "loads",
    "solve",
]
