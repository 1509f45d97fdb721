"""The command about the finite plate, from the outside."""

from __future__ import annotations

import json

import numpy as np
import pytest
import xarray as xr

from five_parts import assert_five_parts
from haptonic.report import Absent, Chapter, Results
from haptonic.report.chapters.plate import chapter
from haptonic.response import read
from haptonic.results.plate.value import ERRORS
from haptonic.store import Store
from haptonic.study import load

pytestmark = pytest.mark.usefixtures("empty_pictures")

# a second drive, at the study's carrier, without amplitude
AT_CARRIER = '[[plate.force]]\nname = "F1"\nregion = "WG"\ncentre = ["1 mm", "1 mm"]\nforce = "0 N"'
PICTURES = ("plan", "maps", "velocity", "contrast", "impedance-A1")
FILES = {
    "response.nc", "maps.nc", "plate.nc", "modes.nc", "plate.vtu", "carrier.gif",
    *(f"{name}.{kind}" for name in PICTURES for kind in ("svg", "png")),
}  # fmt: skip


def test_plate_writes_its_files_and_tables(inside, plated, tmp_path):
    out = tmp_path / "out"
    ran = inside("plate", plated(), "--tables", "--out", out)
    assert ran.code == 0, ran.err
    assert {path.name for path in out.iterdir()} == FILES
    for words in (
        "root mean square velocity",
        "power at",
        "A1 dielectric",
        "modes near the carrier",
        "Simulated",
        "Largest solver error of the field",
        "solver's error",
    ):
        assert words in ran.out
    assert "excludes the discretisation" in " ".join(ran.out.split())
    assert "µm" in ran.out
    response = read(out / "response.nc")
    assert response.values.shape[0] == 19
    assert response.units == "m/s/V"
    assert response.dataset.attrs["origin"] == "simulated"
    assert response.frequency[[0, -1]] == pytest.approx([2e3, 20e3])
    lines = xr.load_dataset(out / "plate.nc", engine="h5netcdf")
    assert lines["part"].values.tolist() == ["lattice", "region WG", "actuator A1"]
    assert float(lines["solver_error"].max()) <= 1e-3
    total = lines["dissipated"].sum("loss")
    np.testing.assert_allclose(total, lines["given"], rtol=1e-4)
    assert {"haptonic_version", "inputs", "code_fingerprint", "mesh"} <= set(lines.attrs)
    # near zero frequency the patch is a capacitor: its impedance falls as 1 / omega
    impedance = lines["impedance_imag"].sel(actuator="A1").values * lines["frequency"].values
    assert (impedance[:3] < 0).all()
    assert_five_parts(inside("plate", plated(), "--out", out), code="repeated", argument="output file")


def test_plate_answers_one_frequency(inside, plated, monkeypatch):
    path = plated()
    monkeypatch.chdir(path.parent)
    ran = inside("plate", path, "--at", "9 kHz", "--json")
    assert ran.code == 0, ran.err
    answer = json.loads(ran.out)
    (line,) = answer["maps"]
    assert line["frequency_hz"] == 9e3
    assert line["solver_error"] <= 1e-3
    assert answer["origin"] == "simulated"
    assert sum(line["dissipated_w_per_v_2"].values()) == pytest.approx(line["given_w_per_v_2"], rel=1e-4)
    assert not list(path.parent.glob("results"))
    assert "excludes the discretisation" in answer["summary"][-1]
    assert len(answer["summary"][-1]) < 180  # a terminal prints it before the table
    assert {"error", "largest_error"}.isdisjoint(answer.keys() | line.keys())
    assert all("error" not in mode and mode["solver_error"] < 1e-3 for mode in answer["modes"])


@pytest.mark.parametrize(
    ("change", "at", "code", "argument"),
    [
        (("loss_factor = 5e-3", "loss_factor = 0.0"), (), "missing", "plate.loss_factor"),
        (('voltage = "10 V"', 'voltage = "0 V"'), (), "missing", "plate.actuator"),
        (("rows = 2", "rows = 2"), ("--at", "9 mm"), "malformed", "--at"),
        (("order = 2", "order = 4"), ("--at", "900 kHz"), "out-of-range", "frequency"),
        (("o11o", "o1zo"), (), "unknown", "plate.map"),
    ],
)
def test_plate_refuses(inside, plated, change, at, code, argument):
    ran = inside("plate", plated(change), "--json", *at)
    assert_five_parts(ran, code=code, argument=argument)


@pytest.mark.parametrize(
    ("change", "argument"),
    [
        (("loss_factor = 5e-3", "loss_factor = 0.0"), "plate.loss_factor"),
        (('voltage = "10 V"', 'voltage = "0 V"'), "plate.actuator"),
        (('voltage = "10 V"', 'voltage = "10 V"\ncarrier = "12 kHz"\n' + AT_CARRIER), "plate.actuator"),
    ],
)
def test_a_plan_and_a_dry_run_refuse_a_plate_that_would_not_answer(inside, plated, change, argument):
    path = plated(change)
    for command in ("plate", "feel"):
        assert_five_parts(inside(command, path, "--dry-run", "--json"), code="missing", argument=argument)
        assert load(path).plan().costs[command].refusal.argument == argument


def test_a_study_without_a_plate_is_refused(inside, study):
    assert_five_parts(inside("plate", study(), "--json"), code="missing", argument="plate")


def test_a_single_line_has_maps_and_no_spectra_and_its_body_moves_like_its_face(plated, store_folder):
    study = load(plated())
    result = study.plate(at=9e3, store=Store(store_folder))
    assert set(result.figures) == {"plan", "maps"}
    place, moved = result.body["node_position"].values, result.body["real"] + 1j * result.body["imag"]
    face = moved.values[np.isclose(place[:, 2], 0.0), 2]
    where = place[np.isclose(place[:, 2], 0.0), :2]
    # the velocity of the flat face on its own grid, from the response
    points = result.response.points
    velocity = result.response.values[0, :, 0] / (2j * np.pi * 9e3)
    near = np.linalg.norm(where[:, None] - points[None], axis=2)
    close = near.min(axis=1) < 0.8e-3
    assert close.sum() > 5
    ours, theirs = face[close], velocity[near.argmin(axis=1)[close]]
    assert abs(np.vdot(ours, theirs)) > 0.99 * np.linalg.norm(ours) * np.linalg.norm(theirs)
    assert np.linalg.norm(ours) == pytest.approx(np.linalg.norm(theirs), rel=0.1)


def test_the_chapter_of_the_report(plated, monkeypatch, store_folder):
    monkeypatch.setenv("HAPTONIC_STORE", str(store_folder))
    study = load(plated())
    result = study.plate(store=Store(store_folder))
    plate_chapter = chapter(Results(study, {"plate": result}))
    assert isinstance(plate_chapter, Chapter)
    for name in ("velocity", "contrast", "impedance-A1"):
        axes = result.figures[name].axes
        assert any("simulated" in text for panel in axes for text in (panel.get_xlabel(), panel.get_ylabel()))
    words = " ".join([*plate_chapter.paragraphs, *plate_chapter.findings])
    assert "4 pillars" in words
    assert "assumed" in words
    assert ERRORS in words
    assert all(picture.caption.startswith("Simulated") for picture in plate_chapter.pictures)
    assert all("imulated" in table.title for table in plate_chapter.tables)
    assert isinstance(chapter(Results(study, {})), Absent)
