from .analysis import Estimation as Estimation
from .analysis import OnPlate as OnPlate
from .analysis import compute_scan as compute_scan
from .simulated import FORMATS as FORMATS
from .simulated import SimulatedScan as SimulatedScan
from .value import ScanResult as ScanResult
