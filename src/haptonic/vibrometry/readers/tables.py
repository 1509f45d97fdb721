"""Scans from named arrays, as in MATLAB and HDF5 files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import prod
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.channels import Channel, Group, Notebook
from haptonic.channels.signals import SIMULATED, Origin
from haptonic.errors import ScanError
from haptonic.foreign.process import refuse_larger
from haptonic.response import FrequencyResponse, Reference
from haptonic.vibrometry.curves import Curve, Point, assemble
from haptonic.vibrometry.readers.mapped import Mapped, Side, check_meanings, chosen, unfit
from haptonic.vibrometry.readers.quantities import (
    UnfitError,
    frequency_factor,
    largest_of,
    length_factor,
    numbers,
    of_amplitude,
    phase_factor,
    response_unit,
    share_factor,
)
from haptonic.vibrometry.records import InMemory, OfChannels, Source, TimeScan

PARTS = (("response",), ("real", "imaginary"), ("amplitude", "phase"))  # one of these is a response
MEANINGS = (
    "frequency", "response", "real", "imaginary", "amplitude", "phase", "coherence", "x", "y", "points",
    "reference", "sample_rate", "unit",
)  # fmt: skip


def scan_of_groups(
    groups: Mapping[str, Group], how: Mapped, notes: Notebook, origin: Origin, title: str, separator: str
) -> FrequencyResponse | TimeScan:
    """Make the scan of a file of named arrays: from all of them, or from the only structure with a scan.

    Parameters
    ----------
    separator : between the names of a group and of its arrays

    Raises
    ------
    ScanError : arrays are missing or contradict each other, or no point is left
    """
    check_meanings(how, MEANINGS)
    every: dict[str, Channel] = {}
    for group in groups.values():
        start = f"{group.name}{separator}" if group.name else ""
        for name, channel in _arrays_of(group).items():
            every.setdefault(f"{start}{name}", replace(channel, name=f"{start}{name}"))
    if any(group.simulated for group in groups.values()):
        origin = SIMULATED
    arrays = every
    if not how.variables and not _is_scan(_arrays_of(groups[""]), how):
        whole = [name for name, group in groups.items() if name and _is_scan(_arrays_of(group), how)]
        if len(whole) > 1:
            raise unfit("structures", f"{', '.join(whole)}, each of which is a scan", every, notes, how)
        if whole:
            notes.remark(f'"{whole[0]}" was used as the scan')
            arrays = _arrays_of(groups[whole[0]])
    table = chosen(arrays, how, notes, MEANINGS)
    return _Arrays(table, every, how, notes).scan(origin, title)


def _arrays_of(group: Group) -> dict[str, Channel]:
    """Arrays of a group, and its attributes that are a number or a text."""
    arrays = dict(group.channels)
    for name, value in group.properties.items():
        if isinstance(value, int | float | str) and name not in arrays:
            arrays[name] = Channel.of(
                name, np.array(value, dtype=object if isinstance(value, str) else float)
            )
    return arrays


def _is_scan(arrays: Mapping[str, Channel], how: Mapped) -> bool:
    """True if arrays have usual names for all quantities of a scan."""
    try:
        table = chosen(arrays, how, Notebook(how.file, ""), MEANINGS).keys()
    except ScanError:  # two arrays with one meaning; reading them raises the error
        return True
    placed = bool(how.at) or {"x", "y"} <= table or "points" in table
    answered = any({*parts} <= table for parts in PARTS)
    return placed and answered and not table.isdisjoint({"frequency", "sample_rate"})


@dataclass(frozen=True, eq=False)
class _Arrays:
    """Arrays of a scan by their meaning, and all arrays of the file."""

    table: Mapping[str, Channel]
    every: Mapping[str, Channel]
    how: Mapped
    notes: Notebook

    def scan(self, origin: Origin, title: str) -> FrequencyResponse | TimeScan:
        """Make responses, or time records if there is a sample rate."""
        try:
            if "sample_rate" in self.table and "frequency" not in self.table:
                return self._records(origin, title)
            return self._responses(origin, title)
        except UnfitError as error:
            raise self._unfit("arrays", str(error)) from error

    def _unfit(self, argument: str, given: str, *needed: str) -> ScanError:
        wanted = needed or ("response", "frequency", "x", "y")
        name = f"{self.notes.path.name}: {argument}"
        return unfit(name, given, self.every, self.notes, self.how, wanted)

    @property
    def _order(self) -> Literal["C", "F"]:
        """Order of the points of a grid: the first axis is the fastest in MATLAB."""
        return "F" if self.notes.format == "MATLAB" else "C"

    def _numbers(self, meaning: str) -> Array:
        """Frequencies or positions: at most as many numbers as in the response, or three for each.

        Sizes are compared first, because a compressed array of some kB may expand to a gigabyte.
        """
        channel = self.table[meaning]
        shape = next(self.table[part].shape for part, *_ in PARTS if part in self.table)
        if channel.size > 3 * prod(shape):
            raise self._unfit(meaning, f"shape {channel.shape}, for a response of shape {shape}")
        refuse_larger(self.notes.path, channel.size)
        return numbers(channel, self._order)

    def _responses(self, origin: Origin, title: str) -> FrequencyResponse:
        table, how, notes = self.table, self.how, self.notes
        parts = next((pair for pair in PARTS if {*pair} <= table.keys()), None)
        if parts is None:
            raise self._unfit("response", "no such variable")
        if "frequency" not in table:
            raise self._unfit("frequency", "neither frequencies nor a sample rate")
        lines = frequency_factor(table["frequency"].unit, how, notes) * self._lines()
        places, grid = self._places(max(prod(table[parts[0]].shape) // max(len(lines), 1), 1), len(lines))
        shape = _Layout(len(places), len(lines), grid)
        of_unit = [table[part] for part in parts if part != "phase"]
        ratio = response_unit(of_unit, how, notes, self._unit_in_file())
        if parts == ("response",):
            if table["response"].kind != "complex":
                raise self._unfit("response", "real numbers: the phase is missing")
            values = self._rows("response", shape)
        elif parts == ("real", "imaginary"):
            values = self._rows("real", shape) + 1j * self._rows("imaginary", shape)
        else:
            phase = self._rows("phase", shape).astype(float)
            factor = phase_factor(table["phase"], largest_of(phase), how, notes)
            amplitude = self._rows("amplitude", shape).astype(float)
            values = of_amplitude(amplitude, factor * phase, table["amplitude"].unit)
        like = Curve(
            source="", point="", axis=3, kind="response", frequency=lines, values=lines,
            motion=ratio.over.motion or "velocity", reference=how.reference_of(ratio),
        )  # fmt: skip
        curves = [
            replace(like, source=f"row {i}", point=str(i), values=ratio.factor * row)
            for i, row in enumerate(values, start=1)
        ]
        if "coherence" in table:
            share = share_factor(table["coherence"].unit)
            curves += [
                replace(like, source=f"row {i}", point=str(i), kind="coherence", values=share * row,
                        reference=Reference())
                for i, row in enumerate(self._rows("coherence", shape), start=1)
            ]  # fmt: skip
        placed = {str(i): place for i, place in enumerate(places, start=1) if place is not None}
        return assemble(curves, placed, notes, origin=origin, title=title, inputs={"file": notes.path.name})

    def _lines(self) -> Array:
        """The frequencies; an array of structures repeats them for each point."""
        lines = self._numbers("frequency")
        axes = tuple(n for n in self.table["frequency"].shape if n != 1)
        if len(axes) < 2:
            return lines
        table = lines.reshape(axes, order=self._order)
        for rows in (table, table.T):
            if len(axes) == 2 and rows.size and (rows == rows[0]).all():
                return np.asarray(rows[0])
        raise self._unfit("frequency", f"shape {self.table['frequency'].shape}, instead of a single axis")

    def _unit_in_file(self) -> str:
        """Text of the array ``unit``, or ""."""
        if "unit" not in self.table or self.table["unit"].size != 1:
            return ""
        return str(np.asarray(self.table["unit"]).item()).strip()

    def _places(self, expected: int, lines: int) -> tuple[list[Point | None], tuple[int, ...]]:
        """Positions of the points, and the axes of their arrays if these are more than one.

        Parameters
        ----------
        expected, lines : numbers of points, and of lines or samples, from the size of the response
        """
        table, how = self.table, self.how
        grid: tuple[int, ...] = ()
        if how.at:
            return list(how.at), grid
        if "x" in table and "y" in table:
            channels = [table["x"], table["y"]]
            columns = [self._numbers("x"), self._numbers("y")]
            axes = [tuple(n for n in channel.shape if n != 1) for channel in channels]
            if axes[0] != axes[1]:
                raise self._unfit("x and y", f"{len(columns[0])} and {len(columns[1])} numbers")
            grid = axes[0] if len(axes[0]) > 1 else ()
        elif "points" in table and len(table["points"].shape) == 2:
            channels = [table["points"]] * 2
            columns = self._columns(expected, lines)
        else:
            raise self._unfit("x, y or points", "no coordinates")
        x, y = (
            length_factor(channel.unit, how, self.notes) * column
            for channel, column in zip(channels, columns, strict=True)
        )
        fine = np.isfinite(x) & np.isfinite(y)
        places = [Point(float(a), float(b)) if ok else None for a, b, ok in zip(x, y, fine, strict=True)]
        return places, grid

    def _columns(self, expected: int, lines: int) -> list[Array]:
        """x and y from one table of the points, whose points are rows or columns."""
        channel = self.table["points"]
        both = self._numbers("points").reshape(channel.shape, order=self._order)
        rows, columns = both.shape
        fits = {
            "rows": columns in (2, 3) and rows == expected,
            "columns": rows in (2, 3) and columns == expected,
        }
        if not any(fits.values()):
            raise self._unfit("points", f"a table of {rows} x {columns}, for {expected} points")
        side = "columns" if fits["columns"] else "rows"
        if all(fits.values()):
            side = self._side_of_points(both, meant=expected != lines)
        both = both.T if side == "columns" else both
        return [both[:, 0], both[:, 1]]

    def _side_of_points(self, both: Array, meant: bool) -> Side:
        """Side of a square table that is the points, rows or columns: z is equal for all points of a plane.

        Parameters
        ----------
        meant : False if the user's choice may be meant for a response that is square as well
        """
        if self.how.points_in is not None and meant:
            return self.how.points_in
        name, shape = self.table["points"].name, both.shape
        heights: dict[Side, Array] = {"rows": both[:, -1], "columns": both[-1]}
        level = [side for side, z in heights.items() if len(both) == 3 and np.ptp(z) == 0]
        if len(level) == 1:
            self.notes.remark(f'the {level[0]} of "{name}" were used as points: they have equal heights')
            return level[0]
        if self.how.points_in is None:
            raise self._ask_side("points", shape)
        raise ScanError.conflict(
            argument=f"{self.notes.path.name}: {name}",
            given=f"shape {shape}, and a response that is square as well",
            allowed="separate x and y, or different numbers of frequencies and points",
            cause="rows or columns may be points, and points_in may be meant for the response",
            next_step='give the places: read_scan(path, at="X, Y; X, Y")',
            command=f'haptonic scan {self.how.path} --points-in {self.how.points_in} --at "X, Y; X, Y"',
        )

    def _ask_side(self, meaning: str, shape: tuple[int, ...]) -> ScanError:
        return ScanError.conflict(
            argument=f"{self.notes.path.name}: {self.table[meaning].name}",
            given=f"shape {shape}, in which rows or columns may be points",
            allowed="different numbers of points and frequencies, or points_in",
            cause="as many points as frequencies",
            next_step='give it: read_scan(path, points_in="rows"), or "columns"',
            command=f"haptonic scan {self.how.path} --points-in rows (or columns)",
        )

    def _rows(self, meaning: str, layout: _Layout) -> NDArray[Any]:
        """(point, line) numbers of an array, whose points are rows or columns."""
        channel = self.table[meaning]
        sides = layout.sides(channel.shape)
        if not sides:
            raise self._unfit(
                meaning, f"shape {channel.shape}, for {layout.points} points and {layout.lines} lines"
            )
        if len(sides) > 1 and self.how.points_in is None:
            raise self._ask_side(meaning, channel.shape)
        side = self.how.points_in if len(sides) > 1 else sides[0]
        refuse_larger(self.notes.path, channel.size)
        values = np.asarray(channel)
        if values.dtype.kind not in "fciu":
            raise UnfitError(f"{channel.name} does not contain numbers")
        flat = (layout.points, layout.lines) if side == "rows" else (layout.lines, layout.points)
        table = values.squeeze().reshape(flat, order=self._order)
        return table if side == "rows" else table.T

    def _records(self, origin: Origin, title: str) -> TimeScan:
        table, how, notes = self.table, self.how, self.notes
        if "response" not in table:
            raise self._unfit("response", "no such variable", "response", "reference", "x", "y")
        if "reference" not in table:
            raise self._unfit("reference", "time records without the record of the drive",
                              "response", "reference", "x", "y")  # fmt: skip
        if not {table[name].kind for name in ("response", "reference")} <= {"number"}:
            raise self._unfit("response", "time records that are not real numbers")
        shape = table["response"].shape
        places, _ = self._places(max(shape[:1] or (1,)), shape[-1] if len(shape) == 2 else 0)
        response, reference = (self._records_first(name, len(places)) for name in ("response", "reference"))
        (count, repeats, samples), driven = _shape(response), _shape(reference)
        if count != len(places) or driven[1:] != (repeats, samples) or driven[0] not in (1, count):
            raise self._unfit(
                "response", f"{response.shape}, reference {reference.shape}, {len(places)} points"
            )
        ratio = response_unit([table["response"]], how, notes, self._unit_in_file())
        keep = [i for i, place in enumerate(places) if place is not None]
        source: Source = OfChannels(reference, response, repeats, samples)
        if len(keep) < count:
            rows, moved = source.load(0, count)
            source = InMemory(rows if driven[0] == 1 else rows[keep], moved[keep])
        for i, place in enumerate(places):
            if place is None:
                notes.drop(f"point {i + 1}", "no coordinates")
        placed = [place for place in places if place is not None]
        return TimeScan(
            source=source,
            names=tuple(str(i + 1) for i in keep),
            x=np.array([place.x for place in placed]), y=np.array([place.y for place in placed]),
            repeats=repeats, samples=samples,
            sample_rate=self._rate(),
            reference=how.reference or Reference("reference", "V"),
            motion=ratio.over.motion or "velocity", response_scale=ratio.over.factor, origin=origin,
            title=title,
        )  # fmt: skip

    def _rate(self) -> float:
        channel = self.table["sample_rate"]
        if channel.size != 1:
            raise self._unfit("sample_rate", f"{channel.size} numbers")
        return float(self._numbers("sample_rate")[0]) * frequency_factor(channel.unit, self.how)

    def _records_first(self, meaning: str, points: int) -> Channel:
        """(point, repeat, sample) or (point, sample) of records; the array may have the samples first.

        Records with the points first stay in their file.
        """
        channel = self.table[meaning]
        axes = len(channel.shape)
        if axes == 3 or (axes == 2 and channel.shape[0] == points and channel.shape[1] != points):
            return channel
        refuse_larger(self.notes.path, channel.size)
        table = np.atleast_2d(np.squeeze(np.asarray(channel)))
        if table.ndim != 2:
            raise self._unfit(meaning, f"shape {channel.shape}, for {points} points", "response", "reference")
        if table.shape == (points, points) and points > 1 and self.how.points_in is None:
            raise self._ask_side(meaning, channel.shape)
        turned = table.shape[0] != points and table.shape[1] in (1, points)
        turned = turned or (table.shape == (points, points) and self.how.points_in == "columns")
        return Channel.of(channel.name, np.asarray((table.T if turned else table)[:, None]))


@dataclass(frozen=True)
class _Layout:
    """Numbers of points and lines of an array; ``grid`` : axes of its points if they have several."""

    points: int
    lines: int
    grid: tuple[int, ...]

    def sides(self, shape: Sequence[int]) -> list[str]:
        """Sides, "rows" and "columns", that can be points."""
        axes = tuple(n for n in shape if n != 1)
        possible = []
        for side in ("rows", "columns"):
            for points in {(self.points,), self.grid or (self.points,)}:
                wanted = (*points, self.lines) if side == "rows" else (self.lines, *points)
                if tuple(n for n in wanted if n != 1) == axes and side not in possible:
                    possible.append(side)
        return possible[:1] if 1 in (self.points, self.lines) else possible


def _shape(of: Channel) -> tuple[int, int, int]:
    """Points, repeats and samples of records whose repeats may be missing."""
    return (of.shape[0], of.shape[1], of.shape[2]) if len(of.shape) == 3 else (of.shape[0], 1, of.shape[1])
