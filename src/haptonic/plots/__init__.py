"""Pictures: each function turns a result into a matplotlib figure. No physics, no state."""

from haptonic.plots.bands import dispersion
from haptonic.plots.designs import front, search
from haptonic.plots.mirrors import decay, guide, layers
from haptonic.plots.modes import mode_shapes
from haptonic.plots.plates import animated, maps, plate_plan
from haptonic.plots.spectra import contrast_spectrum, impedance_spectrum, velocity_spectrum
from haptonic.plots.style import save
from haptonic.plots.sweeps import sweep
from haptonic.plots.tolerances import tolerance
from haptonic.plots.verdicts import before_after, frac_maps, mac_matrix
from haptonic.plots.zone import density_of_states, iso_frequency

__all__ = [
    "animated",
    "before_after",
    "contrast_spectrum",
    "decay",
    "density_of_states",
    "dispersion",
    "frac_maps",
    "front",
    "guide",
    "impedance_spectrum",
    "iso_frequency",
    "layers",
    "mac_matrix",
    "maps",
    "mode_shapes",
    "plate_plan",
    "save",
    "search",
    "sweep",
    "tolerance",
    "velocity_spectrum",
]
