"""Scans in one table with a row for each point and frequency."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, strategies as st

from five_parts import refused
from haptonic import read_scan

LINES = np.linspace(40e3, 60e3, 5)
PLACES = np.array([[0.010, 0.002], [0.012, 0.002], [0.010, 0.004], [0.012, 0.004]])
VALUES = np.random.default_rng(3).standard_normal((4, 5, 2)) @ [1e-3, 1e-3j]
HEADS = ["x [mm]", "y [mm]", "frequency (kHz)", "real (mm/s/V)", "imag (mm/s/V)", "coherence"]


def table(values=VALUES):
    return [
        [1e3 * x, 1e3 * y, 1e-3 * line, 1e3 * value.real, 1e3 * value.imag, 0.9]
        for (x, y), of_point in zip(PLACES, values, strict=True)
        for line, value in zip(LINES, of_point, strict=True)
    ]


def written(path, rows, heads=HEADS):
    lines = [",".join(heads), *(",".join(f"{number:.12g}" for number in row[: len(heads)]) for row in rows)]
    path.write_text("\n".join(lines) + "\n")
    return path


@given(st.permutations(range(20)))
def test_rows_in_any_order_give_the_response(tmp_path_factory, order):
    rows = table()
    scan = read_scan(written(tmp_path_factory.mktemp("scan") / "long.csv", [rows[row] for row in order]))
    response = scan.response
    assert response.frequency == pytest.approx(LINES)
    number = [int(np.abs(PLACES - place).sum(axis=1).argmin()) for place in response.points]
    assert sorted(number) == [0, 1, 2, 3]
    measured = response.values[..., 0].T
    assert measured == pytest.approx(VALUES[number])
    assert response.dataset["coherence"].values == pytest.approx(0.9)


def test_points_that_lack_lines_are_dropped_with_the_reason(tmp_path):
    scan = read_scan(written(tmp_path / "long.csv", table()[:-2]))
    assert scan.report.points == 3
    (dropped,) = scan.report.dropped
    assert "P4" in str(dropped)


def test_rows_without_coordinates_are_listed(tmp_path):
    rows = [[np.nan, *row[1:]] if k < 5 else row for k, row in enumerate(table())]
    scan = read_scan(written(tmp_path / "long.csv", rows))
    assert scan.report.points == 3
    assert any("5 rows" in str(dropped) for dropped in scan.report.dropped)


@pytest.mark.parametrize("heads", [HEADS[1:], HEADS[:2] + HEADS[3:], HEADS[:4]])
def test_a_table_without_some_columns_is_refused(tmp_path, heads):
    kept = [HEADS.index(head) for head in heads]
    rows = [[row[column] for column in kept] for row in table()]
    refused(
        lambda: read_scan(written(tmp_path / "a.csv", rows, heads)),
        "x, y, frequency",
        code="mismatch",
        argument="a.csv",
    )


def test_a_text_that_is_no_table_is_refused(tmp_path):
    (tmp_path / "a.csv").write_text("hello")
    refused(lambda: read_scan(tmp_path / "a.csv"), "hello", code="mismatch", argument="a.csv")
