"""A process beside the worker: it makes files of exports, or reads measured files."""

from __future__ import annotations

import queue
import threading
from typing import Any

from haptonic.errors import HaptonicError
from haptonic.studio.jobs import Worker, worker_died
from haptonic.studio.worker import Order


class Errands:
    """Fulfils orders in a process of its own, one after another, and waits for each.

    For an export the process computes the result again. Nearly all of it comes from the store.
    """

    def __init__(self) -> None:
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
            if self._worker is None or not self._worker.process.is_alive():
                self._worker = Worker(self._heard)
            worker = self._worker
            try:
                worker.connection.send(order)
            except OSError:  # it has died just now
                raise worker_died(worker.process.exitcode) from None
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

    def _heard(self, worker: Worker, kind: str, number: int, content: Any) -> None:
        self._messages.put((worker, kind, content))

    def close(self) -> None:
        """End the process."""
        if self._worker is not None:
            self._worker.end()
