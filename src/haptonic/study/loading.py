"""Reading a study file: a study, or one error that lists every problem in the file."""

from __future__ import annotations

import re
import tomllib
import warnings
from pathlib import Path
from typing import Any, TypeVar

from haptonic.errors import HaptonicWarning, StudyError, nearest, shown
from haptonic.fields import read, table
from haptonic.fields.reading import read_listing
from haptonic.paths import source
from haptonic.study.schema import Description
from haptonic.study.template import ENDING
from haptonic.study.trial_tables import TrialSettings, TrialsFile

S = TypeVar("S", bound=Description)

LARGEST_FILE = 1_000_000  # bytes; a study needs a few thousand
DEEPEST = 20  # brackets within brackets; a study needs two
MOST_DOTS = 500  # in one line; the parser takes minutes over a key of many thousand parts

_PLACE = re.compile(r"\(at line (?P<line>\d+), column \d+\)$")
_BARE_QUANTITY = re.compile(r"=\s*[+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?\s*[A-Za-zµ]")


def load_as(path: str | Path, kind: type[S]) -> S:
    """Read a study file.

    Parameters
    ----------
    kind : `Description`, or `haptonic.study.Study`, which also has methods that compute

    Raises
    ------
    StudyError : the file cannot be read, is not TOML, or does not describe a possible study; paths of keys
        count tables from 1 (``sweep[1].from`` belongs to the first ``[[sweep]]``)

    Warns
    -----
    HaptonicWarning : a value outside its typical range
    """
    checked = source(path, "study", StudyError)
    return loads_as(text_of(checked), kind, str(path), checked.parent)


def loads_as(text: str, kind: type[S], origin: str = "study", folder: Path | None = None) -> S:
    """Read a study from text; ``origin`` is its name in errors and warnings. Otherwise as `load_as`.

    ``folder`` is the base of paths in the study, by default the working directory.
    """
    study = read(kind, _placed(_parsed(text, origin), folder), origin)
    for words in study.unusual():
        warnings.warn(f"{origin}: {words}", HaptonicWarning, stacklevel=2)
    return study


def examined(
    text: str, kind: type[S], folder: Path, origin: str = "study"
) -> tuple[S | None, dict[str, Any], list[StudyError]]:
    """The study of a text, its tables as plain values, and each problem as an error of its own.

    The study is None if there is a problem; without tables the text is not TOML. A CAD file has to be in
    ``folder``, because the text may come from somebody else.
    """
    try:
        data = _parsed(text, origin)
    except StudyError as error:
        return None, {}, [error]
    placed = _placed(data, folder)
    if outside := _outside(data, placed, folder):
        return None, data, [outside]
    study, problems = read_listing(kind, placed)
    return study, data, problems


def _outside(data: dict[str, Any], placed: dict[str, Any], folder: Path) -> StudyError | None:
    """Error for a CAD file outside of the folder of studies; None if there is none."""
    cell = placed.get("cell")
    solid = cell.get("solid") if isinstance(cell, dict) else None
    file = solid.get("file") if isinstance(solid, dict) else None
    if not isinstance(file, str) or Path(file).resolve().is_relative_to(folder.resolve()):
        return None
    return StudyError.forbidden(
        argument="cell.solid.file",
        given=shown(data["cell"]["solid"]["file"], 200),
        allowed="a file in the folder of the studies, or below it",
        cause="the path leads out of the folder",
        next_step="copy the file beside the study, and give its name",
    )


def _placed(data: dict[str, Any], folder: Path | None) -> dict[str, Any]:
    """The data of a study, with the path of its CAD file relative to the working directory."""
    cell = data.get("cell")
    solid = cell.get("solid") if isinstance(cell, dict) else None
    if folder is None or not isinstance(solid, dict) or not isinstance(solid.get("file"), str):
        return data
    return {**data, "cell": {**data["cell"], "solid": {**solid, "file": str(folder / solid["file"])}}}


