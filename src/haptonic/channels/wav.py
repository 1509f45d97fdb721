"""WAV files: a rate and samples, and no unit; read by scipy in the process that reads."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from haptonic.channels.notes import Notebook
from haptonic.channels.signals import Channel, Group, Samples
from haptonic.foreign.process import ask
from haptonic.later import wavfile

SIXTEEN_BITS = 32767


def read(path: Path, notes: Notebook) -> dict[str, Group]:
    """Channels "1", "2" ... of the one group "", in the numbers of the file.

    Raises
    ------
    ChannelError : the file is damaged
    OSError : it may not be read
    """
    found = ask("wav.signals", path)
    notes.remark("a WAV file has no units: its samples are numbers of the converter")
    every = [Channel.of(f"{i}", row, rate=found["rate"]) for i, row in enumerate(found["samples"], start=1)]
    return {"": Group("", {channel.name: channel for channel in every})}


def write(path: Path, samples: Samples, rate: int) -> None:
    """Write samples at a rate in Hz: integers of 16 bits as they are, others with their largest size as full
    scale."""
    if samples.dtype != np.int16:
        samples = np.rint(samples / np.abs(samples).max() * SIXTEEN_BITS).astype(np.int16)
    wavfile.write(path, rate, samples)
