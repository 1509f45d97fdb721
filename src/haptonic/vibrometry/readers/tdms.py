"""Time records of TDMS files: one group for each point, with its position in the group's properties."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from haptonic.channels import Channel, Group, Notebook, tdms
from haptonic.channels.labels import label_of, ratio_of
from haptonic.channels.signals import SIMULATED, Origin, Samples, number_of
from haptonic.foreign.process import damaged
from haptonic.response import Reference
from haptonic.vibrometry.curves import nothing_left
from haptonic.vibrometry.readers.tables import Mapped
from haptonic.vibrometry.records import TimeScan

POSITION = (("x", "y"), ("X", "Y"), ("x_m", "y_m"))


@dataclass(frozen=True, eq=False)
class _TdmsRecords:
    """Channels of a file, one for each point, by group and name; those of some points are read together."""

    path: Path
    reference: list[tuple[str, str]]
    response: list[tuple[str, str]]

    def load(self, start: int, stop: int) -> tuple[Samples, Samples]:
        rows = tdms.samples(self.path, [*self.reference[start:stop], *self.response[start:stop]])
        half = len(rows) // 2
        try:
            return np.stack(rows[:half])[:, None], np.stack(rows[half:])[:, None]
        except ValueError as error:
            raise damaged(self.path, "channels of unequal length") from error


def scan_of_groups(
    groups: Mapping[str, Group], how: Mapped, notes: Notebook, origin: Origin, title: str
) -> TimeScan:
    """Time records of a file in which each group is a point.

    A group has one channel of the response and one of the reference, named so or told apart by their units.

    Raises
    ------
    ScanError : the file holds no usable point
    """
    if any(group.simulated for group in groups.values()):
        origin = SIMULATED
    names, rows, places = [], [], []
    form: tuple[Any, ...] | None = None
    for group in groups.values():
        chosen = _channels(group, how)
        place = _place(group.properties, how.length_unit)
        if chosen is None:
            notes.drop(f"point {group.name}", "no pair of a response and a reference channel")
        elif place is None:
            notes.drop(f"point {group.name}", "no coordinates: its group has no properties x and y")
        else:
            response, reference = chosen
            times = [(channel.start, channel.rate) for channel in chosen]
            found = (response.size, *times, response.unit or how.unit)
            form = form or found
            if found != form or reference.size != response.size or not response.size:
                notes.drop(f"point {group.name}", f"{found[0]} samples, rate or unit differ from the first's")
            else:
                names.append(group.name)
                rows.append((reference, response))
                places.append(place)
    if not rows or form is None:
        raise nothing_left(notes)
    (start, rate), motion = form[1], ratio_of(form[3]).over
    if motion.motion is None:
        notes.drop("response", f'"{form[3]}" is no displacement, velocity or acceleration')
        raise nothing_left(notes)
    drive = label_of(rows[0][0].unit or "V")
    named = [[(name, channel.name) for name, channel in zip(names, column, strict=True)]
             for column in zip(*rows, strict=True)]  # fmt: skip
    return TimeScan(
        source=_TdmsRecords(notes.path, *named), names=tuple(names),
        x=np.array([x for x, _ in places]), y=np.array([y for _, y in places]),
        repeats=1, samples=form[0], sample_rate=rate,
        reference=how.reference or Reference("reference", drive.unit or "V"),
        motion=motion.motion, response_scale=motion.factor, reference_scale=drive.factor,
        start=start, origin=origin, title=title,
    )  # fmt: skip


def _channels(group: Group, how: Mapped) -> tuple[Channel, Channel] | None:
    """Response and reference: as the mapping names them, else the one that moves and the other one."""
    names = (how.variables.get("response", ""), how.variables.get("reference", ""))
    if all(name in group.signals for name in names):
        return group.signals[names[0]], group.signals[names[1]]
    channels = list(group.signals.values())
    if len(channels) != 2:
        return None
    moves = [ratio_of(one.unit).over.motion is not None for one in channels]
    if moves[0] == moves[1]:
        return None
    return (channels[0], channels[1]) if moves[0] else (channels[1], channels[0])


def _place(properties: Mapping[str, Any], length_unit: float) -> tuple[float, float] | None:
    for names in POSITION:
        if all(name in properties for name in names):
            x, y = (length_unit * number_of(properties[name]) for name in names)
            return (x, y) if np.isfinite([x, y]).all() else None
    return None
