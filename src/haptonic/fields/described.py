"""What a declared value is: a frozen dataclass whose fields carry title, unit, bounds and help.

::

    @described("cell.pillar", GeometryError)
    class Pillar:
        diameter: Annotated[float, Quantity("m", at_least=1e-9)] = needed("Of the cylinder.")
        draft: Annotated[float, Quantity("rad")] = setting(0.0, "Of its side.", title="Draft angle")

The declaration stands beside the field and nowhere else: the check, the study file, its keys, help and labels
read it. A value is checked whenever it is made, in Python, ``Pillar(diameter=3.5e-3, height="14 mm")``, or
from a file. Unusual numbers are warned about then, but not where this package makes the value. What has to
agree between fields is checked in ``__post_init__``, which raises `problem`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import fields
from functools import wraps
from typing import Any, TypeVar, cast, dataclass_transform

from pydantic import ConfigDict, Field, ValidationError
from pydantic.dataclasses import dataclass

from haptonic.errors import HaptonicError, StudyError
from haptonic.fields.keys import slots
from haptonic.fields.problems import refusal
from haptonic.fields.reading import any_placed, arranged
from haptonic.fields.unusual import caller, unusual_values, warn_caller

T = TypeVar("T")


def needed(help: str, title: str = "", **more: Any) -> Any:
    """A field that has to be given.

    Parameters
    ----------
    help : what it is, a sentence
    title : heads it where it is shown; by default its name as words
    more : what `pydantic.Field` takes besides, ``max_length`` or ``strict``
    """
    return Field(title=title or None, description=help, **more)


def setting(default: Any, help: str, title: str = "", **more: Any) -> Any:
    """A field with a default; see `needed`."""
    return Field(default=default, title=title or None, description=help, **more)


@dataclass_transform(frozen_default=True, field_specifiers=(Field, needed))
def described(
    place: str, family: type[HaptonicError] = StudyError, *, kw_only: bool = False
) -> Callable[[type[T]], type[T]]:
    """Make a class a declared value.

    Parameters
    ----------
    place : where the value stands in a study, ``cell.pillar``; errors of a value made in Python begin with it
    family : kind of these errors
    kw_only : whether fields are given by their names only
    """

    def made(kind: type[T]) -> type[T]:
        value: Any = dataclass(frozen=True, kw_only=kw_only, config=ConfigDict(extra="forbid"))(kind)
        check: Callable[..., None] = value.__init__
        names = [field.name for field in fields(value) if field.init]
        moved = any_placed(value)

        @wraps(check)
        def checked(self: Any, *given: Any, **named: Any) -> None:
            try:
                check(self, *given, **(arranged(value, named, complete=not given) if moved else named))
            except ValidationError as error:
                refused = refusal(error, value, place=place, family=family, names=names)
            else:
                warn_caller(_slips(self, place, (*given, *named.values())), caller(), value)
                return
            raise refused  # out here it does not drag what pydantic saw along as its context

        value.__init__ = checked
        return cast("type[T]", value)

    return made


def _slips(made: Any, place: str, given: tuple[Any, ...]) -> Iterator[str]:
    """Words on unusual numbers of a value made in Python; values in it that were made before had theirs."""
    ready = {id(one) for each in given for one in (each if isinstance(each, list | tuple) else (each,))}
    prefix = f"{place}." if place else ""
    for path, words in unusual_values(made, prefix, ready).items():
        yield f"{path}: {words}"


def extended(kind: type[T]) -> type[T]:
    """Make a subclass of a declared study, which adds methods and no fields, a declared value as well.

    mypy takes an alias of a field for an attribute of such a subclass, where it hides a method of that name;
    so it is not told that this is a dataclass.
    """
    return described("", kw_only=True)(kind)


def remade(value: T, **changes: Any) -> T:
    """A copy of a described value with some fields, by their names, changed; it checks itself."""
    given = {slot.key: changes.get(slot.name, getattr(value, slot.name)) for slot in slots(type(value))}
    return type(value)(**given)


def unchecked(value: T, **changes: Any) -> T:
    """A copy without a check: for a part left out, or to ask how far a value is from a possible one."""
    made: T = object.__new__(type(value))
    for field in fields(value):  # type: ignore[arg-type]
        object.__setattr__(made, field.name, changes.get(field.name, getattr(value, field.name)))
    return made
