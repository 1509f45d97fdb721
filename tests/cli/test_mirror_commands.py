"""Commands about the lattice as a mirror, from the outside."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

from five_parts import assert_five_parts
from quick import QUICK_CELL

pytestmark = pytest.mark.usefixtures("empty_pictures")

FINE = (("order = 2", "order = 3"), ("foot_rings = 0", "foot_rings = 1"))  # else the gap is not certain
PROTOTYPE = ("[[sweep]]", '[waveguide]\nmode = "0x17"\nwidth = "32 mm"\nrows = 20\n\n[[sweep]]')
LAYER_FILES = {"layers.nc", "layers.html", "layers.svg", "layers.png", "decay.svg", "decay.png"}
GUIDE_FILES = {"waveguide.nc", "waveguide.svg", "waveguide.png"}


def numbers(values: object) -> list[float]:
    """All numbers of a JSON object."""
    if isinstance(values, dict):
        return [n for value in values.values() for n in numbers(value)]
    if isinstance(values, list):
        return [n for value in values for n in numbers(value)]
    return [float(values)] if isinstance(values, int | float) else []


def written(study: Path) -> set[str]:
    """Files beside a study."""
    return {str(path.relative_to(study.parent)) for path in study.parent.rglob("*") if path.is_file()} - {
        study.name
    }


@pytest.fixture
def fine(study):
    return lambda *changes: study(*FINE, *changes)


def test_errors_at_the_carrier_are_changes_if_the_carrier_moves(inside, fine, tmp_path):
    """The number of frequencies of the spectrum does not matter."""

    def computed(name: str, *changes) -> xr.Dataset:
        ran = inside("layers", fine(("points = 3", "points = 2"), *changes), "--out", tmp_path / name)
        assert ran.code == 0, ran.err
        return xr.load_dataset(tmp_path / name / "layers.nc", engine="h5netcdf")

    at = computed("at")
    share = at.attrs["relative_frequency_error"]
    carriers = {sign: f'"{float(60 * (1 + sign * share))!r} kHz"' for sign in (-1, 1)}
    moved = [computed(f"{sign}", ('"60 kHz"', carrier)) for sign, carrier in carriers.items()]
    decays = np.array([data.attrs["carrier_attenuation_db"] for data in (at, *moved)])
    expected = abs(decays[1:] - decays[0]).max() + share * decays[0]
    assert at.attrs["carrier_attenuation_error_db"] == pytest.approx(expected, rel=1e-3)
    losses = [
        -10 * np.log10(data["carrier_transmitted"].sum("outgoing").sel(incident="A0").values)
        for data in (at, *moved)
    ]
    expected = np.abs(np.array(losses[1:]) - losses[0]).max(axis=0) + share * losses[0]
    assert at["carrier_loss_error"].sel(incident="A0").values == pytest.approx(expected, rel=1e-3)


def test_layers_writes_its_files_and_tables(inside, fine, tmp_path):
    out = tmp_path / "out"
    ran = inside("layers", fine(), "--tables", "--html", "--out", out)
    assert ran.code == 0, ran.err
    assert {path.name for path in out.iterdir()} == LAYER_FILES
    for words in ("insertion loss at 60 kHz", "incident A0", "rows needed", "dB per row at the carrier"):
        assert words in ran.out
    data = xr.load_dataset(out / "layers.nc", engine="h5netcdf")
    assert data["frequency"].values == pytest.approx([36e3, 60e3, 84e3])  # 0.6 and 1.4 of the carrier
    assert dict(data["transmitted"].sizes) == {"frequency": 3, "rows": 3, "incident": 3, "outgoing": 4}
    assert data.attrs["carrier_hz"] == 60e3
    low, high = data.attrs["gap"]
    assert low < 60e3 < high
    assert {"haptonic_version", "inputs", "code_fingerprint"} <= set(data.attrs)
    assert_five_parts(
        inside("layers", fine(), "--out", out), "layers.nc", code="repeated", argument="output file"
    )


PASSED = ("transmitted", "reflected")


def test_layers_answers_a_machine_with_one_object(inside, fine, monkeypatch):
    path = fine()
    monkeypatch.chdir(path.parent)
    ran = inside("layers", path, "--json")
    assert ran.code == 0, ran.err
    assert len(ran.out.splitlines()) == 1
    assert not written(path)
    answer = ran.json
    assert all(math.isfinite(number) for number in numbers(answer))
    assert len(numbers(answer)) > 50
    assert answer["gap"]["lower_hz"] < 60e3 < answer["gap"]["upper_hz"]
    assert answer["energy_balance"] < 1e-9
    assert 0 < answer["carrier_attenuation_db"] < 10
    assert list(answer["incident"]) == ["A0", "S0", "SH0"]
    for wave in answer["incident"].values():
        assert len(wave["insulation_db"]) == len(wave["dissipated"]) == 3
        assert (np.array(wave["same_wave_db"]) >= np.array(wave["insulation_db"])).all()
        needed = [rows for rows in wave["rows_needed"].values() if rows]
        assert needed == sorted(needed)
    spectrum = answer["spectrum"]
    for family in answer["incident"]:
        shares = ([[row[family] for row in line] for line in spectrum[name]] for name in PASSED)
        assert sum(map(np.array, shares)) == pytest.approx(np.ones((3, 3)), abs=1e-9)
    # the middle of three frequencies is the carrier
    passed = [-10 * math.log10(row["A0"]) for row in spectrum["transmitted"][1]]
    assert passed == pytest.approx(answer["incident"]["A0"]["insulation_db"])
    assert spectrum["attenuation_db"][1][0] == pytest.approx(answer["carrier_attenuation_db"])


@pytest.fixture
def tiny(study):
    """As little as a spectrum can be."""
    return study(("points = 3", "points = 2"), ("count = 3", "count = 1"))


def test_a_second_run_takes_what_is_in_the_store_and_an_interrupted_one_goes_on(
    inside, tiny, tmp_path, monkeypatch
):
    monkeypatch.setattr("haptonic.analyses.layers.CHUNK", 1)
    store = tmp_path / "store"
    first = inside("layers", tiny, "--json", store=store)
    assert first.code == 0, first.err
    files = {file: file.stat().st_ino for file in store.rglob("*.nc")}
    assert len(files) == 3  # the gaps and two parts of the spectrum
    second = inside("layers", tiny, "--json", store=store)
    assert second.json == first.json
    assert {file: file.stat().st_ino for file in store.rglob("*.nc")} == files
    lost = next(file for file in files if "transmitted" in xr.load_dataset(file, engine="h5netcdf"))
    lost.unlink()
    third = inside("layers", tiny, "--json", store=store)
    assert third.json == first.json
    now = {file: file.stat().st_ino for file in store.rglob("*.nc")}
    assert set(now) == set(files)
    assert all(now[file] == number for file, number in files.items() if file != lost)


@pytest.mark.nightly
def test_a_worker_gives_the_same_numbers(haptonic, inside, tiny, tmp_path):
    here = inside("layers", tiny, "--json", store=tmp_path / "one")
    there = haptonic("layers", tiny, "--json", "--workers", 1, store=tmp_path / "other")
    assert there.code == 0, there.err
    assert len(numbers(there.json)) > 30
    assert numbers(there.json) == pytest.approx(numbers(here.json), rel=1e-9, abs=1e-12)


def test_the_papers_waveguide_resonates_as_in_a_model_of_the_plate(inside, fine, tmp_path):
    """57.0 kHz and 0.15 of the peak at its edge in an independent finite-element model of the whole plate."""
    out = tmp_path / "out"
    path = fine(PROTOTYPE)
    ran = inside("waveguide", path, "--json", "--out", out)
    assert ran.code == 0, ran.err
    assert len(ran.out.splitlines()) == 1
    assert written(path) == {f"out/{name}" for name in GUIDE_FILES}
    answer = ran.json
    assert all(math.isfinite(number) for number in numbers(answer))
    (strip,) = answer["waveguides"]
    assert answer["nearest"] == strip
    assert (answer["mode"], strip["width_m"], strip["rows"]) == ("0x17", 0.032, 20)
    assert strip["length_m"] == pytest.approx(0.140)
    assert strip["frequency_hz"] == pytest.approx(57.0e3, rel=0.01)
    assert 0.08 < strip["amplitude_at_edge"] < 0.2
    assert strip["nodal_spacing_m"] == pytest.approx(8e-3)  # 18 nodal lines, a quarter interval at each end
    assert 0 < strip["fixed_line_m"] < 2e-3
    assert strip["decay_db_per_row"] > 5
    again = inside("waveguide", path, "--out", out)
    assert_five_parts(again, "waveguide.nc", code="repeated", argument="output file")


def test_without_width_and_length_several_are_compared_and_all_lie_at_the_carrier(inside, fine):
    path = fine(('carrier = "60 kHz"', 'carrier = "57 kHz"'))
    ran = inside("waveguide", path, "--json", "--mode", "1x17")
    assert ran.code == 0, ran.err
    answer = ran.json
    strips = answer["waveguides"]
    assert answer["mode"] == "1x17"
    assert len(strips) >= 2
    assert [strip["frequency_hz"] for strip in strips] == pytest.approx([57e3] * len(strips))
    assert answer["nearest"]["amplitude_at_edge"] == min(strip["amplitude_at_edge"] for strip in strips)
    for strip in strips:
        assert strip["length_m"] == pytest.approx(strip["rows"] * 7e-3)
        assert strip["nodal_spacing_m"] == pytest.approx(strip["length_m"] / 17.5)
    widths = {strip["rows"]: strip["width_m"] for strip in strips}
    assert list(widths.values()) == sorted(
        widths.values(), reverse=True
    )  # the longer along, the shorter across


@pytest.mark.nightly
def test_a_guide_in_a_triangular_gap(inside, tmp_path):
    """The cell of the template triangular-mirror, on a mesh so coarse that it takes some seconds."""
    path = tmp_path / "triangular.toml"
    text = QUICK_CELL.replace('pitch = "7 mm"', 'lattice = "triangular"\npitch = "8 mm"')
    text = text.replace("3.5 mm", "4 mm").replace("count = 8", "count = 10")
    path.write_text(text.replace("order = 2", "order = 3") + "\n[waveguide]\nrows = 19\n", encoding="utf-8")
    ran = inside("waveguide", path, "--json", "--out", tmp_path / "out")
    assert ran.code == 0, ran.err
    nearest = ran.json["nearest"]
    assert nearest["frequency_hz"] == pytest.approx(60e3, rel=1e-6)
    # with free ends 17 intervals and a half fill the length; it falls to a third at the zigzag face
    assert nearest["nodal_spacing_m"] == pytest.approx(nearest["length_m"] / 17.5)
    assert nearest["amplitude_at_edge"] == pytest.approx(0.30, abs=0.08)
    # half a wave across, between the lines where the plate seems held; thin plates are some per cent softer
    across = np.pi / (nearest["width_m"] + 2 * nearest["fixed_line_m"])
    thin = np.sqrt(2 * np.pi * 60e3 * np.sqrt(12 * 2700 * (1 - 0.33**2) / 70e9) / 1.5e-3)
    assert 1.0 < np.hypot(across, np.pi / nearest["nodal_spacing_m"]) / thin < 1.1
    assert nearest["decay_db_per_row"] == pytest.approx(16, abs=2)


def test_nothing_is_computed_if_a_file_is_in_the_way(inside, study, tmp_path):
    out, store = tmp_path / "out", tmp_path / "store"
    out.mkdir()
    for command, name in (("layers", "decay.svg"), ("waveguide", "waveguide.png")):
        (out / name).write_text("mine")
        assert_five_parts(
            inside(command, study(), "--out", out, store=store), name, code="repeated", argument="output file"
        )
        assert (out / name).read_text() == "mine"
        assert not list(store.rglob("*.nc"))


PILLAR = '[cell.pillar]\ndiameter = "3.5 mm"\nheight = "14.7 mm"\n'
SWEEP = '[[sweep]]\nvary = "cell.pillar.diameter / cell.pitch"\nfrom = 0.4\nto = 0.6\nsteps = 3\n'
CARRIER = ('carrier = "60 kHz"\n', "")


@pytest.mark.parametrize(
    ("command", "changes", "code", "argument", "given"),
    [
        ("layers", [("count = 3", "count = 0")], "out-of-range", "layers.count", ""),
        ("layers", [("count = 3", 'angle = "90 deg"')], "out-of-range", "layers.angle", "90"),
        (
            "layers",
            [("count = 3", 'lowest = "70 kHz"\nhighest = "50 kHz"')],
            "conflict",
            "layers.highest",
            "",
        ),
        ("layers", [("count = 3", 'lowest = "90 kHz"')], "conflict", "layers.lowest", ""),
        ("layers", [("count = 3", 'highest = "30 kHz"')], "conflict", "layers.lowest", "36 kHz"),
        ("layers", [CARRIER], "missing", "carrier", ""),
        ("layers", [("count = 3", "along = [2, 0]")], "out-of-range", "layers.along", "[2, 0]"),
        ("layers", [("count = 3", "along = [0, 0]")], "out-of-range", "layers.along", "[0, 0]"),
        ("layers", [("count = 3", "along = [1, 0.5]")], "malformed", "layers.along", "0.5"),
        ("layers", [("count = 3", "along = [19, 20]")], "too-large", "layers.along", "[19, 20]"),
        ("layers", [(PILLAR, ""), (SWEEP, "")], "missing", "cell.pillar", ""),
        ("waveguide", [CARRIER], "missing", "carrier", ""),
        ("waveguide", [*FINE, ('"60 kHz"', '"40 kHz"')], "no-answer", "carrier", "40 kHz"),
        ("waveguide", [(PILLAR, ""), (SWEEP, "")], "no-answer", "carrier", ""),
    ],
)
def test_bad_values_are_refused_in_five_parts(inside, study, command, changes, code, argument, given):
    path = study(*changes)
    assert_five_parts(
        inside(command, path, "--out", path.parent / "out"), given, code=code, argument=argument
    )
    assert not written(path)


@pytest.mark.parametrize("mode", ["17", "-1x17", "0X17", "0x17\n", "x", "axb"])
def test_a_mode_that_is_not_written_like_one_is_refused(inside, study, mode):
    path = study()
    assert_five_parts(
        inside("waveguide", path, f"--mode={mode}", "--out", path.parent / "out"),
        code="malformed",
        argument="--mode",
    )
    assert not written(path)


def test_a_strip_too_narrow_for_its_mode_is_refused(inside, fine):
    path = fine(PROTOTYPE, ('"32 mm"', '"3 mm"'))
    ran = inside("waveguide", path, "--out", path.parent / "out")
    assert_five_parts(ran, code="no-answer", argument="waveguide.mode")
    assert not written(path)


def test_a_strip_in_a_crystal_without_its_mirror_is_refused(inside, study, tmp_path):
    """At 45 degrees the strip lies along an axis of symmetry of cubic silicon, at 20 degrees it does not."""
    solid = (
        '[material]\nc11 = "166 GPa"\nc12 = "64 GPa"\nc44 = "80 GPa"\ndensity = "2330 kg/m^3"\nturn = "{}"\n'
    )
    path = study(('material = "aluminium-paper"\n', ""), ("[cell]", solid.format("20 deg") + "[cell]"))
    ran = inside("waveguide", path, store=tmp_path / "store")
    assert_five_parts(ran, "haptonic ribbon", code="unsupported", argument="material.turn")
    path = study(('material = "aluminium-paper"\n', ""), ("[cell]", solid.format("45 deg") + "[cell]"))
    assert inside("waveguide", path, "--dry-run").code == 0


@pytest.mark.parametrize(("turn", "is_refused"), [("0 deg", False), ("90 deg", True)])
def test_unequal_ends_are_not_closed(inside, study, tmp_path, turn, is_refused):
    """Triangles that point along the strip turn a tip to one of its ends and a base to the other."""
    triangle = f'diameter = "2.4 mm"\nsection = "polygon"\nsides = 3\nturn = "{turn}"'
    path = study(('diameter = "3.5 mm"', triangle), (SWEEP, '[waveguide]\nends = "mirror"\n'))
    ran = inside("waveguide", path, "--dry-run", store=tmp_path / "store")
    if is_refused:
        assert_five_parts(ran, code="unsupported", argument="waveguide.ends")
    else:
        assert ran.code == 0, ran.err


def test_ends_that_no_rows_close_are_refused_before_anything_is_computed(inside, study, tmp_path):
    """An oblique lattice has no rows at a right angle to the strip; a square one has them."""
    ends = ("[[sweep]]", '[waveguide]\nends = "mirror"\n\n[[sweep]]')
    oblique = ('pitch = "7 mm"', 'lattice = "oblique"\npitch = "7 mm"\npitch_2 = "8 mm"\nangle = "77 deg"')
    vary = (
        '"cell.pillar.diameter / cell.pitch"\nfrom = 0.4\nto = 0.6',
        '"cell.pillar.height"\nfrom = "9 mm"\nto = "10 mm"',
    )
    path = study(ends, oblique, vary)
    ran = inside("waveguide", path, store=tmp_path / "store")
    assert_five_parts(ran, "right angle", code="unsupported", argument="waveguide.ends")
    assert not (tmp_path / "store").exists()
    ran = inside("waveguide", study(ends), "--dry-run")
    assert ran.code == 0, ran.err
