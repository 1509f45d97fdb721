"""Table of trials: one row for each stroke, including excluded ones."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import fields
from importlib.metadata import version
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import FrictionError
from haptonic.friction.signals.limits import RangeEnds
from haptonic.friction.signals.measuring import Columns, marked, measure_part
from haptonic.friction.signals.record import Label, Record
from haptonic.friction.signals.rules import DEFAULT_RULES, OMISSIONS, REASONS, TOUCHED_EARLY, Rules
from haptonic.later import xarray as xr

AROUND = 5  # trials of a participant, centred on one, whose median estimates the sensor's rest
PORTION = 256  # records in memory at a time
UNITS = {
    "force": "N",
    "speed": "m/s",
    "duration": "s",
    "rest_force": "N",
    "sensor_drift": "N",
    "friction": "1",
}
IDENTITY = ("participant", "block", "trial")


def measured(records: Iterable[tuple[Label, Record]], rules: Rules = DEFAULT_RULES) -> xr.Dataset:
    """Make a table of trials from force records, which may be read one by one from their files.

    Returns
    -------
    along ``stroke``: the label (``participant``, ``block``, ``trial``, ``waveguide``, ``actuation``), the
    fields of `Measured`, and ``friction``, the mean of ratios. Excluded trials are in the table, with the
    reason in ``excluded``; no statistic uses their numbers.

    Raises
    ------
    FrictionError : no record, two records of one trial, or a sampling rate too low for the filter
    """
    coming = iter(records)
    labels: list[Label] = []
    columns, limits = list[Columns](), list[RangeEnds]()
    while portion := list(islice(coming, PORTION)):
        labels += [label for label, _ in portion]
        numbers, ends = measure_part([record for _, record in portion], rules)
        columns.append(numbers)
        limits.append(ends)
    named = {
        field.name: np.array([getattr(label, field.name) for label in labels]) for field in fields(Label)
    }
    every = marked(joined(columns), RangeEnds.joined(limits)) if columns else {}
    return tabulated(named, every, rules)


def begun_pressed(columns: Columns, people: NDArray[Any]) -> NDArray[np.object_]:
    """Reasons for exclusion, completed by trials in which a pressing finger was taken for the sensor's rest.

    If the finger lies on the plate from start to end, its force at the start is subtracted as zero. Then this
    zero departs from that of neighbouring trials by more than the force of the stroke.
    """
    excluded = columns["excluded"].astype(object)
    rest, force = (np.asarray(columns[name], dtype=float) for name in ("rest_force", "force"))
    for person in dict.fromkeys(people.tolist()):
        rows = np.flatnonzero((people == person) & np.isfinite(rest))
        if len(rows) <= AROUND // 2:
            continue
        padded = np.pad(rest[rows], AROUND // 2, "reflect")
        usual = np.median(np.lib.stride_tricks.sliding_window_view(padded, AROUND), axis=1)
        excluded[rows[(np.abs(rest[rows] - usual) > force[rows]) & (excluded[rows] == "")]] = TOUCHED_EARLY
    return excluded


def joined(parts: list[Columns]) -> Columns:
    """Concatenate columns."""
    return {name: np.concatenate([part[name] for part in parts]) for name in (parts[0] if parts else {})}


def tabulated(
    labels: Mapping[str, NDArray[Any]], columns: Columns, rules: Rules, *, origin: str = "measured"
) -> xr.Dataset:
    """The table of `measured` from its columns; ``origin`` is "measured" or "simulated".

    Raises
    ------
    FrictionError : no row, or two rows of one trial
    """
    if not len(labels["participant"]):
        raise FrictionError.missing(
            argument="records",
            given="none",
            allowed="at least one record",
            cause="an empty folder or table",
            next_step="choose another folder",
        )
    once = set()
    for key in zip(*(labels[name].tolist() for name in IDENTITY), strict=True):
        if key in once:
            raise FrictionError.repeated(
                argument="records",
                given=f"participant {key[0]}, block {key[1]}, trial {key[2]} more than once",
                allowed="one record for each trial",
                cause="a file was read twice, or trials are numbered from 1 again within a block",
                next_step="number the trials of a block consecutively",
            )
        once.add(key)
    excluded = begun_pressed(columns, labels["participant"])
    table = {**labels, **columns, "excluded": excluded, "friction": columns["mean_of_ratios"]}
    table |= {name: column.astype(str) for name, column in table.items() if column.dtype == object}
    data = {
        name: ("stroke", values, {"units": UNITS[name]} if name in UNITS else {})
        for name, values in table.items()
    }
    attributes = {
        "origin": origin,
        "rules": json.dumps({rule.name: getattr(rules, rule.name) for rule in fields(Rules)}),
        "haptonic_version": version("haptonic"),
    }
    return xr.Dataset(data, attrs=attributes)


def exclusions(trials: xr.Dataset) -> dict[str, int]:
    """Number of trials excluded for each of `REASONS` and `OMISSIONS`, then for reasons of other programs."""
    given = [str(reason) for reason in trials["excluded"].values]
    own_reasons = (*REASONS, *OMISSIONS)
    return {
        reason: given.count(reason) for reason in (*own_reasons, *sorted(set(given) - {*own_reasons, ""}))
    }
