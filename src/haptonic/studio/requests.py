"""Requests of the page: their values, checked, and the order of an analysis."""

from __future__ import annotations

from typing import Any

from haptonic.errors import StudyError, shown
from haptonic.studio.checking import title_of
from haptonic.studio.offers import chosen, offered, with_paths
from haptonic.studio.order import Order
from haptonic.studio.workspace import Workspace

UNNAMED = "my.toml"  # name in commands for a study that is not saved yet
Asked = dict[str, Any]


def order_of(asked: Asked, workspace: Workspace) -> Order:
    """The order of a request, without a number.

    Raises
    ------
    HaptonicError : an unknown analysis, a wrong option, or a file outside of the folder
    """
    analysis, file, alone = offered(asked.get("analysis")), asked.get("file"), asked.get("alone") is True
    if alone and analysis.study == "needed":
        raise unasked("alone", alone, "false, because this analysis needs a study")
    alone = alone or (analysis.study == "none" and not analysis.study_option)
    options = chosen(analysis, asked.get("options"))
    # refuse a wrong option before a process is asked
    analysis.need_options(with_paths(analysis, options, workspace.measurement))
    text = "" if alone else text_in(asked)
    return Order(
        number=0,  # given when the job begins
        text=text,
        folder=workspace.folder,
        file=file if isinstance(file, str) and file in workspace.names() else UNNAMED,
        analysis=analysis.name,
        options=options,
        title=title_of(text),
        alone=alone,
    )


def text_in(asked: Asked) -> str:
    text = asked.get("text")
    if not isinstance(text, str):
        raise unasked("text", text, "the text of a study")
    return text


def number_in(asked: Asked, name: str = "number") -> int:
    number = asked.get(name)
    if not isinstance(number, int) or isinstance(number, bool):
        raise unasked(name, number, "a number of the page")
    return number


def steps_in(change: Any) -> list[str | int]:
    """Names of tables and keys, and numbers in lists, that lead to a key."""
    steps = change.get("steps") if isinstance(change, dict) else None
    if isinstance(steps, list) and steps and all(isinstance(step, str | int) for step in steps):
        return steps
    raise unasked("steps", steps, "names of tables and keys, and numbers in lists")


def unasked(argument: str, given: object, allowed: str) -> StudyError:
    return StudyError.malformed(
        argument=argument,
        given=shown(given),
        allowed=allowed,
        cause="the request is not that of the page",
        next_step="load the page again",
    )
