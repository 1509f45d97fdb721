"""Jobs of the studio: each is computed in a worker process, and the latest replaces one that still runs.

A job for a number that a user turns replaces another such job without a new process, and that one is
forgotten.
"""

from __future__ import annotations

import multiprocessing
import threading
import time
import warnings
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from multiprocessing.connection import Connection
from typing import Any

from haptonic.errors import HaptonicWarning, ResourceError, StudyError
from haptonic.studio.archive import Archive
from haptonic.studio.job import Job
from haptonic.studio.order import Order, Wish
from haptonic.studio.worker import serve

KEPT = 8  # jobs whose answers stay in memory
MOST_POINTS = 5000  # of a job
SAVED_EVERY = 5.0  # s, of a running job


class Worker:
    """A worker process and the thread that listens to it.

    heard : called with each message, and with "ended" and the exit code after the last one
    work : function of the process, see `haptonic.studio.worker.serve`
    """

    def __init__(
        self,
        heard: Callable[[Worker, str, int, Any], None],
        work: Callable[[Connection], None] = serve,
    ) -> None:
        # spawned, because the fork of a process with threads may hang
        context = multiprocessing.get_context("spawn")
        self.connection, theirs = context.Pipe()
        self.process = context.Process(target=work, args=(theirs,), daemon=True)
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

    archive : jobs on the disk, also those of earlier servers
    notify : called after every change, from any thread
    """

    def __init__(self, archive: Archive, notify: Callable[[], object]) -> None:
        self.archive, self.notify = archive, notify
        self.jobs: dict[int, Job] = {}
        self._lock = threading.RLock()
        self._worker: Worker | None = None
        self._current: Job | None = None
        self._count = max(archive.briefs, default=0)
        self._saved = 0.0  # time of the last writing of a job

    def warm(self) -> None:
        """Start a worker, so that the first job need not wait for it."""
        with self._lock:
            if self._worker is None:
                self._worker = Worker(self._heard)

    def briefs(self) -> list[dict[str, Any]]:
        """States of all jobs in the order of their numbers."""
        with self._lock:
            here = {number: job.brief() for number, job in self.jobs.items()}
            return [brief for _, brief in sorted((self.archive.briefs | here).items())]

    def refresh(self) -> None:
        """Take over runs of the command line that are new, and notify the pages."""
        with self._lock:
            is_new = self.archive.refresh(self.jobs)
        if is_new:
            self.notify()

    def job(self, number: int) -> Job | None:
        """A job with its answer, from memory or from the archive; None without one."""
        with self._lock:
            return self.jobs.get(number) or self.archive.read(number)

    def remove(self, number: int) -> None:
        """Remove a job that has ended, also from the archive.

        Raises
        ------
        StudyError : the job still runs
        """
        with self._lock:
            if (
                self._current is not None
                and self._current.number == number
                and self._current.state == "running"
            ):
                raise StudyError.conflict(
                    argument="number", given=number, allowed="a run that has ended", cause="it is computed",
                    next_step="cancel it first",
                )  # fmt: skip
            self.jobs.pop(number, None)
            self.archive.remove(number)
        self.notify()

    def start(self, order: Order) -> Job:
        """Begin a job with the next number; one that still runs is cancelled.

        Raises
        ------
        ResourceError : no process can be started
        """
        with self._lock:
            if order.turned and self._current is not None and self._current.order.turned:
                self._forget_running()
            else:
                self._stop_running()
            self._count = max(self._count, *self.archive.briefs, 0) + 1
            job = Job.ordered(replace(order, number=self._count))
            self._send(job)
            self._current = self.jobs[job.number] = job
            self._keep(job)
            for number in list(self.jobs)[:-KEPT]:
                del self.jobs[number]
        self.notify()
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

    def wish(self, path: str) -> None:
        """Ask for the preview of a number before others."""
        with self._lock:
            if self._worker is not None:
                with suppress(OSError):  # the process has ended, and no preview comes
                    self._worker.connection.send(Wish(path))

    def cancel(self, number: int) -> None:
        """End a job if it still runs."""
        with self._lock:
            if self._current is not None and self._current.number == number:
                self._stop_running()
                self.warm()
        self.notify()

    def end(self) -> None:
        """Interrupt the running job, which is kept, and end the worker."""
        with self._lock:
            self._stop_running("interrupted")
            self.close()

    def close(self) -> None:
        """End the worker."""
        with self._lock:
            if self._worker is not None:
                self._worker.end()
                self._worker = None

    def _stop_running(self, state: str = "cancelled") -> None:
        if self._current is not None and self._current.state == "running":
            self._current.finish(state)
            self.close()
            self._keep(self._current)
        self._current = None

    def _forget_running(self) -> None:
        """Let the worker, which drops its work with the next order, live on."""
        if self._current is not None and self._current.state == "running":
            self.jobs.pop(self._current.number, None)
        self._current = None

    def _keep(self, job: Job) -> None:
        """Write a job, or remove what was written of it; a job that cannot be written stays in memory."""
        self._saved = time.monotonic()
        if not job.is_kept:
            self.archive.remove(job.number)
            return
        try:
            self.archive.keep(job)
        except ResourceError as error:
            if job.state != "running":
                words = f"run {job.number} is lost when the studio ends: {error.cause}"
                warnings.warn(words, HaptonicWarning, stacklevel=2)

    def _heard(self, worker: Worker, kind: str, number: int, content: Any) -> None:
        """Note a message of a worker; those of a worker that was ended on purpose are late."""
        with self._lock:
            if worker is not self._worker:
                return
            self._note(kind, number, content)
        self.notify()

    def _note(self, kind: str, number: int, content: Any) -> None:
        if kind == "ended":
            self._worker = None
            if self._current is not None and self._current.state == "running":
                self._lose(self._current, content)
        elif (job := self.jobs.get(number)) is not None:
            match kind:
                case "begun":
                    job.begun = True
                case "cost":
                    job.cost = content
                case "progress":
                    job.progress = content
                case "point" if len(job.points) < MOST_POINTS:
                    job.points.append(content)
                case "first":
                    job.first = job.first[0] + 1, content
                case "knobs":
                    job.knobs = content
                case "preview":
                    path, view = content
                    job.previews[path] = job.previews.get(path, (0, b""))[0] + 1, view
                case "done":
                    job.answer, job.view = content
                    job.finish("done")
                    self._keep(job)
                case "failed":
                    # an error in a preview leaves the answer as it is
                    if job.state == "running":
                        job.error = content
                        job.finish("failed")
                        self._keep(job)
            if job.state == "running" and time.monotonic() - self._saved > SAVED_EVERY:
                self._keep(job)

    def _lose(self, job: Job, code: int | None) -> None:
        """End a job whose worker has died; an order that no worker received is given once more."""
        error: ResourceError = worker_died(code)
        if not job.begun:
            job.begun = True
            try:
                self._send(job)
                return
            except ResourceError as refusal:
                error = refusal
        job.error = error.parts()
        job.finish("failed")
        self._keep(job)


def worker_died(code: int | None) -> ResourceError:
    """Error for a worker that ended by itself."""
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
