"""Units: text with a unit is converted to SI floats on input, and back on output.

Text must have the fixed form ``<number> <unit>`` before anything interprets it: study files may come from
other people, so their contents are never evaluated. Numbers are converted as exact fractions and rounded
once; ``"14.7 mm"`` is therefore the same float as ``0.0147``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cache
from typing import TYPE_CHECKING, Annotated, SupportsFloat

from haptonic.errors import HaptonicError, nearest, shown
from haptonic.later import admitted

if TYPE_CHECKING:
    import pint

LONGEST_TEXT = 80
USUAL_DECADES = 2  # between an example and a number with the same unit
MOST_DECIMALS = 6  # of a number with the bound of its error
NARROW = 0.04  # interval of a share that is printed with a decimal
LARGEST_EXPONENT = 400  # beyond the range of floats, while powers of ten of this size are still cheap

PREFIXES = {"p": -12, "n": -9, "µ": -6, "m": -3, "": 0, "k": 3, "M": 6, "G": 9, "T": 12}
PREFIXES_OF = {
    "m": "nµmk", "s": "nµm", "m/s": "nµm", "Hz": "kMGT", "Pa": "kMGT", "N": "µmk", "V": "µmk", "F": "nµ",
    "m/V": "p",
}  # fmt: skip
EXAMPLES = {
    "m": "7 mm",
    "Hz": "60 kHz",
    "Pa": "70 GPa",
    "kg/m^3": "2700 kg/m^3",
    "rad": "2 deg",
    "V": "60 V",
    "N/m^3": "1e12 N/m^3",
    "kg": "0.01 kg",
    "m/s": "78 mm/s",
    "m^2/N": "1.2e-11 m^2/N",
    "m/V": "120 pm/V",
    "C/m^2": "15 C/m^2",
}
TIMES = {"min": Fraction(60), "h": Fraction(3600)}  # s
KINDS = {
    "m": "length",
    "Hz": "frequency",
    "Pa": "pressure or stiffness",
    "kg/m^3": "density",
    "s": "time",
    "m/s": "speed",
    "rad": "angle",
    "N": "force",
    "V": "voltage",
    "kg": "mass",
    "N/m": "stiffness",
    "N/m^3": "stiffness per area",
    "N s/m": "damping",
    "m^2/N": "compliance",
    "m/V": "charge constant",
    "C/m^2": "charge per area",
}
OTHER = "another quantity"

_NUMBER = r"(?P<number>[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE](?P<exponent>[+-]?[0-9]+))?)"
_NAME = r"[A-Za-zµ][A-Za-z0-9_µ]*(?:(?:\^|\*\*)-?[1-9])?"
_QUANTITY = re.compile(rf"\s*{_NUMBER}\s*(?P<unit>{_NAME}(?:(?:\s*[*/]\s*|\s+){_NAME})*)?\s*")
_NOT_FINITE = re.compile(r"\s*[+-]?(nan|inf|infinity)\b", re.IGNORECASE)
_THOUSANDS = re.compile(r",[0-9]{3}(?![0-9])")  # "1,500 mm" may be 1.5 mm or 1.5 m
_MU = "\u03bc"  # the Greek letter; prefixes are written with the micro sign, and users type either
TYPOGRAPHIC = str.maketrans({_MU: "µ", "·": "*", "\u00d7": "*", "²": "^2", "³": "^3", "°": "deg"})


@dataclass(frozen=True)
class In:
    """SI unit of a number, ``Annotated[float, In("Hz")]``; JSON appends it to the name."""

    unit: str


Hertz = Annotated[float, In("Hz")]


@cache
def registry() -> pint.UnitRegistry[Fraction]:
    """The unit registry, made on first use.

    Importing pint and building the registry takes most of a second. Nearly every study uses only units of the
    table above, which need neither.
    """
    units: pint.UnitRegistry[Fraction] = admitted("pint").UnitRegistry(non_int_type=Fraction)
    return units


def to_si(text: object, unit: str, argument: str) -> float:
    """SI value of a quantity with a unit.

    Parameters
    ----------
    text : such as ``"7 mm"``; for a dimensionless quantity (``unit == ""``) also a plain number. Zero needs
        no unit.
    unit : SI unit of the same dimension, such as ``"m"``; empty for a dimensionless quantity
    argument : name used in the error

    Returns
    -------
    The value in ``unit``, correctly rounded and finite.

    Raises
    ------
    HaptonicError : missing or wrong unit, text of another form, NaN, infinite, or outside a float's range
    """
    example = f'"{example_of(unit)}"' if unit else "0.33"
    allowed = f"a number with its unit, such as {example}" if unit else f"a plain number, such as {example}"

    def refused(cause: str, next_step: str = "") -> HaptonicError:
        return HaptonicError.malformed(
            argument=argument,
            given=shown(text),
            allowed=allowed,
            cause=cause,
            next_step=next_step or f"write {allowed}",
        )

    if isinstance(text, bool) or not isinstance(text, str | int | float):
        raise refused("a value of the wrong type")
    if isinstance(text, str) and "%" in text:
        raise refused(
            "a percentage, where the value itself belongs", f"write the absolute value as {allowed}"
        )
    if isinstance(text, str):
        number, unit_text = _split(text, refused)
    elif isinstance(text, float) and not math.isfinite(text):
        raise refused("it is not a finite number")
    else:
        number, unit_text = Fraction(text), ""
    if unit and not unit_text and number != 0:
        complete = f'"{str(text).strip()} {_usual_unit(number, unit)}"'
        raise refused("the unit is missing", f"write the unit as well, with quotes around both: {complete}")
    if unit_text and not unit:
        raise refused("a unit where none belongs", f"leave the unit out: write {allowed}")
    try:
        exact = number * (_factor(unit_text, unit) if unit_text else 1)
        value = float(exact)
    except _UnknownUnitError:
        guess = _nearest_unit(unit_text, unit)
        hint = f'"{guess}" is the nearest known unit' if guess else ""
        raise refused(f'"{unit_text}" is not a known unit', hint) from None
    except _OtherKindError:
        raise refused(f'"{unit_text}" is not a unit of {KINDS.get(unit, unit)}') from None
    except OverflowError:
        raise refused("it is too large for a number in SI units") from None
    if value == 0 and exact != 0:
        raise refused("it is too small for a number in SI units")
    return value


def format_quantity(value: float, unit: str, *, prefer: str | None = None, digits: int | None = 4) -> str:
    """Text of a quantity with a unit, for people: ``format_quantity(0.007, "m")`` is ``"7 mm"``.

    Parameters
    ----------
    value : in ``unit``
    unit : SI unit, such as ``"m"``; empty for a dimensionless quantity
    prefer : unit with a prefix, such as ``"mm"``; by default the one that leaves 1 to 999 before the
        point
    digits : significant digits; None for as many as `to_si` needs to read the same float
    """
    if not math.isfinite(value):
        return f"{value} {unit}".rstrip()
    if unit == "rad" and prefer is None and digits is not None:
        return f"{math.degrees(value) + 0.0:.{digits}g} deg"  # the usual unit of angles
    exact = Decimal(repr(float(value) + 0.0))  # no sign before a zero
    rounded = exact if digits is None or value == 0 else Decimal(f"{exact:.{digits - 1}e}")
    scales = {f"{prefix}{unit}": PREFIXES[prefix] for prefix in ["", *PREFIXES_OF.get(unit, "")]}
    if prefer is None:
        fitting = (
            [name for name, power in scales.items() if power <= rounded.adjusted()] if rounded else [unit]
        )
        prefer = max(fitting, key=scales.__getitem__) if fitting else min(scales, key=scales.__getitem__)
    assert prefer in scales, f"{prefer} is not {unit} with a prefix"
    return f"{_plain(rounded.scaleb(-scales[prefer]))} {prefer}".rstrip()


def duration(seconds: float) -> str:
    """Text of a duration: ``"45 s"``, ``"10 min"``, ``"2.5 h"``; `to_si` reads it."""
    if seconds < 60:
        return f"{max(seconds, 1.0):.2g} s"
    return f"{seconds / 60:.3g} min" if seconds < 6000 else f"{seconds / 3600:.3g} h"


def frequency_scale(*frequencies: float) -> tuple[str, float]:
    """Unit for frequencies (Hz), kHz, MHz or GHz, and the factor to it.

    The largest frequency selects it. Below 1 MHz the unit is kHz, the usual one for plates touched by
    fingers.
    """
    largest = max((abs(frequency) for frequency in frequencies if math.isfinite(frequency)), default=0.0)
    unit = "GHz" if largest >= 1e9 else "MHz" if largest >= 1e6 else "kHz"
    return unit, 10.0 ** -PREFIXES[unit[0]]


def hz_text(*frequencies: float, form: str = ".4g", error: float | None = None) -> str:
    """Text of frequencies (Hz) with a suitable unit: ``52.51 kHz``, ``54.36 MHz``, ``8.1 to 8.9 GHz``.

    Parameters
    ----------
    form : format of each number, as in `format`
    error : error bound of the last frequency, Hz, which is then rounded as by `uncertain`
    """
    unit, scale = frequency_scale(*frequencies)
    texts = [format(frequency * scale, form) for frequency in frequencies]
    if error is not None:
        texts[-1] = uncertain(frequencies[-1] * scale, error * scale)
    return f"{' to '.join(texts)} {unit}"


def in_percent(*shares: SupportsFloat, form: str = "z.0f") -> str:
    """Text of shares in percent, with a space before the sign: ``5 %``, ``92 to 125 %``.

    Parameters
    ----------
    form : format of each number, as in `format`; by default whole percent, without a sign before a zero
    """
    return f"{' to '.join(format(100 * float(share), form) for share in shares)} %"


def share_form(low: float, high: float) -> str:
    """Format of a share in percent and of the ends of its interval, for `in_percent`.

    Whole percent, or one decimal if the interval is narrower than four percent: `uncertain` rounds so too.
    """
    return "z.1f" if abs(high - low) < NARROW else "z.0f"


def share_text(value: float, low: float = math.nan, high: float = math.nan) -> str:
    """A share with its interval, ``80 % (70 to 90 %)``; without finite ends the share alone."""
    form = share_form(low, high)
    interval = f" ({in_percent(low, high, form=form)})" if math.isfinite(low) and math.isfinite(high) else ""
    return in_percent(value, form=form) + interval


def uncertain(value: float, bound: float) -> str:
    """Value and bound of its error, ``52.51 ± 0.05``, both in the unit of the text.

    The bound is rounded up to one digit, or to two if the first is a 1, and the value to the same place:
    ``106400 ± 400``. Without a bound it is alone.
    """
    if not (math.isfinite(bound) and bound > 0):
        return f"{value:.3f}"
    bound = max(bound, 10.0**-MOST_DECIMALS)  # never printed as zero
    power = math.floor(math.log10(bound) + 1e-9)
    power -= bound < 2 * 10.0**power  # for 1.02, one digit would double the bound
    power += math.ceil(bound / 10.0**power - 1e-9) == 10
    digits, shown = max(math.ceil(bound / 10.0**power - 1e-9), 1), min(max(-power, 0), MOST_DECIMALS)
    return f"{round(value, -power):z.{shown}f} ± {digits * 10.0**power:.{shown}f}"


def kind_of(unit: str) -> str:
    """Quantity of a unit: "time" for "us", "another quantity" for "dB"; empty for an unknown unit."""
    if (match := _QUANTITY.fullmatch(f"1 {unit}".translate(TYPOGRAPHIC))) is None or not match["unit"]:
        return ""
    common = [kind for of, kind in KINDS.items() if match["unit"] in _table(of)]  # without pint
    try:
        return common[0] if common else next(filter(None, (_kind(match["unit"], of) for of in KINDS)), OTHER)
    except _UnknownUnitError:
        return ""


def _kind(unit_text: str, unit: str) -> str:
    try:
        _factor(unit_text, unit)
    except _OtherKindError:
        return ""
    return KINDS[unit]


def example_of(unit: str) -> str:
    """Example of a quantity in a given SI unit: ``"7 mm"`` for ``"m"``."""
    return EXAMPLES.get(unit, f"1 {unit}".rstrip())


def example_value(unit: str) -> float:
    """The example in SI units; this needs no pint."""
    number, words = example_of(unit).split(" ", 1)
    return float(number) * (math.radians(1.0) if words == "deg" else float(_table(unit)[words]))


def _usual_unit(number: Fraction, unit: str) -> str:
    """Unit probably meant for a bare number: that of the example or, far from it, one with another prefix."""
    words, factors = example_of(unit).split(" ", 1)[1], _table(unit)

    def decades(prefixed: str) -> float:
        value = abs(number) * factors[prefixed] / Fraction(example_value(unit))
        return abs(math.log10(value.numerator) - math.log10(value.denominator))

    is_usual = words not in factors or decades(words) <= USUAL_DECADES  # degrees have no prefixes
    return words if is_usual else min(factors, key=decades)


class _UnknownUnitError(Exception):
    """The unit is unknown."""


class _OtherKindError(Exception):
    """A unit of another dimension."""


def _split(text: str, refused: Callable[..., HaptonicError]) -> tuple[Fraction, str]:
    """Number and unit of ``<number> <unit>``; the unit may be empty."""
    if not text.strip():
        raise refused("the text is empty")
    if len(text) > LONGEST_TEXT:
        raise refused(f"the text is {len(text)} characters long; a quantity needs at most {LONGEST_TEXT}")
    if _NOT_FINITE.match(text):
        raise refused("it is not a finite number")
    plain = text.translate(TYPOGRAPHIC)
    if (match := _QUANTITY.fullmatch(plain)) is None:
        with_point = plain.replace(",", ".")
        is_clear = _QUANTITY.fullmatch(with_point) and not _THOUSANDS.search(text)
        raise refused(_why_not_a_quantity(text), f'write "{with_point}"' if is_clear else "")
    if abs(int(match["exponent"] or 0)) > LARGEST_EXPONENT:
        raise refused("the power of ten is outside the range of numbers")
    return Fraction(match["number"]), match["unit"] or ""


def as_quantity(text: str) -> str | None:
    """Unit of a text that `to_si` reads, or refuses, as one number with a unit; None for any other text."""
    if not text.strip() or _NOT_FINITE.match(text):
        return ""
    match = _QUANTITY.fullmatch(text.translate(TYPOGRAPHIC)) if len(text) <= LONGEST_TEXT else None
    return None if match is None else match["unit"] or ""


def _why_not_a_quantity(text: str) -> str:
    if re.search(r"[0-9],[0-9]", text):
        return "a decimal comma, where a decimal point is needed"
    if strange := [mark for mark in text if not mark.isascii() and mark not in f"µ{_MU}·²³"]:
        return f"the character {strange[0]!a} is not expected here"
    if re.match(r"\s*[A-Za-z]", text):
        return "the number is missing"
    return "it is not one number followed by one unit"


def _factor(unit_text: str, unit: str) -> Fraction:
    """Value of one ``unit_text`` in ``unit``, exact."""
    factors = _table(unit)
    if unit_text in factors:
        return factors[unit_text]
    try:
        quantity = registry().Quantity(Fraction(1), unit_text)
        if unit == "Hz" and (turns := _turns(quantity)) is not None:
            return turns
        return Fraction(quantity.to(unit).magnitude)
    except Exception as error:  # noqa: BLE001 - pint raises many kinds, some only while it formats its message
        if type(error).__name__ in {"UndefinedUnitError", "DefinitionSyntaxError"}:
            raise _UnknownUnitError from None
        raise _OtherKindError from None


def _turns(quantity: pint.Quantity[Fraction]) -> Fraction | None:
    """Turns per second of an angle per time, exact for rpm; None for another quantity.

    For pint an angle has no dimension, so it would read 1 rad/s as 1 Hz, and 1 rpm as 0.105 Hz.
    """
    power = dict(quantity.to_root_units().unit_items()).get("radian", 0)
    if power == 0:
        return None
    if power != 1:
        raise _OtherKindError
    turn = registry().Quantity(Fraction(1), "turn").to("radian")
    return Fraction(quantity.to("radian/second").magnitude) / Fraction(turn.magnitude)


@cache
def _table(unit: str) -> dict[str, Fraction]:
    """Units that are read without pint: the SI unit and its prefixed forms."""
    prefixes = ["", *PREFIXES_OF.get(unit, "")]
    table = {f"{prefix}{unit}": Fraction(10) ** PREFIXES[prefix] for prefix in prefixes}
    table |= TIMES if unit == "s" else {}
    return table | {name.replace("µ", "u", 1): factor for name, factor in table.items() if "µ" in name}


def _nearest_unit(unit_text: str, unit: str) -> str | None:
    alike = [name for name in _table(unit) if name.casefold() == unit_text.casefold()]
    # then one wrong letter behind a right one: "mn" is closer to "mm" than to "m"
    alike += [name for name in _table(unit) if name[:-1] == unit_text[:-1] != ""]
    return alike[0] if alike else nearest(unit_text, _table(unit))


def _plain(number: Decimal) -> str:
    """Shortest text of a decimal: no trailing zeros, with a power of ten only far from one."""
    number = number.normalize()
    return f"{number:f}" if -5 < number.adjusted() < 16 else f"{number:e}"
