"""Text of a study, from its file or from a result, read without the modules that understand it."""

from __future__ import annotations

from pathlib import Path

from haptonic.errors import CLOSE, ChannelError, ResourceError, StudyError, nearest, shown
from haptonic.foreign.process import ask
from haptonic.hdf5 import SIGNATURE, STUDY
from haptonic.study.template import ENDING

LARGEST_FILE = 1_000_000  # bytes; a study needs a few thousand


def text_of(path: Path) -> str:
    """Text of a study file, or of the study in the NetCDF file of a result.

    Raises
    ------
    StudyError : the file cannot be read, or is not a text of a possible size
    """
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST_FILE + 1)
    except FileNotFoundError:
        if path.is_symlink():  # the nearest name would be that of the link itself
            raise _refused(
                "not-found", path, "it is a link to a file that does not exist", "repair the link"
            ) from None
        raise _refused("not-found", path, "the file does not exist", _similar(path)) from None
    except IsADirectoryError:
        raise _refused("unreadable", path, "it is a folder", _studies_in(path)) from None
    except PermissionError:
        next_step = "change its permissions, or copy it"
        raise _refused("forbidden", path, "you have no permission to read it", next_step) from None
    except (OSError, ValueError) as error:
        cause = getattr(error, "strerror", None) or str(error)
        raise _refused("unreadable", path, f"error of the system: {cause}", "check the path") from None
    if content.startswith(SIGNATURE):
        return _text_in_result(path)
    if len(content) > LARGEST_FILE:
        cause = f"it is larger than {LARGEST_FILE} bytes"
        raise _refused("too-large", path, cause, "check that it is a study file")
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise _refused("encoding", path, "it is encoded as UTF-16", "save it as UTF-8")
    if b"\0" in content:
        next_step = f"give the {ENDING} file that describes the study"
        raise _refused("malformed", path, "it is a binary file", next_step)
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        cause = f"line {line} contains bytes that are not UTF-8 text"
        raise _refused("encoding", path, cause, "save it as UTF-8") from None
    return text


def is_result(path: Path) -> bool:
    """True for an HDF5 file, such as the NetCDF file of a result."""
    with path.open("rb") as file:
        return file.read(len(SIGNATURE)) == SIGNATURE


def _text_in_result(path: Path) -> str:
    try:
        text = ask("hdf5.tree", path, deep=False)["attributes"].get(STUDY)
    except (ChannelError, ResourceError, OSError) as error:
        raise _refused("malformed", path, "it is a damaged HDF5 file", "compute the result again") from error
    if not isinstance(text, str):
        next_step = f"give the {ENDING} file of the study, or compute the result again"
        raise _refused("missing", path, "it is an HDF5 file without the text of a study", next_step)
    return text


def _refused(code: str, path: Path, cause: str, next_step: str) -> StudyError:
    return StudyError(
        code,
        argument="study",
        given=shown(str(path), 200),
        allowed="a readable text file in TOML, or a result of haptonic in NetCDF",
        cause=cause,
        next_step=next_step,
    )


def _similar(path: Path) -> str:
    """The nearest file name in the same folder, as a suggestion."""
    try:
        names = [entry.name for entry in path.parent.iterdir() if entry.suffix == ENDING]
    except OSError:
        return f"check the path: its folder {path.parent} does not exist either"
    stems = {name.removesuffix(ENDING): name for name in names}  # all endings are alike
    guess = stems.get(nearest(path.stem, stems, CLOSE) or "")
    return f"did you mean {path.parent / guess}?" if guess else "check the path"


def _studies_in(folder: Path) -> str:
    names = sorted(entry.name for entry in folder.glob(f"*{ENDING}"))
    return f"give a file in it: {', '.join(names[:5])}" if names else f"give the path of a {ENDING} file"
