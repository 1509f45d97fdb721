from .formats import opened as opened
from .notes import Dropped as Dropped
from .notes import Notebook as Notebook
from .signals import Channel as Channel
from .signals import Group as Group
from .signals import SignalFile as SignalFile
