"""Files of signals in many formats: channels with a name, a unit, a rate and samples.

`opened` reads the channels of a file in any of these formats; `haptonic.vibrometry` and `haptonic.friction`
interpret them.

docs/channels.md explains how to add a format.
"""

import lazy_loader as lazy

__getattr__, __dir__, __all__ = lazy.attach_stub(__name__, __file__)
