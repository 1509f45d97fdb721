"""Paths from users, checked before they are read or written."""

from __future__ import annotations

import os
import stat
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import TypeVar, Unpack

from haptonic.errors import HaptonicError, Parts, ResourceError, shown

E = TypeVar("E", bound=HaptonicError)


LONGEST = 255  # bytes of a name, on every common file system
# opening a pipe without a writer would otherwise wait for ever; the flag has no effect on files
_UNBLOCKED = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0)


def source(given: object, argument: str, kind: type[HaptonicError] = ResourceError) -> Path:
    """Check the path of a file or folder to read; the reader reports a missing or forbidden file.

    Parameters
    ----------
    argument, kind : name and class of the error

    Raises
    ------
    HaptonicError : not a path, an impossible path, a pipe or device, or a file whose first byte cannot be
        read
    """
    path = _path(given, argument, kind)
    try:
        handle = os.open(path, _UNBLOCKED)
    except (FileNotFoundError, NotADirectoryError, PermissionError, IsADirectoryError):
        return path
    except OSError as error:
        raise _unreadable(path, argument, kind, _message(error)) from None
    try:
        form = os.fstat(handle).st_mode
        if not (stat.S_ISREG(form) or stat.S_ISDIR(form)):
            raise _unreadable(path, argument, kind, "it is a pipe or a device, which has no end")
        if stat.S_ISREG(form):
            os.read(handle, 1)
    except OSError as error:
        raise _unreadable(path, argument, kind, _message(error)) from None
    finally:
        os.close(handle)
    return path


def unread(kind: type[E], error: Exception, **parts: Unpack[Parts]) -> E:
    """Error for a file that could not be read: `not-found` if it does not exist, otherwise `unreadable`."""
    if not isinstance(error, FileNotFoundError):
        return kind("unreadable", **parts)
    parts["cause"], parts["next_step"] = "the file does not exist", "check the name and the folder"
    return kind("not-found", **parts)


def target(given: object, argument: str = "--out") -> Path:
    """Check the path of a folder or file to write, as far as its name allows.

    Raises
    ------
    ResourceError : not a path, or an impossible path
    """
    return _path(given, argument, ResourceError)


def inside(folder: Path, name: str | PurePosixPath) -> Path:
    """Path of a file in a folder, or below it. The name cannot lead out of the folder on any system.

    Raises
    ------
    ResourceError : a name or part with a folder, a drive or a step upwards in it, or an empty name
    """
    parts = name.parts if isinstance(name, PurePosixPath) else (name,)
    plain = all({PurePosixPath(part).name, PureWindowsPath(part).name} == {part} for part in parts)
    if not plain or not {"", ".", ".."}.isdisjoint(parts) or not parts:
        raise ResourceError.malformed(
            argument="output file",
            given=shown(str(name), 200),
            allowed="a name without folders",
            cause="a name chosen by a user was used as the name of a file without change",
            next_step="report a fault: haptonic.names.file_parts makes names of files",
        )
    return target(folder / name)


def _path(given: object, argument: str, kind: type[HaptonicError]) -> Path:
    def refused(cause: str, next_step: str) -> HaptonicError:
        return kind.malformed(
            argument=argument,
            given=shown(str(given) if isinstance(given, str | os.PathLike) else given, 200),
            allowed="the path of a file or folder, as text or pathlib.Path",
            cause=cause,
            next_step=next_step,
        )

    if not isinstance(given, str | os.PathLike) or not isinstance(os.fspath(given), str):
        raise refused("a value of another type", 'give a text in quotes, such as "plate.toml"')
    text = os.fspath(given)
    if not text or "\0" in text:
        raise refused("the text is empty or contains a NUL", "give the name of a file or folder")
    path = Path(text)
    if any(len(os.fsencode(part)) > LONGEST for part in path.parts):
        raise refused(f"a name in it is longer than {LONGEST} bytes", "choose a shorter name")
    try:
        if text.startswith("~") and not os.path.lexists(path):
            path = path.expanduser()
        path.lstat()
    except RuntimeError:
        raise refused(f'there is no user "{path.parts[0][1:]}" here', "write the whole path") from None
    except (FileNotFoundError, NotADirectoryError, PermissionError):
        pass  # the reader or writer reports it
    except OSError as error:
        raise refused(f"error of the system: {_message(error)}", "check the path") from None
    return path


def _unreadable(path: Path, argument: str, kind: type[HaptonicError], cause: str) -> HaptonicError:
    return kind.unreadable(
        argument=argument,
        given=shown(str(path), 200),
        allowed="a file or folder that can be read",
        cause=cause,
        next_step="check the path, or copy the content to a file and give that",
    )


def _message(error: OSError) -> str:
    return error.strerror or str(error)
