from .formats import opened
from .notes import Dropped, Notebook
from .signals import Channel, Group, SignalFile

__all__ = ["Channel", "Dropped", "Group", "Notebook", "SignalFile", "opened"]
