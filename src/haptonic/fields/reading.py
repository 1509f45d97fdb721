"""Conversion of the tables of a file to described values."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

import numpy as np
from pydantic import ValidationError

from haptonic.errors import StudyError, shown
from haptonic.fields.expressions import PARAMETERS, scoped
from haptonic.fields.keys import is_described, slots
from haptonic.fields.placing import Placed
from haptonic.fields.problems import MISPLACED, problems_of, refusal
from haptonic.fields.quantity import FROM_FILE

T = TypeVar("T")


def read(kind: type[T], tables: Mapping[str, Any], origin: str = "") -> T:
    """Read a described value from the tables of a file; there, a number with a dimension needs its unit.

    Parameters
    ----------
    origin : name of the file in errors

    Raises
    ------
    StudyError : one error for all problems
    """
    value: Any = kind
    try:
        result: T = value.__pydantic_validator__.validate_python(in_shape(kind, tables), context=FROM_FILE)
    except ValidationError as error:
        refused = refusal(error, kind, origin=origin)
    else:
        return result
    raise refused  # outside of the except clause, so that the file is not pickled as its context


def read_listing(kind: type[T], tables: Mapping[str, Any]) -> tuple[T | None, list[StudyError]]:
    """The described value of the tables of a file, or else each of their problems as an error of its own."""
    value: Any = kind
    try:
        return value.__pydantic_validator__.validate_python(in_shape(kind, tables), context=FROM_FILE), []
    except ValidationError as error:
        return None, problems_of(error, kind)


def in_shape(kind: type, given: Mapping[str, Any], *, complete: bool = False) -> dict[str, Any]:
    """Tables in the shape of a described class; texts of a study may use its named parameters.

    complete : see `arranged`
    """
    is_study = any(slot.key == PARAMETERS for slot in slots(kind))
    return arranged(kind, scoped(given) if is_study else given, complete=complete)


def any_placed(kind: type) -> bool:
    """True if a key of a described class, or of a class in it, is outside of the table of its value."""
    return any(
        slot.placed != Placed() or any(any_placed(below) for below in slot.kinds) for slot in slots(kind)
    )


def arranged(
    kind: type, given: Mapping[str, Any], top: dict[str, Any] | None = None, *, complete: bool = False
) -> dict[str, Any]:
    """The tables of a file in the shape of a described class, with every key at its value.

    Parameters
    ----------
    given : the table; values that are already made are not changed
    top : outermost table, from which keys are taken; by default ``given`` itself
    complete : True if no field is given in another way, such as by a positional argument
    """
    result = dict(given)
    complete = complete or top is not None
    top = result if top is None else top
    for slot in slots(kind):
        for below in slot.kinds:
            value = result.get(slot.key)
            if is_described(value):
                continue
            moved = {
                inner.key: top.pop(inner.key)
                for inner in slots(below)
                if inner.placed.top and inner.key in top
            }
            if slot.placed.inline:
                keys = [inner.key for inner in slots(below) if inner.key in result]
                if keys or complete:
                    result[slot.key] = {key: result.pop(key) for key in keys}
            elif isinstance(value, Mapping) or (moved and not slot.field.is_required()):
                outside = {inner.key for inner in slots(below) if inner.placed.top}
                given_here = dict(value or {}).items()
                here = {f"{MISPLACED}{key}" if key in outside else key: v for key, v in given_here}
                result[slot.key] = arranged(below, {**moved, **here}, top)
            elif isinstance(value, list | tuple):
                result[slot.key] = [
                    arranged(below, item, top) if isinstance(item, Mapping) else item for item in value
                ]
    return result


def with_values(tables: dict[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """The tables of a file with other values of keys such as ``cell.site[2].pillar.height``.

    Raises
    ------
    StudyError : changes without the names of keys, or a table of a list that does not exist
    """
    if not isinstance(changes, Mapping) or not all(isinstance(key, str) for key in changes):
        raise StudyError.malformed(
            argument="changes",
            given=shown(changes),
            allowed='values by key, such as {"cell.pitch": "8 mm"}',
            cause="a value without the name of its key",
            next_step="write a dictionary with the keys of the study file",
        )
    for key, value in changes.items():
        steps = key.replace("[", ".").replace("]", "").split(".")
        tables = _changed(tables, key, steps, value.item() if isinstance(value, np.generic) else value)
    return tables


def _changed(given: Any, key: str, steps: list[str], value: Any) -> Any:
    """Tables with another value at the end of some steps; steps into a list count from 1."""
    if not steps:
        return value
    step, *left = steps
    if isinstance(given, list):
        numbers = [str(number) for number in range(1, len(given) + 1)]
        if step not in numbers:
            raise StudyError.unknown(
                key, step, numbers, f"tables count from 1; the list has no table {step}", slip=False
            )
        row = int(step) - 1
        return [*given[:row], _changed(given[row], key, left, value), *given[row + 1 :]]
    inside = given if isinstance(given, dict) else {}  # an impossible step is refused when the result is read
    return inside | {step: _changed(inside.get(step), key, left, value)}
