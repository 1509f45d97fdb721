"""What came out of reading a scan, and what did not: nothing is left out without being named."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

ELSEWHERE = "it lies in another file, and such links are not followed"
LISTED = 12  # lines of a text that is printed; the value itself holds them all


@dataclass(frozen=True)
class Dropped:
    """Something in the file that is not in the result.

    what : such as "point 17" or "dataset 12"
    reason : why it is not, in words
    """

    what: str
    reason: str

    def __str__(self) -> str:
        return f"{self.what}: {self.reason}"


@dataclass(frozen=True)
class ReadReport:
    """How a scan was read.

    path : of the file or folder
    format : of the file, such as "UFF"
    points : how many are in the result
    dropped : what was in the file but is not in the result
    missing : names of points that the geometry has but the file does not measure
    remarks : what was assumed, such as a unit that the file does not give
    """

    path: str
    format: str
    points: int
    dropped: tuple[Dropped, ...] = ()
    missing: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()

    @property
    def complete(self) -> bool:
        """Nothing was dropped and no point is missing."""
        return not self.dropped and not self.missing

    def __str__(self) -> str:
        lines = [f"{self.path}: {self.format}, {self.points} points"]
        lines += _listed("dropped", [str(one) for one in self.dropped])
        lines += _listed("not measured", self.missing)
        return "\n".join([*lines, *(f"  note: {remark}" for remark in self.remarks)])


@dataclass
class Notebook:
    """Collects what is dropped while a reader works; `closed` makes the report of it."""

    path: Path
    format: str
    dropped: list[Dropped] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)
    remarks: dict[str, None] = field(default_factory=dict)  # each once, found again at once

    def drop(self, what: str, reason: str) -> None:
        self.dropped.append(Dropped(what, reason))

    def remark(self, text: str) -> None:
        self.remarks[text] = None

    def closed(self, points: int) -> ReadReport:
        return ReadReport(
            str(self.path), self.format, points, tuple(self.dropped), tuple(self.missing), tuple(self.remarks)
        )

    def first_reasons(self) -> str:
        """The first things that were dropped, for the error of a file of which nothing is left."""
        return "; ".join(str(one) for one in self.dropped[:3]) or "it holds no measured curve"


def _listed(title: str, lines: Sequence[str]) -> list[str]:
    shown = [f"  {title}: {line}" for line in lines[:LISTED]]
    more = len(lines) - LISTED
    return [*shown, f"  {title}: {more} more"] if more > 0 else shown
