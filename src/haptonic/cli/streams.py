"""Standard output that nobody can read, because its disk is full or its reader has ended."""

from __future__ import annotations

import errno
import os
from typing import IO

UNHEARD = errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO  # errors of a disk that is full or broken


def mute(stream: IO[str]) -> None:
    """Send the rest of a stream nowhere; otherwise Python would try to write it when the process ends."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
