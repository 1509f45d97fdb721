"""Tables in a terminal: whatever stands in them, all of it is shown."""

from __future__ import annotations

import io

from hypothesis import given
from hypothesis import strategies as st
from rich.cells import cell_len

from haptonic.cli.console import Voice
from haptonic.results.table import Table
from hostile import names

CELLS = st.sampled_from(
    ["0.364", "1.04", "48.1 V", "16 % (0 to 36 %)", "54.974 ± 23.354 (uncertain)", "plate (driven)", "-"]
) | names.filter(lambda name: "│" not in name and cell_len(name) >= len(name))


@st.composite
def tables(draw: st.DrawFn) -> Table:
    count = draw(st.integers(1, 14))
    row = st.lists(CELLS, min_size=count, max_size=count)
    return Table(draw(names), draw(row), draw(st.lists(row, max_size=4)))


def unfolded(text: str) -> str:
    return "".join(text.split())


@given(tables(), st.sampled_from([60, 80, 120]))
def test_every_cell_is_shown_whole(table: Table, width: int) -> None:
    voice = Voice(machine=False)
    voice.out.file, voice.out.width = io.StringIO(), width
    voice.show(table)
    lines = [
        line
        for line in voice.out.file.getvalue().splitlines()
        if line[:1] in ("┃", "│") and line[-1] == line[0]
    ]
    shown = [
        unfolded("".join(one)) for one in zip(*(line[1:-1].split(line[0]) for line in lines), strict=True)
    ]
    texts = table.texts or [("none", *[""] * (len(table.columns) - 1))]
    told = [unfolded("".join(one)) for one in zip(table.head, *texts, strict=True)]
    assert [sorted(one) for one in shown] == [sorted(one) for one in told]
    assert max(map(cell_len, voice.out.file.getvalue().splitlines()[1:])) <= width
