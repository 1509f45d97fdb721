"""Frequency responses as universal files (UFF), in ASCII, which most programs read."""

from __future__ import annotations

import importlib
import io
import json
from collections.abc import Iterable, Iterator
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.channels.labels import UNITS
from haptonic.channels.uff import SAYS_SIMULATED
from haptonic.errors import ScanError
from haptonic.response import FrequencyResponse
from haptonic.vibrometry.records import TimeScan, portions

# How pyuff writes a data set to an open file. pyuff.UFF would read the whole file again after each.
SETS: dict[object, Any] = {
    kind: getattr(importlib.import_module(f"pyuff.datasets.dataset_{kind}"), f"_write{kind}")
    for kind in (58, 164, 2411)
}
KIND = {"displacement": 8, "velocity": 11, "acceleration": 12}
UNIT_TYPES = {"N": 13, "Pa": 15}
AXES = {"x": 1, "y": 2, "z": 3}
EVEN = 1e-6  # of the spacing: tolerance for lines written by their first frequency and their spacing


def write_uff(response: FrequencyResponse, path: Path) -> None:
    """Write a response as UFF: units (164), nodes (2411), one function for each point and direction (58).

    Values have twelve digits, frequencies six: the first one and the spacing if they are evenly spaced. The
    origin is in the fifth line of each function, so that a simulation is never taken for a measurement.
    `haptonic.atomic.write_atomically` writes the file completely or not at all.

    Raises
    ------
    ScanError : the file cannot be written
    """
    names = _numbers(response)
    _write(path, chain(_geometry(names, *response.points.T), _functions(response, names)))


def write_uff_records(scan: TimeScan, path: Path) -> None:
    """Write time records as UFF: units (164), nodes (2411), one record (58) for each point and repeat of the
    response and of the reference, a few points at a time; six digits.

    Raises
    ------
    ScanError : the file cannot be written
    """
    numbers = np.arange(1, len(scan.names) + 1)
    _write(path, chain(_geometry(numbers, scan.x, scan.y), _records(scan)))


def _geometry(numbers: NDArray[np.int64], x: Array, y: Array) -> tuple[dict[str, object], dict[str, object]]:
    """Data sets of units and nodes."""
    zeros = np.zeros(len(numbers), dtype=int)
    return (
        {
            "type": 164, "units_code": 1, "units_description": "SI: Meter (newton)", "temp_mode": 2,
            "length": 1.0, "force": 1.0, "temp": 1.0, "temp_offset": 273.15,
        },
        {
            "type": 2411, "node_nums": numbers, "def_cs": zeros, "disp_cs": zeros, "color": zeros,
            "x": x, "y": y, "z": np.zeros(len(numbers)),
        },
    )  # fmt: skip


def _write(path: Path, parts: Iterable[dict[str, object]]) -> None:
    try:
        with path.open("w", encoding="utf-8") as out:
            for part in parts:
                text = io.StringIO()  # pyuff hides the error of a full disk
                SETS[part["type"]](text, part)
                out.write(text.getvalue())
    except OSError as error:
        raise ScanError.unwritable(
            argument="output file",
            given=f"{path} ({error})",
            allowed="a file in a folder that can be written, with room for it",
            cause="the folder does not exist or the disk is full",
            next_step="choose another folder for the output",
        ) from error


