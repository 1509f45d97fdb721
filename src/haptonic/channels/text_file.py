"""Text of a file from any program."""

from __future__ import annotations

import codecs
from pathlib import Path

from haptonic.errors import ChannelError
from haptonic.paths import source


def text_of(path: Path) -> str:
    """Text of a file in UTF-8, UTF-16, or the code page of an older program.

    Raises
    ------
    ChannelError : bytes that are not text, or a special file such as a device
    OSError : no such file, or no right to read it
    """
    try:
        content = source(path, path.name, ChannelError).read_bytes()
    except ChannelError as error:
        raise refused(path, error.cause) from error
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):  # a spreadsheet's "Unicode text"
        text = content.decode("utf-16", errors="replace")
    else:
        try:
            text = content.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = content.decode("latin-1")
    if "\0" in text:
        raise refused(path, "bytes that are not text")
    return text


def refused(path: Path, given: str, next_step: str = "open it in a text editor to see") -> ChannelError:
    """The error for a file that is not a table."""
    return ChannelError.unreadable(
        argument=path.name,
        given=given,
        allowed="a text table: rows of as many cells each, separated by commas, semicolons, tabs, bars or "
        "blanks, perhaps below a line of names",
        cause="it is damaged, or its ending does not match its content",
        next_step=next_step,
    )
