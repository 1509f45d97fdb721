"""Commands from the outside: what they print, write and refuse."""

from __future__ import annotations

import csv
import json
import os
import re
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import xarray as xr

from five_parts import assert_five_parts
from haptonic import analyses
from haptonic.cli import commands
from haptonic.cli.helping import PANELS
from haptonic.results.bands import check_text
from interrupts import hear_interrupts

pytestmark = pytest.mark.usefixtures("empty_pictures")  # of commands in this process


def test_bands_writes_its_files_and_a_table(inside, study, tmp_path):
    out = tmp_path / "out"
    ran = inside("bands", study(), "--out", out, "--surface")
    assert ran.code == 0, ran.err
    assert "band gaps" in ran.out
    summary = inside("bands", study(), "--json", "--surface").json
    assert check_text(summary["counts_checked"], summary["counts_missed"]) in " ".join(ran.out.split())
    names = {path.name for path in out.iterdir()}
    pictures = {
        f"{name}.{kind}"
        for name in ("dispersion", "natures", "modes", "iso_frequency", "density_of_states")
        for kind in ("svg", "png")
    }
    assert names == {"bands.nc", "bands.csv", "gaps.csv", "modes.vtu"} | pictures
    data = xr.load_dataset(out / "bands.nc", engine="h5netcdf")
    assert data["frequency"].attrs["units"] == "Hz"
    assert json.loads(data.attrs["inputs"])["cell"]["pitch"] == 0.007
    assert data.attrs["origin"] == "simulated"
    assert {"haptonic_version", "mesh", "code_fingerprint"} <= set(data.attrs)
    rows = list(csv.DictReader((out / "gaps.csv").read_text().splitlines()))
    complete = [row for row in rows if row["complete"] == "True"]
    assert [(row["band_below"], row["band_above"]) for row in complete] == [("6", "7")]


def test_json_is_one_object_and_nothing_is_written_without_out(inside, study, tmp_path, monkeypatch):
    path = study()
    monkeypatch.chdir(tmp_path)
    ran = inside("bands", path, "--json")
    assert ran.code == 0, ran.err
    answer = ran.json
    assert len(ran.out.splitlines()) == 1
    gap = next(g for g in answer["gaps"] if g["complete"])
    assert set(gap) >= {"lower_hz", "upper_hz", "lower_error_hz", "upper_error_hz", "complete", "between"}
    assert gap["between"] == [6, 7]
    bands = answer["bands"]
    assert np.array(bands["kappa_rad"]).shape == (13, 2)
    assert np.array(bands["frequency_hz"]).shape == (13, 8)
    assert answer["path_labels"] == ["Γ", "X", "M", "Γ"]
    assert bands["group_velocity_m_per_s"][0][0] == [None, None]
    assert answer["counts_missed"] == 0
    assert {path.name for path in tmp_path.iterdir()} == {"quick.toml"}


def test_a_second_run_is_taken_from_the_store(inside, study, tmp_path):
    store = tmp_path / "store"
    path = study()
    first = inside("sweep", path, "--json", store=store)
    assert first.code == 0, first.err
    files = {f: f.stat().st_ino for f in store.rglob("*.nc")}
    assert len(files) == 3
    second = inside("sweep", path, "--json", store=store)
    assert second.json == first.json
    assert {f: f.stat().st_ino for f in store.rglob("*.nc")} == files


def test_sweep_answers_every_design(inside, study, tmp_path):
    """By a worker: of several, `test_jobs` asks more."""
    ran = inside("sweep", study(("steps = 3", "steps = 2")), "--out", tmp_path / "out", "--workers", 1)
    assert ran.code == 0, ran.err
    assert {p.name for p in (tmp_path / "out").iterdir()} == {"sweep_1.nc", "sweep_1.svg", "sweep_1.png"}
    data = xr.load_dataset(tmp_path / "out" / "sweep_1.nc", engine="h5netcdf")
    assert data["value"].values.tolist() == [0.4, 0.6]
    assert data.attrs["own_value"] == 0.5


THIN_ONES = '[[sweep]]\nvary = "cell.thickness"\nfrom = "10 um"\nto = "20 um"\nsteps = 2\n'


def test_a_sweep_of_which_no_design_can_be_computed_is_refused(inside, study, tmp_path):
    """It had reported that no design has a gap, and ended without an error."""
    whole = study().read_text()
    # without a pillar the report is short
    pillar = whole[whole.index("[cell.pillar]") : whole.index("[bands]")]
    path = study((whole[whole.index("[[sweep]]") :], THIN_ONES), (pillar, ""))
    refused = inside("sweep", path, "--out", tmp_path / "swept")
    assert_five_parts(refused, code="out-of-range", argument="cell.thickness")
    assert not (tmp_path / "swept").exists()
    report = inside("reproduce", path, "--out", tmp_path / "report", "--json")
    assert report.code == 0, report.err
    assert "no sweep: " in report.err


