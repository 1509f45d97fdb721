"""Universal files (UFF): curves (data sets 58 and 58b), points, shapes, units and lines.

pyuff 2.5 reads all but the curves: of 1,993 curves in 800 files that had lost one line, it returned 427 with
too few or too many values without an error; here such a curve is refused by name. See `uff_blocks` for more.
"""

from __future__ import annotations

import importlib
import mmap
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.channels.notes import Notebook
from haptonic.channels.signals import ORIGIN, SIMULATED, Channel, Group, Samples
from haptonic.channels.uff_blocks import (
    Buffer,
    DataSet,
    Header,
    UnreadableError,
    blocks_of,
    header_of,
    values_of,
)
from haptonic.foreign.process import damaged


def _extracted(kind: int, text: str) -> dict[str, Any]:
    """Fields of a data set from its text, by pyuff's function for its kind, imported on first use.

    pyuff.UFF reads text from a file only: one file for each of thousands of data sets would take half a
    minute.
    """
    reader = getattr(importlib.import_module(f"pyuff.datasets.dataset_{kind}"), f"_extract{kind}")
    fields: dict[str, Any] = reader(text)
    return fields


# data sets read by pyuff, each by a function of its text
READERS = {kind: partial(_extracted, kind) for kind in (15, 55, 82, 151, 164, 2411, 2412)}
PASSED_OVER = {18, 1858, 2400, 2420, 2429, 2467, 58259}  # known types that a scan does not need
NAMES = {
    0: "general function", 1: "time record", 2: "auto spectrum", 3: "cross spectrum",
    4: "frequency response", 5: "transmissibility", 6: "coherence", 7: "auto correlation",
    9: "power spectral density", 12: "spectrum",
}  # fmt: skip
TIME = 1  # the function of a time record
LARGEST_NUMBER = 1e10  # of a point: a field of ten columns has no larger one
SAYS_SIMULATED = "origin: simulated"  # a line of a curve's header


@dataclass(frozen=True, eq=False)
class Function:
    """A curve of a file. Its numbers stay in the file, in the file's units, until `values` reads them."""

    path: Path
    block: DataSet
    header: Header
    begin: int

    @property
    def source(self) -> str:
        return self.block.name

    def values(self) -> tuple[Array, NDArray[Any]]:
        """Read abscissa and ordinate.

        Raises
        ------
        UnreadableError : fewer values than announced, or text between them
        """
        with _mapped(self.path) as data:
            return values_of(self.block, self.header, self.begin, data)

    def rows(self, first: int, last: int) -> Samples:
        """Read a part of the ordinate.

        Raises
        ------
        ChannelError : the curve cannot be read
        """
        try:
            return self.values()[1][first:last]
        except UnreadableError as error:
            raise damaged(self.path, f"{self.source}: {error}") from error

    @property
    def kind(self) -> str:
        return NAMES.get(self.header.function, f"function of type {self.header.function}")


@dataclass(frozen=True, eq=False)
class UffContents:
    """Content of a universal file.

    functions : curves, data sets 58 and 58b
    nodes : positions, (3,) m, by number; data sets 15 and 2411
    shapes : as pyuff returns them, data set 55
    lines : numbers of points to join, data set 82
    length, force : units of the file in one SI unit, from data set 164; None without one
    notes : content that was not read
    """

    functions: tuple[Function, ...]
    nodes: dict[int, Array]
    shapes: tuple[dict[str, Any], ...]
    lines: tuple[NDArray[np.int64], ...]
    length: float | None
    force: float | None
    title: str
    notes: Notebook

    @property
    def simulated(self) -> bool:
        """True if a curve is marked as simulated."""
        return any(SAYS_SIMULATED in line for function in self.functions for line in function.header.lines)


def uff_contents(path: Path, notes: Notebook | None = None) -> UffContents:
    """Read all content of a universal file. The notes list data sets that cannot be read."""
    notes = Notebook(path, "UFF") if notes is None else notes
    functions: list[Function] = []
    small: dict[int, list[dict[str, Any]]] = {kind: [] for kind in READERS}
    with _mapped(path) as data:
        for block in blocks_of(data):
            try:
                if block.kind == 58:
                    header, begin = header_of(block, data)
                    functions.append(Function(path, block, header, begin))
                elif block.kind in READERS and block.closed and not data[block.begin : block.end].strip():
                    continue  # vendors write an empty one if they have nothing for it
                elif block.kind in READERS:
                    small[block.kind].append(_by_pyuff(block, data))
                    if not block.closed:
                        notes.remark(f"{block.name}: its end is missing")
                elif block.kind not in PASSED_OVER:
                    notes.drop(block.name, "a type that haptonic does not use")
            except UnreadableError as error:
                notes.drop(block.name, str(error))
    length = force = None
    for units in small[164]:
        length, force = float(units["length"]), float(units["force"])
    if length is not None and not (np.isfinite(length) and length > 0 and force and force > 0):
        notes.drop("units (type 164)", f"a factor of {length:g} for the length is impossible")
        length = force = None
    nodes: dict[int, Array] = {}
    for table in small[15] + small[2411]:
        _add_nodes(table, 1.0 if length is None else length, nodes, notes)
    title = next((str(header.get("model_name", "")) for header in small[151]), "")
    lines = tuple(line for table in small[82] if (line := _line(table, notes)) is not None)
    return UffContents(
        functions=tuple(functions),
        nodes=nodes,
        shapes=tuple(small[55]),
        lines=lines,
        length=length,
        force=force,
        title=title.replace("NONE", ""),
        notes=notes,
    )


