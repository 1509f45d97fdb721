"""Channels that stop while the finger presses: they stay at a value, or drop to zero, for some time."""

from __future__ import annotations

import math

import numpy as np

from haptonic.arrays import Array

PRESSED = 0.5  # of the largest departure from the start: the finger presses
LEAST_REST = 20  # samples before that, from which the noise of a channel is estimated
LEAST_RUN = 5  # equal samples in a row
# Steps of the converter, for differences of samples at rest: smaller noise moves a sample that is between two
# steps, and does not move one in the middle of a step.
LEAST_NOISE = 1.5
SHARE = 0.01  # of the time that the finger presses: a shorter stop changes a mean by less
CHANCE = 1e-7  # probability that noise at rest leaves a run of samples equal, below which it is a stop
SURE = 2.0  # standard deviations by which a count at rest may be too small


def stops(channels: Array) -> bool:
    """True if one of the (channel, sample) channels stays at one value although its noise would move it.

    The rate of equal samples is estimated from the rest at the start; with a finger the noise is not smaller.
    A channel whose noise at rest is below its resolution shows no stop; a short stop at a low rate is missed.
    """
    departs = np.abs(channels - channels[:, :1])
    largest = departs[departs.max(axis=1, initial=0).argmax()]
    pressed = np.flatnonzero(largest > PRESSED * largest.max(initial=0))
    if not pressed.size or pressed[0] // 2 < LEAST_REST:
        return False
    for values in channels:
        rest, stroke = values[: pressed[0] // 2], values[pressed[0] : pressed[-1] + 1]
        changes = np.flatnonzero(np.concatenate([[True], np.diff(stroke) != 0, [True]]))
        longest = int(np.diff(changes).max())
        if longest < max(LEAST_RUN, SHARE * len(stroke)):
            continue
        step = np.diff(np.unique(values)).min(initial=np.inf)
        if np.diff(rest).std() < LEAST_NOISE * step:
            continue
        count = np.count_nonzero(np.diff(rest) == 0)
        equal = min((count + 1 + SURE * math.sqrt(count + 1)) / len(rest), 1.0)
        if (longest - 1) * math.log(equal) < math.log(CHANCE):  # differences that are zero
            return True
    return False
