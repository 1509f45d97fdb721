"""A job of the studio: an ordered analysis, and its answer as far as it is computed."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import Any

from haptonic.studio.offers import as_command, as_python, measured_files, offered
from haptonic.studio.order import Order

LONGEST_TITLE = 200  # characters in the list, which is sent after every change


@dataclass(eq=False)
class Job:
    """An ordered analysis and its answer so far.

    state : "running", "done", "failed", "cancelled", or "interrupted" by the end of its server
    begun : True after the worker has received the order
    progress : steps done and planned, and the name of the current one; planned is 0 while it is unknown
    command, python : lines that repeat it
    points : computed designs, see `haptonic.analyses.points`
    first : count of the versions of the part that is computed first, and view of the newest
    knobs : numbers that can be turned, see `haptonic.analyses.turning`
    previews : by path of a number, count of the improvements so far and view
    by_command : True for a run of the command line
    """

    order: Order
    command: str = ""
    python: str = ""
    state: str = "running"
    begun: bool = False
    started: float = field(default_factory=time.time)
    seconds: float = 0.0
    cost: str = ""
    progress: tuple[int, int, str] = (0, 0, "")
    points: list[dict[str, Any]] = field(default_factory=list)
    error: dict[str, str] | None = None
    answer: dict[str, Any] | None = None
    first: tuple[int, bytes] = (0, b"")
    view: bytes | None = None
    knobs: list[dict[str, Any]] | None = None
    previews: dict[str, tuple[int, bytes]] = field(default_factory=dict)
    by_command: bool = False

    @classmethod
    def ordered(cls, order: Order) -> Job:
        """The job of an order."""
        analysis, file = offered(order.analysis), order.file
        options, alone = order.options, order.alone
        command = as_command(analysis, file, options, alone=alone)
        return cls(order, command, as_python(analysis, file, options, alone=alone))

    @property
    def number(self) -> int:
        """Number of the order."""
        return self.order.number

    @property
    def file(self) -> str:
        """File of the study; of a job without a study, the files that it reads."""
        own = self.order
        return measured_files(offered(own.analysis), own.options) if own.alone else own.file

    @property
    def is_kept(self) -> bool:
        """True if the archive keeps the job: it has an answer or points, or it can be continued.

        Designs on the way of a slider would push out other runs.
        """
        is_left = self.state in ("running", "interrupted")
        return not self.order.turned and (is_left or self.answer is not None or bool(self.points))

    def brief(self) -> dict[str, Any]:
        """State for the list of jobs."""
        return {
            "number": self.number, "analysis": self.order.analysis, "file": self.file,
            "title": self.order.title[:LONGEST_TITLE], "started": self.started,
            "state": self.state, "cost": self.cost, "progress": self.progress,
            "points": len(self.points), "turned": bool(self.order.turned), "byCommand": self.by_command,
            "archived": False, "first": self.first[0], "turns": self.knobs is not None,
            "previews": {path: count for path, (count, _) in self.previews.items()},
            "seconds": round(time.time() - self.started if self.state == "running" else self.seconds, 1),
        }  # fmt: skip

    def whole(self) -> dict[str, Any]:
        """State, answer, the study's text, and the lines that repeat it."""
        return self.brief() | {
            "text": self.order.text, "error": self.error, "answer": self.answer,
            "view": self.view is not None, "command": self.command, "python": self.python,
            "options": dict(self.order.options), "alone": self.order.alone,
        }  # fmt: skip

    def finish(self, state: str) -> None:
        """Set the last state and the time that the job took."""
        self.state, self.seconds = state, time.time() - self.started
