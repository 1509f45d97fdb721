"""From the files of a laser vibrometer to frequency responses, maps and a measured gap."""

from haptonic.vibrometry.chirp import Drive, drive, write_drive
from haptonic.vibrometry.estimation import Estimate, Quality, estimate
from haptonic.vibrometry.findings import Dropped, ReadReport
from haptonic.vibrometry.readers import Scan, read_scan
from haptonic.vibrometry.readers.hdf5 import write_records
from haptonic.vibrometry.readers.uff import UffContents, uff_contents
from haptonic.vibrometry.records import InMemory, TimeScan
from haptonic.vibrometry.scan_plan import Disc, Rectangle, ScanPlan, scan_plan
from haptonic.vibrometry.writers import write_uff

__all__ = [
    "Disc",
    "Drive",
    "Dropped",
    "Estimate",
    "InMemory",
    "Quality",
    "ReadReport",
    "Rectangle",
    "Scan",
    "ScanPlan",
    "TimeScan",
    "UffContents",
    "drive",
    "estimate",
    "read_scan",
    "scan_plan",
    "uff_contents",
    "write_drive",
    "write_records",
    "write_uff",
]
