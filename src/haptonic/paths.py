"""A path that a user gave, checked before anything waits for it or writes to it."""

from __future__ import annotations

import os
import stat
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import TypeVar, Unpack

from haptonic.errors import HaptonicError, Parts, ResourceError, shown

E = TypeVar("E", bound=HaptonicError)


LONGEST = 255  # bytes of one name, on every common file system
# Without it, opening a pipe that nobody writes to would wait for ever; files take no notice of it.
_UNBLOCKED = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0)


def source(given: object, argument: str, kind: type[HaptonicError] = ResourceError) -> Path:
    """A file or folder that can be read, or nothing: what is missing or forbidden is told by who reads it.

    Parameters
    ----------
    argument, kind : name and class of the error

    Raises
    ------
    HaptonicError : no path, one that no file can have, a pipe or device, or a file whose first byte fails
    """
    path = _path(given, argument, kind)
    try:
        handle = os.open(path, _UNBLOCKED)
    except (FileNotFoundError, NotADirectoryError, PermissionError, IsADirectoryError):
        return path
    except OSError as error:
        raise _unreadable(path, argument, kind, _said(error)) from None
    try:
        form = os.fstat(handle).st_mode
        if not (stat.S_ISREG(form) or stat.S_ISDIR(form)):
            raise _unreadable(path, argument, kind, "it is a pipe or a device, which has no end")
        if stat.S_ISREG(form):
            os.read(handle, 1)
    except OSError as error:
        raise _unreadable(path, argument, kind, _said(error)) from None
    finally:
        os.close(handle)
    return path


def unread(kind: type[E], error: Exception, **parts: Unpack[Parts]) -> E:
    """The error of a file that was not read: `not-found` if there is none, else `unreadable` as given."""
    if not isinstance(error, FileNotFoundError):
        return kind("unreadable", **parts)
    parts["cause"], parts["next_step"] = "there is no such file", "check the name and the folder"
    return kind("not-found", **parts)


def target(given: object, argument: str = "--out") -> Path:
    """A folder or file that can be made there, as far as its name tells.

    Raises
    ------
    ResourceError : no path, or one that no file can have
    """
    return _path(given, argument, ResourceError)


def inside(folder: Path, name: str | PurePosixPath) -> Path:
    """A file of a folder, or by a path one of a folder below it. Its name leads nowhere else, on any system.

    Raises
    ------
    ResourceError : a name, or a part of a path, with a folder, a drive or a step upwards in it, or none
    """
    parts = name.parts if isinstance(name, PurePosixPath) else (name,)
    plain = all({PurePosixPath(part).name, PureWindowsPath(part).name} == {part} for part in parts)
    if not plain or not {"", ".", ".."}.isdisjoint(parts) or not parts:
        raise ResourceError.malformed(
            argument="output file",
            given=shown(str(name), 200),
            allowed="a name without folders",
            cause="a name of somebody's choice became the name of a file as it is",
            next_step="report a fault: names of files are made by haptonic.names.file_parts",
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
        raise refused("the text is empty, or holds a NUL", "give the name of a file or folder")
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
        pass  # whoever reads or writes it says so
    except OSError as error:
        raise refused(f"the system says: {_said(error)}", "check the path") from None
    return path


def _unreadable(path: Path, argument: str, kind: type[HaptonicError], cause: str) -> HaptonicError:
    return kind.unreadable(
        argument=argument,
        given=shown(str(path), 200),
        allowed="a file or folder that can be read",
        cause=cause,
        next_step="check the path, or copy what it holds to a file and give that",
    )


def _said(error: OSError) -> str:
    return error.strerror or str(error)
