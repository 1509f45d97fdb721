"""Differences of two results: with their errors, row by row."""

import json

import pytest

from haptonic.results.comparison import differing_inputs
from haptonic.results.differences import BEYOND, UNKNOWN, WITHIN, differences
from haptonic.results.table import Column, Ranged, Table, Uncertain
from haptonic.studio.answers import plain_table, table_of
from haptonic.studio.comparing import compared
from haptonic.studio.job import Job
from haptonic.studio.order import Order
from quick import QUICK_CELL

COLUMNS = ("gap", Column("from", "Hz", "kHz", ".2f"), Column("share", "", "%", ".1f"))


def a_table(*rows) -> Table:
    return Table("gaps", COLUMNS, rows)


FIRST = a_table(
    ("3-4", Uncertain(50e3, 100.0), 0.5), ("6-7", Uncertain(70e3, 100.0), 0.25), ("8-9", None, None)
)
SECOND = a_table(
    ("6-7", Uncertain(70.15e3, 100.0), 0.3), ("3-4", Uncertain(51e3, 100.0), 0.5), ("9-10", 90e3, 0.1)
)


def test_rows_meet_by_their_words_and_differences_know_their_errors():
    (table,) = differences([FIRST], [SECOND])
    rows = {row[:2]: row[2:] for row in table.rows}
    assert rows["3-4", "from / kHz"] == ("50.0 ± 0.1", "51.0 ± 0.1", "1.0 ± 0.2", BEYOND)
    assert rows["6-7", "from / kHz"][2:] == ("0.1 ± 0.2", WITHIN)
    assert rows["6-7", "share / %"][2:] == ("5.0", UNKNOWN)
    assert rows["9-10", "from / kHz"][:2] == ("-", "90.00")
    assert ("3-4", "share / %") not in rows
    assert table.strong == {list(rows).index(("3-4", "from / kHz"))}
    (alone,) = differences([FIRST], [])
    assert alone.rows == (("gaps", "first"),)


def test_tables_meet_though_numbers_of_their_titles_differ():
    columns = (Column("amplitude", "m", "µm", ".3f"),)
    tables = [
        Table(f"below a finger at {frequency} kHz and {drive} V", columns, [(amplitude,)])
        for frequency, drive, amplitude in (("59.47", 10, 1e-6), ("60", 200, 2e-6))
    ]
    (table,) = differences(tables[:1], tables[1:])
    assert table.title == f"differences: {tables[0].title} and {tables[1].title}"
    assert len(table.rows) == 1
    # the same title is preferred to one with another number
    (same, other) = differences(tables, tables[::-1])
    assert same.rows == other.rows == ()


def test_rows_without_words_meet_by_their_number_and_ranges_count_as_errors():
    tables = [
        Table("curve", (Column("mu", form=".3f"),), [(Ranged(0.4, 0.6),), (0.1,)]),
        Table("curve", (Column("mu", form=".3f"),), [(Ranged(0.5, 0.7, 0.55),), (0.1,)]),
    ]
    (table,) = differences(tables[:1], tables[1:])
    assert [row[0] for row in table.rows] == ["1"]
    assert table.rows[0][-1] == WITHIN


def test_a_table_survives_its_plain_values():
    table = a_table(("3-4", Uncertain(5e4, 100.0, "*"), Ranged(0.1, 0.2)), ("6", float("nan"), 0.2))
    again = table_of(json.loads(json.dumps(plain_table(table), allow_nan=False)))
    assert again.columns == table.columns
    assert again.texts == table.texts


def test_changed_keys_of_the_studies_are_listed(tmp_path):
    def a_job(number: int, text: str, table: Table) -> Job:
        order = Order(number=number, text=text, folder=tmp_path, file="a.toml", analysis="bands", options={})
        return Job(order, answer={"summary": [f"Answer {number}."], "tables": [plain_table(table)]})

    jobs = a_job(1, QUICK_CELL, FIRST), a_job(2, QUICK_CELL.replace("14.7 mm", "15 mm"), SECOND)
    answer = compared(*jobs, tmp_path)
    keys, numbers = answer["tables"]
    assert keys["rows"] == [("cell.pillar.height", "14.7 mm", "15 mm")]
    assert numbers["count"] == 5
    assert [run["summary"] for run in answer["runs"]] == [["Answer 1."], ["Answer 2."]]
    jobs[1].answer = None
    with pytest.raises(Exception, match="two runs with a result"):
        compared(*jobs, tmp_path)


def test_changed_uncertainties_have_the_unit_of_their_property():
    before, after = ({"material": {"uncertainty": {"youngs_modulus": width}}} for width in (4e9, 5e9))
    units = {"material.youngs_modulus": "Pa"}
    assert list(differing_inputs(before, after, units)) == [
        ("material.uncertainty.youngs_modulus", "4 GPa", "5 GPa")
    ]
