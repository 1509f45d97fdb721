"""Symmetry classes side by side: they share nothing but read-only arrays.

Threads of our own on the classes beat threads inside the linear algebra, whose matrices are small here.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from threadpoolctl import threadpool_limits

from haptonic.solvers import Solver
from haptonic.superelement.folded import FoldedMesh

Result = TypeVar("Result")


def threads() -> int:
    """Threads to use: ``OMP_NUM_THREADS`` if it is set, else the cores that this process may run on."""
    wanted = os.environ.get("OMP_NUM_THREADS", "")
    if wanted.isdigit():
        return max(1, int(wanted))
    # not every system can tell which cores a process may use
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def for_each_class(
    shared: FoldedMesh, work: Callable[[int, Solver], Result], classes: Sequence[int]
) -> list[Result]:
    """``work(class, solver)`` for some symmetry classes, in order; each thread has a solver of its own."""
    workers = min(threads(), len(classes))

    def share(start: int) -> list[Result]:
        solver = shared.solver()
        return [work(q, solver) for q in classes[start::workers]]

    with threadpool_limits(1):
        if workers == 1:
            return share(0)
        with ThreadPoolExecutor(workers) as pool:
            shares = list(pool.map(share, range(workers)))
    return [shares[number % workers][number // workers] for number in range(len(classes))]
