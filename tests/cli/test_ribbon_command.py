"""The command about ribbons, from the outside."""

import re
from types import SimpleNamespace

import numpy as np
import pytest
import xarray as xr

from haptonic.analyses.ribbon import accuracy_of
from haptonic.bloch.candidates import BestModel
from haptonic.bloch.settings import BandSettings
from haptonic.results.common import accuracy_remarks
from haptonic.results.ribbon import COLUMNS, RibbonWaves
from haptonic.study import loads
from quick import FINER_CELL
from unseen_pictures import leave_pictures_empty

RIBBON = """
[ribbon]
map = "ooo111oo"
rows = 4
lowest = "55.5 kHz"
highest = "57 kHz"

[ribbon.tiles]
o = "lattice"
1 = "guide"

[ribbon.widths]
guide = "10.7 mm"
"""
FILES = {"ribbon.nc", "ribbon.svg", "ribbon.png", "field.svg", "field.png"}


@pytest.fixture(scope="module")
def ran(inside, tmp_path_factory):
    """Answer of the command in JSON, and the folder that it writes."""
    folder = tmp_path_factory.mktemp("ribbon")
    (folder / "guide.toml").write_text(FINER_CELL + RIBBON, "utf-8")
    with pytest.MonkeyPatch.context() as patch:
        leave_pictures_empty(patch)
        run = inside("ribbon", folder / "guide.toml", "--json", "--html", "--out", folder / "out")
    assert run.code == 0, run.err
    return run.json, folder / "out"


def test_ribbon_writes_its_files_and_prints_guided_waves(ran):
    answer, folder = ran
    assert {path.name for path in folder.iterdir()} == FILES | {"ribbon.html"}
    summary = " ".join(answer["summary"])
    for words in ("The guide has", "dB per row", "0x3", "group velocity"):
        assert words in summary, summary
    names = {"frequency_hz", "frequency_error_hz", "group_velocity_m_per_s", "decay_db_per_row"}
    assert names <= set(answer["guided"])


def test_errors_that_may_hide_a_wave_are_reported(ran):
    data = xr.load_dataset(ran[1] / "ribbon.nc", engine="h5netcdf")
    none = data.assign(guided=0 * data["guided"])
    unsure = none.assign(frequency_error=0 * none["frequency_error"] + 1e3)
    sure = none.assign(frequency_error=0 * none["frequency_error"] + 1.0)
    assert "hide" not in RibbonWaves(sure).summary()[0]
    assert "Errors of up to 1 kHz may hide one" in RibbonWaves(unsure).summary()[0]


DEFECT = """
[ribbon]
map = '''
ooo
olo
ooo
'''
lowest = "54.9 kHz"
highest = "55.6 kHz"
points = 2

[ribbon.tiles]
o = "lattice"
l = "lower"

[[ribbon.cell]]
name = "lower"
change = { "cell.pillar.height" = "13.5 mm" }
"""


@pytest.mark.nightly
@pytest.mark.usefixtures("empty_pictures")
def test_a_summary_of_a_defect_lists_frequencies_copies_and_damping(inside, tmp_path):
    study = FINER_CELL.replace("aluminium-paper", "aluminium-2017a") + DEFECT  # paper's aluminium has no loss
    (tmp_path / "defect.toml").write_text(study, "utf-8")
    run = inside("ribbon", tmp_path / "defect.toml", "--tables", "--out", tmp_path / "out")
    assert run.code == 0, run.err
    data = xr.load_dataset(tmp_path / "out" / "ribbon.nc", engine="h5netcdf")
    assert data["cell_share"].sizes == {"mode": data.sizes["mode"], "line": 3, "column": 3}
    inside = (data["phase"] == 0) & (data["guided"] == 1) & (data["guide_share"] >= 0.5)
    assert inside.any()
    assert data["cell_share"].values[inside, 1, 1] == pytest.approx(data["guide_share"].values[inside])
    output = " ".join(run.out.split())
    for frequency in data["frequency"].values[inside]:
        assert f"{frequency / 1e3:.2f}" in output
    for words in (
        "Modes of the defect",
        "copies of the defect, 3 cells apart",
        f"quality to {1 / data.attrs['loss_factor']:.0f}",
    ):
        assert words in output, output
    assert "wavenumber" not in output, "what changes along the ribbon has none"


STRIP = """
[ribbon]
map = "ooo"
lowest = "2 kHz"
highest = "60 kHz"
points = 5

[ribbon.tiles]
o = "lattice"
"""


@pytest.mark.usefixtures("empty_pictures")
def test_a_strip_of_crystal_has_its_waves_and_its_stop_band(inside, tmp_path):
    (tmp_path / "strip.toml").write_text(FINER_CELL + STRIP, "utf-8")
    ran = inside("ribbon", tmp_path / "strip.toml", "--tables", "--out", tmp_path / "out")
    assert ran.code == 0, ran.err
    assert {path.name for path in (tmp_path / "out").iterdir()} == FILES
    data = xr.load_dataset(tmp_path / "out" / "ribbon.nc", engine="h5netcdf")
    assert data.attrs["kind"] == "strip"
    assert (data["guided"] == 1).all()
    assert data.sizes["crystal"] == 1
    waves = RibbonWaves(data)
    low, high = waves.stop_band
    assert not ((data["frequency"] > low) & (data["frequency"] < high)).any()
    printed = " ".join(ran.out.split())
    for words in (
        f"The strip has {data.sizes['mode']} waves",
        "between the bulk bands of its crystal",
        "It has no wave from",
        "in the outermost columns",
    ):
        assert words in printed, printed
    for words in ("decay", "nodal lines across", "in the guide"):
        assert words not in printed, printed
    nothing = RibbonWaves(data.isel(mode=[]))
    assert nothing.stop_band == (2e3, 60e3)
    assert nothing.summary() == ["The strip has no wave from 2 to 60 kHz."]


