"""Time records in HDF5: haptonic's own layout, written and read.

::

    /                       attributes: kind "haptonic time records", form 1, sample_rate (Hz), motion,
                            reference ("A1, V"), reference_scale, response_scale (SI units of one stored
                            unit), direction, start (s), origin, title, and full_scale (stored units) if known
    /x, /y                  (point,) m
    /name                   (point,) text
    /response               (point, repeat, sample) integers or floats
    /reference              the same, or one point only when all points share the reference

An attribute ``measured`` of ``/response`` counts the points that were written, from the first on; so a file
that a stopped scan left is readable.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import h5py
import numpy as np

from haptonic.errors import ScanError
from haptonic.foreign.process import ForeignError, ask
from haptonic.hdf5 import written
from haptonic.response import Reference
from haptonic.vibrometry.findings import ELSEWHERE, Notebook
from haptonic.vibrometry.labels import ORDER, Motion
from haptonic.vibrometry.records import Samples, TimeScan

KIND = "haptonic time records"
FORM = 1
PORTION = 64  # points that are copied at a time


@dataclass(frozen=True, eq=False)
class _FromFile:
    path: Path

    def load(self, start: int, stop: int) -> tuple[Samples, Samples]:
        try:
            drive, moved = ask(
                "hdf5.rows", self.path, names=["reference", "response"], start=start, stop=stop
            )
        except ForeignError as error:
            raise _foreign(self.path, f"samples that cannot be read ({error})") from error
        return drive, moved


def write_records(scan: TimeScan, path: Path) -> None:
    """Write time records in haptonic's layout. `haptonic.store.write_atomically` makes the file whole."""
    with written(path) as raw, h5py.File(raw, "w") as file:
        file.attrs.update(
            kind=KIND, form=FORM, sample_rate=scan.sample_rate, motion=scan.motion,
            reference=str(scan.reference),
            reference_scale=scan.reference_scale, response_scale=scan.response_scale,
            direction=scan.direction, start=scan.start, origin=scan.origin, title=scan.title,
        )  # fmt: skip
        if scan.full_scale is not None:
            file.attrs["full_scale"] = scan.full_scale
        file["x"], file["y"], file["name"] = scan.x, scan.y, list(scan.names)
        for first, reference, response in scan.chunks(PORTION):
            if first == 0:
                shape = (len(scan.names), *response.shape[1:])
                shared = len(reference) == 1 < len(response)
                file.create_dataset("response", shape, response.dtype)
                file.create_dataset("reference", (1, *shape[1:]) if shared else shape, reference.dtype)
            if len(reference) == len(response) or first == 0:
                file["reference"][first : first + len(reference)] = reference
            file["response"][first : first + len(response)] = response
        file["response"].attrs["measured"] = len(scan.names)


def read_records(path: Path, notes: Notebook) -> TimeScan:
    """Time records that `write_records` or an instrument's program wrote in this layout.

    Raises
    ------
    ScanError : another layout, or no point was measured
    """
    try:
        content = ask("hdf5.tree", path, deep=False)
        says, sets = content["attributes"], content["sets"]
        if says.get("kind") != KIND:
            raise _foreign(path, "an HDF5 file of another kind")
        if int(says["form"]) > FORM:
            raise _foreign(path, f"form {says['form']}, from a later haptonic")
        elsewhere = [
            name for name in ("x", "y", "name", "response", "reference") if name in content["elsewhere"]
        ]
        if elsewhere:
            raise _foreign(path, f"{elsewhere[0]}: {ELSEWHERE}")
        shape, driven = sets["response"]["shape"], sets["reference"]["shape"]
        measured = int(sets["response"]["attributes"].get("measured", -1))
        if len(shape) != 3 or driven[1:] != shape[1:] or driven[0] not in (1, shape[0]):
            raise _foreign(path, f"a response of shape {shape} and a reference of shape {driven}")
        if {sets[name]["kind"] for name in ("response", "reference", "x", "y")} != {"number"}:
            raise _foreign(path, "text or complex numbers where it should have real ones")
        if not sets["x"]["shape"] == sets["y"]["shape"] == shape[:1]:
            raise _foreign(path, f"{shape[0]} points, and places of other points")
        x, y = (np.asarray(one, float) for one in ask("hdf5.read", path, names=["x", "y"]))
        names = tuple(_names(path, sets, shape[0]))
        scan = TimeScan(
            _FromFile(path), names, x, y, shape[1], shape[2],
            float(says["sample_rate"]), Reference.parse(str(says["reference"])),
            motion=_motion(str(says["motion"]), path),
            reference_scale=float(says["reference_scale"]),
            response_scale=float(says["response_scale"]),
            full_scale=float(says["full_scale"]) if "full_scale" in says else None,
            direction=str(says["direction"]),
            start=float(says["start"]),
            origin="simulated" if says["origin"] == "simulated" else "measured",
            title=str(says["title"]),
        )  # fmt: skip
    except (ForeignError, KeyError, ValueError, TypeError) as error:
        found = error if isinstance(error, ForeignError) else type(error).__name__
        raise _foreign(path, f"a part is missing or damaged ({found})") from error
    if 0 <= measured < len(names):
        for name in names[measured:]:
            notes.drop(f"point {name}", "the scan stopped before it")
        if measured == 0:
            raise _foreign(path, "no point was measured")
        return replace(scan, names=names[:measured], x=x[:measured], y=y[:measured])
    return scan


def _names(path: Path, sets: dict[str, Any], count: int) -> list[str]:
    """Of the points, as they are numbered where the file has none."""
    if "name" not in sets:
        return [str(number) for number in range(count)]
    names = ask("hdf5.read", path, names=["name"])[0]
    return [str(name) for name in names]


def _motion(word: str, path: Path) -> Motion:
    for known in ORDER:
        if word == known:
            return known
    raise _foreign(path, f'the motion "{word}"')


def _foreign(path: Path, found: str) -> ScanError:
    return ScanError(
        argument="file of time records",
        given=f"{path}: {found}",
        allowed='an HDF5 file in haptonic\'s layout of time records, kind "haptonic time records"',
        cause="the file is of another program, or its copy was interrupted",
        next_step="write it with haptonic.vibrometry.write_records, which documents the layout",
    )
