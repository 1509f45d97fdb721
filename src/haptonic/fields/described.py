"""Described values: frozen dataclasses whose fields declare title, unit, bounds and help.

::

    @described("cell.pillar", GeometryError)
    class Pillar:
        diameter: Annotated[float, Quantity("m", at_least=1e-9)] = needed("Diameter of the cylinder.")
        draft: Annotated[float, Quantity("rad")] = setting(0.0, "Angle of its side.", title="Draft angle")

The declaration at the field is the only one: the check, the study file, its keys, help and labels read it. A
value is checked when it is made, in Python, ``Pillar(diameter=3.5e-3, height="14 mm")``, or from a file.
Unusual numbers then give a warning, except when this package makes the value. Conditions between fields are
checked in ``__post_init__``, which raises `problem`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import fields
from functools import partialmethod, wraps
from keyword import iskeyword
from typing import Any, TypeVar, cast, dataclass_transform

import numpy as np
from pydantic import ConfigDict, Field, ValidationError
from pydantic.dataclasses import dataclass

from haptonic.errors import HaptonicError, StudyError, shown
from haptonic.fields.keys import slots
from haptonic.fields.problems import refusal
from haptonic.fields.reading import any_placed, in_shape
from haptonic.fields.unusual import caller, unusual_values, warn_caller

T = TypeVar("T")
FILES = (".toml", ".nc")  # endings of files that contain a study


def needed(help: str, title: str = "", **more: Any) -> Any:
    """Declare a required field.

    Parameters
    ----------
    help : one sentence
    title : short title; by default the name as words
    more : further arguments of `pydantic.Field`, such as ``max_length`` or ``strict``
    """
    return Field(title=title or None, description=help, **more)


def setting(default: Any, help: str, title: str = "", **more: Any) -> Any:
    """Declare a field with a default; see `needed`."""
    return Field(default=default, title=title or None, description=help, **more)


@dataclass_transform(frozen_default=True, field_specifiers=(Field, needed))
def described(
    place: str, family: type[HaptonicError] = StudyError, *, kw_only: bool = False
) -> Callable[[type[T]], type[T]]:
    """Make a class a described value.

    Parameters
    ----------
    place : path of the value in a study, ``cell.pillar``; errors of a value made in Python begin with it
    family : class of these errors
    kw_only : True for a class whose fields are keyword arguments only
    """

    def decorate(kind: type[T]) -> type[T]:
        value: Any = dataclass(frozen=True, kw_only=kw_only, config=ConfigDict(extra="forbid"))(kind)
        check: Callable[..., None] = value.__init__
        names = [field.name for field in fields(value) if field.init]
        moved = any_placed(value)
        # a key such as "from" is no name of an argument in Python
        keywords = {slot.name: slot.key for slot in slots(value) if iskeyword(slot.key)}

        @wraps(check)
        def checked(self: Any, *given: Any, **named: Any) -> None:
            if kw_only and given and isinstance(given[0], str) and given[0].endswith(FILES):
                raise _file_for_a_value(given[0], place, family)
            try:
                named = {keywords.get(key, key): plain(each) for key, each in named.items()}
                check(self, *given, **(in_shape(value, named, complete=not given) if moved else named))
            except ValidationError as error:
                refused = refusal(error, value, place=place, family=family, names=names)
            else:
                warn_caller(_slips(self, place, (*given, *named.values())), caller(), value)
                return
            raise refused  # outside of the except clause, so that pydantic's error is not its context

        value.__init__ = checked
        value.__setattr__ = partialmethod(_refuse_change, place, family)
        return cast("type[T]", value)

    return decorate


def _file_for_a_value(given: str, place: str, family: type[HaptonicError]) -> HaptonicError:
    """Error for the name of a file in place of the values of a class with keyword arguments."""
    return family.malformed(
        argument=place or "the study",
        given=shown(given, 60),
        allowed="values by the names of their keys",
        cause="it is the name of a file",
        next_step=f"load the file: haptonic.load({given!r})",
    )


def _refuse_change(value: Any, place: str, family: type[HaptonicError], name: str, given: Any) -> None:
    """Raise the error for ``value.name = given``."""
    key = {slot.name: slot.key for slot in slots(type(value))}.get(name, name)
    kind = type(value).__name__
    copy = (
        f"study.replace({key}=...)"
        if hasattr(value, "replace")
        else f"dataclasses.replace(value, {name}=...)"
    )
    raise family.unsupported(
        argument=f"{place}.{key}".lstrip("."),
        given=shown(given, 60),
        allowed="a value that is given when the object is made",
        cause=f"an object of {kind} does not change after it is made",
        next_step=f"make a changed copy, {copy}",
    )


def plain(value: Any) -> Any:
    """A value with Python's numbers in place of NumPy's scalars, also in tables and lists."""
    if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and not value.ndim):
        return value.item()
    if isinstance(value, dict):
        return {key: plain(each) for key, each in value.items()}
    return [plain(each) for each in value] if isinstance(value, list) else value


def _slips(value: Any, place: str, given: tuple[Any, ...]) -> Iterator[str]:
    """Remarks on unusual numbers of a value made in Python; values made before have been checked already."""
    ready = {id(part) for each in given for part in (each if isinstance(each, list | tuple) else (each,))}
    prefix = f"{place}." if place else ""
    for path, words in unusual_values(value, prefix, ready).items():
        yield f"{path}: {words}"


def extended(kind: type[T]) -> type[T]:
    """Make a subclass of a described study, which adds methods and no fields, a described value as well.

    It has no `dataclass_transform`: mypy would otherwise take the alias of a field for an attribute of the
    subclass, which hides a method of the same name.
    """
    return described("", kw_only=True)(kind)


def remade(value: T, **changes: Any) -> T:
    """A checked copy of a described value with some fields changed, given by their names."""
    given = {slot.key: changes.get(slot.name, getattr(value, slot.name)) for slot in slots(type(value))}
    return type(value)(**given)


def unchecked(value: T, **changes: Any) -> T:
    """A copy without a check, for example with a part left out."""
    copy: T = object.__new__(type(value))
    for field in fields(value):  # type: ignore[arg-type]
        object.__setattr__(copy, field.name, changes.get(field.name, getattr(value, field.name)))
    return copy
