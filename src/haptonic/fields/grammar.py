"""The grammar of numbers that are written as expressions: ``a - 1 mm``, ``sqrt(2)*a/2``.

::

    sum     = product (("+" | "-") product)*
    product = signed (("*" | "/") signed)*
    signed  = ("+" | "-")* power
    power   = atom (("**" | "^") signed)?
    atom    = number unit? | parameter | "pi" | function "(" sum ")" | "(" sum ")"

A unit follows its number directly, ``5 N/m``. A name in any other place is a parameter, and so is a name of
[parameters] after ``*`` or ``/``: ``1 mm*a``. Text is read by these rules
alone and never run as code; its length, its depth and the size of powers are limited.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from haptonic.errors import StudyError, nearest, shown
from haptonic.fields.arithmetic import FUNCTIONS, CalculationError, ExactNumber
from haptonic.fields.dimension import UnknownUnitError, measured, symbols
from haptonic.units import LARGEST_EXPONENT, TYPOGRAPHIC

LONGEST_TEXT = 200
DEEPEST = 20  # parentheses, functions and powers inside each other
CONSTANTS = {"pi": ExactNumber(Fraction(math.pi))}
ALLOWED = "numbers with units and names of [parameters], with + - * / ** ( ), sqrt, sin, cos, tan and pi"

_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE](?P<exponent>[+-]?[0-9]+))?)"
    r"|(?P<name>[A-Za-z_µ][A-Za-z0-9_µ]*)"
    r"|(?P<operator>\*\*|[-+*/^()]))"
)
_POWERS = ("**", "^")


@dataclass(frozen=True)
class Token:
    """A part of a text: kind "number", "name", "operator" or "end"."""

    kind: str
    text: str


END = Token("end", "")


def names_in(text: str) -> set[str]:
    """Names that a text contains, units and functions among them."""
    return {match["name"] for match in _TOKEN.finditer(text.translate(TYPOGRAPHIC)) if match["name"]}


def evaluate(text: str, parameters: Mapping[str, ExactNumber], known: Iterable[str] = ()) -> ExactNumber:
    """Value of an expression, with dimension and slopes.

    Parameters
    ----------
    known : names of all parameters of the study, for messages

    Raises
    ------
    StudyError : text outside the grammar, an unknown name or unit, terms of different dimensions, or a step
        without a finite result
    """
    try:
        return _Evaluation(text, parameters, known).value()
    except CalculationError as error:
        raise refused(text, error) from None


def refused(given: object, error: CalculationError) -> StudyError:
    """The error for a given text or number whose calculation failed."""
    return StudyError(
        error.code, argument="", given=shown(given), allowed=ALLOWED, cause=error.cause,
        next_step=error.next_step,
    )  # fmt: skip


class _Evaluation:
    """Reads a text from left to right and computes at the same time."""

    def __init__(self, text: str, parameters: Mapping[str, ExactNumber], known: Iterable[str]) -> None:
        self.text, self.parameters, self.known = text, parameters, list(known or parameters)
        if len(text) > LONGEST_TEXT:
            cause = f"the text is {len(text)} characters long; an expression has at most {LONGEST_TEXT}"
            raise CalculationError("too-large", cause, "give parts of it names in [parameters]")
        self.tokens = self._tokens(text.translate(TYPOGRAPHIC))
        self.position = self.depth = 0

    def _tokens(self, text: str) -> list[Token]:
        tokens, position = [], 0
        text = text.rstrip()
        while position < len(text):
            match = _TOKEN.match(text, position)
            if match is None or match.lastgroup is None:
                raise self._stranger(text[position:].lstrip()[0])
            if abs(int(match["exponent"] or 0)) > LARGEST_EXPONENT:
                cause = f"the power of ten of {shown(match['number'])} is outside the range of numbers"
                raise CalculationError("out-of-range", cause, "write a number within the range of floats")
            kind = "number" if match["number"] else match.lastgroup
            tokens.append(Token(kind, match[kind]))
            position = match.end()
        return tokens

    def _stranger(self, character: str) -> CalculationError:
        next_step = "leave it out"
        if character == ".":
            next_step = "give the number a name in [parameters], and write that name in both places"
        return CalculationError("malformed", f"the character {character!a} is not expected here", next_step)

    def value(self) -> ExactNumber:
        value = self._sum()
        if (left := self._next()) is not END:
            raise self._misplaced(left, "an operator such as + or *")
        return value

    def _next(self, ahead: int = 0) -> Token:
        place = self.position + ahead
        return self.tokens[place] if place < len(self.tokens) else END

    def _taken(self, *operators: str) -> str:
        """The next operator if it is one of these, which is then read; else an empty text."""
        token = self._next()
        if token.kind != "operator" or token.text not in operators:
            return ""
        self.position += 1
        return token.text

    def _sum(self) -> ExactNumber:
        total = self._product()
        while operator := self._taken("+", "-"):
            total = total.plus(self._product(), 1 if operator == "+" else -1)
        return total

    def _product(self) -> ExactNumber:
        total = self._signed()
        while operator := self._taken("*", "/"):
            factor = self._signed()
            total = total.times(factor) if operator == "*" else total.over(factor)
        return total

    def _signed(self) -> ExactNumber:
        negative = False
        while sign := self._taken("+", "-"):
            negative ^= sign == "-"
        value = self._power()
        return value.negative() if negative else value

    def _power(self) -> ExactNumber:
        base = self._atom()
        if not self._taken(*_POWERS):
            return base
        self._deeper()
        exponent = self._signed()
        self.depth -= 1
        return base.power(exponent)

    def _atom(self) -> ExactNumber:
        token = self._next()
        self.position += 1
        if token.kind == "number":
            return self._quantity(token.text)
        if token.kind == "name" and token.text not in FUNCTIONS:
            return self._named(token.text)
        if token.kind == "operator" and token.text == "(":
            return self._in_parentheses()
        if token.kind == "name":
            if not self._taken("("):
                cause = f"{token.text} is a function and needs parentheses"
                raise CalculationError("malformed", cause, f"write {token.text}(...)")
            return self._in_parentheses().of_function(token.text)
        raise self._misplaced(token, "a number, a parameter or (")

    def _in_parentheses(self) -> ExactNumber:
        self._deeper()
        value = self._sum()
        if not self._taken(")"):
            raise self._misplaced(self._next(), "an operator or )")
        self.depth -= 1
        return value

    def _deeper(self) -> None:
        self.depth += 1
        if self.depth > DEEPEST:
            cause = f"more than {DEEPEST} parentheses or powers are inside each other"
            raise CalculationError("too-large", cause, "give parts of it names in [parameters]")

    def _named(self, name: str) -> ExactNumber:
        if name in self.parameters:
            return self.parameters[name]
        if name in CONSTANTS:
            return CONSTANTS[name]
        raise self._unknown(name)

    def _unknown(self, name: str) -> CalculationError:
        known = ", ".join(self.known)
        listed = f"the parameters are {known}" if known else "the study has no [parameters]"
        follower = self._next()
        functions = FUNCTIONS if len(name) > 2 and follower.text == "(" else ()
        if guess := nearest(name, [*self.known, *functions]):
            next_step = f'write "{guess}"'
        elif follower.kind == "name" and follower.text in symbols():
            next_step = f"write a number before the unit, such as 6 {follower.text}"
        elif name in symbols():
            next_step = f"write a number before the unit: 1 {name}"
        else:
            next_step = f"add {shown(name)} to [parameters]"
        return CalculationError(
            "unknown", f"{shown(name)} is not the name of a parameter; {listed}", next_step
        )

    def _quantity(self, number: str) -> ExactNumber:
        """A number with the unit that follows it, if any."""
        first = self._next()
        if first.kind != "name":
            return ExactNumber(Fraction(number))
        self._unambiguous(first.text, f"{number}*{first.text}")
        unit = self._unit_word()
        while (word := self._continued(number)) is not None:
            unit += word
        try:
            factor, dimension = measured(unit)
        except UnknownUnitError:
            guess = nearest(first.text, symbols())
            next_step = f"write {guess}, or" if guess else "write a known unit, or"
            cause = f"{shown(unit)} is not a known unit"
            raise CalculationError("unknown", cause, f"{next_step} * before a parameter") from None
        return ExactNumber(Fraction(number) * factor, dimension)

    def _continued(self, number: str) -> str | None:
        """The next word of a unit with its operator, such as "/m^3"; None at its end."""
        operator = self._next()
        by_operator = operator.kind == "operator" and operator.text in ("*", "/")
        word = self._next(1) if by_operator else operator
        if word.kind != "name" or word.text in FUNCTIONS or word.text in CONSTANTS:
            return None
        if word.text in self.parameters and (not by_operator or word.text not in symbols()):
            return None
        if not _is_unit(word.text):
            return None
        if by_operator:
            self._unambiguous(word.text, f"parentheses around the number and its unit, ({number} ...),")
            self.position += 1
        return f"{operator.text if by_operator else ' '}{self._unit_word()}"

    def _unit_word(self) -> str:
        word = self._next().text
        self.position += 1
        if self._next().text not in _POWERS:
            return word
        sign = self._next(1).text == "-"
        power = self._next(1 + sign)
        if power.kind != "number" or not re.fullmatch("[1-9]", power.text):
            cause = f"the power of the unit {word} is not a whole number from 1 to 9"
            raise CalculationError("malformed", cause, "write parentheses around the number and its unit")
        self.position += 2 + sign
        return f"{word}^{'-' if sign else ''}{power.text}"

    def _unambiguous(self, name: str, instead: str) -> None:
        if name in self.parameters:
            cause = f"{name} is a parameter and follows a number in the place of a unit"
            raise CalculationError(
                "conflict", cause, f"write {instead} for the parameter, or rename it if you mean the unit"
            )

    def _misplaced(self, token: Token, belongs: str) -> CalculationError:
        if token is END:
            return CalculationError("malformed", f"at its end, {belongs} is missing", "complete it")
        cause = f"{shown(token.text)} is in the place of {belongs}"
        return CalculationError("malformed", cause, "correct it, such as 0.5*a + 1 mm")


def _is_unit(name: str) -> bool:
    try:
        measured(name)
    except UnknownUnitError:
        return False
    return True
