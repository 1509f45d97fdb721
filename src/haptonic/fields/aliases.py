"""Names that users write instead of a key, and names without a key, each with advice.

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
    """A name that is refused with its reason; ``key`` is the intended key, if there is one."""

    cause: str
    next_step: str
    key: str = ""


Aliases = Mapping[str, Alias]


def meant(key: str, *names: str, cause: str = "", next_step: str = "") -> dict[str, Alias]:
    """Other names of a key of the same table."""
    return {
        name: Alias(cause or f'the name of this key is "{key}"', next_step or f'write "{key}"', key)
        for name in names
    }


def absent(*names: str, cause: str, next_step: str) -> dict[str, Alias]:
    """Names without a key in the same table, with the reason."""
    return {name: Alias(cause, next_step) for name in names}


@cache
def aliases(kind: type, prefix: str = "") -> dict[str, Alias]:
    """Aliases of a described class and of the tables in it, by path as in `haptonic.fields.table`."""
    by_path = {f"{prefix}{name}": alias for name, alias in getattr(kind, "aliases", {}).items()}
    keys = table(kind, prefix)
    for slot in slots(kind):
        path = slot.path(prefix)
        several = path in keys and keys[path].kind == "tables"
        for below in slot.kinds:
            by_path |= aliases(below, f"{path}[]." if several else slot.below(prefix))
    return by_path
