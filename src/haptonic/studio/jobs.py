"""Jobs of the studio: each is computed in a worker process, and the latest replaces one that still runs."""

from __future__ import annotations

import multiprocessing
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

from haptonic.errors import ResourceError
from haptonic.studio.offers import as_command, as_python, offered
from haptonic.studio.worker import Order, serve

KEPT = 8  # jobs whose answers stay in memory


@dataclass(eq=False)
class Job:
    """An ordered analysis and its answer so far.

    state : "running", "done", "failed" or "cancelled"
    begun : True after the worker has received the order
    progress : steps done and planned, and the name of the current one; planned is 0 while it is unknown
    picture : SVG by name
    """

    order: Order
    state: str = "running"
    begun: bool = False
    started: float = field(default_factory=time.time)
    seconds: float = 0.0
    cost: str = ""
    progress: tuple[int, int, str] = (0, 0, "")
    error: dict[str, str] | None = None
    answer: dict[str, Any] | None = None
    view: bytes | None = None
    pictures: dict[str, bytes] = field(default_factory=dict)
    drawn: bool = False

    @property
    def number(self) -> int:
        """Number of the order."""
        return self.order.number

    def brief(self) -> dict[str, Any]:
        """State for the list of jobs."""
        return {
            "number": self.number, "analysis": self.order.analysis, "file": self.order.file,
            "state": self.state, "cost": self.cost, "progress": self.progress, "drawn": self.drawn,
            "pictures": list(self.pictures),
            "seconds": round(time.time() - self.started if self.state == "running" else self.seconds, 1),
        }  # fmt: skip

    def whole(self) -> dict[str, Any]:
        """State, answer, the study's text, and the command and the line of Python that repeat it."""
        analysis, file = offered(self.order.analysis), self.order.file
        return self.brief() | {
            "text": self.order.text, "error": self.error, "answer": self.answer,
            "view": self.view is not None,
            "command": as_command(analysis, file, self.order.options),
            "python": as_python(analysis, file, self.order.options),
        }  # fmt: skip

    def finish(self, state: str) -> None:
        """Set the last state and the time that the job took."""
        self.state, self.seconds = state, time.time() - self.started


class Worker:
    """A worker process and the thread that listens to it."""

    def __init__(self, heard: Callable[[Worker, str, int, Any], None]) -> None:
        # spawned, because the fork of a process with threads may hang
        context = multiprocessing.get_context("spawn")
        self.connection, theirs = context.Pipe()
        self.process = context.Process(target=serve, args=(theirs,), daemon=True)
        self.process.start()
        theirs.close()
        self._heard = heard
        threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        try:
            while True:
                self._heard(self, *self.connection.recv())
        except (EOFError, OSError):
            self.process.join()
            self._heard(self, "ended", 0, self.process.exitcode)

    def end(self) -> None:
        """End the process without waiting for its work."""
        self.process.kill()


class Jobs:
    """All jobs of a studio, newest last, and the worker that computes them.

    tell : called after every change, from any thread
    """

    def __init__(self, tell: Callable[[], object]) -> None:
        self.tell = tell
        self.jobs: dict[int, Job] = {}
        self._lock = threading.RLock()
        self._worker: Worker | None = None
        self._current: Job | None = None
        self._count = 0

    def warm(self) -> None:
        """Start a worker, so that the first job need not wait for it."""
        with self._lock:
            if self._worker is None:
                self._worker = Worker(self._heard)

    def start(self, order: Order) -> Job:
        """Begin a job with the next number; one that still runs is cancelled.

        Raises
        ------
        ResourceError : no process can be started
        """
        with self._lock:
            self._stop_running()
            self._count += 1
            job = Job(replace(order, number=self._count))
            self._send(job)
            self._current = self.jobs[job.number] = job
            for number in list(self.jobs)[:-KEPT]:
                del self.jobs[number]
        self.tell()
        return job

    def _send(self, job: Job) -> None:
        """Give a job to the worker; one that has ended a moment ago is replaced.

        Raises
        ------
        ResourceError : no process can be started
        """
        for attempt in (1, 2):
            try:
                self.warm()
                assert self._worker is not None
                self._worker.connection.send(job.order)
                return
            except OSError as error:
                self._worker = None
                if attempt == 2:
                    raise _not_started(error) from error

    def cancel(self, number: int) -> None:
        """End a job if it still runs."""
        with self._lock:
            if self._current is not None and self._current.number == number:
                self._stop_running()
                self.warm()
        self.tell()

    def close(self) -> None:
        """End the worker."""
        with self._lock:
            if self._worker is not None:
                self._worker.end()
                self._worker = None

    def _stop_running(self) -> None:
        if self._current is not None and self._current.state == "running":
            self._current.finish("cancelled")
            self.close()
        self._current = None

    def _heard(self, worker: Worker, kind: str, number: int, content: Any) -> None:
        """Note a message of a worker; those of a worker that was ended on purpose are late."""
        with self._lock:
            if worker is not self._worker:
                return
            self._note(kind, number, content)
        self.tell()

    def _note(self, kind: str, number: int, content: Any) -> None:
        if kind == "ended":
            self._worker = None
            if self._current is not None and self._current.state == "running":
                self._lose(self._current, content)
        elif (job := self.jobs.get(number)) is not None:  # the worker may still draw for the job before
            match kind:
                case "begun":
                    job.begun = True
                case "cost":
                    job.cost = content
                case "progress":
                    job.progress = content
                case "done":
                    job.answer, job.view = content
                    job.finish("done")
                case "picture":
                    job.pictures[content[0]] = content[1]
                case "failed":
                    # an error in a picture leaves the answer as it is
                    if job.state == "running":
                        job.error = content
                        job.finish("failed")
                case "idle":
                    job.drawn = True

    def _lose(self, job: Job, code: int | None) -> None:
        """End a job whose worker has died; an order that no worker received is given once more."""
        error: ResourceError = _died(code)
        if not job.begun:
            job.begun = True
            try:
                self._send(job)
                return
            except ResourceError as refusal:
                error = refusal
        job.error = error.parts()
        job.finish("failed")


def _died(code: int | None) -> ResourceError:
    return ResourceError.worker(
        argument="worker process",
        given=f"it ended during the computation (exit code {code})",
        allowed="a process that computes until its answer",
        cause="the system ended it, probably because the memory was full",
        next_step="end other programs, or compute fewer bands or a coarser accuracy, and compute again",
    )


def _not_started(error: OSError) -> ResourceError:
    return ResourceError.worker(
        argument="worker process",
        given=str(error),
        allowed="a second process of Python beside the server",
        cause="the machine allows no more processes, or has no memory for one",
        next_step="end other programs, and compute again",
    )
