"""Channels that jump for a sample or two: loose contacts, lost data, switches nearby."""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array

AROUND = 5  # samples; a jump of two samples does not change their median
JUMP = 0.5  # of the largest range of the channels; a smaller jump of a sample changes a mean by less than 1 %
LOUD = 10.0  # times the mean distance from that median; noise stays below


def jumps(channels: Array) -> bool:
    """True if one of the (channel, sample) channels jumps and comes back at once."""
    if channels.shape[1] < AROUND:
        return False
    smooth = median_of_five(channels)
    apart = np.abs(channels[:, AROUND // 2 : -(AROUND // 2)] - smooth)
    largest = np.maximum(JUMP * np.ptp(smooth, axis=1).max(initial=0), LOUD * apart.mean(axis=1))
    return bool((apart.max(axis=1) > largest).any())


def median_of_five(channels: Array) -> Array:
    """(channel, sample - 4) median of each sample and two on either side.

    Neither the least nor the largest of four is the median of five; of the two others and the fifth it is the
    middle one. A sort of every window takes ten times as long.
    """
    first, second, third, fourth, fifth = (
        channels[:, start : channels.shape[1] - AROUND + 1 + start] for start in range(AROUND)
    )
    above = np.maximum(np.minimum(first, second), np.minimum(third, fourth))
    below = np.minimum(np.maximum(first, second), np.maximum(third, fourth))
    return np.maximum(np.minimum(above, below), np.minimum(np.maximum(above, below), fifth))
