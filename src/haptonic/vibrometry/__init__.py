"""From the files of a laser vibrometer to frequency responses, maps and a measured gap."""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
