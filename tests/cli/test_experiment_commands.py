"""The commands that plan trials and make them up, from the outside."""

from __future__ import annotations

import csv
import json
import re

import numpy as np
import pandas as pd
import pytest
import scipy.io.wavfile

from five_parts import assert_five_parts
from haptonic.friction.signals import Label, Record, measured
from haptonic.study import load

pytestmark = pytest.mark.usefixtures("empty_pictures")

TABLE = "[[sweep]]"
SMALL = (TABLE, """
[protocol]
blocks = 4
trials = 8
participants = 2
stroke = "60 mm"
pause = "1 s"

[touch]
force = "0.8 N"
speed = "100 mm/s"

[[sweep]]""")  # fmt: skip
PLATE = (TABLE, """
[plate]
map = "o11o2o3o"
tiles = { o = "lattice", 1 = "left", 2 = "right", 3 = "far" }

[[plate.actuator]]
name = "A1"
region = "right"
centre = ["3.5 mm", "3.5 mm"]
size = ["4 mm", "4 mm", "0.5 mm"]
material = "pzt-4"

[[sweep]]""")  # fmt: skip
BALANCED = ("[protocol]", '[protocol]\norder = "balanced"\nseed = 4')


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path, monkeypatch):
    """What is written without --out goes where it does not stay."""
    monkeypatch.chdir(tmp_path)


def listed(folder):
    return list(csv.DictReader((folder / "trials.csv").read_text("utf-8").splitlines()))


