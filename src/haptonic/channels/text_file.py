"""The text of a file, whatever program wrote it."""

from __future__ import annotations

import codecs
from pathlib import Path

from haptonic.errors import ChannelError
from haptonic.paths import source


def text_of(path: Path) -> str:
    """The text of a file, which names or units in the code page of an older program do not spoil.

    Raises
    ------
    ChannelError : it holds bytes that no text has, or is no file that ends
    OSError : there is no such file, or it may not be read
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
        raise refused(path, "bytes that no text has")
    return text


def refused(path: Path, given: str, next_step: str = "open it in a text editor to see") -> ChannelError:
    """The error of a file that is no table."""
    return ChannelError.unreadable(
        argument=path.name,
        given=given,
        allowed="a text table: rows of as many cells each, parted by commas, semicolons, tabs, bars or "
        "blanks, perhaps below a line of names",
        cause="it is damaged, or saved in another format than its name says",
        next_step=next_step,
    )
