"""Tables of bands as other programs write them, drawn by kind: right values or a refusal."""

from __future__ import annotations

import random
from collections import Counter
from pathlib import Path

import pytest
from hypothesis import given, strategies as st

from tables_of_others import Drawn, drawn, our_bands

OURS = our_bands()
NIGHTLY = 20_000  # tables
LEAST_READ = 0.9  # of the tables that are whole and have names; the others need two blanks between names


def kind_of(table: Drawn, verdict: str) -> str:
    """Of which kind a table is, and what became of it."""
    whole = "damaged" if table.damaged else table.kinds["damage"] or "whole"
    return f"{whole}, {verdict}"


@given(st.data())
def test_a_table_of_bands_is_read_rightly_or_refused(tmp_path_factory, data):
    table = drawn(lambda kinds: data.draw(st.sampled_from(kinds)))
    verdict = table.judged(tmp_path_factory.getbasetemp() / "theirs.txt", OURS)
    assert verdict in ("right", "refused"), table.kinds


def counted(tables: int, path: Path) -> Counter[str]:
    """How many tables of each kind are right, refused or wrong."""
    counts: Counter[str] = Counter()
    for seed in range(tables):
        table = drawn(random.Random(seed).choice)
        counts[kind_of(table, table.judged(path, OURS))] += 1
    return counts


@pytest.mark.parametrize("tables", [200, pytest.param(NIGHTLY, marks=pytest.mark.nightly)])
def test_none_of_many_is_wrong_and_most_of_the_whole_ones_are_read(tmp_path, tables):
    counts = counted(tables, tmp_path / "theirs.txt")
    assert not [kind for kind in counts if "wrong" in kind], counts
    whole = counts["whole, right"], counts["whole, refused"]
    assert whole[0] > LEAST_READ * sum(whole), counts
    print(dict(counts))
