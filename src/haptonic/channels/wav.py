"""WAV files of 16 bits: a rate and samples, and no unit."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import scipy.io.wavfile

from haptonic.channels.signals import Samples

SIXTEEN_BITS = 32767


def write(path: Path, samples: Samples, rate: int) -> None:
    """Write samples at a rate in Hz: integers of 16 bits as they are, others with their largest size as full
    scale."""
    if samples.dtype != np.int16:
        samples = np.rint(samples / np.abs(samples).max() * SIXTEEN_BITS).astype(np.int16)
    scipy.io.wavfile.write(path, rate, samples)
