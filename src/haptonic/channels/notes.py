"""What a reader left out: nothing is left out of a file without being named."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

ELSEWHERE = "it lies in another file, and such links are not followed"


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


@dataclass
class Notebook:
    """Collects what is dropped and what is assumed while a reader works.

    unread : what is in the file and cannot be read, by name
    """

    path: Path
    format: str
    dropped: list[Dropped] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)
    remarks: dict[str, None] = field(default_factory=dict)  # each once, found again at once
    unread: dict[str, str] = field(default_factory=dict)

    def drop(self, what: str, reason: str) -> None:
        self.dropped.append(Dropped(what, reason))

    def remark(self, text: str) -> None:
        self.remarks[text] = None

    def first_reasons(self) -> str:
        """The first things that were dropped, for the error of a file of which nothing is left."""
        return "; ".join(str(one) for one in self.dropped[:3]) or "it holds no measured curve"
