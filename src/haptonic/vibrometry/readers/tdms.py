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
from haptonic.errors import ScanError
from haptonic.foreign.process import damaged
from haptonic.response import Reference
from haptonic.vibrometry.curves import nothing_left
from haptonic.vibrometry.readers.mapped import Mapped, check_meanings, find_named
from haptonic.vibrometry.readers.quantities import UNIT
from haptonic.vibrometry.records import TimeScan

POSITION = (("x", "y"), ("X", "Y"), ("x_m", "y_m"), ("x_mm", "y_mm"))
MEANINGS = ("response", "reference", "x", "y")


@dataclass(frozen=True, eq=False)
class _TdmsRecords:
    """Channels of a file, one for each point, by group and name, read for several points together."""

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
    """Make time records of a file in which each group is a point.

    A group has one channel of the response and one of the reference, distinguished by name or by unit.

    Raises
    ------
    ScanError : the file has no usable point
    """
    check_meanings(how, MEANINGS)
    if any(group.simulated for group in groups.values()):
        origin = SIMULATED
    lacking: list[ScanError] = []
    names, rows, places = [], [], []
    form: tuple[Any, ...] | None = None
    for group in groups.values():
        try:
            chosen = _channels(group, how, notes)
        except ScanError as error:
            lacking.append(error)
            notes.drop(f"point {group.name}", f"it has no channel {error.given}")
            continue
        place = _place(group.properties, how)
        if chosen is None:
            among = ", ".join(group.signals) or "none"
            notes.drop(
                f"point {group.name}", f"no pair of a response and a reference among its channels ({among})"
            )
        elif place is None:
            notes.drop(f"point {group.name}", "no coordinates: its group has no properties x and y")
        else:
            response, reference = chosen
            times = [(channel.start, channel.rate) for channel in chosen]
            point_form = (response.size, *times, response.unit or how.unit or UNIT)
            form = form or point_form
            if point_form != form or reference.size != response.size or not response.size:
                notes.drop(
                    f"point {group.name}", f"{point_form[0]} samples, rate or unit differ from the first's"
                )
            else:
                names.append(group.name)
                rows.append((reference, response))
                places.append(place)
    if not rows and lacking:
        raise lacking[0]
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


def _channels(group: Group, how: Mapped, notes: Notebook) -> tuple[Channel, Channel] | None:
    """Response and reference: as the user names them, else the channel of a motion and the other one.

    Raises
    ------
    ScanError : the group has no channel with a name from the user
    """
    channels = dict(group.signals)
    named = {
        meaning: channels.pop(find_named(how.variables[meaning], meaning, group.signals, notes))
        for meaning in ("response", "reference")
        if meaning in how.variables
    }
    if len(named) == 2:
        return named["response"], named["reference"]
    if len(named) == 1 and len(channels) == 1:
        (other,) = channels.values()
        return (named["response"], other) if "response" in named else (other, named["reference"])
    if named or len(channels) != 2:
        return None
    first, second = channels.values()
    moves = [ratio_of(channel.unit).over.motion is not None for channel in (first, second)]
    if moves[0] == moves[1]:
        return None
    return (first, second) if moves[0] else (second, first)


def _place(properties: Mapping[str, Any], how: Mapped) -> tuple[float, float] | None:
    wanted = tuple(how.variables[axis] for axis in "xy") if {"x", "y"} <= how.variables.keys() else None
    for names in [wanted] if wanted else POSITION:
        if all(name in properties for name in names):
            factor = how.length_unit or (1e-3 if names == ("x_mm", "y_mm") else 1.0)
            x, y = (factor * number_of(properties[name]) for name in names)
            return (x, y) if np.isfinite([x, y]).all() else None
    return None
