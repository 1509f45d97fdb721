"""haptonic: surfaces whose friction is shaped by phononic crystals, from the unit cell to the proof.

>>> study = haptonic.load("studies/touchpad.toml")
>>> bands = study.bands()
>>> scan = haptonic.read_scan("measured.uff")
"""

from typing import TYPE_CHECKING, Any

from haptonic.errors import HaptonicError, HaptonicWarning
from haptonic.study import Study, load

if TYPE_CHECKING:
    from haptonic.vibrometry import read_scan

__version__ = "0.1.0"

__all__ = ["HaptonicError", "HaptonicWarning", "Study", "__version__", "load", "read_scan"]


def __getattr__(name: str) -> Any:
    """The readers of scan files take half a second to import: only for those who use them."""
    if name != "read_scan":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from haptonic.vibrometry import read_scan

    return read_scan
