"""The command that compares a measured response with a plate's model, from the outside."""

from __future__ import annotations

import json

import numpy as np
import pytest
import xarray as xr

from five_parts import assert_five_parts
from haptonic.analyses.plate_needs import fineness
from haptonic.plate.layout.sampling import grid_points
from haptonic.plate.vibration.responses import responded
from haptonic.response import FrequencyResponse, read, write
from haptonic.study import load
from haptonic.updating.parameters import changed

pytestmark = pytest.mark.usefixtures("empty_pictures")

MATERIAL = (
    'material = "aluminium-paper"',
    "material = { youngs_modulus = '70 GPa', poisson_ratio = 0.33, density = '2700 kg/m^3' }",
)
PLATE = (
    "[[sweep]]",
    """
[plate]
map = \"\"\"
112o
\"\"\"
rows = 2
loss_factor = 8e-3

[plate.tiles]
o = "lattice"
1 = "WG1"
2 = "WG2"

[plate.edges]
left = "spring"
spring = "3e11 N/m^3"

[[plate.force]]
name = "F1"
region = "WG1"
centre = ["9 mm", "4 mm"]
force = "2 N"

[fit]
lowest = "1 kHz"
highest = "20 kHz"
points = 12

[[fit.vary]]
parameter = "material.youngs_modulus"
from = "63 GPa"
to = "77 GPa"

[[fit.vary]]
parameter = "plate.loss_factor"
from = 2e-3
to = 3e-2

[[sweep]]""",
)
YOUNG = 'parameter = "material.youngs_modulus"\nfrom = "63 GPa"\nto = "77 GPa"'
LOSS = 'parameter = "plate.loss_factor"\nfrom = 2e-3\nto = 3e-2'
CARRIER = ('carrier = "60 kHz"', 'carrier = "10 kHz"')
FILES = {
    "verdict.nc", "verdict.json", "model.nc", "fitted.toml",
    *(f"{name}.{kind}" for name in ("before-after", "frac", "mac") for kind in ("svg", "png")),
}  # fmt: skip
TRUE = {"material.youngs_modulus": 73e9, "plate.loss_factor": 0.012}


@pytest.fixture
def plated(study):
    return lambda *changes: study(CARRIER, MATERIAL, PLATE, *changes)


@pytest.fixture(scope="session")
def exact():
    """Response of the plate with the true numbers, once."""
    return {}


@pytest.fixture
def scan(plated, exact, tmp_path):
    """Write a simulated scan with 1 % of noise, wider than what is compared; two points are off the plate."""

    def make(**others):
        if not exact:
            described = load(plated())
            of = changed(described.mounted_plate(), TRUE)
            points, regions = grid_points(of, 3e-3)
            lines = np.linspace(0, 22e3, 221)
            computed = responded(of, lines[10:], points, regions, 1e-3, fineness=fineness(described))
            values = np.concatenate([np.zeros((10, *computed.values.shape[1:])), computed.values])
            exact.update(values=values, lines=lines, points=points)
        chance, values, points = np.random.default_rng(0), exact["values"], exact["points"]
        size = 0.01 * np.sqrt((np.abs(values) ** 2).mean() / 2)
        beside = np.concatenate([points, [[40e-3, 5e-3], [-2e-3, 5e-3]]])
        values = np.concatenate([values, np.ones((len(values), 2, 1))], axis=1)
        values = values + size * (
            chance.standard_normal(values.shape) + 1j * chance.standard_normal(values.shape)
        )
        attributes = {"reference": "F1, N", "origin": "simulated", "title": "a plate"} | others
        factor = attributes.pop("factor", 1.0)
        response = FrequencyResponse.of(
            values, frequency=exact["lines"], x=factor * beside[:, 0], y=factor * beside[:, 1], **attributes
        )
        write(response, tmp_path / "scan.nc")
        return tmp_path / "scan.nc"

    return make


def test_verdict_finds_the_numbers_and_writes_its_files(inside, plated, scan, tmp_path):
    path, out = scan(), tmp_path / "out"
    ran = inside("verdict", path, plated(), "--tables", "--out", out)
    assert ran.code == 0, ran.err
    assert {file.name for file in out.iterdir()} == FILES
    for words in ("numbers fitted", "pairs of", "look independent", "outside the plate: 2 points",
                  "Simulated measurement compared with a simulation"):  # fmt: skip
        assert words in " ".join(ran.out.split())
    data = json.loads((out / "verdict.json").read_text("utf-8"))
    for parameter in data["fit"]["parameters"]:
        low, high = parameter["interval_95"]
        assert low < TRUE[parameter["name"]] < high < 1.03 * low
    assert data["fit"]["recomputed_error"] < 1e-3
    before, after = data["agreement"]["model as given"], data["agreement"]["model fitted"]
    assert after["unexplained"] < 1e-3 < 0.1 < before["unexplained"]
    assert after["frac_median"] > 0.999
    assert after["shapes"] == "operating shapes", "a line in the half-power width of a mode is too few"
    assert len(after["pairs"]) == len(after["measured_hz"]) >= 3
    assert all(pair["mac"] > 0.98 and abs(pair["frequency_difference"]) < 2e-3 for pair in after["pairs"])
    assert (data["measurement"], data["model"], data["points_left_out"]) == ("simulated", "simulated", 2)
    kept = xr.load_dataset(out / "verdict.nc", engine="h5netcdf")
    assert kept["frac"].sizes == {"model": 2, "point": data["points"]}
    assert "simulated" in kept.attrs["origin"]
    text = (out / "fitted.toml").read_text("utf-8")
    assert text.startswith('# Numbers fitted to a simulated response, "a plate":\n')
    updated = load(out / "fitted.toml")
    fitted = {parameter["name"]: parameter["value"] for parameter in data["fit"]["parameters"]}
    assert updated.cell.material.youngs_modulus == pytest.approx(fitted["material.youngs_modulus"], rel=1e-12)
    assert updated.plate_settings.loss_factor == pytest.approx(fitted["plate.loss_factor"], rel=1e-12)
    assert read(out / "model.nc").dataset.attrs["origin"] == "simulated"


