"""Lists for people: entries of labelled lines, folded to the terminal and never cut."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping

from rich.text import Text

from haptonic.cli.console import Voice

INDENT = 2


def entry(voice: Voice, head: str, lines: Mapping[str, str]) -> None:
    """A head, and below it a line for every label that has a text."""
    said = {label: text for label, text in lines.items() if text}
    margin = INDENT + max(map(len, said), default=0) + 2
    voice.tell(Text(head, "bold"))
    for label, text in said.items():
        start = f"{'':{INDENT}}{label}".ljust(margin)
        voice.tell(Text(folded(text, voice.out.width, start, " " * margin)))


def pairs(voice: Voice, rows: Mapping[str, str]) -> None:
    """A line for each, the texts below one another."""
    margin = max(map(len, rows), default=0) + 2
    for head, text in rows.items():
        voice.tell(Text(folded(text, voice.out.width, head.ljust(margin), " " * margin)))


def folded(text: str, width: int, start: str = "", behind: str = "") -> str:
    """A text in lines of that width, the first behind ``start``; a word longer than a line stays whole."""
    return textwrap.fill(
        text,
        max(width, len(start) + 20),
        initial_indent=start,
        subsequent_indent=behind,
        break_long_words=False,
        break_on_hyphens=False,
    )
