from .analysis import Estimation, OnPlate, compute_scan, contrast_range
from .excitation import Excitation
from .question import ScanQuestion
from .twin import FORMATS, Twin
from .value import ScanResult

__all__ = [
    "FORMATS",
    "Estimation",
    "Excitation",
    "OnPlate",
    "ScanQuestion",
    "ScanResult",
    "Twin",
    "compute_scan",
    "contrast_range",
]
