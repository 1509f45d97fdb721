"""Analyses with their options, for the list of the page."""

from __future__ import annotations

import json
import shlex
from collections.abc import Callable, Iterator, Mapping
from dataclasses import MISSING, Field, fields
from functools import cache
from pathlib import Path
from types import NoneType
from typing import Any, Literal, get_args, get_origin, get_type_hints

from haptonic.analyses import NAMES, named
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.options import Option, option_of
from haptonic.errors import HaptonicError, StudyError

PATH = "path"  # form of an option that names a file or folder of the workspace


@cache
def offers() -> list[dict[str, Any]]:
    """Name, help, needs and options of each offered analysis, in the order of the command line.

    ``study`` is "needed", "optional" or "none"; ``tables`` are those of the study with settings for the files
    """
    return [
        {
            "name": name,
            "help": NAMES[name],
            "interactive": bool(named(name).interactive),
            "examines": named(name).examine is not None,
            "study": "settings" if named(name).study_option else named(name).study,
            "tables": list(named(name).tables),
            "options": list(_options(named(name))),
        }
        for name in NAMES
        if is_offered(named(name))
    ]


def is_offered(analysis: Analysis) -> bool:
    """True if a page can give all that the analysis needs; files only are written by the command line."""
    asked = {option["name"] for option in _options(analysis)}
    needed = {
        field.name
        for field in fields(analysis.options)
        if field.default is MISSING and field.default_factory is MISSING
    }
    return needed <= asked and not analysis.writes


def offered(name: object) -> Analysis:
    """The analysis of a name in the list.

    Raises
    ------
    StudyError : the list has no such name
    """
    if isinstance(name, str) and name in NAMES and is_offered(named(name)):  # imports no other analysis
        return named(name)
    known = [offer["name"] for offer in offers()]
    raise StudyError.unknown("name of the analysis", str(name)[:60], known, "no analysis has this name")


def _options(analysis: Analysis) -> Iterator[dict[str, Any]]:
    """Options that a page can ask for: words, numbers, choices, yes or no, and names of files."""
    kinds = get_type_hints(analysis.options)
    for field in fields(analysis.options):
        option = option_of(field)
        if option is None or field.name in (analysis.interactive, analysis.study_option):
            continue
        form = _form(option, kinds[field.name])
        if form is None:
            continue
        default = None if field.default is MISSING or form == PATH else field.default
        yield {
            "name": field.name, "form": form, "unit": option.unit, "help": option.help,
            "choices": list(_choices(kinds[field.name])), "default": default if default != () else None,
            "topic": option.topic,
            # a command needs the file that it analyses; in Python a value may replace it
            "required": field.default is MISSING or option.place == "before",
        }  # fmt: skip


def _choices(kind: Any) -> tuple[str, ...]:
    """Words of a type that allows only these."""
    for part in (kind, *get_args(kind)):
        if get_origin(part) is Literal:
            return get_args(part)
    return ()


def _form(option: Option, kind: Any) -> str | None:
    """How a page asks for a value; None if it cannot."""
    plain = [part for part in get_args(kind) or (kind,) if part is not NoneType]
    if option.is_path or plain == [Path]:
        return PATH
    if option.is_text:
        return "text"
    if _choices(kind):
        return "choice"
    simple = len(plain) == 1 and plain[0] in (bool, int, float, str)
    return plain[0].__name__ if simple else None


def chosen(analysis: Analysis, given: object) -> dict[str, Any]:
    """Options of the page by name; those of the interactive view are added.

    Raises
    ------
    StudyError : options that are not a table, or that the page does not offer
    """
    if not isinstance(given, dict):
        raise StudyError.malformed(
            argument="options", given=str(given)[:60], allowed="a table of options by name",
            cause="the request is not that of the page", next_step="load the page again",
        )  # fmt: skip
    known = {option["name"] for option in _options(analysis)} | {analysis.interactive}
    asked = {name: value for name, value in given.items() if value not in (None, "")}
    for name in asked:
        if name not in known:
            raise StudyError.unknown(str(name), str(name)[:60], sorted(known), "the page has no such option")
    return asked | ({analysis.interactive: True} if analysis.interactive else {})


def with_paths(
    analysis: Analysis, options: Mapping[str, Any], path_of: Callable[[object], Path]
) -> dict[str, Any]:
    """The options with the paths of the files that they name.

    Raises
    ------
    HaptonicError : from ``path_of``, with the name of the option
    """
    named_files = {option["name"] for option in _options(analysis) if option["form"] == PATH}
    placed = dict(options)
    for name in named_files & options.keys():
        try:
            placed[name] = path_of(options[name])
        except HaptonicError as error:
            raise error.changed(type(error), argument=name) from error
    return placed


def as_command(analysis: Analysis, file: str, options: Mapping[str, Any], *, alone: bool = False) -> str:
    """The command that repeats an analysis; ``alone`` without a study."""
    before, behind, flags = list[str](), list[str](), list[str]()
    for option, _field, value in _given(analysis, options):
        if option.place != "option":
            (before if option.place == "before" else behind).append(str(value))
            continue
        flag = option.flag.split("/")[0]
        flags += [flag] if value is True else [flag, str(value)]
    if analysis.study_option and not alone:
        flags += [f"--{analysis.study_option}", file]
    study = [file] if analysis.study != "none" and not alone else []
    return shlex.join(["haptonic", *analysis.name.split(), *before, *study, *behind, *flags])


def measured_files(analysis: Analysis, options: Mapping[str, Any]) -> str:
    """Names of the files that an analysis reads."""
    given = _given(analysis, options)
    return ", ".join(str(value) for option, _, value in given if option.place != "option")


def as_python(analysis: Analysis, file: str, options: Mapping[str, Any], *, alone: bool = False) -> str:
    """The line of Python that repeats an analysis; ``alone`` without a study."""
    given = {field.name: value for _, field, value in _given(analysis, options)}
    if analysis.study != "none" and not alone:
        words = ", ".join(f"{name}={_literal(value)}" for name, value in given.items())
        return f"haptonic.load({_literal(file)}).{analysis.method}({words})"
    if analysis.study_option and not alone:
        given[analysis.study_option] = file
    words = ", ".join(f"{_literal(name)}: {_literal(value)}" for name, value in given.items())
    return (
        "from haptonic.analyses import named, runner; "
        f"named({_literal(analysis.name)}).run(None, runner.Runner(), {{{words}}})"
    )


def _given(analysis: Analysis, options: Mapping[str, Any]) -> Iterator[tuple[Option, Field[Any], Any]]:
    """Options with a value other than the default, in the order of their declaration."""
    for field in fields(analysis.options):
        option = option_of(field)
        if option is not None and field.name in options and options[field.name] != field.default:
            yield option, field, options[field.name]


def _literal(value: Any) -> str:
    return str(value) if isinstance(value, bool) else json.dumps(value, ensure_ascii=False)
