"""Expressions that a sweep varies: products and quotients of parameter names and positive numbers.

The grammar is ``factor (("*" | "/") factor)*`` with ``factor = name | number``, evaluated from left to right:
``a / b / c`` is ``a / (b c)``. Nothing is evaluated as code.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache

from haptonic.errors import StudyError, shown
from haptonic.fields import unknown_number
from haptonic.units import registry

LONGEST_TEXT = 200
GRAMMAR = "names of parameters and positive numbers with * and / between them"
EXAMPLE = "cell.pillar.diameter / cell.pitch"

_TOKEN = re.compile(
    r"(?P<name>[A-Za-z_][A-Za-z0-9_]*(?:\[[0-9]+\])?(?:\.[A-Za-z_][A-Za-z0-9_]*(?:\[[0-9]+\])?)*)"
    r"|(?P<number>(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)"
    r"|(?P<operator>[*/])"
)
_UNIT_POWER = re.compile(r"([A-Za-z]+)(?:\^([0-9]))?")
_INSTEAD = {
    "(": "write a / b / c for a / (b * c)",
    ")": "write a / b / c for a / (b * c)",
    "^": "write a * a for a power",
    "+": "sums are not possible; vary one size and keep the others",
    "-": "differences are not possible; vary one size and keep the others",
}


@dataclass(frozen=True)
class Expression:
    """Product of parameters, each to some power, and a constant.

    text : as written
    varied : the first name; this parameter changes, the others keep their values
    powers : integer exponent of every name that does not cancel
    constant : positive and finite
    """

    text: str
    varied: str
    powers: tuple[tuple[str, int], ...]
    constant: float

    def value(self, parameters: Mapping[str, float]) -> float:
        """Value for parameters in SI units.

        Raises
        ------
        StudyError : a division by a parameter that is zero
        """
        zeros = [name for name, power in self.powers if power < 0 and parameters[name] == 0]
        if zeros:
            raise StudyError.out_of_range(
                argument="sweep.vary",
                given=shown(self.text),
                allowed="an expression that is not divided by zero",
                cause=f"{zeros[0]} is zero in this study",
                next_step=f"give {zeros[0]} another value, or leave it out of the expression",
            )
        return self.constant * math.prod(parameters[name] ** power for name, power in self.powers)

    def unit(self, units: Mapping[str, str]) -> str:
        """SI unit of the value, from those of the parameters; empty for a dimensionless value."""
        total: dict[str, int] = {}
        for name, power in self.powers:
            for symbol, each in _UNIT_POWER.findall(units[name]):
                sign = -1 if f"/{symbol}" in units[name] else 1
                total[symbol] = total.get(symbol, 0) + sign * power * int(each or 1)
        left = {symbol: power for symbol, power in total.items() if power}
        return _reduced(
            "*".join(symbol if power == 1 else f"{symbol}^{power}" for symbol, power in left.items())
        )


def parse(text: str) -> Expression:
    """Read an expression.

    Raises
    ------
    StudyError : text outside the grammar, no parameter, or a first parameter that occurs twice
    """
    if not text.strip():
        raise _refused("missing", text, "the text is empty")
    if len(text) > LONGEST_TEXT:
        raise _refused("too-large", text, "the text is too long")
    names: list[tuple[str, int]] = []
    constant, power, factor_next = 1.0, 1, True
    for kind, token in _tokens(text):
        if factor_next == (kind == "operator"):
            belongs = "a name or number" if factor_next else "* or /"
            raise _refused("malformed", text, f'"{token}" is in the place of {belongs}')
        if kind == "name":
            names.append((token, power))
        elif kind == "number":
            constant *= _positive(text, token) ** power
        else:
            power = 1 if token == "*" else -1
        factor_next = kind == "operator"
    if factor_next:
        raise _refused("malformed", text, "a name or number is missing at the end")
    if not names:
        raise _refused("missing", text, "no parameter is named, so nothing would vary")
    if not (math.isfinite(constant) and constant > 0):
        cause = "its numbers multiply to something outside the range of numbers"
        raise _refused("out-of-range", text, cause)
    varied = names[0][0]
    if [name for name, _ in names].count(varied) > 1:
        cause = f'"{varied}" is the parameter that varies and occurs more than once'
        raise _refused("repeated", text, cause)
    powers: dict[str, int] = {}
    for name, each in names:
        powers[name] = powers.get(name, 0) + each
    return Expression(text, varied, tuple((name, each) for name, each in powers.items() if each), constant)


def check_names(expression: Expression, known: Mapping[str, object], absent: Mapping[str, str]) -> None:
    """Refuse a name that is not a numeric parameter of a study.

    Parameters
    ----------
    known : names of the parameters that can be used
    absent : parameters that exist but have no value in this study, with the reason
    """
    for name, _ in expression.powers:
        if name not in known:
            raise unknown_number(name, known, absent, "sweep.vary")


def solve(
    expression: Expression, value: float, parameters: Mapping[str, float], absent: Mapping[str, str]
) -> float:
    """Value of the first parameter (SI) for which the expression has a given value (SI).

    Parameters
    ----------
    parameters, absent : by path, parameters with a value in a study, and reasons for those without

    Raises
    ------
    StudyError : an unknown name, or a value that no number of this parameter gives
    """
    check_names(expression, parameters, absent)
    powers = dict(expression.powers)
    direction = powers.pop(expression.varied)
    try:
        rest = expression.constant * math.prod(parameters[name] ** power for name, power in powers.items())
        wanted = (value / rest) ** direction
    except (ZeroDivisionError, OverflowError):
        wanted = math.nan
    if not math.isfinite(wanted):
        raise StudyError.out_of_range(
            argument="sweep.vary",
            given=shown(expression.text),
            allowed="an expression whose value some parameter can reach",
            cause=f"no finite {expression.varied} gives it the value {value:g}",
            next_step="leave out parameters that are zero, or choose another range",
        )
    return wanted


def _tokens(text: str) -> Iterator[tuple[str, str]]:
    position = 0
    while position < len(text):
        if text[position].isspace():
            position += 1
            continue
        match = _TOKEN.match(text, position)
        if match is None:
            character = text[position]
            cause = f"{character!a} at position {position + 1} is not part of the grammar"
            raise _refused("malformed", text, cause, _INSTEAD.get(character, ""))
        assert match.lastgroup is not None
        yield match.lastgroup, match.group()
        position = match.end()


def _positive(text: str, token: str) -> float:
    number = float(token)
    if not (math.isfinite(number) and number > 0):
        raise _refused("out-of-range", text, f"{token} is not a positive finite number")
    return number


@cache
def _reduced(unit: str) -> str:
    """Empty for units that cancel, such as ``Pa*m*kg^-1*Hz^-2``; otherwise the unit itself."""
    simple = not unit or re.fullmatch(r"[A-Za-z]+(\^[0-9])?", unit)
    return "" if not simple and registry().Unit(unit).dimensionless else unit


def _refused(code: str, text: str, cause: str, instead: str = "") -> StudyError:
    return StudyError(
        code,
        argument="sweep.vary",
        given=shown(text),
        allowed=GRAMMAR,
        cause=cause,
        next_step=f'{instead}, such as "{EXAMPLE}"' if instead else f'write it like "{EXAMPLE}"',
    )
