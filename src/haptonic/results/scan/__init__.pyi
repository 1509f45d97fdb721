from .analysis import Estimation as Estimation, OnPlate as OnPlate, compute_scan as compute_scan
from .simulated import FORMATS as FORMATS, SimulatedScan as SimulatedScan
from .value import ScanResult as ScanResult
