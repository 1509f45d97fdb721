"""The table of a study with the name of an analysis; its keys are settings of the study, not options."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from haptonic.errors import shown
from haptonic.fields import table
from haptonic.study.schema import Description


def settings_of(name: str) -> list[str]:
    """Keys of the study's table with the name of an analysis; empty without such a table."""
    keys = table(Description)
    for start in (f"{name}.", f"{name}[]."):
        paths = [path.removeprefix(start) for path in keys if path.startswith(start)]
        if paths:
            return [key for key in paths if "." not in key]
    return []


def example_of(name: str, keys: Sequence[str], values: Mapping[str, object] = MappingProxyType({})) -> str:
    """Python code that sets such a table; ``values`` are given values of some of its keys."""
    several = f"{name}[].{keys[0]}" in table(Description)
    shown_values = [shown(values[key]).replace("'", '"') if key in values else "..." for key in keys]
    inner = "{" + ", ".join(f'"{key}": {value}' for key, value in zip(keys, shown_values, strict=True)) + "}"
    return f"haptonic.Study(..., {name}={f'[{inner}]' if several else inner})"
