"""Readers for the comparison: bands of haptonic, of a result file, and of a table from another program."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from haptonic.analyses.table_columns import TableOfBands, columns_of
from haptonic.analyses.table_path import OurPath, gathered, positions, unit_of
from haptonic.bloch import gaps_of
from haptonic.channels.hdf5 import arrays_of, refuse_sizes
from haptonic.channels.text_table import TextTable, read_table
from haptonic.errors import ChannelError, StudyError, shown
from haptonic.foreign.process import ask
from haptonic.gate import json_from
from haptonic.later import xarray as xr
from haptonic.paths import unread
from haptonic.results.comparison import BandSet

LARGEST_FILE = 50_000_000  # bytes
PARTS = {
    "distance": ("wavevector",),
    "frequency": ("wavevector", "band"),
    **dict.fromkeys(("gap_below", "gap_lower", "gap_upper", "gap_lower_error", "gap_upper_error"), ("gap",)),
    **dict.fromkeys(("gap_lower_kappa", "gap_upper_kappa"), ("gap", "axis")),
    **dict.fromkeys(("gap_complete", "gap_direction", "gap_samples", "gap_waves"), ("gap",)),
}  # variables of bands.nc with their dimensions


@dataclass(frozen=True, kw_only=True)
class OfTable:
    """Settings of a user for a table: units missing in it, and the number of lines to skip."""

    wavevector: str | None = None
    frequency_unit: str | None = None
    skip_lines: int = 0


def of_dataset(name: str, data: xr.Dataset) -> BandSet:
    """Band set of a dataset that haptonic computed."""
    path = OurPath.of_dataset(data)
    inputs = json_from(data.attrs["inputs"])
    frequency = np.sort(data["frequency"].values, axis=1)
    loss = loss_of(inputs)
    return BandSet(
        name=name,
        position=np.interp(data["distance"].values, path.distance, np.arange(len(path.distance))),
        frequency=frequency,
        labels=path.labels,
        gaps=tuple(gap for gap in gaps_of(data) if gap.complete),
        inputs=inputs,
        loss=None if loss is None else np.full_like(frequency, loss),
        loss_from="the material",
    )


def of_file(path: Path) -> xr.Dataset:
    """Read the variables that are compared from a file of `haptonic bands`.

    Raises
    ------
    StudyError : another kind of file, or a damaged one
    """
    try:
        content = ask("hdf5.tree", path, deep=False)
        refuse_sizes(path, content["sets"], PARTS)
        parts = arrays_of(path, content, [*PARTS])
        data = xr.Dataset(
            {name: (dims, parts[name]) for name, dims in PARTS.items()}, attrs=content["attributes"]
        )
        of_dataset("", data)
    except (
        ChannelError, OSError, MemoryError, KeyError, ValueError, TypeError, IndexError, AttributeError,
    ) as error:  # fmt: skip
        raise unread(
            StudyError,
            error,
            argument="bands of an earlier run",
            given=shown(str(path), 200),
            allowed="bands.nc of `haptonic bands`, or its folder",
            cause="the file is of another kind, or it is damaged",
            next_step="give the study, or run `haptonic bands` again",
        ) from error
    return data


def zone_of(data: xr.Dataset) -> list[tuple[str, tuple[float, float]]]:
    """Corners of the zone on whose edge a dataset of bands was computed; see `IrreducibleZone`."""
    return [(label, (float(x), float(y))) for label, (x, y) in json_from(data.attrs["zone"])]


def of_table(path: Path, ours: OurPath, asked: OfTable) -> BandSet:
    """Read the bands of a text table and place them on our path.

    Raises
    ------
    ChannelError : not a table, missing units, an axis that is not a wavevector, or another path
    """
    table, unit = _read(path, ours, asked)
    places = positions(path, table, ours, unit)
    position, frequency, loss, remarks = gathered(path, table, places)
    return BandSet(
        name=path.stem,
        position=position,
        frequency=frequency,
        labels=ours.labels,
        gaps=(),
        inputs={},
        ours=False,
        left=table.left,
        loss=loss,
        loss_from=table.from_column,
        remarks=(*table.remarks, *remarks),
    )


def check_table(path: Path, ours: OurPath | None, asked: OfTable) -> None:
    """Raise the errors of `of_table` that can be detected before bands are computed."""
    if ours is None:
        columns_of(_text_table(path, asked), asked.frequency_unit)
    else:
        of_table(path, ours, asked)


def _text_table(path: Path, asked: OfTable) -> TextTable:
    try:
        return read_table(path, skip=asked.skip_lines, option="--skip-lines", largest=LARGEST_FILE)
    except OSError as error:
        raise unread(
            ChannelError, error, argument=path.name, given=error.strerror or "nothing",
            allowed="a text table that can be read", cause="you have no permission to read it",
            next_step="check the permissions of the file",
        ) from error  # fmt: skip


def _read(path: Path, ours: OurPath, asked: OfTable) -> tuple[TableOfBands, str]:
    text = _text_table(path, asked)
    try:
        table = columns_of(text, asked.frequency_unit)
    except ChannelError as error:
        if error.argument == "--frequency-unit" and not asked.frequency_unit:  # report the first column first
            table = columns_of(text, "Hz")
            positions(path, table, ours, unit_of(path, table, ours, asked.wavevector))
        raise
    return table, unit_of(path, table, ours, asked.wavevector)


def loss_of(inputs: Mapping[str, Any]) -> float | None:
    """Loss factor of every mode of a cell; None for materials of several loss factors."""
    materials = [inputs.get("material"), *(inputs.get("cell", {}).get("materials") or {}).values()]
    losses = {
        material.get("loss_factor") if isinstance(material, Mapping) else None for material in materials
    }
    loss = losses.pop() if len(losses) == 1 else None
    return float(loss) if isinstance(loss, int | float) else None
