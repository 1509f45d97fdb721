"""haptonic: surfaces whose friction is shaped by phononic crystals, from the unit cell to the proof.

>>> study = haptonic.load("studies/touchpad.toml")
>>> bands = study.bands()
>>> scan = haptonic.read_scan("measured.uff")
"""

import lazy_loader as lazy

__version__ = "0.2.0"

# What a name needs is loaded when it is first asked for: half of the field's libraries would be, otherwise.
__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
__all__.append("__version__")
