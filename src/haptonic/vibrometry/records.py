"""Time records of a scan: many points, one after the other, read in small portions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.channels import Channel
from haptonic.channels.labels import Motion
from haptonic.channels.signals import Samples
from haptonic.errors import ChannelError, ResourceError, ScanError
from haptonic.response import Reference

WRITTEN = 16  # points that are written to a file at a time


class Source(Protocol):
    """Source of records: a file, or arrays in memory."""

    def load(self, start: int, stop: int) -> tuple[Samples, Samples]:
        """Read reference and response of the points from ``start`` up to ``stop``.

        Returns
        -------
        Two arrays (point, repeat, sample) in SI units, or integers as stored; the first has one point if all
        points share the reference.
        """


@dataclass(frozen=True, eq=False)
class InMemory:
    """Records in arrays: (point or 1, repeat, sample) and (point, repeat, sample)."""

    reference: Samples
    response: Samples

    def load(self, start: int, stop: int) -> tuple[Samples, Samples]:
        shared = len(self.reference) == 1
        return self.reference if shared else self.reference[start:stop], self.response[start:stop]


@dataclass(frozen=True, eq=False)
class OfChannels:
    """Records in channels whose first axis is the point; all points share a channel with a single row."""

    reference: Channel
    response: Channel
    repeats: int
    samples: int

    def load(self, start: int, stop: int) -> tuple[Samples, Samples]:
        def rows(of: Channel) -> Samples:
            part = of.rows(0, 1) if of.shape[0] == 1 else of.rows(start, stop)
            return part.reshape(-1, self.repeats, self.samples)

        return rows(self.reference), rows(self.response)


@dataclass(frozen=True, eq=False)
class TimeScan:
    """Time records of all points of a scan, read into memory by `chunks`.

    source : source of the records
    names : names of the points, as numbered by the instrument
    x, y : (point,) m
    repeats, samples : records for each point, samples of each
    sample_rate : Hz
    motion : measured quantity of the response
    reference : quantity of the reference channel
    reference_scale, response_scale : SI units of one stored unit
    full_scale : largest stored value that the instrument can give for the response; None if unknown
    direction : "x", "y" or "z"
    start : time of the first sample after the trigger, s; the same for both channels
    origin : "measured" or "simulated"
    title : text for readers
    """

    source: Source
    names: tuple[str, ...]
    x: Array
    y: Array
    repeats: int
    samples: int
    sample_rate: float
    reference: Reference
    motion: Motion = "velocity"
    reference_scale: float = 1.0
    response_scale: float = 1.0
    full_scale: float | None = None
    direction: str = "z"
    start: float = 0.0
    origin: Literal["measured", "simulated"] = "measured"
    title: str = ""

    def __post_init__(self) -> None:
        for name, given in (("sample_rate", self.sample_rate), ("response_scale", self.response_scale),
                            ("reference_scale", self.reference_scale)):  # fmt: skip
            if not (np.isfinite(given) and given != 0 and (given > 0 or name != "sample_rate")):
                raise ScanError.out_of_range(
                    argument=f"records.{name}",
                    given=f"{given:g}",
                    allowed="a finite number that is not zero; a rate is positive",
                    cause="the file does not give it, or gives it wrongly",
                    next_step=f"give the {name.replace('_', ' ')} in the mapping or in the file",
                )
        if not np.isfinite(self.start):
            raise ScanError.out_of_range(
                argument="records.start",
                given=f"{self.start:g}",
                allowed="a finite time, s",
                cause="the file gives it wrongly",
                next_step="correct the start of the records in the file",
            )
        if not len(self.names) == len(self.x) == len(self.y) > 0:
            raise ScanError.mismatch(
                argument="records.names",
                given=f"{len(self.names)} names, {len(self.x)} and {len(self.y)} coordinates",
                allowed="one name and one pair of coordinates for each point, at least one point",
                cause="the geometry belongs to another scan",
                next_step="give one row of the geometry for each record",
            )

    @property
    def duration(self) -> float:
        """Duration of one record, s."""
        return self.samples / self.sample_rate

    def chunks(self, size: int, start: int = 0) -> Iterator[tuple[int, Samples, Samples]]:
        """Yield number of the first point, reference and response, ``size`` points at a time, as stored."""
        for first in range(start, len(self.names), size):
            yield first, *self.load(first, min(first + size, len(self.names)))

    def load(self, start: int, stop: int) -> tuple[Samples, Samples]:
        """Read reference and response of some points; see `Source`.

        Raises
        ------
        ScanError : the file is damaged
        ResourceError : the records do not fit into memory
        """
        try:
            return self.source.load(start, stop)
        except ChannelError as error:
            raise error.changed(ScanError) from error
        except (MemoryError, ResourceError) as error:
            raise ResourceError.too_large(
                argument="records",
                given=f"{stop - start} points of {self.repeats} x {self.samples} samples",
                allowed="records of which a few points fit into memory",
                cause="the file announces more than it contains, or records are very long",
                next_step="look at the file's number of samples, or divide the records",
            ) from error


def portions(scan: TimeScan) -> Iterator[tuple[int, NDArray[np.float32], NDArray[np.float32]]]:
    """Yield number of the first point, reference and response in SI units and single precision, a few points
    at a time."""
    for first, reference, response in scan.chunks(WRITTEN):
        yield (
            first,
            np.asarray(reference * scan.reference_scale, dtype=np.float32),
            np.asarray(response * scan.response_scale, dtype=np.float32),
        )
