"""Reader of scans from files of many programs, by one function."""

from __future__ import annotations

import math
import re
import shlex
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.channels import Notebook
from haptonic.channels.formats import format_of
from haptonic.channels.signals import Origin
from haptonic.errors import ChannelError, HaptonicError, HaptonicWarning, ResourceError, ScanError, shown
from haptonic.names import listed
from haptonic.paths import source
from haptonic.response import FrequencyResponse, Reference
from haptonic.units import format_quantity, to_si
from haptonic.vibrometry.curves import Point
from haptonic.vibrometry.estimation.spectra import Estimator
from haptonic.vibrometry.findings import ReadReport
from haptonic.vibrometry.readers.folder import GEOMETRY
from haptonic.vibrometry.readers.forms import FORMATS, FORMS, form_name
from haptonic.vibrometry.readers.mapped import Mapped, Side
from haptonic.vibrometry.readers.uff import LARGEST_PLATE
from haptonic.vibrometry.records import TimeScan

__all__ = ["Scan", "read_scan"]

SLENDEREST, DENSE = 100.0, 0.1  # length over width of a strip of points; share of their distance in a row
LOWEST_TOP = 200.0  # Hz; a scan that ends below is probably in kHz: ultrasonic ones reach some 100 kHz
EXAMPLES = {"m": "mm", "Hz": "kHz", "rad": "deg"}
OPTIONAL = ("variables", "at", "frequency_unit", "phase_unit", "points_in")  # not taken by every format
MOST_NAMED = 4  # files of a folder, in a message


@dataclass(frozen=True, eq=False)
class Scan:
    """A scan from a file: a frequency response or time records, and the report on reading it."""

    content: FrequencyResponse | TimeScan
    report: ReadReport

    @property
    def response(self) -> FrequencyResponse:
        """The frequency response.

        Raises
        ------
        ScanError : the file contains time records
        """
        if isinstance(self.content, TimeScan):
            raise ScanError.mismatch(
                argument="scan.response",
                given=f"{self.report.path}, which contains time records",
                allowed="a scan of frequency responses",
                cause="the instrument stored time data",
                next_step="estimate them: haptonic.vibrometry.estimate(scan.records)",
            )
        return self.content

    @property
    def points(self) -> Array:
        """(point, 2) positions in the coordinates of the file, m."""
        if isinstance(self.content, TimeScan):
            return np.column_stack([self.content.x, self.content.y])
        return self.content.points

    @classmethod
    def of(cls, response: FrequencyResponse) -> Scan:
        """A response that was not read from a file."""
        return cls(response, ReadReport("a response", "in memory", response.dataset.sizes["point"]))

    @property
    def records(self) -> TimeScan:
        """The time records.

        Raises
        ------
        ScanError : the file contains frequency responses
        """
        if isinstance(self.content, FrequencyResponse):
            raise ScanError.mismatch(
                argument="scan.records",
                given=f"{self.report.path}, which contains frequency responses",
                allowed="a scan of time records",
                cause="the instrument estimated the responses itself",
                next_step="use scan.response",
            )
        return self.content


