"""The study file: reading, checking and writing; a study is one immutable value with all inputs of a run."""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
