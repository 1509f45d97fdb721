"""Pictures: each function turns a result into a matplotlib figure. No physics, no state."""

from haptonic.plots.bands import dispersion
from haptonic.plots.designs import front, search
from haptonic.plots.feel import friction_map, reduction_curve
from haptonic.plots.friction import conditions, reductions, trial_sheet
from haptonic.plots.mirrors import decay, guide, layers
from haptonic.plots.modes import mode_shapes
from haptonic.plots.planning import power
from haptonic.plots.plates import animated, maps, plate_plan
from haptonic.plots.scans import (
    average_response,
    drive_signal,
    fading,
    fading_map,
    measured_contrast,
    point_quality,
    wave_map,
)
from haptonic.plots.spectra import contrast_spectrum, impedance_spectrum, velocity_spectrum
from haptonic.plots.style import save
from haptonic.plots.sweeps import sweep
from haptonic.plots.tolerances import tolerance
from haptonic.plots.verdicts import before_after, frac_maps, mac_matrix
from haptonic.plots.zone import density_of_states, iso_frequency

__all__ = [
    "animated",
    "average_response",
    "before_after",
    "conditions",
    "contrast_spectrum",
    "decay",
    "density_of_states",
    "dispersion",
    "drive_signal",
    "fading",
    "fading_map",
    "frac_maps",
    "friction_map",
    "front",
    "guide",
    "impedance_spectrum",
    "iso_frequency",
    "layers",
    "mac_matrix",
    "maps",
    "measured_contrast",
    "mode_shapes",
    "plate_plan",
    "point_quality",
    "power",
    "reduction_curve",
    "reductions",
    "save",
    "search",
    "sweep",
    "tolerance",
    "trial_sheet",
    "velocity_spectrum",
    "wave_map",
]
