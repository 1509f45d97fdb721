"""Tables of raw values, from which terminal, page, file and notebook are written."""

from __future__ import annotations

import html
import math
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache

from haptonic import names
from haptonic.errors import HaptonicError
from haptonic.later import pandas as pd, xarray as xr
from haptonic.units import frequency_scale, share_form, to_si, uncertain

NOTHING = "-"  # text of an empty cell


@dataclass(frozen=True)
class Uncertain:
    """A value and the bound of its error, in the unit of the column; ``note`` is appended."""

    value: float
    error: float
    note: str = ""


@dataclass(frozen=True)
class Ranged:
    """Two ends of an interval, and optionally a value between them, in the unit of the column."""

    low: float
    high: float
    value: float | None = None


FIXED = re.compile(r"(\+?)\.(\d+)f")


# by unit and declared unit of a column: the unit for its largest value
SUITED: dict[tuple[str, str], Callable[[float], str]] = {
    ("Hz", "kHz"): lambda largest: frequency_scale(largest)[0],
    ("m", "mm"): lambda largest: "mm" if not 0 < largest < 5e-4 else "µm" if largest >= 5e-7 else "nm",
}
Cell = float | int | str | None | Uncertain | Ranged


@dataclass(frozen=True)
class Column:
    """Declaration of a column.

    name : its head; unit : SI unit of the values, empty for words and bare numbers
    shown : unit for people, by default the SI unit; form : number format, as in `format`
    of : variable of a dataset with the values and their unit, for `Table.of`; by default the name
    error : variable that bounds the errors of the values; ends : variables of the ends of their intervals
    """

    name: str
    unit: str = ""
    shown: str = ""
    form: str = ".4g"
    of: str = ""
    error: str = ""
    ends: tuple[str, str] | None = None

    def read(self, data: xr.Dataset, along: str) -> Iterator[tuple[Column, list[Cell]]]:
        """The column with its cells; for a second dimension one column per label, "{}" in the name."""
        array = data[self.of or self.name]
        column = replace(self, unit=array.attrs.get("units", "").removeprefix("1"))
        others = [str(dimension) for dimension in array.dims if dimension != along]
        for other in others:
            for number, label in enumerate(data[other].values.tolist()):
                cells = array.isel({other: number}).values.tolist()
                yield replace(column, name=self.name.format(label)), cells
        if others:
            return
        cells = array.values.tolist()
        if self.error:
            errors = data[self.error].values.tolist()
            cells = [
                cell if math.isnan(cell) else Uncertain(cell, error)
                for cell, error in zip(cells, errors, strict=True)
            ]
        if self.ends is not None:
            low, high = (data[end].values.tolist() for end in self.ends)
            cells = [Ranged(*three) for three in zip(low, high, cells, strict=True)]
        yield column, cells

    def suited(self, cells: Iterable[Cell]) -> Column:
        """The column with a unit that suits its cells, if they are too large, or lengths too small, for the
        declared unit: MHz for kHz, µm for mm."""
        if (self.unit, self.shown) not in SUITED:
            return self
        sizes = [abs(number) for cell in cells for number in _numbers_in(cell) if math.isfinite(number)]
        shown = SUITED[self.unit, self.shown](max(sizes, default=0.0))
        if shown == self.shown or not FIXED.fullmatch(self.form):
            return replace(self, shown=shown)
        # the smallest value may be below 1 in this unit: one more digit keeps its error visible
        return replace(
            self, shown=shown, form=FIXED.sub(lambda form: f"{form[1]}.{int(form[2]) + 1}f", self.form)
        )

    @property
    def head(self) -> str:
        """Name with the unit for people."""
        unit = self.shown or self.unit
        unit = f"({unit})" if self.name and "/" in unit else unit
        return f"{self.name} / {unit}" if self.name and unit else self.name or unit

    def text(self, cell: Cell) -> str:
        """Text of a cell for people."""
        scale = _scale(self.shown, self.unit) if self.shown else 1.0
        match cell:
            case None:
                return NOTHING
            case str():
                return cell
            case Uncertain(value, error, note):
                return f"{uncertain(value * scale, error * scale)}{note}"
            case Ranged(low, high, None):
                return f"{self._number(low * scale)} to {self._number(high * scale)}"
            case Ranged(low, high, value):
                rounded = replace(self, form=share_form(low, high)) if self.shown == "%" else self
                ends = f"{rounded._number(low * scale)} to {rounded._number(high * scale)}"
                return f"{rounded._number((value or 0.0) * scale)} ({ends})"
            case int():
                return str(cell)
        return self._number(cell * scale)

    def _number(self, value: float) -> str:
        return format(value, self.form) if math.isfinite(value) else NOTHING


