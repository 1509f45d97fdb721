"""``trials.csv``, the list of trials and their files: written by protocols, read by the analysis."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import Literal

from haptonic.friction.signals import Label
from haptonic.names import cell

Per = Literal["trial", "block"]

NAME = "trials.csv"
HEAD = ("participant", "block", "trial", "waveguide", "actuation", "file", "order", "direction", "origin")
DIRECTION = "ulnar"  # all strokes go in one direction, as published [daunizeau-haptics]


def file_of(label: Label, suffix: str = ".csv", per: Per = "trial") -> str:
    """Name of the file with a trial's record, in the folder of the list."""
    trial = f"-T{label.trial:02d}" if per == "trial" else ""
    return f"{label.participant}-B{label.block:02d}{trial}{suffix}"


def write_list(
    labels: Sequence[Label],
    path: Path,
    *,
    suffix: str = ".csv",
    per: Per = "trial",
    origin: Literal["measured", "simulated"],
    lasting: float | None = None,
) -> None:
    """Write the list of trials in their order.

    Parameters
    ----------
    suffix, per : suffix of the files, and "trial" or "block" for the content of each file
    lasting : length of a trial, s, if one file contains the trials of a block one after the other; adds
        columns ``start`` and ``stop``
    """
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow((*HEAD, "start", "stop") if lasting else HEAD)
        for label, order in zip(labels, _places(labels), strict=True):
            row = [label.participant, label.block, label.trial, label.waveguide, label.actuation]
            row += [file_of(label, suffix, per), order, DIRECTION, origin]
            if lasting:
                row += [f"{(label.trial - 1) * lasting:.6g}", f"{label.trial * lasting:.6g}"]
            table.writerow(map(cell, row))


def _places(labels: Sequence[Label]) -> list[int]:
    """Position of every trial in the session of its participant, from 1."""
    count: dict[str, int] = {}
    places = []
    for label in labels:
        count[label.participant] = count.get(label.participant, 0) + 1
        places.append(count[label.participant])
    return places
