"""Scan in one table with a row for each point and frequency: the columns of a point's file, and x and y."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from haptonic.channels import Notebook, delimited
from haptonic.channels.signals import SIMULATED, Origin
from haptonic.response import FrequencyResponse
from haptonic.vibrometry.curves import Curve, Point, assemble
from haptonic.vibrometry.readers.folder import COLUMNS, PointFile, curves_of
from haptonic.vibrometry.readers.mapped import Mapped, check_meanings, chosen, unfit
from haptonic.vibrometry.readers.quantities import UnfitError, length_factor, numbers

MEANINGS = ("x", "y", *COLUMNS)


def read_table(path: Path, how: Mapped, notes: Notebook, origin: Origin, title: str) -> FrequencyResponse:
    """Read the responses of a table; rows of equal x and y are one point.

    Raises
    ------
    ScanError : missing columns, or no usable point
    """
    check_meanings(how, MEANINGS)
    group = delimited.read(path, notes)[""]
    columns = chosen(group.channels, how, notes, MEANINGS)
    table = PointFile(path, group, columns)
    needed = ("x", "y", "frequency", "real", "imaginary")
    if table.parts is None or not {"x", "y", "frequency"} <= columns.keys():
        lacking = f"a table without some of the columns {', '.join(needed)}"
        raise unfit(path.name, lacking, group.channels, notes, how, needed)
    try:
        x, y = (length_factor(columns[axis].unit, how, notes) * numbers(columns[axis]) for axis in "xy")
        whole = curves_of("", table, how, notes)
    except UnfitError as error:
        raise unfit(path.name, str(error), group.channels, notes, how, needed) from error
    rows_of: dict[Point, list[int]] = {}
    for row, place in enumerate(map(Point, x.tolist(), y.tolist())):
        if np.isfinite([place.x, place.y]).all():
            rows_of.setdefault(place, []).append(row)
    if lost := len(x) - sum(map(len, rows_of.values())):
        notes.drop(f"{lost} rows", "no coordinates: x or y is not a number")
    places = {f"P{number}": place for number, place in enumerate(rows_of, start=1)}
    curves = [_part(curve, name, rows_of[place]) for name, place in places.items() for curve in whole]
    return assemble(
        curves, places, notes, estimator=how.estimator, origin=SIMULATED if group.simulated else origin,
        title=title, inputs={"file": path.name},
    )  # fmt: skip


def _part(curve: Curve, point: str, rows: list[int]) -> Curve:
    """The rows of a point."""
    return replace(
        curve, source=f"row {rows[0] + 1}", point=point, frequency=curve.frequency[rows],
        values=curve.values[rows],
    )  # fmt: skip
