"""Formats of signal files, and their detection; see `haptonic.channels` for adding one."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from haptonic.channels import delimited, hdf5, matlab, tdms, uff, wav
from haptonic.channels.notes import Notebook
from haptonic.channels.signals import Group, SignalFile
from haptonic.errors import ChannelError, ResourceError
from haptonic.hdf5 import SIGNATURE


@dataclass(frozen=True)
class Format:
    """A format.

    read : function that reads the groups
    recognises : True for the first bytes of such a file
    """

    name: str
    suffixes: tuple[str, ...]
    read: Callable[[Path, Notebook], Mapping[str, Group]]
    recognises: Callable[[bytes], bool] = lambda head: False


HEAD = 4096  # bytes for the detection
_DELIMITER = re.compile(rb"^    -1 *\r?$", re.MULTILINE)

# The order matters: a MATLAB file of version 7.3 is HDF5 behind a block of its own.
FORMATS = (
    Format("TDMS", (".tdms",), tdms.read, lambda head: head.startswith(b"TDSm")),
    Format("MATLAB", (".mat",), matlab.read, lambda head: head.startswith(b"MATLAB 5.0")),
    Format("HDF5", (".h5", ".hdf5", ".nc"), hdf5.read, lambda head: SIGNATURE in (head[:8], head[512:520])),
    Format("WAV", (".wav",), wav.read, lambda head: head.startswith(b"RIFF") and head[8:12] == b"WAVE"),
    Format("CSV", (".csv",), delimited.read),
    Format("UFF", (".uff", ".unv", ".uf"), uff.read, lambda head: bool(_DELIMITER.search(head))),
)
SUFFIXES = sorted(suffix for form in FORMATS for suffix in form.suffixes)


def format_of(path: Path) -> Format | None:
    """Format of a file, by its suffix or its first bytes; None if it is unknown.

    Raises
    ------
    OSError : no such file, or no right to read it
    """
    with path.open("rb") as file:
        return recognised(path.suffix, file.read(HEAD))


def recognised(suffix: str, head: bytes) -> Format | None:
    """Format of a file with this suffix and these first bytes, of which `HEAD` suffice; None if unknown."""
    ending = suffix.lower()
    return next((form for form in FORMATS if ending in form.suffixes or form.recognises(head)), None)


def opened(path: Path) -> SignalFile:
    """Open a file of signals.

    Raises
    ------
    ChannelError : no such file, or one that cannot be read, is damaged or of another format
    """
    try:
        if not path.is_file():  # raises an error for a name that is too long for any file
            raise _refused(path, "no such file", "check its name", code="not-found")
        form = format_of(path)
        if form is None:
            raise _refused(path, f'"{path.suffix}" is not the ending of a known format', "save it as CSV")
        notes = Notebook(path, form.name)
        return SignalFile(path, form.read(path, notes), notes)
    except (MemoryError, ResourceError) as error:
        if isinstance(error, ResourceError) and error.code != "too-large":
            raise
        raise _refused(path, "it does not fit into memory, or is damaged", "divide it") from error
    except OSError as error:
        given = f"it cannot be read ({type(error).__name__})"
        raise _refused(path, given, "check your right to read it, and the disk") from error


def _refused(path: Path, given: str, next_step: str, code: str = "unreadable") -> ChannelError:
    return ChannelError(
        code,
        argument=path.name,
        given=given,
        allowed=f"a readable file that ends in {', '.join(SUFFIXES)}",
        cause="the file was moved, renamed, cut or saved in another format",
        next_step=next_step,
    )
