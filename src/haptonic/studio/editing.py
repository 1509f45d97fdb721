"""Change of one key in the text of a study; comments and the order of everything else are not changed."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from typing import Any

import tomlkit
from tomlkit.exceptions import TOMLKitError
from tomlkit.items import String, StringType, Trivia

from haptonic.errors import StudyError

Step = str | int  # a key, or the number of a table in a list, from 0
LONGEST = 5000  # lines; the library takes 10 s for a hundred thousand
HEADING = re.compile(r"\s*(\[\[?)\s*([^\]]+?)\s*\]\]?\s*(?:#.*)?$")
KEY = re.compile(
    r"""\s*((?:[A-Za-z0-9_-]+|"[^"]*"|'[^']*')(?:\s*\.\s*(?:[A-Za-z0-9_-]+|"[^"]*"|'[^']*'))*)\s*="""
)
PART = re.compile(r"""[A-Za-z0-9_-]+|"[^"]*"|'[^']*'""")


def changed(text: str, steps: Sequence[Step], value: Any) -> str:
    """The text with another value at the end of some steps; None removes the key, or the table in a list.

    Raises
    ------
    StudyError : a text that is not TOML, steps that it does not have, or a text in which only an editor can
        change this key
    """
    try:
        before = tomllib.loads(text)
        _need(len(text.splitlines()) <= LONGEST)
        wanted = _with(before, list(steps), value)
        document = tomlkit.parse(text)
        _change(document, list(steps), value)
        result = tomlkit.dumps(document)
        _need(tomllib.loads(result) == wanted)
    # the library has faults in rare orders of tables; the comparison above finds them
    except (TOMLKitError, AttributeError, LookupError, TypeError, ValueError):
        raise StudyError.unsupported(
            argument=".".join(map(str, steps))[:100],
            given="a change in the form",
            allowed="a text in TOML whose tables are in a usual order",
            cause="the text is not TOML, is too long, or gives the tables of this key in several places",
            next_step="change the text itself",
        ) from None
    return result


def _need(fits: bool) -> None:
    if not fits:
        raise ValueError


def _with(tables: Any, steps: list[Step], value: Any) -> Any:
    """Plain tables with the change."""
    step, *rest = steps
    if isinstance(tables, list):
        if not isinstance(step, int) or not 0 <= step <= len(tables):
            raise LookupError(step)
        items = list(tables)
        if rest:
            items[step] = _with(items[step], rest, value)
        else:
            items[step : step + 1] = [] if value is None else [value]
        return items
    if not isinstance(step, str) or not isinstance(tables, dict):
        raise LookupError(step)
    result = dict(tables)
    if not rest and value is None:
        del result[step]
    elif rest:
        start: Any = [] if isinstance(rest[0], int) else {}
        result[step] = _with(result.get(step, start), rest, value)
        if result[step] == [] and value is None:
            del result[step]
    else:
        result[step] = value
    return result


def _change(place: Any, steps: list[Step], value: Any) -> None:
    """Make the change in the document of tomlkit."""
    step, *rest = steps
    if not rest:
        if value is None:
            del place[step]
        elif isinstance(step, int):
            place.insert(step, _item(value)) if step == len(place) else place.__setitem__(step, _item(value))
        else:
            place[step] = _item(value)  # keeps the comment behind a value
        return
    if isinstance(step, str) and step not in place:
        place[step] = tomlkit.aot() if isinstance(rest[0], int) else tomlkit.table()
    _change(place[step], rest, value)
    if isinstance(rest[0], int) and value is None and len(rest) == 1 and not len(place[step]):
        del place[step]


def _item(value: Any) -> Any:
    if isinstance(value, str) and "\n" in value and "\r" not in value:
        lines = tomlkit.string(value, multiline=True).as_string()[3:-3]
        return String(StringType.MLB, value, f"\n{lines}", Trivia())  # the first line break does not count
    if not isinstance(value, dict):
        return value
    table = tomlkit.table()
    for key, inner in value.items():
        table[key] = _item(inner)
    return table


def steps_of(path: str) -> list[Step]:
    """Steps to a key, from its path: ``sweep[1].from`` is in the first table of the list."""
    steps: list[Step] = []
    for part in path.split("."):
        name, _, number = part.partition("[")
        steps += [name, int(number.rstrip("]")) - 1] if number else [name]
    return steps


def path_of(steps: Sequence[Step]) -> str:
    """Path of a key from its steps; the inverse of `steps_of`."""
    path = ""
    for step in steps:
        path += f"[{step + 1}]" if isinstance(step, int) else f".{step}"
    return path.removeprefix(".")


def lines_of(text: str) -> dict[str, int]:
    """Line of each key and table by its path, both counted from 1: ``sweep[1].from``."""
    lines, counts = dict[str, int](), dict[str, int]()
    table, quotes = "", ""
    for number, line in enumerate(text.splitlines(), start=1):
        if quotes:  # within a text of several lines
            quotes = "" if quotes in line else quotes
            continue
        if heading := HEADING.match(line):
            table = _heading(heading[2], heading[1] == "[[", counts)
            lines.setdefault(table, number)
        elif key := KEY.match(line):
            steps = _parts(key[1])
            for count in range(1, len(steps) + 1):
                lines.setdefault(".".join(filter(None, [table, *steps[:count]])), number)
            rest = line[key.end() :].strip()
            quotes = next((mark for mark in ('"""', "'''") if rest.startswith(mark)), "")
            quotes = "" if quotes and quotes in rest[3:] else quotes
    return lines


def _heading(name: str, is_list: bool, counts: dict[str, int]) -> str:
    """Path of a heading, with the numbers of the tables in lists."""
    path = ""
    steps = _parts(name)
    for number, step in enumerate(steps, start=1):
        path = f"{path}.{step}".lstrip(".")
        if number == len(steps) and is_list:
            counts[path] = counts.get(path, 0) + 1
            # lists below a new table of a list are counted again from the first
            for below in [inner for inner in counts if inner.startswith(f"{path}[{counts[path]}].")]:
                del counts[below]
        if path in counts:
            path = f"{path}[{counts[path]}]"
    return path


def _parts(name: str) -> list[str]:
    return [part.strip("\"'") for part in PART.findall(name)]
