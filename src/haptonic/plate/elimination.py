"""In which order the unknowns between blocks are eliminated, so that a factorisation fills in little.

All unknowns that lie on the same blocks, as those of one interface do, are eliminated together. There are
few such groups, so the exact fill of each can be known at every step.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.arrays import Ints
from haptonic.later import sparse as sp


def elimination_order(size: int, blocks: Sequence[Ints]) -> Ints:
    """(size,) unknowns in the order of their elimination: greedy minimum fill (Tinney and Walker 1967,
    doi 10.1109/PROC.1967.6011).

    blocks : the unknowns of each, all of which are coupled with one another
    """
    groups = _alike(size, blocks)
    weights = [len(unknowns) for _, unknowns in groups]
    of_block: list[set[int]] = [set() for _ in blocks]
    for number, (on, _) in enumerate(groups):
        for block in on:
            of_block[block].add(number)
    near = [set().union(*(of_block[block] for block in on)) - {k} for k, (on, _) in enumerate(groups)]
    fills = {k: _fill(near, weights, k) for k in range(len(groups))}
    order = []
    while fills:
        first = min(fills, key=fills.__getitem__)
        del fills[first]
        order.append(first)
        for other in near[first]:
            near[other] = (near[other] | near[first]) - {first, other}
        for other in near[first]:  # the fill of those beyond can only have become less
            fills[other] = _fill(near, weights, other)
    return np.array([k for group in order for k in groups[group][1]], dtype=np.int64)


def _alike(size: int, blocks: Sequence[Ints]) -> list[tuple[tuple[int, ...], list[int]]]:
    """Groups of unknowns that lie on the same blocks: these, and the unknowns."""
    rows = np.concatenate(blocks)
    columns = np.repeat(np.arange(len(blocks)), [len(block) for block in blocks])
    on = sp.csr_array((np.ones(len(rows)), (rows, columns)), shape=(size, len(blocks)))
    on.sort_indices()
    groups: dict[tuple[int, ...], list[int]] = {}
    for unknown, own in enumerate(np.split(on.indices, on.indptr[1:-1])):
        groups.setdefault(tuple(own.tolist()), []).append(unknown)
    return list(groups.items())


def _fill(near: list[set[int]], weights: list[int], group: int) -> int:
    """Entries that appear when a group is eliminated: its neighbours become neighbours of one another."""
    return sum(
        weights[one] * sum(weights[other] for other in near[group] - near[one] if other > one)
        for one in near[group]
    )
