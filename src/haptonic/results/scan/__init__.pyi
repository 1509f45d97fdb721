from .analysis import Estimation, OnPlate, compute_scan, contrast_range
from .excitation import Excitation
from .twin import FORMATS, Twin
from .value import ScanResult

__all__ = [
    "FORMATS",
    "Estimation",
    "Excitation",
    "OnPlate",
    "ScanResult",
    "Twin",
    "compute_scan",
    "contrast_range",
]