def _functions(response: FrequencyResponse, names: NDArray[np.int64]) -> Iterator[dict[str, object]]:
    notes, lines = response.dataset.attrs, response.frequency
    name, unit = response.reference.name, response.reference.unit
    step = np.diff(lines)
    even = len(lines) > 1 and np.ptp(step) <= EVEN * step.mean()
    common: dict[str, object] = {
        "type": 58, "binary": 0, "load_case_id": 0, "rsp_ent_name": "NONE",
        "ref_ent_name": name[:10] or "NONE", "ref_node": 0, "ref_dir": 0,
        "id1": (str(notes["title"]) or "NONE").encode("ascii", "replace").decode()[:80],
        "id4": f"haptonic {notes['haptonic_version']}", "id5": f"origin: {notes['origin']}",
        "abscissa_spacing": int(even), "x": lines, "abscissa_spec_data_type": 18,
        "abscissa_axis_lab": "Frequency", "abscissa_axis_units_lab": "Hz",
    }  # fmt: skip
    assert notes["origin"] != "simulated" or common["id5"] == SAYS_SIMULATED
    motion = str(notes["quantity"])
    for column, direction in enumerate(response.dataset["direction"].values):
        for row, number in enumerate(names):
            yield common | {
                "func_type": 4, "rsp_node": int(number), "rsp_dir": AXES[str(direction)],
                "ordinate_spec_data_type": KIND[motion], "ordinate_axis_lab": motion.capitalize(),
                "ordinate_axis_units_lab": {"velocity": "m/s", "displacement": "m"}[motion],
                "orddenom_spec_data_type": UNIT_TYPES.get(unit, 1 if unit else 0),
                "orddenom_axis_lab": name[:20] or "NONE", "orddenom_axis_units_lab": unit[:20] or "NONE",
                "data": response.values[:, row, column].astype(np.complex128),
            }  # fmt: skip
    if "coherence" in response.dataset:
        coherence = response.dataset["coherence"].values
        for row, number in enumerate(names):
            yield common | {
                "func_type": 6, "rsp_node": int(number), "rsp_dir": 3, "ordinate_spec_data_type": 0,
                "orddenom_spec_data_type": 0, "data": coherence[:, row].astype(float),
            }  # fmt: skip


def _records(scan: TimeScan) -> Iterator[dict[str, object]]:
    name, unit = scan.reference.name, scan.reference.unit
    common: dict[str, object] = {
        "type": 58, "binary": 0, "func_type": 1, "load_case_id": 0, "rsp_ent_name": "NONE",
        "ref_ent_name": "NONE", "ref_node": 0, "ref_dir": 0, "id1": (scan.title or "NONE")[:80],
        "id5": f"origin: {scan.origin}", "abscissa_spacing": 1, "abscissa_spec_data_type": 17,
        "x": scan.start + np.arange(scan.samples) / scan.sample_rate,
        "abscissa_axis_lab": "Time", "abscissa_axis_units_lab": "s", "orddenom_spec_data_type": 0,
    }  # fmt: skip
    moved: dict[str, object] = {
        "rsp_dir": AXES[scan.direction], "ordinate_spec_data_type": KIND[scan.motion],
        "ordinate_axis_lab": scan.motion.capitalize(), "ordinate_axis_units_lab": UNITS[scan.motion],
    }  # fmt: skip
    driven: dict[str, object] = {
        "rsp_dir": 0, "rsp_ent_name": name[:10], "ordinate_spec_data_type": UNIT_TYPES.get(unit, 1),
        "ordinate_axis_lab": name[:20], "ordinate_axis_units_lab": unit or "V",
    }  # fmt: skip
    for first, reference, response in portions(scan):
        for rows, kind in ((reference, driven), (response, moved)):
            if first and len(rows) < len(response):
                continue  # all points share one reference, written with the first
            for row, records in enumerate(rows):
                for record in records:
                    data = record.astype(np.float64)
                    yield common | kind | {"rsp_node": first + row + 1, "data": data}


def _numbers(response: FrequencyResponse) -> NDArray[np.int64]:
    """Numbers of the points: those of the original file, else counted from 1."""
    names = json.loads(response.dataset.attrs["inputs"]).get("points")
    count = response.dataset.sizes["point"]
    if isinstance(names, list) and len(names) == count and all(str(n).isdigit() for n in names):
        numbers = np.array([int(n) for n in names])
        if len(set(names)) == count and numbers.min() > 0:
            return numbers
    return np.arange(1, count + 1)
