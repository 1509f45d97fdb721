"""How long work tells how far it is: one callback with one signature, everywhere."""

from __future__ import annotations

from typing import Protocol


class Progress(Protocol):
    """Called with what is done, what is planned, and if it helps a word on what is done now.

    planned : 0 while nobody knows yet
    """

    def __call__(self, done: int, planned: int, what: str = "", /) -> object: ...


def silent(done: int, planned: int, what: str = "", /) -> None:
    """Tell nobody."""
