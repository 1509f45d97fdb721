"""From the tables of a file to the shape of the values that they describe."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from pydantic import ValidationError

from haptonic.fields.keys import is_described, slots
from haptonic.fields.placing import Placed
from haptonic.fields.problems import MISPLACED, refusal
from haptonic.fields.quantity import FROM_FILE

T = TypeVar("T")


def read(kind: type[T], tables: Mapping[str, Any], origin: str = "") -> T:
    """A described value from the tables of a file, where a number with a dimension needs its unit.

    Parameters
    ----------
    origin : how errors call the file

    Raises
    ------
    StudyError : one for all problems
    """
    value: Any = kind
    try:
        made: T = value.__pydantic_validator__.validate_python(arranged(kind, tables), context=FROM_FILE)
    except ValidationError as error:
        refused = refusal(error, kind, origin=origin)
    else:
        return made
    raise refused  # out here it does not drag the whole file along as its context when it is pickled


def any_placed(kind: type) -> bool:
    """Whether some key of a described class, or of one in it, stands elsewhere than its value."""
    return any(
        slot.placed != Placed() or any(any_placed(below) for below in slot.kinds) for slot in slots(kind)
    )


def arranged(
    kind: type, given: Mapping[str, Any], top: dict[str, Any] | None = None, *, complete: bool = False
) -> dict[str, Any]:
    """What a file gives for a described class, in the shape of the values: every key at the value it is of.

    Parameters
    ----------
    given : the table; values that were made already are left as they are
    top : the outermost table, from which keys are taken; by default ``given`` itself
    complete : whether nothing is given elsewhere, such as by arguments without a keyword
    """
    own = dict(given)
    complete = complete or top is not None
    top = own if top is None else top
    for slot in slots(kind):
        for below in slot.kinds:
            value = own.get(slot.key)
            if is_described(value):
                continue
            moved = {one.key: top.pop(one.key) for one in slots(below) if one.placed.top and one.key in top}
            if slot.placed.inline:
                keys = [one.key for one in slots(below) if one.key in own]
                if keys or complete:
                    own[slot.key] = {key: own.pop(key) for key in keys}
            elif isinstance(value, Mapping) or (moved and not slot.field.is_required()):
                outside = {one.key for one in slots(below) if one.placed.top}
                given_here = dict(value or {}).items()
                here = {f"{MISPLACED}{key}" if key in outside else key: one for key, one in given_here}
                own[slot.key] = arranged(below, {**moved, **here}, top)
            elif isinstance(value, list | tuple):
                own[slot.key] = [
                    arranged(below, one, top) if isinstance(one, Mapping) else one for one in value
                ]
    return own


def with_value(given: Any, steps: list[str], value: Any) -> Any:
    """The content of a file with another value where these steps end; steps into a list count from 1."""
    if not steps:
        return value
    step, *left = steps
    if isinstance(given, list) and step in map(str, range(1, len(given) + 1)):
        row = int(step) - 1
        return [*given[:row], with_value(given[row], left, value), *given[row + 1 :]]
    inside = given if isinstance(given, dict) else {}  # a step that leads nowhere is refused when it is read
    return inside | {step: with_value(inside.get(step), left, value)}
