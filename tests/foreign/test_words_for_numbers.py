"""Files that are whole, with words where numbers belong: named or refused, never a traceback."""

from __future__ import annotations

from contextlib import suppress

import numpy as np
import pandas as pd
import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from five_parts import refusing
from haptonic.channels import opened
from haptonic.errors import ChannelError, FrictionError, HaptonicError
from haptonic.friction.recordings.trial_table import TrialTable
from haptonic.vibrometry import read_scan
from pace import within

SLOW = settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
# what int, float, isdigit and numpy each understand differently, and any text without a line's end
WORDS = st.one_of(
    st.sampled_from(
        ["nan", "inf", "-inf", "1e999", "-1", "1_0", "\u00b2", "1\u00b2", "\u0663", "0x1", "1D3", "9" * 400]
    ),
    st.floats().map(repr),
    st.text(st.characters(exclude_categories=("Cs", "Cc", "Z")), min_size=1, max_size=8),
)


def universal(node="1", place="0.0", kind="11", joined="1", units="1.0") -> str:
    """Units, one node, a line and a curve of two lines at it, with words where they are asked for."""
    header = ["NONE"] * 5
    header += [f"{4:5d}{0:10d}{1:5d}{0:10d} {'NONE':<10}{1:10d}{3:4d} {'A1':<10}{0:10d}{0:4d}"]
    header += [f"{5:10d}{2:10d}{1:10d}{1.0:13.5e}{1.0:13.5e}{0.0:13.5e}"]
    axes = [
        f"{18:10d}    0    0    0 {'f':<20} {'Hz':<20}",
        f"{kind:>10}    0    0    0 {'v':<20} {'m/s':<20}",
    ]
    axes += [
        f"{1:10d}    0    0    0 {'u':<20} {'V':<20}",
        f"{0:10d}    0    0    0 {'NONE':<20} {'NONE':<20}",
    ]
    sets = {
        164: [f"{9:10d}{'other':<20}{1:10d}", f" {units} 1.0 1.0", " 0.0"],
        15: [f" {node} 0 0 0 {place} 0.0 0.0", " 1 0 0 0 0.0 0.0 0.0"],
        82: [f"{1:10d}{2:10d}{0:10d}", "outline", f" {joined} 1"],
        58: [*header, *axes, f"{1.0:13.5e}{1.0:13.5e}{1.0:13.5e}{1.0:13.5e}"],
    }
    return "".join(
        "    -1\n" + "\n".join([f"{kind:6d}", *lines]) + "\n    -1\n" for kind, lines in sets.items()
    )


def test_the_file_is_good(tmp_path):
    (tmp_path / "a.uff").write_text(universal())
    assert read_scan(tmp_path / "a.uff").report.complete


@given(st.sampled_from(["node", "place", "kind", "joined", "units"]), WORDS)
@SLOW
def test_universal_files(tmp_path, where, word):
    (tmp_path / "a.uff").write_text(universal(**{where: word}), encoding="utf-8")
    with suppress(HaptonicError):
        assert np.isfinite(read_scan(tmp_path / "a.uff").response.points).all()


@pytest.mark.parametrize("filled", [False, True])
def test_thousands_of_small_data_sets(tmp_path, filled):
    """50 000 lines to draw, empty or not, took 30 s when each went through a file of its own."""
    text = "\n".join(["         1         2         0", "outline", " 1 1"]) + "\n" if filled else ""
    block = f"    -1\n    82\n{text}    -1\n"
    (tmp_path / "a.uff").write_text(universal() + block * 50_000)
    with within(8.0):
        scan = read_scan(tmp_path / "a.uff")
    assert not scan.report.dropped  # lines to draw are no measurement, and an empty block is no damage


@given(
    st.sampled_from(["x", "file"]),
    WORDS | st.sampled_from(["\0", "a\0.csv"]),
    st.sampled_from(["utf-8", "latin-1"]),
)
@SLOW
def test_folders_of_csv(tmp_path, column, word, encoding):
    row = {"file": "a.csv", "x": "0.0", "y": "0.0"} | {column: word}
    table = "file,x,y\nb.csv,0.001,0.0\n" + ",".join(row.values()) + "\n"
    (tmp_path / "geometry.csv").write_bytes(table.encode(encoding, "replace"))
    for name in "ab":
        (tmp_path / f"{name}.csv").write_text("frequency,real (m/s/V),imaginary\n1,2,3\n")
    with suppress(HaptonicError):
        assert np.isfinite(read_scan(tmp_path, frequency_unit="Hz", length_unit="m").response.points).all()


def test_a_name_in_the_code_page_of_an_older_program(tmp_path):
    (tmp_path / "geometry.csv").write_bytes("file,x,y\nmöbel.csv,0,0\n".encode("latin-1"))
    (tmp_path / "möbel.csv").write_text("frequency,real (m/s/V),imaginary\n1,2,3\n")
    assert read_scan(tmp_path, frequency_unit="Hz", length_unit="m").report.complete


@given(st.sampled_from(["start", "stop"]), st.floats().filter(lambda time: not np.isnan(time)))
@SLOW
def test_times_of_a_trial(tmp_path, column, given_time):
    row = {
        "participant": "P1",
        "block": 1,
        "trial": 1,
        "waveguide": "WG1",
        "actuation": "on",
        "file": "a.csv",
    }
    pd.DataFrame([row | {column: given_time}]).to_csv(tmp_path / "trials.csv", index=False)
    if 0 <= given_time < 1e9:
        (place,) = TrialTable.read(tmp_path).spans
        assert getattr(place, column) == pytest.approx(given_time)
    else:
        with refusing(FrictionError, "malformed", f"column {column}"):
            TrialTable.read(tmp_path)


@given(st.text(st.characters(exclude_categories=("Cs", "Cc")), min_size=1, max_size=20), st.integers(1, 400))
@SLOW
def test_names_of_recordings(tmp_path, name, times):
    """The table of trials of others names whatever it likes, also what no system takes for a name."""
    name = name * times
    with pytest.raises(ChannelError):
        opened(tmp_path / (name + ".csv").replace("/", "_"))
