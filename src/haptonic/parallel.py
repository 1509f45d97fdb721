"""Work side by side, in threads or in processes: one way to spread it and one to stop it.

Many designs, whose results are kept one by one, go through `haptonic.jobs`.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, ThreadPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import ExitStack, contextmanager, suppress
from importlib import import_module
from multiprocessing import resource_tracker
from typing import TypeVar

from threadpoolctl import threadpool_limits

from haptonic.later import psutil

Key = TypeVar("Key")
Item = TypeVar("Item")
Result = TypeVar("Result")

THREAD_LIMITS = ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS")


class StartError(RuntimeError):
    """No process can be started."""


def cores() -> int:
    """That this process may run on."""
    # not every system can tell which these are
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def threads() -> int:
    """Threads to use: ``OMP_NUM_THREADS`` if it is set, else as many as there are cores."""
    wanted = os.environ.get("OMP_NUM_THREADS", "")
    return max(1, int(wanted)) if wanted.isdigit() else cores()


@contextmanager
def one_thread() -> Iterator[None]:
    """Linear algebra without threads of its own: ours do more, and most matrices are too small for any.

    A limit holds for libraries that are loaded, and SciPy brings its own, which is loaded when first used: a
    first answer had a thread more than the next, and differed in its seventh digit.
    """
    import_module("scipy.linalg")
    with threadpool_limits(1):
        yield


def each(work: Callable[[Item], Result], items: Iterable[Item]) -> list[Result]:
    """Results of all items in their order, from threads of our own; linear algebra inside has one each.

    Raises
    ------
    whatever the work on an item raises; what has not begun by then is not begun any more
    """
    every = list(items)
    workers = min(threads(), len(every))
    with one_thread():
        return list(streamed(work, every, workers if workers > 1 else 0, len(every)))


def streamed(
    work: Callable[[Item], Result], items: Iterable[Item], workers: int, ahead: int
) -> Generator[Result, None, None]:
    """Results in the order of items that come one after the other, from threads.

    Parameters
    ----------
    workers : threads that work; 0 works in this one
    ahead : items that may be taken before the first result is asked for, which bounds the memory

    Whoever closes the generator, by an error or Ctrl-C, cancels what has not begun.
    """
    if not workers:
        yield from map(work, items)
        return
    waiting: deque[Future[Result]] = deque()
    with ThreadPoolExecutor(workers) as pool:
        try:
            for item in items:
                waiting.append(pool.submit(work, item))
                if len(waiting) >= ahead:
                    yield waiting.popleft().result()
            while waiting:
                yield waiting.popleft().result()
        finally:
            pool.shutdown(wait=False, cancel_futures=True)


def finished(
    work: Callable[[Item], Result],
    items: Iterable[tuple[Key, Item]],
    workers: int,
    died: Callable[[Item], Result],
) -> Generator[tuple[Key, Result], None, None]:
    """Results of items by their keys, as they come, from processes; no item is taken before one is free.

    A process that dies takes its own item with it and no other; the item is tried once more.

    Parameters
    ----------
    work : importable
    workers : processes that work; 0 works in this one
    died : what stands in place of the result of an item on which two processes died

    Whoever closes the generator, by an error or Ctrl-C, ends the processes without waiting for their work.

    Raises
    ------
    StartError : no process can be started
    whatever the work on an item raises, after the results that came with it
    """
    if not workers:
        yield from ((key, work(item)) for key, item in items)
        return
    coming = ((key, item, 0) for key, item in items)
    again: deque[tuple[Key, Item, int]] = deque()  # with how many processes died on it
    with ExitStack() as stack:
        idle = _started(workers, workers, stack)
        running: dict[Future[Result], tuple[Key, Item, int, ProcessPoolExecutor]] = {}
        while True:
            while idle and (task := again.popleft() if again else next(coming, None)):
                pool = idle.pop()
                running[pool.submit(work, task[1])] = *task, pool
            if not running:
                return
            done, _ = wait(running, return_when=FIRST_COMPLETED)
            for future in sorted(done, key=lambda one: one.exception() is not None):
                key, item, deaths, pool = running.pop(future)
                try:
                    yield key, future.result()
                    idle.append(pool)
                except BrokenProcessPool:
                    idle += _started(1, workers, stack)
                    if deaths:
                        yield key, died(item)
                    else:
                        again.append((key, item, 1))


def _started(count: int, workers: int, stack: ExitStack) -> list[ProcessPoolExecutor]:
    """Pools of one process each, one of ``workers`` that share the cores; they end with the stack."""
    # spawned, because a fork of a process with threads may hang
    spawned = multiprocessing.get_context("spawn")
    pools = [ProcessPoolExecutor(1, mp_context=spawned) for _ in range(count)]
    share = str(max(1, cores() // workers))
    with _interrupts_held(), _environment(dict.fromkeys(THREAD_LIMITS, share)):
        try:
            names = [pool.submit(os.getpid) for pool in pools]
            for pool, name in zip(pools, names, strict=True):
                stack.callback(_end, pool, name.result())
        except (BrokenProcessPool, OSError) as error:
            raise StartError(str(error)) from error
    return pools


def _end(pool: ProcessPoolExecutor, process: int) -> None:
    """End a process without waiting for what it is doing, which nobody wants any more."""
    with _interrupts_held(), suppress(psutil.Error):
        pool.shutdown(wait=False, cancel_futures=True)
        psutil.Process(process).kill()


@contextmanager
def _interrupts_held() -> Iterator[None]:
    """Let Ctrl-C wait until the block is done: half a set of processes would stay behind.

    The signal is also blocked in the threads and processes that are started meanwhile. A terminal sends it to
    every process of the run, and only this one is to react.
    """
    seen: list[int] = []
    blocks = hasattr(signal, "pthread_sigmask")  # not on Windows
    # Python allows handlers in the main thread only; elsewhere Ctrl-C does not arrive anyway.
    handles = threading.current_thread() is threading.main_thread()
    if handles:
        handler = signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
    if blocks:
        # Started on demand otherwise, by a thread that would then unblock the signal.
        resource_tracker.ensure_running()
        mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        if blocks:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        if handles:
            signal.signal(signal.SIGINT, handler or signal.SIG_DFL)
    if seen:
        signal.raise_signal(signal.SIGINT)


@contextmanager
def _environment(values: Mapping[str, str]) -> Iterator[None]:
    """Set variables for a while."""
    before = {name: os.environ.get(name) for name in values}
    os.environ.update(values)
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                os.environ.pop(name, None)
            else:
                os.environ[name] = value
