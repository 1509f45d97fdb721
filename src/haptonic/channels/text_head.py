"""Lines above the rows of a text table: titles, the line of names, a line of units."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from haptonic.channels.dialect import Dialect, comment_text, is_comment, is_unclear_title
from haptonic.channels.headings import Heading, could_be_names, is_rule, is_title, names_by_blanks, units_in
from haptonic.channels.text_file import refused
from haptonic.errors import shown

ROWS = 5  # that give the positions of the cells of a table with blanks


@dataclass
class Head:
    """Lines above the rows.

    first : index of the first row among the lines, from 0
    line : number of the line of names, from 1; None without one
    names, units : of the columns, may be empty
    unmatched : number of a line that may contain names, but not as many as columns
    titles : other lines
    remarks : assumptions, as text
    """

    first: int
    line: int | None = None
    names: list[str] = field(default_factory=list)
    units: list[str] = field(default_factory=list)
    unmatched: int | None = None
    titles: list[str] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)


class _Names:
    """Function that finds as many names in a line as the rows below have cells."""

    def __init__(self, rows: Sequence[str], dialect: Dialect) -> None:
        self.dialect = dialect
        self.starts = self.ends = None
        if not dialect.separator:
            places = [[(f.start(), f.end()) for f in re.finditer(r"\S+", line)] for line in rows[:ROWS]]
            starts, ends = ({tuple(place[k] for place in row) for row in places} for k in (0, 1))
            self.starts = starts.pop() if len(starts) == 1 else None
            self.ends = ends.pop() if len(ends) == 1 else None

    def __call__(self, line: str) -> list[str] | None:
        plain = comment_text(line) if is_comment(line) else line
        most, least = self.dialect.cells, self.dialect.cells - self.dialect.empty
        if not self.dialect.separator:
            return names_by_blanks(line, most, self.starts, self.ends)
        cells = self.dialect.split(plain)
        while len(cells) > least and not cells[-1]:
            cells.pop()
        if least <= len(cells) <= most and len(cells) > 0:
            return cells
        # names with commas or blanks above rows with semicolons; units prove that they are names
        others = None if self.dialect.separator in plain else names_by_blanks(line, least)
        return others if others and any(Heading.of(name).unit for name in others) else None


def head_of(path: Path, lines: Sequence[str], dialect: Dialect, skip: int, option: str) -> Head:
    """Find the first row and the names of the columns.

    Raises
    ------
    ChannelError : no row, a line above the rows that may be a row, or fewer names than columns
    """
    if not any(dialect.numeric):
        return _of_words(path, lines, dialect, skip)
    rows = (
        k
        for k, line in enumerate(lines[skip:], start=skip)
        if line.strip() and not is_comment(line) and dialect.is_row(dialect.split(line))
    )
    first = next(rows, None)
    if first is None:
        raise refused(path, "no row of numbers", "export it as text, a row of numbers a line")
    head = Head(first)
    names_in = _Names(
        [lines[first], *(lines[k] for _, k in zip(range(ROWS - 1), rows, strict=False))], dialect
    )
    above = [(k, line) for k, line in enumerate(lines[skip:first], start=skip) if not is_rule(line)]
    while above:
        k, line = above.pop()
        plain = comment_text(line) if is_comment(line) else line
        names = names_in(line)
        possible = names is not None and could_be_names(names, dialect.decimal) and not is_title(plain)
        units = units_in(names) if names else None
        if units and not head.units and above and names_in(above[-1][1]) and not is_title(above[-1][1]):
            head.units = units
        elif names is not None and possible:
            head.line, head.names = k + 1, names
            break
        elif not possible and _is_free(plain, line, dialect):
            _refuse_rows(path, [(k, line)], dialect, option)
            head.titles.insert(0, line.strip())
        elif dialect.separator:
            raise refused(
                path,
                f"line {k + 1} has {len(dialect.split(plain))} cells and line {first + 1} has "
                f"{dialect.cells - dialect.empty}, so some columns have no name: {shown(line.strip(), 60)}",
                leave_out(k + 1, option),
            )
        else:
            _refuse_rows(path, [(k, line)], dialect, option)
            head.unmatched = k + 1
            head.remarks.append(
                f"line {k + 1} does not have {dialect.cells} names that match the columns, which "
                f"are called 1 to {dialect.cells}: {shown(line.strip(), 60)}"
            )
            break
    _refuse_rows(path, above, dialect, option)
    head.titles = [line.strip() for _, line in above] + head.titles
    return head


def leave_out(line: int, option: str) -> str:
    """The next step for a line above the numbers that cannot be read."""
    if option:
        return f"leave out the lines above the names: {option}={line}"
    return f"put # before line {line}, or complete it"


def _of_words(path: Path, lines: Sequence[str], dialect: Dialect, skip: int) -> Head:
    """The head of a table without numbers: its first line with the right number of cells has the names."""
    for k, line in enumerate(lines[skip:], start=skip):
        cells = dialect.split(line)
        if len(cells) == dialect.cells and not is_comment(line):
            titles = [title.strip() for title in lines[:k] if title.strip()]
            return Head(k + 1, k + 1, names=cells, titles=titles)
    raise refused(path, "no row of numbers", "export it as text, a row of numbers a line")


def _is_free(plain: str, line: str, dialect: Dialect) -> bool:
    """True for a line of free text, which needs no cell for each column."""
    if dialect.separator:
        return is_title(plain) or dialect.separator not in plain
    return is_title(plain) or len(plain.split()) == 1 or not is_comment(line)


def _refuse_rows(path: Path, above: Sequence[tuple[int, str]], dialect: Dialect, option: str) -> None:
    """Refuse a line that begins like a row of numbers but is not one."""
    for k, line in above:
        if not is_comment(line) and is_unclear_title(dialect.split(line), dialect):
            raise refused(
                path,
                f"line {k + 1} begins like a row of the table but is not one: {shown(line.strip(), 40)}",
                leave_out(k + 1, option),
            )
