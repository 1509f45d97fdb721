"""Reading of a scan's file before its analysis: points, units and assumptions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from haptonic.arrays import Array
from haptonic.errors import ResponseError
from haptonic.later import xarray as xr
from haptonic.plate import Plate
from haptonic.plate.layout.drawing import drawing_of
from haptonic.response import FrequencyResponse, average_spectrum
from haptonic.response.lines import regular_line
from haptonic.results.reading import MOST_SAMPLES, Reading
from haptonic.units import format_quantity, hz_text
from haptonic.vibrometry import Registration, Scan, TimeScan


@dataclass(frozen=True, eq=False, repr=False)
class ScanReading(Reading):
    """A scan as it was read.

    plate, registration : where the points lie on the plate of the study, if there is one
    """

    scan: Scan
    plate: Plate | None = None
    registration: Registration | None = None

    @property
    def origin(self) -> str:
        content = self.scan.content
        return content.origin if isinstance(content, TimeScan) else str(content.dataset.attrs["origin"])

    @property
    def positions(self) -> Array:
        """(point, 2) on the plate, or in the coordinates of the file, m."""
        points = self.scan.points
        return points if self.registration is None else self.registration.of(points)

    @cached_property
    def dataset(self) -> xr.Dataset:
        """Places of the points, and a spectrum or the first record."""
        positions = self.positions
        points = {
            name: ("point", positions[:, axis], {"units": "m", "long_name": name})
            for axis, name in enumerate("xy")
        }
        content = self.scan.content
        if isinstance(content, TimeScan):
            curve = first_record(content)
            along = "time", np.arange(len(curve)) / content.sample_rate
            about = {"units": "SI", "long_name": f"{content.motion} of the first point"}
            unit = "s"
        else:
            lines = content.frequency
            every = max(1, -(-len(lines) // MOST_SAMPLES))
            along, curve, unit = (
                ("frequency", lines[::every]),
                average_spectrum(content).values[::every],
                "Hz",
            )
            about = {"units": content.units, "long_name": "rms of all points"}
        name, axis = along
        return xr.Dataset(
            {**points, "curve": (name, curve, about)},
            coords={name: (name, axis, {"units": unit, "long_name": name})},
        )

    def drawing(self) -> Mapping[str, Any] | None:
        return None if self.plate is None else drawing_of(self.plate)

    def summary(self) -> list[str]:
        sentences = [f"{len(self.positions)} points, {_extent(self.positions)}, {self.origin}."]
        if self.registration is not None:
            sentences.append(self.registration.sentence)
        return sentences

    def remarks(self) -> list[str]:
        report = self.scan.report
        missing = [f"not measured: {', '.join(report.missing)}"] if report.missing else []
        dropped = [f"not used: {part}" for part in report.dropped]
        outside = []
        if self.plate is not None:
            right, top = self.plate.layout.x[-1], self.plate.layout.y[-1]
            beyond = ((self.positions < 0) | (self.positions > [right, top])).any(axis=1).sum()
            outside = [f"{beyond} points lie outside the plate of the study"] if beyond else []
        doubts = [] if self.registration is None else self.registration.doubts
        return [*doubts, *outside, *report.remarks, *missing, *dropped]

    def answers(self) -> list[tuple[str, str]]:
        content, positions = self.scan.content, self.positions
        rows = [
            ("format", self.scan.report.format),
            ("points", f"{len(positions)}{_grid(positions)}"),
            ("from left to right", _range(positions[:, 0])),
            ("from bottom to top", _range(positions[:, 1])),
            ("first point", _place(positions[0])),
            ("last point", _place(positions[-1])),
        ]
        if isinstance(content, TimeScan):
            rows += [
                ("records", f"{content.repeats} for each point, of {content.samples} samples"),
                ("sampling rate", format_quantity(content.sample_rate, "Hz")),
                ("quantity", f"{content.motion} along {content.direction}"),
            ]
        else:
            lines = content.frequency
            rows += [
                ("frequencies", f"{len(lines)}, {hz_text(float(lines[0]), float(lines[-1]), form='.4g')}"),
                ("quantity", f"{content.dataset.attrs['quantity']} in {content.units}, along "
                 f"{', '.join(str(name) for name in content.dataset['direction'].values)}"),
                ("loudest frequency", hz_text(_loudest(content), form=".4g")),
            ]  # fmt: skip
        reference = str(content.reference)
        return [*rows, ("reference", reference or "none: the responses are not divided by a drive")]


def first_record(scan: TimeScan) -> Array:
    """First samples of the response of the first point."""
    _, response = scan.source.load(0, 1)
    return np.asarray(response[0, 0, :MOST_SAMPLES], dtype=float) * scan.response_scale


def _loudest(response: FrequencyResponse) -> float:
    return float(response.frequency[int(average_spectrum(response).values.argmax())])


def _range(values: Array) -> str:
    low, high = float(values.min()), float(values.max())
    return f"{low * 1e3:.4g} to {high * 1e3:.4g} mm"


def _extent(points: Array) -> str:
    width, height = np.ptp(points, axis=0) * 1e3
    return f"{width:.4g} x {height:.4g} mm"


def _place(point: Array) -> str:
    x, y = point * 1e3
    return f"x = {x:.4g} mm, y = {y:.4g} mm"


def _grid(points: Array) -> str:
    """Columns and rows of a regular grid, behind the number of points."""
    extent = float(np.ptp(points, axis=0).max())
    try:
        columns, rows = (
            len(regular_line(points[:, axis], extent, name)[1]) for axis, name in enumerate("xy")
        )
    except ResponseError:
        return ", on no regular grid"
    return f", in {columns} columns and {rows} rows"