def read_scan(
    path: Path | str,
    *,
    variables: Mapping[str, str] | None = None,
    unit: str | None = None,
    length_unit: float | str | None = None,
    frequency_unit: float | str | None = None,
    phase_unit: float | str | None = None,
    reference: str | None = None,
    estimator: Estimator = "H1",
    at: str | Sequence[float] | Sequence[Sequence[float]] | None = None,
    points_in: Side | None = None,
    origin: Origin = "measured",
    title: str = "",
) -> Scan:
    """Read a scan in any known format; ``report`` lists unused content.

    Parameters
    ----------
    path : a file, a folder with one CSV file for each point, or a folder with one scan
    variables : names of arrays, columns or channels by their meaning, such as {"response": "FRF"}; see
        `haptonic.vibrometry.readers.mapped.NAMES`. Others are guessed from usual names
        unit : of responses in files without one; by default "m/s/V"
    length_unit : of the coordinates, if it is not that of the file: "mm", or its value in m, 1e-3
    frequency_unit, phase_unit : of arrays and columns without a unit: "kHz", "deg", or the value in Hz or rad
    reference : reference to use if there are several; or its name and unit if the file gives none
    estimator : estimator to use if a file has several
    at : positions of the points of a file without coordinates, in its order: "10 mm, 5 mm; 15 mm, 5 mm", or
        pairs in m
    points_in : "rows" or "columns", for arrays with as many points as frequencies
    origin : "simulated" for a file of a simulation; a file marked as simulated is always simulated
    title : text for readers

    Raises
    ------
    ScanError : an unknown format, a file without usable content, or an option for another format
    HaptonicError : a unit that is not one of length, frequency or angle
    ResponseError : a damaged file of responses written by haptonic
    ResourceError : the file cannot be read, or does not fit into memory
    """
    path = source(path, "path")
    if not path.exists():
        cause, next_step = "the name is misspelt, or it lies elsewhere", "check the name and the folder"
        raise ScanError.not_found(
            argument="path", given=path, allowed=FORMATS, cause=cause, next_step=next_step
        )
    if not isinstance(variables, Mapping | None):
        raise ScanError.malformed(
            argument="variables", given=shown(variables), allowed='names by meaning, {"response": "FRF"}',
            cause="it is not a dictionary, but perhaps in the form of the command line",
            next_step='write variables={"response": "FRF", "frequency": "f"}',
        )  # fmt: skip
    try:
        path = _scan_in(path)
        lengths = _unit_value(length_unit, "m", "length_unit")
        how = Mapped(
            variables=variables or {},
            unit=unit,
            length_unit=lengths,
            reference=Reference.parse(reference or ""),
            reference_text=reference,
            frequency_unit=_unit_value(frequency_unit, "Hz", "frequency_unit"),
            phase_unit=_unit_value(phase_unit, "rad", "phase_unit"),
            at=points_at(at, lengths or 1.0),
            points_in=points_in,
            estimator=estimator,
            file=path,
        )
        return _read(path, how, origin, title)
    except PermissionError as error:
        next_step = "ask for the right to read it, or copy it"
        raise _unopened("forbidden", path, "you may not read it", next_step) from error
    except MemoryError as error:
        cause = "its form is read as a whole and does not fit into memory, or it is damaged"
        next_step = "export it in HDF5 or TDMS, which are read in parts"
        raise _unopened("too-large", path, cause, next_step) from error


def points_at(at: str | Sequence[Any] | None, length_unit: float = 1.0) -> tuple[Point, ...]:
    """Positions given by a user; numbers without a unit are in ``length_unit``, m.

    Raises
    ------
    ScanError : not pairs of lengths
    """
    if at is None:
        return ()
    try:
        if isinstance(at, str):
            texts = [place.split(",") for place in at.split(";") if place.strip()]
            plain = {not re.search("[a-zµ]", text) for pair in texts for text in pair if text.strip() != "0"}
            if len(plain) > 1:  # "10,5 mm" is perhaps a decimal comma
                raise ValueError(at)
            pairs = [
                [to_si(text, "m", "at") if plain == {False} else length_unit * float(text) for text in pair]
                for pair in texts
            ]
        else:
            given = [at] if np.ndim(at[0]) == 0 else at
            pairs = [[float(coordinate) for coordinate in pair] for pair in given]
        places = tuple(Point(*pair) for pair in pairs)
        if places and np.isfinite(pairs).all():
            return places
    except (TypeError, ValueError, IndexError, KeyError, HaptonicError):
        pass
    raise ScanError.malformed(
        argument="at",
        given=shown(at),
        allowed='two lengths for each point, "10 mm, 5 mm", with semicolons between points; or pairs in m',
        cause="a number or a comma is missing, or the unit is not one of length",
        next_step='write at="10 mm, 5 mm"',
        command='add --at "10 mm, 5 mm"',
    )


def _scan_in(path: Path) -> Path:
    """The only scan in a folder without a scan of its own; otherwise the path itself.

    Raises
    ------
    ScanError : several scans
    """
    if not path.is_dir() or any(path.glob("*.csv")):
        return path
    inside = [file for file in sorted(path.iterdir()) if file.is_file() and not file.name.startswith(".")]
    scans = [file for file in inside if (form := format_of(file)) is not None and form.name in FORMS]
    scans += [table.parent for table in sorted(path.glob(f"*/{GEOMETRY}"))]
    if len(scans) > 1:
        listed = ", ".join(scan.name for scan in scans[:MOST_NAMED])
        raise ScanError.conflict(
            argument="path",
            given=f"{path}: {len(scans)} files ({listed}{', ...' if len(scans) > MOST_NAMED else ''})",
            allowed="a folder with one scan",
            cause="the folder has several scans, or results beside one",
            next_step=f"choose one: read_scan({str(scans[0])!r})",
            command=f"haptonic scan {shlex.quote(str(scans[0]))}",
        )
    return scans[0] if scans else path


