"""Results of a scan of a plate: regions, gap, waves in the guides, decay through the lattice."""

from haptonic.vibrometry.maps.edges import Edge, LatticeGap, LatticeRows, decay_along, gap_edges
from haptonic.vibrometry.maps.gap import MeasuredGap, measured_gap, region_statistics
from haptonic.vibrometry.maps.noise import clean_contrast, clean_rms
from haptonic.vibrometry.maps.registration import Registration, register_by_corners, register_by_fit
from haptonic.vibrometry.maps.waves import lattice_decay, warn_if_aliased, wavenumber_map

__all__ = [
    "Edge",
    "LatticeGap",
    "LatticeRows",
    "MeasuredGap",
    "Registration",
    "clean_contrast",
    "clean_rms",
    "decay_along",
    "gap_edges",
    "lattice_decay",
    "measured_gap",
    "region_statistics",
    "register_by_corners",
    "register_by_fit",
    "warn_if_aliased",
    "wavenumber_map",
]
