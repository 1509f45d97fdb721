"""A study as the text of a study file."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any

from haptonic.fields.entries import Entries
from haptonic.fields.keys import fields_of, is_described, quantities_of, quantity_of, unit_of
from haptonic.units import format_quantity


def toml_of(model: object) -> str:
    """TOML that reads back to an equal value: every value, also the defaults, with all its digits."""
    return "\n".join(_lines(model, "")).strip() + "\n"


def _lines(model: object, prefix: str) -> Iterator[str]:
    """Plain keys first, then tables: TOML has no way back from a table to the keys of its parent."""
    tables = []
    for name, field in fields_of(model).items():
        value, key = getattr(model, name), field.alias or name
        if is_described(value) or isinstance(value, Entries) or _is_tables(value):
            tables.append((key, value, field))
        elif isinstance(value, tuple):
            numbers = zip(value, quantities_of(field), strict=True)
            yield f"{key} = [{', '.join(_value(item, quantity.unit) for item, quantity in numbers)}]"
        elif value is not None:
            quantity = quantity_of(field)
            unit = (
                quantity.unit if quantity else getattr(model, "unit", "") if isinstance(value, float) else ""
            )
            yield f"{key} = {_value(value, unit)}"
    for key, value, field in tables:
        path = f"{prefix}{key}"
        if is_described(value):
            below = list(_lines(value, f"{path}."))
            yield from ("", f"[{path}]", *below) if below else ()
        elif isinstance(value, Entries):
            entries = ((entry, item, unit_of(model, field, entry)) for entry, item in value.items())
            below = [
                f"{_name(entry)} = {_value(item, quantity.unit if quantity else '')}"
                for entry, item, quantity in entries
            ]
            yield from ("", f"[{path}]", *below) if below else ()
        else:
            for item in value:
                yield from ("", f"[[{path}]]", *_lines(item, f"{path}."))


def _is_tables(value: Any) -> bool:
    return isinstance(value, tuple) and all(is_described(item) for item in value)


def _name(entry: str) -> str:
    """A key as TOML wants it."""
    return entry if re.fullmatch(r"[A-Za-z0-9_-]+", entry) else _value(entry, "")


def _value(value: Any, unit: str) -> str:
    if isinstance(value, str):
        lines = value.split("\n")
        if len(lines) > 1 and all(line.isprintable() and not set(line) & set('"\\') for line in lines):
            return f'"""\n{value}"""'  # a map keeps its shape
        # a JSON string is a TOML string, but for one control character that TOML wants escaped
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    return f'"{format_quantity(value, unit, digits=None)}"' if unit else repr(value)
