from .plate_tables import PlateSettings as PlateSettings
from .runs import Study as Study, load as load, load_trials as load_trials, loads as loads
from .sweeps import SweepSettings as SweepSettings
from .template import (
    ENDING as ENDING,
    Template as Template,
    case_templates as case_templates,
    templates as templates,
)
from .trial_tables import TrialSettings as TrialSettings
