"""The table of a study that is called like an analysis: settings, which are no options of the analysis."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from haptonic.errors import shown
from haptonic.fields import table
from haptonic.study.schema import Description


def settings_of(name: str) -> list[str]:
    """Keys of the table of the study that is called like an analysis; none where there is no such table."""
    keys = table(Description)
    for start in (f"{name}.", f"{name}[]."):
        found = [path.removeprefix(start) for path in keys if path.startswith(start)]
        if found:
            return [key for key in found if "." not in key]
    return []


def example_of(name: str, keys: Sequence[str], values: Mapping[str, object] = MappingProxyType({})) -> str:
    """How Python gives such a table; ``values`` are those of some of its keys, as a person wrote them."""
    several = f"{name}[].{keys[0]}" in table(Description)
    inner = f"{{{', '.join(f'{chr(34)}{key}{chr(34)}: {_written(key, values)}' for key in keys)}}}"
    return f"haptonic.Study(..., {name}={f'[{inner}]' if several else inner})"


def _written(key: str, values: Mapping[str, object]) -> str:
    return shown(values[key]).replace("'", '"') if key in values else "..."
