"""State of a text: its values, its problems at their lines, and remarks on unusual values."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from haptonic.errors import HaptonicError, StudyError
from haptonic.fields import unusual_values
from haptonic.studio.editing import lines_of
from haptonic.studio.painting import painting
from haptonic.study import Study
from haptonic.study.loading import examined, parsed_tables

LINE = re.compile(r", line (\d+)$")  # end of the argument of an error in the syntax
MOST = 50  # problems


def checked(text: str, folder: Path) -> dict[str, Any]:
    """Values, problems and remarks of a text, in plain values for the page, and the drawing of its plate.

    Without ``values`` the text is not TOML. The drawing is that of `painting`, None if there is a problem.
    """
    study, data, problems = study_in(text, folder)
    lines = lines_of(text)
    return {
        "values": _plain(data) if data else None,
        "problems": [described(problem, lines) for problem in problems[:MOST]],
        "remarks": [] if study is None else [
            {"path": path, "text": words, "line": line_at(path, lines)}
            for path, words in unusual_values(study).items()
        ],
        "title": "" if study is None else study.title,
        "plate": None if study is None else painting(study),
    }  # fmt: skip


def study_in(text: str, folder: Path) -> tuple[Study | None, dict[str, Any], Sequence[HaptonicError]]:
    """The study of a text, its tables and its problems, as from `examined`; it raises no error."""
    try:
        return examined(text, Study, folder)
    except HaptonicError as error:
        return None, {}, [error]


def title_of(text: str) -> str:
    """Title in the text of a study, also of one with problems; empty without one."""
    try:
        title = parsed_tables(text, "study").get("title")
    except StudyError:
        return ""
    return title if isinstance(title, str) else ""


def described(error: HaptonicError, lines: Mapping[str, int]) -> dict[str, Any]:
    """The parts of an error, with the path and the line of its key."""
    parts: dict[str, Any] = error.parts()
    syntax = LINE.search(error.argument)
    line = int(syntax[1]) if syntax else line_at(error.argument, lines)
    return parts | {"path": "" if syntax else error.argument, "line": line}


def line_at(path: str, lines: Mapping[str, int]) -> int | None:
    """Line of a key, or else of the innermost table that the text has; None for a key at the top."""
    while path:
        if path in lines:
            return lines[path]
        path = path[: path.rindex("[")] if path.endswith("]") else path.rpartition(".")[0]
    return None


def _plain(value: Any) -> Any:
    """Values of TOML for JSON: dates and numbers that are not finite become texts."""
    if isinstance(value, dict):
        return {key: _plain(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [_plain(inner) for inner in value]
    if isinstance(value, float) and value - value != 0:
        return str(value)
    return value if isinstance(value, str | int | float | bool) else str(value)
