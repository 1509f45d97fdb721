"""What a reader left out: nothing is left out of a file without being named."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

MOST_KINDS = 3  # of reasons, in a message
NUMBER = re.compile(r"[\d.]+")  # by which reasons of one kind differ
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
        """The kinds of what was dropped, for the error of a file of which nothing is left."""
        return "; ".join(by_kind(self.dropped)[:MOST_KINDS]) or "it holds no measured curve"


def by_kind(dropped: Sequence[Dropped]) -> list[str]:
    """A line for each kind of reason: the first thing dropped for it, and how many others."""
    kinds: dict[str, list[Dropped]] = {}
    for one in dropped:
        kinds.setdefault(NUMBER.sub("#", one.reason), []).append(one)
    return [
        str(first) if not others else f"{first.what} and {len(others)} more: {first.reason}"
        for first, *others in kinds.values()
    ]
