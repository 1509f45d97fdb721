"""Dialect of a text table: separator of the columns, and decimal sign of the numbers."""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from haptonic.channels.cells import is_missing, joined, number_of
from haptonic.channels.headings import COMMENT, could_be_names

# The first of several that read every row is used: a semicolon is never part of a number, a comma may be.
SEPARATORS = ("\t", ";", "|", ",", "")
TAIL, SPREAD = 24, 12  # lines of the sample: at the end, and spread over the file


@dataclass(frozen=True)
class Dialect:
    """Dialect of the rows of a table.

    separator : "" for blanks
    decimal : "." or ","
    cells : number of cells in a row
    empty : number of cells at the end that are empty in all rows
    numeric : for each cell, True if its column contains numbers
    """

    separator: str
    decimal: str
    cells: int
    empty: int
    numeric: tuple[bool, ...]

    def split(self, line: str) -> list[str]:
        """Split a line into cells."""
        return split(line, self.separator)

    def is_row(self, cells: Sequence[str]) -> bool:
        """True if all numeric columns have a number or a missing one, and one of them has a number."""
        if not self.cells - self.empty <= len(cells) <= self.cells:
            return False
        pairs = zip(cells, self.numeric, strict=False)
        numbers = [number_of(cell, self.decimal) for cell, numeric in pairs if numeric]
        return None not in numbers and any(value == value for value in numbers)


def split(line: str, separator: str) -> list[str]:
    """Split a line into cells."""
    if "(" in line or "i" in line or "j" in line or "I" in line:
        line = joined(line)
    if not separator:
        line = re.sub(r"(?<=\d)\s*\*\s*(?=[ij])", "*", line)
        return [cell.strip('"') for cell in line.split()]
    if '"' in line:
        try:
            rows = list(csv.reader([line], delimiter=separator, skipinitialspace=True))
        except csv.Error:  # a cell of more than 131072 characters, which no table has
            rows = [line.split(separator)]
        return [cell.strip() for cell in rows[0]] if rows else []
    return [cell.strip() for cell in line.split(separator)]


def is_comment(line: str) -> bool:
    """True if a line begins with %, #, ! or //."""
    begin = line.lstrip()[:2]
    return begin[:1] in ("%", "#", "!") or begin == "//"


