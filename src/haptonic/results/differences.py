"""Differences of the tables of two results, number by number, with their errors."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

from haptonic.results.table import NOTHING, Cell, Column, Ranged, Table, Uncertain

HEAD = ("row", "quantity", "first", "second", "difference", "compared with the errors")
WITHIN, BEYOND, UNKNOWN = "within the errors", "beyond the errors", "no errors are given"
NUMBER = re.compile(r"-?\d[\d.,]*(?:e[-+]?\d+)?")


def differences(first: Sequence[Table], second: Sequence[Table]) -> list[Table]:
    """A table of differences for each pair of tables; ``strong`` are those beyond the errors.

    Titles of a pair differ at most in numbers, such as the frequency of a drive. Rows belong together if all
    their words agree, or else by their number. Equal numbers are left out. A last table lists the titles that
    only one of the two has, if there are any.
    """
    tables, left = [], list(second)
    alone: list[tuple[str, str]] = []
    for before in first:
        alike = [t for t in left if NUMBER.sub("0", t.title) == NUMBER.sub("0", before.title)]
        after = min(alike, key=lambda t: t.title != before.title, default=None)
        if after is None:
            alone.append((before.title, "first"))
            continue
        left.remove(after)
        rows = list(_rows(before, after))
        strong = [number for number, row in enumerate(rows) if row[-1] == BEYOND]
        titles = dict.fromkeys((before.title, after.title))
        tables.append(Table(f"differences: {' and '.join(titles)}", HEAD, rows, strong))
    alone += [(table.title, "second") for table in left]
    if alone:
        tables.append(Table("tables that only one of the runs has", ("table", "run"), alone))
    return tables


def _rows(first: Table, second: Table) -> Iterator[tuple[str, ...]]:
    """Texts of the numbers that differ; those of a row that only one of the two has are all listed."""
    columns = {column.name: place for place, column in enumerate(second.columns)}
    shared = [
        (place, columns[column.name], column)
        for place, column in enumerate(first.columns)
        if column.name in columns and second.columns[columns[column.name]].unit == column.unit
    ]
    ours, theirs = _keyed(first, second)
    for key in dict.fromkeys([*ours, *theirs]):
        for here, there, column in shared:
            before = ours[key][here] if key in ours else None
            after = theirs[key][there] if key in theirs else None
            if before == after or isinstance(before or after, str):
                continue
            yield key, column.head, *_compared(column, before, after)


def _keyed(first: Table, second: Table) -> tuple[dict[str, tuple[Cell, ...]], dict[str, tuple[Cell, ...]]]:
    """Rows of both tables by their words, or by their number if the words of a table are not unique."""
    keys = [
        [", ".join(cell for cell in row if isinstance(cell, str)) for row in table.rows]
        for table in (first, second)
    ]
    if any(len(set(each)) < len(each) or "" in each for each in keys):
        keys = [[str(number) for number, _ in enumerate(each, start=1)] for each in keys]
    ours, theirs = (
        dict(zip(each, table.rows, strict=True)) for each, table in zip(keys, (first, second), strict=True)
    )
    return ours, theirs


def _compared(column: Column, before: Cell, after: Cell) -> tuple[str, str, str, str]:
    texts = column.text(before), column.text(after)
    (low, error), (high, second_error) = _parts(before), _parts(after)
    if low is None or high is None:
        return *texts, NOTHING, NOTHING
    change = high - low
    if error is None or second_error is None:
        return *texts, column.text(change), UNKNOWN
    bound = error + second_error
    return *texts, column.text(Uncertain(change, bound)), WITHIN if abs(change) <= bound else BEYOND


def _parts(cell: Cell) -> tuple[float | None, float | None]:
    """Value of a cell and the bound of its error; None for a missing one."""
    match cell:
        case Uncertain(value, error):
            return _finite(value), error
        case Ranged(low, high, value):
            middle = (low + high) / 2 if value is None else value
            return _finite(middle), max(high - middle, middle - low)
        case int() | float():
            return _finite(float(cell)), None
    return None, None


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