@dataclass(frozen=True)
class Table:
    """Rows of raw values below a title.

    columns : declarations of the columns; a text is the head of a column of words
    rows : values in the units of the columns
    strong : numbers of emphasised rows, from 0
    """

    title: str
    columns: tuple[Column, ...]
    rows: tuple[tuple[Cell, ...], ...]
    strong: frozenset[int] = frozenset()

    def __init__(
        self,
        title: str,
        columns: Sequence[Column | str],
        rows: Sequence[Sequence[Cell]],
        strong: Sequence[int] = (),
    ) -> None:
        declared = tuple(Column(column) if isinstance(column, str) else column for column in columns)
        assert all(len(row) == len(declared) for row in rows), title
        declared = tuple(
            column.suited(cells)
            for column, cells in zip(declared, _columns(rows, len(declared)), strict=True)
        )
        assert all(column.head for column in declared), (
            f"{title}: every column needs a name for screen readers"
        )
        object.__setattr__(self, "title", title)
        object.__setattr__(self, "columns", declared)
        object.__setattr__(self, "rows", tuple(tuple(row) for row in rows))
        object.__setattr__(self, "strong", frozenset(strong))

    @classmethod
    def of(
        cls,
        title: str,
        data: xr.Dataset,
        along: str,
        columns: Sequence[Column | str],
        strong: Sequence[int] = (),
    ) -> Table:
        """Rows along a dimension of a dataset; see `Column.read` for the conversion of its variables."""
        read = [
            pair
            for column in columns
            for pair in (Column(column) if isinstance(column, str) else column).read(data, along)
        ]
        rows = list(zip(*(cells for _, cells in read), strict=True))
        return cls(title, [column for column, _ in read], rows, strong)

    @property
    def head(self) -> tuple[str, ...]:
        """Heads of the columns for people."""
        return tuple(column.head for column in self.columns)

    @property
    def texts(self) -> list[tuple[str, ...]]:
        """Rows as texts for people."""
        return [
            tuple(column.text(cell) for column, cell in zip(self.columns, row, strict=True))
            for row in self.rows
        ]

    def labelled(self, origin: str) -> Table:
        """The table with its origin, measured or simulated, in the title."""
        return Table(f"{self.title} ({origin})", self.columns, self.rows, tuple(self.strong))

    def of_columns(self, numbers: Sequence[int], title: str) -> Table:
        """Table of the columns with these numbers, from 0."""
        rows = [[row[number] for number in numbers] for row in self.rows]
        return Table(title, [self.columns[number] for number in numbers], rows, tuple(self.strong))

    def to_dataframe(self) -> pd.DataFrame:
        """Raw values in SI units; a value with an error or ends has a column for each of them."""
        return pd.DataFrame([self._record(row) for row in self.rows])

    def _record(self, row: Sequence[Cell]) -> dict[str, object]:
        record: dict[str, object] = {}
        for column, cell in zip(self.columns, row, strict=True):
            name = f"{column.name} ({column.unit})" if column.unit else column.name
            match cell:
                case Uncertain(value, error):
                    record |= {name: value, f"error of {name}": error}
                case Ranged(low, high, value):
                    record |= {name: value, f"low of {name}": low, f"high of {name}": high}
                case _:
                    record[name] = cell
        return record

    def written(self, form: str) -> str:
        """The table as text of a form, see `FORMS`; CSV has raw values in SI units, others texts for people.

        Raises
        ------
        HaptonicError : an unknown form
        """
        check_form(form)
        markup = FORMS[form]
        if markup.raw:
            records = [self._record(row) for row in self.rows]
            unknown = [Uncertain(math.nan, math.nan) if column.error else None for column in self.columns]
            head = tuple(
                dict.fromkeys(name for record in records or [self._record(unknown)] for name in record)
            )
            rows = [tuple(record.get(name) for name in head) for record in records]
        else:
            head, rows = self.head, list[tuple[object, ...]](self.texts)
        numeric = [bool(self.rows) and not isinstance(cell, str) for cell in (self.rows or (head,))[0]]
        return markup.frame.format(
            title=markup.safe(self.title),
            columns="".join("r" if number else "l" for number in numeric),
            head=markup.head.line(map(markup.safe, head)),
            rule=markup.row.line("---" for _ in head),
            body="".join(markup.row.line(map(markup.safe, row)) for row in rows),
        )


