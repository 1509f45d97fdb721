"""The band diagram as numbers: arrays with a name each, and a table that other programs read."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from haptonic import Study
from haptonic.results import Bands
from haptonic.study import loads
from quick import QUICK_CELL


@pytest.fixture(scope="module")
def study() -> Study:
    triangular = QUICK_CELL.replace('pitch = "7 mm"', 'pitch = "7 mm"\nlattice = "triangular"')
    return loads(triangular.replace("points = 13", "points = 25"))


@pytest.fixture(scope="module")
def bands(study) -> Bands:
    return study.bands()


def test_corners_are_those_of_the_hexagon(bands):
    """Gamma-K is 4 pi / 3a long and K-M half of that; K lies at a corner of the hexagon, M at a middle."""
    names = [name for name, _ in bands.corners]
    distances = [distance for _, distance in bands.corners]
    assert set(names) == {"Γ", "K", "M"}
    pairs = (frozenset(pair) for pair in pairwise(names))
    lengths = dict(zip(pairs, np.diff(distances), strict=True))
    third = 4 * np.pi / (3 * 7e-3)
    assert lengths[frozenset("ΓK")] == pytest.approx(third)
    assert lengths[frozenset("KM")] == pytest.approx(third / 2)
    assert lengths[frozenset("MΓ")] == pytest.approx(third * np.sqrt(3) / 2)


def test_the_distance_is_the_length_of_the_path_of_wavevectors(bands):
    steps = np.linalg.norm(np.diff(bands.wavevector, axis=0), axis=1)
    assert bands.distance == pytest.approx(np.concatenate([[0], np.cumsum(steps)]))


def test_slopes_along_the_path_are_the_group_velocities(bands):
    """Two routes to d omega / d k: the wavevectors in the table, and derivatives of the pencil."""
    (_, start), (_, stop), *_ = bands.corners
    rows = np.flatnonzero((bands.distance > start) & (bands.distance < stop))
    middle = rows[1:-1]
    omega = 2 * np.pi * bands.frequency[rows, 0]
    slope = np.gradient(omega, bands.distance[rows])[1:-1]
    direction = bands.wavevector[middle] / np.linalg.norm(bands.wavevector[middle], axis=1, keepdims=True)
    velocity = (bands.dataset["group_velocity"].values[middle, 0] * direction).sum(axis=1)
    assert len(middle) >= 3
    assert slope == pytest.approx(velocity, abs=0.1 * np.abs(velocity).max())


def test_the_table_holds_the_arrays_and_is_read_by_other_programs(bands, tmp_path):
    bands.files["bands.csv"](tmp_path / "bands.csv")
    table = pd.read_csv(tmp_path / "bands.csv")
    pd.testing.assert_frame_equal(table, bands.diagram(), rtol=1e-8)
    count = bands.frequency.shape[1]
    assert table[[f"f{band} (Hz)" for band in range(1, count + 1)]].to_numpy() == pytest.approx(
        bands.frequency
    )
    assert table[f"error of f{count} (Hz)"].to_numpy() == pytest.approx(bands.error[:, -1])
    assert (bands.error > 0).all()


def test_the_table_is_that_of_the_study_again(study, bands, tmp_path):
    """`compare` finds wavevectors and frequencies in it, and takes no error for a frequency."""
    path = tmp_path / "table.csv"
    bands.diagram().to_csv(path, index=False)
    (tmp_path / "study.toml").write_text(study.to_toml(), "utf-8")
    both = study.compare(first=str(tmp_path / "study.toml"), second=str(path))
    assert f"{bands.frequency.shape[1]} bands" in both.summary()[0]


TWO_LATTICES = """
[plate]
map = "osf1"
[plate.tiles]
o = "lattice"
s = "short"
f = "flat"
1 = "left"
[[plate.cell]]
name = "short"
change = { "cell.pillar.height" = "13 mm" }
[[plate.cell]]
name = "flat"
change = { "cell.pillar.height" = "4 mm" }
"""


def test_gaps_of_further_lattices_are_in_every_file_and_read_back(tmp_path):
    """Also a lattice without a gap is named, and each gap is that of a study of its own lattice alone."""
    bands = loads(QUICK_CELL + TWO_LATTICES).bands()
    alone = loads(QUICK_CELL.replace('height = "14.7 mm"', 'height = "13 mm"')).bands()
    edges = [gap.lower for gap in alone.gaps if gap.complete]
    assert [gap.lower for gap in bands.further["short"]] == pytest.approx(edges)
    assert len(edges) == 1
    assert (list(bands.further), bands.further["flat"]) == (["short", "flat"], ())
    for name in ("bands.nc", "gaps.csv"):
        bands.files[name](tmp_path / name)
    read = Bands(xr.load_dataset(tmp_path / "bands.nc", engine="h5netcdf"))
    assert read.further == bands.further
    assert read.gaps == bands.gaps
    table = pd.read_csv(tmp_path / "gaps.csv")
    assert [*table["lattice"]] == ["lattice"] * len(bands.gaps) + ["short"] * len(bands.further["short"])
    last, gap = table.iloc[-1], bands.further["short"][-1]
    assert (last["band_below"], last["band_above"]) == gap.between
    assert last["lower_hz"] == pytest.approx(gap.lower, abs=1e-3)
    answer = bands.to_json()["further_lattices"]
    assert [each["lower_hz"] for each in answer["short"]] == [each.lower for each in bands.further["short"]]
    assert answer["flat"] == []
