"""Simulated folders of force records, as an experiment leaves them."""

from __future__ import annotations

from collections.abc import Callable
from itertools import groupby
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pandas as pd
import scipy.io

from haptonic.friction.participants import Participants
from haptonic.friction.protocol import Protocol
from haptonic.friction.signals import Label, Record
from haptonic.friction.simulation import Truth, strokes

Made = list[tuple[Label, Record]]
Channels = dict[str, np.ndarray]


def truth_of(**changes: Any) -> Truth:
    """A truth, and its people, with some numbers changed."""
    people = {name: changes.pop(name) for name in vars(Participants()) if name in changes}
    return Truth(Participants(**people), **changes)


def simulated(participants: int = 3, blocks: int = 2, trials: int = 6, seed: int = 0, **truth: Any) -> Made:
    """Labels and records of an experiment."""
    experiment = strokes(truth_of(**truth), Protocol(blocks, trials), participants, seed)
    return [(label, record) for label, record, _ in experiment]


def channels(records: list[Record]) -> Channels:
    """Named channels of records that follow each other."""
    normal = np.concatenate([record.normal for record in records])
    return {
        "time": np.arange(len(normal)) / records[0].rate,
        "Fx": np.zeros_like(normal),
        "Fy": np.concatenate([record.tangential for record in records]),
        "Fz": normal,
        "position": np.concatenate([record.position for record in records]),
    }


def write_csv(columns: Channels, path: Path) -> None:
    pd.DataFrame(columns).to_csv(path, index=False)


def write_h5(columns: Channels, path: Path) -> None:
    with h5py.File(path, "w") as file:
        for name, values in columns.items():
            file[name] = values


def write_mat(columns: Channels, path: Path) -> None:
    scipy.io.savemat(path, columns, oned_as="column")


def write_tdms(columns: Channels, path: Path) -> None:
    from nptdms import ChannelObject, TdmsWriter

    with TdmsWriter(path) as file:
        file.write_segment([ChannelObject("records", name, values) for name, values in columns.items()])


WRITERS = {"csv": write_csv, "h5": write_h5, "hdf5": write_h5, "mat": write_mat, "tdms": write_tdms}


def written(
    folder: Path,
    trials: Made,
    *,
    kind: str = "csv",
    per: str = "trial",
    change: Callable[[Channels], Channels] = lambda columns: columns,
    **more: Any,
) -> Path:
    """A folder with ``trials.csv`` and a file for each trial or block; ``more`` are columns of the table."""
    folder.mkdir(exist_ok=True)
    rows = []
    parts = [[trial] for trial in trials]
    if per == "block":
        parts = [
            list(group) for _, group in groupby(trials, lambda trial: (trial[0].participant, trial[0].block))
        ]
    for part in parts:
        first = part[0][0]
        name = f"{first.participant}-B{first.block}-T{first.trial}.{kind}"
        WRITERS[kind](change(channels([record for _, record in part])), folder / name)
        start = 0.0
        for label, record in part:
            stop = start + len(record.normal) / record.rate
            row = {name: getattr(label, name) for name in Label.__dataclass_fields__}
            rows.append(
                row | {"file": name} | ({"start": start, "stop": stop} if per == "block" else {}) | more
            )
            start = stop
    pd.DataFrame(rows).to_csv(folder / "trials.csv", index=False)
    return folder


def edited(folder: Path, change: Callable[[pd.DataFrame], pd.DataFrame]) -> Path:
    """The folder with its table of trials changed."""
    change(pd.read_csv(folder / "trials.csv")).to_csv(folder / "trials.csv", index=False)
    return folder
