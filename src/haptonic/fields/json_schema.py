"""The JSON schema of a file, for editors: what the declarations say, in the words of draft 7.

It knows the keys, words, bounds of plain numbers and which keys have to be there. Whether a text is a
quantity of the right kind and within its bounds, and whether values fit together, is told by
`haptonic.fields.reading`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, get_args

import annotated_types

from haptonic.fields.keys import Key, Slot, metadata_of, slots, table
from haptonic.fields.quantity import Quantity

DRAFT = "http://json-schema.org/draft-07/schema#"
WITH_UNIT = r"^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*[A-Za-zµ\u03bc]"  # `haptonic.units` says more
ZERO = [{"enum": [0]}, {"type": "string", "pattern": r"^\s*[+-]?[0.]+\s*$"}]  # which needs no unit

Schema = dict[str, Any]


def json_schema(kind: type, title: str) -> Schema:
    """Of the file that a described class is read from."""
    return {"$schema": DRAFT, "title": title, **_table(kind, "", table(kind))}


def _table(kind: type, prefix: str, keys: dict[str, Key]) -> Schema:
    """Of the keys of a described class below ``prefix``, those at the top of a file left to the top."""
    properties, required = dict[str, Schema](), list[str]()
    for slot, path in _standing_here(kind, prefix):
        properties[slot.key] = _slot(slot, path, keys)
        if slot.field.is_required():
            required.append(slot.key)
    told: Schema = {"type": "object", "properties": properties, "additionalProperties": False}
    return told | ({"required": list(dict.fromkeys(required))} if required else {})


def _standing_here(kind: type, prefix: str) -> Iterator[tuple[Slot, str]]:
    """The fields whose keys stand in this very table, and their paths."""
    for slot in slots(kind):
        if slot.placed.inline:
            for below in slot.kinds:
                yield from _standing_here(below, prefix)
        elif not slot.placed.top:
            yield slot, slot.path(prefix)
        if not prefix:
            yield from ((one, one.key) for below in slot.kinds for one in _from_inside(below))


def _from_inside(kind: type) -> Iterator[Slot]:
    """Fields of a class and of those in it that stand at the top of the file."""
    for slot in slots(kind):
        if slot.placed.top:
            yield slot
        yield from (one for below in slot.kinds for one in _from_inside(below))


def _slot(slot: Slot, path: str, keys: dict[str, Key]) -> Schema:
    key = keys[path]
    about: Schema = {"title": key.title, "description": _described(key)}
    if key.example and key.kind != "quantities":
        about["examples"] = [key.example]
    match key.kind:
        case "table":
            return about | _tabled(slot, key, keys)
        case "tables":
            (below,) = slot.kinds
            return (
                about | {"type": "array", "items": _table(below, f"{path}[].", keys)} | _limits(slot, "Items")
            )
        case "quantities":
            each = [_quantity(one) for one in slot.quantities]
            return about | {"type": "array", "items": each, "minItems": len(each), "maxItems": len(each)}
        case "entries":
            (value,) = get_args(slot.field.annotation)
            quantity = slot.quantities[0] if slot.quantities else None
            inner: Schema = _quantity(quantity) if quantity else {} if value is float else {"type": "string"}
            # a path without quotes is TOML's own tables
            return about | {"type": "object", "additionalProperties": inner if value is not float else True}
    return about | _plain(slot, key) | ({"default": _default(key)} if key.default else {})


def _tabled(slot: Slot, key: Key, keys: dict[str, Key]) -> Schema:
    (below,) = slot.kinds
    inner = _table(below, f"{key.path}.", keys)
    return {"anyOf": [{"enum": list(key.known_names)}, inner]} if key.named else inner


def _plain(slot: Slot, key: Key) -> Schema:
    """Of a value that is no table and no list."""
    if key.choices:
        return {"enum": list(key.choices)}
    if key.named:  # capitals and blanks do not matter in these names, which an editor cannot know
        return {"anyOf": [{"enum": list(key.known_names)}, {"type": "string"}]}
    if key.quantity:
        return _quantity(key.quantity)
    kinds: dict[str, Schema] = {
        "integer": {"type": "integer"} | _limits(slot, "imum"),
        "boolean": {"type": "boolean"},
        "text": {"type": "string"} | _limits(slot, "Length"),
    }
    return kinds.get(key.kind, {"type": ["number", "string"]})


def _quantity(quantity: Quantity) -> Schema:
    """A text with its unit; without a dimension, a plain number within its bounds."""
    if quantity.unit:
        given = {"type": "string", "pattern": WITH_UNIT, "examples": [quantity.example.strip('"')]}
        return {"anyOf": [given, *ZERO]} if quantity.holds(0.0) else given
    bounds = {
        "minimum": quantity.at_least,
        "maximum": quantity.at_most,
        "exclusiveMinimum": quantity.above,
        "exclusiveMaximum": quantity.below,
    }
    finite = {name: end for name, end in bounds.items() if abs(end) != float("inf")}
    return {"anyOf": [{"type": "number", **finite}, {"type": "string"}]}


def _limits(slot: Slot, of: str) -> Schema:
    """Least and most of whole numbers, texts and lists."""
    told: Schema = {}
    for one in metadata_of(slot.field):
        match one:
            case annotated_types.Ge(ge=low) | annotated_types.MinLen(min_length=low):
                told[f"min{of}"] = low
            case annotated_types.Le(le=high) | annotated_types.MaxLen(max_length=high):
                told[f"max{of}"] = high
    return told


def _described(key: Key) -> str:
    more = [key.bounds[:1].upper() + key.bounds[1:], f"Usual: {key.typical}" if key.typical else ""]
    return " ".join([key.description, *(f"{words}." for words in more if words)])


def _default(key: Key) -> Any:
    """As a file would give it."""
    if key.kind == "boolean":
        return key.default_text == "true"
    plain = {"integer": int, "number": float}
    return plain.get(key.kind, str)(key.default_text)
