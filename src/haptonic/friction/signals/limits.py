"""Forces that stay at the end of a channel's range, told from those of a coarse converter."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array, Bools

RUN = 5  # equal samples in a row at an extreme
LONGER = 3.0  # than any run of equal samples elsewhere in the stroke: no chance
PERHAPS = 1.2  # the same where other strokes have to show the same limit
FINE = 0.5  # of the other samples that differ from each other: noise shows, so equal samples are no chance
COUNTS = 100.0  # steps of a converter up to its limit: none has fewer
AWAY = 0.3  # of the way from rest to the extreme: samples nearer to rest do not count
SHARING = 3  # strokes at a limit, if the resolution is coarse


@dataclass(frozen=True, eq=False)
class RangeEnds:
    """Where forces of strokes stay at an extreme.

    sure : (stroke,) whether a channel of fine resolution stays at one value at its extreme
    level : (4, stroke) N, the largest and smallest value of normal and tangential force
    doubtful : (4, stroke) whether a channel of coarse resolution stays at it, which is a limit if others do
    """

    sure: Bools
    level: Array
    doubtful: Bools

    @classmethod
    def none(cls, count: int) -> RangeEnds:
        """Strokes that stay nowhere."""
        return cls(np.zeros(count, dtype=bool), np.full((4, count), np.nan), np.zeros((4, count), dtype=bool))

    @classmethod
    def of(cls, channels: Array) -> RangeEnds:
        """Those of (channel, stroke, sample) normal and tangential force."""
        found = cls.none(channels.shape[1])
        both = np.concatenate([channels, -channels])
        found.level[:] = both.max(axis=2)
        # the end of a range is far from zero, where a sensor rests
        count = (both == found.level[:, :, None]).sum(axis=2) * (
            found.level >= np.roll(found.level, 2, axis=0)
        )
        for end, stroke in np.argwhere(count >= RUN):
            state = stays(both[end, stroke])
            found.sure[stroke] |= state == "sure"
            found.doubtful[end, stroke] = state == "doubtful"
        return found

    @classmethod
    def joined(cls, parts: Sequence[RangeEnds]) -> RangeEnds:
        """Those of many strokes, one after the other."""
        return cls(
            np.concatenate([one.sure for one in parts]),
            np.concatenate([one.level for one in parts], axis=1),
            np.concatenate([one.doubtful for one in parts], axis=1),
        )

    def put(self, rows: Sequence[int], part: RangeEnds) -> None:
        """Enter those of some strokes."""
        self.sure[rows], self.level[:, rows], self.doubtful[:, rows] = part.sure, part.level, part.doubtful

    def shared(self) -> Bools:
        """(stroke,) True for a doubtful stroke that stays at the extreme of all, as several others do."""
        if not self.doubtful.any():
            return np.zeros(self.doubtful.shape[1], dtype=bool)
        at_end = self.level == np.nanmax(self.level, axis=1, keepdims=True)
        shared = (at_end & (self.doubtful | self.sure)).sum(axis=1, keepdims=True) >= SHARING
        return np.asarray((at_end & self.doubtful & shared).any(axis=0))


def stays(values: Array) -> str:
    """Whether (sample,) values stay at their largest one: "sure", "doubtful" or nothing."""
    top, rest = values.max(), values[0]
    changes = np.flatnonzero(np.concatenate([[True], np.diff(values) != 0]))
    lengths = np.diff(np.concatenate([changes, [len(values)]]))
    starts = values[changes]
    away = np.abs(starts - rest) > AWAY * abs(top - rest)
    at_top = starts == top
    longest = lengths[at_top].max()
    elsewhere = lengths[away & ~at_top].max(initial=1)
    if top == rest or longest < RUN or longest <= PERHAPS * elsewhere:
        return ""
    below = values[(values < top) & (np.abs(values - rest) > AWAY * abs(top - rest))]
    if len(np.unique(below)) > FINE * len(below) and longest > LONGER * elsewhere:
        return "sure"
    different = np.unique(values)
    step = float(np.diff(different).min(initial=np.inf)) if len(different) > 1 else np.inf
    return "doubtful" if abs(top) >= COUNTS * step else ""
