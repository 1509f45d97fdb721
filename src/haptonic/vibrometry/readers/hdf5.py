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

import h5py
import numpy as np

from haptonic.errors import ScanError
from haptonic.hdf5 import written
from haptonic.vibrometry.findings import Notebook
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
            with h5py.File(self.path, "r") as file:
                reference, response = file["reference"], file["response"]
                drive = reference[:] if reference.shape[0] == 1 else reference[start:stop]
                return np.asarray(drive), np.asarray(response[start:stop])
        except (OSError, KeyError) as error:
            raise _foreign(self.path, "samples that cannot be read") from error


def write_records(scan: TimeScan, path: Path) -> None:
    """Write time records in haptonic's layout. `haptonic.store.write_atomically` makes the file whole."""
    with written(path) as raw, h5py.File(raw, "w") as file:
        file.attrs.update(
            kind=KIND, form=FORM, sample_rate=scan.sample_rate, motion=scan.motion, reference=scan.reference,
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
        with h5py.File(path, "r") as file:
            notes_of = dict(file.attrs)
            if notes_of.get("kind") != KIND:
                raise _foreign(path, "an HDF5 file of another kind")
            if int(notes_of["form"]) > FORM:
                raise _foreign(path, f"form {notes_of['form']}, from a later haptonic")
            shape, measured = file["response"].shape, int(file["response"].attrs.get("measured", -1))
            driven = file["reference"].shape
            if len(shape) != 3 or driven[1:] != shape[1:] or driven[0] not in (1, shape[0]):
                raise _foreign(path, f"a response of shape {shape} and a reference of shape {driven}")
            names = tuple(file["name"].asstr()[:]) if "name" in file else tuple(map(str, range(shape[0])))
            x, y = np.asarray(file["x"][:], float), np.asarray(file["y"][:], float)
            scan = TimeScan(
                _FromFile(path), names, x, y, shape[1], shape[2],
                float(notes_of["sample_rate"]), str(notes_of["reference"]),
                motion=_motion(str(notes_of["motion"]), path),
                reference_scale=float(notes_of["reference_scale"]),
                response_scale=float(notes_of["response_scale"]),
                full_scale=float(notes_of["full_scale"]) if "full_scale" in notes_of else None,
                direction=str(notes_of["direction"]),
                start=float(notes_of["start"]),
                origin="simulated" if notes_of["origin"] == "simulated" else "measured",
                title=str(notes_of["title"]),
            )  # fmt: skip
    except ScanError:
        raise
    except (OSError, KeyError, ValueError, TypeError) as error:
        raise _foreign(path, f"a part is missing or damaged ({type(error).__name__})") from error
    if 0 <= measured < len(names):
        for name in names[measured:]:
            notes.drop(f"point {name}", "the scan stopped before it")
        if measured == 0:
            raise _foreign(path, "no point was measured")
        return replace(scan, names=names[:measured], x=x[:measured], y=y[:measured])
    return scan


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