def test_a_sweep_without_a_computable_design_is_reported(inside, study, tmp_path):
    path = study(("[[sweep]]", THIN_ONES + "\n[[sweep]]"))
    ran = inside("sweep", path, "--out", tmp_path / "swept")
    assert ran.code == 0, ran.err
    assert "No design along cell.thickness could be computed." in ran.out
    assert "design 2 of the sweep is left out" in ran.err


def test_files_are_overwritten_only_with_the_option(inside, study, tmp_path):
    out = tmp_path / "out"
    out.mkdir()
    (out / "gaps.csv").write_text("mine")
    assert_five_parts(
        inside("bands", study(), "--out", out), "gaps.csv", code="repeated", argument="output file"
    )
    assert (out / "gaps.csv").read_text() == "mine"
    assert [path.name for path in out.iterdir()] == ["gaps.csv"]
    assert inside("bands", study(), "--out", out, "--overwrite").code == 0
    assert (out / "gaps.csv").read_text() != "mine"


@pytest.mark.parametrize(
    ("change", "code", "argument", "given"),
    [
        (("thickness =", "thicknes ="), "unknown", "cell.thicknes", ""),
        (('"7 mm"', '"7 kHz"'), "malformed", "cell.pitch", "7 kHz"),
        (('"7 mm"', '"7"'), "malformed", "cell.pitch", ""),
        (('"3.5 mm"', '"7.5 mm"'), "out-of-range", "cell.pillar.diameter", ""),
        (('"1.5 mm"', '"0 mm"'), "out-of-range", "cell.thickness", ""),
        (('"1.5 mm"', '"-1 mm"'), "out-of-range", "cell.thickness", ""),
        (('"1.5 mm"', '"nan mm"'), "malformed", "cell.thickness", ""),
        (('"aluminium-paper"', '"aluminium-papr"'), "unknown", "material", ""),
        (("accuracy = 2e-2", "accuracy = 0"), "out-of-range", "bands.accuracy", ""),
        (("count = 8", "count = 0"), "out-of-range", "bands.count", ""),
        (("cell.pillar.diameter / cell.pitch", "__import__('os')"), "malformed", "sweep[1].vary", ""),
    ],
)
def test_bad_values_are_refused_in_five_parts(inside, study, tmp_path, change, code, argument, given):
    out = tmp_path / "out"
    assert_five_parts(inside("bands", study(change), "--out", out), given, code=code, argument=argument)
    assert not out.exists()


def test_poisson_ratio_of_one_half_is_refused(inside, study):
    constants = 'youngs_modulus = "70 GPa"\npoisson_ratio = 0.5\ndensity = "2700 kg/m^3"\n'
    path = study(('material = "aluminium-paper"\n', ""), ("[cell]\n", f"[material]\n{constants}\n[cell]\n"))
    assert_five_parts(inside("bands", path), code="out-of-range", argument="material.poisson_ratio")


def test_an_error_is_one_object_for_machines(inside, study):
    ran = inside("bands", study(('"7 mm"', '"7 kHz"')), "--json")
    assert ran.code == 2
    assert ran.json["error"]["argument"].endswith("cell.pitch")


def test_absurd_sizes_warn(inside, study):
    changes = [(f'"{size} mm"', f'"{size} m"') for size in ("7", "1.5", "3.5", "14.7")]
    ran = inside("bands", study(*changes), "--json")
    assert ran.code == 0, ran.err
    assert any("cell.pitch" in text and "typical" in text for text in ran.json["warnings"])


def test_accuracy_beyond_the_budget_is_answered_with_what_was_reached(inside, study, tmp_path):
    path = study(("accuracy = 2e-2", "accuracy = 1e-6"), ("[mesh]\norder = 2\nfoot_rings = 0\n", ""))
    ran = inside("bands", path, "--budget", "2 s", "--out", tmp_path / "out")
    assert ran.code == 0, ran.err
    assert "The required accuracy, 1e-06, is not reached" in ran.err
    assert "--budget" in ran.err or "budget" in ran.err


def test_a_mesh_of_the_study_that_misses_the_accuracy_is_reported(inside, study):
    ran = inside("bands", study(("accuracy = 2e-2", "accuracy = 1e-4")), "--json")
    assert ran.code == 0, ran.err
    (warning,) = ran.json["warnings"]
    assert "The required accuracy, 0.0001, is not reached" in warning
    assert "without it, the accuracy determines the mesh" in warning