@pytest.mark.parametrize(("in_gap", "guided", "words"), [
    ([0, 0], [0, 0], []), ([1, 1], [1, 1], []),
    ([1, 0], [0, 0], ["1 wave", "runs", "is"]),
    ([1, 1], [0, 0], ["2 waves", "run", "are"]),
    ([1, 1], [1, 0], ["1 wave", "runs", "is"]),
])  # fmt: skip
def test_waves_along_the_outer_edges_are_counted(in_gap, guided, words):
    names = [column.of or column.name for column in COLUMNS] + ["intervals", "frequency_error", "decay_error"]
    data = xr.Dataset({name: ("mode", [1e4, 2e4]) for name in [*names, "group_velocity_error", "phase"]})
    data["in_gap"], data["guided"] = ("mode", in_gap), ("mode", guided)
    data = data.assign_coords(wavevector=[0], line=[0])
    data.attrs = {"kind": "guide", "range_hz": [2e3, 60e3]}
    summary = RibbonWaves(data).summary()
    expected = "{} outside of the bulk bands {} along the ribbon's outer edges, and {} in no table."
    assert summary[2 if any(guided) else 1 :] == ([expected.format(*words)] if words else [])
    assert summary[0].startswith("The guide has" if any(guided) else "No wave of the guide lies outside")


def test_a_stop_band_ends_where_bands_may_turn_between_two_phases():
    """A quadratic band whose maximum is between two phases, and one above the range's end."""
    phases, period = np.linspace(0, np.pi, 5), 7e-3
    top, crest, bend = 30e3, 0.4 * np.pi, 2e3
    frequency, slope = top - bend * (phases - crest) ** 2, -2 * bend * (phases - crest)
    mode = {"frequency": frequency, "group_velocity": 2 * np.pi * period * slope}
    data = xr.Dataset({name: ("mode", values) for name, values in mode.items()})
    data["frequency_error"] = 0 * data["frequency"]
    data["wavevector_phase"] = ("wavevector", phases)
    data.attrs = {"kind": "strip", "range_hz": [1e3, 60e3], "period": period}
    low, high = RibbonWaves(data).stop_band
    assert frequency.max() < top <= low < top + 0.2 * bend
    assert high == 60e3


def test_all_modes_are_in_the_file_with_what_they_are(ran):
    _, folder = ran
    data = xr.load_dataset(folder / "ribbon.nc", engine="h5netcdf")
    assert data["wavevector_phase"].values == pytest.approx((np.arange(4) + 0.5) * np.pi / 4)
    assert data["cell_share"].sum(["line", "column"]).values == pytest.approx(np.ones(data.sizes["mode"]))
    assert (data["frequency_error"] > 0).all()
    held = data["guided"].values.astype(bool)
    assert (data["in_gap"].values[held] == 1).all()
    assert np.isnan(data["decay"].values[data["in_gap"].values == 0]).all()
    intervals = data["intervals"].values[held]
    assert intervals == pytest.approx(np.round(intervals), abs=1e-9), (
        "a whole number of them fits a resonance"
    )
    straight = (data["nodal_lines"].values == 0) & (np.abs(data["intervals"].values - 3) < 0.1)
    (mode,) = np.flatnonzero(straight & held)
    assert data["guide_share"].values[mode] > 0.9
    assert data["group_velocity"].values[mode] == pytest.approx(1560, rel=0.1)


def test_the_stated_error_of_a_plain_strip_is_that_of_its_modes():
    strip = STRIP.replace('"ooo"', '"11"').replace('o = "lattice"', '1 = "plain"').replace("60", "30")
    attributes = {}
    for name, text in (("given", FINER_CELL), ("found", re.sub(r"\[mesh\][^[]*", "", FINER_CELL))):
        data = loads(text + strip).ribbon().dataset
        attributes[name] = data.attrs
        largest = (data["frequency_error"] / data["frequency"]).max()
        assert data.attrs["largest_error"] == pytest.approx(float(largest))
    assert "stopped_by" not in attributes["given"] | attributes["found"]


def test_errors_beyond_the_accuracy_of_the_cells_name_the_smaller_accuracy():
    modes = xr.Dataset({"frequency": ("mode", [1e3, 2e3]), "frequency_error": ("mode", [10.0, 60.0])})
    settings = BandSettings(accuracy=1e-2)
    best = BestModel(SimpleNamespace(worst_error=5e-3, cell=SimpleNamespace(solid=None)))
    attributes = accuracy_of(modes, np.empty(0), [best], settings)
    assert attributes["largest_error"] == pytest.approx(0.03)
    (remark,) = accuracy_remarks(attributes)
    assert "a smaller accuracy in [bands] refines it" in remark
    assert "accept" not in remark