def load_trials_as(path: str | Path, kind: type[S]) -> tuple[TrialSettings, S | None]:
    """The table [trials] of a study file, and the study; None for a file without other tables.

    Raises
    ------
    StudyError : as `load_as`
    """
    data = _parsed(text_of(source(path, "study", StudyError)), str(path))
    if not data.keys() <= table(TrialsFile).keys():
        study = load_as(path, kind)
        return study.trials, study
    return read(TrialsFile, data, str(path)).trials, None


def trials_in(text: str, kind: type[S], folder: Path) -> tuple[TrialSettings, S | None]:
    """As `load_trials_as`, for a text that may come from somebody else; see `examined`.

    Raises
    ------
    StudyError : the first problem of the text
    """
    data = _parsed(text, "study")
    if data.keys() <= table(TrialsFile).keys():
        return read(TrialsFile, data, "study").trials, None
    study, _, problems = examined(text, kind, folder)
    if study is None:
        raise problems[0]
    return study.trials, study


def text_of(path: Path) -> str:
    """Text of a study file.

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


def _parsed(text: str, origin: str) -> dict[str, Any]:
    if _depth(text) > DEEPEST:
        raise _malformed(text, origin, ValueError("brackets are nested too deeply"))
    if max(line.count(".") for line in text.split("\n")) > MOST_DOTS:
        raise _malformed(text, origin, ValueError("a line contains too many dots for a key or a value"))
    try:
        data = tomllib.loads(text)
    except ValueError as error:  # also raised for a number of thousands of digits
        raise _malformed(text, origin, error) from None
    if not data:
        raise StudyError.missing(
            argument=origin,
            given="a file without any key",
            allowed="a study: at least [material] and [cell]",
            cause="the file is empty, or everything in it is a comment",
            next_step="write [material] and [cell]; `haptonic keys` lists every key",
        )
    return data


def _depth(text: str) -> int:
    """Depth of nested brackets; the parser of the standard library has no limit for it."""
    depth = deepest = 0
    for bracket in re.findall(r"[][{}]", text):
        depth = depth + 1 if bracket in "[{" else max(depth - 1, 0)
        deepest = max(deepest, depth)
    return deepest


def _malformed(text: str, origin: str, error: Exception) -> StudyError:
    """Error for text that is not TOML, with the line of the mistake."""
    message, place = str(error), _PLACE.search(str(error))
    lines = text.splitlines() or [""]
    number = min(int(place["line"]), len(lines)) if place else len(lines)
    line = lines[number - 1].strip() if place or "end of document" in message else ""
    if "integer string conversion" in message:
        message = "a whole number has thousands of digits"
    next_step = "correct that line; texts and quantities need quotes, numbers do not"
    if _BARE_QUANTITY.search(line):
        next_step = 'put quotes around the number and its unit: pitch = "7 mm"'
    elif line.startswith("[") and "twice" in message:
        next_step = "a heading may occur only once; several sweeps need a heading [[sweep]] each"
    return StudyError.malformed(
        argument=f"{origin}, line {number}" if line else origin,
        given=shown(line) if line else "text that is not TOML",
        allowed='TOML: lines such as pitch = "7 mm" below headings such as [cell]',
        cause=_PLACE.sub("", message).strip(),
        next_step=next_step,
    )


def _refused(code: str, path: Path, cause: str, next_step: str) -> StudyError:
    return StudyError(
        code,
        argument="study",
        given=shown(str(path), 200),
        allowed="a readable text file in TOML",
        cause=cause,
        next_step=next_step,
    )


def _similar(path: Path) -> str:
    """The nearest file name in the same folder, as a suggestion."""
    try:
        names = [entry.name for entry in path.parent.iterdir() if entry.suffix == ENDING]
    except OSError:
        return f"check the path: its folder {path.parent} does not exist either"
    guess = nearest(path.name, names)
    return f"did you mean {path.parent / guess}?" if guess else "check the path"


def _studies_in(folder: Path) -> str:
    names = sorted(entry.name for entry in folder.glob(f"*{ENDING}"))
    return f"give a file in it: {', '.join(names[:5])}" if names else f"give the path of a {ENDING} file"
