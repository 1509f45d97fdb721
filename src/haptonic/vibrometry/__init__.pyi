from .chirp import Drive as Drive, drive as drive, drive_notes as drive_notes, write_drive as write_drive
from .estimation import Estimate as Estimate, Quality as Quality, estimate as estimate
from .findings import Dropped as Dropped, ReadReport as ReadReport
from .maps import (
    Edge as Edge,
    LatticeGap as LatticeGap,
    LatticeRows as LatticeRows,
    MeasuredGap as MeasuredGap,
    Registration as Registration,
    clean_contrast as clean_contrast,
    clean_rms as clean_rms,
    decay_along as decay_along,
    gap_edges as gap_edges,
    lattice_decay as lattice_decay,
    measured_gap as measured_gap,
    region_statistics as region_statistics,
    register_by_corners as register_by_corners,
    register_by_fit as register_by_fit,
    warn_if_aliased as warn_if_aliased,
    wavenumber_map as wavenumber_map,
)
from .planning import (
    Rectangle as Rectangle,
    RoundRegion as RoundRegion,
    ScanPlan as ScanPlan,
    scan_plan as scan_plan,
    visited as visited,
)
from .readers import Scan as Scan, read_scan as read_scan
from .readers.hdf5 import write_records as write_records
from .readers.uff import UffContents as UffContents, uff_contents as uff_contents
from .records import InMemory as InMemory, TimeScan as TimeScan
from .writers import write_uff as write_uff, write_uff_records as write_uff_records
