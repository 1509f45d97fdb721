"""What a run gives back: values that can be asked, drawn and written, each with the inputs that made it.

`haptonic.results.result` is the protocol of all of them.
"""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
