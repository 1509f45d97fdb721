"""From the files of a laser vibrometer to frequency responses, maps and a measured gap."""

from haptonic.vibrometry.estimation import Estimate, Quality, estimate
from haptonic.vibrometry.findings import Dropped, ReadReport
from haptonic.vibrometry.readers import Scan, read_scan
from haptonic.vibrometry.readers.hdf5 import write_records
from haptonic.vibrometry.readers.uff import UffContents, uff_contents
from haptonic.vibrometry.records import InMemory, TimeScan
from haptonic.vibrometry.writers import write_uff

__all__ = [
    "Dropped",
    "Estimate",
    "InMemory",
    "Quality",
    "ReadReport",
    "Scan",
    "TimeScan",
    "UffContents",
    "estimate",
    "read_scan",
    "uff_contents",
    "write_records",
    "write_uff",
]
