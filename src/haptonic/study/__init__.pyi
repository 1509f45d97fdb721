from .plate_tables import PlateSettings
from .runs import Study, load, load_trials, loads
from .sweeps import SweepSettings
from .trial_tables import TrialSettings

__all__ = [
    "PlateSettings",
    "Study",
    "SweepSettings",
    "TrialSettings",
    "load",
    "load_trials",
    "loads",
]
