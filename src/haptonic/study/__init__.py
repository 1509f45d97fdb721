"""The study file: read, checked, written; one immutable value for everything that a run computes with."""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
