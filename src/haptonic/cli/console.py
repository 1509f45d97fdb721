"""Output of commands: tables and messages for people, one JSON object for machines."""

from __future__ import annotations

import errno
import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from rich.cells import cell_len
from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress as Bar,
    SpinnerColumn,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)
from rich.table import Table as RichTable
from rich.text import Text

from haptonic.cli.streams import UNHEARD, mute
from haptonic.errors import HaptonicError, HaptonicWarning
from haptonic.gate import json_of
from haptonic.names import visible
from haptonic.progress import Progress, silent
from haptonic.results.table import NOTHING, Table

USER_ERROR = 2
INTERRUPTED = 130
ROOMY = 6  # columns that fit, with spaces around them, into a terminal 80 columns wide


class PlainConsole(Console):
    """A terminal that prints names and contents of files as they are, without markup and control codes."""

    def __init__(self, *, stderr: bool = False) -> None:
        super().__init__(stderr=stderr, markup=False, emoji=False)

    def on_broken_pipe(self) -> None:
        """Go on if the reader of the answer has ended; rich would end here, before files are written."""
        self.quiet = True
        mute(self.file)

    def render_str(self, text: str, **how: Any) -> Text:
        """Make control codes visible; rich calls this for every text, cells of tables too."""
        return super().render_str(visible(text), **how)


@dataclass
class Voice:
    """Standard output and standard error of a command.

    machine : True for ``--json``: standard output then contains one object and nothing else
    """

    machine: bool
    out: Console = field(default_factory=PlainConsole)
    err: Console = field(default_factory=lambda: PlainConsole(stderr=True))
    warned: list[str] = field(default_factory=list)
    unheard: OSError | None = None  # why the answer could not be printed

    @contextmanager
    def _printing(self) -> Iterator[None]:
        """Note if nothing can be printed, and go on: the files of the command are still to be written."""
        try:
            yield
        except OSError as error:
            if error.errno not in (*UNHEARD, errno.EPIPE):
                raise
            self.unheard = error if error.errno in UNHEARD else None
            self.out.quiet = True
            mute(sys.stdout)

    def write(self, content: object) -> None:
        """Print a line of text on standard output; silent with ``--json``."""
        if not self.machine:
            with self._printing():
                self.out.print(content)

    def print(self, text: str) -> None:
        """Print text for another program at once and without changing it; silent with ``--json``."""
        if not self.machine:
            with self._printing():
                sys.stdout.write(text)
                sys.stdout.flush()

    def remark(self, text: str) -> None:
        """Print a remark on progress on standard error; silent with ``--json``."""
        if not self.machine:
            self.err.print(Text(text, "dim"), soft_wrap=True)

    def answer(self, values: dict[str, Any]) -> None:
        """Print the JSON object; silent without ``--json``."""
        if self.machine:
            _print_json({**values, "warnings": self.warned})

    def refuse(self, error: HaptonicError) -> None:
        """Print the five parts of an error, with the next step for the command line."""
        error = error.for_command()
        if self.machine:
            _print_json({"error": error.parts(), "warnings": self.warned})
        rows = {
            "argument": error.argument,
            "given": error.given,
            "allowed": error.allowed,
            "likely cause": error.cause,
            "next step": error.next_step,
            "code": error.code,
        }
        self.err.print(Text("error", "bold red"))
        for title, text in rows.items():
            row = Text.assemble("  ", (f"{title:<13}", "bold"), text)
            self.err.print(row, soft_wrap=True, highlight=False)

    def warn(self, text: str) -> None:
        """Print a warning; a repeated one is printed once."""
        if text in self.warned:
            return
        self.warned.append(text)
        row = Text.assemble(("warning", "yellow"), " ", visible(text))
        self.err.print(row, soft_wrap=True, highlight=False)

    def show(self, content: Table) -> None:
        """Print a table; silent with ``--json``."""
        if not self.machine:
            with self._printing():
                for part in self._parts(content):
                    self.out.print(self._drawn(part))

    def height(self, content: Table) -> int:
        """Number of terminal lines that a table needs."""
        return sum(len(self.out.render_lines(self._drawn(part))) for part in self._parts(content))

    def _parts(self, content: Table) -> list[Table]:
        """Split a table that is too wide for whole words and numbers; each part repeats the first column."""
        folded = [_longest_word(column) for column in zip(*_rows(content), strict=True)]
        groups: list[list[int]] = [[0]]
        for number in range(1, len(folded)):
            tried = [*groups[-1], number]
            if len(tried) > 2 and sum(folded[column] for column in tried) > self._room(len(tried)):
                groups.append([0, number])
            else:
                groups[-1] = tried
        if len(groups) == 1:
            return [content]
        titles = [content.title, *[f"{content.title} (continued)"] * (len(groups) - 1)]
        return [content.of_columns(group, title) for group, title in zip(groups, titles, strict=True)]

    def _room(self, count: int) -> int:
        """Width in letters for the contents of so many columns."""
        return self.out.width - count * (2 * _padding(count) + 1) - 1

    def _drawn(self, content: Table) -> RichTable:
        """Lay out a table for this terminal.

        In a narrow terminal heads and words are folded first, then numbers are separated from their errors,
        then words and numbers that are wider than the terminal are broken; nothing is cut off.
        """
        padding, room = _padding(len(content.columns)), self._room(len(content.columns))
        rows = _rows(content)
        columns = list(zip(*rows, strict=True))
        folded = [_longest_word(column) for column in columns]
        whole = [max(map(cell_len, cells), default=0) if _numeric(cells) else 0 for _, *cells in columns]
        least = [max(pair) for pair in zip(folded, whole, strict=True)]
        least = least if sum(least) <= room else folded
        widths = _fitting([max(map(cell_len, column)) for column in columns], least, room)
        widths = _fitting(widths, [1] * len(widths), room)
        shown = RichTable(title=content.title, padding=(0, padding))
        for head, width in zip(content.head, widths, strict=True):
            shown.add_column(head, overflow="fold", width=width)
        for number, row in enumerate(rows[1:]):
            shown.add_row(*row, style="bold" if number in content.strong else "")
        return shown

    @contextmanager
    def counted(self, what: str) -> Iterator[Progress]:
        """Show a progress bar with the time left on standard error; yields the callback that moves it.

        Until steps are planned, only the elapsed time changes. If standard error is a file, no bar is shown.
        """
        if not self.err.is_terminal:
            yield silent
            return
        columns = (
            SpinnerColumn(), TextColumn("{task.description}", markup=False), BarColumn(),
            MofNCompleteColumn(),
            TextColumn("elapsed"), TimeElapsedColumn(), TextColumn("left"), TimeRemainingColumn(),
        )  # fmt: skip
        with Bar(*columns, console=self.err, transient=True) as bar:
            task = bar.add_task(what, total=None)

            def progress(done: int, planned: int, now: str = "", /) -> None:
                words = f"{what}: {now}" if now else what
                bar.update(task, completed=done, total=planned or None, description=words)

            yield progress


