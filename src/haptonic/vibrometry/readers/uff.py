"""Universal files (UFF): curves, points, shapes, units and lines, and the scan that they make."""

from __future__ import annotations

import importlib
import mmap
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.response import Reference
from haptonic.vibrometry.curves import AXES, Curve, Place
from haptonic.vibrometry.findings import Notebook
from haptonic.vibrometry.labels import Label, Motion, Ratio, label_of, ratio_of
from haptonic.vibrometry.readers.blocks import (
    Block,
    Buffer,
    Header,
    UnreadableError,
    blocks_of,
    header_of,
    values_of,
)

Array = NDArray[np.float64]

# Data sets that pyuff reads, each by a function of its text. pyuff.UFF takes the text from a file only: one
# file for each of thousands of data sets would take half a minute.
READERS = {
    kind: getattr(importlib.import_module(f"pyuff.datasets.dataset_{kind}"), f"_extract{kind}")
    for kind in (15, 55, 82, 151, 164, 2411, 2412)
}
PASSED_OVER = {18, 1858, 2400, 2420, 2429, 2467, 58259}  # known, and nothing that a scan needs
NAMES = {
    0: "general function", 1: "time record", 2: "auto spectrum", 3: "cross spectrum",
    4: "frequency response", 5: "transmissibility", 6: "coherence", 7: "auto correlation",
    9: "power spectral density", 12: "spectrum",
}  # fmt: skip
RESPONSES = {4: "response", 5: "response", 12: "response", 6: "coherence"}
MOTIONS: dict[int, Motion] = {8: "displacement", 11: "velocity", 12: "acceleration"}
REFERENCES = {9: "N", 13: "N", 15: "Pa"}
LARGEST_NUMBER = 1e10  # of a point: a field of ten columns holds no larger one
LARGEST_PLATE = 10.0  # m; a larger one is in mm without saying so


@dataclass(frozen=True, eq=False)
class Function:
    """A curve of a file. Its numbers stay there, in the units of the file, until `values` reads them."""

    path: Path
    block: Block
    header: Header
    begin: int

    @property
    def source(self) -> str:
        return self.block.name

    def values(self) -> tuple[Array, NDArray[Any]]:
        """Abscissa and ordinate.

        Raises
        ------
        UnreadableError : fewer values than announced, or text between them
        """
        with _mapped(self.path) as data:
            return values_of(self.block, self.header, self.begin, data)

    @property
    def kind(self) -> str:
        return NAMES.get(self.header.function, f"function of type {self.header.function}")


@dataclass(frozen=True, eq=False)
class UffContents:
    """All that was read of a universal file.

    functions : curves, data sets 58 and 58b
    nodes : positions, (3,) m, by number; data sets 15 and 2411
    shapes : as pyuff gives them, data set 55
    lines : numbers of points to join, data set 82
    length, force : units of the file in one SI unit, from data set 164; None if it has none
    notes : what was not read
    """

    functions: tuple[Function, ...]
    nodes: dict[int, Array]
    shapes: tuple[dict[str, Any], ...]
    lines: tuple[NDArray[np.int64], ...]
    length: float | None
    force: float | None
    title: str
    notes: Notebook


def uff_contents(path: Path) -> UffContents:
    """Everything that a universal file holds. A data set that cannot be read is named in the notes."""
    notes = Notebook(path, "UFF")
    functions: list[Function] = []
    small: dict[int, list[dict[str, Any]]] = {kind: [] for kind in READERS}
    with _mapped(path) as data:
        for block in blocks_of(data):
            try:
                if block.kind == 58:
                    header, begin = header_of(block, data)
                    functions.append(Function(path, block, header, begin))
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
        tuple(functions), nodes, tuple(small[55]), lines, length, force, title.replace("NONE", ""), notes
    )


