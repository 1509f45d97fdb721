"""The reference study, what a study can leave out, and what reaches the core."""

import json
import math
import os
import pickle
import subprocess
import sys
import warnings

import pytest

from five_parts import refusing
from haptonic.errors import HaptonicError, HaptonicWarning, StudyError
from haptonic.materials import material
from haptonic.study import load, loads

PLAIN = """
material = "steel"
[cell]
pitch = "10 mm"
thickness = "1 mm"
"""


def test_a_table_of_results_in_place_of_a_study_is_answered_with_what_to_give(tmp_path):
    path = tmp_path / "bands.csv"
    path.write_text("distance (rad/m),kx (rad/m)\n0,0\n")
    with pytest.raises(StudyError) as caught:
        load(path)
    assert "ends in .toml" in caught.value.next_step


def test_reference_study_holds_the_prototype(reference_path):
    study = load(reference_path)
    assert study.title == "Touchpad with two waveguides"
    assert study.carrier == 60e3
    cell = study.cell
    assert (cell.lattice.a1, cell.lattice.a2) == ((0.007, 0.0), (0.0, 0.007))
    assert (cell.thickness, cell.pillar.diameter, cell.pillar.height) == (0.0015, 0.0035, 0.0147)
    solid = cell.material
    assert (solid.youngs_modulus, solid.poisson_ratio, solid.density) == (70e9, 0.33, 2700.0)
    assert solid.loss_factor == 1e-3
    assert (study.bands_settings.count, study.bands_settings.points, study.bands_settings.accuracy) == (
        10,
        66,
        2e-3,
    )
    first, second = study.sweep_settings
    assert (first.start, first.stop, first.steps) == (0.2, 0.8, 25)
    assert (second.start, second.stop, second.steps) == (1.0, 3.0, 25)


def test_designs_of_the_reference_sweeps(reference_path):
    study = load(reference_path)
    widths = [design.cell.pillar.diameter for design in study.designs(study.sweep_settings[0])]
    assert len(widths) == 25
    assert widths[0] == pytest.approx(0.2 * 0.007, rel=1e-15)
    assert widths[12] == pytest.approx(0.5 * 0.007, rel=1e-15)
    assert widths[-1] == pytest.approx(0.8 * 0.007, rel=1e-15)
    heights = [design.cell.pillar.height for design in study.designs(study.sweep_settings[1])]
    assert heights[0] == pytest.approx(0.007, rel=1e-15)
    assert heights[-1] == pytest.approx(0.021, rel=1e-15)
    assert {design.sweep_settings for design in study.designs(study.sweep_settings[1])} == {()}


def test_short_study_has_the_documented_defaults():
    study = loads(PLAIN)
    assert study.carrier is None
    assert study.cell.pillar is None
    assert study.cell.material == material("steel")
    assert (study.bands_settings.count, study.bands_settings.points, study.bands_settings.accuracy) == (
        10,
        66,
        2e-3,
    )
    assert (study.bands_settings.mesh.order, study.bands_settings.mesh.foot_rings) == (None, None)
    assert study.sweep_settings == ()


def test_rectangular_lattice_has_two_periods():
    text = PLAIN.replace("[cell]", '[cell]\nlattice = "rectangular"\npitch_y = "12 mm"')
    lattice = loads(text).cell.lattice
    assert (lattice.a1, lattice.a2) == ((0.01, 0.0), (0.0, 0.012))


def test_pillar_has_to_fit_into_the_shorter_period():
    text = PLAIN.replace("[cell]", '[cell]\nlattice = "rectangular"\npitch_y = "5 mm"')
    text += '[cell.pillar]\ndiameter = "4.95 mm"\nheight = "5 mm"\n'
    with refusing(StudyError, "out-of-range", "study: cell.pillar.diameter") as caught:
        loads(text)
    assert (
        caught.value.allowed == "less than 4.8 mm, so that a hundredth of the pitch stays free on either side"
    )
    assert loads(text.replace("4.95", "4.75")).cell.pillar.diameter == 0.00475


def test_units_of_other_people_are_read():
    text = PLAIN.replace('"10 mm"', '"0.5 inch"').replace('"1 mm"', '"1000 µm"')
    study = loads(text)
    assert (study.cell.lattice.pitch, study.cell.thickness) == (0.0127, 0.001)


def test_expert_mesh_is_passed_on():
    study = loads(PLAIN + "[mesh]\norder = 5\nfoot_rings = 0\n")
    assert (study.bands_settings.mesh.order, study.bands_settings.mesh.foot_rings) == (5, 0)


def test_byte_order_mark_and_windows_line_ends_are_accepted(tmp_path, reference_path, reference_text):
    path = tmp_path / "study.toml"
    path.write_bytes(b"\xef\xbb\xbf" + reference_text.replace("\n", "\r\n").encode())
    assert load(path) == load(reference_path)


def test_study_is_an_immutable_value(reference_path):
    study = load(reference_path)
    with pytest.raises(HaptonicError, match=r"dataclasses\.replace"):
        study.cell.lattice.pitch = 0.008
    assert study == load(reference_path)
    assert hash(study) == hash(load(reference_path))
    assert pickle.loads(pickle.dumps(study)) == study


