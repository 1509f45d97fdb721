"""Clicks that mark the start and the end of each stroke."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from haptonic.channels import wav

RATE = 16_000  # Hz
START, END = 1760.0, 880.0  # Hz: a high click starts the stroke, a low one ends it
DECAY, AUDIBLE = 0.008, 0.06  # s
LOUD = 0.8  # of full scale
FULL_SCALE = 2**15 - 1


def clicks(trials: int, lasting: float, pause: float) -> NDArray[np.int16]:
    """(samples,) the track of one block: a pause, a stroke between two clicks, the next pause, and so on.

    Parameters
    ----------
    trials : number of trials in the block
    lasting : duration of a stroke, s, longer than a click
    pause : duration of the pause before each stroke, s, longer than a click
    """
    track = np.zeros(round((trials * (pause + lasting) + pause) * RATE), dtype=np.int16)
    time = np.arange(round(AUDIBLE * RATE)) / RATE
    decay = FULL_SCALE * LOUD * np.exp(-time / DECAY)
    for trial in range(trials):
        start = (trial + 1) * pause + trial * lasting
        for moment, pitch in ((start, START), (start + lasting, END)):
            first = round(moment * RATE)
            track[first : first + len(time)] = np.rint(decay * np.cos(2 * np.pi * pitch * time))
    return track


def write_wav(track: NDArray[np.int16], path: Path) -> None:
    """Write the track as a WAV file of one channel and 16 bits."""
    wav.write(path, track, RATE)
