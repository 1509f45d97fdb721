"""Dimensions of numbers with units: powers of base units, such as kg m^-3."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cache
from typing import Any

from haptonic.units import KINDS, PREFIXES, PREFIXES_OF, TIMES, TYPOGRAPHIC, registry

Dimension = tuple[tuple[str, Fraction], ...]
"""Base units with their powers in alphabetical order; empty for a plain number."""

PLAIN: Dimension = ()
BASES: dict[str, dict[str, int]] = {
    "m": {"m": 1},
    "s": {"s": 1},
    "kg": {"kg": 1},
    "rad": {"rad": 1},  # kept apart from plain numbers, so that a revolution is no frequency
    "Hz": {"s": -1},
    "N": {"kg": 1, "m": 1, "s": -2},
    "Pa": {"kg": 1, "m": -1, "s": -2},
    "V": {"kg": 1, "m": 2, "s": -3, "A": -1},
    "F": {"kg": -1, "m": -2, "s": 4, "A": 2},
}
BY_PINT = {"meter": "m", "second": "s", "kilogram": "kg", "radian": "rad", "ampere": "A"}

_PART = re.compile(r"(?P<operator>[*/]|\s|^)\s*(?P<name>[A-Za-zµ]+)(?:(?:\^|\*\*)(?P<power>-?[1-9]))?\s*")


class UnknownUnitError(Exception):
    """A text that is not a known unit."""


def dimension(powers: Mapping[str, Fraction]) -> Dimension:
    """Dimension of base units with their powers; powers of zero are left out."""
    return tuple(sorted((name, power) for name, power in powers.items() if power))


def combined(first: Dimension, second: Dimension, sign: int = 1) -> Dimension:
    """Dimension of a product, or with a ``sign`` of -1 of a quotient."""
    powers = dict(first)
    for name, power in second:
        powers[name] = powers.get(name, Fraction(0)) + sign * power
    return dimension(powers)


def raised(of: Dimension, power: Fraction) -> Dimension:
    """Dimension of a power."""
    return dimension({name: each * power for name, each in of})


@cache
def symbols() -> dict[str, tuple[Fraction, Dimension]]:
    """Units of one word that need no registry: factor to SI units, and dimension."""
    units = {}
    for unit, powers in BASES.items():
        of = dimension({name: Fraction(power) for name, power in powers.items()})
        for prefix in ("", *PREFIXES_OF.get(unit, "")):
            units[f"{prefix}{unit}"] = (Fraction(10) ** PREFIXES[prefix], of)
    second = dimension({"s": Fraction(1)})
    units |= {name: (factor, second) for name, factor in TIMES.items()}
    return units | {name.replace("µ", "u", 1): value for name, value in units.items() if "µ" in name}


@cache
def measured(unit: str) -> tuple[Fraction, Dimension]:
    """Value of one unit in SI base units, exact, and its dimension; ``unit`` such as "N/mm^2".

    Raises
    ------
    UnknownUnitError : not a unit
    """
    text = unit.translate(TYPOGRAPHIC).strip()
    parts = list(_parts(text))
    if parts and all(name in symbols() for _, name, _ in parts):
        factor, of = Fraction(1), PLAIN
        for sign, name, power in parts:
            size, own = symbols()[name]
            factor *= size ** (sign * power)
            of = combined(of, raised(own, Fraction(power)), sign)
        return factor, of
    try:
        quantity: Any = registry().Quantity(Fraction(1), text).to_base_units()
        powers = {BY_PINT.get(name, name): Fraction(power) for name, power in quantity.unit_items()}
        return Fraction(quantity.magnitude), dimension(powers)
    except Exception:  # noqa: BLE001 - pint raises many kinds
        raise UnknownUnitError(unit) from None


def _parts(text: str) -> Iterator[tuple[int, str, int]]:
    """(sign of the power, name, power) of each word of a unit; nothing for another text."""
    position, parts = 0, []
    while position < len(text):
        match = _PART.match(text, position)
        if match is None:
            return
        parts.append((-1 if match["operator"] == "/" else 1, match["name"], int(match["power"] or 1)))
        position = match.end()
    yield from parts


def dimension_of(unit: str) -> Dimension:
    """Dimension of a declared SI unit; empty for a plain number."""
    return measured(unit)[1] if unit else PLAIN


@cache
def _declared() -> dict[Dimension, str]:
    return {dimension_of(unit): unit for unit in KINDS}


def unit_of(of: Dimension) -> str:
    """SI unit of a dimension: "Hz", "kg/m^3", "m^2"; empty for a plain number."""
    return _declared().get(of) or "*".join(name if power == 1 else f"{name}^{power}" for name, power in of)


def kind_text(of: Dimension) -> str:
    """Kind of a quantity for messages, with an article: "a length", "a number in m^2"."""
    if not of:
        return "a plain number"
    unit = unit_of(of)
    if unit not in KINDS:
        return f"a number in {unit}"
    return f"an {KINDS[unit]}" if KINDS[unit][0] in "aeiou" else f"a {KINDS[unit]}"
