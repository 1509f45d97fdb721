"""Data sets of a universal file: their positions, and the curves (58, 58b) in them.

pyuff reads the small data sets. Curves are read here, because pyuff 2.5 returns a curve of a cut or damaged
file with fewer values than it announces, without an error. It also needs more than twice as long and the
whole file in memory, and reads neither Fortran's exponents (1.0D+00) nor the code page of older instruments.
"""

from __future__ import annotations

import mmap
import re
import warnings
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array

Buffer = bytes | mmap.mmap

DELIMITER = b"    -1"
HEADER_LINES = 11
REAL, COMPLEX = (2, 4), (5, 6)
SINGLE = (2, 5)

_KIND = re.compile(rb"\s*(\d{1,6})(b)?(?![0-9A-Za-z.+-])", re.IGNORECASE)
_EXPONENT = re.compile(r"(?<=[0-9.])[dD](?=[+-]?\d)|(?<=[0-9.])(?=[+-]\d{3}$)")


@dataclass(frozen=True)
class DataSet:
    """One data set: its type, and the start and the end of its text, after the line of the type."""

    number: int
    kind: int
    binary: bool
    begin: int
    end: int
    first_line: bytes
    closed: bool

    @property
    def name(self) -> str:
        return f"data set {self.number} (type {self.kind}{'b' * self.binary})"


@dataclass(frozen=True)
class Axis:
    """Quantity of an axis, records 8 to 11 of a curve. ``kind`` is the data type, 11 for velocity."""

    kind: int
    label: str
    unit: str


@dataclass(frozen=True)
class Header:
    """Header of a curve, records 1 to 11 of data set 58."""

    lines: tuple[str, ...]
    function: int
    response_name: str
    response_node: int
    response_axis: int
    reference_name: str
    reference_node: int
    reference_axis: int
    ordinate: int
    count: int
    even: bool
    first: float
    step: float
    abscissa: Axis
    over: Axis
    under: Axis


class UnreadableError(Exception):
    """A data set that cannot be read; the text gives the reason."""


def blocks_of(data: Buffer) -> list[DataSet]:
    """Find all data sets, including incomplete ones."""
    blocks: list[DataSet] = []
    position = _delimiter(data, 0)
    while position >= 0:
        kind_line, begin = _line(data, _after(data, position))
        match = _KIND.match(kind_line)
        if match is None or int(match[1]) == 0:  # the end of a data set whose beginning is lost
            position = _delimiter(data, position + len(DELIMITER))
            continue
        binary = match[2] is not None
        end = _delimiter(data, _beyond_bytes(data, kind_line, begin) if binary else begin)
        closed = end >= 0
        if closed and not binary:
            follows, _ = _line(data, _after(data, end))
            opens = _KIND.match(follows)
            # two delimiters meet between data sets; a single one, followed by a type, begins the next
            closed = opens is None or follows.strip() == DELIMITER.strip()
        stop = end if end >= 0 else len(data)
        blocks.append(
            DataSet(
                number=len(blocks) + 1,
                kind=int(match[1]),
                binary=binary,
                begin=begin,
                end=stop,
                first_line=kind_line,
                closed=closed,
            )
        )
        if end < 0:
            break
        position = _delimiter(data, end + len(DELIMITER)) if closed else end
    return blocks


def header_of(block: DataSet, data: Buffer) -> tuple[Header, int]:
    """Read the header of a curve, and find the start of its values.

    Raises
    ------
    UnreadableError : a record is cut short, or contains text instead of numbers
    """
    lines, position = [], block.begin
    for _ in range(HEADER_LINES):
        raw, position = _line(data, position)
        lines.append(_decoded(raw))
        if position > block.end:
            raise UnreadableError("cut short in its header")
    who = _fields(lines[5], (5, 10, 5, 10, 11, 10, 4, 11, 10, 4))
    form = _fields(lines[6], (10, 10, 10, 13, 13, 13))
    try:
        integers = [int(form[i] or 0) for i in range(3)]
        floats = [_number(form[i]) for i in (3, 4)]
        function, response, reference = int(who[0] or 0), int(who[5] or 0), int(who[8] or 0)
        axes = int(who[6] or 0), int(who[9] or 0)
    except ValueError:
        raise UnreadableError("text where its header should have numbers") from None
    if integers[0] not in REAL + COMPLEX or integers[1] < 0:
        raise UnreadableError(f"ordinate of type {integers[0]}; known are {REAL + COMPLEX}")
    header = Header(
        lines=tuple(line.strip() for line in lines[:5]), function=function,
        response_name=_name(who[4]), response_node=response, response_axis=axes[0],
        reference_name=_name(who[7]), reference_node=reference, reference_axis=axes[1],
        ordinate=integers[0], count=integers[1], even=integers[2] != 0, first=floats[0], step=floats[1],
        abscissa=_axis(lines[7]), over=_axis(lines[8]), under=_axis(lines[9]),
    )  # fmt: skip
    return header, position


