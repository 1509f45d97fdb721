"""Lists for people: entries with labelled lines, folded to the width of the terminal and never cut."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping

from rich.text import Text

from haptonic.cli.console import Voice

INDENT = 2


def entry(voice: Voice, head: str, lines: Mapping[str, str]) -> None:
    """Print a head, and below it a line for every label that has a text."""
    filled = {label: text for label, text in lines.items() if text}
    margin = INDENT + max(map(len, filled), default=0) + 2
    voice.write(Text(head, "bold"))
    for label, text in filled.items():
        start = f"{'':{INDENT}}{label}".ljust(margin)
        voice.write(Text(folded(text, voice.out.width, start, " " * margin)))


def pairs(voice: Voice, rows: Mapping[str, str]) -> None:
    """Print a line for each row, with the texts aligned."""
    margin = max(map(len, rows), default=0) + 2
    for head, text in rows.items():
        voice.write(Text(folded(text, voice.out.width, head.ljust(margin), " " * margin)))


def folded(text: str, width: int, start: str = "", behind: str = "") -> str:
    """A text folded to a width; the first line begins with ``start``, and long words are not broken."""
    return textwrap.fill(
        text,
        max(width, len(start) + 20),
        initial_indent=start,
        subsequent_indent=behind,
        break_long_words=False,
        break_on_hyphens=False,
    )
