"""Cells of text tables: the numbers that programs write, and the words for a missing number."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from haptonic.arrays import Array

MISSING = frozenset(
    ("", "-", "--", "---", "na", "n/a", "#n/a", "nan", "-nan", "+nan", "<na>", "null", "none", "nan(ind)",
     "-nan(ind)", "1.#qnan", "-1.#qnan", "1.#ind", "-1.#ind")
)  # fmt: skip
_INFINITE = {"1.#inf": "inf", "-1.#inf": "-inf", "+1.#inf": "inf", "∞": "inf", "-∞": "-inf", "+∞": "inf"}
# "D" is the exponent of double precision in Fortran, "*^" the exponent in Mathematica
_PART = r"(?:(?:\d+(?:\.\d*)?|\.\d+)(?:(?:[ed]|\*\^)[+-]?\d+)?|inf(?:inity)?|nan)"
# Fortran leaves the letter out of 1.5-101; with an "i" behind it that is a complex number
_REAL = re.compile(rf"[+-]?(?:{_PART}|\d+\.\d*[+-]\d{{3}})")
_IMAGINARY = re.compile(rf"(?P<sign>[+-]?)(?:(?P<before>{_PART})\*?[ij]|[ij]\*?(?P<behind>{_PART}))")
_SUM = re.compile(
    rf"(?P<real>[+-]?{_PART})(?P<sign>[+-])(?:(?P<before>{_PART})?\*?[ij]|[ij]\*?(?P<behind>{_PART}))"
)
_PAIR = re.compile(rf"\((?P<real>[+-]?{_PART})[,;](?P<imaginary>[+-]?{_PART})\)")
_AROUND_SIGNS = re.compile(r"\s*([+-])\s*")
# complex numbers with blanks or a comma inside, in tables whose columns are separated by the same sign
_SPACED = re.compile(
    rf"(?P<real>(?<![\w.]){_PART})\s+(?P<sign>[+-])\s+(?P<imaginary>{_PART}\s*\*?\s*[ij])(?!\w)",
    re.IGNORECASE,
)
_SPACED_PAIR = re.compile(
    rf"\(\s*(?P<real>[+-]?{_PART})\s*[,;]\s*(?P<imaginary>[+-]?{_PART})\s*\)", re.IGNORECASE
)
# points between groups of three digits, before a decimal comma; 9.838 alone may be a number of either kind
_GROUPED = re.compile(r"(?<![\d.,])[1-9]\d{0,2}(?:\.\d{3})+(?=,\d)")
LONGEST = 80  # characters of a number


def is_missing(cell: str) -> bool:
    """True for an empty cell, and for a word that means a missing number."""
    return cell.strip().lower() in MISSING


def number_of(cell: str, decimal: str = ".") -> complex | None:
    """Number in a cell: a float, or a complex number for a cell with an imaginary part; else None.

    A missing number is NaN. In numbers with decimal commas, points may separate thousands: 9.838,85.
    """
    if decimal == ".":
        try:
            value = float(cell)
            if "_" not in cell:  # Python reads 1_000, which no table means as a number
                return value
        except ValueError:
            pass
    text = cell.strip().lower().replace("\N{MINUS SIGN}", "-")
    if text in MISSING:
        return float("nan")
    if len(text) > LONGEST:
        return None
    text = _INFINITE.get(text, text)
    if decimal == ",":
        text = _GROUPED.sub(lambda digits: digits[0].replace(".", ""), text)
        if "." in text or text.endswith(","):
            return None
        text = text.replace(",", ".")
    text = _AROUND_SIGNS.sub(r"\1", text)
    pair = _PAIR.fullmatch(text.replace(" ", ""))
    if pair:
        return complex(_float(pair["real"]), _float(pair["imaginary"]))
    while text[:1] in ("(", "[") and text[-1:] == {"(": ")", "[": "]"}[text[0]]:
        text = text[1:-1].strip()
    if _REAL.fullmatch(text):
        return _float(text)
    if match := _IMAGINARY.fullmatch(text):
        return complex(0.0, _float(match["sign"] + (match["before"] or match["behind"])))
    if match := _SUM.fullmatch(text):
        return complex(
            _float(match["real"]), _float(match["sign"] + (match["before"] or match["behind"] or "1"))
        )
    return None


def _float(text: str) -> float:
    text = text.replace("d", "e").replace("*^", "e")
    try:
        return float(text)
    except ValueError:  # an exponent without its letter
        return float(re.sub(r"(?<=[\d.])([+-]\d{3})$", r"e\1", text))


def joined(line: str) -> str:
    """A line with complex numbers without blanks or commas: ``1 + 2i`` and ``(1, 2)`` become ``1+2i``."""
    if "(" in line:
        line = _SPACED_PAIR.sub(_as_sum, line)
    return _SPACED.sub(lambda match: re.sub(r"\s+", "", match[0]), line)


def _as_sum(match: re.Match[str]) -> str:
    imaginary = match["imaginary"]
    return f"{match['real']}{'' if imaginary[0] in '+-' else '+'}{imaginary}i"


def numbers_in(cells: Sequence[str], decimal: str) -> tuple[Array | np.ndarray, int | None]:
    """Numbers of cells, float or complex, and the index of the first cell without one; None if all have one.

    The array has NaN for a cell without a number.
    """
    try:
        return _quick(cells, decimal), None
    except ValueError:
        pass
    numbers = [number_of(cell, decimal) for cell in cells]
    bad = next((k for k, value in enumerate(numbers) if value is None), None)
    values = [float("nan") if value is None else value for value in numbers]
    dtype = complex if any(isinstance(value, complex) for value in values) else float
    return np.array(values, dtype=dtype), bad


def _quick(cells: Sequence[str], decimal: str) -> Array:
    """`numbers_in` for cells that Python itself reads.

    Raises
    ------
    ValueError : a cell that Python cannot read, or reads differently from `number_of`
    """
    if decimal == ",":
        text = "\n".join(cells)
        if "." in text:
            raise ValueError
        cells = text.replace(",", ".").split("\n")
    values = np.array(list(map(float, cells)))
    if len(values) and any("_" in cell for cell in cells):
        raise ValueError
    return values
