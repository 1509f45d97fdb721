"""Numbers of the study file with unit, bounds and usual range, declared once.

``Annotated[float, Quantity("m", at_least=1e-9, typical=(5e-4, 0.05))]`` makes a field that reads ``"7 mm"``,
and in Python also 0.007, as 0.007. The check, the warning, the help and labels all read this declaration.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated, Any

from pydantic import AfterValidator, Field, GetCoreSchemaHandler
from pydantic_core import PydanticCustomError, core_schema

from haptonic.errors import HaptonicError, shown
from haptonic.fields.expressions import ExpressedNumber, FollowingError, ScopedText, scope_of
from haptonic.names import hidden_in, listed
from haptonic.units import example_of, example_value, format_quantity, to_si

FROM_FILE = {"from a file": True}  # validation context for files: a number with a dimension needs its unit


FOLLOWING = "haptonic_following"  # pydantic's name for a `FollowingError`

FASTEST = 1e11  # Hz; waves of higher frequency are too short for a continuum
SMALLEST, LARGEST = 1e-9, 1e3  # m; smaller parts are no continuum, larger ones no plate for a hand


@dataclass(frozen=True)
class Quantity:
    """Declaration of a parameter, apart from its name.

    unit : SI unit; empty for a dimensionless number
    above, at_least, at_most, below : hard bounds, in ``unit``; a value outside is refused
    typical : (lowest, highest) of ordinary designs, in ``unit``; a value outside gives a warning
    hint : next step for a value above the bounds, if it needs more than the bounds
    exception : words on ordinary values outside the typical range
    """

    unit: str
    above: float = -math.inf
    at_least: float = -math.inf
    at_most: float = math.inf
    below: float = math.inf
    typical: tuple[float, float] | None = None
    hint: str = ""
    exception: str = ""

    def __get_pydantic_core_schema__(
        self, source: type[Any], handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.with_info_plain_validator_function(self._read)

    def _read(self, value: object, info: core_schema.ValidationInfo[dict[str, bool] | None]) -> float:
        return self._bounded(number_of(value, self.unit, info.context, self.allowed), value)

    def _bounded(self, number: float, given: object) -> float:
        if self.holds(number):
            if isinstance(number, ExpressedNumber):
                return number
            return number + 0.0  # a negative zero becomes the ordinary one, which is written in the same way
        size = self.unit == "m"
        if math.isnan(number):
            cause = "it is not a finite number"
        elif size and number == 0:
            cause = "a size of zero: the part would not exist"
        elif size and number < 0:
            cause = "a size cannot be negative"
        else:
            cause = "the value is outside the range that this model describes"
        text = shown(given) if isinstance(given, str) else format_quantity(number, self.unit)
        hint = self.hint if number >= min(self.below, self.at_most) else ""
        next_step = hint or f"choose a value that is {self.limits}"
        raise problem("out-of-range", text, self.allowed, cause, next_step)

    def holds(self, number: float) -> bool:
        """True if a value (in ``unit``) lies within the hard bounds."""
        return self.above < number < self.below and self.at_least <= number <= self.at_most

    def _suits(self, number: float) -> bool:
        """True for an allowed value within the typical range."""
        low, high = self.typical or (-math.inf, math.inf)
        return self.holds(number) and low <= number <= high

    @property
    def limits(self) -> str:
        """The hard bounds as text."""
        bounds = {
            "above": self.above,
            "at least": self.at_least,
            "below": self.below,
            "at most": self.at_most,
        }
        words = [
            f"{word} {format_quantity(limit, self.unit)}"
            for word, limit in bounds.items()
            if math.isfinite(limit)
        ]
        return listed(words) or "finite"

    @property
    def example(self) -> str:
        """An allowed and typical value as in a study file: that of the unit, or one amid the range."""
        if self.unit and self._suits(example_value(self.unit)):
            return f'"{example_of(self.unit)}"'
        low, high = self.typical or (max(self.above, self.at_least), min(self.below, self.at_most))
        amid = math.sqrt(low * high) if low > 0 else 0.5 * high if low == 0 else 0.0
        text = format_quantity(float(f"{amid:.1g}"), self.unit)
        return f'"{text}"' if self.unit else text

    @cached_property  # asked for whenever a value is read, so that an error has it
    def allowed(self) -> str:
        """Allowed values in a file, as text."""
        kind = f"a number with its unit, such as {self.example}," if self.unit else "a number"
        return f"{kind} {self.limits}"

    @property
    def usual(self) -> str:
        """The typical range as text; empty if none is declared."""
        if self.typical is None:
            return ""
        lowest, highest = (format_quantity(end, self.unit) for end in self.typical)
        return f"{lowest} to {highest}"

    def unusual(self, value: float, beside: str = "") -> str:
        """Remark on a value (in ``unit``) outside the typical range; empty for an ordinary value.

        ``beside`` is the quantity that the range depends on, such as "for a pitch of 7 mm".
        """
        if self.typical is None or self.typical[0] <= value <= self.typical[1]:
            return ""
        where = f" {beside}" if beside else ""
        words = f"{format_quantity(value, self.unit)} is unusual{where}: {self.usual} is typical"
        if self.exception:
            return f"{words}, {self.exception}"
        near = self.typical[0] / 10 <= value <= self.typical[1] * 10  # too close for a wrong unit
        for power in () if near or not self.unit else (3, -3, 6, -6, 9, -9):
            slipped = value * 10.0**power
            if self.typical[0] <= slipped <= self.typical[1]:
                return f"{words}. Did you mean {format_quantity(slipped, self.unit)}?"
        return words


def size(lowest: float, highest: float) -> Quantity:
    """Declaration of a length that is not zero, with its typical range, m."""
    return Quantity("m", at_least=SMALLEST, at_most=LARGEST, typical=(lowest, highest))


def problem(
    code: str, given: str, allowed: str, cause: str, next_step: str, at: str = ""
) -> PydanticCustomError:
    """Error for pydantic to collect; `haptonic.fields.problems` converts it to five parts.

    ``code`` is a code of `haptonic.errors`; ``at`` is the path of the parameter below the value that pydantic
    blames: ``pillar.diameter`` for a check of a cell.
    """
    parts = {"code": code, "given": given, "allowed": allowed, "cause": cause, "next_step": next_step}
    return PydanticCustomError("haptonic", "{cause}", {**parts, "at": at})


def handed_on(error: HaptonicError, at: str | None = None) -> PydanticCustomError:
    """The error in a form that pydantic collects, at its own parameter or at another one."""
    at = error.argument if at is None else at
    return problem(error.code, error.given, error.allowed, error.cause, error.next_step, at)


def number_of(value: object, unit: str, context: object, allowed: str = "") -> float:
    """SI value of a quantity: a text with its unit, or, except in files, a plain number in SI units.

    The text may be an expression, which the number then keeps.
    """
    if isinstance(value, ExpressedNumber):
        with collected():
            return value.checked(unit)
    if isinstance(value, str) and scope_of(value).is_expression(value):
        with collected():
            return scope_of(value).expressed(value).checked(unit)
    if context != FROM_FILE and isinstance(value, int | float) and not isinstance(value, bool):
        return float(value)
    with collected(allowed):
        return to_si(value, unit, "")


def number_of_any_unit(value: object) -> ExpressedNumber:
    """SI value of a text with any unit, of an expression or of a plain number, with its dimension."""
    if isinstance(value, ExpressedNumber):
        return value
    with collected():
        if isinstance(value, ScopedText) and value.problem is not None:
            raise value.problem
        return scope_of(value).expressed(value)


@dataclass(frozen=True)
class AnyUnit:
    """Mark of a number whose text determines its unit."""

    def __get_pydantic_core_schema__(
        self, source: type[Any], handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.no_info_plain_validator_function(number_of_any_unit)


@contextmanager
def collected(allowed: str = "", within: str = "") -> Iterator[None]:
    """Convert an error with five parts for pydantic, which collects it and adds the path.

    ``within`` is the path of the checked field, if the error names a parameter below it.
    """
    try:
        yield
    except FollowingError as error:
        raise PydanticCustomError(FOLLOWING, "{cause}", {**error.parts(), "at": ""}) from None
    except HaptonicError as error:
        at = error.argument.removeprefix(f"{within}.") if within else ""
        raise handed_on(error.changed(HaptonicError, allowed=allowed or error.allowed), at) from None


def _printable(name: str) -> str:
    """Check that a name is not blank and has no invisible characters."""
    if (character := hidden_in(name)) is not None:
        raise problem(
            "malformed",
            shown(name),
            "letters, digits, signs and spaces of any script",
            f"it contains the control character {character!a}",
            "remove it: names appear in tables, pictures and files",
        )
    if not name.strip():
        raise problem(
            "missing",
            shown(name),
            "a text in quotes that is not blank",
            "it was left blank",
            "write a name in the quotes",
        )
    return name


Length = Annotated[float, Quantity("m", at_least=SMALLEST, at_most=LARGEST)]
FREQUENCY = Quantity("Hz", at_least=1.0, at_most=FASTEST, typical=(1e3, FASTEST))
Frequency = Annotated[float, FREQUENCY]
CARRIER = Quantity("Hz", at_least=1.0, at_most=FASTEST, typical=(10e3, FASTEST))
Name = Annotated[str, Field(max_length=40, strict=True), AfterValidator(_printable)]
"""Name of a part, a region or a person, chosen by the user."""
