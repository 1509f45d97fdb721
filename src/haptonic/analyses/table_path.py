"""Positions of another program's wavevectors on our path, and the grouping of its rows."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise, product
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from haptonic.analyses.table_columns import TableOfBands
from haptonic.arrays import Array
from haptonic.bloch.bands import lattice_of
from haptonic.cell import UnitCell
from haptonic.errors import ChannelError, shown
from haptonic.gate import json_from
from haptonic.later import xarray as xr
from haptonic.lattice import Lattice

_PREFIXES = {"": 1.0, "m": 1e-3, "c": 1e-2, "u": 1e-6, "µ": 1e-6, "n": 1e-9, "k": 1e3}
LENGTHS = {f"{angle}/{prefix}m": 1 / scale for angle in ("rad", "1") for prefix, scale in _PREFIXES.items()}
OF_PITCH = {"pi/a": 1.0, "2pi/a": 2.0}  # in units of pi over the pitch
ALONG = ("share", "segments")
WAVEVECTORS = ("rad/m", "rad/mm", "1/m", "pi/a", "2pi/a", *ALONG)
SAME_PATH = 0.02  # relative difference of two lengths of the same path
ON_PATH = 2e-3  # of a reciprocal vector: tables give wavevectors with four digits or more, shares with three
SAME_PLACE = 1e-6  # of a reciprocal vector
LEAST_STEP = 1e-4  # of the highest frequency; rigid modes, which are rounding errors, lie below it
SAME_ROWS = 2e-3  # relative difference of the frequencies of a wavevector that is given twice


@dataclass(frozen=True, eq=False)
class OurPath:
    """Path of the bands that haptonic computed.

    labels : of the corners, the first one repeated at the end; distance : of each along the path, rad/m
    phases : (corner, 2) rad; lattice, operations : for wavevectors off the path; None if not known
    """

    labels: tuple[str, ...]
    distance: Array
    phases: Array | None = None
    lattice: Lattice | None = None
    operations: tuple[tuple[tuple[int, int], tuple[int, int]], ...] = ()

    @classmethod
    def of_dataset(cls, data: xr.Dataset) -> OurPath:
        """Path of a result."""
        labels = tuple(json_from(data.attrs["path_labels"]))
        distance = data["distance"].values[json_from(data.attrs["path_corners"])]
        if not {"lattice", "zone", "point_group"} <= data.attrs.keys():
            return cls(labels=labels, distance=distance)
        corners = dict(json.loads(data.attrs["zone"]))
        return cls(
            labels=labels,
            distance=distance,
            phases=np.pi * np.array([corners[label] for label in labels]),
            lattice=lattice_of(data),
            operations=tuple(((a, b), (c, d)) for (a, b), (c, d) in json.loads(data.attrs["point_group"])),
        )

    @classmethod
    def of_cell(cls, cell: UnitCell) -> OurPath:
        """Path of a cell, before its bands are computed."""
        labels = tuple(label for label, _ in cell.zone.corners)
        labels = (*labels, labels[0])
        phases = np.array([cell.zone.corner_phases[label] for label in labels])
        steps = np.linalg.norm(np.diff(cell.lattice.wavevector(phases), axis=0), axis=1)
        distance = np.concatenate([[0.0], np.cumsum(steps)])
        return cls(
            labels=labels,
            distance=distance,
            phases=phases,
            lattice=cell.lattice,
            operations=cell.point_group.operations,
        )


def unit_of(path: Path, table: TableOfBands, ours: OurPath, asked: str | None) -> str:
    """Unit of the wavevector: the unit of the user, or else that of the file.

    Raises
    ------
    ChannelError : no unit is given, or it is not a unit of wavevectors
    """
    unit = plain_unit(asked or table.unit)
    allowed = [u for u in WAVEVECTORS if table.axes == "k" or u not in ALONG]
    if unit in LENGTHS or unit in allowed:
        return unit
    if table.axes == "k":
        first, last = float(table.wavevector.min()), float(table.wavevector.max())
        cause = f"the wavevector of {path.name} goes from {first:g} to {last:g}, and its unit is not given"
        likely = _likely(last, ours)
    else:
        largest = float(np.abs(table.wavevector).max())
        cause = f"the wavevectors of {path.name} go up to {largest:g}, and their unit is not given"
        likely = _likely_of_parts(largest, ours)
    raise ChannelError.missing(
        argument="--wavevector",
        given=shown(unit or table.unit) if unit or table.unit else "nothing",
        allowed=f"one of {', '.join(allowed)}",
        cause=cause,
        next_step=f"give the unit: --wavevector={likely}"
        + ("; share is of the whole path, segments count its corners from 0" if table.axes == "k" else ""),
    )


def plain_unit(text: str) -> str:
    """Normalise the unit of a wavevector; also accepts "2π/a", "2*pi / a" and "rad m^-1"."""
    unit = text.replace(" ", "").replace("*", "").replace("π", "pi").replace("\u03bc", "µ")
    if unit.endswith(("m^-1", "m-1")):
        body = unit.removesuffix("-1").removesuffix("^")
        unit = f"rad/{body.removeprefix('rad')}"
    return "" if unit == "1" else unit


def _likely(last: float, ours: OurPath) -> str:
    """Likely unit of a column without a unit, from its last value; used only as advice in an error."""
    length = float(ours.distance[-1])
    ends = {"segments": len(ours.distance) - 1.0, "share": 1.0, "rad/m": length, "rad/mm": length / 1e3}
    return min(ends, key=lambda name: abs(np.log(max(last, 1e-12) / ends[name])))


def _likely_of_parts(largest: float, ours: OurPath) -> str:
    if ours.lattice is None:
        return "rad/m"
    side = np.pi / ours.lattice.pitch
    ends = {"rad/m": side, "rad/mm": side / 1e3, "pi/a": 1.0, "2pi/a": 0.5}
    return min(ends, key=lambda name: abs(np.log(max(largest, 1e-12) / ends[name])))


def positions(path: Path, table: TableOfBands, ours: OurPath, unit: str) -> Array:
    """(row,) position of each row on our path: corners count 0, 1, 2, ...; NaN for a row off the path.

    Raises
    ------
    ChannelError : a wavevector beyond the end of the path, or no wavevector on the path
    """
    scale = LENGTHS.get(unit, 1.0)
    if unit in OF_PITCH:
        if ours.lattice is None:
            raise _other_path(path, f"wavevectors in {unit}", "wavevectors in rad/m", ours)
        scale = OF_PITCH[unit] * np.pi / ours.lattice.pitch
    if table.axes == "k":
        return _along(path, table.wavevector[:, 0], unit, scale, ours)
    if ours.lattice is None or ours.phases is None:
        raise _other_path(path, "kx and ky", "a wavevector along the path", ours)
    vectors = np.zeros((len(table.wavevector), 2))
    for k, axis in enumerate(table.axes):
        vectors[:, "xy".index(axis)] = scale * table.wavevector[:, k]
    places = _on_path(vectors, ours)
    if np.isnan(places).all():
        largest = np.abs(vectors).max()
        raise _other_path(
            path, f"no wavevector on the path; the largest part is {largest:g} rad/m",
            f"wavevectors on {'-'.join(ours.labels)}, or symmetric to such", ours,
        )  # fmt: skip
    return places


def _along(path: Path, axis: Array, unit: str, scale: float, ours: OurPath) -> Array:
    last = len(ours.distance) - 1
    length = float(ours.distance[-1])
    end = {"segments": float(last), "share": 1.0}.get(unit, length / scale)
    if axis.min() < -SAME_PATH * end or axis.max() > (1 + SAME_PATH) * end:
        raise _other_path(
            path,
            f"{axis.min():g} to {axis.max():g} as {unit}",
            f"0 to {end:.4g}, along the path of the study",
            ours,
        )
    if unit == "segments":
        return np.asarray(np.clip(axis, 0, last))
    return np.asarray(np.interp(axis / end * length, ours.distance, np.arange(last + 1.0)))


def _on_path(vectors: Array, ours: OurPath) -> Array:
    """Positions of wavevectors (rad/m), or of their symmetric images, on our path; NaN for those off it."""
    assert ours.lattice is not None
    assert ours.phases is not None
    period = 2 * np.pi
    size = period / float(np.linalg.norm(ours.lattice.vectors, axis=1).max())
    kappa = vectors @ ours.lattice.vectors.T
    places, misses = np.full(len(vectors), np.nan), np.full(len(vectors), ON_PATH * size)
    corners = ours.lattice.wavevector(ours.phases)
    shifts = np.array(list(product((-1, 0, 1), repeat=2)))
    operations = {
        tuple(map(tuple, np.multiply(sign, operation)))
        for operation in (*ours.operations, ((1, 0), (0, 1)))
        for sign in (1, -1)
    }
    for operation in sorted(operations):
        turned = kappa @ np.linalg.inv(np.array(operation))  # rows of W^-T kappa
        inside = turned - period * np.round(turned / period)
        for shift in shifts:
            points = ours.lattice.wavevector(inside + period * shift)
            for k, (first, second) in enumerate(pairwise(corners)):
                along = second - first
                share = np.clip((points - first) @ along / (along @ along), 0, 1)
                miss = np.linalg.norm(points - first - share[:, None] * along, axis=1)
                # a tie keeps the earlier position, such as the centre of the zone at both ends of the path
                better = miss < misses - 1e-9 * size
                places[better], misses[better] = k + share[better], miss[better]
    return places


def gathered(
    path: Path, table: TableOfBands, position: Array
) -> tuple[Array, Array, Array | None, list[str]]:
    """Positions in order, the sorted frequencies of each (NaN if it has fewer), their loss, and remarks.

    Rows of the same wavevector are grouped, wherever they are; a wavevector that is repeated with all its
    frequencies counts once.

    Raises
    ------
    ChannelError : different frequencies for the same wavevector, or blocks of unknown kind
    """
    remarks = []
    on = np.isfinite(position)
    if not on.all():
        remarks.append(f"{int((~on).sum())} rows of {path.name} are off the path and are left out")
    size = max(float(np.abs(table.wavevector).max()), 1e-300)
    _, group = np.unique(np.round(table.wavevector / (SAME_PLACE * size)), axis=0, return_inverse=True)
    group = group.reshape(-1)
    by_group = np.argsort(group, kind="stable")
    by_group = by_group[on[by_group]]
    rows = np.split(by_group, np.flatnonzero(np.diff(group[by_group])) + 1)
    usual = int(np.bincount([len(group_rows) for group_rows in rows]).argmax())
    _refuse_segments(path, table, group)
    sets: dict[float, list[tuple[Array, Array | None, int]]] = {}
    holes = [group_rows for group_rows in rows if _has_hole(table.frequency[group_rows].ravel())]
    if holes:
        remarks.append(
            f"{len(holes)} wavevectors of {path.name} are left out, the first in line "
            f"{table.lines[holes[0][0]]}: one of their frequencies is missing, and its band is unknown"
        )
    if len(holes) == len(rows):
        raise _refused(
            path, "a missing frequency at every wavevector", "frequencies of bands from the lowest"
        )
    for group_rows in rows:
        if _has_hole(table.frequency[group_rows].ravel()):
            continue
        values, loss = _of_wavevector(path, table, group_rows, usual)
        sets.setdefault(round(float(position[group_rows[0]]), 6), []).append(
            (values, loss, int(group_rows[0]))
        )
    chosen = {place: _agreed(path, table, candidates) for place, candidates in sorted(sets.items())}
    most = max(len(values) for values, _ in chosen.values())
    if most == 0:
        raise _refused(path, "no finite frequency", "finite frequencies")
    frequency = np.full((len(chosen), most), np.nan)
    loss = np.full_like(frequency, np.nan)
    for k, (values, lost) in enumerate(chosen.values()):
        frequency[k, : len(values)] = values
        if lost is not None:
            loss[k, : len(values)] = lost
    fewer = int((np.isnan(frequency).any(axis=1)).sum())
    if fewer:
        remarks.append(
            f"{fewer} wavevectors of {path.name} have fewer than {most} frequencies: the lowest are taken"
        )
    return np.array(list(chosen)), frequency, None if table.loss is None else loss, remarks


def _has_hole(values: Array) -> bool:
    """True if a frequency is missing before others, so that bands cannot be counted from the lowest.

    Missing frequencies at the end of an ascending row belong to the highest bands.
    """
    finite = np.isfinite(values)
    present = int(finite.sum())
    if present in (0, len(values)):
        return False
    # rigid modes at the zone's centre are rounding errors, in any order
    rounding = LEAST_STEP * float(np.nanmax(np.abs(values)))
    return not (finite[:present].all() and bool((np.diff(values[:present]) >= -rounding).all()))


def _of_wavevector(
    path: Path, table: TableOfBands, rows: NDArray[np.int64], usual: int
) -> tuple[Array, Array | None]:
    """(band,) frequencies of one wavevector in order, without repetitions, and their loss factors."""
    values = table.frequency[rows].ravel()
    order = np.argsort(values, kind="stable")[: int(np.isfinite(values).sum())]
    wide = table.frequency.shape[1] > 1
    times = len(rows) // usual if len(rows) % usual == 0 else 1
    if times > 1 and (wide or usual > 1):
        again = values[order][: len(order) // times * times].reshape(-1, times)
        if len(order) % times or not np.allclose(again[:, 0], again[:, -1], rtol=SAME_ROWS, atol=1.0):
            raise _refused(
                path,
                f"other frequencies for one wavevector in line {table.lines[rows[-1]]} than in line "
                f"{table.lines[rows[0]]}",
                "each wavevector once, or with the same frequencies again",
            )
        order = order[::times]
    return values[order], None if table.loss is None else table.loss[rows].ravel()[order]


def _refuse_segments(path: Path, table: TableOfBands, group: NDArray[np.int64]) -> None:
    """Refuse wavevectors that start again if every run of them has several frequencies per wavevector.

    Such runs may be different bands, or different parts of the path.
    """
    if table.axes != "k":
        return
    axis = table.wavevector[:, 0]
    starts = [0, *(np.flatnonzero((np.diff(axis) < 0) | (np.diff(table.blocks) != 0)) + 1), len(axis)]
    groups = int(group.max()) + 1
    if (len(starts) - 1) * groups > len(axis):  # too few rows for runs that have all wavevectors
        return
    runs = [np.bincount(group[a:b], minlength=groups) for a, b in pairwise(starts)]
    if len(runs) < 2 or any(not np.array_equal(run > 0, runs[0] > 0) for run in runs):
        return
    if np.count_nonzero(runs[0]) > 1 and all(
        run[run > 0].min() * table.frequency.shape[1] > 1 for run in runs
    ):
        values = [np.sort(table.frequency[a:b], axis=None) for a, b in pairwise(starts)]
        if all(len(run) == len(values[0]) and np.allclose(run, values[0], rtol=SAME_ROWS) for run in values):
            return
        raise _refused(
            path,
            f"a wavevector that starts again in line {table.lines[starts[1]]}, with several frequencies "
            "in each block",
            "blocks of one band each, or rows with different wavevectors",
        )


def _agreed(
    path: Path, table: TableOfBands, candidates: Sequence[tuple[Array, Array | None, int]]
) -> tuple[Array, Array | None]:
    """Frequencies at one position of the path, which symmetric wavevectors must share."""
    values, loss, row = max(candidates, key=lambda candidate: len(candidate[0]))
    for others, _, other in candidates:
        if not np.allclose(others, values[: len(others)], rtol=SAME_PATH, atol=1.0):
            raise _refused(
                path,
                f"other frequencies in line {table.lines[other]} than in line {table.lines[row]}, whose "
                "wavevectors are equal by symmetry",
                "equal frequencies for equal wavevectors",
            )
    return values, loss


def _other_path(path: Path, given: str, allowed: str, ours: OurPath) -> ChannelError:
    return ChannelError.mismatch(
        argument=f"{path.name}, wavevector",
        given=given,
        allowed=allowed,
        cause=f"another unit, another pitch, or another path than {'-'.join(ours.labels)}",
        next_step="check --wavevector; the path of the study is in its diagram",
    )


def _refused(path: Path, given: str, allowed: str) -> ChannelError:
    return ChannelError.malformed(
        argument=path.name,
        given=given,
        allowed=allowed,
        cause="the rows are not those of one set of bands, or a column is not the wavevector",
        next_step="export the wavevector and the frequencies of one set of bands",
    )
