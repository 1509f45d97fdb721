"""Forces that stay at the end of a channel's range, distinguished from those of a coarse converter."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Bools

# Evidence of a stroke for an end of a channel's range.
NOTHING = 0
TOUCHES = 1  # equal samples in a row at its extreme: an end if another stroke shows that it is one
STAYS = 2  # it stays there longer than a smooth peak: an end if no stroke goes beyond
SURE = 3  # it stays there, and noise would have moved it

MOST = 6  # channels of a sensor
COUNTS = 30.0  # steps of the converter within a stroke; with fewer, a quiet force stays at one value
ROUNDED = 1e-5  # relative; files in other units round the same end to other numbers
RUN = 5  # equal samples in a row
AWAY = 0.3  # of the range of the stroke, or of the way to its extreme: nearer to rest, it is not an end
OPPOSITE = 0.5  # the same for an end that is nearer to zero than the other extreme
# When an end changes a stroke by 2 %, all of 19,495 (drawn as in tests/friction/test_limits.py) were seen;
# of 28,165 within the range none was excluded. Steps of 15, 20 mN: 6 of 4961 missed, none of 6997 excluded.
# A smooth peak stays at its last step for at most 2 + 2 sqrt(2) = 4.8 times as long as at the step before.
LONGER = 5.0
CHANCE = 1e-6  # probability that noise leaves all samples of a run unchanged, below which the run is an end
NOISY = 0.3  # of a step of the converter: smaller noise cannot be measured
LOUDEST = 0.03  # share of the second differences that is left out: jumps where rows are missing
SHORTEST = 0.1  # quantile of the lengths of runs: samples for each change of the channel


@dataclass(frozen=True, eq=False)
class RangeEnds:
    """Evidence of strokes for the ends of the channels' ranges, the upper and the lower end of each channel.

    shown : (2 `MOST`, stroke) `NOTHING` to `SURE`
    level : same shape, largest and negative smallest value; -inf for missing channels
    step : (stroke,) smallest difference of two values of a channel
    """

    shown: NDArray[np.int8]
    level: Array
    step: Array

    @classmethod
    def none(cls, count: int) -> RangeEnds:
        """Evidence of strokes without channels: nothing."""
        shape = 2 * MOST, count
        return cls(np.zeros(shape, np.int8), np.full(shape, -np.inf), np.full(count, np.inf))

    @classmethod
    def of(cls, strokes: Sequence[Array]) -> RangeEnds:
        """Evidence of strokes, each (channel, sample) as the sensor gave them, at most `MOST` channels."""
        ends = cls.none(len(strokes))
        for stroke, channels in enumerate(strokes):
            if not np.isfinite(channels).all() or channels.shape[1] < RUN:
                continue
            for k, values in enumerate(channels):
                step = np.diff(np.unique(values)).min(initial=np.inf)
                ends.step[stroke] = min(ends.step[stroke], step)
                for end, signed in ((2 * k, values), (2 * k + 1, -values)):
                    top = ends.level[end, stroke] = signed.max()
                    if np.count_nonzero(signed == top) >= RUN:
                        ends.shown[end, stroke] = shown_by(signed)
        return ends

    @classmethod
    def joined(cls, parts: Sequence[RangeEnds]) -> RangeEnds:
        """Evidence of many strokes, one part after the other."""
        every = ([getattr(part, name) for part in parts] for name in ("shown", "level", "step"))
        return cls(*(np.concatenate(values, axis=-1) for values in every))

    def put(self, rows: Sequence[int], part: RangeEnds) -> None:
        """Enter the evidence of some strokes."""
        self.shown[:, rows], self.level[:, rows], self.step[rows] = part.shown, part.level, part.step

    def reached(self) -> Bools:
        """(stroke,) True if a channel is at its end, by this stroke or by all strokes together."""
        if not self.level.size:
            return np.zeros(0, dtype=bool)
        # a steep channel skips steps of the converter that others use
        used = self.level.reshape(MOST, 2, -1).sum(axis=1)
        shown = np.where((used >= COUNTS * self.step.min()).repeat(2, axis=0), self.shown, NOTHING)
        end = self.level.max(axis=1, keepdims=True)
        farthest = self.level >= end - ROUNDED * np.abs(end)
        is_end = (farthest & (shown >= STAYS)).any(axis=1, keepdims=True)
        return np.asarray(((shown == SURE) | (is_end & farthest & (shown >= TOUCHES))).any(axis=0))


def shown_by(values: Array) -> int:
    """Evidence of (sample,) values of a channel for the upper end of its range: `NOTHING` to `SURE`."""
    top, bottom, rest = values.max(), values.min(), float(np.median(values[: max(1, len(values) // 20)]))
    # an end of a range is far from zero, or the sensor rests elsewhere before and after the stroke
    far = top >= -bottom
    if top - rest <= (AWAY if far else OPPOSITE) * (top - bottom) or not (far or values[-1] < top):
        return NOTHING
    changes = np.flatnonzero(np.concatenate([[True], np.diff(values) != 0]))
    lengths, levels = np.diff(np.concatenate([changes, [len(values)]])), values[changes]
    longest = int(lengths[levels == top].max())
    if longest < RUN:
        return NOTHING
    elsewhere = lengths[(np.abs(levels - rest) > AWAY * (top - rest)) & (levels < top)]
    if longest <= LONGER * elsewhere.max(initial=1):
        return TOUCHES
    # a channel that is read more often than it changes has several samples of each value
    read = max(1, int(np.quantile(elsewhere, SHORTEST))) if elsewhere.size else 1
    if longest / read * math.log(_unmoved(values[::read])) < math.log(CHANCE):
        return SURE
    return STAYS if far else TOUCHES


def _unmoved(values: Array) -> float:
    """Largest probability that noise leaves a sample at its step of the converter; 1 if the noise is small.

    The noise is estimated from second differences. Rounding adds step^2 / 12 to its variance if the noise is
    not far below the step.
    """
    step = float(np.diff(np.unique(values)).min())
    bends = np.diff(values, 2)
    bends = bends[np.max([values[:-2], values[1:-1], values[2:]], axis=0) < values.max()]
    if len(bends) < 2 * RUN:
        return 1.0
    bends = np.sort(np.abs(bends))[: math.ceil(len(bends) * (1 - LOUDEST))]
    noise = math.sqrt(max(0.0, float(np.mean(bends**2)) / 6 - step**2 / 12))
    if noise < NOISY * step:
        return 1.0
    return max(math.erf(step / (2 * math.sqrt(2) * noise)), 1e-12)
