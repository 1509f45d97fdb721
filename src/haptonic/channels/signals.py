"""What a file of signals holds: channels with a name, a unit, a rate and samples, in groups."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.channels.notes import Notebook
from haptonic.errors import ChannelError

Samples = NDArray[Any]
Kind = Literal["number", "complex", "text"]
Origin = Literal["measured", "simulated"]

ORIGIN = "origin"  # a property of every format
SIMULATED: Literal["simulated"] = "simulated"  # and its value
RATES = ("sample_rate", "sampling_rate", "fs", "rate")  # Hz: properties that may say it
KINDS: dict[str, Kind] = {"c": "complex", "O": "text", "U": "text", "S": "text"}


@dataclass(frozen=True, eq=False)
class Channel:
    """A signal, or a table of them. Its numbers may stay in the file until somebody asks for them.

    name : without the unit that a column such as "Fz (mN)" ends with
    shape : samples last
    rows : those of the first axis from a start up to a stop, in the unit of the file
    unit : as the file writes it; empty where it does not say
    rate : Hz; 0 where the file does not say
    start : time of the first sample, s
    streamed : whether the numbers are in the file still, so that a part of them is cheaper than all
    properties : what else the file says of it
    """

    name: str
    shape: tuple[int, ...]
    rows: Callable[[int, int], Samples] = field(repr=False)
    kind: Kind = "number"
    unit: str = ""
    rate: float = 0.0
    start: float = 0.0
    streamed: bool = True
    properties: Mapping[str, Any] = field(default_factory=dict, repr=False)

    @classmethod
    def of(cls, name: str, values: Samples, unit: str = "", rate: float = 0.0, start: float = 0.0) -> Channel:
        """A channel whose numbers are in memory."""

        def rows(first: int, last: int) -> Samples:
            return values[first:last] if values.ndim else values

        kind = KINDS.get(values.dtype.kind, "number")
        return cls(
            name=name,
            shape=values.shape,
            rows=rows,
            kind=kind,
            unit=unit,
            rate=rate,
            start=start,
            streamed=False,
        )

    @property
    def size(self) -> int:
        """How many numbers it has."""
        return math.prod(self.shape)

    @property
    def is_signal(self) -> bool:
        """Whether it has numbers along one axis, whatever axes of length one are beside it."""
        long = len(self.shape) == 1 or self.size == max(self.shape, default=0) > 1
        return self.kind == "number" and long

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Samples:
        """All of it, in the unit of the file."""
        return np.asarray(self.rows(0, self.shape[0] if self.shape else 1), dtype=dtype)


@dataclass(frozen=True, eq=False)
class Group:
    """Channels that belong together.

    properties : what the file says of them
    of_file : what it says of all groups
    """

    name: str
    channels: Mapping[str, Channel]
    properties: Mapping[str, Any] = field(default_factory=dict)
    of_file: Mapping[str, Any] = field(default_factory=dict)
    _kept: dict[str, Array] = field(default_factory=dict, repr=False)

    @cached_property
    def signals(self) -> dict[str, Channel]:
        """The channels that are signals."""
        return {name: channel for name, channel in self.channels.items() if channel.is_signal}

    def __getitem__(self, name: str) -> Array:
        """(sample,) one signal, in the unit of the file; read once, then kept.

        Raises
        ------
        ChannelError : no such signal, or it holds text
        """
        if name not in self._kept:
            if name not in self.signals:
                raise self._lacks(name)
            try:
                self._kept[name] = np.asarray(self.signals[name], dtype=float).ravel()
            except (TypeError, ValueError):
                raise ChannelError.malformed(
                    argument=f"channel {name}",
                    given="text among the numbers",
                    allowed="numbers",
                    cause="a line of text within the data, or decimal commas",
                    next_step="look at the file in a text editor",
                ) from None
        return self._kept[name]

    @property
    def rate(self) -> float | None:
        """Sampling rate that the file gives, Hz; None if it gives none."""
        says = {**self.of_file, **self.properties}
        said = [number_of(says[name]) for name in RATES if name in says]
        rates = [*said, *(channel.rate for channel in self.signals.values())]
        return next((rate for rate in rates if math.isfinite(rate) and rate > 0), None)

    @property
    def simulated(self) -> bool:
        """Whether the file says that it is."""
        says = {**self.of_file, **self.properties}
        flag, origin = says.get(SIMULATED, False), says.get(ORIGIN)
        # an attribute of a damaged file may be an array
        return (isinstance(origin, str) and origin == SIMULATED) or (
            isinstance(flag, int | float) and bool(flag)
        )

    def _lacks(self, name: str) -> ChannelError:
        cause = "the column has another name, or the file is another one"
        return ChannelError.unknown(f"channel {name}", name, self.signals, cause)


@dataclass(frozen=True, eq=False)
class SignalFile:
    """What is in a file. Channels outside of any group are in the group "".

    notes : what was not read, and why
    """

    path: Path
    groups: Mapping[str, Group]
    notes: Notebook

    def group(self, name: str) -> Group:
        """A group by its name; "" is what lies outside of all, or else the only group.

        Raises
        ------
        ChannelError : there is no such group
        """
        named = [one for one in self.groups if one]
        if not name and "" not in self.groups and len(named) == 1:
            return self.groups[named[0]]
        found = self.groups.get(name)
        if found is not None and (name or found.signals or not named):
            return found
        cause = "the column group of the table of trials is missing, or a name in it is misspelt"
        raise ChannelError.unknown(f"group in {self.path.name}", name, named[:10], cause)


def number_of(given: object) -> float:
    """A property as a number; a text that is none is NaN."""
    try:
        return float(str(given))
    except ValueError:
        return float("nan")
