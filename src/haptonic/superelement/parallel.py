"""Analysed solvers, stored for further work on the same pattern in any thread."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import TypeVar

from haptonic.solvers import Pattern, Solver, chosen

Result = TypeVar("Result")

# Number of analysed solvers stored for the next cell of the same topology. The six parts of a hexagon at two
# orders need twelve, squares in between may need four.
KEPT_SOLVERS = 16
# Largest number of entries of one stored pattern, and of all. With its factors an entry needs 70 bytes, so
# all need 0.4 GB at most; a square cell has 0.5 million at the usual order, a triangular one 1.2.
KEPT_ENTRIES, KEPT_IN_ALL = 5_000_000, 6_000_000

_idle: deque[tuple[Pattern, Solver]] = deque(maxlen=KEPT_SOLVERS)


def with_solver(pattern: Pattern, work: Callable[[Solver], Result]) -> Result:
    """Return ``work(solver)`` with a solver for a pattern, and store the solver for further work."""
    solver = _take_solver(pattern)
    result = work(solver)
    if len(pattern.indices) <= KEPT_ENTRIES:
        _idle.append((pattern, solver))
    with suppress(IndexError):  # another thread may be faster
        while sum(len(stored.indices) for stored, _ in tuple(_idle)) > KEPT_IN_ALL:
            _idle.popleft()
    return result


def _take_solver(pattern: Pattern) -> Solver:
    """Take an idle solver that has analysed a pattern, or make a new one."""
    for _ in range(len(_idle)):
        try:
            analysed, solver = _idle.popleft()
        except IndexError:  # another thread was faster
            break
        if analysed is pattern and isinstance(solver, chosen()):
            return solver
        _idle.append((analysed, solver))
    return chosen()(pattern)
