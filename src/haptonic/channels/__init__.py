"""Files of signals: channels with a name, a unit, a rate and samples, from and to the formats of others.

`haptonic.vibrometry` and `haptonic.friction` begin where this ends: `opened` gives the channels of a file,
whatever its format, and they know what the channels mean.

docs/channels.md says how to add a format.
"""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
