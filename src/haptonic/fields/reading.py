"""From the tables of a file to the shape of the values that they describe."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from haptonic.fields.keys import is_described, slots


def arranged(kind: type, given: Mapping[str, Any], top: dict[str, Any] | None = None) -> dict[str, Any]:
    """What a file gives for a described class, in the shape of the values: every key at the value it is of.

    Parameters
    ----------
    given : the table; values that were made already are left as they are
    top : the outermost table, from which keys are taken; by default ``given`` itself
    """
    own = dict(given)
    top = own if top is None else top
    for slot in slots(kind):
        for below in slot.kinds:
            value = own.get(slot.key)
            if is_described(value):
                continue
            moved = {one.key: top.pop(one.key) for one in slots(below) if one.placed.top and one.key in top}
            if slot.placed.inline:
                keys = [one.key for one in slots(below) if one.key in own]
                if keys or top is not own:
                    own[slot.key] = {key: own.pop(key) for key in keys}
            elif isinstance(value, Mapping):
                own[slot.key] = arranged(below, {**moved, **value}, top)
            elif isinstance(value, list | tuple):
                own[slot.key] = [
                    arranged(below, one, top) if isinstance(one, Mapping) else one for one in value
                ]
    return own
