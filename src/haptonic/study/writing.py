"""A study as the text of a study file."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from pydantic import BaseModel

from haptonic.study.keys import quantity_of
from haptonic.units import format_quantity


def toml_of(model: BaseModel) -> str:
    """TOML that reads back to an equal model: every value, also the defaults, with all its digits."""
    return "\n".join(_lines(model, "")).strip() + "\n"


def _lines(model: BaseModel, prefix: str) -> Iterator[str]:
    """Plain keys first, then tables: TOML has no way back from a table to the keys of its parent."""
    fields = [
        (field.alias or name, getattr(model, name), quantity_of(field))
        for name, field in type(model).model_fields.items()
    ]
    for name, value, quantity in fields:
        if value is not None and not isinstance(value, BaseModel | tuple):
            unit = (
                quantity.unit if quantity else getattr(model, "unit", "") if isinstance(value, float) else ""
            )
            yield f"{name} = {_value(value, unit)}"
    for name, value, _ in fields:
        path = f"{prefix}{name}"
        if isinstance(value, BaseModel):
            below = list(_lines(value, f"{path}."))
            yield from ("", f"[{path}]", *below) if below else ()
        elif isinstance(value, tuple):
            for item in value:
                yield from ("", f"[[{path}]]", *_lines(item, f"{path}."))


def _value(value: Any, unit: str) -> str:
    if isinstance(value, str):
        # a JSON string is a TOML string, but for one control character that TOML wants escaped
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    return f'"{format_quantity(value, unit, digits=None)}"' if unit else repr(value)
