"""Text tables (CSV): a line of names, perhaps with units in brackets, and numbers below it.

Columns are parted by commas, semicolons or tabs; between the others a decimal comma is read too. Lines that
begin with "#" are comments, and so is a title above the names; a comment that says "simulated", or a column
``origin`` that does, marks the file.
"""

from __future__ import annotations

import codecs
import csv
import io
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from haptonic.channels.notes import Notebook
from haptonic.channels.signals import ORIGIN, SIMULATED, Channel, Group, Samples
from haptonic.errors import ChannelError
from haptonic.later import pandas as pd
from haptonic.names import cell, from_cell
from haptonic.paths import source

HEAD = 20  # lines in which comments and the names are looked for
MISSING = ("", "NA", "N/A", "n/a", "NaN", "nan", "-nan", "<NA>", "NULL", "null", "None", "none")
UNEVEN = "uneven_line"  # property: number of the first line with another number of cells than the names
# the last pair of brackets, which may hold others: "Fz (mN)", "real ((m/s)/V)"
_UNIT = re.compile(r"(?P<name>.*?)\s*[\[(](?P<unit>(?:[^()\[\]]|\([^()]*\))*)[\])]\s*")


def read(path: Path, notes: Notebook) -> dict[str, Group]:
    """The columns as channels of the one group "".

    Raises
    ------
    ChannelError : no table, or bytes that no text has
    OSError : there is no such file, or it may not be read
    """
    text = text_of(path).replace("\r\n", "\n").replace("\r", "\n")
    lines = text.split("\n", HEAD)[:HEAD]
    comments = " ".join(line.lower() for line in lines if line.startswith("#"))
    above, names, separator = _names(lines)
    below = lines[above:] + text.split("\n", HEAD)[HEAD:]
    text = "\n" * above + "\n".join(below)  # lines keep their numbers
    # spreadsheets write rows of empty cells below a table
    end = text.find("\n", len(text.rstrip(f"{separator} \t\r\n")))
    text = text if end < 0 else text[:end]
    uneven = _uneven_line(path, text, names, separator)
    decimal = "," if separator != "," and re.search(r"[0-9],[0-9]", text) else "."
    try:
        # without index_col, a separator behind every row would put each column below the name of the next
        table = pd.read_csv(
            io.StringIO(text), sep=separator, decimal=decimal, comment="#", skipinitialspace=True,
            index_col=False, usecols=lambda name: True,
        )  # fmt: skip
    except pd.errors.EmptyDataError as error:
        raise _no_table(path, "no columns") from error
    except ValueError as error:  # of which pandas' other errors are kinds
        raise _no_table(path, str(error)) from error
    simulated = SIMULATED in comments or (ORIGIN in table and bool((table[ORIGIN] == SIMULATED).any()))
    properties: dict[str, Any] = {ORIGIN: SIMULATED} if simulated else {}
    if uneven is not None:
        properties[UNEVEN] = uneven
    channels = {}
    for head in map(str, table.columns):
        found = _UNIT.fullmatch(head)
        name, unit = (found["name"], found["unit"].strip()) if found else (head, "")
        # words in a column are a fault of its numbers, which whoever asks for them hears of
        if name != ORIGIN:
            values = table[head].to_numpy()
            channels[name] = Channel(name, values.shape, _from(values), unit=unit, streamed=False)
    return {"": Group("", channels, properties)}


def heads(path: Path) -> list[str]:
    """Names of the columns, with what stands in brackets behind them.

    Raises
    ------
    ChannelError : bytes that no text has
    OSError : there is no such file, or it may not be read
    """
    _, line, separator = _names(re.split(r"\r\n|\r|\n", text_of(path), maxsplit=HEAD)[:HEAD])
    return [name.strip(' "') for name in line.split(separator)]


def _names(lines: Sequence[str]) -> tuple[int, str, str]:
    """How many lines stand above that of the names, this line, and what parts its columns."""
    said = [(k, line) for k, line in enumerate(lines) if line.strip() and not line.startswith("#")]
    # a title has no columns; where nothing has, there is one column
    above, names = next((one for one in said if re.search(r"[;,\t]", one[1])), [*said, (0, "")][0])
    return above, names, ";" if names.count(";") > names.count(",") else "\t" if "\t" in names else ","


def _from(values: Samples) -> Any:
    return lambda first, last: values[first:last]


def _uneven_line(path: Path, text: str, heads: str, separator: str) -> int | None:
    """The first line with fewer cells than there are names, or with empty ones behind them.

    Raises
    ------
    ChannelError : a line with a number behind the last name: pandas would leave it out
    """
    expected, first = heads.count(separator), None
    for number, line in enumerate(text.split("\n"), start=1):
        if line.count(separator) == expected or '"' in line or not line.strip() or line.startswith("#"):
            continue
        if line.rstrip(f"{separator} \t\r").count(separator) > expected:
            raise _no_table(path, f"line {number} has more cells than the line of names")
        first = first or number
    return first


def columns(path: Path, texts: Sequence[str]) -> dict[str, Samples]:
    """Columns of a table of words and numbers; those in ``texts`` hold words, whatever these look like.

    Raises
    ------
    ChannelError : no table, or bytes that no text has
    OSError : there is no such file, or it may not be read
    """
    text = text_of(path)
    try:
        heads = [str(name) for name in pd.read_csv(io.StringIO(text), nrows=0).columns]
        # "NA" and "None" are missing numbers, but names of people and guides
        missing = {name: MISSING for name in heads if name not in texts}
        table = pd.read_csv(
            io.StringIO(text), dtype=dict.fromkeys(texts, str), keep_default_na=False, na_values=missing
        )
    except ValueError as error:
        raise _no_table(path, str(error)) from error
    for name in set(texts) & set(heads):
        table[name] = table[name].map(from_cell)
    return {str(name): table[name].to_numpy() for name in table.columns}


def text_of(path: Path) -> str:
    """The text of a file, which names or units in the code page of an older program do not spoil.

    Raises
    ------
    ChannelError : it holds bytes that no text has, or is no file that ends
    OSError : there is no such file, or it may not be read
    """
    try:
        content = source(path, path.name, ChannelError).read_bytes()
    except ChannelError as error:
        raise _no_table(path, error.cause) from error
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):  # a spreadsheet's "Unicode text"
        text = content.decode("utf-16", errors="replace")
    else:
        try:
            text = content.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = content.decode("latin-1")
    if "\0" in text:
        raise _no_table(path, "bytes that no text has")
    return text


def write(path: Path, table: Mapping[str, Sequence[Any] | Samples]) -> None:
    """Write columns below their names; text that a spreadsheet would compute is made safe."""
    rows = zip(*(_plain(column) for column in table.values()), strict=True)
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(map(cell, table))
        writer.writerows(rows)


def _plain(column: Sequence[Any] | Samples) -> list[Any]:
    if isinstance(column, np.ndarray) and column.dtype.kind in "fiu":
        return list(column.tolist())
    return [cell(value) for value in column]


def _no_table(path: Path, found: str) -> ChannelError:
    return ChannelError.unreadable(
        argument=path.name,
        given=found,
        allowed="a text table: a line of names, and rows of as many numbers below it",
        cause="it is damaged, or saved in another format than its name says",
        next_step="open it in a text editor to see",
    )
