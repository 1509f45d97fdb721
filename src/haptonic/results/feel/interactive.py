"""Interactive view of friction under a finger: amplitudes at every place, and both models as tables."""

from __future__ import annotations

from importlib.metadata import version
from typing import TYPE_CHECKING, Any

import numpy as np

from haptonic import plots
from haptonic.fields import table
from haptonic.fields.keys import Key
from haptonic.friction.lubrication import WEBER_FRACTION
from haptonic.friction.lubrication.prediction import VALID
from haptonic.friction.lubrication.settings import TouchSettings
from haptonic.friction.lubrication.tables import friction_tables
from haptonic.plate.layout.drawing import drawing_of
from haptonic.plate.layout.parts import Force
from haptonic.units import format_quantity
from haptonic.views import InteractiveView

if TYPE_CHECKING:
    from haptonic.results.feel.value import Feel

COUNT = 13  # forces and speeds of a slider, about evenly spaced in their logarithm
COLOURS = 256


def feel_view(result: Feel) -> InteractiveView:
    """View of the finger on the plate.

    ``amplitude`` (load, point) is in m for a unit of the drive. ``load_sharing`` and ``intermittent`` are
    those of `friction_tables` for the usual forces and speeds and those of the study.
    """
    friction = result.friction
    touch, loaded = friction.touch, friction.loaded
    keys = table(TouchSettings)
    forces, speeds = (_steps(keys[name], getattr(touch, name)) for name in ("force", "speed"))
    data = friction_tables(touch, friction.skin, forces, speeds)
    for name in ("load_sharing", "intermittent"):
        data[name] = data[name].astype(np.float32)
    for name in ("force", "speed"):
        data[name].attrs["long_name"] = keys[name].title
    data["amplitude"] = loaded["amplitude"].astype(np.float32)
    data["amplitude"].attrs["long_name"] = "root mean square below the finger, for a unit of the drive"
    data.attrs = {"origin": "simulated", "haptonic_version": version("haptonic")}
    return InteractiveView(kind="finger", title=result.title, dataset=data, extra=_extra(result))


def _steps(key: Key, value: float) -> list[float]:
    """Values of a slider within the usual range of a key and the study's own."""
    return sorted({*np.geomspace(*_usual(key), COUNT).tolist(), value})


def _usual(key: Key) -> tuple[float, float]:
    assert key.quantity is not None
    assert key.quantity.typical is not None
    return key.quantity.typical


def _extra(result: Feel) -> dict[str, Any]:
    friction = result.friction
    drive = table(TouchSettings)["voltage"] if friction.unit == "V" else table(Force)["force"]
    low, high = _usual(drive)
    parameters = [
        {
            "title": assumption["title"],
            "value": format_quantity(assumption["value"], assumption["unit"]),
            "plausible": " to ".join(
                format_quantity(end, assumption["unit"]) for end in assumption["plausible"]
            ),
            "mark": assumption["mark"],
            "source": assumption["source"],
        }
        for assumption in friction.skin.assumptions().values()
    ]
    return {
        "summary": result.summary(),
        "colours": plots.shades(COLOURS),
        "weber": WEBER_FRACTION,
        "frequency": friction.frequency,
        "diameter": result.pad.diameter,
        "drive": {
            "title": drive.title, "unit": friction.unit, "value": friction.drive,
            "low": min(low, friction.drive), "high": max(high, friction.drive),
        },
        "force": friction.touch.force,
        "speed": friction.touch.speed,
        "parameters": parameters,
        "models": {name.replace("_", " "): words for name, words in VALID.items()},
        **drawing_of(result.plate),
    }  # fmt: skip
