"""Time records in HDF5, in haptonic's own layout.

::

    /                       attributes: kind "haptonic time records", form 1, sample_rate (Hz), motion,
                            reference ("A1, V"), reference_scale, response_scale (SI units of one stored
                            unit), direction, start (s), origin, title, and full_scale (stored units) if known
    /x, /y                  (point,) m
    /name                   (point,) text
    /response               (point, repeat, sample) integers or floats
    /reference              the same, or a single point if all points share the reference

The attribute ``measured`` of ``/response`` is the number of points written so far, so that the file of a
stopped scan is readable.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from haptonic.channels import Group, Notebook
from haptonic.channels.hdf5 import set_name
from haptonic.channels.labels import ORDER, Motion
from haptonic.channels.notes import ELSEWHERE
from haptonic.channels.signals import SIMULATED
from haptonic.errors import ChannelError, ScanError
from haptonic.hdf5 import written
from haptonic.later import h5py
from haptonic.response import Reference
from haptonic.vibrometry.records import OfChannels, TimeScan

KIND = "haptonic time records"
FORM = 1
PORTION = 64  # points that are copied at a time


def write_records(scan: TimeScan, path: Path) -> None:
    """Write time records in haptonic's layout. `haptonic.atomic.write_atomically` writes a complete file."""
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


def is_records(attributes: Mapping[str, Any]) -> bool:
    """True for attributes of a file written by `write_records`."""
    kind = attributes.get("kind")
    return isinstance(kind, str) and kind == KIND


def read_records(group: Group, notes: Notebook) -> TimeScan:
    """Read time records that `write_records` or an instrument's program wrote in this layout.

    Raises
    ------
    ScanError : another layout, or no point was measured
    """
    path, attributes, sets = notes.path, group.properties, group.channels
    try:
        if not isinstance(attributes["form"], int | float) or attributes["form"] > FORM:
            raise _foreign(path, f"form {attributes['form']}, from a later haptonic")
        dropped = {item.what for item in notes.dropped}
        for name in ("x", "y", "name", "response", "reference"):
            if set_name(name) in dropped:
                raise _foreign(path, f"{name}: {ELSEWHERE}")
        shape, driven = sets["response"].shape, sets["reference"].shape
        if len(shape) != 3 or driven[1:] != shape[1:] or driven[0] not in (1, shape[0]):
            raise _foreign(path, f"a response of shape {shape} and a reference of shape {driven}")
        if {sets[name].kind for name in ("response", "reference", "x", "y")} != {"number"}:
            raise _foreign(path, "text or complex numbers instead of real ones")
        if not sets["x"].shape == sets["y"].shape == shape[:1]:
            raise _foreign(path, f"{shape[0]} points, and places of other points")
        if "name" in sets and (sets["name"].kind, sets["name"].shape) != ("text", shape[:1]):
            raise _foreign(path, f"{shape[0]} points, and names of kind {sets['name'].kind} and shape "
                                 f"{sets['name'].shape}")  # fmt: skip
        names = np.asarray(sets["name"]).ravel() if "name" in sets else range(shape[0])
        x, y = (np.asarray(sets[name], float) for name in "xy")
        measured = int(sets["response"].properties.get("measured", -1))
        scan = TimeScan(
            source=OfChannels(sets["reference"], sets["response"], shape[1], shape[2]),
            names=tuple(str(name) for name in names), x=x, y=y, repeats=shape[1], samples=shape[2],
            sample_rate=float(attributes["sample_rate"]),
            reference=Reference.parse(str(attributes["reference"])),
            motion=_motion(str(attributes["motion"]), path),
            reference_scale=float(attributes["reference_scale"]),
            response_scale=float(attributes["response_scale"]),
            full_scale=float(attributes["full_scale"]) if "full_scale" in attributes else None,
            direction=str(attributes["direction"]),
            start=float(attributes["start"]),
            origin=SIMULATED if attributes["origin"] == SIMULATED else "measured",
            title=str(attributes["title"]),
        )  # fmt: skip
    except (ChannelError, KeyError, ValueError, TypeError, OverflowError) as error:
        reason = error.given if isinstance(error, ChannelError) else type(error).__name__
        raise _foreign(path, f"a part is missing or damaged ({reason})") from error
    if not 0 <= measured < len(scan.names):
        return scan
    for name in scan.names[measured:]:
        notes.drop(f"point {name}", "the scan stopped before it")
    if measured == 0:
        raise _foreign(path, "no point was measured")
    return replace(scan, names=scan.names[:measured], x=x[:measured], y=y[:measured])


def _motion(word: str, path: Path) -> Motion:
    for motion in ORDER:
        if word == motion:
            return motion
    raise _foreign(path, f'the motion "{word}"')


def _foreign(path: Path, given: str) -> ScanError:
    return ScanError.unreadable(
        argument="file of time records",
        given=f"{path}: {given}",
        allowed='an HDF5 file in haptonic\'s layout of time records, kind "haptonic time records"',
        cause="another program wrote the file, or its copy was interrupted",
        next_step="write it with haptonic.vibrometry.write_records, which documents the layout",
    )
