"""Scans with a laser vibrometer: results of their analysis, and simulated scans for tests."""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
