"""NI TDMS files: one group for each point, or one channel for each point in one group."""

from __future__ import annotations

import importlib
import struct
import weakref
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from haptonic.errors import ScanError
from haptonic.vibrometry.curves import nothing_left
from haptonic.vibrometry.findings import Notebook
from haptonic.vibrometry.labels import label_of, ratio_of
from haptonic.vibrometry.readers.tables import ORIGIN, Mapped, Origin
from haptonic.vibrometry.records import Samples, TimeScan

if TYPE_CHECKING:
    from nptdms import TdmsChannel, TdmsFile

DAMAGED = (
    ValueError, TypeError, LookupError, AttributeError, EOFError, RuntimeError, OSError, OverflowError,
    struct.error,
)  # fmt: skip
"""What npTDMS raises at a file of another kind or a damaged one."""
POSITION = (("x", "y"), ("X", "Y"), ("x_m", "y_m"))


@dataclass(frozen=True, eq=False)
class _FromFile:
    """Channels of an open file, one for each point; npTDMS reads a channel when it is asked for it."""

    path: Path
    reference: list[TdmsChannel]
    response: list[TdmsChannel]

    def load(self, start: int, stop: int) -> tuple[Samples, Samples]:
        try:
            reference, response = (
                np.stack([channel[:] for channel in channels[start:stop]])[:, None]
                for channels in (self.reference, self.response)
            )
        except PermissionError:
            raise
        except DAMAGED as error:
            raise _damaged(self.path, error) from error
        return reference, response


def read_tdms(path: Path, how: Mapped, notes: Notebook, origin: Origin, title: str) -> TimeScan:
    """Time records of a file in which each group is a point, with its position in the group's properties.

    The samples stay in the file, which is open as long as the scan exists.

    A group has one channel of the response and one of the reference, named so or told apart by their units
    (``unit_string``); the rate is that of the waveform (``wf_increment``), its start ``wf_start_offset``.

    Raises
    ------
    ScanError : npTDMS is not installed, or the file is damaged or holds no usable point
    """
    nptdms = nptdms_for(path)
    with ExitStack() as stack:
        # opened here, for npTDMS does not close what it cannot read
        handle = stack.enter_context(path.open("rb"))
        try:
            file = nptdms.TdmsFile.open(handle)
        except DAMAGED as error:
            raise _damaged(path, error) from error
        scan = _scan_of(file, path, how, notes, origin, title)
        weakref.finalize(scan.source, stack.pop_all().close)
        return scan


def nptdms_for(path: Path) -> ModuleType:
    """The package npTDMS, which is needed to read or write a file.

    Raises
    ------
    ScanError : it is not installed
    """
    try:
        return importlib.import_module("nptdms")
    except ImportError as error:
        raise ScanError(
            argument="TDMS file",
            given=str(path),
            allowed="TDMS files where the package npTDMS is installed",
            cause="npTDMS is an optional part of haptonic and is not installed",
            next_step='pip install "haptonic[tdms]"',
        ) from error


def _scan_of(
    file: TdmsFile, path: Path, how: Mapped, notes: Notebook, origin: Origin, title: str
) -> TimeScan:
    if str(file.properties.get(ORIGIN)) == "simulated":
        origin = "simulated"
    names, rows, places = [], [], []
    form: tuple[Any, ...] | None = None
    for group in file.groups():
        chosen = _channels(group.channels(), how)
        place = _place(group.properties, how.length_unit)
        if chosen is None:
            notes.drop(f"point {group.name}", "no pair of a response and a reference channel")
        elif place is None:
            notes.drop(f"point {group.name}", "no coordinates: its group has no properties x and y")
        else:
            response, reference = chosen
            found = (len(response), *(_timing(channel) for channel in chosen), _unit(chosen[0], how))
            form = form or found
            if found != form or len(reference) != len(response) or not len(response):
                notes.drop(f"point {group.name}", f"{found[0]} samples, rate or unit differ from the first's")
            else:
                names.append(group.name)
                rows.append((reference, response, _unit(chosen[1], how, reference=True)))
                places.append(place)
    if not rows or form is None:
        raise nothing_left(notes)
    (start, rate), motion = form[1], ratio_of(form[3]).over
    if motion.motion is None:
        notes.drop("response", f'"{form[3]}" is no displacement, velocity or acceleration')
        raise nothing_left(notes)
    drive = label_of(rows[0][2])
    source = _FromFile(path, [row[0] for row in rows], [row[1] for row in rows])
    return TimeScan(
        source, tuple(names),
        np.array([x for x, _ in places]), np.array([y for _, y in places]),
        1, form[0], rate, how.reference or f"reference, {drive.unit or 'V'}",
        motion=motion.motion, response_scale=motion.factor, reference_scale=drive.factor,
        start=start, origin=origin, title=title,
    )  # fmt: skip


def open_tdms(path: Path) -> TdmsFile:
    """A whole TDMS file.

    Raises
    ------
    ScanError : npTDMS is not installed, or the file is damaged
    """
    nptdms = nptdms_for(path)
    try:
        return nptdms.TdmsFile.read(path)
    except PermissionError:
        raise
    except DAMAGED as error:
        raise _damaged(path, error) from error


def _damaged(path: Path, error: Exception) -> ScanError:
    return ScanError(
        argument="TDMS file",
        given=f"{path} ({type(error).__name__})",
        allowed="a whole TDMS file",
        cause="the file is of another kind, or its copy was interrupted",
        next_step="copy it again, without the .tdms_index file beside it",
    )


def _channels(channels: list[TdmsChannel], how: Mapped) -> tuple[TdmsChannel, TdmsChannel] | None:
    """Response and reference: as the mapping names them, else the one that moves and the other one."""
    by_name = {channel.name: channel for channel in channels}
    names = (how.variables.get("response"), how.variables.get("reference"))
    if all(name in by_name for name in names):
        return by_name[names[0]], by_name[names[1]]
    moving = [c for c in channels if ratio_of(str(c.properties.get("unit_string", ""))).over.motion]
    others = [c for c in channels if c not in moving]
    return (moving[0], others[0]) if len(moving) == len(others) == 1 else None


def _timing(channel: TdmsChannel) -> tuple[float, float]:
    """Time of the first sample (s) and rate (Hz). npTDMS.time_track needs both properties."""
    step = float(channel.properties.get("wf_increment", 0.0))
    return float(channel.properties.get("wf_start_offset", 0.0)), 1 / step if step > 0 else 0.0


def _unit(channel: TdmsChannel, how: Mapped, *, reference: bool = False) -> str:
    return str(channel.properties.get("unit_string") or ("V" if reference else how.unit))


def _place(properties: dict[str, Any], length_unit: float) -> tuple[float, float] | None:
    for names in POSITION:
        if all(name in properties for name in names):
            x, y = (length_unit * float(properties[name]) for name in names)
            return (x, y) if np.isfinite([x, y]).all() else None
    return None
