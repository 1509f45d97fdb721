"""One stroke: forces, and the position of the finger if it was recorded."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array
from haptonic.errors import FrictionError, nearest, shown

HEAVIEST = 100.0  # N, above the force of any finger
FURTHEST = 10.0  # m, above the length of any stroke
ACTUATIONS = ("on", "off")
EVERYBODY = "all participants"  # name for all together, among the conditions


@dataclass(frozen=True)
class Label:
    """Trial that a record belongs to.

    participant, waveguide : names
    block, trial : numbers, from 1; the trial counts within its block
    actuation : "on" or "off"
    """

    participant: str
    block: int
    trial: int
    waveguide: str
    actuation: str

    def __post_init__(self) -> None:
        if self.actuation not in ACTUATIONS:
            guess = nearest(str(self.actuation).lower(), ACTUATIONS)
            raise _bad(
                self, "actuation", self.actuation, '"on" or "off"', f'write "{guess}"' if guess else ""
            )
        for name in ("participant", "waveguide"):
            text = getattr(self, name)
            if not (isinstance(text, str) and text.strip()):
                raise _bad(self, name, text, "a name that is not empty")
        if self.participant == EVERYBODY:
            raise _bad(self, "participant", EVERYBODY, "another name: this one means all of them together")
        for name in ("block", "trial"):
            number = getattr(self, name)
            if not isinstance(number, int) or isinstance(number, bool) or number < 1:
                raise _bad(self, name, number, "a number from 1")

    def __str__(self) -> str:
        return f"participant {self.participant}, block {self.block}, trial {self.trial}"


def _bad(label: Label, name: str, given: object, allowed: str, next_step: str = "") -> FrictionError:
    parts = {each: f"{getattr(label, each)!s:.20}" for each in ("participant", "block", "trial")}
    where = ", ".join(f"{each} {value}" for each, value in parts.items() if value)
    return FrictionError.malformed(
        argument=f"{name} of {where}",
        given=shown(given),
        allowed=allowed,
        cause="a cell of the table is empty, misspelt or of another type",
        next_step=next_step or f"correct the {name} of this trial",
    )


@dataclass(frozen=True, eq=False)
class Record:
    """Forces of one stroke.

    normal, tangential : (samples,) N; normal is positive when the finger presses
    rate : sampling rate, Hz
    position : (samples,) m along the stroke, or None
    saturated : True if a channel of the sensor was at its end and the forces themselves do not show it
    across : (samples,) N, the other force in the plane, or None
    raw : (channel, row) channels at the rows of the file, which show the ends of their ranges; None if the
        forces are as in the file
    remarks : changes of the samples, such as bridged gaps
    """

    normal: Array
    tangential: Array
    rate: float
    position: Array | None = None
    saturated: bool = False
    across: Array | None = None
    raw: Array | None = None
    remarks: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if not (np.isfinite(self.rate) and self.rate > 0):
            raise _unusable(
                "rate", f"{self.rate} Hz", "a positive sampling rate in Hz", "no times were recorded"
            )
        channels = {
            "normal": self.normal, "tangential": self.tangential, "across": self.across,
            "position": self.position,
        }  # fmt: skip
        for name, channel in channels.items():
            if channel is None:
                continue
            array = np.asarray(channel)
            if array.ndim != 1 or array.dtype.kind not in "fi" or array.shape != np.shape(self.normal):
                raise _unusable(
                    name,
                    f"{array.dtype} of shape {array.shape}",
                    "real numbers, one for each sample, as many as of the normal force",
                    "a channel is missing or has another length",
                )
            limit, unit = (FURTHEST, "m") if name == "position" else (HEAVIEST, "N")
            largest = float(np.nanmax(np.abs(array), initial=0.0))
            if largest > limit:
                raise _unusable(
                    name,
                    f"up to {largest:.4g} {unit}",
                    f"at most {limit:g} {unit}",
                    "the channel is in mN, gram-force, mm or counts of the converter",
                    f"convert it to {unit} first",
                )

    @property
    def channels(self) -> Array:
        """(channel, row) channels at the rows of the file, or the forces."""
        return np.array([self.normal, self.tangential], dtype=float) if self.raw is None else self.raw


def _unusable(name: str, given: str, allowed: str, cause: str, next_step: str = "") -> FrictionError:
    return FrictionError.malformed(
        argument=f"record.{name}",
        given=given,
        allowed=allowed,
        cause=cause,
        next_step=next_step or "look at the file of this record",
    )
