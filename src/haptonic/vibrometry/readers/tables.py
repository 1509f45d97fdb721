"""Named arrays, as MATLAB files, TDMS files and folders of CSV hold them, made into a scan."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.channels import Channel, Notebook
from haptonic.channels.labels import Ratio, ratio_of
from haptonic.channels.signals import ORIGIN, Origin
from haptonic.errors import ScanError
from haptonic.response import FrequencyResponse, Reference
from haptonic.vibrometry.curves import Curve, Point, assemble
from haptonic.vibrometry.records import InMemory, OfChannels, Source, TimeScan

# What a variable may be called when nothing else is said; the first that is there is taken.
GUESSES: dict[str, tuple[str, ...]] = {
    "frequency": ("frequency", "freq", "frequencies", "f", "freqs", "fvec", "f_hz"),
    "response": ("response", "frf", "h1", "h", "hf", "vel_frf", "velocity", "v", "data", "y_resp"),
    "coherence": ("coherence", "coh", "gamma2", "cxy"),
    "x": ("x", "xs", "x_m", "xpos", "xcoord", "x_mm"),
    "y": ("y", "ys", "y_m", "ypos", "ycoord", "y_mm"),
    "points": ("points", "xyz", "xy", "coords", "coordinates", "nodes", "pos", "positions"),
    "reference": ("reference", "ref", "drive", "input", "voltage", "excitation"),
    "sample_rate": ("sample_rate", "fs", "samplerate", "sampling_rate", "rate"),
}
NEEDED = "response, x and y (or points), and frequency for responses or reference and sample_rate for records"


@dataclass(frozen=True)
class Mapped:
    """How variables of a file are understood.

    variables : name of the variable for "frequency", "response", "coherence", "x", "y", "points",
        "reference", "sample_rate"; what is left out is guessed from usual names
    unit : of the response, such as "mm/s/V" or, for time records, "mm/s"
    length_unit : one unit of the coordinates, m
    reference : as somebody gave it, or empty
    frequency_unit : one unit of the frequencies, Hz
    """

    variables: Mapping[str, str]
    unit: str
    length_unit: float
    reference: Reference
    frequency_unit: float = 1.0

    def reference_of(self, unit: Ratio) -> Reference:
        """What somebody called it, or else what the unit of the responses is over."""
        named = Reference("reference", unit.under.unit) if unit.under.unit else Reference()
        return self.reference or named


def table_of(arrays: Mapping[str, Channel], how: Mapped, notes: Notebook) -> dict[str, Channel]:
    """The arrays by what they mean.

    Raises
    ------
    ScanError : the mapping names an unknown meaning or a variable that is not there
    """
    for meaning, name in how.variables.items():
        for word, known, what in ((meaning, GUESSES, "meanings"), (name, arrays, "variables")):
            if word not in known:
                cause = f"none of the {what} has this name, or the file is another one"
                raise ScanError.unknown(f"variables.{meaning}", word, sorted(known), cause)
    found = {meaning: arrays[name] for meaning, name in how.variables.items()}
    lower = {name.lower(): name for name in arrays}
    taken = set(how.variables.values())
    for meaning, guesses in GUESSES.items():
        guess = next((lower[g] for g in guesses if g in lower and lower[g] not in taken), None)
        if meaning not in found and guess is not None:
            found[meaning] = arrays[guess]
            taken.add(guess)
            notes.remark(f'the variable "{guess}" was taken as {meaning}')
    for name in arrays:
        if name not in taken and name != ORIGIN:
            notes.remark(f'the variable "{name}" was not used')
    return found


def scan_of(
    table: Mapping[str, Channel], how: Mapped, notes: Notebook, origin: Origin, title: str
) -> FrequencyResponse | TimeScan:
    """The arrays of a table as responses, or as time records when they come with a sample rate.

    Raises
    ------
    ScanError : arrays are missing or do not fit together, or nothing is left
    """
    places = _places(table, how, notes)
    if "response" not in table:
        raise _unfit("response", "no such variable", notes)
    unit = ratio_of(how.unit)
    if unit.over.motion is None:
        raise ScanError.malformed(
            argument="unit",
            given=f'"{how.unit}"',
            allowed='a unit of displacement, velocity or acceleration, such as "mm/s/V"',
            cause="the unit is that of the sensor's voltage, or misspelt",
            next_step="give the unit after the vibrometer's sensitivity was applied",
        )
    if "sample_rate" in table:
        return _records(table, places, how, notes, origin, title)
    if "frequency" not in table:
        raise _unfit("frequency", "neither frequencies nor a sample rate", notes)
    lines = how.frequency_unit * np.asarray(table["frequency"], dtype=float).ravel()
    values = _points_first(np.squeeze(np.asarray(table["response"])), len(places), len(lines), notes)
    if not np.iscomplexobj(values):
        raise _unfit("response", "real numbers: the phase is missing", notes)
    reference = how.reference_of(unit)
    motion = unit.over.motion
    curves = [
        Curve(
            source=f"row {i + 1}",
            point=str(i + 1),
            axis=3,
            kind="response",
            frequency=lines,
            values=unit.factor * row,
            motion=motion,
            reference=reference,
        )
        for i, row in enumerate(values)
    ]
    if "coherence" in table:
        both = _points_first(np.squeeze(np.asarray(table["coherence"])), len(places), len(lines), notes)
        curves += [
            Curve(
                source=f"row {i + 1}",
                point=str(i + 1),
                axis=3,
                kind="coherence",
                frequency=lines,
                values=row,
                motion=motion,
                reference=Reference(),
            )
            for i, row in enumerate(both)
        ]
    known = {str(i + 1): place for i, place in enumerate(places) if place is not None}
    return assemble(curves, known, notes, origin=origin, title=title, inputs={"file": notes.path.name})


def _places(table: Mapping[str, Channel], how: Mapped, notes: Notebook) -> list[Point | None]:
    if "x" in table and "y" in table:
        columns = [np.asarray(table[name], dtype=float).ravel() for name in ("x", "y")]
    elif "points" in table and len(table["points"].shape) == 2:
        both = np.asarray(table["points"], dtype=float)
        both = both.T if both.shape[0] in (2, 3) and both.shape[1] not in (2, 3) else both
        columns = [both[:, 0], both[:, 1]]
    else:
        raise _unfit("x, y or points", "no coordinates", notes)
    if len(columns[0]) != len(columns[1]):
        raise _unfit("x and y", f"{len(columns[0])} and {len(columns[1])} numbers", notes)
    pairs = [how.length_unit * column for column in columns]
    fine = np.isfinite(pairs[0]) & np.isfinite(pairs[1])
    return [
        Point(float(x), float(y)) if ok else None for x, y, ok in zip(pairs[0], pairs[1], fine, strict=True)
    ]


def _points_first(values: NDArray[Any], points: int, lines: int, notes: Notebook) -> NDArray[Any]:
    """(point, line), whichever way they came; MATLAB files have points in columns as often as in rows."""
    if values.shape == (points, lines):
        if points == lines:
            notes.remark("as many points as lines: rows were taken as points")
        return values
    if values.shape == (lines, points):
        return values.T
    if values.size == points * lines and values.ndim == 1:
        return values.reshape(points, lines)
    raise _unfit("response", f"shape {values.shape}, for {points} points and {lines} lines", notes)


def _records(
    table: Mapping[str, Channel],
    places: list[Point | None],
    how: Mapped,
    notes: Notebook,
    origin: Origin,
    title: str,
) -> TimeScan:
    if "reference" not in table:
        raise _unfit("reference", "time records without the record of the drive", notes)
    response, reference = (_records_first(table[name], len(places)) for name in ("response", "reference"))
    (count, repeats, samples), driven = _shape(response), _shape(reference)
    if count != len(places) or driven[1:] != (repeats, samples) or driven[0] not in (1, count):
        raise _unfit(
            "response", f"{response.shape}, reference {reference.shape}, {len(places)} points", notes
        )
    keep = [i for i, place in enumerate(places) if place is not None]
    source: Source = OfChannels(reference, response, repeats, samples)
    if len(keep) < count:
        rows, moved = source.load(0, count)
        source = InMemory(rows if driven[0] == 1 else rows[keep], moved[keep])
    for i, place in enumerate(places):
        if place is None:
            notes.drop(f"point {i + 1}", "no coordinates")
    found = [place for place in places if place is not None]
    unit = ratio_of(how.unit).over
    return TimeScan(
        source=source,
        names=tuple(str(i + 1) for i in keep),
        x=np.array([place.x for place in found]), y=np.array([place.y for place in found]),
        repeats=repeats, samples=samples,
        sample_rate=float(np.asarray(table["sample_rate"], dtype=float).ravel()[0]),
        reference=how.reference or Reference("reference", "V"),
        motion=unit.motion or "velocity", response_scale=unit.factor, origin=origin, title=title,
    )  # fmt: skip


def _shape(of: Channel) -> tuple[int, int, int]:
    """Points, repeats and samples of records that may lack the middle one."""
    return (of.shape[0], of.shape[1], of.shape[2]) if len(of.shape) == 3 else (of.shape[0], 1, of.shape[1])


def _records_first(values: Channel, points: int) -> Channel:
    """(point, repeat, sample) or (point, sample) of records that came so, as (sample, point) or (sample,).

    Those with the points first stay in their file.
    """
    if len(values.shape) == 3 or (len(values.shape) == 2 and values.shape[0] == points):
        return values
    table = np.atleast_2d(np.squeeze(np.asarray(values)))
    turned = table.shape[0] != points and table.shape[1] in (1, points)
    return Channel.of(values.name, np.asarray((table.T if turned else table)[:, None]))


def _unfit(argument: str, given: str, notes: Notebook) -> ScanError:
    return ScanError.mismatch(
        argument=f"{notes.path.name}: {argument}",
        given=given,
        allowed=NEEDED,
        cause="variables have other names than usual, or belong to different scans",
        next_step='name them: read_scan(path, variables={"response": "...", "x": "...", "y": "..."}), or '
        "haptonic scan --variables response=...,x=...,y=...",
    )
