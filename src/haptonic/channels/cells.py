"""Cells of text tables: the numbers that programs write, and the words for a missing one."""

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
# "D" is Fortran's exponent of double precision, "*^" Mathematica's
_PART = r"(?:(?:\d+(?:\.\d*)?|\.\d+)(?:(?:[ed]|\*\^)[+-]?\d+)?|inf(?:inity)?|nan)"
# Fortran leaves the letter out of 1.5-101; with an "i" behind it that is a complex number
_REAL = re.compile(rf"[+-]?(?:{_PART}|\d+\.\d*[+-]\d{{3}})")
_IMAGINARY = re.compile(rf"(?P<sign>[+-]?)(?:(?P<before>{_PART})\*?[ij]|[ij]\*?(?P<behind>{_PART}))")
_SUM = re.compile(
    rf"(?P<real>[+-]?{_PART})(?P<sign>[+-])(?:(?P<before>{_PART})?\*?[ij]|[ij]\*?(?P<behind>{_PART}))"
)
_PAIR = re.compile(rf"\((?P<real>[+-]?{_PART})[,;](?P<imaginary>[+-]?{_PART})\)")
_AROUND_SIGNS = re.compile(r"\s*([+-])\s*")
# complex numbers with blanks or a comma in them, where blanks or commas part the columns
_SPACED = re.compile(
    rf"(?P<real>(?<![\w.]){_PART})\s+(?P<sign>[+-])\s+(?P<imaginary>{_PART}\s*\*?\s*[ij])(?!\w)",
    re.IGNORECASE,
)
_SPACED_PAIR = re.compile(
    rf"\(\s*(?P<real>[+-]?{_PART})\s*[,;]\s*(?P<imaginary>[+-]?{_PART})\s*\)", re.IGNORECASE
)
LONGEST = 80  # characters of a number


def is_missing(cell: str) -> bool:
    """True for an empty cell and for the words for a missing number."""
    return cell.strip().lower() in MISSING


def number_of(cell: str, decimal: str = ".") -> complex | None:
    """The number in a cell: a float, or a complex number where the cell has an imaginary part; else None.

    A missing number is NaN.
    """
    if decimal == ".":
        try:
            value = float(cell)
            if "_" not in cell:  # Python reads 1_000; no table means that
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
    if found := _IMAGINARY.fullmatch(text):
        return complex(0.0, _float(found["sign"] + (found["before"] or found["behind"])))
    if found := _SUM.fullmatch(text):
        return complex(
            _float(found["real"]), _float(found["sign"] + (found["before"] or found["behind"] or "1"))
        )
    return None


def _float(text: str) -> float:
    text = text.replace("d", "e").replace("*^", "e")
    try:
        return float(text)
    except ValueError:  # an exponent without its letter
        return float(re.sub(r"(?<=[\d.])([+-]\d{3})$", r"e\1", text))


def joined(line: str) -> str:
    """A line in which complex numbers hold no blanks or commas: ``1 + 2i`` and ``(1, 2)`` are ``1+2i``."""
    if "(" in line:
        line = _SPACED_PAIR.sub(_as_sum, line)
    return _SPACED.sub(lambda found: re.sub(r"\s+", "", found[0]), line)


def _as_sum(found: re.Match[str]) -> str:
    imaginary = found["imaginary"]
    return f"{found['real']}{'' if imaginary[0] in '+-' else '+'}{imaginary}i"


def numbers_in(cells: Sequence[str], decimal: str) -> tuple[Array | np.ndarray, int | None]:
    """Numbers of cells, float or complex, and the place of the first cell that has none.

    Where a cell has no number, the array has NaN.
    """
    try:
        return _quick(cells, decimal), None
    except ValueError:
        pass
    found = [number_of(cell, decimal) for cell in cells]
    bad = next((k for k, value in enumerate(found) if value is None), None)
    values = [float("nan") if value is None else value for value in found]
    dtype = complex if any(isinstance(value, complex) for value in values) else float
    return np.array(values, dtype=dtype), bad


def _quick(cells: Sequence[str], decimal: str) -> Array:
    """The same for cells that Python itself reads.

    Raises
    ------
    ValueError : a cell that Python does not read, or reads where `number_of` would not
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