def sample_of(lines: Sequence[str]) -> list[str]:
    """Lines with text that are not comments: some of all, then the last ones."""
    tail: list[str] = []
    for line in reversed(lines):
        if len(tail) == TAIL:
            break
        if line.strip() and not is_comment(line):
            tail.append(line)
    spread = lines[:: max(1, len(lines) // SPREAD)] if len(lines) > TAIL else []
    return [line for line in spread if line.strip() and not is_comment(line)] + tail[::-1]


def dialect_of(sample: Sequence[str]) -> Dialect | None:
    """The dialect in which most lines are rows with equal numbers of cells; None without lines.

    Rows of numbers only are better evidence for a dialect than words with the same separators.
    """
    best: tuple[tuple[Fraction, Fraction, int], Dialect] | None = None
    late = sample[len(sample) // 2 :]
    for rank, separator in enumerate(SEPARATORS):
        if separator and rank and not 2 * sum(separator in line for line in late) >= len(late):
            continue
        rows = [split(line, separator) for line in sample]
        for decimal in (".", ","):
            for cells, count in Counter(map(len, rows)).most_common(2):
                equal = [row for row in rows if len(row) == cells]
                has_number = [[number_of(cell, decimal) is not None for cell in row] for row in equal]
                filled = [[not is_missing(cell) for cell in row] for row in equal]
                part = len(equal) // 2  # titles and names are above it
                numeric = tuple(
                    2 * sum(row[k] for row in has_number[part:]) >= len(has_number) - part
                    for k in range(cells)
                )
                whole = (
                    sum(all(h) and any(f) for h, f in zip(has_number, filled, strict=True))
                    if cells > 1
                    else 0
                )
                numbers = sum(
                    a and b
                    for h, f in zip(has_number, filled, strict=True)
                    for a, b in zip(h, f, strict=True)
                )
                score = (
                    Fraction(whole, len(rows)) if all(numeric) else Fraction(0),
                    # blanks also occur within words, and lines of a single cell prove nothing
                    Fraction(count, len(rows) * (1 if cells > 1 and separator else 2))
                    * (1 + Fraction(numbers, max(1, sum(map(sum, filled))))),
                    -rank,
                )
                if best is None or score > best[0]:
                    empty = next(
                        (k for k in range(cells) if any(row[cells - 1 - k] for row in filled[part:])), cells
                    )
                    best = (
                        score,
                        Dialect(
                            separator=separator, decimal=decimal, cells=cells, empty=empty, numeric=numeric
                        ),
                    )
            if best and best[0][0] == 1:
                return best[1]
    return best[1] if best else None


def with_rare_commas(
    lines: Sequence[str], sample: Sequence[str], dialect: Dialect
) -> tuple[Dialect, list[str]]:
    """The dialect with decimal commas if lines outside of the sample have them; these lines join the sample.

    A table of whole numbers does not show its decimal sign; a rare number such as 1,01e+06 does.
    """
    sample = list(sample)
    if dialect.decimal == "," or dialect.separator == ",":
        return dialect, sample
    numbers = [
        cell
        for row in map(dialect.split, sample)
        if dialect.is_row(row)
        for cell, numeric in zip(row, dialect.numeric, strict=False)
        if numeric
    ]
    if any("." in cell for cell in numbers):
        return dialect, sample
    commas = replace(dialect, decimal=",")
    rare = [line for line in lines if "," in line and not is_comment(line)]
    rare = [line for line in rare if commas.is_row(row := commas.split(line)) and not dialect.is_row(row)]
    return (commas, [*sample, *rare[:TAIL]]) if rare else (dialect, sample)


def comma_meaning(lines: Sequence[str], dialect: Dialect) -> str:
    """Ambiguity of the commas in lines of a table, as a sentence; "" if their meaning is clear."""
    rows = [row for line in lines if len(row := dialect.split(line)) == dialect.cells and dialect.is_row(row)]
    cells = [cell for row in rows for cell, numeric in zip(row, dialect.numeric, strict=True) if numeric]
    if dialect.decimal == ",":
        commas = [cell.lstrip("+-") for cell in cells if "," in cell]
        is_clear = any(
            not re.fullmatch(r"[1-9]\d{0,2}(,\d{3})+", cell) and cell.count(",") == 1 for cell in commas
        )
        if commas and not is_clear:
            return f'"{commas[0]}" may be {commas[0].replace(",", "")} or {commas[0].replace(",", ".", 1)}'
    elif dialect.separator == "," and not any("." in cell or "e" in cell.lower() for cell in cells):
        zeros = [cell for cell in cells if re.fullmatch(r"[+-]?0\d+", cell)]
        if zeros:
            return f'"{zeros[0]}" looks like decimals behind a comma, and commas part the columns too'
    return ""


def is_unclear_title(cells: Sequence[str], dialect: Dialect) -> bool:
    """True for a line above the numbers that looks like a row but is not one."""
    has_number = [number_of(cell, dialect.decimal) is not None and not is_missing(cell) for cell in cells]
    if len(cells) < 2 or not any(has_number):
        return False
    if dialect.cells - dialect.empty <= len(cells) <= dialect.cells:
        return (has_number[0] or 2 * sum(has_number) >= len(cells)) and not could_be_names(
            cells, dialect.decimal
        )
    return has_number[0] and 2 * sum(has_number) > len(cells)


def comment_text(line: str) -> str:
    """A line without comment marks."""
    mark = COMMENT.match(line)
    return line[mark.end() :].strip() if mark else line.strip()
