"""Scan files of many programs, read by one function."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from haptonic import response
from haptonic.channels import Group, Notebook
from haptonic.channels.formats import Format, format_of
from haptonic.channels.signals import SIMULATED, Origin
from haptonic.channels.uff import scaled, uff_contents
from haptonic.errors import ChannelError, HaptonicWarning, ResourceError, ScanError, shown
from haptonic.paths import source
from haptonic.response import FrequencyResponse, Reference
from haptonic.units import to_si
from haptonic.vibrometry.curves import assemble
from haptonic.vibrometry.findings import ReadReport
from haptonic.vibrometry.readers import hdf5, uff, uff_time
from haptonic.vibrometry.readers.folder import read_folder
from haptonic.vibrometry.readers.tables import Mapped, scan_of, table_of
from haptonic.vibrometry.readers.tdms import scan_of_groups
from haptonic.vibrometry.readers.uff import LARGEST_PLATE
from haptonic.vibrometry.records import TimeScan

__all__ = ["Scan", "read_scan"]

FORMATS = (
    "UFF (.uff, .unv), MATLAB (.mat), TDMS, NetCDF and HDF5 in haptonic's layouts, a folder of CSV files"
)
FOLDER = "CSV folder"
WITHOUT_UNITS = ("MATLAB", FOLDER)  # what they hold has no unit, or need not have one
LOWEST_TOP = 200.0  # Hz; a scan that ends below is probably in kHz: ultrasonic ones reach some 100 kHz
EXAMPLES = {"m": "mm", "Hz": "kHz"}


@dataclass(frozen=True, eq=False)
class Scan:
    """What a file gave: a frequency response or time records, and the report of how it was read."""

    content: FrequencyResponse | TimeScan
    report: ReadReport

    @property
    def response(self) -> FrequencyResponse:
        """The frequency response.

        Raises
        ------
        ScanError : the file holds time records
        """
        if isinstance(self.content, TimeScan):
            raise ScanError.mismatch(
                argument="scan.response",
                given=f"{self.report.path}, which holds time records",
                allowed="a scan of frequency responses",
                cause="the instrument stored time data",
                next_step="estimate them: haptonic.vibrometry.estimate(scan.records)",
            )
        return self.content

    @property
    def records(self) -> TimeScan:
        """The time records.

        Raises
        ------
        ScanError : the file holds frequency responses
        """
        if isinstance(self.content, FrequencyResponse):
            raise ScanError.mismatch(
                argument="scan.records",
                given=f"{self.report.path}, which holds frequency responses",
                allowed="a scan of time records",
                cause="the instrument estimated the responses itself",
                next_step="use scan.response",
            )
        return self.content


def read_scan(
    path: Path | str,
    *,
    variables: Mapping[str, str] | None = None,
    unit: str = "m/s/V",
    length_unit: float | str | None = None,
    frequency_unit: float | str | None = None,
    reference: str | None = None,
    origin: Origin = "measured",
    title: str = "",
) -> Scan:
    """Read a scan, whatever program wrote it; what could not be used is named in ``report``.

    Parameters
    ----------
    path : of a file, or of a folder with one CSV file for each point
    variables : how a MATLAB file's variables (a TDMS file's channels) are called, see
        `haptonic.vibrometry.readers.tables.Mapped`; usual names are guessed
    unit : of responses in files that give none
    length_unit : of the coordinates, where it is not that of the file: "mm", or one of it in m, 1e-3
    frequency_unit : of frequencies in a MATLAB file, or in CSV without a unit: "kHz", or one of it in Hz, 1e3
    reference : which reference, when there are several; or its name and unit, when the file gives none
    origin : "simulated" for a file of a simulation; files that say so themselves are believed
    title : for people

    Raises
    ------
    ScanError : an unknown format, a file of which nothing can be used, or a unit of frequencies for a form
        that has its own
    HaptonicError : a unit that is not one of length or frequency
    ResponseError : a NetCDF file that haptonic did not write
    ResourceError : the file may not be read, or does not fit into memory
    """
    path = source(path, "path")
    if not path.exists():
        cause, next_step = "the name is misspelt, or it lies elsewhere", "check the name and the folder"
        raise ScanError.not_found(
            argument="path", given=path, allowed=FORMATS, cause=cause, next_step=next_step
        )
    try:
        length, frequency = (
            _one(length_unit, "m", "length_unit"),
            _one(frequency_unit, "Hz", "frequency_unit"),
        )
        return _read(path, variables, unit, length, frequency, reference, origin, title)
    except PermissionError as error:
        next_step = "ask for the right to read it, or copy it"
        raise _unopened("forbidden", path, "you may not read it", next_step) from error
    except MemoryError as error:
        cause = "its form is read as a whole and does not fit into memory, or it is damaged"
        next_step = "export it in HDF5 or TDMS, which are read in parts"
        raise _unopened("too-large", path, cause, next_step) from error


def _read(
    path: Path,
    variables: Mapping[str, str] | None,
    unit: str,
    length_unit: float | None,
    frequency_unit: float | None,
    reference: str | None,
    origin: Origin,
    title: str,
) -> Scan:
    how = Mapped(
        variables=variables or {},
        unit=unit,
        length_unit=length_unit or 1.0,
        reference=Reference.parse(reference or ""),
        frequency_unit=frequency_unit or 1.0,
    )
    form = None if path.is_dir() else _format(path)
    notes = Notebook(path, FOLDER if form is None else form.name)
    if frequency_unit is not None and notes.format not in WITHOUT_UNITS:
        raise ScanError.conflict(
            argument="frequency_unit",
            given=f"{frequency_unit:g} Hz, for {notes.format}",
            allowed=f"a unit for {' or '.join(WITHOUT_UNITS)}",
            cause="this form says itself in which unit its frequencies are",
            next_step="leave it out",
        )
    content: FrequencyResponse | TimeScan
    try:
        if form is None:
            content = read_folder(path, how, notes, origin, title)
        elif form.name == "UFF":
            content = _uff(path, notes, length_unit, reference, origin, title)
        else:
            content = _of_groups(form.read(path, notes), how, notes, origin, title)
    except ChannelError as error:
        raise error.changed(ScanError) from error
    if notes.format in WITHOUT_UNITS:
        _doubt(content, path, length_unit is None, frequency_unit is None)
    points = len(content.x) if isinstance(content, TimeScan) else content.dataset.sizes["point"]
    return Scan(content, ReadReport.of(notes, points))


def _of_groups(
    groups: Mapping[str, Group], how: Mapped, notes: Notebook, origin: Origin, title: str
) -> FrequencyResponse | TimeScan:
    if notes.format == "TDMS":
        return scan_of_groups(groups, how, notes, origin, title)
    every = groups[""]
    if notes.format == "MATLAB":
        origin = SIMULATED if every.simulated else origin
        return scan_of(table_of(every.channels, how, notes), how, notes, origin, title)
    if every.properties.get("kind") == hdf5.KIND:
        return hdf5.read_records(every, notes)
    notes.format = "NetCDF"
    return response.read(notes.path)


def _one(unit: float | str | None, si: str, argument: str) -> float | None:
    """One of a unit in SI units: of ``"mm"`` 1e-3 m, of a number itself."""
    if unit is None:
        return None
    one = to_si(f"1 {unit}", si, argument) if isinstance(unit, str) else float(unit)
    if not 0 < one < math.inf:
        raise ScanError.malformed(
            argument=argument,
            given=shown(unit),
            allowed=f'a unit such as "{EXAMPLES[si]}", or a positive number of {si}',
            cause="a slip in the number",
            next_step=f'write "{EXAMPLES[si]}"',
        )
    return one


def _doubt(content: FrequencyResponse | TimeScan, path: Path, lengths: bool, frequencies: bool) -> None:
    """Warn where numbers without a unit, taken as m and Hz, are no scan that anybody makes of a plate."""
    points = [content.x, content.y] if isinstance(content, TimeScan) else content.points.T
    wide = max(float(np.ptp(axis)) for axis in points)
    top = math.inf if isinstance(content, TimeScan) else float(content.frequency[-1])
    for doubtful, said, argument, option, unit in (
        (lengths and wide > LARGEST_PLATE, f"a scan {wide:g} m wide", "length_unit", "--length-unit", "mm"),
        (frequencies and top < LOWEST_TOP, f"a scan up to {top:g} Hz", "frequency_unit", "--frequency-unit",
         "kHz"),
    ):  # fmt: skip
        if doubtful:
            warnings.warn(
                f"{path.name}: {said} was read, because the file gives no unit; if it is in {unit}, write "
                f'{argument}="{unit}" ({option} {unit})',
                HaptonicWarning,
                stacklevel=4,
            )


def _uff(
    path: Path, notes: Notebook, length_unit: float | None, reference: str | None, origin: Origin, title: str
) -> FrequencyResponse | TimeScan:
    contents = uff_contents(path, notes)
    if length_unit is not None:
        contents = scaled(contents, length_unit)
    origin = SIMULATED if contents.simulated else origin
    title = title or contents.title
    if uff_time.has_records(contents) and not any(f.header.function == 4 for f in contents.functions):
        return uff_time.time_scan_of(contents, origin, title)
    curves, places = uff.curves_of(contents)
    inputs: dict[str, Any] = {"file": path.name, "lines": [line.tolist() for line in contents.lines]}
    return assemble(curves, places, notes, reference=reference, origin=origin, title=title, inputs=inputs)


def _format(path: Path) -> Format:
    """The format, if scans are read from files of it.

    Raises
    ------
    ScanError : a format that is not read
    """
    if path.suffix.lower() in (".svd", ".pvd"):
        raise _refused(
            path,
            "a Polytec file, which only the maker's library can read",
            "the scan was saved in the instrument's own format",
            "in PSV software: File > Export > Universal File (UFF), FFT > FRF, with geometry; read that file",
        )
    form = format_of(path)
    if form is not None and form.name != "CSV":
        return form
    next_step = "choose one of these; a CSV scan is a folder with geometry.csv and one file for each point"
    raise _refused(path, "a file of an unknown format", "another program wrote it", next_step)


def _unopened(code: str, path: Path, cause: str, next_step: str) -> ResourceError:
    allowed = "a file that can be read"
    return ResourceError(code, argument="path", given=path, allowed=allowed, cause=cause, next_step=next_step)


def _refused(path: Path, found: str, cause: str, next_step: str) -> ScanError:
    return ScanError.unreadable(
        argument="path", given=f"{path}: {found}", allowed=FORMATS, cause=cause, next_step=next_step
    )
