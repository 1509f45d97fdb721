"""Scans with a laser vibrometer: what to measure, what came out, and a twin to test with."""

from haptonic.results.scan.analysis import Estimation, OnPlate, compute_scan, contrast_range
from haptonic.results.scan.excitation import Excitation
from haptonic.results.scan.question import ScanQuestion
from haptonic.results.scan.twin import FORMATS, Twin
from haptonic.results.scan.value import ScanResult
from haptonic.vibrometry.instrument import Instrument

__all__ = [
    "FORMATS",
    "Estimation",
    "Excitation",
    "Instrument",
    "OnPlate",
    "ScanQuestion",
    "ScanResult",
    "Twin",
    "compute_scan",
    "contrast_range",
]
