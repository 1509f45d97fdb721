"""Errors of folders that are no scan."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, strategies as st

from five_parts import refused
from haptonic import read_scan

UNITS = {"m": 1.0, "mm": 1e-3, "": 1.0}


@pytest.mark.parametrize("below", ["scan", "monday/scan"])
@pytest.mark.parametrize("files", [["a.csv", "p1.csv"], ["p1.csv"]])
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


@given(
    st.sampled_from([(",", "."), (";", "."), (";", ","), ("\t", "."), ("\t", ",")]),
    st.sampled_from([*UNITS]),
    st.permutations(["file", "x", "y", "remark"]),
    st.sampled_from(["geometry.csv", "points.csv", "Liste.csv"]),
    st.sampled_from(["file", "Name", "FILENAME"]),
    st.sampled_from([[], ["Vibrometer export"], ["# logged", "", "a title of words"]]),
)
def test_a_folder_as_some_logger_writes_it(tmp_path_factory, form, unit, order, table, called, above):
    """Whatever parts the columns, in which order they come, and how the table of the points is called."""
    (separator, decimal), folder = form, tmp_path_factory.mktemp("scan")
    places = {"p1.csv": (0.011, 0.0025), "p2.csv": (0.012, 0.0025), "p3.csv": (0.011, 0.0035)}

    def text(value):
        return f"{value:.6g}".replace(".", decimal)

    def rows(heads, *below):
        return "\n".join([*above, separator.join(heads), *(separator.join(row) for row in below)]) + "\n"

    of_unit = f" [{unit}]" if unit else ""
    heads = {"file": called, "x": f"X{of_unit}", "y": f"y{of_unit}", "remark": "remark"}
    cells = [
        {"file": name, "x": text(x / UNITS[unit]), "y": text(y / UNITS[unit]), "remark": "fine"}
        for name, (x, y) in places.items()
    ]
    (folder / table).write_text(
        rows([heads[column] for column in order], *([row[column] for column in order] for row in cells))
    )
    for number, name in enumerate(places, start=1):
        lines = [[text(f), text(number), text(-0.5)] for f in (1e3, 2e3, 3e3)]
        (folder / name).write_text(rows(["f [Hz]", "Re [(mm/s)/V]", "Im [(mm/s)/V]"], *lines))
    response = read_scan(folder).response
    assert response.points == pytest.approx(np.array([*places.values()]))
    assert response.values[0, :, 0] == pytest.approx(1e-3 * np.array([1 - 0.5j, 2 - 0.5j, 3 - 0.5j]))


@pytest.mark.parametrize("heads", ["file,x", "datei,x,y", "1,2,3"])
def test_a_table_of_points_whose_columns_are_called_otherwise(tmp_path, heads):
    (tmp_path / "geometry.csv").write_text(f"{heads}\n{'p1.csv,1,2,'[: 2 * heads.count(',') + 6]}\n")
    refused(
        lambda: read_scan(tmp_path), heads.split(",")[0], code="missing", argument="geometry.csv of a scan"
    )
