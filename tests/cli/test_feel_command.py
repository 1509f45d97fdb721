"""The command about what a finger feels, from the outside."""

from __future__ import annotations

import json

import numpy as np
import pytest
import xarray as xr

from five_parts import assert_five_parts
from haptonic.report import Absent, Chapter, Results
from haptonic.report.chapters.feel import chapter
from haptonic.study import load

pytestmark = pytest.mark.usefixtures("empty_pictures")

FILES = {"feel.nc", *(f"{name}.{kind}" for name in ("friction", "reduction") for kind in ("svg", "png"))}
TOUCH = ("[[sweep]]", '[touch]\nforce = "0.8 N"\nvoltage = "200 V"\n\n[[sweep]]')


def test_feel_writes_its_files_and_tables(inside, plated, tmp_path):
    out = tmp_path / "out"
    ran = inside("feel", plated(TOUCH), "--tables", "--out", out)
    assert ran.code == 0, ran.err
    assert {path.name for path in out.iterdir()} == FILES
    for words in (
        "WG (driven)",
        "200 V, simulated",
        "Assumed, not measured",
        "contact gap",
        "■ red",
        "0.8 N",
    ):
        assert words in ran.out, ran.out
    with xr.open_dataset(out / "feel.nc", engine="h5netcdf") as data:
        assert data.attrs["origin"] == "simulated"
        assert json.loads(data.attrs["touch"]) == {"force_n": 0.8, "speed_m_s": 0.078}
        assert ((data["low"] <= data["value"]) & (data["value"] <= data["high"])).all()
    again = inside("feel", plated(TOUCH), "--out", out)
    assert_five_parts(again, code="repeated", argument="output file")


def test_the_voltage_scales_amplitudes_and_nothing_is_computed_anew(inside, plated):
    low, high = (inside("feel", plated(), "--voltage", volts, "--json").json for volts in ("10 V", "30 V"))
    single, triple = (answer["regions"]["WG"] for answer in (low, high))
    assert triple["amplitude_m"] == pytest.approx(3 * single["amplitude_m"])
    assert single["amplitude_m"] < single["amplitude_without_finger_m"]
    assert triple["reduction"] > single["reduction"]
    assert single["drive_to_be_felt_v"] == pytest.approx(triple["drive_to_be_felt_v"], rel=1e-3)
    assert low["origin"] == "simulated"
    assert low["quality_factor"] < low["quality_factor_without_finger"]
    assert {requirement["colour"] for requirement in low["requirements"]} <= {"green", "amber", "red"}
    # the same plate at the same frequency by the other command, per volt, without a finger
    line = inside("plate", plated(), "--at", f"{low['frequency_hz']} Hz", "--json").json["maps"][0]
    assert line["finger_m_per_v"]["WG"] * 10 == pytest.approx(
        single["amplitude_without_finger_m"], rel=0.35
    )  # its largest against our mean


def test_feel_at_a_frequency_and_for_a_reduction(inside, plated):
    answer = inside("feel", plated(), "--at", "9 kHz", "--reduction", "0.3", "--json").json
    assert answer["frequency_hz"] == pytest.approx(9e3)
    drive = answer["drive_for"]["WG"]
    if drive is None:
        pytest.fail("no drive found")
    again = inside("feel", plated(), "--at", "9 kHz", "--voltage", f"{drive} V", "--json").json
    assert again["regions"]["WG"]["reduction"] == pytest.approx(0.3, abs=2e-3)


FORCED = '[[plate.force]]\nname = "F"\nregion = "WG"\ncentre = ["4 mm", "4 mm"]\nforce = "2 N"\n'


def test_a_carrier_has_its_own_drives_only(inside, plated):
    forced = plated(("[[sweep]]", f'{FORCED}carrier = "9 kHz"\n\n[[sweep]]'))
    at_own, elsewhere = (inside("feel", forced, "--at", at, "--json").json for at in ("9 kHz", "10 kHz"))
    assert at_own["drive"] == {"amplitude": 2.0, "unit": "N"}
    assert elsewhere["drive"]["unit"] == "V"


def test_drives_that_keep_their_ratio_are_named(inside, plated, tmp_path):
    forced = plated(("[[sweep]]", f"{FORCED}\n[[sweep]]"))
    words = " ".join(inside("feel", forced, "--at", "9 kHz", "--out", tmp_path / "out").out.split())
    assert "V at A1, WG (driven)" in words
    assert "For other amplitudes of A1, F keeps its ratio to it." in words


