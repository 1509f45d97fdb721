"""Keys that people write and this program calls otherwise, or does not have, each with what to write.

A described class lists them beside its fields::

    aliases: ClassVar[Aliases] = {
        **meant("diameter", "d", "width"),
        **absent("hole", cause="a pillar is solid", next_step="leave it out"),
    }
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from haptonic.fields.keys import slots, table


@dataclass(frozen=True)
class Alias:
    """A key that is refused with its reason; ``key`` is the one that is meant, if there is such a key."""

    cause: str
    next_step: str
    key: str = ""


Aliases = Mapping[str, Alias]


def meant(key: str, *names: str, cause: str = "", next_step: str = "") -> dict[str, Alias]:
    """Other names of a key of the same table."""
    return {
        name: Alias(cause or f'this is called "{key}" here', next_step or f'write "{key}"', key)
        for name in names
    }


def absent(*names: str, cause: str, next_step: str) -> dict[str, Alias]:
    """Names that no key of the same table stands for."""
    return {name: Alias(cause, next_step) for name in names}


@cache
def aliases(kind: type, prefix: str = "") -> dict[str, Alias]:
    """All of a described class and of the tables in it, by path as `haptonic.fields.table` has paths."""
    found = {f"{prefix}{name}": one for name, one in getattr(kind, "aliases", {}).items()}
    keys = table(kind, prefix)
    for slot in slots(kind):
        path = slot.path(prefix)
        several = path in keys and keys[path].kind == "tables"
        for below in slot.kinds:
            found |= aliases(below, f"{path}[]." if several else slot.below(prefix))
    return found
