"""NI TDMS files, by npTDMS in the process that reads; samples stay in the file until they are asked for."""

from __future__ import annotations

import importlib
from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Any

from haptonic.channels.notes import Notebook
from haptonic.channels.signals import Channel, Group, Samples, number_of
from haptonic.errors import ChannelError
from haptonic.foreign.process import ask


def read(path: Path, notes: Notebook) -> dict[str, Group]:
    """Groups of a file; the rate of a channel is that of its waveform (``wf_increment``).

    Raises
    ------
    ChannelError : npTDMS is not installed, or the file is damaged
    """
    nptdms_for(path)
    found = ask("tdms.tree", path)
    return {
        one["name"]: Group(
            one["name"],
            {channel["name"]: _channel(path, one["name"], **channel) for channel in one["channels"]},
            one["properties"],
            found["properties"],
        )
        for one in found["groups"]
    }


def _channel(
    path: Path, group: str, name: str, length: int, properties: Mapping[str, Any], numbers: bool
) -> Channel:
    # npTDMS.time_track needs both properties of a waveform; a file may have one
    step = number_of(properties.get("wf_increment", 0.0))

    def rows(first: int, last: int) -> Samples:
        return samples(path, [(group, name)])[0][first:last]

    return Channel(
        name=name,
        shape=(length,),
        rows=rows,
        kind="number" if numbers else "text",
        unit=str(properties.get("unit_string") or ""),
        rate=1 / step if step > 0 else 0.0,
        start=number_of(properties.get("wf_start_offset", 0.0)),
    )


def samples(path: Path, names: Sequence[tuple[str, str]]) -> list[Samples]:
    """(sample,) of each channel, named by its group and its own name: many at once, in one question.

    Raises
    ------
    ChannelError : the file is damaged
    """
    return list(ask("tdms.channels", path, names=[list(name) for name in names]))


def write(path: Path, properties: Mapping[str, Any], segments: Iterable[Sequence[Group]]) -> None:
    """Write groups, a segment of the file after the other, so that they need not be in memory together.

    Raises
    ------
    ChannelError : npTDMS is not installed
    """
    nptdms = nptdms_for(path)
    with nptdms.TdmsWriter(path) as file:
        file.write_segment([nptdms.RootObject(dict(properties))])
        for groups in segments:
            parts = []
            for group in groups:
                parts.append(nptdms.GroupObject(group.name, dict(group.properties)))
                parts += map(partial(_written, nptdms, group.name), group.channels.values())
            file.write_segment(parts)


def _written(nptdms: ModuleType, group: str, channel: Channel) -> Any:
    timing = {"wf_increment": 1 / channel.rate, "wf_start_offset": channel.start} if channel.rate else {}
    return nptdms.ChannelObject(
        group, channel.name, channel.__array__(), {"unit_string": channel.unit, **timing}
    )


def nptdms_for(path: Path) -> ModuleType:
    """The package npTDMS, which is needed to read or write a file.

    Raises
    ------
    ChannelError : it is not installed
    """
    try:
        return importlib.import_module("nptdms")
    except ImportError as error:
        raise ChannelError.not_installed(
            argument="TDMS file",
            given=str(path),
            allowed="TDMS files where the package npTDMS is installed",
            cause="npTDMS is an optional part of haptonic and is not installed",
            next_step='pip install "haptonic[tdms]"',
        ) from error
