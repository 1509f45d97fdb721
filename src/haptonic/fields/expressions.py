"""Numbers of a study that are written as expressions, and the named parameters that they use.

A number with an expression is a float for everything that computes with it. It keeps its text, so that a
written study contains the expression again, and so that another value of a parameter changes it.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from graphlib import CycleError, TopologicalSorter
from typing import Any

from haptonic.errors import HaptonicError, StudyError, shown
from haptonic.fields.arithmetic import FUNCTIONS, CalculationError, ExactNumber
from haptonic.fields.dimension import Dimension, dimension_of, kind_text, symbols, unit_of
from haptonic.fields.grammar import ALLOWED, CONSTANTS, evaluate, names_in, refused
from haptonic.units import TYPOGRAPHIC, as_quantity, example_of, format_quantity

PARAMETERS = "parameters"  # name of the table of a study
NAMED = f"{PARAMETERS}."  # beginning of the path of a named parameter, ``parameters.a``
MOST_PARAMETERS = 100
LONGEST_NAME = 40
FREE = {"h"}  # a unit of time that studies hardly use, and everybody's letter for a height
RESERVED = {"deg", "g", "mg", "L", "l"}  # units that a reader takes for a unit after * or /

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_ALPHABET = re.compile(r"[A-Za-z0-9_µ.\s+\-*/^()]*[A-Za-z0-9(][A-Za-z0-9_µ.\s+\-*/^()]*")


class ExpressedNumber(float):
    """A number in SI units with the text that gives it, and its dimension.

    It equals the plain number, also in keys of the store. Arithmetic with it gives plain numbers.

    text : expression or quantity as in a file; empty for a plain number
    """

    __slots__ = ("dimension", "text")
    text: str
    dimension: Dimension

    def __new__(cls, value: float, text: str = "", dimension: Dimension = ()) -> ExpressedNumber:
        number = super().__new__(cls, value)
        number.text, number.dimension = text, dimension
        return number

    def __reduce__(self) -> tuple[object, ...]:
        return type(self), (float(self), self.text, self.dimension)

    @property
    def unit(self) -> str:
        """SI unit; empty for a plain number."""
        return unit_of(self.dimension)

    @property
    def expression(self) -> str:
        """The text if it is more than a number with its unit; else an empty text."""
        return self.text if as_quantity(self.text) is None else ""

    def changed(self, value: float) -> ExpressedNumber:
        """Another value of the same dimension, without an expression."""
        text = format_quantity(value, self.unit, digits=None) if self.unit else ""
        return ExpressedNumber(value, text, self.dimension)

    def checked(self, unit: str) -> ExpressedNumber:
        """The number itself, if it has the dimension of a unit.

        Raises
        ------
        StudyError : another dimension
        """
        wanted = dimension_of(unit)
        if self.dimension == wanted or (not self and not self.dimension):  # zero needs no unit
            return self
        raise StudyError.mismatch(
            argument="", given=shown(self.text or float(self)),
            allowed=f'{kind_text(wanted)}, such as "{example_of(unit)}"' if unit else "a plain number",
            cause=f"it gives {kind_text(self.dimension)}",
            next_step=f"write {kind_text(wanted)}, or correct the units in it",
        )  # fmt: skip


class FollowingError(StudyError):
    """An expression without a value because of an error in a parameter, which is reported itself."""


class Scope:
    """The parameters of a study, in which expressions have values.

    texts : by name, expressions, quantities or plain numbers as given
    numbers : by name, values with dimensions and slopes; problems : reasons of those without a value
    """

    def __init__(self, texts: Mapping[str, Any]) -> None:
        self.texts = {name: text for name, text in texts.items() if not reason_against(name)}
        self.numbers: dict[str, ExactNumber] = {}
        self.problems: dict[str, HaptonicError] = {}
        for name in self._order():
            try:
                value = self.value(self.texts[name])
            except HaptonicError as error:
                if error.code == "unknown":
                    step = f"{error.next_step}; if {name} is no parameter, move its line above [parameters]"
                    error = error.changed(type(error), next_step=step)
                self.problems[name] = error
            else:
                self.numbers[name] = value.named(name)
        self.numbers = {name: self.numbers[name] for name in self.texts if name in self.numbers}

    def _order(self) -> Iterator[str]:
        """Names, each after those that it uses; cycles become problems."""
        left = {
            name: names_in(text) & self.texts.keys() if isinstance(text, str) else set()
            for name, text in self.texts.items()
        }
        while True:
            try:
                order = list(TopologicalSorter(left).static_order())
            except CycleError as error:
                cycle = error.args[1]
                for name in cycle[1:]:
                    self.problems[name] = self._circular(name, cycle)
                left = {name: used - set(cycle) for name, used in left.items() if name not in cycle}
            else:
                yield from (name for name in order if name in left)
                return

    def _circular(self, name: str, cycle: list[str]) -> StudyError:
        return StudyError.conflict(
            argument="",
            given=shown(self.texts[name]),
            allowed="an expression that does not lead back to the parameter itself",
            cause=f"these parameters use each other: {' -> '.join(cycle[:6])}",
            next_step="give one of them a number with its unit",
        )

    def value(self, given: object) -> ExactNumber:
        """Value of an expression or a plain number, with dimension and slopes, not yet rounded.

        Raises
        ------
        StudyError : see `haptonic.fields.grammar.evaluate`; a parameter in it without a value; another type
        """
        if isinstance(given, ExpressedNumber):
            if not given.text:
                return ExactNumber(Fraction(repr(float(given))), given.dimension)
            given = given.text
        if isinstance(given, str):
            return self._of_text(given)
        if isinstance(given, float) and math.isfinite(given):
            return ExactNumber(Fraction(repr(float(given))))  # as it is written, 0.1 for a tenth
        if isinstance(given, int) and not isinstance(given, bool):
            return ExactNumber(Fraction(given))
        raise StudyError.malformed(
            argument="", given=shown(given), allowed=ALLOWED,
            cause="it is neither a finite number nor a text", next_step='write a text such as "7 mm"',
        )  # fmt: skip

    def _of_text(self, text: str) -> ExactNumber:
        for name in sorted(names_in(text) & self.problems.keys()):
            raise FollowingError.conflict(
                argument="", given=shown(text), allowed="parameters that have a value",
                cause=f"the parameter {name} has no value", next_step=f"correct parameters.{name} first",
            )  # fmt: skip
        return evaluate(text, self.numbers, self.texts)

    def expressed(self, given: object) -> ExpressedNumber:
        """Value of an expression or a plain number, with its text; for errors see `value`."""
        number, text = self.value(given), str(given) if isinstance(given, str) else ""
        text = given.text if isinstance(given, ExpressedNumber) else text
        try:
            return ExpressedNumber(number.rounded(), text, number.dimension)
        except CalculationError as error:
            raise refused(given, error) from None

    def contains(self, number: object) -> bool:
        """True for a number whose text still gives its value here."""
        if not isinstance(number, ExpressedNumber) or not number.text:
            return False
        try:
            here = self.expressed(number.text)
        except HaptonicError:
            return False
        return here == number and here.dimension == number.dimension

    def is_expression(self, text: str) -> bool:
        """True for a text that has to be computed; False for a number with a unit, and for other texts."""
        unit = as_quantity(text)
        if unit is not None:
            return bool(names_in(unit) & self.texts.keys())
        return _ALPHABET.fullmatch(text.translate(TYPOGRAPHIC)) is not None

    def changed(self, values: Mapping[str, object]) -> Scope:
        """A scope with other values of some parameters: texts, or numbers in SI units."""
        changes = dict(values)
        for name, value in values.items():
            own = self.texts[name]
            if isinstance(value, bool | ExpressedNumber) or not isinstance(value, int | float):
                continue
            if isinstance(own, ExpressedNumber) and math.isfinite(value):
                changes[name] = own.changed(value)
        return Scope({**self.texts, **changes})

    def uses(self, text: str) -> set[str]:
        """Names of the parameters on which an expression depends, through other parameters too."""
        used_names, left = set[str](), names_in(text) & self.texts.keys()
        while left:
            used_names |= left
            texts = (self.texts[name] for name in left)
            inner = (t.text if isinstance(t, ExpressedNumber) else t for t in texts)
            used = {name for each in inner if isinstance(each, str) for name in names_in(each)}
            left = (used & self.texts.keys()) - used_names
        return used_names


class ScopedText(str):
    """A text of a study with the parameters of that study.

    problem : for the text of a parameter, the reason why it has no value
    """

    scope: Scope
    problem: HaptonicError | None

    @classmethod
    def of(cls, text: str, scope: Scope, name: str = "") -> ScopedText:
        """The text in a scope; ``name`` of a parameter whose text it is."""
        scoped = cls(text)
        scoped.scope, scoped.problem = scope, scope.problems.get(name)
        return scoped

    def __reduce__(self) -> tuple[object, ...]:
        return str, (str(self),)


NO_PARAMETERS = Scope({})


def scope_of(text: object) -> Scope:
    """Parameters of the study that contains a text; without any for a value from elsewhere."""
    return text.scope if isinstance(text, ScopedText) else NO_PARAMETERS


def scoped(given: Mapping[str, Any]) -> dict[str, Any]:
    """Tables of a study whose texts know the study's parameters; values that are made are not changed."""
    parameters = given.get(PARAMETERS)
    if not isinstance(parameters, Mapping) or not parameters:
        return dict(given)
    named = [(name, text) for name, text in parameters.items() if isinstance(name, str)]
    scope = Scope(dict(named[:MOST_PARAMETERS]))

    def inside(value: Any) -> Any:
        if isinstance(value, str):
            return ScopedText.of(value, scope)
        if isinstance(value, dict):
            return {name: inside(item) for name, item in value.items()}
        if type(value) in (list, tuple):
            return [inside(item) for item in value]
        return value

    changed = {name: inside(value) for name, value in given.items() if name != PARAMETERS}
    texts = {
        name: ScopedText.of(value, scope, name) if isinstance(value, str) else value
        for name, value in parameters.items()
    }
    return {**given, **changed, PARAMETERS: texts}