@contextmanager
def speaking(machine: bool, kept: str = "") -> Iterator[Voice]:
    """Run the work of a command: an error ends in five parts and exit code 2, Ctrl-C in the text ``kept``."""
    voice = Voice(machine)
    with warnings.catch_warnings():
        warnings.simplefilter("always", HaptonicWarning)
        default = warnings.showwarning

        def show(message: Any, category: Any, *rest: Any, **more: Any) -> None:
            if issubclass(category, HaptonicWarning):
                voice.warn(str(message))
            else:
                default(message, category, *rest, **more)

        warnings.showwarning = show
        try:
            yield voice
            if voice.unheard is not None:
                raise voice.unheard
        except HaptonicError as error:
            voice.refuse(error)
            raise SystemExit(USER_ERROR) from None
        except KeyboardInterrupt:
            if machine:
                _print_json({"interrupted": True, "warnings": voice.warned})
            voice.err.print(Text.assemble(("interrupted", "yellow"), f": {kept}" if kept else ""))
            raise SystemExit(INTERRUPTED) from None
        finally:
            warnings.showwarning = default


def _padding(count: int) -> int:
    return 0 if count > ROOMY else 1


def _rows(content: Table) -> list[tuple[str, ...]]:
    """Heads of the columns, then the texts of each row."""
    return [content.head, *(content.texts or [("none", *[""] * (len(content.columns) - 1))])]


def _longest_word(texts: Sequence[str]) -> int:
    return max((cell_len(word) for text in texts for word in text.split()), default=0)


def _fitting(widths: Sequence[int], least: Sequence[int], room: int) -> list[int]:
    """Widths of columns: the widest are narrowed until all fit, but none below its least width."""
    fitted = list(widths)
    while sum(fitted) > room:
        spare = [width if width > low else 0 for width, low in zip(fitted, least, strict=True)]
        if not any(spare):
            break
        fitted[spare.index(max(spare))] -= 1
    return fitted


def _numeric(cells: Sequence[str]) -> bool:
    return all(cell == NOTHING or cell[:1] in "+-0123456789" for cell in cells)


def _print_json(values: dict[str, Any]) -> None:
    sys.stdout.write(json_of(values) + "\n")
    sys.stdout.flush()
