"""Parallel work in threads or in processes: starting and stopping it.

Many designs whose results are stored one by one use `haptonic.jobs`.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import ExitStack, contextmanager, suppress
from functools import cache
from importlib import import_module
from multiprocessing import resource_tracker
from queue import SimpleQueue
from typing import TypeVar

from threadpoolctl import ThreadpoolController

from haptonic.later import psutil

Key = TypeVar("Key")
Item = TypeVar("Item")
Result = TypeVar("Result")

BLOCKS_SIGNALS = hasattr(signal, "pthread_sigmask")  # not on Windows
THREAD_LIMITS = ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS")


class StartError(RuntimeError):
    """No worker process can be started."""


def cores() -> int:
    """Number of cores that this process may use."""
    # not every system reports the cores of a process
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def threads() -> int:
    """Number of threads: ``OMP_NUM_THREADS`` if it is set, otherwise the number of cores."""
    wanted = os.environ.get("OMP_NUM_THREADS", "")
    return max(1, int(wanted)) if wanted.isdigit() else cores()


@contextmanager
def one_thread() -> Iterator[None]:
    """Run linear algebra on one thread: our threads are faster, and most matrices are too small for more."""
    with _linear_algebra().limit(limits=1):
        yield


@cache
def _linear_algebra() -> ThreadpoolController:
    """Loaded libraries of linear algebra.

    SciPy and CHOLMOD load theirs on first use; without the import here, a first result used one thread more
    than the next and differed in the seventh digit. MKL is limited where it is called. The search takes 3 ms
    and never ends if another thread loads a library meanwhile: it waits for the interpreter, and the other
    thread for the list of libraries. So there is one search, before our threads begin.
    """
    import_module("scipy.linalg")
    with suppress(ImportError):  # optional dependency
        import_module("sksparse.cholmod")
    return ThreadpoolController()


def each(work: Callable[[Item], Result], items: Iterable[Item]) -> list[Result]:
    """Results of all items in their order, computed by threads; linear algebra in each uses one thread.

    Raises
    ------
    any exception of the work on an item; items that have not begun are then skipped
    """
    every = list(items)
    workers = min(threads(), len(every))
    with one_thread():
        return list(streamed(work, every, workers if workers > 1 else 0, len(every)))


def streamed(
    work: Callable[[Item], Result], items: Iterable[Item], workers: int, ahead: int
) -> Generator[Result, None, None]:
    """Results in the order of the items, computed by threads.

    Parameters
    ----------
    workers : number of threads; 0 for the calling thread
    ahead : items that may be taken before the first result is requested, which bounds the memory

    Closing the generator, by an error or Ctrl-C, cancels work that has not begun.
    """
    if not workers:
        yield from map(work, items)
        return
    waiting: deque[SimpleQueue[Future[Result]]] = deque()
    with ThreadPoolExecutor(workers) as pool:
        try:
            for item in items:
                waiting.append(SimpleQueue())
                _submit(pool, work, item, waiting[-1])
                if len(waiting) >= ahead:
                    yield _result(waiting.popleft().get())
            while waiting:
                yield _result(waiting.popleft().get())
        finally:
            with _interrupts_delayed():
                pool.shutdown(wait=False, cancel_futures=True)


def finished(
    work: Callable[[Item], Result],
    items: Iterable[tuple[Key, Item]],
    workers: int,
    died: Callable[[Item], Result],
) -> Generator[tuple[Key, Result], None, None]:
    """Results of items by key, as they are finished by processes; items are taken one by one.

    A process that dies loses only its own item, which is tried once more.

    Parameters
    ----------
    work : importable function
    workers : number of processes; 0 for this process
    died : returns the result of an item on which two processes died

    Closing the generator, by an error or Ctrl-C, ends the processes without waiting for their work.

    Raises
    ------
    StartError : no process can be started
    any exception of the work on an item, after the results that came with it
    """
    if not workers:
        yield from ((key, work(item)) for key, item in items)
        return
    coming = ((key, item, 0) for key, item in items)
    again: deque[tuple[Key, Item, int]] = deque()  # with the number of processes that died on it
    with ExitStack() as stack:
        idle = _started(workers, workers, stack)
        running: dict[Future[Result], tuple[Key, Item, int, ProcessPoolExecutor]] = {}
        ended: SimpleQueue[Future[Result]] = SimpleQueue()
        while True:
            while idle and (task := again.popleft() if again else next(coming, None)):
                pool = idle.pop()
                running[_submit(pool, work, task[1], ended)] = *task, pool
            if not running:
                return
            done = [ended.get()]
            while not ended.empty():
                done.append(ended.get())
            with _interrupts_delayed():
                failed = {future: future.exception() is not None for future in done}
            for future in sorted(done, key=failed.__getitem__):
                key, item, deaths, pool = running.pop(future)
                try:
                    yield key, _result(future)
                    idle.append(pool)
                except BrokenProcessPool:
                    idle += _started(1, workers, stack)
                    if deaths:
                        yield key, died(item)
                    else:
                        again.append((key, item, 1))


# A future that Ctrl-C interrupts may never release its lock, and then its pool never ends. So Ctrl-C acts
# while the main thread waits for a queue of ended futures or the caller works, not in calls of futures.


def _submit(
    pool: Executor, work: Callable[[Item], Result], item: Item, ended: SimpleQueue[Future[Result]]
) -> Future[Result]:
    """Submit work to a pool; its future is put into the queue when it has ended."""
    with _interrupts_delayed():
        future = pool.submit(work, item)
        future.add_done_callback(ended.put)
    return future


def _result(future: Future[Result]) -> Result:
    """Result of a future that has ended."""
    with _interrupts_delayed():
        return future.result()


def _started(count: int, workers: int, stack: ExitStack) -> list[ProcessPoolExecutor]:
    """Pools of one process each, each with its share of the cores among ``workers``; the stack ends them."""
    # spawned, because the fork of a process with threads may hang
    spawned = multiprocessing.get_context("spawn")
    pools = [ProcessPoolExecutor(1, mp_context=spawned) for _ in range(count)]
    share = str(max(1, cores() // workers))
    if BLOCKS_SIGNALS:
        # otherwise it is started on demand, by a thread that would then unblock Ctrl-C
        resource_tracker.ensure_running()
    with _interrupts_delayed(), _environment(dict.fromkeys(THREAD_LIMITS, share)):
        try:
            names = [pool.submit(os.getpid) for pool in pools]
            for pool, name in zip(pools, names, strict=True):
                stack.callback(_end, pool, name.result())
        except (BrokenProcessPool, OSError) as error:
            raise StartError(str(error)) from error
    return pools


def _end(pool: ProcessPoolExecutor, process: int) -> None:
    """End a process without waiting for its work."""
    with _interrupts_delayed(), suppress(psutil.Error):
        pool.shutdown(wait=False, cancel_futures=True)
        psutil.Process(process).kill()


@contextmanager
def _interrupts_delayed() -> Iterator[None]:
    """Delay Ctrl-C until the end of the block; it would leave processes of an incomplete set behind.

    The signal is also blocked in threads and processes that are started in the block. A terminal sends it to
    every process of the run, but only this one should react.
    """
    seen: list[int] = []
    # Python allows signal handlers in the main thread only; Ctrl-C does not arrive in other threads
    handles = threading.current_thread() is threading.main_thread()
    if handles:
        handler = signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
    if BLOCKS_SIGNALS:
        mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        if BLOCKS_SIGNALS:
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        if handles:
            signal.signal(signal.SIGINT, handler or signal.SIG_DFL)
        if seen:
            signal.raise_signal(signal.SIGINT)


@contextmanager
def _environment(values: Mapping[str, str]) -> Iterator[None]:
    """Set environment variables for a block."""
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
