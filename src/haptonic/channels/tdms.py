"""NI TDMS files, by npTDMS in the reader process; samples stay in the file until they are used."""

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
    """Read the groups of a file; the rate of a channel is that of its waveform (``wf_increment``).

    Raises
    ------
    ChannelError : npTDMS is not installed, or the file is damaged
    """
    nptdms_for(path)
    tree = ask("tdms.tree", path)
    return {
        group["name"]: Group(
            group["name"],
            {channel["name"]: _channel(path, group["name"], **channel) for channel in group["channels"]},
            group["properties"],
            tree["properties"],
        )
        for group in tree["groups"]
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
    """(sample,) arrays of channels, each given by group and name, in one call of the reader process.

    Raises
    ------
    ChannelError : the file is damaged
    """
    return list(ask("tdms.channels", path, names=[list(name) for name in names]))


def write(path: Path, properties: Mapping[str, Any], segments: Iterable[Sequence[Group]]) -> None:
    """Write groups, one segment of the file after the other, so that they need not be in memory together.

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
    """The package npTDMS, which reads and writes TDMS files.

    Raises
    ------
    ChannelError : npTDMS is not installed
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
