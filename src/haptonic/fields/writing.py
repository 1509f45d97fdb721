"""Writing a study as the text of a study file."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from haptonic.fields.entries import Entries
from haptonic.fields.expressions import PARAMETERS, ExpressedNumber, Scope
from haptonic.fields.keys import declared_entry, is_described, slots
from haptonic.fields.quantity import Quantity
from haptonic.units import format_quantity


def toml_of(model: object) -> str:
    """TOML that reads back to an equal value, with all values and defaults to full precision.

    A number that was given by an expression is written as this expression if it still has the same value.
    """
    scope = parameters_of(model)

    def leaf(value: Any, unit: str) -> str:
        if isinstance(value, ExpressedNumber) and scope.contains(value):
            return _value(value.text, "")
        return _value(value, unit)

    return "\n".join(_lines(document(model, leaf), "")).strip() + "\n"


def parameters_of(model: object) -> Scope:
    """The named parameters of a study, in which its expressions have values."""
    named = next((slot.name for slot in slots(type(model)) if slot.key == PARAMETERS), "")
    return Scope(getattr(model, named) if named else {})


Leaf = Callable[[Any, str], Any]


def document(
    model: object, leaf: Leaf, *, absent: bool = False, top: dict[str, Any] | None = None
) -> dict[str, Any]:
    """A described value as nested tables and lists by the keys of a file.

    Parameters
    ----------
    leaf : converts a value that is not a table, from the value and its SI unit
    absent : True to write None for an absent value; otherwise it is left out
    top : outermost table, for the keys at the top
    """
    result: dict[str, Any] = {}
    top = result if top is None else top

    def of(value: Any, declared: Quantity | None) -> Any:
        return leaf(value, declared.unit if declared else "")

    for slot in slots(type(model)):
        value = getattr(model, slot.name)
        where = top if slot.placed.top else result
        if name := slot.name_of(value):
            where[slot.key] = of(name, None)
        elif is_described(value) and slot.placed.inline:
            result |= document(value, leaf, absent=absent, top=top)
        elif is_described(value):
            where[slot.key] = document(value, leaf, absent=absent, top=top)
        elif isinstance(value, Entries):
            entries = value.items()
            result[slot.key] = {
                name: of(item, declared_entry(model, slot.field, name, item)) for name, item in entries
            }
        elif isinstance(value, tuple):
            result[slot.key] = [
                document(item, leaf, absent=absent, top=top)
                if is_described(item)
                else of(item, slot.quantities[index] if slot.quantities else None)
                for index, item in enumerate(value)
            ]
        elif value is not None or absent:
            result[slot.key] = of(value, slot.declared(model, value))
    return result


def _lines(tables: Mapping[str, Any], prefix: str) -> Iterator[str]:
    """Lines of a table: plain keys first, because TOML has no way back from a table to its parent."""
    for key, value in tables.items():
        if isinstance(value, list) and value and isinstance(value[0], str):
            yield f"{_name(key)} = [{', '.join(value)}]"
        elif isinstance(value, str):
            yield f"{_name(key)} = {value}"
    for key, value in tables.items():
        path = f"{prefix}{_name(key)}"
        if isinstance(value, dict):
            below = list(_lines(value, f"{path}."))
            yield from ("", f"[{path}]", *below) if below else ()
        elif isinstance(value, list) and value and not isinstance(value[0], str):
            for item in value:
                yield from ("", f"[[{path}]]", *_lines(item, f"{path}."))


def _name(entry: str) -> str:
    """A key in the syntax of TOML."""
    return entry if re.fullmatch(r"[A-Za-z0-9_-]+", entry) else _value(entry, "")


def _value(value: Any, unit: str) -> str:
    if isinstance(value, str):
        lines = value.split("\n")
        if len(lines) > 1 and all(line.isprintable() and not set(line) & set('"\\') for line in lines):
            return f'"""\n{value}"""'  # keeps the lines of a map
        # a JSON string is a TOML string, except for one control character that TOML wants escaped
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, bool):
        return str(value).lower()
    return f'"{format_quantity(value, unit, digits=None)}"' if unit else repr(value)
