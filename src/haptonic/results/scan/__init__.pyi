from .analysis import Estimation, OnPlate, compute_scan
from .twin import FORMATS, Twin
from .value import ScanResult

__all__ = [
    "FORMATS",
    "Estimation",
    "OnPlate",
    "ScanResult",
    "Twin",
    "compute_scan",
]