def values_of(block: DataSet, header: Header, begin: int, data: Buffer) -> tuple[Array, NDArray[Any]]:
    """Read abscissa and ordinate of a curve.

    Raises
    ------
    UnreadableError : fewer values than announced, or text between them
    """
    is_complex = header.ordinate in COMPLEX
    columns = (1 + is_complex) + (not header.even)
    expected = columns * header.count
    if block.binary:
        numbers = _binary(block, header, data[begin : block.end], expected)
    else:
        numbers = _ascii(data[begin : block.end], header, expected)
    if len(numbers) < expected:
        raise UnreadableError(f"cut short: {len(numbers) // columns} of {header.count} values")
    if header.count == 0:
        raise UnreadableError("it has no values")
    table = numbers[:expected].reshape(-1, columns)
    ordinate = table[:, -2] + 1j * table[:, -1] if is_complex else table[:, -1]
    abscissa = header.first + header.step * np.arange(header.count) if header.even else table[:, 0]
    return np.asarray(abscissa), np.asarray(ordinate)


def _binary(block: DataSet, header: Header, content: bytes, expected: int) -> Array:
    """Values of data set 58b. An uneven abscissa has the precision of the ordinate."""
    order, form = block.first_line[7:13].strip(), block.first_line[13:19].strip()
    if form not in (b"2", b"0", b""):
        raise UnreadableError("binary numbers of a DEC VAX or IBM 370; only IEEE 754 is read")
    kind = np.dtype(f"{'>' if order == b'2' else '<'}f{4 if header.ordinate in SINGLE else 8}")
    whole = min(len(content) // kind.itemsize, expected)
    return np.frombuffer(content, kind, count=whole).astype(np.float64)


def _ascii(content: bytes, header: Header, expected: int) -> Array:
    """Numbers separated by blanks; split by column width if some of them touch."""
    text = content.decode("ascii", errors="replace")
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)  # how numpy reports text between numbers
        try:
            numbers = np.fromstring(text, sep=" ")
            if len(numbers) == expected:
                return numbers
        except (ValueError, DeprecationWarning):
            pass
    widths = _widths(header)
    values: list[float] = []
    for line in text.splitlines():
        at = 0
        for width in widths * 6:
            part = line[at : at + width]
            if not part.strip():
                break
            try:
                values.append(_number(part))
            except ValueError:
                raise UnreadableError(f'the text "{part.strip()[:20]}" between its numbers') from None
            at += width
    return np.array(values)


def _widths(header: Header) -> tuple[int, ...]:
    if header.ordinate in SINGLE:
        return (13,)
    if header.even:
        return (20,)
    return (13, 20, 20) if header.ordinate in COMPLEX else (13, 20)


def _number(text: str) -> float:
    """Number in Fortran's notation: 1.0D+00, 1.0+100, or blank for zero."""
    plain = text.strip()
    return float(_EXPONENT.sub("e", plain)) if plain else 0.0


def _fields(line: str, widths: tuple[int, ...]) -> list[str]:
    edges = np.cumsum((0, *widths))
    parts = [line[a:b].strip() for a, b in pairwise(edges)]
    numeric = [part for part, width in zip(parts, widths, strict=True) if width != 11]
    loose = line.split()
    # the columns are shifted: as many words as fields still identify the fields
    if any(" " in part or not _is_number(part) for part in numeric if part) and len(loose) == len(widths):
        return loose
    return parts


def _is_number(text: str) -> bool:
    try:
        _number(text)
    except ValueError:
        return False
    return True


def _axis(line: str) -> Axis:
    kind, label, unit = line[:10].strip(), line[25:46].strip(), line[46:67].strip()
    # isdigit alone takes digits that int does not, such as a raised 2
    return Axis(int(kind) if kind.isascii() and kind.isdigit() else 0, _name(label), _name(unit))


def _name(text: str) -> str:
    return "" if text.upper() == "NONE" else text


def _decoded(raw: bytes) -> str:
    """Text in UTF-8, or in the code page of older instruments."""
    try:
        return raw.decode("utf-8")
    except UnicodeDecodeError:
        return raw.decode("latin-1")


def _delimiter(data: Buffer, start: int) -> int:
    """Position of the next line with only -1 in columns 5 and 6; -1 if there is none."""
    while (at := data.find(DELIMITER, start)) >= 0:
        rest = data[at + len(DELIMITER) : at + 81]
        tail = re.match(rb"[ ]*(?=\r|\n|$)", rest)
        if tail and (tail.end() < len(rest) or len(rest) < 75 or not rest.strip()):
            return at
        start = at + 1
    return -1


def _after(data: Buffer, delimiter: int) -> int:
    return _line(data, delimiter)[1]


def _line(data: Buffer, start: int) -> tuple[bytes, int]:
    """A line without its end, and the start of the next line; past the data if the line is unfinished."""
    stop = data.find(b"\n", start)
    if stop < 0:
        return data[start:].rstrip(b"\r"), len(data) + 1
    line = data[start:stop]
    return line.rstrip(b"\r"), stop + 1


def _beyond_bytes(data: Buffer, kind_line: bytes, begin: int) -> int:
    """Start of the search for the end of a binary data set: after its announced bytes, if plausible."""
    for _ in range(HEADER_LINES):
        begin = _line(data, begin)[1]
    announced = kind_line[31:43].strip()
    beyond = begin + int(announced) if announced.isdigit() else begin
    if data[beyond : beyond + 16].lstrip(b"\r\n").startswith(DELIMITER):
        return beyond
    return min(begin, len(data))
