"""Remarks and doubts about the sensor and the records of an experiment, in sentences."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import FrictionError
from haptonic.friction.recordings.channel_map import ChannelMap
from haptonic.friction.recordings.mounting import Mounting, begins_sliding, mounting_of
from haptonic.friction.signals.limits import RangeEnds
from haptonic.friction.signals.record import Record
from haptonic.friction.signals.rules import OTHER_WAY, REMEDIES, UNREADABLE
from haptonic.later import xarray as xr
from haptonic.names import counted

SLIPPERY = 0.03  # median friction; on a plate that is not driven a fingertip has more
STICKY = 1.0  # median friction above which normal and tangential force may be exchanged
FEWEST_EXCHANGED = 2  # records that show that the forces are exchanged
MOST_NAMED = 10  # participants that a sentence names
MOST_DETAILS = 3  # reasons why records cannot be read that are listed


def mounted(channel_map: ChannelMap, records: Mapping[str, Sequence[Record]]) -> ChannelMap:
    """The channel map with the orientation of the sensor for each participant, and unusual facts about it."""
    sign, angle = channel_map.sign_unknown, channel_map.axis_unknown
    exchanged = _exchanged(channel_map, records)
    within = _within_ranges(records)
    lay = {name: mounting_of(some, sign=sign, angle=True) for name, some in within.items()}
    remarks, doubts = _signs(lay)
    doubts += exchanged
    along, across = channel_map.plane
    if angle:
        doubts += [
            f'the strokes of {people_text(names)} go {text} from "{along}" towards "{across}": the force '
            "along them was taken as tangential"
            for text, names in _alike(lay)
        ]
    else:
        doubts += [
            f'the strokes of {people_text(names)} go {text} from "{along}", which trials.sensor.tangential '
            f'names, towards "{across}": part of the friction is left out; leave tangential out in '
            "[trials.sensor] to have both forces combined"
            for text, names in _alike(lay)
        ]
        lay = {name: Mounting(mounting.sign) for name, mounting in lay.items()}
    return channel_map.mounted(lay, tuple(remarks), tuple(doubts))


def _within_ranges(records: Mapping[str, Sequence[Record]]) -> dict[str, list[Record]]:
    """Records of each participant without those with a channel at the end of its range, if others are left.

    Such a channel changes the direction of the force in the plane.
    """
    ends = RangeEnds.of([record.channels for some in records.values() for record in some])
    reached = iter(ends.reached().tolist())
    within = {name: [record for record in some if not next(reached)] for name, some in records.items()}
    return {name: within[name] or list(some) for name, some in records.items()}


def _exchanged(channel_map: ChannelMap, records: Mapping[str, Sequence[Record]]) -> list[str]:
    """A doubt if the tangential force begins before the normal force in most records, and both are named.

    Raises
    ------
    FrictionError : the forces are exchanged, and the study does not name both
    """
    begin = [begins_sliding(record) for some in records.values() for record in some]
    if 2 * sum(begin) <= len(begin) or sum(begin) < FEWEST_EXCHANGED:
        return []
    given = f"a tangential force before the finger presses, in {sum(begin)} of {len(begin)} records"
    if channel_map.named:
        return [f"{given}: friction cannot do so; check whether normal and tangential force are exchanged"]
    along, across = channel_map.plane
    others = " or ".join(f'"{name}"' for name in (along, across) if name)
    raise FrictionError.conflict(
        argument="trials.sensor.normal",
        given=given,
        allowed="a normal force that begins before the tangential one, or with it: friction needs a load",
        cause="normal and tangential force are exchanged, or the normal force is another channel",
        next_step=f"name both in [trials.sensor]: normal is perhaps {others}",
    )


def _signs(lay: Mapping[str, Mounting]) -> tuple[list[str], list[str]]:
    """Remarks on a reversed sign of the normal force, and doubts about participants who differ in it."""
    turned = [name for name, mounting in lay.items() if mounting.sign < 0]
    if not turned:
        return [], []
    if len(turned) == len(lay):
        return ["the normal force falls where the finger presses: its sign was turned"], []
    few = turned if 2 * len(turned) <= len(lay) else [name for name in lay if name not in turned]
    return [], [
        f"the normal force of {people_text(few)} goes the other way than that of the others: each "
        "participant's sign was taken so that the finger presses"
    ]


def _alike(lay: Mapping[str, Mounting]) -> list[tuple[str, list[str]]]:
    """Participants by the direction of their strokes (text), without strokes along the named channel."""
    by_direction: dict[str, list[str]] = {}
    for name, mounting in lay.items():
        if mounting.angle:
            by_direction.setdefault(f"{5 * round(np.degrees(mounting.angle) / 5)}°", []).append(name)
    every = len(lay)
    return [(text, names if len(names) < every else []) for text, names in by_direction.items()]


def people_text(names: Sequence[str]) -> str:
    """Names of participants for a sentence; an empty list means all of them."""
    if not names:
        return "all participants"
    more = len(names) - MOST_NAMED
    return ", ".join(names[:MOST_NAMED]) + (f" and {more} more" if more > 0 else "")


def remarked(remarks: NDArray[Any], people: NDArray[Any]) -> list[str]:
    """Remarks on records, each with the number of its trials and their participants."""
    rows: dict[str, list[int]] = {}
    for row, some in enumerate(remarks):
        for text in some:
            rows.setdefault(text, []).append(row)
    return [
        f"{text} ({len(where)} of {len(remarks)} trials, {_whose(where, people)})"
        for text, where in rows.items()
    ]


def _whose(rows: Sequence[int], people: NDArray[Any]) -> str:
    names = list(dict.fromkeys(str(people[row]) for row in rows))
    every = len(set(people.tolist()))
    return "all participants" if len(names) == every else people_text(names)


def explained(trials: xr.Dataset) -> xr.Dataset:
    """The table with a detail for every trial that was left out: the likely cause."""
    detail = trials["detail"].values.astype(object)
    for row, reason in enumerate(trials["excluded"].values.tolist()):
        if reason in REMEDIES and not detail[row]:
            cause, next_step = REMEDIES[reason]
            detail[row] = f"{cause}; {next_step}"
    return trials.assign(detail=("stroke", detail.astype(str)))


def doubts_of(trials: xr.Dataset, normal: str) -> list[str]:
    """Doubts about the trials: a sign that disagrees with the study's, or a friction unlike a fingertip's."""
    excluded, people = trials["excluded"].values, trials["participant"].values
    doubts = []
    against = excluded == OTHER_WAY
    for person in dict.fromkeys(people[against].tolist()):
        rows = people == person
        share = int((against & rows).sum())
        named = f'normal = "{normal}" in [trials.sensor]' if normal.startswith("-") else "the other trials"
        doubts.append(
            f"the normal force of {person} goes the other way than that of {named}, in {share} of "
            f"{int(rows.sum())} trials: they were left out"
        )
    details = trials["detail"].values[excluded == UNREADABLE].tolist()
    doubts += [
        f"{counted(details.count(detail), 'trial')} without a readable record: {detail}"
        for detail in list(dict.fromkeys(details))[:MOST_DETAILS]
    ]
    doubts += _unchecked(trials)
    counts = excluded == ""
    off = counts & (trials["actuation"].values == "off")
    friction = trials["friction"].values[off if off.any() else counts]
    middle = float(np.median(friction)) if friction.size else np.nan
    if middle < SLIPPERY:
        doubts.append(
            f"a friction of {middle:.2g} is too low for a fingertip: the tangential force is another channel "
            "or has another unit; check tangential and force_unit in [trials.sensor]"
        )
    elif middle > STICKY:
        doubts.append(
            f"a friction of {middle:.2g} is high for a fingertip: if normal and tangential force are "
            "exchanged, name them with normal and tangential in [trials.sensor]"
        )
    return doubts


def _unchecked(trials: xr.Dataset) -> list[str]:
    """A sentence about trials whose records do not end at rest, so that a small drift cannot be seen."""
    window = json.loads(trials.attrs.get("rules", "{}")).get("bias_window")
    if "sensor_drift" not in trials or not window:
        return []
    counts = trials["excluded"].values == ""
    unknown = int((np.isnan(trials["sensor_drift"].values) & counts).sum())
    if not unknown:
        return []
    return [
        f"{unknown} of {int(counts.sum())} records do not end at rest: a drift of the sensor is not "
        "corrected there, and seen only where the rest at the start shows it; let the finger leave the "
        "plate before a record ends"
    ]
