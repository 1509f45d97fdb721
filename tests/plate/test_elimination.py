"""The order of elimination against the fill that a symbolic factorisation counts."""

import numpy as np
from hypothesis import given, strategies as st

from haptonic.plate.body.elimination import elimination_order
from haptonic.plate.body.skeleton import TraceOrders, traced
from haptonic.plate.layout.grid import Block


def entries(size, blocks, order):
    """Entries of the factor, diagonal included, of a matrix that couples the unknowns of each block."""
    coupled = np.eye(size, dtype=bool)
    for block in blocks:
        coupled[np.ix_(block, block)] = True
    coupled, count = coupled[np.ix_(order, order)], 0
    for k in range(size):
        after = k + np.flatnonzero(coupled[k, k:])
        coupled[np.ix_(after, after)] = True
        count += len(after)
    return count


def drawn_blocks(size, seed, count=6):
    rng = np.random.default_rng(seed)
    blocks = [rng.choice(size, rng.integers(1, 6), replace=False) for _ in range(count)]
    return [*blocks, np.setdiff1d(np.arange(size), np.concatenate(blocks))]


@given(st.integers(6, 20), st.integers(0, 2**32 - 1))
def test_every_unknown_has_its_turn_and_those_on_the_same_blocks_one_after_the_other(size, seed):
    blocks = drawn_blocks(size, seed)
    order = elimination_order(size, blocks)
    assert sorted(order) == list(range(size))
    on = np.array([[k in block for block in blocks] for k in order])
    changes = (on[1:] != on[:-1]).any(axis=1).sum()
    assert changes == len(np.unique(on, axis=0)) - 1


def strip(tiles):
    """Blocks in a row, each coupled with the next through three unknowns, and with six of its own."""
    return [np.arange(9 * k, min(9 * k + 12, 9 * tiles)) for k in range(tiles)]


def test_blocks_in_a_row_need_no_fill_at_all():
    blocks = strip(6)
    order = elimination_order(54, blocks)
    coupled = sum(len(block) * (len(block) + 1) // 2 for block in blocks) - 5 * 3 * 4 // 2
    assert entries(54, blocks, order) == coupled
    assert entries(54, blocks, np.random.default_rng(0).permutation(54)) > 1.2 * coupled


def test_a_plate_fills_in_less_than_row_by_row_or_by_chance():
    places = np.arange(11.0)
    blocks = [Block((i, i + 1), (j, j + 1)) for i in range(10) for j in range(10)]
    traces, size = traced(places, places, blocks, TraceOrders(1, 1))
    ordered = entries(size, traces, elimination_order(size, traces))
    by_rows = entries(size, traces, np.arange(size))
    chances = [entries(size, traces, np.random.default_rng(k).permutation(size)) for k in range(3)]
    assert ordered < 0.8 * by_rows
    assert ordered < 0.5 * min(chances)
