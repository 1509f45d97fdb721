"""Reader of all text tables: CSV files, exports of other programs, tables of trials and of points.

Columns are separated by tabs, semicolons, bars, commas or blanks; numbers have a decimal point or comma, and
may be complex, infinite or missing. Lines that begin with %, #, ! or // are comments. The line of names is
the last line above the numbers with as many cells, even if it is a comment; a line of units may be below it.
Without a line of names, columns have numbers, from 1. Every line that is left out is counted, or the file is
refused.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.channels.cells import is_missing, number_of, numbers_in
from haptonic.channels.dialect import (
    Dialect,
    comma_meaning,
    dialect_of,
    is_comment,
    sample_of,
    with_rare_commas,
)
from haptonic.channels.headings import Heading
from haptonic.channels.text_file import refused, text_of
from haptonic.channels.text_head import head_of
from haptonic.errors import ChannelError, shown
from haptonic.names import from_cell

PORTION = 20_000  # lines that are read at a time
MOST_COLUMNS = 20_000  # each takes time: a million of them in 2 MB took minutes
MOST_NOTED = 5  # comments among the rows that a remark lists


@dataclass(frozen=True, eq=False)
class TextColumn:
    """A column of a table.

    heading : its name and unit; both empty if the file has no names
    number : of the column, from 1
    values : (row,) float, complex, or texts (object)
    bad : line and text of its first cell that is not a number, for a column of numbers
    """

    heading: Heading
    number: int
    values: NDArray[Any] = field(repr=False)
    bad: tuple[int, str] | None = None

    @property
    def name(self) -> str:
        """The name without the unit, or the number."""
        return self.heading.name or str(self.number)

    @property
    def unit(self) -> str:
        return self.heading.unit

    @property
    def is_text(self) -> bool:
        return self.values.dtype.kind == "O"


@dataclass(frozen=True, eq=False)
class TextTable:
    """A text table.

    lines : (row,) number of the row's line in the file, from 1
    blocks : (row,) 0, 1, ...: number of empty lines, or groups of them, above the row within the table
    names_line : number of the line of names, None without one
    unmatched : number of a line above the rows with names that match no columns, or None
    titles : lines above the table, comments among them
    short : lines with fewer cells than columns, which are filled with missing numbers
    remarks : omissions and assumptions, as text
    """

    path: Path
    columns: tuple[TextColumn, ...]
    lines: NDArray[np.int64] = field(repr=False)
    blocks: NDArray[np.int64] = field(repr=False)
    names_line: int | None
    unmatched: int | None
    titles: tuple[str, ...]
    short: tuple[int, ...]
    remarks: tuple[str, ...]
    first_row: tuple[str, ...]

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(column.name for column in self.columns)

    @cached_property
    def columns_by_name(self) -> dict[str, TextColumn]:
        """The columns by their names; the second of two equal names gets ".1" appended."""
        by_name: dict[str, TextColumn] = {}
        again: Counter[str] = Counter()
        for column in self.columns:
            name = column.name
            while name in by_name:
                again[column.name] += 1
                name = f"{column.name}.{again[column.name]}"
            by_name[name] = column
        return by_name

    def numbers(self, column: TextColumn) -> NDArray[Any]:
        """(row,) float or complex numbers of a column.

        Raises
        ------
        ChannelError : a cell that is not a number; the error gives its line
        """
        line, text = column.bad or (0, "")
        if column.is_text and len(column.values):
            line, text = int(self.lines[0]), str(column.values[0])
        if line:
            cause = "a title or a note among the rows, or a number in an unknown form"
            next_step = f"correct line {line} of {self.path.name}, or put # before it"
            if text.count(".") == 1 and number_of(text) is not None:
                cause = "a point in a table of decimal commas, for decimals or between thousands"
                next_step = f"write {text.replace('.', ',')} or {text.replace('.', '')} in line {line}"
            raise ChannelError.malformed(
                argument=f"{self.path.name}, column {column.name}",
                given=f"line {line}: {shown(text, 40)}",
                allowed="a number in every row, or an empty cell",
                cause=cause,
                next_step=next_step,
            )
        return column.values


def read_table(
    path: Path, *, texts: Collection[str] = (), skip: int = 0, option: str = "", largest: int | None = None
) -> TextTable:
    """Read the table of a text file.

    Parameters
    ----------
    texts : names of columns that contain words, even if these look like numbers; capitals do not matter
    skip : number of lines at the top before the table
    option : name of the user's option for ``skip``, such as "--skip-lines", for error messages
    largest : largest size of a file that is read, bytes

    Raises
    ------
    ChannelError : no text, no rows, a line that is neither a row nor a title, or ambiguous commas
    OSError : no such file, or no right to read it
    """
    if largest is not None and path.is_file() and path.stat().st_size > largest:
        raise refused(path, f"more than {largest // 10**6} MB", "export fewer columns or rows")
    lines = text_of(path).rstrip().replace("\r\n", "\n").replace("\r", "\n").split("\n")
    sample = sample_of(lines[skip:])
    dialect = dialect_of(sample)
    if dialect is None:
        raise refused(path, "no line with a number", "export it as text, a row of numbers a line")
    if dialect.cells > MOST_COLUMNS:
        raise refused(path, f"{dialect.cells:,} columns", f"export at most {MOST_COLUMNS:,} columns")
    dialect, sample = with_rare_commas(lines[skip:], sample, dialect)
    # a large file is read whole for its commas only if those of the sample are unclear
    if (unsure := comma_meaning(sample, dialect)) and comma_meaning(lines[skip:], dialect):
        raise refused(path, unsure, "export it with a decimal point, or with semicolons between the columns")
    head = head_of(path, lines, dialect, skip, option)
    count = len(head.names) or dialect.cells - dialect.empty
    headings = [Heading.of(cell) for cell in head.names] or [Heading("", "", "")] * count
    for k, unit in enumerate(head.units[:count]):
        headings[k] = replace(headings[k], unit=headings[k].unit or unit)
    words = {text.casefold() for text in texts}
    numeric = [
        dialect.numeric[k] and words.isdisjoint((heading.name.casefold(), heading.text.casefold()))
        for k, heading in enumerate(headings)
    ]
    body = _Body(path, dialect, numeric)
    for first in range(head.first, len(lines), PORTION):
        body.add(first + 1, lines[first : first + PORTION])
    return TextTable(
        path=path,
        columns=tuple(body.column(k, heading) for k, heading in enumerate(headings)),
        lines=np.array(body.lines, dtype=np.int64),
        blocks=np.array(body.blocks, dtype=np.int64),
        names_line=head.line,
        unmatched=head.unmatched,
        titles=(*(line.strip() for line in lines[:skip]), *head.titles),
        short=tuple(body.short),
        remarks=(*head.remarks, *body.remarks()),
        first_row=tuple(dialect.split(lines[head.first])) if head.first < len(lines) else (),
    )


class _Body:
    """The rows of a table, portion by portion."""

    def __init__(self, path: Path, dialect: Dialect, numeric: Sequence[bool]) -> None:
        self.path, self.dialect, self.numeric, self.count = path, dialect, numeric, len(numeric)
        self.parts: list[list[NDArray[Any]]] = [[] for _ in range(self.count)]
        self.bad: list[tuple[int, str] | None] = [None] * self.count
        self.lines: list[int] = []
        self.blocks: list[int] = []
        self.short: list[int] = []
        self.comments: list[tuple[int, str]] = []
        self.block, self.apart = 0, False

    def add(self, first: int, portion: Sequence[str]) -> None:
        """Add lines; the first has this number."""
        rows = self._regular(portion)
        if rows is None:
            numbers, rows = self._one_by_one(first, portion)
        else:
            numbers = list(range(first, first + len(rows)))
            self.blocks += self._begun(len(rows))
        self.lines += numbers
        for k, cells in enumerate(zip(*rows, strict=True) if rows else []):
            if not self.numeric[k]:
                column = np.empty(len(cells), dtype=object)
                column[:] = [from_cell(cell.strip()) for cell in cells]
                self.parts[k].append(column)
                continue
            values, bad = numbers_in(cells, self.dialect.decimal)
            if bad is not None and self.bad[k] is None:
                self.bad[k] = (numbers[bad], cells[bad])
            self.parts[k].append(values)

    def _begun(self, count: int) -> list[int]:
        if self.apart:
            self.block, self.apart = self.block + bool(self.blocks), False
        return [self.block] * count

    def _regular(self, portion: Sequence[str]) -> list[list[str]] | None:
        """Cells of lines if all are rows, without comments and quotes; else None."""
        text = "\n".join(portion)
        if any(mark in text for mark in ("%", "#", "!", '"', "(", "//")):
            return None
        rows = [line.split(self.dialect.separator or None) for line in portion]
        if set(map(len, rows)) != {self.dialect.cells} or not all(map(any, rows)):
            return None
        if self.count < self.dialect.cells:
            if any(any(row[self.count :]) for row in rows):
                return None
            rows = [row[: self.count] for row in rows]
        return rows

    def _one_by_one(self, first: int, portion: Sequence[str]) -> tuple[list[int], list[list[str]]]:
        numbers: list[int] = []
        rows: list[list[str]] = []
        for number, line in enumerate(portion, start=first):
            if is_comment(line):
                self.comments.append((number, line.strip()))
                continue
            cells = self.dialect.split(line) if line.strip() else []
            if not any(cells):
                self.apart = True
                continue
            rows.append(self._row(number, line, cells))
            numbers.append(number)
            self.blocks += self._begun(1) if self.apart else [self.block]
        return numbers, rows

    def _row(self, number: int, line: str, cells: list[str]) -> list[str]:
        """The cells of a row, one for each column."""
        if len(cells) > self.count:
            if any(cells[self.count :]):
                raise self._refused(
                    f"line {number} has more cells than the table has columns: {shown(line.strip(), 40)}",
                    number,
                )
            return cells[: self.count]
        if len(cells) < self.count:
            _, bad = numbers_in(
                [cell for cell, numeric in zip(cells, self.numeric, strict=False) if numeric],
                self.dialect.decimal,
            )
            if bad is not None or not self.dialect.separator or len(cells) == 1:
                raise self._refused(
                    f"line {number} is not a row of {self.count} cells: {shown(line.strip(), 40)}", number
                )
            self.short.append(number)
        return [*cells, *[""] * (self.count - len(cells))]

    def _refused(self, given: str, number: int) -> ChannelError:
        return refused(self.path, given, f"complete line {number} of {self.path.name}, or put # before it")

    def column(self, k: int, heading: Heading) -> TextColumn:
        """A column with all rows."""
        parts = self.parts[k]
        empty: NDArray[Any] = np.zeros(0, dtype=float if self.numeric[k] else object)
        return TextColumn(heading, k + 1, np.concatenate(parts) if parts else empty, self.bad[k])

    def remarks(self) -> list[str]:
        """Remarks on comments among the rows, which are not part of the table."""
        if not self.comments:
            return []
        named = "; ".join(f"line {number}: {shown(text, 40)}" for number, text in self.comments[:MOST_NOTED])
        more = len(self.comments) - MOST_NOTED
        return [f"comments among the rows are left out: {named}{f'; and {more} more' if more > 0 else ''}"]


def missing_as_nan(column: TextColumn) -> NDArray[Any]:
    """Texts of a column, with NaN for an empty cell or a word for a missing number."""
    return np.array([np.nan if is_missing(text) else text for text in column.values], dtype=object)
