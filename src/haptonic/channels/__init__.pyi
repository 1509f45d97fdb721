from .formats import opened as opened
from .notes import Dropped as Dropped, Notebook as Notebook
from .signals import Channel as Channel, Group as Group, SignalFile as SignalFile
