"""The process that makes the files of exports."""

from __future__ import annotations

import queue
import threading
from typing import Any

from haptonic.errors import HaptonicError
from haptonic.studio.jobs import Worker, worker_died
from haptonic.studio.worker import Order


class Exports:
    """Makes the files of exports in a process of their own, one after another.

    The process computes the result again. Nearly all of it comes from the store.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._worker: Worker | None = None
        self._messages: queue.SimpleQueue[tuple[Worker, str, Any]] = queue.SimpleQueue()

    def made(self, order: Order) -> tuple[str, bytes]:
        """Name and content of the file of an order with an export.

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
                match kind:
                    case _ if sender is not worker:
                        pass  # the end of an earlier process
                    case "file":
                        name, data = content
                        return name, data
                    case "failed":
                        raise HaptonicError(content.pop("code"), **content)
                    case "ended":
                        raise worker_died(content)

    def _heard(self, worker: Worker, kind: str, number: int, content: Any) -> None:
        self._messages.put((worker, kind, content))

    def close(self) -> None:
        """End the process."""
        if self._worker is not None:
            self._worker.end()
