"""From force records to coefficients of friction, with all left-out samples and trials and their reasons.

Strokes of equal length are processed together: a filter over many records costs little more than over one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Bools
from haptonic.friction.signals.filters import design_frequency, smoothed
from haptonic.friction.signals.jumps import jumps
from haptonic.friction.signals.limits import RangeEnds
from haptonic.friction.signals.record import Record
from haptonic.friction.signals.rest import RETURNED, drifts, rest_of
from haptonic.friction.signals.rules import (
    DEFAULT_RULES,
    DRIFTS,
    JUMPS,
    OTHER_WAY,
    STOPS,
    TOUCHED_EARLY,
    Measured,
    Rules,
)
from haptonic.friction.signals.stops import stops

Columns = dict[str, NDArray[np.generic]]

FEWEST = 10  # samples of a record that a filter can use
TOGETHER = 64  # strokes; their channels fit into the processor's cache
# Without a finger, the sensor's output is small relative to the force of a stroke, and quiet. A finger that
# lies on it from the start is lifted in the end, which leaves little of the force at the start.
LITTLE = 0.2
QUIETER = 0.25  # of the scatter of the normal force at the start: an end with less is without a finger
# Scatter of a finger's force within the bias window, of the force of the stroke. Noise, drift and steps of
# converters in 2000 drawn folders had up to 0.0071 where the end was also quieter.
UNSTEADY = 0.01


@dataclass(frozen=True, eq=False)
class Processed:
    """Strokes of equal length after filter and bias.

    normal, tangential : (stroke, sample) N
    velocity : (stroke, sample) m/s; NaN if no position was recorded
    contact, forwards, plateau : (stroke, sample) pressed, moving in the direction of the stroke, at a steady
        speed
    touched : (stroke,) True if there is contact within the window of the bias already
    pulled : (stroke,) True if the normal force falls when the finger presses
    zero : (stroke,) N, normal force at the start, subtracted as zero
    drift : (stroke,) N, change of the rest from start to end; NaN if the record does not end at rest
    drifting : (stroke,) True if the rest at the start drifts, and no rest at the end corrects it
    """

    normal: Array
    tangential: Array
    velocity: Array
    contact: Bools
    forwards: Bools
    plateau: Bools
    touched: Bools
    pulled: Bools
    zero: Array
    drift: Array
    drifting: Bools

    @property
    def steady(self) -> Bools:
        """The samples of the steady part."""
        return np.asarray(self.contact & self.forwards & self.plateau)


def measure(record: Record, rules: Rules = DEFAULT_RULES) -> Measured:
    """Measure the friction of one stroke over its steady part.

    The steady part is where the finger presses and moves in the direction of the stroke at about its median
    speed; without a position, the middle of the contact.

    Raises
    ------
    FrictionError : a sampling rate too low for the filter
    """
    return Measured(**{name: column.tolist()[0] for name, column in measure_all([record], rules).items()})


def measure_all(records: Sequence[Record], rules: Rules = DEFAULT_RULES) -> Columns:
    """Measure many strokes: (record,) columns by the names of `Measured`, with the limits that they share.

    Raises
    ------
    FrictionError : a sampling rate too low for the filter
    """
    columns, limits = measure_part(records, rules)
    return marked(columns, limits)


def measure_part(records: Sequence[Record], rules: Rules = DEFAULT_RULES) -> tuple[Columns, RangeEnds]:
    """Measure some strokes of an experiment, and detect where their forces stay at an extreme; see `marked`.

    Raises
    ------
    FrictionError : a sampling rate too low for the filter
    """
    columns: Columns = {
        name: np.full(len(records), value, dtype=object if isinstance(value, str) else float)
        for name, value in asdict(Measured()).items()
    }
    limits = RangeEnds.none(len(records))
    for rows in alike(records):
        chosen = [records[row] for row in rows]
        part, ends = _measured(chosen, rules)
        for name, values in part.items():
            columns[name][rows] = values
        limits.put(rows, ends)
    return columns, limits


def marked(columns: Columns, limits: RangeEnds) -> Columns:
    """The columns, with strokes excluded in which a channel is at the end of its range."""
    excluded = columns["excluded"].copy()
    excluded[limits.reached() & (excluded != "missing numbers")] = "saturated channel"
    return {**columns, "excluded": excluded}


def alike(records: Sequence[Record]) -> list[list[int]]:
    """Group records that can be processed together: equal length and rate, all or none with a position."""

    def form(row: int) -> tuple[int, float, bool]:
        record = records[row]
        return len(record.normal), record.rate, record.position is not None

    groups = []
    for _, group in groupby(sorted(range(len(records)), key=form), form):
        rows = list(group)
        groups += [rows[first : first + TOGETHER] for first in range(0, len(rows), TOGETHER)]
    return groups


def channels_of(records: Sequence[Record]) -> Array:
    """(channel, stroke, sample) normal and tangential force and, if recorded, position of records `alike`."""
    channels = [[record.normal for record in records], [record.tangential for record in records]]
    if records[0].position is not None:
        channels.append([record.position for record in records if record.position is not None])
    return np.array(channels, dtype=float)


def processed(channels: Array, rate: float, rules: Rules) -> Processed:
    """Filter, bias, contact and steady part of finite channels from `channels_of`."""
    smooth = smoothed(channels, rate)
    forces = smooth[:2] if rules.filter == "literal" else smoothed(channels[:2], rate, rules.filter)
    window = round(rules.bias_window * rate)
    touched = np.zeros(channels.shape[1], dtype=bool)
    pulled = drifting = touched
    drift, zero = np.full(channels.shape[1], np.nan), np.zeros(channels.shape[1])
    if window:
        start = channels[:2, :, :window].mean(axis=2)
        up, down = (np.abs(end(smooth[0], axis=1) - start[0]) for end in (np.max, np.min))
        pulled = down > np.maximum(up, rules.threshold)
        stroke, far = np.maximum(up, down), np.where(up > down, start[0] + up, start[0] - down)
        back = np.abs(channels[0, :, -window:].mean(axis=1) - start[0]) < RETURNED * stroke
        touched = np.ptp(smooth[0, :, :window], axis=1) > rules.threshold
        leaves = (stroke > rules.threshold) & ~back
        # a sensor at rest shows zero, or if it has an offset, less motion than a finger
        scatter, last = (smooth[0, :, part].std(axis=1) for part in (slice(window), slice(-window, None)))
        quieter = (scatter > UNSTEADY * stroke) & (last < QUIETER * scatter)
        touched |= leaves & ((np.abs(far) < LITTLE * np.abs(start[0])) | quieter)
        rest, settled = rest_of(channels[:2], smooth[0], start, back, window)
        forces = forces - rest
        zero = start[0]
        drift = np.where(settled, rest[0, :, -1] - rest[0, :, 0], np.nan)
        unsure = np.flatnonzero(~settled & ~touched)
        drifting = np.zeros_like(touched)
        drifting[unsure] = [drifts(channels[:2, k], smooth[0, k], rate) for k in unsure]
    normal, tangential = forces
    contact = normal > rules.threshold
    velocity, forwards, plateau = _motion(smooth[2:], rate, tangential, contact, rules)
    return Processed(
        normal=normal,
        tangential=tangential,
        velocity=velocity,
        contact=contact,
        forwards=forwards,
        plateau=plateau,
        touched=touched,
        pulled=pulled & ~touched,
        zero=zero,
        drift=drift,
        drifting=drifting,
    )


def _measured(records: list[Record], rules: Rules) -> tuple[dict[str, NDArray[np.generic]], RangeEnds]:
    rate = records[0].rate
    design_frequency(rules.filter, rate)
    channels = channels_of(records)
    count, samples = channels.shape[1:]
    excluded = np.full(count, "", dtype=object)
    whole = np.isfinite(channels).all(axis=(0, 2))
    excluded[~whole] = "missing numbers"
    limits = RangeEnds.none(count)
    if samples < FEWEST:
        excluded[whole] = "record too short"
    else:
        limits = RangeEnds.of([record.channels for record in records])
        for row in np.flatnonzero(whole):
            if jumps(records[row].channels):
                excluded[row] = JUMPS
            elif stops(records[row].channels):
                excluded[row] = STOPS
        excluded[whole & np.array([record.saturated for record in records])] = "saturated channel"
    usable = np.flatnonzero(excluded == "")
    numbers = {
        name: np.full(count, value) for name, value in asdict(Measured()).items() if name != "excluded"
    }
    if usable.size:
        values, reasons = _numbers(processed(channels[:, usable], rate, rules), rate, rules)
        excluded[usable] = reasons
        for name, column in values.items():
            numbers[name][usable] = column
    return {**numbers, "excluded": excluded}, limits


def _numbers(stroke: Processed, rate: float, rules: Rules) -> tuple[dict[str, Array], NDArray[np.object_]]:
    """Columns of `Measured` by name, and the reasons for exclusion."""
    steady, contact = stroke.steady, stroke.contact
    count = steady.sum(axis=1)
    duration = count / rate
    excluded = np.full(len(count), "", dtype=object)
    excluded[duration < rules.steady] = "steady part too short"
    excluded[~contact.any(axis=1)] = "no contact"
    excluded[stroke.pulled] = OTHER_WAY
    excluded[stroke.drifting & (excluded == "")] = DRIFTS
    excluded[stroke.touched] = TOUCHED_EARLY
    enough, least = excluded == "", np.maximum(count, 1)

    def mean(values: Array) -> Array:
        return np.asarray(np.where(steady, values, 0.0).sum(axis=1) / least)

    size = np.abs(stroke.tangential)
    ratio = size / np.where(steady, stroke.normal, 1.0)
    force, speed, friction = mean(stroke.normal), mean(np.abs(stroke.velocity)), mean(ratio)
    apart = np.where(steady, ratio - friction[:, None], 0.0)
    with np.errstate(divide="ignore", invalid="ignore"):
        numbers = {
            "mean_of_ratios": friction,
            "ratio_of_means": mean(size) / force,
            "spread": np.sqrt((apart**2).sum(axis=1) / (count - 1)),
            "force": force,
            "speed": speed,
            "rest_force": stroke.zero,
            "sensor_drift": stroke.drift,
        }
    numbers = {name: np.where(enough, values, np.nan) for name, values in numbers.items()}
    seen = ~stroke.touched
    pressed = seen & contact.any(axis=1)
    shares = {
        "duration": np.where(pressed, duration, 0.0),
        "below_threshold": np.where(seen, 1 - contact.mean(axis=1), np.nan),
        "reversing": np.where(pressed, (contact & ~stroke.forwards).mean(axis=1), np.nan),
        "off_plateau": np.where(pressed, (contact & stroke.forwards & ~stroke.plateau).mean(axis=1), np.nan),
    }
    slow = np.isfinite(speed) & ~((rules.speed[0] <= speed) & (speed <= rules.speed[1]))
    excluded[enough & slow] = "speed outside of the rule"
    excluded[enough & ~((rules.force[0] <= force) & (force <= rules.force[1]))] = (
        "normal force outside of the rule"
    )
    return {**numbers, **shares}, excluded


def _motion(
    position: Array, rate: float, tangential: Array, contact: Bools, rules: Rules
) -> tuple[Array, Bools, Bools]:
    """Velocity, whether it has the direction of the stroke, and whether the speed is steady."""
    if not len(position):
        forwards = np.sign(tangential) == np.sign(_median(tangential, contact))[:, None]
        rank, pressed = np.cumsum(contact, axis=1) - 1, contact.sum(axis=1, keepdims=True)
        trimmed = np.rint(0.5 * (1 - rules.middle) * pressed)
        return np.full(contact.shape, np.nan), forwards, (rank >= trimmed) & (rank < pressed - trimmed)
    velocity = np.gradient(position[0], 1 / rate, axis=1)
    typical = _median(velocity, contact)
    forwards = velocity * typical[:, None] > 0
    ahead = contact & forwards
    typical = np.where(ahead.any(axis=1), _median(velocity, ahead), typical)[:, None]
    return velocity, forwards, np.abs(velocity - typical) <= rules.plateau * np.abs(typical)


def _median(values: Array, mask: Bools) -> Array:
    """(stroke,) median over the masked samples; 0 for an empty mask."""
    ordered = np.sort(np.where(mask, values, np.inf), axis=1)
    count = mask.sum(axis=1)
    places = np.stack([np.maximum(count - 1, 0) // 2, np.minimum(count // 2, mask.shape[1] - 1)], axis=1)
    middle = np.take_along_axis(ordered, places, axis=1)
    return np.asarray(np.where(count > 0, np.where(count[:, None] > 0, middle, 0.0).mean(axis=1), 0.0))