def _read(path: Path, how: Mapped, origin: Origin, title: str) -> Scan:
    name = form_name(path)
    form, notes = FORMS[name], Notebook(path, name)
    given = {option: getattr(how, option) for option in OPTIONAL}
    for option, value in given.items():
        if value and option not in form.takes:
            others = [other for other, other_form in FORMS.items() if option in other_form.takes]
            raise ScanError.conflict(
                argument=option,
                given=f"{shown(value)}, for {name}",
                allowed=f"it for {listed(others, 'or')}",
                cause="a file of this format gives it itself, or has nothing of the kind",
                next_step="leave it out",
                command=f"leave --{option.replace('_', '-')} out",
            )
    try:
        content = form.read(path, how, notes, origin, title)
    except ChannelError as error:
        raise error.changed(ScanError) from error
    if "frequency_unit" in form.takes and notes.format == name:
        _doubt(content, path, how.length_unit is None, how.frequency_unit is None)
    points = np.stack([content.x, content.y], axis=1) if isinstance(content, TimeScan) else content.points
    _doubt_axes(points, path)
    return Scan(content, ReadReport.of(notes, len(points)))


def _unit_value(unit: float | str | None, si: str, argument: str) -> float | None:
    """Value of a unit in SI units: 1e-3 for ``"mm"``; a number is returned as it is."""
    if unit is None:
        return None
    value = to_si(f"1 {unit}", si, argument) if isinstance(unit, str) else float(unit)
    if not 0 < value < math.inf:
        raise ScanError.malformed(
            argument=argument,
            given=shown(unit),
            allowed=f'a unit such as "{EXAMPLES[si]}", or a positive number of {si}',
            cause="a slip in the number",
            next_step=f'write "{EXAMPLES[si]}"',
        )
    return value


def _doubt(content: FrequencyResponse | TimeScan, path: Path, lengths: bool, frequencies: bool) -> None:
    """Warn if numbers without a unit, read as m and Hz, give an implausible scan of a plate."""
    axes = [content.x, content.y] if isinstance(content, TimeScan) else content.points.T
    wide = max(float(np.ptp(axis)) for axis in axes)
    top = math.inf if isinstance(content, TimeScan) else float(content.frequency[-1])
    for doubtful, description, argument, option, unit in (
        (lengths and wide > LARGEST_PLATE, f"a scan {wide:g} m wide", "length_unit", "--length-unit", "mm"),
        (frequencies and top < LOWEST_TOP, f"a scan up to {top:g} Hz", "frequency_unit", "--frequency-unit",
         "kHz"),
    ):  # fmt: skip
        if doubtful:
            warnings.warn(
                f"{path.name or path}: {description} was read, because the file gives no unit; if it is in "
                f'{unit}, write {argument}="{unit}" ({option} {unit})',
                HaptonicWarning,
                stacklevel=4,
            )


def _doubt_axes(points: Array, path: Path) -> None:
    """Warn of points (n, 2) that fill a strip as narrow as if its axes had different units.

    A row of points is as narrow, but its neighbours are as far apart as its length divided by their number.
    """
    extent = np.ptp(points, axis=0)
    wide, narrow = float(extent.max()), float(extent.min())
    if len(points) < 3 or not 0 < SLENDEREST * narrow < wide:
        return
    near = scipy.spatial.cKDTree(points).query(points, k=2)[0][:, 1]
    if float(np.median(near)) < DENSE * wide / len(points):
        x, y = (format_quantity(float(length), "m", digits=3) for length in extent)
        warnings.warn(
            f"{path.name or path}: the points extend {x} along x and {y} along y; check the units of both",
            HaptonicWarning,
            stacklevel=4,
        )


def _unopened(code: str, path: Path, cause: str, next_step: str) -> ResourceError:
    allowed = "a file that can be read"
    return ResourceError(code, argument="path", given=path, allowed=allowed, cause=cause, next_step=next_step)
