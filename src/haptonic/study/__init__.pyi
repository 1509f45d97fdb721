from .plate_tables import PlateSection
from .runs import Study, load, load_trials, loads
from .sweeps import SweepSection
from .trial_tables import Trials

__all__ = [
    "PlateSection",
    "Study",
    "SweepSection",
    "Trials",
    "load",
    "load_trials",
    "loads",
]
