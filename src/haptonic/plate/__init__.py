"""The finite plate: tiles of lattice and plain plate, supports, drives, and its vibration."""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
