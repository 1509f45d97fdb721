"""NI TDMS files: one group for each point, or one channel for each point in one group."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from haptonic.errors import ScanError
from haptonic.foreign.process import ForeignError, ask
from haptonic.response import Reference
from haptonic.vibrometry.curves import nothing_left
from haptonic.vibrometry.findings import Notebook
from haptonic.vibrometry.labels import label_of, ratio_of
from haptonic.vibrometry.readers.tables import ORIGIN, Mapped, Origin
from haptonic.vibrometry.records import Samples, TimeScan

POSITION = (("x", "y"), ("X", "Y"), ("x_m", "y_m"))


@dataclass(frozen=True)
class Channel:
    """A channel of a file: its group, its own name, samples, properties, and whether it holds numbers."""

    group: str
    name: str
    length: int
    properties: dict[str, Any]
    numbers: bool

    @property
    def timing(self) -> tuple[float, float]:
        """Time of the first sample, s, and rate, Hz; a rate of 0 where the file has none.

        npTDMS.time_track needs both properties.
        """
        step = number_of(self.properties.get("wf_increment", 0.0))
        return number_of(self.properties.get("wf_start_offset", 0.0)), 1 / step if step > 0 else 0.0


@dataclass(frozen=True)
class Group:
    """A group of channels."""

    name: str
    properties: dict[str, Any]
    channels: tuple[Channel, ...]


@dataclass(frozen=True)
class Content:
    """What a file describes; the samples stay in it."""

    properties: dict[str, Any]
    groups: tuple[Group, ...]


@dataclass(frozen=True, eq=False)
class _FromFile:
    """Channels of a file, one for each point."""

    path: Path
    reference: list[Channel]
    response: list[Channel]

    def load(self, start: int, stop: int) -> tuple[Samples, Samples]:
        rows = samples_of(self.path, [*self.reference[start:stop], *self.response[start:stop]])
        half = len(rows) // 2
        try:
            return np.stack(rows[:half])[:, None], np.stack(rows[half:])[:, None]
        except ValueError as error:
            raise _damaged(self.path, "channels of unequal length") from error


def read_tdms(path: Path, how: Mapped, notes: Notebook, origin: Origin, title: str) -> TimeScan:
    """Time records of a file in which each group is a point, with its position in the group's properties.

    A group has one channel of the response and one of the reference, named so or told apart by their units
    (``unit_string``); the rate is that of the waveform (``wf_increment``), its start ``wf_start_offset``.

    Raises
    ------
    ScanError : npTDMS is not installed, or the file is damaged or holds no usable point
    """
    return _scan_of(tdms_content(path), path, how, notes, origin, title)


def tdms_content(path: Path) -> Content:
    """What a TDMS file describes.

    Raises
    ------
    ScanError : npTDMS is not installed, or the file is damaged
    """
    nptdms_for(path)
    try:
        found = ask("tdms.tree", path)
    except ForeignError as error:
        raise _damaged(path, error) from error
    groups = [
        Group(
            one["name"],
            one["properties"],
            tuple(Channel(one["name"], **channel) for channel in one["channels"]),
        )
        for one in found["groups"]
    ]
    return Content(found["properties"], tuple(groups))


def samples_of(path: Path, channels: list[Channel]) -> list[Samples]:
    """(sample,) the samples of each.

    Raises
    ------
    ScanError : the file is damaged
    """
    try:
        return list(ask("tdms.channels", path, names=[[one.group, one.name] for one in channels]))
    except ForeignError as error:
        raise _damaged(path, error) from error


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


def _scan_of(file: Content, path: Path, how: Mapped, notes: Notebook, origin: Origin, title: str) -> TimeScan:
    if str(file.properties.get(ORIGIN)) == "simulated":
        origin = "simulated"
    names, rows, places = [], [], []
    form: tuple[Any, ...] | None = None
    for group in file.groups:
        chosen = _channels(group.channels, how)
        place = _place(group.properties, how.length_unit)
        if chosen is None:
            notes.drop(f"point {group.name}", "no pair of a response and a reference channel")
        elif place is None:
            notes.drop(f"point {group.name}", "no coordinates: its group has no properties x and y")
        else:
            response, reference = chosen
            found = (response.length, *(channel.timing for channel in chosen), _unit(chosen[0], how))
            form = form or found
            if found != form or reference.length != response.length or not response.length:
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
        1, form[0], rate, how.reference or Reference("reference", drive.unit or "V"),
        motion=motion.motion, response_scale=motion.factor, reference_scale=drive.factor,
        start=start, origin=origin, title=title,
    )  # fmt: skip


def _damaged(path: Path, found: object) -> ScanError:
    return ScanError(
        argument="TDMS file",
        given=f"{path} ({found})",
        allowed="a whole TDMS file",
        cause="the file is of another kind, or its copy was interrupted",
        next_step="copy it again, without the .tdms_index file beside it",
    )


def _channels(channels: tuple[Channel, ...], how: Mapped) -> tuple[Channel, Channel] | None:
    """Response and reference: as the mapping names them, else the one that moves and the other one."""
    channels = tuple(channel for channel in channels if channel.numbers)
    by_name = {channel.name: channel for channel in channels}
    names = (how.variables.get("response", ""), how.variables.get("reference", ""))
    if all(name in by_name for name in names):
        return by_name[names[0]], by_name[names[1]]
    if len(channels) != 2:
        return None
    moves = [ratio_of(str(one.properties.get("unit_string", ""))).over.motion is not None for one in channels]
    if moves[0] == moves[1]:
        return None
    return (channels[0], channels[1]) if moves[0] else (channels[1], channels[0])


def _unit(channel: Channel, how: Mapped, *, reference: bool = False) -> str:
    return str(channel.properties.get("unit_string") or ("V" if reference else how.unit))


def _place(properties: dict[str, Any], length_unit: float) -> tuple[float, float] | None:
    for names in POSITION:
        if all(name in properties for name in names):
            x, y = (length_unit * number_of(properties[name]) for name in names)
            return (x, y) if np.isfinite([x, y]).all() else None
    return None


def number_of(given: object) -> float:
    """A property as a number; a text that is none is NaN."""
    try:
        return float(str(given))
    except ValueError:
        return float("nan")