class TestProtocol:
    def test_everything_that_is_written(self, inside, study, tmp_path):
        ran = inside("protocol", study(SMALL), "--tables", "--out", tmp_path / "plan")
        assert ran.code == 0, ran.err
        assert {path.name for path in (tmp_path / "plan").iterdir()} == {
            "trials.csv", "sheet.html", "metronome.wav", "power.nc", "power.svg", "power.png",
        }  # fmt: skip
        rows = listed(tmp_path / "plan")
        assert len(rows) == 2 * 4 * 8 == len({row["file"] for row in rows})
        assert {row["origin"] for row in rows} == {"measured"}
        assert [row["actuation"] for row in rows[:4]] == ["on", "off", "on", "off"]
        sheet = (tmp_path / "plan" / "sheet.html").read_text("utf-8").replace("\N{NO-BREAK SPACE}", " ")
        assert sheet.count('class="box"') == 64
        assert sheet.count('class="page"') == 2
        assert "100 mm/s" in sheet
        assert "60 mm in 0.6 s" in sheet
        assert not re.search(r"<(script|link|img)|https?:", sheet)
        rate, track = scipy.io.wavfile.read(tmp_path / "plan" / "metronome.wav")
        assert len(track) / rate == pytest.approx(8 * 1.6 + 1)
        for words in ("less friction assumed", "not for other people", "steady drift", "simulated"):
            assert words in ran.out

    def test_json_gives_the_sample_sizes(self, inside, study, tmp_path):
        ran = inside("protocol", study(SMALL), "--json")
        answer = ran.json
        assert answer["origin"] == "simulated"
        assert answer["waveguides"] == ["WG1", "WG2"]
        driven, idle = (answer["waveguide"][name] for name in ("WG1", "WG2"))
        assert (driven["reduction"], idle["reduction"]) == (0.55, 0.11)
        assert 2 < driven["needed"] < idle["needed"]
        for guide in (driven, idle):
            chances = dict(zip(guide["participants"], guide["power"], strict=True))
            assert chances[guide["needed"]] >= 0.79
            assert chances[guide["needed"] - 1] < 0.81
        assert answer["imbalance_trials"] == pytest.approx(1)
        assert not (tmp_path / "results").exists()

    def test_a_balanced_order(self, inside, study, tmp_path):
        answers = []
        for seed, name in ((4, "one"), (4, "same"), (5, "other")):
            path = study(SMALL, ("[protocol]", f'[protocol]\norder = "balanced"\nseed = {seed}'))
            ran = inside("protocol", path, "--json", "--out", tmp_path / name)
            assert ran.json["imbalance_trials"] == 0
            assert any("cancels" in sentence for sentence in ran.json["summary"])
            answers.append([row["actuation"] for row in listed(tmp_path / name)])
        assert answers[0] == answers[1] != answers[2]

    def test_a_warning_that_all_feel_the_regions_in_the_same_order(self, inside, study):
        published = inside("protocol", study(SMALL), "--json").json["warnings"]
        assert ["in the same order" in text and 'order = "balanced"' in text for text in published] == [True]
        for change in (
            ("[protocol]", '[protocol]\norder = "balanced"'),
            ("participants = 2", "participants = 1"),
        ):
            assert inside("protocol", study(SMALL, change), "--json").json["warnings"] == []

    def test_one_participant_proves_nothing(self, inside, study):
        ran = inside("protocol", study(SMALL, ("participants = 2", "participants = 1")), "--json")
        assert ran.json["shown"] is None
        assert "allows no conclusion on other people" in ran.json["summary"][0]

    def test_more_participants_than_are_needed(self, inside, study):
        answer = inside("protocol", study(SMALL, ("participants = 2", "participants = 90")), "--json").json
        chances = answer["waveguide"]["WG2"]
        assert chances["participants"] == [*range(2, 21), 90]
        assert chances["power"][-1] > 0.99
        assert "with 90 participants the power to detect it" in answer["summary"][1]

    def test_the_plate_names_the_waveguides(self, inside, study):
        """The one with the actuator is driven, the first other one idle, unless the study names them."""
        assert inside("protocol", study(PLATE), "--json").json["waveguides"] == ["right", "left"]
        named = study(PLATE, (TABLE, '[protocol]\ndriven = "far"\nidle = "right"\n[[sweep]]'))
        assert inside("protocol", named, "--json").json["waveguides"] == ["far", "right"]
        wrong = study(PLATE, (TABLE, '[protocol]\nidle = "lift"\n[[sweep]]'))
        assert_five_parts(inside("protocol", wrong), code="unknown", argument="protocol.idle")
        single = study(PLATE, ("o11o2o3o", "o11o"), (', 2 = "right", 3 = "far"', ""), ('"right"', '"left"'))
        assert_five_parts(inside("protocol", single), code="missing", argument="protocol.idle")

    @pytest.mark.parametrize(
        ("change", "code", "argument", "given"),
        [
            (("blocks = 4", "blocks = 5"), "out-of-range", "protocol.blocks", ""),
            (("trials = 8", "trials = 8.0"), "malformed", "protocol.trials", ""),
            (('"60 mm"', '"60 um"'), "out-of-range", "protocol.stroke", ""),
            (('"100 mm/s"', '"1 mm/s"'), "out-of-range", "protocol.stroke", "60 s"),
            (('"100 mm/s"', '"100 mm"'), "malformed", "touch.speed", ""),
            (("pause", "pauze"), "unknown", "protocol.pauze", ""),
            (("[protocol]", '[protocol]\ndriven = "A"\nidle = "A"'), "conflict", "protocol.idle", ""),
            (("[protocol]", "[participants]\nidle = 0.6\n[protocol]"), "conflict", "participants.idle", ""),
            (
                ("[protocol]", "[participants]\nwithin = 22\n[protocol]"),
                "out-of-range",
                "participants.within",
                "",
            ),
        ],
    )
    def test_bad_plans_are_refused(self, inside, study, change, code, argument, given):
        assert_five_parts(inside("protocol", study(SMALL, change)), given, code=code, argument=argument)

    def test_nothing_is_overwritten_unasked(self, inside, study, tmp_path):
        path = study(SMALL)
        assert inside("protocol", path, "--out", tmp_path / "plan").code == 0
        assert_five_parts(
            inside("protocol", path, "--out", tmp_path / "plan"), code="repeated", argument="output file"
        )
        assert inside("protocol", path, "--out", tmp_path / "plan", "--overwrite").code == 0
        (tmp_path / "other").mkdir()
        (tmp_path / "other" / "power.png").touch()
        assert_five_parts(
            inside("protocol", path, "--out", tmp_path / "other"),
            "power.png",
            code="repeated",
            argument="output file",
        )
        assert len(list((tmp_path / "other").iterdir())) == 1


