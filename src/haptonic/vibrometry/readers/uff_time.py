"""Time records in universal files: one record of the response, one of the reference, for each point."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

import numpy as np

from haptonic.channels.labels import Ratio
from haptonic.channels.signals import Origin, Samples
from haptonic.channels.uff import TIME, Function, UffContents
from haptonic.errors import ScanError
from haptonic.response import Reference
from haptonic.vibrometry.curves import AXES, nothing_left
from haptonic.vibrometry.readers.uff import ratio_in
from haptonic.vibrometry.records import TimeScan


@dataclass(frozen=True, eq=False)
class _UffRecords:
    """Records of the file; all points share the reference if it has one row."""

    reference: list[list[Function]]
    response: list[list[Function]]

    def load(self, start: int, stop: int) -> tuple[Samples, Samples]:
        shared = len(self.reference) == 1
        reference = self.reference if shared else self.reference[start:stop]
        return _stacked(reference), _stacked(self.response[start:stop])


def has_records(contents: UffContents) -> bool:
    """True if the file has time records of a motion."""
    times = [f for f in contents.functions if f.header.function == TIME]
    return any(ratio_in(f.header, contents).over.motion for f in times)


def time_scan_of(contents: UffContents, origin: Origin, title: str) -> TimeScan:
    """Make a scan of the time records; curves that do not belong to it are noted.

    Raises
    ------
    ScanError : no record of a point with coordinates, no reference channel, or several that cannot be paired
    """
    notes = contents.notes
    times = [f for f in contents.functions if f.header.function == TIME]
    ratio = {id(f): ratio_in(f.header, contents) for f in times}
    first = next(f for f in times if ratio[id(f)].over.motion)
    like, unit = first.header, ratio[id(first)].over
    points: dict[int, list[Function]] = defaultdict(list)
    references: list[Function] = []
    for function in times:
        header, name = function.header, f"point {function.header.response_node} ({function.source})"
        over = ratio[id(function)].over
        if (header.count, f"{header.step:.4e}", header.even) != (like.count, f"{like.step:.4e}", True):
            notes.drop(name, f"{header.count} samples, where the scan has {like.count}, or another rate")
        elif not function.block.closed:
            notes.drop(name, "cut short: its end is missing")
        elif over.motion is None:
            references.append(function)
        elif over != unit or abs(header.response_axis or 3) != abs(like.response_axis or 3):
            notes.drop(name, f'its unit "{header.over.unit}" or direction is not that of the first record')
        elif header.response_node not in contents.nodes:
            notes.drop(name, "no coordinates")
        else:
            points[header.response_node].append(function)
    repeats = len(points[min(points)]) if points else 0
    for node in [node for node, rows in points.items() if len(rows) != repeats]:
        notes.drop(f"point {node}", f"{len(points.pop(node))} records, where the scan has {repeats}")
    if not points:
        raise nothing_left(notes)
    nodes = list(points)
    notes.missing.extend(str(node) for node in contents.nodes if node not in points)
    drives, channel = _paired(references, points, ratio, contents)
    places = np.array([contents.nodes[node] for node in nodes])
    return TimeScan(
        source=_UffRecords(drives, [points[node] for node in nodes]),
        names=tuple(str(node) for node in nodes), x=places[:, 0].copy(), y=places[:, 1].copy(),
        repeats=repeats, samples=like.count,
        sample_rate=1 / like.step if like.step else 0.0, reference=channel,
        motion=unit.motion or "velocity",
        response_scale=unit.factor * (1 if like.response_axis >= 0 else -1),
        reference_scale=ratio[id(drives[0][0])].over.factor,
        direction=AXES[abs(like.response_axis) or 3],
        start=like.first,
        origin=origin,
        title=title,
    )  # fmt: skip


def _paired(
    references: list[Function],
    points: dict[int, list[Function]],
    ratio: dict[int, Ratio],
    contents: UffContents,
) -> tuple[list[list[Function]], Reference]:
    """Reference records of every point, or one row for all, and the quantity of the channel."""
    of_point: dict[int, list[Function]] = defaultdict(list)
    for function in references:
        of_point[function.header.response_node].append(function)
    repeats = len(next(iter(points.values())))
    if all(len(of_point.get(node, [])) == repeats for node in points):
        rows = [of_point[node] for node in points]
    elif len(references) == repeats:
        rows = [references]
    elif len(references) == repeats * len(points):
        contents.notes.remark("reference records were paired with the points by their order in the file")
        rows = [references[i : i + repeats] for i in range(0, len(references), repeats)]
    else:
        raise ScanError.mismatch(
            argument="reference channel",
            given=f"{len(references)} records of it for {len(points)} points with {repeats} each",
            allowed="one record for each of the points' records, or one set that all points share",
            cause="only the vibrometer's channel was exported",
            next_step="export the drive's voltage or the force as well",
        )
    header = rows[0][0].header
    unit = ratio[id(rows[0][0])].over.unit or "V"
    return rows, Reference(header.response_name or header.over.label or "reference", unit)


def _stacked(rows: list[list[Function]]) -> Samples:
    return np.array([[f.rows(0, f.header.count).real.astype(np.float32) for f in row] for row in rows])
