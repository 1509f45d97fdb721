"""File formats of scans, and the options of each."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from haptonic import response
from haptonic.channels import Group, Notebook, hdf5 as hdf5_file, matlab, tdms as tdms_file
from haptonic.channels.formats import format_of
from haptonic.channels.signals import SIMULATED, Origin
from haptonic.channels.uff import scaled, uff_contents
from haptonic.errors import ScanError
from haptonic.response import FrequencyResponse
from haptonic.response.files import is_response
from haptonic.vibrometry.curves import assemble
from haptonic.vibrometry.readers import hdf5, tdms, uff, uff_time
from haptonic.vibrometry.readers.folder import GEOMETRY, read_folder
from haptonic.vibrometry.readers.long_table import read_table
from haptonic.vibrometry.readers.mapped import Mapped
from haptonic.vibrometry.readers.tables import scan_of_groups
from haptonic.vibrometry.records import TimeScan

FORMATS = (
    "UFF (.uff, .unv), MATLAB (.mat), TDMS, NetCDF and HDF5 (.nc, .h5), a folder of CSV files, or one CSV "
    "file with the columns x, y, frequency, real and imaginary"
)
FOLDER = "CSV folder"
OF_ARRAYS = frozenset(("variables", "at", "frequency_unit", "phase_unit", "points_in"))

Content = FrequencyResponse | TimeScan


@dataclass(frozen=True)
class ScanForm:
    """A file format of scans.

    read : function that reads the scan of a file
    takes : options that apply to this format
    """

    read: Callable[[Path, Mapped, Notebook, Origin, str], Content]
    takes: frozenset[str] = frozenset()


def form_name(path: Path) -> str:
    """Name of the format of a file or folder, in `FORMS`.

    Raises
    ------
    ScanError : such files cannot be read as a scan
    """
    if path.is_dir():
        return FOLDER
    if path.suffix.lower() in (".svd", ".pvd"):
        raise _refused(
            path,
            "a Polytec file, which only the maker's library can read",
            "the scan was saved in the instrument's own format",
            "in PSV software: File > Export > Universal File (UFF), FFT > FRF, with geometry; read that file",
        )
    form = format_of(path)
    if form is not None and form.name in FORMS:
        return form.name
    next_step = f"choose one of these; a CSV scan is a folder with {GEOMETRY} and one file for each point"
    if form is None:
        raise _refused(path, "a file of an unknown format", "another program wrote it", next_step)
    given = f"a {form.name} file, from which no scan is read"
    cause = "it contains signals or a table, without the places of points"
    raise _refused(path, given, cause, next_step)


def _matlab(path: Path, how: Mapped, notes: Notebook, origin: Origin, title: str) -> Content:
    return scan_of_groups(matlab.read(path, notes), how, notes, origin, title, ".")


def _hdf5(path: Path, how: Mapped, notes: Notebook, origin: Origin, title: str) -> Content:
    """Time records or responses in haptonic's layouts, or arrays with usual names."""
    groups: Mapping[str, Group] = hdf5_file.read(path, notes)
    if hdf5.is_records(groups[""].properties):
        return hdf5.read_records(groups[""], notes)
    if is_response(groups[""].properties):
        notes.format = "NetCDF"
        return response.read(path)
    return scan_of_groups(groups, how, notes, origin, title, "/")


def _tdms(path: Path, how: Mapped, notes: Notebook, origin: Origin, title: str) -> Content:
    return tdms.scan_of_groups(tdms_file.read(path, notes), how, notes, origin, title)


def _uff(path: Path, how: Mapped, notes: Notebook, origin: Origin, title: str) -> Content:
    contents = uff_contents(path, notes)
    if how.length_unit is not None:
        contents = scaled(contents, how.length_unit)
    origin = SIMULATED if contents.simulated else origin
    title = title or contents.title
    if uff_time.has_records(contents) and not any(f.header.function == 4 for f in contents.functions):
        return uff_time.time_scan_of(contents, origin, title)
    curves, places = uff.curves_of(contents, how.at)
    inputs: dict[str, Any] = {"file": path.name, "lines": [line.tolist() for line in contents.lines]}
    return assemble(
        curves, places, notes, reference=how.reference_text, estimator=how.estimator, origin=origin,
        title=title, inputs=inputs,
    )  # fmt: skip


# The names are those of `haptonic.channels.formats`, with one for folders
FORMS = {
    "UFF": ScanForm(_uff, frozenset({"at"})),
    "MATLAB": ScanForm(_matlab, OF_ARRAYS),
    "HDF5": ScanForm(_hdf5, OF_ARRAYS),
    "TDMS": ScanForm(_tdms, frozenset({"variables"})),
    "CSV": ScanForm(read_table, OF_ARRAYS - {"at", "points_in"}),
    FOLDER: ScanForm(read_folder, OF_ARRAYS - {"points_in"}),
}


def _refused(path: Path, given: str, cause: str, next_step: str) -> ScanError:
    return ScanError.unreadable(
        argument="path", given=f"{path}: {given}", allowed=FORMATS, cause=cause, next_step=next_step
    )