def test_inputs_are_plain_si_values(reference_path):
    inputs = json.loads(json.dumps(load(reference_path).inputs(), allow_nan=False))
    assert inputs["cell"]["pillar"] == {
        "diameter": 0.0035, "height": 0.0147, "section": "round", "draft": 0.0, "fillet": 0.0, "step": None,
        "length": None, "sides": None, "corner_radius": None, "turn": None, "point": [],
        "material": None,
    }  # fmt: skip
    assert inputs["material"]["youngs_modulus"] == 70e9
    assert inputs["sweep"][0]["from"] == 0.2
    assert "title" not in inputs


def test_inputs_ignore_how_a_value_was_written(edited, reference_path):
    reference = load(reference_path)
    same = loads(edited(('"7 mm"', '"0.7 cm"'), ('"60 kHz"', '"60000 Hz"'), ("Touchpad", "Another title")))
    assert same.inputs() == reference.inputs()
    changed = [
        ('"7 mm"', '"7.0001 mm"'),
        ("0.33", "0.34"),
        ("count = 10", "count = 11"),
        ("to = 0.8", "to = 0.7"),
    ]
    for change in changed:
        assert loads(edited(change)).inputs() != reference.inputs()


def test_inputs_of_a_design_do_not_contain_its_sweep(edited):
    study = loads(edited(("to = 0.8", "to = 0.5"), ("from = 1.0", "from = 2.1")))
    by_width, by_height = (
        study.designs(study.sweep_settings[0])[-1],
        study.designs(study.sweep_settings[1])[0],
    )
    assert math.isclose(by_width.cell.pillar.height, by_height.cell.pillar.height)
    assert by_width.inputs().keys() == by_height.inputs().keys()
    assert by_width.inputs()["sweep"] == by_height.inputs()["sweep"] == []


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (
            ('pitch = "7 mm"', 'pitch = "7 m"'),
            ["cell.pitch", "7 m is unusual", "100 mm is typical", "Did you mean 7 mm"],
        ),
        (('"1.5 mm"', '"1.5 m"'), ["cell.thickness", "Did you mean 1.5 mm?"]),
        (('"2700 kg/m^3"', '"2.7 kg/m^3"'), ["material.density", "Did you mean 2700 kg/m^3?"]),
        (
            ('"70 GPa"', '"70 MPa"'),
            ["material.youngs_modulus", "500 GPa is typical, 0.1 to 100 MPa for rubber"],
        ),
        (('"60 kHz"', '"60 Hz"'), ["carrier", "Did you mean 60 kHz?"]),
        (("to = 3.0", "to = 30.0"), ["sweep[2]", "cell.pillar.height", "210 mm is unusual"]),
    ],
)
def test_unusual_value_is_warned_about_once(edited, change, words):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        loads(edited(change), "touchpad.toml")
    assert [warning.category for warning in caught] == [HaptonicWarning]
    message = str(caught[0].message)
    assert message.startswith("touchpad.toml: ")
    assert [word for word in words if word not in message] == []


GLUED = """[[cell.disc]]
diameter = "3 mm"
low = "0 mm"
high = "50 um"
material = "epoxy"
[[cell.disc]]
diameter = "3 mm"
low = "50 um"
high = "4 mm"
"""
BELOW = """[[cell.disc]]
diameter = "3 mm"
low = "-0.2 mm"
high = "2 mm"
material = "brass"
[[cell.disc]]
diameter = "3 mm"
high = "0.1 mm"
material = "epoxy"
"""
AT_GLUE = {"cell.disc[1].high": "has no effect above 50 µm, from where disc 2 replaces it"}


@pytest.mark.parametrize(
    ("change", "remarks"),
    [
        (("", ""), {}),
        (('high = "50 um"\nmaterial = "epoxy"', 'high = "0.2 mm"'), {}),  # of one material
        (('"3 mm"\nlow = "50 um"', '"2 mm"\nlow = "20 um"'), {}),  # a core in the glue
        (('"50 um"\nmaterial', '"0.2 mm"\nmaterial'), AT_GLUE),
        (('"0 mm"\nhigh = "50 um"', '"-0.2 mm"\nhigh = "0.2 mm"'), AT_GLUE),
        ((GLUED, BELOW), {"cell.disc[1].low": "has no effect below 100 µm, up to where disc 2 replaces it"}),
    ],
)  # fmt: skip
def test_an_end_that_a_later_disc_replaces_is_doubtful(change, remarks):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        study = loads(PLAIN + GLUED.replace(*change))
    assert study.doubtful() == remarks


def test_reference_study_is_usual(reference_path):
    assert load(reference_path).unusual() == ()


def test_loading_imports_neither_units_nor_workers(reference_path):
    # both are slow to import and needed by few runs; a study brings its own results and pictures along
    code = (
        "import sys; from haptonic.study import load; load(sys.argv[1]);"
        "print([name for name in ('pint', 'distributed', 'dask') if name in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(reference_path)],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )
    assert done.stdout.strip() == "[]"
