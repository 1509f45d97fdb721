from .files import from_plain as from_plain, plain as plain, read as read, write as write
from .measures import (
    average_spectrum as average_spectrum,
    cmif as cmif,
    contrast as contrast,
    disc_average as disc_average,
    frac as frac,
    mac as mac,
    rms as rms,
)
from .reference import Reference as Reference
from .value import FrequencyResponse as FrequencyResponse
