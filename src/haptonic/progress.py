"""Progress of long work: one callback with the same signature everywhere."""

from __future__ import annotations

import html
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Protocol

PATIENCE, PAUSE = 1.0, 0.2  # s before a notebook shows a bar, and between two updates


class Progress(Protocol):
    """Callback with the number of steps done and planned, and optionally the name of the current step.

    planned : 0 while the number is unknown
    """

    def __call__(self, done: int, planned: int, what: str = "", /) -> object: ...


def silent(done: int, planned: int, what: str = "", /) -> None:
    """Report nothing."""


def in_kernel() -> bool:
    """True in the kernel of a notebook."""
    module = sys.modules.get("IPython")  # loaded if this is a notebook
    return module is not None and hasattr(module.get_ipython(), "kernel")


@contextmanager
def in_notebook(doing: str) -> Iterator[Progress]:
    """A progress bar below the cell of a notebook if the work takes longer; no output elsewhere."""
    if not in_kernel():
        yield silent
        return
    module = sys.modules["IPython"]
    due, bar = time.monotonic() + PATIENCE, None

    def advance(done: int, planned: int, what: str = "", /) -> None:
        nonlocal due, bar
        if time.monotonic() < due:
            return
        due = time.monotonic() + PAUSE
        words = " ".join(filter(None, [doing, f"{done} of {planned}" if planned else "", what]))
        share = f' value="{done}" max="{planned}"' if planned else ""
        shown: dict[str, Any] = {
            "text/plain": words, "text/html": f"<progress{share}></progress> {html.escape(words)}",
        }  # fmt: skip
        if bar is None:
            bar = module.display.display(shown, raw=True, display_id=True)
        else:
            bar.update(shown, raw=True)

    try:
        yield advance
    finally:
        if bar is not None:
            bar.update({"text/plain": "", "text/html": ""}, raw=True)