def curves_of(contents: UffContents) -> tuple[list[Curve], dict[str, Place]]:
    """Responses and coherences in SI units, and the places of the points. What is neither is named."""
    notes = contents.notes
    if contents.length is None:
        notes.remark("no data set 164: lengths without a unit were taken as m, forces as N")
    places = {str(n): Place(float(p[0]), float(p[1])) for n, p in contents.nodes.items()}
    extent = max((abs(v) for p in places.values() for v in (p.x, p.y)), default=0.0)
    if extent > LARGEST_PLATE:
        notes.remark(f"points lie {extent:g} m from the origin: they are probably in mm; give length_unit")
    curves = [curve for function in contents.functions if (curve := _curve(function, contents))]
    curves += [curve for shape in _frequency_shapes(contents) for curve in shape]
    # a point whose curve cannot be used was measured all the same: it is named among what was dropped
    measured = {curve.point for curve in curves} | {str(f.header.response_node) for f in contents.functions}
    if measured & places.keys():
        notes.missing.extend(name for name in places if name not in measured)
    return curves, places


def scaled(contents: UffContents, length_unit: float) -> UffContents:
    """The same with coordinates taken in another unit, given in m."""
    factor = length_unit * (contents.length or 1.0)
    contents.notes.remark(f"coordinates taken in units of {length_unit:g} m, as asked")
    return replace(contents, nodes={number: factor * place for number, place in contents.nodes.items()})


def _curve(function: Function, contents: UffContents) -> Curve | None:
    header, notes = function.header, contents.notes
    kind = RESPONSES.get(header.function)
    node = header.response_node
    name = str(node) if node else header.response_name
    if kind is None:  # time records make a scan of their own, see `uff_time`
        notes.drop(f"{function.source}, point {name or '?'}", f"a {function.kind}, not a frequency response")
        return None
    if not name:
        notes.drop(function.source, "it does not say at which point it was measured")
        return None
    if abs(header.response_axis) > 3:
        notes.drop(f"point {name} ({function.source})", "a rotation, not a motion along x, y or z")
        return None
    if header.response_axis == 0:
        notes.remark("curves without a direction were taken as z, normal to the plate")
    axis = header.response_axis or 3
    common = (function.source, name, axis)
    try:
        abscissa, ordinate = function.values()
    except UnreadableError as error:
        notes.drop(f"point {name} ({function.source})", str(error))
        return None
    if kind == "coherence":
        return Curve(*common, "coherence", abscissa, np.real(ordinate), "velocity", Reference())
    ratio = ratio_in(header, contents)
    if ratio.over.motion is None:
        found = header.over.unit or header.over.label or f"type {header.over.kind}"
        notes.drop(
            f"point {name} ({function.source})", f'"{found}" is no displacement, velocity or acceleration'
        )
        return None
    if np.isrealobj(ordinate):
        notes.drop(f"point {name} ({function.source})", "real numbers: the phase is missing")
        return None
    reference = reference_of(header, ratio.under)
    values = ordinate * ratio.factor
    if header.reference_axis < 0:
        values = -values  # driven against the axis
    return Curve(*common, "response", abscissa, values, ratio.over.motion, reference)


def ratio_in(header: Header, contents: UffContents) -> Ratio:
    """Units of the ordinate: as they are labelled, else by data type and the units of the file."""
    ratio = ratio_of(header.over.unit)
    over, under = ratio.over, ratio.under
    notes, length, force = contents.notes, contents.length or 1.0, contents.force or 1.0
    typed = MOTIONS.get(header.over.kind)
    if over.motion is None and typed is not None and not over.unit:
        over = Label(typed, "", 1 / length)
    elif typed is not None and over.motion is not None and typed != over.motion:
        notes.remark(f'a curve of type {typed} has the unit "{header.over.unit}"; the unit was believed')
    elif over.motion is not None and contents.length not in (None, 1.0):
        assert contents.length is not None
        if not np.isclose(over.factor * contents.length, 1.0):
            notes.remark(f'the unit "{header.over.unit}" is not that of data set 164; the unit was believed')
    if not under.unit:
        under = label_of(header.under.unit)
    if not under.unit and header.under.kind in REFERENCES:
        under = Label(None, REFERENCES[header.under.kind], 1 / force if header.under.kind != 15 else 1.0)
    return Ratio(over, under)