def check_names(names: Iterable[str]) -> None:
    """Refuse names of parameters that are too many, that are no names, or that read like a unit or function.

    Raises
    ------
    StudyError : the first of these problems; its argument is the name
    """
    for number, name in enumerate(names, start=1):
        if number > MOST_PARAMETERS:
            raise StudyError.too_large(
                argument="", given=f"more than {MOST_PARAMETERS} parameters", allowed="fewer",
                cause="a study needs only a few parameters", next_step="leave out those that are not used",
            )  # fmt: skip
        if cause := reason_against(name):
            raise StudyError.malformed(
                argument=name if _NAME.fullmatch(name) else shown(name),
                given=f"the name {shown(name)}",
                allowed=f"names of at most {LONGEST_NAME} letters, digits and _, such as a, d2 or wall",
                cause=cause,
                next_step="choose another name, such as a, width or d_1",
            )


def reason_against(name: str) -> str:
    """Reason why a parameter cannot have a name; empty for a good name."""
    if not _NAME.fullmatch(name) or len(name) > LONGEST_NAME:
        return "it is not made of letters, digits and _ alone, with a letter first"
    if name in FUNCTIONS or name in CONSTANTS:
        return "it is the name of a function or a constant of expressions"
    if (name in symbols() and name not in FREE) or name in RESERVED:
        return f"it is a unit: 2 m/{name} could be read in two ways"
    return ""
