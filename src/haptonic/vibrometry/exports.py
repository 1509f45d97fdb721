"""Scans in the forms of other programs: MATLAB, TDMS, folders of CSV.

Records are written a few points at a time. Every file says whether it is measured or simulated.
"""

from __future__ import annotations

import csv
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

import h5py
import numpy as np
import scipy.io

from haptonic import hdf5
from haptonic.names import cell
from haptonic.response import FrequencyResponse
from haptonic.vibrometry.labels import UNITS
from haptonic.vibrometry.readers.folder import GEOMETRY
from haptonic.vibrometry.readers.tables import ORIGIN
from haptonic.vibrometry.readers.tdms import nptdms_for
from haptonic.vibrometry.records import TimeScan, portions

HEADER = b"MATLAB 7.3 MAT-file, written by haptonic"
USER_BLOCK = 512  # bytes before the HDF5 part of a MATLAB file


def write_mat(response: FrequencyResponse, path: Path) -> None:
    """A response as MATLAB variables (version 5): response (line, point), frequency, x, y, coherence."""
    notes, data = response.dataset.attrs, response.dataset
    content = {
        "response": response.values[:, :, 0], "frequency": response.frequency, "x": data["x"].values,
        "y": data["y"].values, "unit": response.units, ORIGIN: notes["origin"],
    }  # fmt: skip
    if "coherence" in data:
        content["coherence"] = data["coherence"].values
    scipy.io.savemat(path, content, appendmat=False)


def write_mat_records(scan: TimeScan, path: Path) -> None:
    """Records as MATLAB variables (version 7.3): response and reference (point, repeat, sample) in SI units,
    single precision, sample_rate, x, y."""
    shape = (scan.samples, scan.repeats, len(scan.names))  # MATLAB's axes run the other way in HDF5
    with hdf5.written(path) as raw, h5py.File(raw, "w", userblock_size=USER_BLOCK) as file:
        for name, values in (("x", scan.x), ("y", scan.y), ("sample_rate", np.array([scan.sample_rate]))):
            file[name] = values[:, None]
            file[name].attrs["MATLAB_class"] = np.bytes_("double")
        text = np.frombuffer(scan.origin.encode("utf-16-le"), np.uint16)
        file[ORIGIN] = text[:, None]
        file[ORIGIN].attrs["MATLAB_class"] = np.bytes_("char")
        file[ORIGIN].attrs["MATLAB_int_decode"] = np.int32(2)
        for first, reference, response in portions(scan):
            for name, rows in (("reference", reference), ("response", response)):
                if first == 0:
                    whole = shape if len(rows) == len(response) else (*shape[:2], 1)
                    file.create_dataset(name, whole, np.float32, chunks=(*shape[:2], 1))
                    file[name].attrs["MATLAB_class"] = np.bytes_("single")
                if first == 0 or file[name].shape[2] > 1:
                    file[name][..., first : first + len(rows)] = rows.T
    with path.open("rb+") as again:
        again.write(HEADER.ljust(124) + b"\x00\x02IM")


def write_tdms(scan: TimeScan, path: Path) -> None:
    """Records as TDMS: a group for each point with its place, a channel of the response and one of the
    reference, the repeats behind each other. It needs the package npTDMS."""
    nptdms = nptdms_for(path)
    unit = UNITS[scan.motion]
    timing = {"wf_increment": 1 / scan.sample_rate, "wf_start_offset": scan.start}
    driving = scan.reference.unit or "V"
    with nptdms.TdmsWriter(path) as file:
        file.write_segment([nptdms.RootObject({ORIGIN: scan.origin, "title": scan.title})])
        for first, reference, response in portions(scan):
            parts = []
            for row, moved in enumerate(response):
                name, i = scan.names[first + row], first + row
                driven = reference[min(row, len(reference) - 1)]
                parts += [
                    nptdms.GroupObject(name, {"x": float(scan.x[i]), "y": float(scan.y[i])}),
                    nptdms.ChannelObject(name, "response", moved.ravel(), {"unit_string": unit, **timing}),
                    nptdms.ChannelObject(
                        name, "reference", driven.ravel(), {"unit_string": driving, **timing}
                    ),
                ]
            file.write_segment(parts)


def csv_files(response: FrequencyResponse) -> dict[str, Callable[[Path], object]]:
    """Writers of ``geometry.csv`` and of one file of frequency, real and imaginary part for each point."""
    origin, places = str(response.dataset.attrs["origin"]), response.points
    digits = len(str(len(places)))
    names = [f"point-{i + 1:0{digits}d}.csv" for i in range(len(places))]
    rows = [[name, f"{x:.9g}", f"{y:.9g}", origin] for name, (x, y) in zip(names, places, strict=True)]
    found: dict[str, Callable[[Path], object]] = {
        name: partial(_write_point, response, i) for i, name in enumerate(names)
    }
    return found | {GEOMETRY: partial(_write_rows, [["file", "x", "y", ORIGIN], *rows])}


def _write_point(response: FrequencyResponse, point: int, path: Path) -> None:
    values = response.values[:, point, 0].astype(np.complex128)
    heads = ["frequency (Hz)", f"real ({response.units})", f"imaginary ({response.units})"]
    columns = [response.frequency, values.real, values.imag]
    if "coherence" in response.dataset:
        heads.append("coherence")
        columns.append(response.dataset["coherence"].values[:, point])
    _write_rows([heads, *([f"{v:.9g}" for v in row] for row in zip(*columns, strict=True))], path)


def _write_rows(rows: Sequence[Sequence[str]], path: Path) -> None:
    with path.open("w", newline="", encoding="utf-8") as text:
        csv.writer(text).writerows([cell(one) for one in row] for row in rows)
