from .plate_tables import PlateSettings as PlateSettings
from .runs import Study as Study
from .runs import load as load
from .runs import load_trials as load_trials
from .runs import loads as loads
from .sweeps import SweepSettings as SweepSettings
from .trial_tables import TrialSettings as TrialSettings
