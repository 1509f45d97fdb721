"""Files of signals: channels with a name, a unit, a rate and samples, from and to the formats of others.

`haptonic.vibrometry` and `haptonic.friction` begin where this ends: `opened` gives the channels of a file,
whatever its format, and they know what the channels mean.

docs/channels.md says how to add a format.
"""

from haptonic.channels.formats import opened
from haptonic.channels.notes import Dropped, Notebook
from haptonic.channels.signals import Channel, Group, SignalFile

__all__ = ["Channel", "Dropped", "Group", "Notebook", "SignalFile", "opened"]
