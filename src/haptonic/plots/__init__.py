"""Pictures: each function turns a result into a matplotlib figure. No physics, no state."""

from haptonic.plots.bands import dispersion
from haptonic.plots.designs import front, search
from haptonic.plots.mirrors import decay, guide, layers
from haptonic.plots.modes import mode_shapes
from haptonic.plots.style import save
from haptonic.plots.sweeps import sweep
from haptonic.plots.tolerances import tolerance
from haptonic.plots.zone import density_of_states, iso_frequency

__all__ = [
    "decay",
    "density_of_states",
    "dispersion",
    "front",
    "guide",
    "iso_frequency",
    "layers",
    "mode_shapes",
    "save",
    "search",
    "sweep",
    "tolerance",
]
