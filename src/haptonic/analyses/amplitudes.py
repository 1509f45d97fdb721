"""Amplitudes of vibration of the waveguides, from `haptonic feel` or from a user's file."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from haptonic.errors import FrictionError, ResourceError, shown
from haptonic.gate import json_from
from haptonic.paths import source, unread


def read_amplitudes(given: str | Path) -> dict[str, float]:
    """Amplitudes of vibration, m, by waveguide.

    Raises
    ------
    ResourceError : the file cannot be read
    FrictionError : the file contains something else
    """
    path = source(given, "--from")
    try:
        values: Any = json_from(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise unread(
            ResourceError,
            error,
            argument="--from",
            given=path,
            allowed='a JSON file such as {"WG1": 1e-6, "WG2": 3e-7}',
            cause="the file cannot be read, or it is not JSON",
            next_step="write the file again",
        ) from None
    if isinstance(values, dict) and isinstance(values.get("regions"), dict):  # the output of `haptonic feel`
        values = {name: region.get("amplitude_m") for name, region in values["regions"].items()}
    numbers = isinstance(values, dict) and all(
        isinstance(value, int | float) and not isinstance(value, bool) for value in values.values()
    )
    if not numbers or not values:
        raise FrictionError.malformed(
            argument="--from",
            given=shown(values),
            allowed='amplitudes in m by waveguide, such as {"WG1": 1e-6, "WG2": 3e-7}',
            cause="the file is of another kind, or a number is written as text",
            next_step="write a number of metres for each waveguide",
        )
    return {str(name): float(value) for name, value in values.items()}
