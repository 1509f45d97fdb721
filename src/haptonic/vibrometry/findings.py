"""Report on reading a scan: content that was used, left out, or assumed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from haptonic.channels import Dropped, Notebook
from haptonic.channels.notes import by_kind

__all__ = ["Dropped", "ReadReport"]
LISTED = 12  # lines of the printed text; the value itself has all of them


@dataclass(frozen=True)
class ReadReport:
    """Report on reading a scan.

    path : path of the file or folder
    format : format of the file, such as "UFF"
    points : number of points in the result
    dropped : content of the file that is not in the result
    missing : names of points in the geometry without a measurement
    remarks : assumptions, such as a unit that the file does not give
    """

    path: str
    format: str
    points: int
    dropped: tuple[Dropped, ...] = ()
    missing: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()

    @classmethod
    def of(cls, notes: Notebook, points: int) -> ReadReport:
        """Make the report from a reader's notes and its number of points."""
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
        """A report of two steps: the points of the later one, and the content dropped and assumed in both."""
        dropped, remarks = (
            (*a, *b) for a, b in ((self.dropped, later.dropped), (self.remarks, later.remarks))
        )
        return replace(
            self, points=later.points, dropped=tuple(dict.fromkeys(dropped)),
            remarks=tuple(dict.fromkeys(remarks)),
        )  # fmt: skip

    @property
    def complete(self) -> bool:
        """True if nothing was dropped and no point is missing."""
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
