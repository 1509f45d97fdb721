from .chirp import Drive, drive, drive_notes, write_drive
from .estimation import Estimate, Quality, estimate
from .findings import Dropped, ReadReport
from .maps import (
    Edge,
    LatticeGap,
    LatticeRows,
    MeasuredGap,
    Registration,
    clean_contrast,
    clean_rms,
    decay_along,
    gap_edges,
    lattice_decay,
    measured_gap,
    region_statistics,
    register_by_corners,
    register_by_fit,
    warn_if_aliased,
    wavenumber_map,
)
from .planning import Disc, Rectangle, ScanPlan, scan_plan, visited
from .readers import Scan, read_scan
from .readers.hdf5 import write_records
from .readers.uff import UffContents, uff_contents
from .records import InMemory, TimeScan
from .writers import write_uff, write_uff_records

__all__ = [
    "Disc",
    "Drive",
    "Dropped",
    "Edge",
    "Estimate",
    "InMemory",
    "LatticeGap",
    "LatticeRows",
    "MeasuredGap",
    "Quality",
    "ReadReport",
    "Rectangle",
    "Registration",
    "Scan",
    "ScanPlan",
    "TimeScan",
    "UffContents",
    "clean_contrast",
    "clean_rms",
    "decay_along",
    "drive",
    "drive_notes",
    "estimate",
    "gap_edges",
    "lattice_decay",
    "measured_gap",
    "read_scan",
    "region_statistics",
    "register_by_corners",
    "register_by_fit",
    "scan_plan",
    "uff_contents",
    "visited",
    "warn_if_aliased",
    "wavenumber_map",
    "write_drive",
    "write_records",
    "write_uff",
    "write_uff_records",
]
