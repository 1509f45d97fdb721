from .files import from_plain, plain, read, write
from .measures import average_spectrum, cmif, contrast, disc_average, frac, mac, rms
from .reference import Reference
from .value import FrequencyResponse

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
