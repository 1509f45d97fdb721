"""Analysed solvers that wait for the next work on the same pattern, whichever thread does it."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import TypeVar

from haptonic.solvers import Pattern, Solver, chosen

Result = TypeVar("Result")

# Analysed solvers that wait for the next cell of the same topology. A hexagon's six parts at two orders take
# twelve, and squares between may have four.
KEPT_SOLVERS = 16
# Of a pattern, and of all that wait; the factors of more would hold too much memory.
KEPT_ENTRIES, KEPT_IN_ALL = 5_000_000, 15_000_000

_idle: deque[tuple[Pattern, Solver]] = deque(maxlen=KEPT_SOLVERS)


def with_solver(pattern: Pattern, work: Callable[[Solver], Result]) -> Result:
    """``work(solver)`` with a solver for a pattern, which waits for the next work on the same then."""
    solver = _taken(pattern)
    result = work(solver)
    if len(pattern.indices) <= KEPT_ENTRIES:
        _idle.append((pattern, solver))
    with suppress(IndexError):  # another thread may be faster
        while sum(len(one.indices) for one, _ in tuple(_idle)) > KEPT_IN_ALL:
            _idle.popleft()
    return result


def _taken(pattern: Pattern) -> Solver:
    """An idle solver that has analysed a pattern, or a new one."""
    for _ in range(len(_idle)):
        try:
            whose, solver = _idle.popleft()
        except IndexError:  # another thread was faster
            break
        if whose is pattern and isinstance(solver, chosen()):
            return solver
        _idle.append((whose, solver))
    return chosen()(pattern)
