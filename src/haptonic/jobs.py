"""Many computations, each stored when it is finished.

Parallel work runs in processes of this machine (`haptonic.parallel`), or through Dask on the workers of a
running scheduler. They return their datasets and only this process writes the store, so remote workers need
no shared disk.
"""

from __future__ import annotations

import importlib.util
import logging
import warnings
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from concurrent.futures import CancelledError
from contextlib import closing, contextmanager
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from haptonic.errors import HaptonicError, ResourceError, shown
from haptonic.gate import passed
from haptonic.later import admitted, xarray as xr
from haptonic.parallel import StartError, finished
from haptonic.progress import Progress, silent
from haptonic.store import Store, content_key, fingerprint

if TYPE_CHECKING:
    from distributed import Client, Future

    Function = Callable[[Any], xr.Dataset]
    Result = xr.Dataset | HaptonicError
    Results = Generator[tuple[str, Result], None, None]

STORED = "in the store"  # progress text of a task that was computed before
CONNECT_SECONDS = 5
FIRST_WORKER_SECONDS = 30


@dataclass(frozen=True)
class Task:
    """A computation: inputs for the key of its result (see ``content_key``), and argument of the function."""

    key_inputs: dict[str, object]
    argument: object


@dataclass(frozen=True, eq=False)
class Outcome:
    """Outcome of a task: either a dataset or an error."""

    key: str
    dataset: xr.Dataset | None
    error: HaptonicError | None
    from_store: bool


def ignored(position: int, outcome: Outcome) -> None:
    """Do nothing with the outcome of a task."""


def run_all(
    function: Function,
    tasks: Sequence[Task],
    *,
    store: Store,
    workers: int = 0,
    scheduler: str | None = None,
    progress: Progress = silent,
    heard: Callable[[int, Outcome], object] = ignored,
) -> list[Outcome]:
    """Compute all tasks that are not in the store; return the outcomes in the order of the tasks.

    Parameters
    ----------
    function : takes a task's argument and returns a dataset; for parallel work it must be importable
    workers : worker processes on this machine; 0 computes in this process
    scheduler : address of a running Dask scheduler, whose workers are used instead
    progress : called with the tasks done and their number; `STORED` marks a task that was in the store
    heard : called with the position of each task and its outcome as soon as it is finished

    A HaptonicError of one task becomes its outcome, as does a worker that dies twice on the same task; the
    other tasks continue. Any other exception, and Ctrl-C, ends the run; finished results are in the store,
    and the next run continues from there. Errors are not stored.

    On this machine a task is given up after two dead workers. A running scheduler has its own setting for the
    number of deaths per attempt, and there are two attempts.

    Raises
    ------
    HaptonicError : both ``workers`` and ``scheduler``, or negative ``workers``
    ResourceError : no scheduler at this address, no workers, a lost scheduler, local workers that do not
        start, or a store that cannot be used
    """
    check_workers(workers, scheduler)
    keys = [content_key(task.key_inputs) for task in tasks]
    arguments = {key: task.argument for key, task in zip(keys, tasks, strict=True)}
    copies: dict[str, list[int]] = {}
    for position, key in enumerate(keys):
        copies.setdefault(key, []).append(position)
    outcomes: dict[str, Outcome] = {}
    done = 0

    def keep(outcome: Outcome) -> None:
        nonlocal done
        outcomes[outcome.key] = outcome
        for position in copies[outcome.key]:
            done += 1
            progress(done, len(keys), STORED if outcome.from_store else "")
            heard(position, outcome)

    for key in copies:
        stored = store.get(key)
        if stored is not None:
            keep(Outcome(key, stored, None, from_store=True))

    missing = {key: arguments[key] for key in copies if key not in outcomes}
    if not missing or (workers == 0 and scheduler is None):
        results = ((key, _attempt(function, argument)) for key, argument in missing.items())
    elif scheduler is None:
        results = _computed_by_processes(function, missing, workers)
    else:
        results = _computed_by_dask(function, missing, scheduler)
    with closing(results):
        for key, result in results:
            if isinstance(result, HaptonicError):
                keep(Outcome(key, None, result, from_store=False))
            else:
                store.put(key, result)
                keep(Outcome(key, result, None, from_store=False))
    return [outcomes[key] for key in keys]


def check_workers(workers: object, scheduler: object) -> None:
    """Refuse a wrong number of workers, a wrong address of a scheduler, or both together."""
    counted = isinstance(workers, int) and not isinstance(workers, bool) and workers >= 0
    if not counted or (scheduler is not None and (workers or not isinstance(scheduler, str))):
        raise HaptonicError.malformed(
            argument="workers",
            given=shown(workers) if scheduler is None else f"{workers!r}, and the scheduler {scheduler!r}",
            allowed="0 or more worker processes on this machine, or a scheduler with workers of its own",
            cause="a slip, or two ways of computing at the same time",
            next_step="give workers (--workers N) or a scheduler (--scheduler ADDRESS), not both",
        )
    if scheduler and importlib.util.find_spec("distributed") is None:
        raise ResourceError.not_installed(
            argument="scheduler",
            given=shown(scheduler),
            allowed="an address, with the package distributed installed",
            cause="distributed is an optional part of haptonic and is not installed",
            next_step='pip install "haptonic[scheduler]", or use workers of this machine (--workers N)',
        )


