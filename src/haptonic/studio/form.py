"""Declarations of all keys of the study, in plain values for the form of the page."""

from __future__ import annotations

from functools import cache
from typing import Any

from haptonic.fields.keys import Key, table
from haptonic.study import Study


@cache
def form() -> list[dict[str, Any]]:
    """All keys in the order of their declaration; ``sweep[].from`` is a key of every [[sweep]]."""
    return [_plain(key) for key in table(Study).values()]


def _plain(key: Key) -> dict[str, Any]:
    return {
        "path": key.path,
        "title": key.title,
        "kind": key.kind,
        "unit": key.unit,
        "default": key.default_text,
        "required": key.required and not key.is_alternative,
        "bounds": key.bounds,
        "typical": key.typical,
        "help": key.description,
        "names": list(key.known_names),
        # a name that the list does not contain may be allowed too, such as that of a material in capitals
        "closed": bool(key.choices),
        "numbers": list(key.numbers),
        "count": key.count,
        "example": key.example or (key.quantity.example.strip('"') if key.quantity and key.unit else ""),
    }