def read(path: Path, notes: Notebook) -> dict[str, Group]:
    """Read the time records as channels of a single group "", named by response or by data set.

    Raises
    ------
    OSError : no such file, or no right to read it
    """
    contents = uff_contents(path, notes)
    records = [curve for curve in contents.functions if curve.header.function == TIME and curve.header.even]
    names = [record.header.response_name or record.header.over.label for record in records]
    single = {name for name, times in Counter(names).items() if times == 1 and name}
    channels = {}
    for function, name in zip(records, names, strict=True):
        header, name = function.header, name if name in single else function.source
        rate = 1 / header.step if header.step > 0 else 0.0
        channels[name] = Channel(
            name, (header.count,), function.rows, unit=header.over.unit, rate=rate, start=header.first
        )
    return {"": Group("", channels, {ORIGIN: SIMULATED} if contents.simulated else {})}


def scaled(contents: UffContents, length_unit: float) -> UffContents:
    """A copy with coordinates read in another unit, given in m."""
    factor = length_unit * (contents.length or 1.0)
    contents.notes.remark(f"coordinates were read in units of {length_unit:g} m, as requested")
    return replace(contents, nodes={number: factor * place for number, place in contents.nodes.items()})


def _by_pyuff(block: DataSet, data: Buffer) -> dict[str, Any]:
    """Read one small data set by pyuff; node by node if pyuff fails."""
    if not block.closed and block.kind not in (15, 2411):
        raise UnreadableError("its end is missing")
    content = data[block.begin : block.end]
    text = content.rstrip().decode("utf-8", "replace")
    try:
        fields = READERS[block.kind](f"    -1\n{block.kind:6d}\n{text}\n")
    except Exception as error:  # pyuff converts every error into a plain Exception
        _raise_unrelated_cause(error)
        if block.kind in (15, 2411):
            return _nodes_line_by_line(block, content)
        raise UnreadableError("pyuff cannot read it: it is damaged, or not of the standard form") from error
    lengths = {len(fields[name]) for name in ("node_nums", "x", "y", "z") if name in fields}
    if block.kind in (15, 2411) and len(lengths) > 1:
        return _nodes_line_by_line(block, content)
    return dict(fields)


def _raise_unrelated_cause(error: BaseException) -> None:
    """Raise the cause of pyuff's exception if it is not a fault of the text."""
    cause: BaseException | None = error
    while cause is not None:
        if isinstance(cause, MemoryError | OSError | KeyboardInterrupt):
            raise cause
        cause = cause.__context__


def _nodes_line_by_line(block: DataSet, content: bytes) -> dict[str, Any]:
    """Read the complete nodes."""
    words = [line.decode("ascii", "replace").replace("D", "E").split() for line in content.splitlines()]
    if block.kind == 2411:
        words = [first + second for first, second in zip(words[::2], words[1::2], strict=False)]
    rows = []
    for row in words:
        try:
            rows.append((int(row[0]), *(float(part) for part in row[4:7])) if len(row) == 7 else None)
        except ValueError:
            rows.append(None)
    whole = [row for row in rows if row is not None and len(row) == 4]
    if not whole:
        raise UnreadableError("it has no complete node")
    columns = dict(zip(("node_nums", "x", "y", "z"), zip(*whole, strict=True), strict=True))
    return columns | {"broken": len(rows) - len(whole)}


def _line(table: dict[str, Any], notes: Notebook) -> NDArray[np.int64] | None:
    """Numbers of the points that a line joins, 0 where it is interrupted."""
    numbers = np.asarray(table["nodes"], dtype=float)
    if not (np.abs(numbers) < LARGEST_NUMBER).all():
        notes.drop("line (type 82)", "it joins points of impossible numbers")
        return None
    return numbers.astype(np.int64)


def _add_nodes(table: dict[str, Any], length: float, nodes: dict[int, Array], notes: Notebook) -> None:
    if table.get("broken"):
        notes.drop("points (geometry)", f"{table['broken']} that are cut short or not numbers")
    rows = np.column_stack([np.asarray(table[name], dtype=float) for name in ("node_nums", "x", "y", "z")])
    for number, *place in rows:
        if not 0 <= number < LARGEST_NUMBER:
            notes.drop(f"point {number:g} (geometry)", "not a possible number of a point")
        elif not np.isfinite(place).all():
            notes.drop(f"point {number:g} (geometry)", "coordinates that are not finite")
        elif int(number) in nodes and not np.allclose(nodes[int(number)], np.array(place) / length):
            notes.drop(f"point {number:g} (geometry)", "repeated at another position; the first is used")
        else:
            nodes.setdefault(int(number), np.array(place) / length)


@contextmanager
def _mapped(path: Path) -> Iterator[Buffer]:
    with path.open("rb") as file:
        if path.stat().st_size == 0:
            yield b""
            return
        with mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
            yield data
