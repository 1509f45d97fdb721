"""WAV files as plain values."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import scipy.io.wavfile


def signals(path: str) -> dict[str, Any]:
    """``rate`` (Hz) and ``samples`` (channel, sample) as they are stored."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # on unknown chunks of a file, and on its end
        rate, samples = scipy.io.wavfile.read(path)
    return {"rate": int(rate), "samples": np.atleast_2d(samples.T)}
