"""A scan and the verdict on its plate's model in one command."""

from __future__ import annotations

import json

import numpy as np
import pytest

from five_parts import assert_five_parts
from haptonic.analyses import scanning
from haptonic.analyses.scanning import Estimation, compute_scan
from haptonic.errors import HaptonicWarning
from haptonic.response import FrequencyResponse, read, write
from haptonic.results import write_files
from haptonic.store import Store
from haptonic.study import load
from haptonic.vibrometry import ReadReport, Scan, read_scan
from haptonic.vibrometry.of_settings import drive_for, response_for
from tiny_scan import TINY

FIT = """
[fit]
lowest = "60 kHz"
highest = "67 kHz"
points = 20

[[fit.vary]]
parameter = "plate.loss_factor"
from = 1e-3
to = 2e-2
"""
TRUE = 5e-3  # loss factor of the scanned plate
MAPS = {"response.nc", "scan.nc", "points.csv", "shape.gif", "maps.png", "contrast.png", "quality.png"}
VERDICT = {"verdict.nc", "verdict.json", "model.nc", "fitted.toml", "mac.png", "frac.png", "before-after.png"}

pytestmark = pytest.mark.filterwarnings("ignore:the period of:haptonic.errors.HaptonicWarning")


@pytest.fixture(scope="module")
def folder(tmp_path_factory, store_folder):
    """Two studies, one of them with another loss factor, a scan of the first, and what it computes."""
    out, store = tmp_path_factory.mktemp("against"), Store(store_folder)
    (out / "true.toml").write_text(TINY + FIT, "utf-8")
    wrong = TINY.replace("loss_factor = 5e-3", "loss_factor = 8e-3")
    (out / "wrong.toml").write_text(wrong + FIT, "utf-8")
    (out / "plain.toml").write_text(TINY, "utf-8")
    (out / "cell.toml").write_text(TINY[: TINY.index("[plate]")], "utf-8")
    study = load(out / "true.toml")
    question = study.scan_settings
    with pytest.warns(HaptonicWarning, match="ring-down"):
        drive = drive_for(question, study.mounted_plate())
    computed = study.plate(settings=response_for(question, 1e-3, drive), store=store).response
    with pytest.warns(HaptonicWarning, match="ring-down"):
        simulated = study.simulate_scan(seed=5, response=computed, store=store)
    write(computed, out / "model.nc")
    write_files(out, simulated.files, overwrite=False)
    return out


@pytest.mark.usefixtures("empty_pictures")
def test_one_command_gives_maps_gap_and_verdict(inside, folder, tmp_path):
    out = tmp_path / "out"
    ran = inside("scan", folder / "scan.h5", "--against", folder / "wrong.toml", "--tables", "--out", out)
    assert ran.code == 0, ran.err
    assert {file.name for file in out.iterdir()} >= MAPS | VERDICT
    for words in ("Registered", "Gap in the scan", "numbers fitted", "pairs of",
                  "Simulated measurement compared with a simulation"):  # fmt: skip
        assert words in " ".join(ran.out.split())
    data = json.loads((out / "verdict.json").read_text("utf-8"))
    (loss,) = data["fit"]["parameters"]
    assert loss["start"] == 8e-3
    assert loss["value"] == pytest.approx(TRUE, rel=0.02)
    before, after = (data["agreement"][name]["unexplained"] for name in ("model as given", "model fitted"))
    assert after < 1e-2 < 3e-2 < before
    assert load(out / "fitted.toml").plate_settings.loss_factor == pytest.approx(TRUE, rel=0.02)
    # what the scan has given is judged once more, by the same measure
    again = inside(
        "verdict", out / "response.nc", folder / "plain.toml", "--computed", out / "model.nc", "--json"
    )
    assert again.json["agreement"]["model as given"]["unexplained"] == pytest.approx(after, rel=1e-3)
    assert_five_parts(
        inside("scan", folder / "scan.h5", "--against", folder / "wrong.toml", "--out", out),
        "response.nc",
        code="repeated",
        argument="output file",
    )


@pytest.mark.nightly
def test_a_response_that_is_there_is_compared_with(inside, folder):
    """Over the whole band: both ranges of the verdict are found as that of the scan is."""
    ran = inside(
        "scan", folder / "scan.h5", folder / "plain.toml", "--against", folder / "model.nc", "--json"
    )
    assert ran.code == 0, ran.err
    verdict = ran.json["verdict"]
    assert verdict["fit"] is None
    assert list(verdict["agreement"]) == ["model as given"]
    assert verdict["agreement"]["model as given"]["unexplained"] < 1e-3
    assert verdict["agreement"]["model as given"]["frac_median"] > 0.999
    assert verdict["contrast_range"]["measurement"] == pytest.approx(ran.json["contrast_range"], rel=1e-3)


def test_the_path_is_taken_out_only_once(folder, store_folder):
    """A response that a scan has given records that delay and low-pass are removed."""
    store = Store(store_folder)
    on = scanning.on_plate(load(folder / "plain.toml"), store=store)
    first = compute_scan(read_scan(folder / "scan.h5"), Estimation(), on, store=store).response
    again = Scan(first, ReadReport("NetCDF", "memory", len(first.points)))
    second = compute_scan(again, Estimation(), on, store=store).response
    assert np.array_equal(first.values, second.values)
    assert first.points == pytest.approx(second.points, abs=1e-9)


def test_files_of_a_verdict_in_the_way_stop_it_before_the_work(inside, folder, tmp_path):
    (tmp_path / "fitted.toml").write_text("mine")
    ran = inside("scan", folder / "scan.h5", "--against", folder / "true.toml", "--out", tmp_path)
    assert_five_parts(ran, "fitted.toml", code="repeated", argument="output file")
    assert [file.name for file in tmp_path.iterdir()] == ["fitted.toml"]


@pytest.mark.parametrize(
    ("arguments", "code", "argument", "given"),
    [
        (("--against", "model.nc"), "missing", "--against", "without its study"),
        (("true.toml", "--against", "wrong.toml"), "conflict", "--against", ""),
        (("--against", "none.toml"), "not-found", "study", ""),
        (("true.toml", "--against", "none.nc"), "not-found", "file of a frequency response", "none.nc"),
        (("--against", "cell.toml"), "missing", "plate", ""),
        (("true.toml", "--against", "measured.nc"), "mismatch", "computed", ""),
    ],
)
def test_it_refuses(inside, folder, arguments, code, argument, given):
    measured = read(folder / "model.nc")
    write(FrequencyResponse(measured.dataset.assign_attrs(origin="measured")), folder / "measured.nc")
    named = [arg if arg.startswith("--") else folder / arg for arg in arguments]
    assert_five_parts(
        inside("scan", folder / "scan.h5", *named, "--json"), given, code=code, argument=argument
    )
