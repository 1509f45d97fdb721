"""Channels that stop while the finger presses: they hang at a value, or drop to zero, for some time."""

from __future__ import annotations

import math

import numpy as np

from haptonic.arrays import Array

PRESSED = 0.5  # of the largest departure from the start: the finger presses
LEAST_REST = 20  # samples before that, which show the noise of a channel
LEAST_RUN = 5  # equal samples in a row
# Steps of the converter, of differences of samples at rest: less noise than that moves a sample between two
# steps, and none in the middle of a step.
LEAST_NOISE = 1.5
SHARE = 0.01  # of the time that the finger presses: a shorter stop changes a mean by less
CHANCE = 1e-7  # of equal samples in a row by the noise at rest, below which they are no chance
SURE = 2.0  # standard deviations by which a count at rest may be too small


def stops(channels: Array) -> bool:
    """True if one of the (channel, sample) channels stays at one value where its noise would have moved it.

    How often noise leaves a sample as it was follows from the rest at the start; where a finger presses it is
    no quieter. A channel whose noise at rest is below its resolution shows no stop, and a short one at a low
    rate is not seen.
    """
    departs = np.abs(channels - channels[:, :1])
    largest = departs[departs.max(axis=1, initial=0).argmax()]
    pressed = np.flatnonzero(largest > PRESSED * largest.max(initial=0))
    if not pressed.size or pressed[0] // 2 < LEAST_REST:
        return False
    for values in channels:
        rest, stroke = values[: pressed[0] // 2], values[pressed[0] : pressed[-1] + 1]
        step = np.diff(np.unique(values)).min(initial=np.inf)
        if np.diff(rest).std() < LEAST_NOISE * step:
            continue
        count = np.count_nonzero(np.diff(rest) == 0)
        equal = min((count + 1 + SURE * math.sqrt(count + 1)) / len(rest), 1.0)
        changes = np.flatnonzero(np.concatenate([[True], np.diff(stroke) != 0, [True]]))
        longest = int(np.diff(changes).max())
        if longest >= max(LEAST_RUN, SHARE * len(stroke)) and longest * math.log(equal) < math.log(CHANCE):
            return True
    return False
