"""The frequency response: velocity against frequency, point and direction. Simulation and scan meet here."""

from haptonic.response.files import from_plain, plain, read, write
from haptonic.response.measures import (
    average_spectrum,
    cmif,
    contrast,
    disc_average,
    frac,
    mac,
    rms,
)
from haptonic.response.reference import Reference
from haptonic.response.value import FrequencyResponse

__all__ = [
    "FrequencyResponse",
    "Reference",
    "average_spectrum",
    "cmif",
    "contrast",
    "disc_average",
    "frac",
    "from_plain",
    "mac",
    "plain",
    "read",
    "rms",
    "write",
]