def test_a_response_that_is_there_is_not_computed_again(inside, plated, scan, monkeypatch):
    """The simulated scan against itself, without anything to fit and without the extra for modes."""
    monkeypatch.setattr("haptonic.analyses.verdict.can_identify", lambda: False)
    path = scan()
    without = PLATE[1][PLATE[1].index("[[fit.vary]]") : PLATE[1].index("[[sweep]]")]
    ran = inside("verdict", path, plated((without, "")), "--computed", path, "--json")
    assert ran.code == 0, ran.err
    assert ran.json["fit"] is None
    assert ran.json["agreement"]["model as given"]["unexplained"] == 0
    assert list(ran.json["agreement"]) == ["model as given"]
    assert ran.json["agreement"]["model as given"]["shapes"] == "operating shapes"


def test_a_constant_of_a_built_in_material_is_fitted_and_written(inside, plated, scan, tmp_path):
    out = tmp_path / "out"
    ran = inside("verdict", scan(), plated((MATERIAL[1], MATERIAL[0])), "--json", "--out", out)
    assert ran.code == 0, ran.err
    fitted = {parameter["name"]: parameter["value"] for parameter in ran.json["fit"]["parameters"]}
    assert fitted["material.youngs_modulus"] == pytest.approx(73e9, rel=1e-2)
    material = load(out / "fitted.toml").cell.material
    assert material.youngs_modulus == pytest.approx(fitted["material.youngs_modulus"], rel=1e-12)
    assert material.density == pytest.approx(2700)


@pytest.mark.parametrize(
    ("others", "code", "argument"),
    [
        ({"reference": "A1, V"}, "mismatch", "reference"),
        ({"reference": ""}, "mismatch", "reference"),
        ({"factor": 1e3}, "mismatch", "points"),
        ({"direction": ("x",)}, "missing", "direction"),
    ],
)
def test_a_scan_of_something_else_is_refused(inside, plated, scan, others, code, argument):
    assert_five_parts(inside("verdict", scan(**others), plated()), code=code, argument=argument)


def test_files_in_the_way_stop_it_before_the_work(inside, plated, scan, tmp_path):
    out = tmp_path / "out"
    out.mkdir()
    (out / "fitted.toml").write_text("mine")
    assert_five_parts(
        inside("verdict", scan(), plated(), "--out", out),
        "fitted.toml",
        code="repeated",
        argument="output file",
    )
    assert (out / "fitted.toml").read_text() == "mine"


@pytest.mark.parametrize(
    ("change", "code", "argument"),
    [
        (("material.youngs_modulus", "material.young"), "unknown", "fit.vary[1].parameter"),
        (
            (YOUNG, 'parameter = "plate.clamp.spring"\nfrom = "1 N/m^3"\nto = "2 N/m^3"'),
            "missing", "fit.vary[1].parameter",
        ),
        (('from = "63 GPa"', 'from = "71 GPa"'), "conflict", "fit.vary[1]"),
        (('from = "63 GPa"', 'from = "80 GPa"'), "conflict", "fit.vary[1].to"),
        (('from = "63 GPa"', 'from = "63 mm"'), "malformed", "fit.vary[1].from"),
        ((LOSS, YOUNG), "repeated", "fit.vary"),
        (('highest = "20 kHz"', 'highest = "500 Hz"'), "conflict", "fit.highest"),
    ],
)  # fmt: skip
def test_unknowns_that_cannot_be_fitted_are_refused(inside, plated, scan, change, code, argument):
    assert_five_parts(inside("verdict", scan(), plated(change)), code=code, argument=argument)


def test_a_study_without_a_plate_has_no_verdict(inside, study, scan):
    assert_five_parts(inside("verdict", scan(), study()), code="missing", argument="plate")


def test_a_study_in_the_place_of_the_response_is_refused(inside, tmp_path):
    study, scan = tmp_path / "study.toml", tmp_path / "response.nc"
    study.write_text("material = 'steel'")
    scan.write_bytes(b"\x89HDF\r\n\0")
    assert_five_parts(inside("verdict", study, scan), code="conflict", argument="response")
