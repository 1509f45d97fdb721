"""Tables in a terminal: all of their content is shown, whatever it is."""

from __future__ import annotations

import csv
import io
import re
from html.parser import HTMLParser

from hypothesis import example, given, strategies as st
from rich.cells import cell_len

from five_parts import refused
from haptonic.cli.console import Voice
from haptonic.names import from_cell
from haptonic.results.table import Table
from hostile import names

CELLS = st.sampled_from(
    ["0.364", "1.04", "48.1 V", "16 % (0 to 36 %)", "55 ± 30 (uncertain)", "plate (driven)", "-"]
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
    shown = []
    for part in voice.out.file.getvalue().split("┏")[1:]:
        lines = [line for line in part.splitlines() if line[:1] in ("┃", "│") and line[-1] == line[0]]
        cells = zip(*(line[1:-1].split(line[0]) for line in lines), strict=True)
        first, *others = (sorted(unfolded("".join(pieces))) for pieces in cells)
        shown += [first, *others] if not shown else others
        assert first == shown[0]
    texts = table.texts or [("none", *[""] * (len(table.columns) - 1))]
    columns = [unfolded("".join(column)) for column in zip(table.head, *texts, strict=True)]
    assert shown == [sorted(text) for text in columns]
    assert max(map(cell_len, voice.out.file.getvalue().splitlines()[1:])) <= width


@given(st.integers(2, 16), st.integers(60, 100))
def test_no_number_is_broken(count: int, width: int) -> None:
    """Of twelve columns a narrow terminal had 0.0001 above 65."""
    numbers = [f"0.000{165 + number}" for number in range(count)]
    voice = Voice(machine=False)
    voice.out.file, voice.out.width = io.StringIO(), width
    voice.show(Table("powers", [f"actuator {number}" for number in range(count)], [numbers]))
    output = voice.out.file.getvalue()
    assert all(number in output for number in numbers)


@given(tables())
@example(Table("bars", ("a|b", "c"), [("x|y", "z\\|")]))
def test_a_table_is_the_same_in_every_form(table: Table) -> None:
    """Each form is read again by the rules of its own language."""
    shown = [table.head, *table.texts]
    (head, *rows) = csv.reader(io.StringIO(table.written("csv"), newline=""))
    assert len(rows) == len(table.rows)
    assert [from_cell(name) for name in head] == list(dict.fromkeys(table.head))

    lines = table.written("markdown").split("\n")
    written = [re.split(r"(?<!\\)(?:\\\\)*\|", line)[1:-1] for line in lines if line.startswith("|")]
    assert [len(cells) for cells in written] == [len(table.head)] * (len(table.rows) + 2)

    body = table.written("latex").split("\\hline\n")[1:-1]
    written = [line.removesuffix(" \\\\").split(" & ") for part in body for line in part.split("\n") if line]
    assert [len(cells) for cells in written] == [len(cells) for cells in shown]
    for cells, texts in zip(written, shown, strict=True):
        for cell, text in zip(cells, texts, strict=True):
            bare = re.sub(r"\\[%&_$#{}]|\\text[a-z]+\{\}|\$[^$]*\$", "", cell)
            assert not set(bare) & set("%&_$#{}\\^~<>|"), (cell, text)

    reader = Cells()
    reader.feed(table.written("html"))
    assert reader.cells == [cell for cells in shown for cell in cells]


class Cells(HTMLParser):
    """Texts in the cells of a table."""

    def __init__(self) -> None:
        super().__init__()
        self.cells: list[str] = []
        self.inside = False

    def handle_starttag(self, tag, attrs):
        self.inside = tag in ("td", "th")
        self.cells += [""] * self.inside

    def handle_endtag(self, tag):
        self.inside = False

    def handle_data(self, data):
        if self.inside:
            self.cells[-1] += data


def test_a_form_that_does_not_exist_is_refused_with_the_nearest():
    refused(lambda: Table("a", ("b",), ()).written("latx"), 'write "latex"', code="unknown")
