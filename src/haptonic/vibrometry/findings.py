"""What came out of reading a scan, and what did not: nothing is left out without being named."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from haptonic.channels import Dropped, Notebook
from haptonic.channels.notes import by_kind

__all__ = ["Dropped", "ReadReport"]
LISTED = 12  # lines of a text that is printed; the value itself holds them all


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

    @classmethod
    def of(cls, notes: Notebook, points: int) -> ReadReport:
        """What a reader noted, and how many points it gave."""
        dropped, missing, remarks = tuple(notes.dropped), tuple(notes.missing), tuple(notes.remarks)
        return cls(
            path=str(notes.path),
            format=notes.format,
            points=points,
            dropped=dropped,
            missing=missing,
            remarks=remarks,
        )

    def followed_by(self, later: ReadReport) -> ReadReport:
        """The same with the points left in the end, and what was left out and assumed on the way."""
        dropped, remarks = (
            (*a, *b) for a, b in ((self.dropped, later.dropped), (self.remarks, later.remarks))
        )
        return replace(
            self, points=later.points, dropped=tuple(dict.fromkeys(dropped)),
            remarks=tuple(dict.fromkeys(remarks)),
        )  # fmt: skip

    @property
    def complete(self) -> bool:
        """Nothing was dropped and no point is missing."""
        return not self.dropped and not self.missing

    def __str__(self) -> str:
        lines = [f"{self.path}: {self.format}, {self.points} points"]
        lines += _listed("dropped", by_kind(self.dropped))
        lines += _listed("not measured", self.missing)
        return "\n".join([*lines, *(f"  note: {remark}" for remark in self.remarks)])


def _listed(title: str, lines: Sequence[str]) -> list[str]:
    shown = [f"  {title}: {line}" for line in lines[:LISTED]]
    more = len(lines) - LISTED
    return [*shown, f"  {title}: {more} more"] if more > 0 else shown
