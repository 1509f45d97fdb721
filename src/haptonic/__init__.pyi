from .errors import HaptonicError, HaptonicWarning
from .study import Study, load
from .vibrometry import read_scan

__version__: str

__all__ = ["HaptonicError", "HaptonicWarning", "Study", "__version__", "load", "read_scan"]
