"""Many computations, each kept in the store the moment it is finished: only this process writes the store."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from typing import Any

import xarray as xr

from haptonic.errors import HaptonicError
from haptonic.gate import passed
from haptonic.jobs.engine import Progress, each
from haptonic.store import Store, content_key

__all__ = ["Outcome", "Progress", "Task", "each", "run_all"]

Function = Callable[[Any], xr.Dataset]


@dataclass(frozen=True)
class Task:
    """One computation: what names its result (see ``content_key``), and what the function is given."""

    key_inputs: dict[str, object]
    argument: object


@dataclass(frozen=True, eq=False)
class Outcome:
    """What came of a task: either the dataset or the error that stands in its place."""

    key: str
    dataset: xr.Dataset | None
    error: HaptonicError | None
    from_store: bool


def run_all(
    function: Function,
    tasks: Sequence[Task],
    *,
    store: Store,
    workers: int = 0,
    scheduler: str | None = None,
    on_progress: Progress | None = None,
) -> list[Outcome]:
    """Compute every task that is not in the store yet; the outcomes, in the order of the tasks.

    Parameters
    ----------
    function : takes a task's argument and returns a dataset; for parallel work it must be importable
    workers, scheduler : see `each`
    on_progress : called with (tasks done, tasks in all, whether this one was in the store)

    An error of one task becomes its outcome, and the other tasks go on. Whatever ends the run, what was
    finished is in the store, and the next run goes on from there. Errors are not stored.

    Raises
    ------
    HaptonicError, ResourceError : see `each`; or the store cannot be used
    """
    keys = [content_key(task.key_inputs) for task in tasks]
    arguments = {key: task.argument for key, task in zip(keys, tasks, strict=True)}
    copies = Counter(keys)
    outcomes: dict[str, Outcome] = {}
    done = 0

    def keep(outcome: Outcome) -> None:
        nonlocal done
        outcomes[outcome.key] = outcome
        for _ in range(copies[outcome.key]):
            done += 1
            if on_progress is not None:
                on_progress(done, len(keys), outcome.from_store)

    for key in copies:
        stored = store.get(key)
        if stored is not None:
            keep(Outcome(key, stored, None, from_store=True))

    missing = {key: arguments[key] for key in copies if key not in outcomes}
    with closing(each(partial(_gated, function), missing, workers=workers, scheduler=scheduler)) as results:
        for key, result in results:
            if isinstance(result, HaptonicError):
                keep(Outcome(key, None, result, from_store=False))
            else:
                store.put(key, result)
                keep(Outcome(key, result, None, from_store=False))
    return [outcomes[key] for key in keys]


def _gated(function: Function, argument: object) -> xr.Dataset:
    dataset = function(argument)
    assert isinstance(dataset, xr.Dataset), f"{function} returned {type(dataset).__name__}, not a dataset"
    return passed(dataset)
