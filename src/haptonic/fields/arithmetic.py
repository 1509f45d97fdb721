"""Exact arithmetic with dimensions and slopes: the numbers that expressions are computed with.

Values are fractions, so that ``a - 1 mm`` for 14.7 mm is the same float as ``13.7 mm``: only roots and
functions of angles are rounded on the way. Every number has its derivatives with respect to the parameters
(forward differentiation), by the rules of sums, products, powers and functions.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from haptonic.fields.dimension import PLAIN, Dimension, combined, kind_text, raised

MOST_BITS = 1200  # of a numerator or denominator; beyond, a fraction is rounded to a float
LARGEST_POWER = 64

Slopes = Mapping[str, Fraction]
Rule = tuple[Callable[[float], float], Callable[[float], float]]

FUNCTIONS: dict[str, Rule] = {
    "sqrt": (math.sqrt, lambda x: 0.5 / math.sqrt(x)),
    "sin": (math.sin, math.cos),
    "cos": (math.cos, lambda x: -math.sin(x)),
    "tan": (math.tan, lambda x: 1 + math.tan(x) ** 2),
}
"""Functions of one number, each with its derivative."""


class CalculationError(Exception):
    """A step without a result; code of the error, cause and next step."""

    def __init__(self, code: str, cause: str, next_step: str) -> None:
        self.code, self.cause, self.next_step = code, cause, next_step
        super().__init__(cause)


@dataclass(frozen=True)
class ExactNumber:
    """A number in SI base units, with its dimension and its derivatives.

    slopes : by name of a parameter; zeros are left out
    """

    value: Fraction
    dimension: Dimension = PLAIN
    slopes: Slopes = field(default_factory=dict)

    def plus(self, other: ExactNumber, sign: int = 1) -> ExactNumber:
        """The sum, or with a ``sign`` of -1 the difference."""
        if self.dimension != other.dimension:
            first, second = kind_text(self.dimension), kind_text(other.dimension)
            raise CalculationError(
                "mismatch",
                f"{first} and {second} cannot be added or subtracted",
                "give both terms the same kind of unit",
            )
        slopes = _sum((self.slopes, Fraction(1)), (other.slopes, Fraction(sign)))
        return ExactNumber(_bounded(self.value + sign * other.value), self.dimension, slopes)

    def times(self, other: ExactNumber) -> ExactNumber:
        """The product."""
        slopes = _sum((self.slopes, other.value), (other.slopes, self.value))
        of = combined(self.dimension, other.dimension)
        return ExactNumber(_bounded(self.value * other.value), of, slopes)

    def over(self, other: ExactNumber) -> ExactNumber:
        """The quotient."""
        if other.value == 0:
            raise CalculationError("out-of-range", "it is divided by zero", "give the divisor another value")
        value = _bounded(self.value / other.value)
        slopes = _sum((self.slopes, 1 / other.value), (other.slopes, -value / other.value))
        return ExactNumber(value, combined(self.dimension, other.dimension, -1), slopes)

    def power(self, other: ExactNumber) -> ExactNumber:
        """The number to a power: a whole number of a small size, or for positive numbers any plain number."""
        exponent = other.value
        if other.dimension != PLAIN:
            cause = f"the power is {kind_text(other.dimension)}"
            raise CalculationError("mismatch", cause, "write a plain number as the power")
        if abs(exponent) > LARGEST_POWER:
            cause = f"the power {float(exponent):g} is larger than {LARGEST_POWER}"
            raise CalculationError("too-large", cause, f"write a power of at most {LARGEST_POWER}")
        if self.dimension != PLAIN and (other.slopes or exponent.denominator > 12):
            cause = f"{kind_text(self.dimension)} has a power that is no simple number"
            raise CalculationError("mismatch", cause, "divide by a number with the same unit first")
        if self.value == 0 and exponent < 0:
            raise CalculationError("out-of-range", "it is divided by zero", "give the divisor another value")
        if exponent.denominator == 1 and not other.slopes:
            value = _bounded(self.value ** int(exponent))
            lower = int(exponent) - 1
            steep = exponent * self.value**lower if self.value or lower >= 0 else Fraction(0)
            slopes = _sum((self.slopes, _bounded(steep)))
            return ExactNumber(value, raised(self.dimension, exponent), slopes)
        if self.value <= 0:
            cause = "a number that is not positive has a fractional power"
            raise CalculationError("out-of-range", cause, "write a whole number as the power")
        value = _rounded(lambda: float(self.value) ** float(exponent))
        slopes = _sum(
            (self.slopes, value * exponent / self.value),
            (other.slopes, value * _rounded(lambda: math.log(self.value))),
        )
        return ExactNumber(value, raised(self.dimension, exponent), slopes)

    def of_function(self, name: str) -> ExactNumber:
        """The square root, or the sine, cosine or tangent of an angle."""
        function, slope = FUNCTIONS[name]
        if name == "sqrt":
            if self.value < 0:
                cause = "the square root of a negative number"
                raise CalculationError("out-of-range", cause, "change the sign, or the number")
            of = raised(self.dimension, Fraction(1, 2))
        elif self.dimension in (PLAIN, (("rad", Fraction(1)),)):
            of = PLAIN
        else:
            cause = f"{name} of {kind_text(self.dimension)}"
            raise CalculationError("mismatch", cause, "write an angle, such as 30 deg, or a plain number")
        value = _rounded(lambda: function(float(self.value)))
        if not self.slopes:
            return ExactNumber(value, of)
        if name == "sqrt" and self.value == 0:
            cause = "the square root of zero has no slope"
            raise CalculationError("out-of-range", cause, "give the parameter another value")
        return ExactNumber(value, of, _sum((self.slopes, _rounded(lambda: slope(float(self.value))))))

    def negative(self) -> ExactNumber:
        """The number with the other sign."""
        return ExactNumber(-self.value, self.dimension, _sum((self.slopes, Fraction(-1))))

    def named(self, name: str) -> ExactNumber:
        """The value of the parameter of this name."""
        return ExactNumber(self.value, self.dimension, {**self.slopes, name: Fraction(1)})

    def rounded(self) -> float:
        """The nearest float; neither infinite nor zero for another number."""
        try:
            value = float(self.value)
        except OverflowError:
            raise _too_large() from None
        if value == 0 and self.value != 0:
            raise _too_small()
        return value + 0.0


def _too_large() -> CalculationError:
    cause = "a result is too large for a number in SI units"
    return CalculationError("out-of-range", cause, "write a smaller number")


def _too_small() -> CalculationError:
    cause = "a result is too small for a number in SI units"
    return CalculationError("out-of-range", cause, "write a larger number")


def _bounded(value: Fraction) -> Fraction:
    """The fraction itself, or the nearest float of a fraction with very many digits."""
    if max(value.numerator.bit_length(), value.denominator.bit_length()) <= MOST_BITS:
        return value
    rounded = _rounded(lambda: float(value))
    if not rounded:
        raise _too_small()
    return rounded


def _rounded(compute: Callable[[], float]) -> Fraction:
    try:
        return Fraction(compute())
    except (OverflowError, ValueError):  # also for infinity and for a value that is not a number
        raise _too_large() from None


def _sum(*terms: tuple[Slopes, Fraction]) -> Slopes:
    """Sum of slopes, each with a factor."""
    total: dict[str, Fraction] = {}
    for slopes, factor in terms:
        for name, slope in slopes.items():
            total[name] = _bounded(total.get(name, Fraction(0)) + factor * slope)
    return {name: slope for name, slope in total.items() if slope}
