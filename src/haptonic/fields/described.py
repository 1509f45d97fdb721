"""What a declared value is: a frozen dataclass whose fields carry title, unit, bounds and help.

::

    @described("cell.pillar", GeometryError)
    class Pillar:
        diameter: Annotated[float, Quantity("m", at_least=1e-9)] = Field(title="Diameter", description="...")

The declaration stands beside the field and nowhere else: the check, the study file, its keys, help and labels
read it. A value is checked whenever it is made, in Python, ``Pillar(diameter=3.5e-3, height="14 mm")``, or
from a file. What has to hold between fields is checked in ``__post_init__``, which raises `problem`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from functools import wraps
from typing import Any, TypeVar, cast, dataclass_transform

from pydantic import BaseModel, ConfigDict, Field, ValidationError
from pydantic.dataclasses import dataclass

from haptonic.errors import HaptonicError, StudyError
from haptonic.fields.problems import refusal

T = TypeVar("T")


class Section(BaseModel):
    """A table of the study file that is no value of the domain: immutable, without unknown keys."""

    model_config = ConfigDict(frozen=True, extra="forbid")


@dataclass_transform(frozen_default=True, field_specifiers=(Field,))
def described(place: str, family: type[HaptonicError] = StudyError) -> Callable[[type[T]], type[T]]:
    """Make a class a declared value.

    Parameters
    ----------
    place : where the value stands in a study, ``cell.pillar``; errors of a value made in Python begin with it
    family : kind of these errors
    """

    def made(kind: type[T]) -> type[T]:
        value: Any = dataclass(frozen=True, config=ConfigDict(extra="forbid"))(kind)
        check: Callable[..., None] = value.__init__
        names = [field.name for field in fields(value) if field.init]

        @wraps(check)
        def checked(self: Any, *given: Any, **named: Any) -> None:
            try:
                check(self, *given, **named)
            except ValidationError as error:
                refused = refusal(error, value, place=place, family=family, names=names)
            else:
                return
            raise refused  # out here it does not drag what pydantic saw along as its context

        value.__init__ = checked
        return cast("type[T]", value)

    return made
