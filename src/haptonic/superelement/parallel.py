"""Symmetry classes side by side: they share nothing but read-only arrays.

Threads of our own on the classes beat threads inside the linear algebra, whose matrices are small here.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import TypeVar

from haptonic.parallel import each
from haptonic.solvers import Solver, chosen
from haptonic.superelement.assembly import Assembler
from haptonic.superelement.folded import FoldedMesh

Result = TypeVar("Result")

KEPT_SOLVERS = 6  # analysed solvers that wait for the next cell of the same topology
KEPT_ENTRIES = 5_000_000  # of a pattern; the factors of larger ones would hold too much memory

_idle: deque[tuple[Assembler, Solver]] = deque(maxlen=KEPT_SOLVERS)


def for_each_class(
    shared: FoldedMesh, work: Callable[[int, Solver], Result], mirrored: Callable[[Result], Result]
) -> list[Result]:
    """``work(class, solver)`` for every symmetry class, in order; no two at a time share a solver.

    A class that is the diagonal's image of another gets what ``mirrored`` makes of the other's result.
    """
    classes, images = shared.classes_and_images()

    def one(q: int) -> Result:
        solver = _taken(shared.assembler)
        result = work(q, solver)
        if len(shared.assembler.pattern.indices) <= KEPT_ENTRIES:
            _idle.append((shared.assembler, solver))
        return result

    by_class = dict(zip(classes, each(one, classes), strict=True))
    by_class |= {q: mirrored(by_class[original]) for q, original in images.items()}
    return [by_class[q] for q in sorted(by_class)]


def _taken(assembler: Assembler) -> Solver:
    """An idle solver that has analysed the assembler's pattern, or a new one."""
    for _ in range(len(_idle)):
        try:
            whose, solver = _idle.popleft()
        except IndexError:  # another thread was faster
            break
        if whose is assembler and isinstance(solver, chosen()):
            return solver
        _idle.append((whose, solver))
    return chosen()(assembler.pattern)
