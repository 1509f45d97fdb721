"""A process beside the worker: it makes files of exports, or reads measured files."""

from __future__ import annotations

import os
import queue
import threading
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any

from haptonic.errors import HaptonicError
from haptonic.studio.jobs import Worker, worker_died
from haptonic.studio.order import Order
from haptonic.studio.worker import serve

PRIORITY = 3  # lower than that of computations, in steps of ``nice``


class Errands:
    """Fulfils orders in a process of its own, one after another, and waits for each.

    For an export the process computes the result again. Nearly all of it comes from the store.

    work : function of the process
    """

    def __init__(self, work: Callable[[Connection], None] = serve) -> None:
        self._work = work
        self._lock = threading.Lock()
        self._worker: Worker | None = None
        self._messages: queue.SimpleQueue[tuple[Worker, str, Any]] = queue.SimpleQueue()

    def done(self, order: Order, answer: str) -> Any:
        """Content of the message of the kind ``answer``, such as "file" for an order with an export.

        Raises
        ------
        HaptonicError : of the computation or of the export, or the process has died
        """
        with self._lock:
            worker = self._sent(order)
            while True:
                sender, kind, content = self._messages.get()
                if sender is not worker:
                    continue  # the end of an earlier process
                if kind == answer:
                    return content
                if kind == "failed":
                    raise HaptonicError(content.pop("code"), **content)
                if kind == "ended":
                    raise worker_died(content)

    def _sent(self, order: Order) -> Worker:
        """Send an order to the process, or to a new one if it has ended."""
        if self._worker is not None:
            try:
                self._worker.connection.send(order)
                return self._worker
            except OSError:  # it has ended, perhaps just now
                pass
        self._worker = Worker(self._heard, self._work)
        self._worker.connection.send(order)
        return self._worker

    def _heard(self, worker: Worker, kind: str, number: int, content: Any) -> None:
        self._messages.put((worker, kind, content))

    def close(self) -> None:
        """End the process."""
        if self._worker is not None:
            self._worker.end()


def serve_aside(connection: Connection) -> None:
    """Fulfil orders as the worker does, with a lower priority than its computations."""
    if hasattr(os, "nice"):  # not on Windows
        os.nice(PRIORITY)
    serve(connection)