def strokes_of(folder, matrix=None):
    """Records by the list of trials, read without any of haptonic's readers."""
    files = {}
    for row in listed(folder):
        name = row["file"]
        table = files.setdefault(name, pd.read_csv(folder / name))
        part = table
        if "start" in row:
            inside = (table["time"] >= float(row["start"]) - 1e-9) & (
                table["time"] < float(row["stop"]) - 1e-9
            )
            part = table[inside]
        if matrix is None:
            normal, tangential = part["Fz"].to_numpy(), part["Fy"].to_numpy()
        else:
            axes = matrix @ part[[f"G{n}" for n in range(6)]].to_numpy().T
            normal, tangential = axes[2], axes[1]
        label = Label(
            row["participant"], int(row["block"]), int(row["trial"]), row["waveguide"], row["actuation"]
        )
        yield label, Record(normal, tangential, 1000.0, part["position"].to_numpy())


class TestTwin:
    def test_the_folder(self, inside, study, tmp_path):
        path = study(SMALL)
        ran = inside("simulate", "friction", path, "--out", tmp_path / "twin", "--seed", 3)
        assert ran.code == 0, ran.err
        assert "Simulated" in ran.out
        rows = listed(tmp_path / "twin")
        assert {row["origin"] for row in rows} == {"simulated"}
        names = {path.name for path in (tmp_path / "twin").iterdir()}
        assert names == {row["file"] for row in rows} | {"trials.csv", "truth.json", "study.toml"}
        assert load(tmp_path / "twin" / "study.toml") == load(path)
        stroke = pd.read_csv(tmp_path / "twin" / "P1-B01-T01.csv")
        assert len(stroke) == 900  # 0.6 s of contact, 0.3 s without
        assert stroke["time"].iloc[-1] == pytest.approx(0.899)
        truth = json.loads((tmp_path / "twin" / "truth.json").read_text("utf-8"))
        assert truth["origin"] == "simulated"
        assert truth["population"]["reduction"] == pytest.approx({"WG1": 0.55, "WG2": 0.11}, abs=1e-3)
        assert truth["population"]["stopped"] == pytest.approx(0.8, abs=0.01)
        assert set(truth["participants"]) == {"P1", "P2"}

    def test_every_form_holds_the_same_strokes(self, inside, study, tmp_path):
        """Per trial, per block and as gauge voltages: the same friction, to the steps of the converter."""
        path, frictions, forces = study(SMALL), [], []
        for name, options in (("trial", ()), ("block", ("--per", "block")), ("raw", ("--raw",))):
            folder = tmp_path / name
            ran = inside("simulate", "friction", path, "--out", folder, "--seed", 3, *options)
            assert ran.code == 0, ran.err
            matrix = np.loadtxt(folder / "calibration.csv", delimiter=",") if name == "raw" else None
            table = measured(strokes_of(folder, matrix))
            assert set(table["excluded"].values) == {""}
            frictions.append(table["friction"].values)
            forces.append(table["force"].values)
            assert table["speed"].values.mean() == pytest.approx(0.1, abs=0.006)
            assert forces[-1].mean() == pytest.approx(0.8, abs=0.2)
        assert forces[1] == pytest.approx(forces[0], abs=1e-5)
        assert forces[2] == pytest.approx(forces[0], abs=2e-3)
        assert frictions[1] == pytest.approx(frictions[0], abs=1e-6)
        assert frictions[2] == pytest.approx(frictions[0], abs=5e-3)
        assert (frictions[2] != frictions[0]).all()

    @pytest.mark.parametrize("form", ["h5", "mat", "tdms"])
    def test_other_forms(self, inside, study, tmp_path, form):
        options = ("--out", tmp_path / "twin", "--format", form, "--per", "block", "--json")
        ran = inside("simulate", "friction", study(SMALL), *options)
        assert ran.json["files"] == 8 + 3
        files = {row["file"] for row in listed(tmp_path / "twin")}
        assert len(files) == 8
        assert all((tmp_path / "twin" / name).stat().st_size > 1000 for name in files)

    def test_what_is_true_shows(self, inside, study, tmp_path):
        """Strokes without scatter: what is left is the truth itself, of everybody."""
        quiet = "[participants]\nwithin = 0\nbetween = 0.3\neffect_between = 0.1\nnoise = 0\ndrift = 0\n"
        path = study(SMALL, ("[protocol]", f'{quiet}force_spread = "0 N"\n[protocol]'))
        amplitudes = tmp_path / "amplitudes.json"
        amplitudes.write_text('{"WG1": 1e-6, "WG2": 0, "elsewhere": 1}')
        ran = inside("simulate", "friction", path, "--out", tmp_path / "twin", "--from", amplitudes, "--json")
        truth = ran.json
        assert truth["amplitude_m"] == {"WG1": 1e-6, "WG2": 0.0}
        table = measured(strokes_of(tmp_path / "twin"))
        for person, of in truth["participants"].items():
            for guide, reduction in of["reduction"].items():
                here = (table["waveguide"] == guide) & (table["participant"] == person)
                on, off = (
                    table["friction"][here & (table["actuation"] == side)].mean() for side in ("on", "off")
                )
                assert float(1 - on / off) == pytest.approx(reduction, abs=2e-3)
                assert float(off) == pytest.approx(of["friction"], rel=3e-3)
        assert truth["population"]["reduction"]["WG2"] == pytest.approx(0, abs=1e-9)
        assert truth["population"]["stopped"] == pytest.approx(1)
        amplitudes.write_text('{"WG1": 0, "WG2": 0}')
        still = inside(
            "simulate", "friction", path, "--out", tmp_path / "still", "--from", amplitudes, "--json"
        ).json["population"]
        assert still["stopped"] is None

    def test_the_same_seed_the_same_files(self, inside, study, tmp_path):
        texts = []
        for number, seed in enumerate((1, 1, 2)):
            folder = tmp_path / str(number)
            ran = inside("simulate", "friction", study(SMALL), "--out", folder, "--seed", seed,
                         "--participants", 1, "--per", "block")  # fmt: skip
            assert ran.code == 0
            texts.append((folder / "P1-B01.csv").read_bytes())
            assert not (folder / "P2-B01.csv").exists()
        assert texts[0] == texts[1] != texts[2]

    def test_bad_input_is_refused(self, inside, study, tmp_path):
        path, folder = study(SMALL), ("--out", tmp_path / "twin")
        bad = tmp_path / "bad.json"
        for text, words in (
            ("{", ("--from", "not JSON")),
            ("[1e-6]", ("--from", "WG1")),
            ('{"WG1": "1 um"}', ("--from",)),
            ('{"WG1": 1e-6}', ("amplitudes", 'add "WG2"')),
            ('{"WG1": 1.0, "WG2": 0}', ("amplitude", "1 mm")),
        ):
            bad.write_text(text)
            assert_five_parts(inside("simulate", "friction", path, *folder, "--from", bad), *words)
        none = tmp_path / "none.json"
        assert_five_parts(
            inside("simulate", "friction", path, *folder, "--from", none),
            code="not-found",
            argument="--from",
        )
        assert_five_parts(
            inside("simulate", "friction", path, *folder, "--participants", 0),
            code="out-of-range",
            argument="participants",
        )
        still = study(SMALL, ('carrier = "60 kHz"\n', ""), name="still.toml")
        assert_five_parts(inside("simulate", "friction", still, *folder), code="missing", argument="carrier")
        assert not (tmp_path / "twin").exists()
        (tmp_path / "twin").mkdir()
        (tmp_path / "twin" / "truth.json").touch()
        assert_five_parts(
            inside("simulate", "friction", path, *folder), code="repeated", argument="output file"
        )
