"""Scans in file formats of other programs: MATLAB, TDMS, folders of CSV.

Records are written a few points at a time. Every file is marked as measured or simulated.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path

import numpy as np

from haptonic.channels import Channel, Group, delimited, matlab, tdms
from haptonic.channels.labels import UNITS
from haptonic.channels.signals import ORIGIN, Samples
from haptonic.response import FrequencyResponse
from haptonic.vibrometry.readers.folder import GEOMETRY
from haptonic.vibrometry.records import TimeScan, portions


def write_mat(response: FrequencyResponse, path: Path) -> None:
    """Write a response for MATLAB (version 5): response (line, point), frequency, x, y, coherence."""
    notes, data = response.dataset.attrs, response.dataset
    content = {
        "response": response.values[:, :, 0], "frequency": response.frequency, "x": data["x"].values,
        "y": data["y"].values, "unit": response.units,
    }  # fmt: skip
    if "coherence" in data:
        content["coherence"] = data["coherence"].values
    matlab.write(path, content, notes["origin"])


def write_mat_records(scan: TimeScan, path: Path) -> None:
    """Write records as MATLAB variables (version 7.3): response and reference (point, repeat, sample) in SI
    units, single precision, sample_rate, x, y."""
    form, shared = (scan.repeats, scan.samples), len(scan.load(0, 2)[0]) == 1
    shapes = {"reference": (1 if shared else len(scan.names), *form), "response": (len(scan.names), *form)}

    def parts() -> Iterator[tuple[int, Mapping[str, Samples]]]:
        for first, reference, response in portions(scan):
            driven = {} if shared and first else {"reference": reference}
            yield first, driven | {"response": response}

    small = {"x": scan.x, "y": scan.y, "sample_rate": np.array([scan.sample_rate])}
    matlab.write_rows(path, small, shapes, parts(), scan.origin)


def write_tdms(scan: TimeScan, path: Path) -> None:
    """Write records as TDMS: a group for each point with its coordinates, a channel of the response and one
    of the reference, the repeats one after the other. It needs the package npTDMS."""
    timing = scan.sample_rate, scan.start

    def segments() -> Iterator[list[Group]]:
        for first, reference, response in portions(scan):
            groups = []
            for row, moved in enumerate(response):
                i = first + row
                driven = reference[min(row, len(reference) - 1)]
                both = (
                    Channel.of("response", moved.ravel(), UNITS[scan.motion], *timing),
                    Channel.of("reference", driven.ravel(), scan.reference.unit or "V", *timing),
                )
                place = {"x": float(scan.x[i]), "y": float(scan.y[i])}
                groups.append(Group(scan.names[i], {channel.name: channel for channel in both}, place))
            yield groups

    tdms.write(path, {ORIGIN: scan.origin, "title": scan.title}, segments())


def csv_files(response: FrequencyResponse) -> dict[str, Callable[[Path], object]]:
    """Writers of ``geometry.csv`` and of one file for each point: frequency, real and imaginary part."""
    origin, places = str(response.dataset.attrs["origin"]), response.points
    digits = len(str(len(places)))
    names = [f"point-{i + 1:0{digits}d}.csv" for i in range(len(places))]
    geometry = {"file": names, "x (m)": _rounded(places[:, 0]), "y (m)": _rounded(places[:, 1])}
    geometry[ORIGIN] = [origin] * len(places)
    points: dict[str, Callable[[Path], object]] = {
        name: partial(_write_point, response, i) for i, name in enumerate(names)
    }
    return points | {GEOMETRY: partial(delimited.write, table=geometry)}


def _write_point(response: FrequencyResponse, point: int, path: Path) -> None:
    values = response.values[:, point, 0].astype(np.complex128)
    units = response.units
    table = {
        "frequency (Hz)": response.frequency, f"real ({units})": values.real,
        f"imaginary ({units})": values.imag,
    }  # fmt: skip
    if "coherence" in response.dataset:
        table["coherence"] = response.dataset["coherence"].values[:, point]
    delimited.write(path, {name: _rounded(column) for name, column in table.items()})


def _rounded(values: Samples) -> list[str]:
    return [f"{value:.9g}" for value in values]
