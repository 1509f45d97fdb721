"""Reading a study file: a study, or one error that lists every problem in the file."""

from __future__ import annotations

import re
import tomllib
import warnings
from collections.abc import Collection
from pathlib import Path
from typing import Any, TypeVar

from haptonic.errors import HaptonicWarning, StudyError, shown
from haptonic.fields import read, table
from haptonic.fields.reading import read_listing
from haptonic.paths import source
from haptonic.study.schema import Description
from haptonic.study.template import ENDING
from haptonic.study.text_file import is_result, text_of
from haptonic.study.trial_tables import TrialSettings, TrialsFile

S = TypeVar("S", bound=Description)

DEEPEST = 20  # brackets within brackets; a study needs two
MOST_DOTS = 500  # in one line; the parser takes minutes over a key of many thousand parts

_PLACE = re.compile(r"\(at line (?P<line>\d+), column \d+\)$")
_BARE_QUANTITY = re.compile(r"=\s*[+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?\s*[A-Za-zµ]")


def load_as(path: str | Path, kind: type[S]) -> S:
    """Read a study from its file, or from the NetCDF file of a result, such as ``bands.nc``.

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
    return loads_as(text_of(checked), kind, str(path), checked.parent, near=is_result(checked))


def loads_as(
    text: str, kind: type[S], origin: str = "study", folder: Path | None = None, *, near: bool = False
) -> S:
    """Read a study from text; ``origin`` is its name in errors and warnings. Otherwise as `load_as`.

    ``folder`` is the base of paths in the study, by default the working directory. With ``near``, as for a
    result, it is the working directory or the nearest folder above ``folder`` that contains the file.
    """
    data = parsed_tables(text, origin)
    if near and folder is not None:
        folder = _folder_with_solid(data, folder)
    study = read(kind, _placed(data, folder), origin)
    for words in study.unusual():
        warnings.warn(f"{origin}: {words}", HaptonicWarning, stacklevel=2)
    return study


def examined(
    text: str, kind: type[S], folder: Path, omitted: Collection[str] = ()
) -> tuple[S | None, dict[str, Any], list[StudyError]]:
    """The study of a text, its tables as plain values, and each problem as an error of its own.

    The study is None if there is a problem; without tables the text is not TOML. A CAD file has to be in
    ``folder``, because the text may come from somebody else. Tables that are ``omitted`` are not read.
    """
    try:
        data = parsed_tables(text, "study")
    except StudyError as error:
        return None, {}, [error]
    data = {name: content for name, content in data.items() if name not in omitted}
    placed = _placed(data, folder)
    if outside := _outside(data, placed, folder):
        return None, data, [outside]
    study, problems = read_listing(kind, placed)
    return study, data, problems


def _outside(data: dict[str, Any], placed: dict[str, Any], folder: Path) -> StudyError | None:
    """Error for a CAD file outside of the folder of studies; None if there is none."""
    file = _solid_file(placed)
    if file is None or Path(file).resolve().is_relative_to(folder.resolve()):
        return None
    return StudyError.forbidden(
        argument="cell.solid.file",
        given=shown(data["cell"]["solid"]["file"], 200),
        allowed="a file in the folder of the studies, or below it",
        cause="the path leads out of the folder",
        next_step="copy the file beside the study, and give its name",
    )


def _solid_file(data: dict[str, Any]) -> str | None:
    """Path of the CAD file in the data of a study."""
    cell = data.get("cell")
    solid = cell.get("solid") if isinstance(cell, dict) else None
    file = solid.get("file") if isinstance(solid, dict) else None
    return file if isinstance(file, str) else None


def _folder_with_solid(data: dict[str, Any], folder: Path) -> Path | None:
    """Folder of the CAD file of a study in a result: that of the run may be above that of the result."""
    file, above = _solid_file(data), folder.absolute()
    if file is None:
        return None
    return next((each for each in (Path(), above, *above.parents) if (each / file).is_file()), None)


def _placed(data: dict[str, Any], folder: Path | None) -> dict[str, Any]:
    """The data of a study, with the path of its CAD file relative to the working directory."""
    file = _solid_file(data)
    if folder is None or file is None:
        return data
    cell = data["cell"]
    return {**data, "cell": {**cell, "solid": {**cell["solid"], "file": str(folder / file)}}}


def load_trials_as(path: str | Path, kind: type[S]) -> tuple[TrialSettings, S | None]:
    """The table [trials] of a study file, and the study; None for a file without other tables.

    Raises
    ------
    StudyError : as `load_as`
    """
    data = parsed_tables(text_of(source(path, "study", StudyError)), str(path))
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
    data = parsed_tables(text, "study")
    if data.keys() <= table(TrialsFile).keys():
        return read(TrialsFile, data, "study").trials, None
    study, _, problems = examined(text, kind, folder)
    if study is None:
        raise problems[0]
    return study.trials, study


def parsed_tables(text: str, origin: str) -> dict[str, Any]:
    """Tables of a text in TOML.

    Raises
    ------
    StudyError : the text is not TOML, or is empty
    """
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
    elif number == 1 and Path(origin).suffix not in ("", ENDING):
        next_step = f"give a study file, which ends in {ENDING}; this one may be a result or a measurement"
    return StudyError.malformed(
        argument=f"{origin}, line {number}" if line else origin,
        given=shown(line) if line else "text that is not TOML",
        allowed='TOML: lines such as pitch = "7 mm" below headings such as [cell]',
        cause=_PLACE.sub("", message).strip(),
        next_step=next_step,
    )
