from .bands import dispersion
from .designs import front, search
from .feel import friction_map, reduction_curve
from .friction import conditions, reductions, trial_sheet
from .mapped import animated, maps, maps_compared
from .mirrors import decay, guide, layers
from .modes import mode_shapes
from .overlays import compared
from .planning import power
from .plates import plate_plan
from .ribbons import projected, ribbon_field
from .scans import (
    average_response,
    decay_map,
    drive_signal,
    measured_contrast,
    measured_decay,
    point_quality,
    wave_map,
)
from .spectra import contrast_spectrum, impedance_spectrum, velocity_spectrum
from .style import rendered, save
from .sweeps import sweep
from .tolerances import tolerance
from .verdicts import before_after, frac_maps, mac_matrix
from .zone import density_of_states, iso_frequency

__all__ = [
    "animated",
    "average_response",
    "before_after",
    "compared",
    "conditions",
    "contrast_spectrum",
    "decay",
    "decay_map",
    "density_of_states",
    "dispersion",
    "drive_signal",
    "frac_maps",
    "friction_map",
    "front",
    "guide",
    "impedance_spectrum",
    "iso_frequency",
    "layers",
    "mac_matrix",
    "maps",
    "maps_compared",
    "measured_contrast",
    "measured_decay",
    "mode_shapes",
    "plate_plan",
    "point_quality",
    "power",
    "projected",
    "reduction_curve",
    "reductions",
    "rendered",
    "ribbon_field",
    "save",
    "search",
    "sweep",
    "tolerance",
    "trial_sheet",
    "velocity_spectrum",
    "wave_map",
]
