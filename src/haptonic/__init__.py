"""haptonic: surfaces whose friction is shaped by phononic crystals, from the unit cell to the proof.

>>> study = haptonic.load("studies/touchpad.toml")
>>> bands = study.bands()
>>> scan = haptonic.read_scan("measured.uff")
"""

from haptonic.errors import HaptonicError, HaptonicWarning
from haptonic.study import Study, load
from haptonic.vibrometry import read_scan

__version__ = "0.1.0"

__all__ = ["HaptonicError", "HaptonicWarning", "Study", "__version__", "load", "read_scan"]