def test_unreadable_files_and_folders(inside, study, tmp_path):
    assert_five_parts(
        inside("bands", tmp_path / "none.toml"), "none.toml", code="not-found", argument="study"
    )
    assert_five_parts(inside("bands", tmp_path), str(tmp_path), code="unreadable", argument="study")
    (tmp_path / "binary.toml").write_bytes(bytes(range(256)))
    assert_five_parts(inside("bands", tmp_path / "binary.toml"), code="malformed", argument="study")
    blocked = tmp_path / "file"
    blocked.write_text("")
    assert_five_parts(
        inside("bands", study(), "--out", blocked / "below"), code="unwritable", argument="output file"
    )


def test_a_store_that_cannot_be_used_warns_and_stops_nothing(inside, study, tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    ran = inside("bands", study(), "--json", store=blocked / "store")
    assert ran.code == 0
    assert "not stored" in ran.err
    assert ran.json["gaps"]


def test_a_study_without_sweeps_cannot_be_swept(inside, study):
    text = study().read_text()
    path = study((text[text.index("[[sweep]]") :], ""))
    assert_five_parts(inside("sweep", path), code="missing", argument="sweep")


def test_ctrl_c_keeps_what_was_done(study, tmp_path):
    path = study(("steps = 3", "steps = 60"))
    store = tmp_path / "store"
    environment = {**os.environ, "HAPTONIC_STORE": str(store), "OMP_NUM_THREADS": "1"}
    process = subprocess.Popen(
        [sys.executable, "-m", "haptonic", "sweep", str(path), "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
        preexec_fn=hear_interrupts,
    )
    deadline = time.monotonic() + 120

    def stored():
        """Results in the store, without one that is being written."""
        return [path for path in store.rglob("*.nc") if ".tmp" not in path.name]

    while len(stored()) < 2 and time.monotonic() < deadline:
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130, err
    assert "Traceback" not in err
    assert json.loads(out)["interrupted"] is True
    assert 2 <= len(stored()) < 60


def test_keys_come_from_the_schema(inside):
    keys = {key["path"]: key for key in inside("keys", "--json").json["keys"]}
    assert keys["cell.pillar.diameter"]["unit"] == "m"
    assert keys["bands.accuracy"]["default"] == "0.002"


def test_help_has_every_command_in_one_panel(inside):
    out = inside("--help").out
    titles = re.findall(r"─ ([A-Z][a-z ]+?) ─", out)
    assert titles == ["Options", *PANELS]
    commands_in_help = re.findall(r"^│ ([a-z]+) ", out, re.MULTILINE)
    assert commands_in_help[0] == "new"
    assert sorted(commands_in_help) == sorted({name.split()[0] for name in analyses.NAMES | commands.NAMES})


def test_help_and_version(inside):
    assert "reproduce" in inside("--help").out
    assert inside("--version").out.startswith("haptonic 0.")
    assert inside("nonsense").code == 2


def test_reproduce_ends_with_a_report(inside, study, tmp_path):
    out = tmp_path / "out"
    ran = inside("reproduce", study(), "--out", out)
    assert ran.code == 0, ran.err
    assert str(out / "report.html") in ran.out.replace("\n", "")
    page = (out / "report.html").read_text(encoding="utf-8")
    assert "simulated" in page
    assert (out / "sweep_1.nc").exists()
    assert (out / "bands.nc").exists()
    names = {path.name for path in out.iterdir()}
    assert {"layers.nc", "layers.svg", "layers.png", "decay.svg", "decay.png"} <= names
    assert 'id="mirror"' in page
    assert "no waveguide" in ran.err  # the gap of so coarse a mesh is not certain
    assert_five_parts(
        inside("reproduce", study(), "--out", out), str(out), code="repeated", argument="output file"
    )


@pytest.mark.parametrize(
    ("checked", "missed", "sentence"),
    [
        (3, 0, "3 comparisons: no bands missing"),
        (1, 1, "1 comparison: 1 band missing"),
        (0, 0, "not checked"),
    ],
)
def test_counts_in_words(checked, missed, sentence):
    assert sentence in check_text(checked, missed)


def test_tables_as_latex_are_all_that_is_printed(inside, study, tmp_path):
    quick = study()
    done = inside("bands", quick, "--out", tmp_path / "out", "--tables-as", "latex")
    assert done.code == 0
    assert done.out.startswith("\\begin{table}")
    assert done.out.endswith("\\end{table}\n")
    assert (tmp_path / "out" / "dispersion.svg").is_file()
    assert_five_parts(inside("bands", quick, "--tables-as", "latx"), 'write "latex"', code="unknown")
