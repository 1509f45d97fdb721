from .plate_tables import PlateSection
from .runs import Study, load, load_trials, loads
from .scan_tables import ScanSection
from .sections import BandsSection, MeshSection
from .sweeps import SweepSection
from .trial_tables import Trials

__all__ = [
    "BandsSection",
    "MeshSection",
    "PlateSection",
    "ScanSection",
    "Study",
    "SweepSection",
    "Trials",
    "load",
    "load_trials",
    "loads",
]
