"""Published and exact cases, each a study file, that `haptonic verify` computes and compares."""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
