"""A command that runs again whenever its file is saved."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from haptonic.cli.console import Voice
from haptonic.errors import HaptonicError

PAUSE = 0.3  # s between two looks at the file; nobody saves twice in it


def watched(file: Path, voice: Voice, again: Callable[[], None]) -> None:
    """Call ``again`` after every saving of a file, until Ctrl-C.

    What is wrong with the file is told, and the next saving waited for; it may not be there while an editor
    replaces it.
    """
    with suppress(KeyboardInterrupt):
        seen = _saved(file)
        voice.say(f"{file} is watched: save it to draw anew, Ctrl-C ends")
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
    """What differs after a saving; None where there is no file."""
    try:
        found = file.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino
