from .analysis import Estimation, OnPlate, compute_scan
from .simulated import FORMATS, SimulatedScan
from .value import ScanResult

__all__ = [
    "FORMATS",
    "Estimation",
    "OnPlate",
    "ScanResult",
    "SimulatedScan",
    "compute_scan",
]
