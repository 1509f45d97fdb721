"""Tables of numbers that other programs export: whatever parts the columns, with or without names above them.

Columns are parted by tabs, semicolons, bars, commas or blanks; numbers have a decimal point or comma, and may
be complex, of which the real part is taken. Lines that begin with %, #, ! or // are comments; the last line
before the numbers, a comment or not, has the names if it has as many.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from haptonic.arrays import Array
from haptonic.channels.text_file import text_of
from haptonic.errors import ChannelError, shown

FORMS = (
    ("\t", "."),
    ("\t", ","),
    (";", "."),
    (";", ","),
    ("|", "."),
    ("|", ","),
    (",", "."),
    ("", "."),
    ("", ","),
)
COMMENT = re.compile(r"\s*(%|#|!|//)+\s?")
_REAL = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eEdD][+-]?\d+)?"
_NUMBER = re.compile(rf"(?P<real>{_REAL})(?:\s*[+-]\s*(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\s*\*?[ij])?")
_MISSING = {"nan", "-nan", "na", "n/a", "-", "--"}
_UNIT = re.compile(r"(?P<name>.*?)\s*[\[(](?P<unit>[^()\[\]]*)[\])]\s*")
LARGEST_FILE = 50_000_000  # bytes


@dataclass(frozen=True)
class Numbers:
    """values : (row, column); names, units : of the columns, empty where the file does not say them."""

    values: Array
    names: tuple[str, ...]
    units: tuple[str, ...]


def read_numbers(path: Path) -> Numbers:
    """The table of a text file.

    Raises
    ------
    ChannelError : no file that can be read, no table of numbers, rows of different lengths, or commas that
        may be either of two things
    """
    if path.is_file() and path.stat().st_size > LARGEST_FILE:
        raise _refused(path, f"more than {LARGEST_FILE // 10**6} MB", "export fewer columns or rows")
    try:
        lines = text_of(path).splitlines()
    except OSError as error:
        raise _refused(
            path, error.strerror or "nothing", "check the path, and that you may read it"
        ) from error
    counted = [(sum(_row(line, form) is not None for line in lines), form) for form in FORMS]
    most = max(count for count, _ in counted)
    if not most:
        raise _refused(
            path, "no line with two numbers or more", "export the bands as text, a row of numbers a line"
        )
    form = next(one for count, one in counted if count == most)
    first = next(k for k, line in enumerate(lines) if _row(line, form) is not None)
    rows: list[list[float]] = []
    for number, line in enumerate(lines[first:], start=first + 1):
        if not line.strip() or COMMENT.match(line):
            continue
        row = _row(line, form)
        if row is None:
            raise _refused(
                path, f"line {number}: {shown(line.strip(), 40)}", "remove what is not a row of numbers"
            )
        if rows and len(row) != len(rows[0]):
            raise _refused(
                path, f"{len(row)} numbers in line {number} and {len(rows[0])} above it", "complete the rows"
            )
        rows.append(row)
    heads = _heads(lines[:first], form[0])
    if form[0] == "," and heads and 2 * len(heads) == len(rows[0]):
        raise _refused(path, f"{len(heads)} names above {len(rows[0])} numbers, all parted by commas",
                       "export it with a decimal point, or with semicolons between the columns")  # fmt: skip
    heads = heads if len(heads) == len(rows[0]) else [""] * len(rows[0])
    found = [_UNIT.fullmatch(head) for head in heads]
    return Numbers(
        np.array(rows),
        tuple(one["name"] if one else head for one, head in zip(found, heads, strict=True)),
        tuple(one["unit"].strip() if one else "" for one in found),
    )


def _cells(line: str, separator: str) -> list[str]:
    cells = [cell.strip() for cell in line.split(separator)] if separator else line.split()
    return cells[:-1] if separator and cells and not cells[-1] else cells  # one behind every row


def _row(line: str, form: tuple[str, str]) -> list[float] | None:
    """The numbers of a line, if it is nothing else."""
    separator, decimal = form
    cells = _cells(line.strip("\r\n"), separator)
    found = [_number(cell.strip('"'), decimal) for cell in cells]
    return [one for one in found if one is not None] if len(found) > 1 and None not in found else None


def _number(cell: str, decimal: str) -> float | None:
    if not cell or cell.lower() in _MISSING:
        return float("nan")
    if decimal == ",":
        if "." in cell:
            return None
        cell = cell.replace(",", ".")
    found = _NUMBER.fullmatch(cell)
    return float(re.sub("[dD]", "e", found["real"])) if found else None


def _heads(before: list[str], separator: str) -> list[str]:
    """Names in the last line before the numbers; below blanks a unit belongs to the word before it."""
    line = next((one for one in reversed(before) if one.strip()), "")
    line = COMMENT.sub("", line, count=1)
    if separator:
        return [cell.strip('"') for cell in _cells(line, separator)]
    return re.findall(r"\S+(?:\s+[\[(][^)\]]*[\])])?", line)


def _refused(path: Path, given: str, next_step: str) -> ChannelError:
    return ChannelError.unreadable(
        argument=path.name,
        given=given,
        allowed="rows of as many numbers each, parted by tabs, semicolons, bars, commas or blanks",
        cause="it is no table of numbers, or another export than it seems",
        next_step=next_step,
    )