def reference_of(header: Header, under: Label) -> Reference:
    if not under.unit:
        return Reference()
    name = header.reference_name or header.under.label
    if header.reference_node:
        name = f"{header.reference_node}{AXES.get(abs(header.reference_axis), '')}"
    return Reference(name or "reference", under.unit)


def _frequency_shapes(contents: UffContents) -> Iterator[list[Curve]]:
    """Shapes at given frequencies (data set 55, analysis type 5) as curves over their frequencies."""
    table: dict[tuple[int, int], list[tuple[float, complex]]] = {}
    motion: Motion | None = None
    for shape in contents.shapes:
        motion = MOTIONS.get(int(shape["spec_data_type"]))
        if int(shape["analysis_type"]) != 5 or motion is None:
            contents.notes.drop("shape (type 55)", "a mode shape or of an unknown quantity, no response")
            continue
        lengths = {len(shape[name]) for name in ("node_nums", "r1", "r2", "r3")}
        if len(lengths) != 1 or not 0 <= float(shape["freq"]) < np.inf:
            contents.notes.drop("shape (type 55)", "cut short, or at an impossible frequency")
            continue
        factor = 1 / (contents.length or 1.0)
        for axis in (1, 2, 3):
            values = np.asarray(shape[f"r{axis}"])
            for node, value in zip(shape["node_nums"], values, strict=True):
                table.setdefault((int(node), axis), []).append((float(shape["freq"]), factor * value))
    still = {axis: all(v == 0 for (_, a), row in table.items() if a == axis for _, v in row) for axis in AXES}
    for (node, axis), row in table.items():
        if still[axis]:  # a laser fills the directions that it does not measure with zeros
            continue
        row.sort(key=lambda pair: pair[0])
        lines, values = np.array([f for f, _ in row]), np.array([v for _, v in row], dtype=complex)
        assert motion is not None
        yield [Curve("shapes (type 55)", str(node), axis, "response", lines, values, motion, Reference())]


def _by_pyuff(block: Block, data: Buffer) -> dict[str, Any]:
    """One small data set, read by pyuff; node by node where pyuff gives up."""
    if not block.closed and block.kind not in (15, 2411):
        raise UnreadableError("its end is missing")
    content = data[block.begin : block.end]
    text = content.rstrip().decode("utf-8", "replace")
    try:
        made = READERS[block.kind](f"    -1\n{block.kind:6d}\n{text}\n")
    except Exception as error:  # pyuff turns whatever happens to it into a plain Exception
        _raise_what_no_file_is_to_blame_for(error)
        if block.kind in (15, 2411):
            return _nodes_line_by_line(block, content)
        raise UnreadableError("pyuff cannot read it: it is damaged, or not of the standard form") from error
    lengths = {len(made[name]) for name in ("node_nums", "x", "y", "z") if name in made}
    if block.kind in (15, 2411) and len(lengths) > 1:
        return _nodes_line_by_line(block, content)
    return dict(made)


def _raise_what_no_file_is_to_blame_for(error: BaseException) -> None:
    """Raise what pyuff's exception hides, if it is no fault of the text that it read."""
    cause: BaseException | None = error
    while cause is not None:
        if isinstance(cause, MemoryError | OSError | KeyboardInterrupt):
            raise cause
        cause = cause.__context__


def _nodes_line_by_line(block: Block, content: bytes) -> dict[str, Any]:
    """The nodes that are whole."""
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
        raise UnreadableError("no node of it is whole")
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
            notes.drop(f"point {number:g} (geometry)", "no number that a point can have")
        elif not np.isfinite(place).all():
            notes.drop(f"point {number:g} (geometry)", "coordinates that are not finite")
        elif int(number) in nodes and not np.allclose(nodes[int(number)], np.array(place) / length):
            notes.drop(f"point {number:g} (geometry)", "a second place for it; the first is used")
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
