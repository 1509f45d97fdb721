"""Times of samples as computers write them: scattered, rounded, doubled, with lost rows, or times of day."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.errors import FrictionError

JITTER = 0.1  # of a sampling interval: times that scatter by less are even
ROUNDED = 0.75  # of the step to which times are rounded: largest distance of even samples from their grid
SCATTERED = 1.5  # sampling intervals by which the times of even samples may scatter
LOST = 4.0  # times the usual step: a longer step means lost rows
LONGEST_GAP = 0.03  # s, longest bridged gap: forces below 50 Hz change little within half of that
MOST_LOST = 0.2  # largest share of the record in gaps
COARSEST = 0.05  # error of a sampling rate from rounded times
FASTEST = 1e6  # Hz: above any force sensor, so the times are in another unit
DAY = 86400.0

NEAR = 0.5  # of a sampling interval: usual steps of times that agree with a rate
ALIKE = 0.05  # largest relative difference of the times' mean rate from the given one
SCATTER = "the times scatter: the samples were taken as equidistant"
UNEVEN = "the samples lie at uneven times: they were interpolated on an even grid"
BRIDGED = f"rows are missing for up to {1e3 * LONGEST_GAP:g} ms at a time: these gaps were bridged by lines"
REPEATED = "rows that repeat the row above them, with its time, were left out"
OTHER_RATE = "the column of times gives another sampling rate than trials.sensor.rate, which was used"
ADVICE = 'give the sampling rate, such as rate = "1 kHz", in [trials.sensor]: it goes before the times'

_OF_DAY = re.compile(
    r"(?:.*[\sT])?(?P<hour>\d{1,2}):(?P<minute>\d{2})(?::(?P<second>\d{2}(?:[.,:]\d+)?))?"
    r"\s*(?P<half>[AaPp])?\.?(?:[Mm]\.?)?(?:Z|[+-]\d{2}:?\d{2})?\s*"
)


@dataclass(frozen=True, eq=False)
class Clock:
    """Sampling rate of a file, and the map from its rows to even times.

    rate : Hz
    times : (row,) s, ascending, times of the rows; None if the rows are evenly spaced
    once : (row of the file,) False for rows that repeat the row above them and are left out; None if there
        are
    none
    remark : change made because of the times; empty if none
    """

    rate: float
    times: Array | None = None
    once: Bools | None = None
    remark: str = ""

    def without(self, repeats: Bools) -> Clock:
        """A clock for a file with rows that repeat the row above them; this clock is for the other rows."""
        if not repeats.any():
            return self
        remark = f"{REPEATED}; {self.remark}" if self.remark else REPEATED
        return replace(self, once=~repeats, remark=remark)

    def regular(self, values: Array) -> Array:
        """Samples at even times; rows of the same time count as their mean."""
        values = values if self.once is None else values[self.once]
        if self.times is None:
            return values
        times, first, count = np.unique(self.times, return_index=True, return_counts=True)
        means = np.add.reduceat(np.asarray(values, dtype=float), first) / count
        grid = np.arange(np.floor((times[-1] - times[0]) * self.rate + 1e-6) + 1) / self.rate
        return np.asarray(np.interp(times[0] + grid, times, means))

    def rows(self, values: Array, first: int, last: int | None) -> Array:
        """Values of the file, unchanged, between two of the even samples."""
        values = values if self.once is None else values[self.once]
        if self.times is None:
            return values[first:last]
        ends = [None if end is None else self.times[0] + end / self.rate for end in (first, last)]
        start, stop = (None if end is None else int(np.searchsorted(self.times, end)) for end in ends)
        return values[start:stop]


def repeats_of(time: Array, channels: Iterable[Array]) -> Bools:
    """(row,) True for rows that repeat the row above them; all False unless all rows of equal time do.

    A coarse clock gives the same time to different rows.
    """
    none = np.zeros(len(time), dtype=bool)
    same = np.concatenate([[False], np.diff(time) == 0]) if len(time) else none
    if not same.any():
        return none
    for values in channels:
        if len(values) == len(time) and not (values[1:] == values[:-1])[same[1:]].all():
            return none
    return same


def clock_of(time: Array, where: str) -> Clock:
    """Make the clock of a record from the times of its rows, s.

    Times that scatter about even ones, or are rounded, belong to even samples; others are interpolated. Short
    gaps of missing rows are bridged.

    Raises
    ------
    FrictionError : times that are missing, decrease or are too coarse, or a longer gap; ``where`` is the file
    """
    if len(time) < 2:
        raise _unusable(where, f"{len(time)} times", "an empty or a cut record", "look at the file")
    if not np.isfinite(time).all():
        row = int(np.flatnonzero(~np.isfinite(time))[0]) + 1
        raise _unusable(where, f"sample {row} without a time", "a cell is empty or contains text", ADVICE)
    steps, span = np.diff(time), float(time[-1] - time[0])
    mean = span / len(steps)
    if span < 0 or steps.min() < -SCATTERED * abs(mean):
        raise _going_back(where, steps)
    if span == 0:
        raise _unusable(
            where, "the same time in every row", "the clock is too coarse, or did not run", ADVICE
        )
    typical = float(np.median(steps))
    if (np.abs(steps - typical) < JITTER * typical).all():
        return _plausible(Clock(1 / mean), where)
    rounded = float(steps[steps > 0].min())
    if (steps == 0).any():
        coarse = float(np.median(steps[steps > 0]))
        if coarse > COARSEST * span:
            raise _unusable(
                where, f"times that are rounded to {coarse:g} s, in a record of {span:.3g} s",
                "the clock does not show fractions of a second", ADVICE,
            )  # fmt: skip
    tidy = np.mean(np.abs(steps - typical) < JITTER * typical) > 0.9
    usual = 1.5 * typical if tidy else LOST * max(typical, mean)
    usual = max(usual, 1.5 * rounded) if (steps == 0).any() else usual
    gaps = steps > usual
    if not gaps.any():
        place = np.arange(len(time))
        step, start = np.polyfit(place, time - time[0], 1)
        allowed = max(SCATTERED * step, ROUNDED * rounded if (steps == 0).any() else 0.0)
        if step > 0 and np.abs(time - time[0] - start - step * place).max() <= allowed:
            return _plausible(Clock(float(1 / step), remark=SCATTER), where)
    if steps.min() < 0:
        raise _going_back(where, steps)
    even = typical if tidy else float(np.median(np.diff(np.unique(time))))
    if gaps.any():
        longest = int(np.argmax(steps))
        lost = float((steps[gaps] - even).sum())
        if steps[longest] > LONGEST_GAP + even or lost > MOST_LOST * span:
            even_anyway = "record this trial again; or, if the samples follow each other evenly, " + ADVICE
            raise _rows_lost(time, where, even_anyway)
    return _plausible(Clock(1 / even, times=time, remark=BRIDGED if gaps.any() else UNEVEN), where)


def clock_at(rate: float, time: Array, where: str) -> Clock:
    """Make the clock of a record with a given rate, Hz, which goes before the times of its rows, s.

    Raises
    ------
    FrictionError : the times agree with the rate and show that rows are missing; ``where`` is the file
    """
    steps = np.diff(time)
    if not steps.size or not np.isfinite(steps).all() or time[-1] == time[0]:
        return Clock(rate)
    if abs(np.median(steps) * rate - 1) < NEAR and steps.max() > LONGEST_GAP + 1 / rate:
        raise _rows_lost(
            time, where, "record this trial again; or, if none was lost, take the times out of the file"
        )
    mean = len(steps) / float(time[-1] - time[0])
    return Clock(rate, remark="" if abs(mean - rate) <= ALIKE * rate else OTHER_RATE)


def _rows_lost(time: Array, where: str, next_step: str) -> FrictionError:
    longest = int(np.argmax(np.diff(time)))
    return _unusable(
        where, f"times that do not advance evenly: no sample for {time[longest + 1] - time[longest]:.3g} s "
        f"after {time[longest] - time[0]:.3g} s", "rows were lost", next_step,
    )  # fmt: skip


def _going_back(where: str, steps: Array) -> FrictionError:
    row = int(np.flatnonzero(steps < 0)[0]) + 2
    return _unusable(
        where, f"times that do not advance evenly: they go back at sample {row}",
        "rows were sorted or joined, or the clock started again: several records in one file",
        "divide the file there; or, if the samples follow each other evenly, " + ADVICE,
    )  # fmt: skip


def seconds_of_day(texts: Sequence[Any], where: str) -> Array:
    """Times of day such as "10:31:00.002", "1/5/2024 10:31:00.002 AM", in s, increasing beyond midnight.

    Raises
    ------
    FrictionError : a text that is not a time of day
    """
    seconds = np.empty(len(texts))
    for row, text in enumerate(texts):
        match = _OF_DAY.fullmatch(str(text).strip())
        if match is None:
            raise _unusable(
                where, f'"{text}" in sample {row + 1}', "not a time of day, such as 10:31:00.002", ADVICE
            )
        hour = float(match["hour"])
        if match["half"]:
            hour = hour % 12 + 12 * (match["half"] in "pP")
        whole = (match["second"] or "0").replace(",", ".").replace(":", ".")
        seconds[row] = 3600 * hour + 60 * float(match["minute"]) + float(whole)
    return seconds + DAY * np.concatenate([[0.0], np.cumsum(np.diff(seconds) < -0.5 * DAY)])


def _plausible(clock: Clock, where: str) -> Clock:
    if clock.rate > FASTEST:
        raise _unusable(
            where, f"{clock.rate:.3g} samples per second", "the times are in another unit than stated",
            'give time_unit, such as time_unit = "ms", in [trials.sensor]',
        )  # fmt: skip
    return clock


def _unusable(where: str, given: str, cause: str, next_step: str) -> FrictionError:
    return FrictionError.malformed(
        argument=where,
        given=given,
        allowed="ascending times of the samples",
        cause=cause,
        next_step=next_step,
    )
