"""Tables on one number of a study, whose own numbers have the unit of that number."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from pydantic import Field, ValidationInfo, field_validator

from haptonic.errors import StudyError
from haptonic.fields.described import described, needed
from haptonic.fields.expressions import NAMED, ExpressedNumber
from haptonic.fields.quantity import handed_on, number_of, number_of_any_unit, problem
from haptonic.units import format_quantity


@described("")
class OfNumber:
    """A table on one number of the study; a subclass defines `unit_of` and `known`."""

    takes_parameters: ClassVar[bool] = False  # True if it may name one of [parameters]

    parameter: str = needed("Name of a number in this file; tables of one name count from 1.", strict=True)

    @classmethod
    def unit_of(cls, path: str) -> str | None:
        """SI unit of a number that the table allows; None for other names."""
        raise NotImplementedError

    @classmethod
    def known(cls) -> Sequence[str]:
        """Paths of the allowed numbers."""
        raise NotImplementedError

    @field_validator("parameter")
    @classmethod
    def _known(cls, path: str) -> str:
        if cls.takes_parameters and path.startswith(NAMED):
            return path  # the study has its name and unit
        if cls.unit_of(path) is None:
            cause = "no number of this name can be changed here"
            raise handed_on(StudyError.unknown("", path, cls.known(), cause))
        return path

    @field_validator("low", "high", "spread", mode="plain", check_fields=False)
    @classmethod
    def _in_its_unit(cls, value: object, info: ValidationInfo) -> float:
        if "parameter" not in info.data:  # already refused; the unit is then unknown
            return 0.0
        if cls.takes_parameters and info.data["parameter"].startswith(NAMED):
            return number_of_any_unit(value)
        return number_of(value, cls.unit_of(info.data["parameter"]) or "", info.context)

    @property
    def names_parameter(self) -> bool:
        """True for a number of [parameters], whose unit only the study has."""
        return self.parameter.startswith(NAMED)

    @property
    def unit(self) -> str:
        """SI unit of the number; empty for a dimensionless number."""
        if self.names_parameter:
            given = (getattr(self, name, None) for name in ("high", "low", "spread"))
            return next((end.unit for end in given if isinstance(end, ExpressedNumber) and end), "")
        return self.unit_of(self.parameter) or ""


@described("")
class NumberRange(OfNumber):
    """A number that may change between two bounds, SI."""

    low: float = Field(
        alias="from", title="Lowest value", description="Lowest value, with its unit.", examples=["2 mm"]
    )
    high: float = Field(
        alias="to", title="Highest value", description="Highest value, with its unit.", examples=["5 mm"]
    )

    def __post_init__(self) -> None:
        if not self.low < self.high:
            raise problem(
                "conflict",
                format_quantity(self.high, self.unit),
                f"more than the lowest value, {format_quantity(self.low, self.unit)}",
                "the bounds contradict each other",
                "exchange them, or leave the parameter out to keep its value",
                at="to",
            )


def once(parameters: Sequence[OfNumber], at: str) -> None:
    """Refuse a number that occurs in two tables of one name; ``at`` is that name."""
    names = [table.parameter for table in parameters]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise problem(
            "repeated",
            f"{twice[0]}, twice",
            "every parameter once",
            "a table was copied",
            "remove one of them",
            at=at,
        )


def ascending(lowest: float | None, highest: float | None, what: str) -> None:
    """Refuse two ends of a range of frequencies, Hz, in the wrong order."""
    if lowest is not None and highest is not None and lowest >= highest:
        raise problem(
            "conflict",
            format_quantity(highest, "Hz"),
            f"more than the lowest frequency, {format_quantity(lowest, 'Hz')}",
            f"the two ends of the {what} are exchanged or equal",
            "exchange them",
            at="highest",
        )
