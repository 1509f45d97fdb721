"""Results of analyses: values that can be queried, drawn and written, each with its inputs.

`haptonic.results.result` is their common protocol.
"""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
