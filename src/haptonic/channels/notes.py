"""Notes of a reader on all content of a file that it leaves out."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

MOST_KINDS = 3  # of reasons, in a message
NUMBER = re.compile(r"[\d.]+")  # numbers do not distinguish kinds of reasons
ELSEWHERE = "it lies in another file, and such links are not followed"


@dataclass(frozen=True)
class Dropped:
    """Content of the file that is not in the result.

    what : such as "point 17" or "dataset 12"
    reason : reason for dropping it, as text
    """

    what: str
    reason: str

    def __str__(self) -> str:
        return f"{self.what}: {self.reason}"


@dataclass
class Notebook:
    """Dropped content and assumptions, collected while a reader works.

    unread : content of the file that cannot be read, by name
    """

    path: Path
    format: str
    dropped: list[Dropped] = field(default_factory=list)
    missing: list[str] = field(default_factory=list)
    remarks: dict[str, None] = field(default_factory=dict)  # a set that keeps the order
    unread: dict[str, str] = field(default_factory=dict)

    def drop(self, what: str, reason: str) -> None:
        self.dropped.append(Dropped(what, reason))

    def remark(self, text: str) -> None:
        self.remarks[text] = None

    def first_reasons(self) -> str:
        """Kinds of dropped content, for the error of a file without any usable content."""
        return "; ".join(by_kind(self.dropped)[:MOST_KINDS]) or "it has no measured curve"


def by_kind(dropped: Sequence[Dropped]) -> list[str]:
    """A line for each kind of reason: its first dropped item, and the number of others."""
    kinds: dict[str, list[Dropped]] = {}
    for item in dropped:
        kinds.setdefault(NUMBER.sub("#", item.reason), []).append(item)
    return [
        str(first) if not others else f"{first.what} and {len(others)} more: {first.reason}"
        for first, *others in kinds.values()
    ]
