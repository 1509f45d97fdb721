"""The command about trials, from the outside."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from five_parts import assert_five_parts
from haptonic.analyses import named
from haptonic.analyses.runner import Runner
from haptonic.friction.phrases import averages
from trial_folders import edited, simulated, written

pytestmark = pytest.mark.usefixtures("empty_pictures")

ROOT = Path(__file__).parents[2]
MADE = simulated(trials=4)
PICTURES = {f"{name}.{kind}" for name in ("conditions", "reductions") for kind in ("svg", "png")}
TABLES = {"trials.csv", "conditions.csv", "tests.csv"}
FILES = {"trials.nc", "quality.html"} | TABLES | PICTURES


def test_friction_writes_its_files_and_tables(inside, tmp_path):
    folder = written(tmp_path / "trials", MADE, origin="simulated")
    out = tmp_path / "out"
    ran = inside("friction", folder, "--tables", "--out", out)
    assert ran.code == 0, ran.err
    assert {path.name for path in out.iterdir()} == FILES
    for words in (
        "24 trials, none of them excluded",
        "friction of each condition",
        "tests of the difference",
        "Holm",
        "WG1 trials, as published; WG2 trials, as published: trials of one participant are treated",
        "mixed model",
        "Share of the reduction that does not reach WG2",
        "one-sided test against the noticeable 11 %",
        "Drift over a session",
        "Simulated: these trials are simulated, not measured",
        "Two averages of the same trials",
    ):
        assert words in ran.out, words
    assert averages() in " ".join(ran.out.split())
    data = xr.load_dataset(out / "trials.nc", engine="h5netcdf")
    assert data.attrs["origin"] == "simulated"
    table = pd.read_csv(out / "trials.csv")
    assert table["friction"].to_numpy() == pytest.approx(data["friction"].values)
    for name in TABLES:
        assert set(pd.read_csv(out / name).get("origin", ["simulated"])) == {"simulated"}
    tests = pd.read_csv(out / "tests.csv")
    assert tests["participant"].isna().sum() == 6
    assert len(tests) == 6 + 2 * 3
    conditions = pd.read_csv(out / "conditions.csv")
    first = conditions.iloc[0]
    rows = (table["participant"] == first["participant"]) & (table["waveguide"] == first["waveguide"])
    rows &= table["actuation"] == first["actuation"]
    assert first["friction_sd"] == pytest.approx(table["friction"][rows].std())
    page = (out / "quality.html").read_text("utf-8")
    assert "Simulated: these trials are simulated, not measured" in page
    assert page.count('<section id="sheet') == 6
    assert "http" not in page.split("<body>")[0]
    assert_five_parts(
        inside("friction", folder, "--out", out), "trials.nc", code="repeated", argument="output file"
    )


def test_the_first_sentence_has_the_reduction_of_every_region(inside, tmp_path):
    folder = written(tmp_path / "trials", MADE)
    ran = inside("friction", folder, "--out", tmp_path / "out")
    assert ran.code == 0, ran.err
    every = r"WG1: friction (falls|rises) by .*; WG2: friction (falls|rises) by"
    assert re.match(every, " ".join(ran.out.split()))


def test_one_object_for_machines(inside, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    folder = written(tmp_path / "trials", MADE)
    (folder / "P2-B1-T3.csv").unlink()
    (folder / "study.toml").write_text(
        '[trials]\nfilter = "compensated"\n[[trials.exclude]]\nparticipant = "P1"\nblock = 2\ntrial = 1\n'
        'reason = "slipped"\n'
    )
    ran = inside("friction", folder, "--json")
    assert ran.code == 0, ran.err
    answer = ran.json
    assert answer["origin"] == "measured"
    assert answer["exclusions"] == {"unreadable record": 1, "declared beforehand": 1}
    details = [exclusion["detail"] for exclusion in answer["excluded"]]
    assert "slipped" in details
    assert any("P2-B1-T3.csv: no such file" in text for text in details)
    assert str(tmp_path) not in ran.out
    assert answer["rules"]["filter"] == "compensated"
    assert answer["driven"] == "WG1"
    assert answer["averages"].keys() == {"reduction", "equivalence"}
    assert all(words in averages() for words in answer["averages"].values())
    pooled = [test for test in answer["tests"] if not test["participant"]]
    assert [(test["waveguide"], test["name"]) for test in pooled] == [
        (guide, name)
        for guide in ("WG1", "WG2")
        for name in ("trials, as published", "participants", "mixed model")
    ]
    assert {"stopped", "equivalence", "drift", "conditions", "conclusions"} <= set(answer)
    assert answer["stopped"]["WG2"]["value"] == pytest.approx(
        1 - answer["reduction"]["WG2"]["value"] / answer["reduction"]["WG1"]["value"]
    )
    assert any("unequal numbers" in text for text in answer["warnings"])
    assert not (tmp_path / "results").exists()


def test_one_participant_gets_no_p_value_for_people(inside, tmp_path):
    folder = written(tmp_path / "trials", simulated(1, trials=4))
    answer = inside("friction", folder, "--json").json
    for test in answer["tests"]:
        assert (test["p"] is None) == (test["name"] != "trials, as published"), test
    assert answer["reduction"]["WG1"]["low"] is None
    assert all("one participant only" in text for text in answer["conclusions"])


def test_a_missing_condition_is_reported_and_not_tested(inside, tmp_path):
    folder = written(tmp_path / "trials", MADE)
    edited(folder, lambda t: t[(t["waveguide"] == "WG1") | (t["actuation"] == "off")])
    ran = inside("friction", folder, "--json")
    assert ran.code == 0, ran.err
    assert "WG2: no test" in ran.err
    answer = ran.json
    assert {test["waveguide"] for test in answer["tests"]} == {"WG1"}
    assert answer["stopped"] == {}


def test_a_study_elsewhere_and_the_driven_waveguide(inside, study, tmp_path):
    folder = written(tmp_path / "trials", MADE)
    path = study(("[[sweep]]", '[trials]\ndriven = "WG2"\n[[sweep]]'))
    answer = inside("friction", folder, "--study", path, "--json").json
    assert (answer["driven"], answer["driven_chosen"]) == ("WG2", "given in the study")


def test_the_result_contains_reference_values_if_they_are_given(tmp_path):
    folder, known = written(tmp_path / "trials", MADE), ROOT / "studies" / "references" / "touchpad.toml"
    asked = {"path": folder, "references": known}
    assert named("friction").run(None, Runner(), asked).published == {
        "driven": 0.55, "idle": 0.11, "stopped": 0.8,
    }  # fmt: skip
    assert named("friction").run(None, Runner(), {"path": folder}).published == {}


@pytest.mark.parametrize(
    ("text", "code", "argument", "given"),
    [
        ('[trials]\nfilter = "bessel"\n', "unknown", "trials.filter", ""),
        ('[trials]\nthreshold = "100 mm"\n', "malformed", "trials.threshold", ""),
        ('[trials]\nforce = ["5 N", "0.1 N"]\n', "conflict", "trials.force", ""),
        ("[trials]\ntreshold = 1\n", "unknown", "trials.treshold", ""),
        ('[trials.sensor]\nforce_unit = "mm"\n', "malformed", "trials.sensor.force_unit", ""),
        ('[trials.sensor]\ngauges = "a, b"\n', "malformed", "trials.sensor.gauges", ""),
        (
            '[trials.sensor]\ncalibration = "none.csv"\n',
            "not-found",
            "trials.sensor.calibration",
            "none.csv",
        ),
        ('[trials.sensor]\nnormal = "G2"\ncalibration = "c.csv"\n', "unknown", "trials.sensor.normal", ""),
        ('[trials]\ndriven = "WG9"\n', "unknown", "trials.driven", "WG9"),
        (
            '[[trials.exclude]]\nparticipant = "P1"\ntrial = 2\nreason = "x"\n',
            "missing",
            "trials.exclude[1].block",
            "",
        ),
        ('[[trials.exclude]]\nparticipant = "P7"\nreason = "x"\n', "mismatch", "trials.exclude[1]", "P7"),
        ('[[trials.exclude]]\nparticipant = "P1"\n', "missing", "trials.exclude[1].reason", ""),
    ],
)
def test_bad_studies_are_refused(inside, tmp_path, text, code, argument, given):
    folder = written(tmp_path / "trials", MADE[:8])
    (folder / "study.toml").write_text(text)
    assert_five_parts(inside("friction", folder, "--json"), given, code=code, argument=argument)


def test_bad_places_are_refused(inside, tmp_path):
    assert_five_parts(
        inside("friction", tmp_path / "none", "--json"), code="not-found", argument="folder of trials"
    )
    assert_five_parts(inside("friction", tmp_path, "--json"), code="not-found", argument="folder of trials")
    assert_five_parts(
        inside("friction", tmp_path / "none.csv", "--json"), code="not-found", argument="table of trials"
    )
    folder = written(tmp_path / "trials", MADE[:8], change=lambda f: {"a": f["time"], "b": f["Fz"]})
    assert_five_parts(
        inside("friction", folder, "--json"),
        code="unknown",
        argument="P1-B1-T1.csv: channel of the normal force",
    )


def test_json_has_no_nan(inside, tmp_path):
    folder = written(tmp_path / "trials", simulated(1, trials=2))
    ran = inside("friction", folder, "--json")
    json.loads(ran.out, parse_constant=lambda name: pytest.fail(name))
    assert np.isfinite(ran.json["reduction"]["WG1"]["value"])
