"""Scans with a laser vibrometer: what to measure, what came out, and a simulated scan to test with."""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
