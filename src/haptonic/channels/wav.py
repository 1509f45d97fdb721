"""WAV files: a rate and samples without a unit; read by scipy in the reader process."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from haptonic.channels.notes import Notebook
from haptonic.channels.signals import Channel, Group, Samples
from haptonic.foreign.process import ask
from haptonic.later import wavfile

SIXTEEN_BITS = 32767


def read(path: Path, notes: Notebook) -> dict[str, Group]:
    """Read channels "1", "2" ... of a single group "", in the numbers of the file.

    Raises
    ------
    ChannelError : the file is damaged
    OSError : no right to read it
    """
    content = ask("wav.signals", path)
    notes.remark("a WAV file has no units: its samples are numbers of the converter")
    every = [
        Channel.of(f"{i}", row, rate=content["rate"]) for i, row in enumerate(content["samples"], start=1)
    ]
    return {"": Group("", {channel.name: channel for channel in every})}


def write(path: Path, samples: Samples, rate: int) -> None:
    """Write samples at a rate in Hz: 16-bit integers unchanged, others scaled to full scale."""
    if samples.dtype != np.int16:
        samples = np.rint(samples / np.abs(samples).max() * SIXTEEN_BITS).astype(np.int16)
    wavfile.write(path, rate, samples)
