"""Elimination order of the unknowns between blocks for a factorisation with little fill.

All unknowns on the same blocks, such as those of one interface, are eliminated together. There are few such
groups, so the exact fill of each is computed at every step.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.arrays import Ints
from haptonic.later import sparse as sp


def elimination_order(size: int, blocks: Sequence[Ints]) -> Ints:
    """(size,) unknowns in the order of their elimination: greedy minimum fill (Tinney and Walker 1967,
    doi 10.1109/PROC.1967.6011).

    blocks : unknowns of each block, which are all coupled with each other
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
        for other in near[first]:  # the fill of groups beyond can only decrease
            fills[other] = _fill(near, weights, other)
    return np.array([k for group in order for k in groups[group][1]], dtype=np.int64)


def _alike(size: int, blocks: Sequence[Ints]) -> list[tuple[tuple[int, ...], list[int]]]:
    """Groups of unknowns on the same blocks: numbers of the blocks, and the unknowns."""
    rows = np.concatenate(blocks)
    columns = np.repeat(np.arange(len(blocks)), [len(block) for block in blocks])
    on = sp.csr_array((np.ones(len(rows)), (rows, columns)), shape=(size, len(blocks)))
    on.sort_indices()
    groups: dict[tuple[int, ...], list[int]] = {}
    for unknown, on_blocks in enumerate(np.split(on.indices, on.indptr[1:-1])):
        groups.setdefault(tuple(on_blocks.tolist()), []).append(unknown)
    return list(groups.items())


def _fill(near: list[set[int]], weights: list[int], group: int) -> int:
    """Number of new entries if a group is eliminated, as its neighbours become neighbours."""
    return sum(
        weights[neighbour]
        * sum(weights[other] for other in near[group] - near[neighbour] if other > neighbour)
        for neighbour in near[group]
    )
