"""Scan files of many programs, read by one function."""

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

from haptonic.channels import Notebook
from haptonic.channels.formats import format_of
from haptonic.channels.signals import Origin
from haptonic.errors import ChannelError, HaptonicError, HaptonicWarning, ResourceError, ScanError, shown
from haptonic.paths import source
from haptonic.response import FrequencyResponse, Reference
from haptonic.units import to_si
from haptonic.vibrometry.curves import Point
from haptonic.vibrometry.estimation.spectra import Estimator
from haptonic.vibrometry.findings import ReadReport
from haptonic.vibrometry.readers.folder import GEOMETRY
from haptonic.vibrometry.readers.forms import FORMATS, FORMS, form_name
from haptonic.vibrometry.readers.mapped import Mapped, Side
from haptonic.vibrometry.readers.uff import LARGEST_PLATE
from haptonic.vibrometry.records import TimeScan

__all__ = ["Scan", "read_scan"]

LOWEST_TOP = 200.0  # Hz; a scan that ends below is probably in kHz: ultrasonic ones reach some 100 kHz
EXAMPLES = {"m": "mm", "Hz": "kHz", "rad": "deg"}
OPTIONAL = ("variables", "at", "frequency_unit", "phase_unit", "points_in")  # that not every form takes
MOST_NAMED = 4  # files of a folder, in a message


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
    """Read a scan, whatever program wrote it; ``report`` names what could not be used.

    Parameters
    ----------
    path : of a file, of a folder with one CSV file for each point, or of a folder that holds one scan
    variables : names of arrays, columns or channels by their meaning, such as {"response": "FRF"}; see
        `haptonic.vibrometry.readers.mapped.NAMES`. Others are taken by usual names
    unit : of responses in files that give none; "m/s/V" if this is left out too
    length_unit : of the coordinates, where it is not that of the file: "mm", or one of it in m, 1e-3
    frequency_unit, phase_unit : of arrays and columns without a unit: "kHz", "deg", or one of it in Hz or rad
    reference : which reference, when there are several; or its name and unit, when the file gives none
    estimator : which estimator, if a file has several
    at : places of the points of a file without coordinates, in its order: "10 mm, 5 mm; 15 mm, 5 mm", or
        pairs in m
    points_in : "rows" or "columns", for arrays with as many points as frequencies
    origin : "simulated" for a file of a simulation; a file that calls itself simulated is
    title : for people

    Raises
    ------
    ScanError : an unknown format, a file of which nothing can be used, or an option for another form
    HaptonicError : a unit that is not one of length, frequency or angle
    ResponseError : a file of responses that haptonic wrote and that is damaged
    ResourceError : the file may not be read, or does not fit into memory
    """
    path = source(path, "path")
    if not path.exists():
        cause, next_step = "the name is misspelt, or it lies elsewhere", "check the name and the folder"
        raise ScanError.not_found(
            argument="path", given=path, allowed=FORMATS, cause=cause, next_step=next_step
        )
    try:
        path = _scan_in(path)
        lengths = _one(length_unit, "m", "length_unit")
        how = Mapped(
            variables=variables or {},
            unit=unit,
            length_unit=lengths,
            reference=Reference.parse(reference or ""),
            reference_text=reference,
            frequency_unit=_one(frequency_unit, "Hz", "frequency_unit"),
            phase_unit=_one(phase_unit, "rad", "phase_unit"),
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
    """Places that a user gives; in a text, numbers without a unit are in ``length_unit``, m.

    Raises
    ------
    ScanError : no pairs of lengths
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
            pairs = [[float(one) for one in pair] for pair in given]
        places = tuple(Point(*pair) for pair in pairs)
        if places and np.isfinite(pairs).all():
            return places
    except (TypeError, ValueError, IndexError, KeyError, HaptonicError):
        pass
    raise ScanError.malformed(
        argument="at",
        given=shown(at),
        allowed='two lengths for each point, "10 mm, 5 mm", with semicolons between points; or pairs in m',
        cause="a number or a comma is missing, or the unit is none of length",
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
    inside = [one for one in sorted(path.iterdir()) if one.is_file() and not one.name.startswith(".")]
    scans = [one for one in inside if (form := format_of(one)) is not None and form.name in FORMS]
    scans += [one.parent for one in sorted(path.glob(f"*/{GEOMETRY}"))]
    if len(scans) > 1:
        listed = ", ".join(one.name for one in scans[:MOST_NAMED])
        raise ScanError.conflict(
            argument="path",
            given=f"{path}: {len(scans)} files ({listed}{', ...' if len(scans) > MOST_NAMED else ''})",
            allowed="a folder with one scan",
            cause="the folder holds several scans, or results beside one",
            next_step=f"choose one: read_scan({str(scans[0])!r})",
            command=f"haptonic scan {shlex.quote(str(scans[0]))}",
        )
    return scans[0] if scans else path


def _read(path: Path, how: Mapped, origin: Origin, title: str) -> Scan:
    name = form_name(path)
    form, notes = FORMS[name], Notebook(path, name)
    given = {one: getattr(how, one) for one in OPTIONAL}
    for option, value in given.items():
        if value and option not in form.takes:
            others = [other for other, one in FORMS.items() if option in one.takes]
            raise ScanError.conflict(
                argument=option,
                given=f"{shown(value)}, for {name}",
                allowed=f"it for {' or '.join(others)}",
                cause="a file of this form says it itself, or has nothing of the kind",
                next_step="leave it out",
                command=f"leave --{option.replace('_', '-')} out",
            )
    try:
        content = form.read(path, how, notes, origin, title)
    except ChannelError as error:
        raise error.changed(ScanError) from error
    if "frequency_unit" in form.takes and notes.format == name:
        _doubt(content, path, how.length_unit is None, how.frequency_unit is None)
    points = len(content.x) if isinstance(content, TimeScan) else content.dataset.sizes["point"]
    return Scan(content, ReadReport.of(notes, points))


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
                f"{path.name or path}: {said} was read, because the file gives no unit; if it is in {unit}, "
                f'write {argument}="{unit}" ({option} {unit})',
                HaptonicWarning,
                stacklevel=4,
            )


def _unopened(code: str, path: Path, cause: str, next_step: str) -> ResourceError:
    allowed = "a file that can be read"
    return ResourceError(code, argument="path", given=path, allowed=allowed, cause=cause, next_step=next_step)