@dataclass(frozen=True)
class Line:
    """Texts before, between and behind the cells of a row."""

    before: str
    between: str
    behind: str

    def line(self, cells: Iterable[str]) -> str:
        """Row of cells that have been escaped."""
        return f"{self.before}{self.between.join(cells)}{self.behind}"


@dataclass(frozen=True)
class Markup:
    """Text format of tables.

    safe : escapes a value
    head, row : texts around the cells
    frame : whole table: ``title``, ``columns`` ("l" for words, "r" for numbers), ``head``, ``rule``, ``body``
    raw : True for raw values, False for texts for people
    """

    safe: Callable[[object], str]
    head: Line
    row: Line
    frame: str
    raw: bool = False


def _in_csv(value: object) -> str:
    if isinstance(value, float):
        value = float(f"{value:.12g}")  # 0.0065 for 0.006500000000000001
    text = "" if value is None else str(names.cell(value))
    return f'"{text.replace(chr(34), 2 * chr(34))}"' if set(text) & set(',"\r\n') else text


BARS = Line("| ", " | ", " |\n")
AMPERSANDS = Line("", " & ", " \\\\\n")
COMMAS = Line("", ",", "\n")
FORMS = {
    "csv": Markup(_in_csv, COMMAS, COMMAS, "{head}{body}", raw=True),
    "html": Markup(
        lambda text: html.escape(str(text)),
        Line("<tr><th>", "</th><th>", "</th></tr>"),
        Line("<tr><td>", "</td><td>", "</td></tr>"),
        "<table><caption>{title}</caption>{head}{body}</table>",
    ),
    "latex": Markup(
        lambda text: names.latex(str(text)),
        AMPERSANDS,
        AMPERSANDS,
        "\\begin{{table}}\n\\caption{{{title}}}\n\\begin{{tabular}}{{{columns}}}\n\\hline\n{head}\\hline\n{body}"
        "\\hline\n\\end{{tabular}}\n\\end{{table}}\n",
    ),
    "markdown": Markup(
        lambda text: re.sub(r"([\\|])", r"\\\1", str(text)), BARS, BARS, "**{title}**\n\n{head}{rule}{body}"
    ),
}


def check_form(form: object) -> None:
    """Raise HaptonicError for an unknown form of tables."""
    if form not in FORMS:
        raise HaptonicError.unknown("form of a table", form, FORMS, "tables are not written in this form")


@cache
def _scale(shown: str, unit: str) -> float:
    """Factor from a value in an SI unit to another unit."""
    return 100.0 if (shown, unit) == ("%", "") else 1.0 / to_si(f"1 {shown}", unit, shown)


def _columns(rows: Sequence[Sequence[Cell]], count: int) -> list[list[Cell]]:
    """Cells of each column."""
    return [[row[number] for row in rows] for number in range(count)]


def _numbers_in(cell: Cell) -> tuple[float, ...]:
    """Values of a cell, without error bounds."""
    match cell:
        case Uncertain(value, _, _):
            return (value,)
        case Ranged(low, high, _):
            return low, high
        case int() | float():
            return (float(cell),)
    return ()
