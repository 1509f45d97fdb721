"""haptonic: design and validation of surfaces whose friction is shaped by phononic crystals.

>>> study = haptonic.load("studies/touchpad.toml")
>>> bands = study.bands()
>>> scan = haptonic.read_scan("measured.uff")
"""

import lazy_loader as lazy

__version__ = "0.2.0"

# names are imported on first access; otherwise every import would load half of the scientific libraries
__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
__all__.append("__version__")
