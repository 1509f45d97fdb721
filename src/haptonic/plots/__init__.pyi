from .bands import dispersion as dispersion, shown_up_to as shown_up_to
from .designs import front as front, search as search
from .feel import friction_map as friction_map, reduction_curve as reduction_curve
from .friction import conditions as conditions, reductions as reductions, trial_sheet as trial_sheet
from .looks import chosen as chosen
from .mapped import (
    animated as animated,
    map_at as map_at,
    maps as maps,
    maps_compared as maps_compared,
    maps_of_drives as maps_of_drives,
)
from .mirrors import decay as decay, guide as guide, layers as layers
from .modes import mode_shapes as mode_shapes, moving_modes as moving_modes
from .overlays import compared as compared
from .planning import power as power
from .plates import plate_plan as plate_plan
from .ribbons import projected as projected, ribbon_field as ribbon_field
from .scans import (
    average_response as average_response,
    decay_map as decay_map,
    drive_signal as drive_signal,
    measured_contrast as measured_contrast,
    measured_decay as measured_decay,
    point_quality as point_quality,
    wave_map as wave_map,
)
from .spectra import (
    contrast_spectrum as contrast_spectrum,
    impedance_spectrum as impedance_spectrum,
    velocity_spectrum as velocity_spectrum,
)
from .stage import Stage as Stage, checked as checked, painted as painted
from .style import rendered as rendered, save as save, shades as shades
from .sweep_grids import sweep_grid as sweep_grid
from .sweeps import sweep as sweep
from .tolerances import tolerance as tolerance
from .verdicts import before_after as before_after, frac_maps as frac_maps, mac_matrix as mac_matrix
from .zone import density_of_states as density_of_states, iso_frequency as iso_frequency
