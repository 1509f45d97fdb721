"""A folder that is no scan: what is said of it."""

from __future__ import annotations

import pytest

from five_parts import refused
from haptonic import read_scan


@pytest.mark.parametrize("below", ["scan", "monday/scan"])
@pytest.mark.parametrize("files", [["geometry.csv", "p1.csv"], ["p1.csv"]])
def test_csv_files_in_a_folder_below_are_pointed_at(tmp_path, below, files):
    there = tmp_path / below
    there.mkdir(parents=True)
    for name in files:
        (there / name).write_text("x\n1\n")
    error = refused(lambda: read_scan(tmp_path), code="missing", argument="folder of a scan")
    assert str(there) in error.cause
    assert error.next_step == f"give that folder: {there}"


@pytest.mark.parametrize("name", ["notes.txt", "p1.csv"])
def test_a_folder_without_any_is_asked_for_its_coordinates(tmp_path, name):
    (tmp_path / name).write_text("x\n1\n")
    error = refused(lambda: read_scan(tmp_path), code="missing", argument="folder of a scan")
    assert "geometry.csv: a header" in error.next_step
