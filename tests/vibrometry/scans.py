"""Simulated scans, and files of them written by others than haptonic."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pyuff

from haptonic.response import FrequencyResponse

LINES = 100.0 * np.arange(1, 9)
X, Y = (along.ravel() for along in np.meshgrid(np.arange(4) * 2e-3, np.arange(3) * 2e-3))
DATA = Path(__file__).parents[1] / "data" / "uff"


def noise(*shape: int, seed: int = 3):
    chance = np.random.default_rng(seed)
    return chance.normal(size=shape) + 1j * chance.normal(size=shape)


VALUES = noise(8, 12)


def response(**changes) -> FrequencyResponse:
    keywords = {"frequency": LINES, "x": X, "y": Y, "reference": "A1, V", "origin": "measured"} | changes
    values = keywords.pop("response", VALUES[..., None])
    return FrequencyResponse.of(values, **keywords)


def curve(node: int, values, **changes) -> dict:
    """A frequency response as pyuff wants it; velocity per volt along z."""
    return {
        "type": 58, "binary": 0, "func_type": 4, "rsp_node": node, "rsp_dir": 3, "ref_node": 0, "ref_dir": 0,
        "ref_ent_name": "A1", "abscissa_spacing": 1, "abscissa_spec_data_type": 18, "x": LINES,
        "ordinate_spec_data_type": 11, "ordinate_axis_units_lab": "m/s", "orddenom_spec_data_type": 1,
        "orddenom_axis_units_lab": "V", "data": np.array(values),
    } | changes  # fmt: skip


def nodes(scale: float = 1.0, kind: int = 2411, count: int = 12) -> dict:
    zeros = np.zeros(count, dtype=int)
    return {
        "type": kind, "node_nums": np.arange(1, count + 1), "def_cs": zeros, "disp_cs": zeros, "color": zeros,
        "x": scale * X[:count], "y": scale * Y[:count], "z": zeros.astype(float),
    }  # fmt: skip


def units(length: float = 1.0, force: float = 1.0) -> dict:
    return {"type": 164, "units_code": 9, "length": length, "force": force, "temp": 1.0, "temp_offset": 0.0}


def uff(path: Path, *sets: dict) -> Path:
    pyuff.UFF(str(path)).write_sets([dict(data_set) for data_set in sets], "overwrite")
    return path


def whole(path: Path, **changes) -> Path:
    return uff(path, units(), nodes(), *(curve(i + 1, VALUES[:, i], **changes) for i in range(12)))