def test_the_map_is_that_of_the_response(inside, plated, tmp_path):
    out = tmp_path / "out"
    inside("feel", plated(), "--out", out)
    assert load(out / "feel.nc") == load(plated())
    with xr.open_dataset(out / "feel.nc", engine="h5netcdf") as data:
        order = np.argsort(data["amplitude"].values)
        assert (np.diff(data["value"].values[order]) <= 1e-12).all()  # more vibration, less friction


@pytest.mark.parametrize(
    ("options", "code", "argument", "given"),
    [
        (["--voltage", "200"], "malformed", "--voltage", ""),
        (["--voltage", "3 kHz"], "malformed", "--voltage", ""),
        (["--voltage", "0 V"], "out-of-range", "voltage", ""),
        (["--voltage", "-5 V"], "out-of-range", "voltage", "-5 V"),
        (["--at", "58 mm"], "malformed", "--at", ""),
        (["--at", "5 Hz"], "out-of-range", "touch.frequency", ""),
        (["--reduction", "55"], "out-of-range", "reduction", ""),
    ],
)
def test_bad_options_are_refused(inside, plated, options, code, argument, given):
    assert_five_parts(inside("feel", plated(), *options, "--json"), given, code=code, argument=argument)


def test_a_wrong_reduction_is_refused_before_anything_is_computed(inside, plated, tmp_path):
    ran = inside("feel", plated(), "--reduction", "55", "--json", store=tmp_path / "store")
    assert_five_parts(ran, code="out-of-range", argument="reduction")
    assert not (tmp_path / "store").exists()


@pytest.mark.parametrize(
    ("change", "options", "argument"),
    [('force = "5 N"', [], "touch.force"), ('force = "1 N"', ["--at", "900 kHz"], "frequency")],
)
def test_a_large_force_and_a_high_frequency_are_refused_before_anything_is_computed(
    inside, plated, tmp_path, change, options, argument
):
    study = plated(("[[sweep]]", f"[touch]\n{change}\n\n[[sweep]]"))
    ran = inside("feel", study, *options, "--dry-run", "--json", store=tmp_path / "store")
    assert_five_parts(ran, code="out-of-range", argument=argument)
    assert not (tmp_path / "store").exists()


def test_a_voltage_for_a_plate_that_a_force_drives_is_refused(inside, plated):
    force = (
        "[[plate.actuator]]",
        '[[plate.force]]\nregion = "WG"\nname = "F"\ncentre = ["7 mm", "7 mm"]\n\n',
    )
    study = plated(force)
    text = study.read_text("utf-8")
    study.write_text(text[: text.index('name = "A1"')] + text[text.index("[plate.response]") :], "utf-8")
    assert_five_parts(
        inside("feel", study, "--voltage", "200 V", "--json"), code="conflict", argument="voltage"
    )


@pytest.mark.parametrize(
    ("change", "code", "argument"),
    [
        ('damping = ["30 N s/m", "10 N s/m", "5 N s/m"]', "conflict", "touch.damping"),
        ('force = "2000 N"', "out-of-range", "touch.force"),
        ('skin = { contact_gap = ["4 um", "3 um", "5 um"] }', "conflict", "touch.skin.contact_gap"),
        ('skin = { gap = ["4 um", "5 um", "6 um"] }', "unknown", "touch.skin.gap"),
        ('skin = { film_share = "1" }', "malformed", "touch.skin.film_share"),
        ('voltage = "0 V"', "out-of-range", "touch.voltage"),
    ],
)
def test_bad_keys_of_the_touch_are_refused(inside, plated, change, code, argument):
    assert_five_parts(
        inside("feel", plated(("[[sweep]]", f"[touch]\n{change}\n\n[[sweep]]"))), code=code, argument=argument
    )


def test_a_study_without_a_plate_is_refused(inside, study):
    assert_five_parts(inside("feel", study(), "--json"), code="missing", argument="plate")


def test_the_report_contains_friction_reductions(plated, monkeypatch, store_folder):
    monkeypatch.setenv("HAPTONIC_STORE", str(store_folder))
    study = load(plated())
    result = study.feel()
    feel_chapter = chapter(Results(study, {"feel": result}))
    assert isinstance(feel_chapter, Chapter)
    assert len(feel_chapter.pictures) == 2
    felt = result.friction.reductions()["WG"]
    assert any(str(felt) in words for words in feel_chapter.findings)
    assert any(f"{result.friction.quality():.0f}; the vibration" in words for words in feel_chapter.findings)
    assert not any("paper" in words for words in feel_chapter.findings)  # it is not its plate
    assert all("imulated" in picture.caption for picture in feel_chapter.pictures)
    assert isinstance(chapter(Results(study, {})), Absent)
