"""JSON schema (draft 7) of a file, for editors, from the declarations.

It contains keys, choices, bounds of plain numbers and required keys. It does not check the unit and bounds of
quantities, nor conditions between values; `haptonic.fields.reading` does.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, get_args

import annotated_types

from haptonic.fields.keys import Key, Slot, metadata_of, slots, table
from haptonic.fields.quantity import AnyUnit, Quantity

DRAFT = "http://json-schema.org/draft-07/schema#"
WITH_UNIT = r"^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?\s*[A-Za-zµ\u03bc]"  # `haptonic.units` is stricter
UNIT = r"[µum]?[msVN]|k[mVN]|n[msF]|[µu]?F|[kMGT]?(?:Hz|Pa)|kg|rad"  # alone it is no expression
# `haptonic.fields.grammar` is stricter
EXPRESSION = rf"^(?!\s*(?:{UNIT})\s*$)\s*[A-Za-z_(]|[*/()]|[0-9.A-Za-z]\s*[+-]"
ZERO = [{"enum": [0]}, {"type": "string", "pattern": r"^\s*[+-]?[0.]+\s*$"}]  # zero needs no unit

Schema = dict[str, Any]


def json_schema(kind: type, title: str) -> Schema:
    """Schema of the file that describes a class."""
    return {"$schema": DRAFT, "title": title, **_table(kind, "", table(kind))}


def _table(kind: type, prefix: str, keys: dict[str, Key]) -> Schema:
    """Schema of the keys of a described class below ``prefix``, without those at the top of the file."""
    properties, required = dict[str, Schema](), list[str]()
    for slot, path in _own_keys(kind, prefix):
        properties[slot.key] = _slot(slot, path, keys)
        if slot.field.is_required():
            required.append(slot.key)
    schema: Schema = {"type": "object", "properties": properties, "additionalProperties": False}
    return schema | ({"required": list(dict.fromkeys(required))} if required else {})


def _own_keys(kind: type, prefix: str) -> Iterator[tuple[Slot, str]]:
    """Fields whose keys are in this table itself, and their paths."""
    for slot in slots(kind):
        if slot.placed.inline:
            for below in slot.kinds:
                yield from _own_keys(below, prefix)
        elif not slot.placed.top:
            yield slot, slot.path(prefix)
        if not prefix:
            yield from ((inner, inner.key) for below in slot.kinds for inner in _at_top(below))


def _at_top(kind: type) -> Iterator[Slot]:
    """Fields of a class, and of those in it, whose keys are at the top of the file."""
    for slot in slots(kind):
        if slot.placed.top:
            yield slot
        yield from (inner for below in slot.kinds for inner in _at_top(below))


def _slot(slot: Slot, path: str, keys: dict[str, Key]) -> Schema:
    key = keys[path]
    about: Schema = {"title": key.title, "description": _described(key)}
    if key.example and key.kind not in {"quantities", "entries"}:
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
            each = [_quantity(quantity) for quantity in slot.quantities]
            return about | {"type": "array", "items": each, "minItems": len(each), "maxItems": len(each)}
        case "entries":
            (value,) = get_args(slot.field.annotation)
            quantity = slot.quantities[0] if slot.quantities else None
            inner: Schema = _quantity(quantity) if quantity else {} if value is float else {"type": "string"}
            if any(isinstance(mark, AnyUnit) for mark in metadata_of(slot.field)):
                inner = {"type": ["string", "number"]}
            # TOML reads a path without quotes as nested tables
            return about | {"type": "object", "additionalProperties": inner if value is not float else True}
    return about | _plain(slot, key) | ({"default": _default(key)} if key.default else {})


def _tabled(slot: Slot, key: Key, keys: dict[str, Key]) -> Schema:
    tables = [_table(below, f"{key.path}.", keys) for below in slot.kinds]
    return {"anyOf": [*_names(key), *tables]} if key.named else tables[0]


def _names(key: Key) -> list[Schema]:
    """Schemas of a name, of which the case of letters and blanks do not matter."""
    spelt = [
        "".join(
            f"[{letter}{letter.upper()}]" if letter.isalpha() else letter.replace("-", r"[\s_-]+")
            for letter in name
        )
        for name in key.known_names
    ]
    return [
        {"enum": list(key.known_names)},
        {"type": "string", "pattern": rf"^\s*({'|'.join(spelt)})\s*$"},
    ]


def _plain(slot: Slot, key: Key) -> Schema:
    """Schema of a value that is neither a table nor a list."""
    if key.choices:
        return {"enum": [*key.choices, *key.synonyms]}
    if key.quantity:
        return _quantity(key.quantity)
    kinds: dict[str, Schema] = {
        "integer": {"type": "integer"} | _limits(slot, "imum"),
        "boolean": {"type": "boolean"},
        "text": {"type": "string"} | _limits(slot, "Length"),
    }
    return kinds.get(key.kind, {"type": ["number", "string"]})


def _quantity(quantity: Quantity) -> Schema:
    """Schema of a text with its unit; without a dimension, of a plain number within its bounds."""
    if quantity.unit:
        given = {
            "type": "string",
            "anyOf": [{"pattern": WITH_UNIT}, {"pattern": EXPRESSION}],
            "examples": [quantity.example.strip('"')],
        }
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
    """Bounds of integers, texts and lists."""
    limits: Schema = {}
    for mark in metadata_of(slot.field):
        match mark:
            case annotated_types.Ge(ge=low) | annotated_types.MinLen(min_length=low):
                limits[f"min{of}"] = low
            case annotated_types.Le(le=high) | annotated_types.MaxLen(max_length=high):
                limits[f"max{of}"] = high
    return limits


def _described(key: Key) -> str:
    more = [key.bounds[:1].upper() + key.bounds[1:], f"Usual: {key.typical}" if key.typical else ""]
    return " ".join([key.description, *(f"{words}." for words in more if words)])


def _default(key: Key) -> Any:
    """The default as in a file."""
    if key.kind == "boolean":
        return key.default_text == "true"
    plain = {"integer": int, "number": float}
    return plain.get(key.kind, str)(key.default_text)
