"""Frequency response: velocity against frequency, point and direction, from a simulation or a scan."""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
