"""Run a command again whenever its file is saved."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from haptonic.cli.console import Voice
from haptonic.errors import HaptonicError

PAUSE = 0.3  # s between two checks of the file; shorter than two savings by hand


def watched(file: Path, voice: Voice, again: Callable[[], None]) -> None:
    """Call ``again`` whenever a file is saved, until Ctrl-C.

    An error in the file is printed, and the next saving is awaited. The file may be missing for a moment
    while an editor replaces it.
    """
    with suppress(KeyboardInterrupt):
        seen = _saved(file)
        voice.remark(f"{file} is watched: save it to draw again, press Ctrl-C to end")
        while True:
            time.sleep(PAUSE)
            now = _saved(file)
            if now not in (None, seen):
                seen = now
                try:
                    again()
                except HaptonicError as error:
                    voice.refuse(error)


def _saved(file: Path) -> tuple[int, int, int] | None:
    """Time, size and inode of a file, which change when it is saved; None without a file."""
    try:
        status = file.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino
