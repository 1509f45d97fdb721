"""Work side by side, in threads or in processes: one way to spread it and one to stop it.

Many designs, whose results are kept one by one, go through `haptonic.jobs`.
"""

from __future__ import annotations

import multiprocessing
import os
from collections import deque
from collections.abc import Callable, Generator, Iterable
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from typing import TypeVar

from threadpoolctl import threadpool_limits

Item = TypeVar("Item")
Result = TypeVar("Result")


def threads() -> int:
    """Threads to use: ``OMP_NUM_THREADS`` if it is set, else the cores that this process may run on."""
    wanted = os.environ.get("OMP_NUM_THREADS", "")
    if wanted.isdigit():
        return max(1, int(wanted))
    # not every system can tell which cores a process may use
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def each(work: Callable[[Item], Result], items: Iterable[Item]) -> list[Result]:
    """Results of all items in their order, from threads of our own; linear algebra inside has one each.

    Raises
    ------
    whatever the work on an item raises; what has not begun by then is not begun any more
    """
    every = list(items)
    workers = min(threads(), len(every))
    with threadpool_limits(1):
        return list(streamed(work, every, workers if workers > 1 else 0, len(every)))


def streamed(
    work: Callable[[Item], Result],
    items: Iterable[Item],
    workers: int,
    ahead: int,
    *,
    processes: bool = False,
) -> Generator[Result, None, None]:
    """Results in the order of items that come one after the other.

    Parameters
    ----------
    workers : threads, or processes, that work; 0 works in this thread
    ahead : items that may be taken before the first result is asked for, which bounds the memory

    Whoever closes the generator, by an error or Ctrl-C, cancels what has not begun.
    """
    if not workers:
        yield from map(work, items)
        return
    pool: Executor
    if processes:  # spawned, because a fork of a process with threads may hang
        pool = ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"))
    else:
        pool = ThreadPoolExecutor(workers)
    waiting: deque[Future[Result]] = deque()
    with pool:
        try:
            for item in items:
                waiting.append(pool.submit(work, item))
                if len(waiting) >= ahead:
                    yield waiting.popleft().result()
            while waiting:
                yield waiting.popleft().result()
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
