from .simulated import FORMATS as FORMATS, SimulatedScan as SimulatedScan
from .value import ScanResult as ScanResult
