"""Analyses that need only a study, with their options, for the list of the page."""

from __future__ import annotations

import json
import shlex
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, fields
from functools import cache
from types import NoneType
from typing import Any, Literal, get_args, get_origin, get_type_hints

from haptonic.analyses import NAMES, named
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.options import option_of
from haptonic.errors import StudyError


@cache
def offers() -> list[dict[str, Any]]:
    """Name, help and options of each offered analysis, in the order of the command line."""
    return [
        {
            "name": name,
            "help": NAMES[name],
            "interactive": bool(named(name).interactive),
            "options": list(_options(named(name))),
        }
        for name in NAMES
        if is_offered(named(name))
    ]


def is_offered(analysis: Analysis) -> bool:
    """True for an analysis that answers from the study alone; files only are written by the command line."""
    needed = [
        field
        for field in fields(analysis.options)
        if field.default is MISSING and field.default_factory is MISSING
    ]
    return analysis.study == "needed" and not needed and not analysis.writes


def offered(name: object) -> Analysis:
    """The analysis of a name in the list.

    Raises
    ------
    StudyError : the list has no such name
    """
    known = [offer["name"] for offer in offers()]
    if not isinstance(name, str) or name not in known:
        raise StudyError.unknown("name of the analysis", str(name)[:60], known, "no analysis has this name")
    return named(name)


def _options(analysis: Analysis) -> Iterator[dict[str, Any]]:
    """Options that a page can ask for: words, numbers, choices, yes or no."""
    kinds = get_type_hints(analysis.options)
    for field in fields(analysis.options):
        option = option_of(field)
        kind = kinds[field.name]
        plain = [part for part in get_args(kind) or (kind,) if part is not NoneType]
        choices = list(get_args(kind)) if get_origin(kind) is Literal else []
        simple = choices or (len(plain) == 1 and plain[0] in (bool, int, float, str))
        if option is None or option.read or not simple or field.name == analysis.interactive:
            continue
        form = "choice" if choices else "text" if option.unit else plain[0].__name__
        yield {
            "name": field.name, "form": form, "unit": option.unit, "help": option.help, "choices": choices,
            "default": field.default,
        }  # fmt: skip


def chosen(analysis: Analysis, given: object) -> dict[str, Any]:
    """Options of the page by name; those of the interactive view are added.

    Raises
    ------
    StudyError : options that are not a table
    """
    if not isinstance(given, dict):
        raise StudyError.malformed(
            argument="options", given=str(given)[:60], allowed="a table of options by name",
            cause="the request is not that of the page", next_step="load the page again",
        )  # fmt: skip
    asked = {name: value for name, value in given.items() if value not in (None, "")}
    return asked | ({analysis.interactive: True} if analysis.interactive else {})


def as_command(analysis: Analysis, file: str, options: Mapping[str, Any]) -> str:
    """The command that repeats an analysis."""
    words = ["haptonic", *analysis.name.split(), file]
    declared = {field.name: (option_of(field), field.default) for field in fields(analysis.options)}
    for name, value in options.items():
        option, default = declared[name]
        if option is None or value == default:
            continue
        flag = option.flag.split("/")[0]
        words += [flag] if value is True else [flag, str(value)]
    return shlex.join(words)


def as_python(analysis: Analysis, file: str, options: Mapping[str, Any]) -> str:
    """The line of Python that repeats an analysis."""
    declared = {field.name: field.default for field in fields(analysis.options)}
    given = [
        f"{name}={value if isinstance(value, bool) else json.dumps(value, ensure_ascii=False)}"
        for name, value in options.items()
        if value != declared[name]
    ]
    return f"haptonic.load({json.dumps(file, ensure_ascii=False)}).{analysis.method}({', '.join(given)})"
