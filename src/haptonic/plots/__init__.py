"""Pictures: each function turns a result into a matplotlib figure. No physics, no state."""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