def _attempt(function: Function, argument: object) -> Result:
    try:
        dataset = function(argument)
        assert isinstance(dataset, xr.Dataset), f"{function} returned {type(dataset).__name__}, not a dataset"
        return passed(dataset)
    except HaptonicError as error:
        return error


def _attempt_there(argument: object, function: Function, expected: str) -> Result:
    """Run ``_attempt`` on a worker; refuse it if the code differs from that in the key of the result."""
    if fingerprint() != expected:
        return ResourceError.worker(
            argument="worker",
            given="a worker with another version of haptonic, numpy or scipy",
            allowed="workers with the same versions as this process, so that results do not mix",
            cause="haptonic was updated on the worker or while this run was starting",
            next_step="install the same versions everywhere, restart the workers, and start again",
        )
    return _attempt(function, argument)


def _computed_by_processes(function: Function, missing: Mapping[str, object], workers: int) -> Results:
    attempt = partial(_attempt_there, function=function, expected=fingerprint())
    try:
        yield from finished(attempt, missing.items(), min(workers, len(missing)), _died_twice)
    except StartError as error:
        raise ResourceError.worker(
            argument="workers",
            given=workers,
            allowed="as many worker processes as this machine can start",
            cause=f"too little memory, or a script without a main guard ({error})",
            next_step='put the call below `if __name__ == "__main__":`, or use fewer workers, or 0',
        ) from error


def _computed_by_dask(function: Function, missing: Mapping[str, object], scheduler: str) -> Results:
    with _quiet(), _remote_workers(scheduler) as client:
        try:
            yield from _collected(client, function, missing)
        except CancelledError as error:
            raise _no_scheduler(
                scheduler, "it was ended, or the connection broke, while computing"
            ) from error
        except ImportError as error:
            raise _no_scheduler(scheduler, f"its workers lack a module: {error}") from error


def _collected(client: Client, function: Function, missing: Mapping[str, object]) -> Results:
    from distributed import KilledWorker, as_completed  # here for the reason given in _remote_workers

    def submitted(keys: Sequence[str]) -> list[Future[Any]]:
        arguments = [missing[key] for key in keys]
        return client.map(_attempt_there, arguments, function=function, expected=fingerprint(), pure=False)

    keys = list(missing)
    futures = submitted(keys)
    waiting = {future.key: (key, future) for key, future in zip(keys, futures, strict=True)}
    finished = as_completed(futures, loop=client.loop)
    del futures  # a worker keeps a dataset as long as its future exists
    suspects = []
    for future in finished:
        key, _ = waiting.pop(future.key)
        try:
            yield key, future.result()
        except KilledWorker:
            suspects.append(key)
        except Exception:
            yield from (
                (key, other.result()) for key, other in waiting.values() if other.status == "finished"
            )
            raise

    # A dead worker loses all its tasks, so they are only suspected of its death. Each is tried alone, to find
    # the cause.
    for key in suspects:
        (future,) = submitted([key])
        try:
            yield key, future.result()
        except KilledWorker:
            yield key, _died_twice(missing[key])


def _died_twice(argument: object) -> ResourceError:
    return ResourceError.worker(
        argument="worker process",
        given=f"died twice on the task {str(argument)[:200]}",
        allowed="a task that a worker can finish",
        cause="the task needs more memory than a worker has, or a numerical library crashed",
        next_step="run again with fewer workers (each has more memory), or remove this design",
    )


@contextmanager
def _remote_workers(address: str) -> Iterator[Client]:
    # importing distributed takes most of a second; only runs that use it should wait for it
    admitted("dask")
    from distributed import Client
    from distributed.utils import LoopRunner

    try:
        LoopRunner().run_sync(_reach, address)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # about other versions on workers; `_attempt_there` compares them
            client = Client(address, timeout=CONNECT_SECONDS, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        raise _no_scheduler(address, "it is not running, or the address is misspelt") from error
    with client:
        try:
            client.wait_for_workers(1, timeout=FIRST_WORKER_SECONDS)
        except TimeoutError as error:
            raise _no_scheduler(address, "it has no workers") from error
        yield client


async def _reach(address: str) -> None:
    """Connect to the address and fail like a client that cannot connect, without a half-made client.

    Dask's client does not close itself after every failure. The garbage collector then closes it at a later
    moment; if another client is being started at that moment, the two wait for each other's lock.
    """
    from distributed import Security
    from distributed.comm.core import connect

    comm = await connect(address, timeout=CONNECT_SECONDS, **Security().get_connection_args("client"))
    await comm.close()


def _no_scheduler(address: str, cause: str) -> ResourceError:
    return ResourceError.worker(
        argument="scheduler",
        given=shown(address),
        allowed="the address of a running Dask scheduler with workers, such as tcp://127.0.0.1:8786",
        cause=cause,
        next_step="start `dask scheduler` and `dask worker ADDRESS`, or use workers (--workers N) instead; "
        "finished results are in the store",
    )


@contextmanager
def _quiet() -> Iterator[None]:
    """Silence Dask's loggers; the outcomes and errors contain all information for users."""
    loggers = [logging.getLogger(name) for name in ("distributed", "distributed.client", "distributed.gc")]
    levels = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        for logger, level in zip(loggers, levels, strict=True):
            logger.setLevel(level)
