"""Text tables (CSV) as channels, and as columns of words and numbers; `text_table` reads them.

A file is simulated if a comment above its rows, or a column ``origin``, contains "simulated".
"""

from __future__ import annotations

import csv
from collections.abc import Callable, Collection, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from haptonic.channels.dialect import is_comment
from haptonic.channels.notes import Notebook
from haptonic.channels.signals import ORIGIN, SIMULATED, Channel, Group, Kind, Samples
from haptonic.channels.text_table import TextColumn, TextTable, missing_as_nan, read_table
from haptonic.names import cell

HEAD = 20  # lines in which a comment may mark a file as simulated
UNEVEN = "uneven_line"  # property: number of the first line with fewer cells than columns
NAMES_LINE = "names_line"  # property: number of the line of names; missing for a table without names
FIRST_ROW = "first_row"  # property: cells of the first row, as in the file
TITLES = "titles"  # property: lines above the table


def read(path: Path, notes: Notebook, texts: Collection[str] = (), skip: int = 0) -> dict[str, Group]:
    """Read the columns as channels of a single group ""; without names they are called 1, 2, ...

    Parameters
    ----------
    texts : names of columns that contain words, even if these look like numbers
    skip : number of lines at the top before the table

    Raises
    ------
    ChannelError : no table, or bytes that are not text
    OSError : no such file, or no right to read it
    """
    table = read_table(path, texts=texts, skip=skip)
    for remark in table.remarks:
        notes.remark(f"{path.name}: {remark}")
    comments = " ".join(line.lower() for line in table.titles[:HEAD] if is_comment(line))
    columns = table.columns_by_name
    origin = columns.pop(ORIGIN, None)
    simulated = SIMULATED in comments or (origin is not None and bool((origin.values == SIMULATED).any()))
    properties: dict[str, Any] = {FIRST_ROW: table.first_row, TITLES: table.titles}
    properties |= {ORIGIN: SIMULATED} if simulated else {}
    properties |= {UNEVEN: table.short[0]} if table.short else {}
    properties |= {NAMES_LINE: table.names_line} if table.names_line else {}
    channels = {name: _channel(table, name, column) for name, column in columns.items()}
    return {"": Group("", channels, properties)}


def _channel(table: TextTable, name: str, column: TextColumn) -> Channel:
    kind: Kind = "complex" if column.values.dtype.kind == "c" else "number"
    return Channel(
        name, column.values.shape, _rows(table, column), kind=kind, unit=column.unit, streamed=False
    )


def _rows(table: TextTable, column: TextColumn) -> Callable[[int, int], Samples]:
    # a word in a column of numbers raises an error when the numbers are used, not before
    def rows(first: int, last: int) -> Samples:
        return (column.values if column.is_text else table.numbers(column))[first:last]

    return rows


def columns(path: Path, texts: Collection[str]) -> dict[str, Samples]:
    """Read columns of words and numbers, by the full text of their headings.

    Columns in ``texts`` contain words, even if these look like numbers; in others an empty cell is NaN.

    Raises
    ------
    ChannelError : no table, or bytes that are not text
    OSError : no such file, or no right to read it
    """
    table = read_table(path, texts=texts)
    # a column of numbers with a word in a cell becomes a column of words
    mixed = [column.heading.text for column in table.columns if column.bad]
    if mixed:
        table = read_table(path, texts=[*texts, *mixed])
    text_names = {text.casefold() for text in texts}
    return {
        name if column.name == name and not column.unit else column.heading.text or name: _plain_column(
            column, text_names
        )
        for name, column in table.columns_by_name.items()
    }


def _plain_column(column: TextColumn, texts: Collection[str]) -> Samples:
    """Texts, floats, or integers if all numbers are whole."""
    values = column.values
    if column.is_text:
        return values if column.name.casefold() in texts else missing_as_nan(column)
    if values.dtype.kind == "f" and np.isfinite(values).all() and (np.abs(values) < 2**53).all():
        whole = values.astype(np.int64)
        return whole if len(values) and (whole == values).all() else values
    return values


def write(path: Path, table: Mapping[str, Sequence[Any] | Samples]) -> None:
    """Write columns below their names; text that a spreadsheet would evaluate is escaped."""
    rows = zip(*(_plain(column) for column in table.values()), strict=True)
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(map(cell, table))
        writer.writerows(rows)


def _plain(column: Sequence[Any] | Samples) -> list[Any]:
    if isinstance(column, np.ndarray) and column.dtype.kind in "fiu":
        return list(column.tolist())
    return [cell(value) for value in column]
