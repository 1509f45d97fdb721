"""Content of a file of signals: channels with a name, a unit, a rate and samples, in groups."""

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
RATES = ("sample_rate", "sampling_rate", "fs", "rate")  # Hz: properties for the rate
KINDS: dict[str, Kind] = {"c": "complex", "O": "text", "U": "text", "S": "text"}


@dataclass(frozen=True, eq=False)
class Channel:
    """A signal, or a table of signals. Its numbers may stay in the file until they are used.

    name : without the unit at the end of a column's heading such as "Fz (mN)"
    shape : with samples along the last axis
    rows : function that reads rows of the first axis, from a start up to a stop, in the unit of the file
    unit : as in the file; empty if missing
    rate : Hz; 0 if the file does not give it
    start : time of the first sample, s
    streamed : True if the numbers are still in the file, so that reading a part is cheaper than reading all
    properties : further properties in the file
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
        """Make a channel of numbers in memory."""

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
        """Number of values."""
        return math.prod(self.shape)

    @property
    def is_signal(self) -> bool:
        """True for numbers along one axis; further axes of length one do not matter."""
        long = len(self.shape) == 1 or self.size == max(self.shape, default=0) > 1
        return self.kind == "number" and long

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Samples:
        """All values, in the unit of the file."""
        return np.asarray(self.rows(0, self.shape[0] if self.shape else 1), dtype=dtype)


@dataclass(frozen=True, eq=False)
class Group:
    """Channels that belong together.

    properties : properties of the group
    of_file : properties of the whole file
    """

    name: str
    channels: Mapping[str, Channel]
    properties: Mapping[str, Any] = field(default_factory=dict)
    of_file: Mapping[str, Any] = field(default_factory=dict)
    _read_signals: dict[str, Array] = field(default_factory=dict, repr=False)

    @cached_property
    def signals(self) -> dict[str, Channel]:
        """Channels that are signals."""
        return {name: channel for name, channel in self.channels.items() if channel.is_signal}

    def __getitem__(self, name: str) -> Array:
        """(sample,) one signal, in the unit of the file; read once, then stored.

        Raises
        ------
        ChannelError : no such signal, or a signal that contains text
        """
        if name not in self._read_signals:
            if name not in self.signals:
                raise self._lacks(name)
            try:
                self._read_signals[name] = np.asarray(self.signals[name], dtype=float).ravel()
            except (TypeError, ValueError):
                raise ChannelError.malformed(
                    argument=f"channel {name}",
                    given="text among the numbers",
                    allowed="numbers",
                    cause="a line of text within the data, or decimal commas",
                    next_step="look at the file in a text editor",
                ) from None
        return self._read_signals[name]

    @property
    def rate(self) -> float | None:
        """Sampling rate from the file, Hz; None if it has none."""
        properties = {**self.of_file, **self.properties}
        given = [number_of(properties[name]) for name in RATES if name in properties]
        rates = [*given, *(channel.rate for channel in self.signals.values())]
        return next((rate for rate in rates if math.isfinite(rate) and rate > 0), None)

    @property
    def simulated(self) -> bool:
        """True if the file is marked as simulated."""
        properties = {**self.of_file, **self.properties}
        flag, origin = properties.get(SIMULATED, False), properties.get(ORIGIN)
        # an attribute of a damaged file may be an array
        return (isinstance(origin, str) and origin == SIMULATED) or (
            isinstance(flag, int | float) and bool(flag)
        )

    def _lacks(self, name: str) -> ChannelError:
        cause = "the column has another name, or the file is another one"
        return ChannelError.unknown(f"channel {name}", name, self.signals, cause)


@dataclass(frozen=True, eq=False)
class SignalFile:
    """Content of a file. Channels outside of any group are in the group "".

    notes : content that was not read, with reasons
    """

    path: Path
    groups: Mapping[str, Group]
    notes: Notebook

    def group(self, name: str) -> Group:
        """A group by its name; "" is the group of channels outside of any, or else the only group.

        Raises
        ------
        ChannelError : no such group
        """
        named = [group_name for group_name in self.groups if group_name]
        if not name and "" not in self.groups and len(named) == 1:
            return self.groups[named[0]]
        group = self.groups.get(name)
        if group is not None and (name or group.signals or not named):
            return group
        cause = "the column group of the table of trials is missing, or a name in it is misspelt"
        raise ChannelError.unknown(f"group in {self.path.name}", name, named[:10], cause)


def number_of(given: object) -> float:
    """Number in a property; NaN for a text that is not a number."""
    try:
        return float(str(given))
    except ValueError:
        return float("nan")
