"""Studies and cells made in Python: of values or texts, checked as in a file, changed by paths."""

import inspect
import math
import re
from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from test_study_writing import studies

from each import each
from five_parts import refused, refusing
from haptonic.analyses import NAMES, named
from haptonic.analyses.options import option_of
from haptonic.analyses.runner import Runner
from haptonic.cell import Pillar, UnitCell
from haptonic.errors import HaptonicError, StudyError
from haptonic.fields import numbers, table, with_numbers
from haptonic.fields.keys import key_of
from haptonic.lattice import Lattice
from haptonic.materials import OrthotropicMaterial, material
from haptonic.store import canonical
from haptonic.study import Study, loads
from haptonic.study.sweeps import SweepSettings
from plies import SKEWED

CELL = UnitCell(Lattice.square(7e-3), 1.5e-3, material("steel"), Pillar(3.5e-3, 14.7e-3))
SAME = {
    "values": {"cell": CELL},
    "texts": {
        "material": "steel",
        "cell": {"pitch": "7 mm", "thickness": "1.5 mm", "pillar": {"diameter": "3.5 mm", "height": 14.7e-3}},
    },
    "keys of a cell": {
        "cell": UnitCell(
            pitch="7 mm", thickness=1.5e-3, material="steel", pillar=Pillar(diameter="3.5 mm", height=14.7e-3)
        )
    },
}


def test_values_texts_and_files_give_one_study():
    variants = {way: Study(**given, carrier="60 kHz", bands={"count": 8}) for way, given in SAME.items()}
    assert len(set(variants.values())) == 1
    study = variants["values"]
    assert loads(study.to_toml()) == study
    assert study.bands_settings.count == 8
    assert study.cell.lattice == Lattice.square(7e-3)


WIDE = Pillar(6.99e-3, 10e-3)
REFUSED = {
    "a slip at the top": (lambda: Study(cell=CELL, bnads={}), "unknown", "bnads", '"bands"'),
    "a slip in a table": (lambda: Study(cell=CELL, bands={"cuont": 3}), "unknown", "bands.cuont", '"count"'),
    "a slip in a cell": (
        lambda: UnitCell(ptch=7e-3, thickness=1e-3, material="steel"),
        "unknown",
        "cell.ptch",
        '"pitch"',
    ),
    "a size": (
        lambda: Study(cell={"pitch": 1, "thickness": -1}, material="steel"),
        "out-of-range",
        "cell.thickness",
        "1 nm",
    ),
    "no pitch": (lambda: UnitCell(thickness=1e-3, material="steel"), "missing", "cell.pitch", 'pitch = "'),
    "no material": (
        lambda: Study(cell={"pitch": 7e-3, "thickness": 1e-3}),
        "missing",
        "material",
        'material = "',
    ),
    "no cell": (lambda: Study(material="steel"), "missing", "cell", "[cell]"),
    "a material twice": (lambda: Study(cell=CELL, material="steel"), "unknown", "material", ""),
    "no such material": (lambda: UnitCell(CELL.lattice, 1e-3, "stel"), "unknown", "material", '"steel"'),
    "two periods": (lambda: Lattice(pitch=1e-3, pitch_y=1e-3), "conflict", "cell.pitch_y", "pitch_y"),
    "too many": (
        lambda: UnitCell(CELL.lattice, 1e-3, "steel", None, (), "one", (), None, 9),
        "malformed",
        "cell.argument_9",
        "",
    ),
    "no number": (lambda: Lattice.square("wide"), "unknown", "cell.pitch", ""),
    "a wide pillar": (
        lambda: UnitCell(CELL.lattice, 1e-3, "steel", WIDE),
        "out-of-range",
        "cell.pillar.diameter",
        "",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_wrong_has_five_parts(case):
    make, code, argument, named_there = REFUSED[case]
    error = refused(make, code=code)
    assert error.argument == argument
    assert named_there in error.next_step


@settings(deadline=None, max_examples=30)
@given(studies(), st.data())
def test_a_number_that_is_changed_by_its_path_is_that_number_and_no_other(study, data):
    before = numbers(study)
    path = data.draw(st.sampled_from(sorted(before)))
    declared = key_of(path, table(Study))
    value = data.draw(st.floats(0.9, 1.1)) * before[path]
    try:
        other = with_numbers(study, {path: value})
    except HaptonicError:
        return  # such as a pillar wider than its cell
    assert declared is None or declared.quantity is None or declared.quantity.holds(value)
    assert numbers(other) == {**before, path: value}
    assert with_numbers(other, {path: before[path]}) == study
    assert (canonical(other) == canonical(study)) == (value == before[path])


def test_only_what_lies_on_the_way_is_made_anew():
    study = Study(cell=CELL)
    other = with_numbers(study, {"cell.pillar.diameter": 3e-3})
    assert other.cell.pillar.diameter == 3e-3
    assert other.trials is study.trials
    assert other.cell.lattice is study.cell.lattice
    assert other.cell.material == material("steel")
    with refusing(StudyError, "unknown", "name of a number", "step"):
        with_numbers(study, {"cell.pillar.step.height": 1e-3})


def test_anisotropic_materials_come_back_from_a_file():
    cell = {
        "pitch": 7e-3,
        "thickness": 1e-3,
        "pillar": {"diameter": 3e-3, "height": 4e-3, "material": SKEWED},
    }
    study = Study(material={"c11": "165.7 GPa", "c12": 63.9e9, "c44": 79.6e9, "density": 2330.0}, cell=cell)
    assert study.cell.material == OrthotropicMaterial(c11=165.7e9, c12=63.9e9, c44=79.6e9, density=2330.0)
    again = loads(study.to_toml())
    assert again == study
    assert again.inputs() == study.inputs()
    for path in ("material.c11", "cell.pillar.material.c66", "cell.pillar.material.turn"):
        assert path in study.parameters()
    assert "material.c33" not in study.parameters()
    assert study.with_parameter("material.c44", 80e9).cell.material.c44 == 80e9


def test_a_material_without_a_table_cannot_be_written():
    study = Study(cell=UnitCell(Lattice.square(7e-3), 1e-3, replace(material("pzt-4"), density=7600.0)))
    with refusing(StudyError, "unsupported", "material"):
        study.to_toml()
    silicon = Study(cell=UnitCell(Lattice.square(7e-3), 1e-3, "silicon"))
    assert loads(silicon.to_toml()) == silicon


@given(
    st.text() | st.sampled_from([*numbers(CELL, "cell."), "cell", "cell.pillar.step"]), st.floats(1e-4, 1e-2)
)
def test_a_number_of_no_name_is_an_error_of_five_parts(name, value):
    study = Study(cell=CELL)
    known = {*numbers(CELL, "cell."), *study.parameters(), "cell.pitch_y"}
    for change in (study.with_parameter, one_number):
        if name not in known:
            with pytest.raises(HaptonicError) as caught:
                change(name, value)
            assert all(caught.value.parts().values())


def one_number(path, value):
    return CELL.with_numbers({path: value})


@given(st.floats(0.0, 0.5e-3))
def test_the_radius_of_a_sharp_edge_is_a_number_like_others(radius):
    """Each value of it is a body of its own, and zero the sharp one."""
    filleted = CELL.with_numbers({"cell.pillar.fillet": radius})
    assert filleted.pillar == Pillar(3.5e-3, 14.7e-3, fillet=radius)
    assert filleted.with_numbers({"cell.pillar.fillet": 0.0}) == CELL


@pytest.mark.parametrize(
    ("argument", "value"),
    [
        ("workers", "a"),
        ("workers", True),
        ("workers", 1.5),
        ("scheduler", 3),
        ("store", "x"),
        ("progress", 1),
    ],
)
def test_what_a_run_cannot_be_given_is_refused_before_any_work(argument, value):
    error = refused(lambda: Study(cell=CELL).bands(**{argument: value}))
    assert error.argument == ("workers" if argument == "scheduler" else argument)


NEEDING_PATHS = {
    name: [field.name for field in fields(named(name).options) if field.type in ("Path", "Path | None")]
    for name in NAMES
}


@pytest.mark.parametrize("name", [name for name, paths in NEEDING_PATHS.items() if paths])
def test_a_path_that_an_analysis_takes_may_be_a_text_and_nothing_else(name, tmp_path):
    """Of every analysis with a path, whatever it is for."""
    study, analysis = Study(cell=CELL, carrier="60 kHz"), named(name)
    given = dict.fromkeys(NEEDING_PATHS[name], str(tmp_path))
    assert all(getattr(analysis.chosen(given), path) == tmp_path for path in given)
    for path in given:
        for wrong in (3, "", b"x", ["a.csv"]):
            error = refused(lambda path=path, wrong=wrong: study.run(name, **given | {path: wrong}))
            assert error.argument == path


WRONG = {
    "str": [3, None], "bool": [3, "yes"], "int": ["3", 3.5, True, [1]], "float": ["3", [1, 2], True],
    "Literal": ["another", 3],
}  # fmt: skip


@each("name", NAMES)
def test_a_value_of_another_type_is_refused(name, tmp_path):
    analysis, needed = named(name), dict.fromkeys(NEEDING_PATHS[name], tmp_path)
    for field in fields(analysis.options):
        for value in WRONG.get(re.match(r"\w+", str(field.type))[0], []):
            allows_none = value is None and "None" in str(field.type)
            is_quantity = isinstance(value, str) and (known := option_of(field)) and known.is_text
            if not (allows_none or is_quantity):
                error = refused(lambda: analysis.need_options(needed | {field.name: value}))  # noqa: B023
                assert (error.code, error.argument) == ("malformed", field.name), (field, value)


@each("name", NAMES)
def test_a_number_beyond_its_bounds_is_refused(name, tmp_path):
    analysis, needed = named(name), dict.fromkeys(NEEDING_PATHS[name], tmp_path)
    for field in fields(analysis.options):
        if (known := option_of(field)) and known.quantity:
            for value in (-1, *([math.nan] if "float" in str(field.type) else [])):
                error = refused(lambda: analysis.need_options(needed | {field.name: value}))  # noqa: B023
                assert (error.code, error.argument) == ("out-of-range", field.name)


@pytest.mark.parametrize(
    ("changes", "code", "argument"),
    [
        (["a"], "malformed", "changes"),
        ({3: 4}, "malformed", "changes"),
        ({"cell.disc[2].diameter": "3 mm"}, "unknown", "cell.disc[2].diameter"),
    ],
)
def test_changes_of_keys_that_do_not_exist_are_refused(changes, code, argument):
    disc = '[[cell.disc]]\ndiameter = "4 mm"\nempty = true\n'
    study = loads(f'material = "steel"\n[cell]\npitch = "7 mm"\nthickness = "1 mm"\n{disc}')
    error = refused(lambda: study.with_keys(changes))
    assert (error.code, error.argument) == (code, argument)


def test_keys_take_numbers_of_numpy():
    assert Study(cell=CELL).with_keys({"bands.count": np.int64(9)}).bands_settings.count == 9


@pytest.mark.parametrize(("name", "option"), [("scan", "path"), ("friction", "path"), ("compare", "second")])
def test_what_an_analysis_cannot_do_without_is_asked_for_by_its_name(name, option):
    error = refused(lambda: Study(cell=CELL).run(name, **({"first": "a.toml"} if name == "compare" else {})))
    assert (error.code, error.argument) == ("missing", option)


@each("name", NAMES)
def test_an_option_without_its_name_is_refused(name):
    error = refused(lambda: getattr(Study(cell=CELL), name.replace(" ", "_"))("measured.uff"))
    assert (error.code, error.argument) == ("malformed", f"options of {name}")
    assert all(f"{field.name}=" in error.allowed for field in fields(named(name).options))


QUANTITIES = [
    (name, field.name)
    for name in NAMES
    for field in fields(named(name).options)
    if (known := option_of(field)) and known.unit
]


@pytest.mark.parametrize(("name", "option"), QUANTITIES)
def test_a_quantity_is_called_by_its_name_in_python_and_by_its_flag_on_the_command_line(
    name, option, tmp_path
):
    given = dict.fromkeys(NEEDING_PATHS[name], str(tmp_path)) | {option: "3 apples"}
    error = refused(lambda: Study(cell=CELL).run(name, **given))
    assert error.argument == option
    assert "--" not in str(error)
    at_the_command = refused(lambda: named(name).chosen(given))
    assert at_the_command.argument == f"--{option.replace('_', '-')}"


@pytest.mark.parametrize(
    ("name", "given", "option"),
    [
        ("bands", {"modes_at": "Q"}, "modes_at"),
        ("waveguide", {"mode": "17"}, "mode"),
        ("scan", {"corners": "0 0 1 1 mm"}, "corners"),
        ("scan", {"variables": "response"}, "variables"),
        ("simulate scan", {"form": "nc", "time": True}, "form"),  # --format
        ("simulate friction", {"amplitudes": "nowhere.json"}, "amplitudes"),  # --from
    ],
)
def test_an_error_of_an_analysis_names_no_flag_in_python(name, given, option, tmp_path):
    paths = dict.fromkeys(NEEDING_PATHS[name], str(tmp_path))
    error = refused(lambda: Study(cell=CELL, carrier="60 kHz").run(name, **paths | given))
    assert error.argument == option
    assert "--" not in str(error)


def test_a_command_that_an_error_advises_keeps_its_flags(tmp_path):
    given = {"path": str(tmp_path), "against": "model.nc"}
    error = refused(lambda: named("scan").run(None, Runner(), given), argument="against")
    assert error.next_step == "haptonic scan PATH STUDY --against model.nc"


def test_a_study_without_a_title_is_printed_with_its_sentence_once():
    study = Study(material="brass", cell={"pitch": 6e-3, "thickness": 1e-3})
    assert repr(study) == "<Study: a square lattice in brass without pillars.>"
    titled = study.with_keys({"title": "Mine"})
    assert repr(titled) == "<Study: Mine: a square lattice in brass without pillars.>"


def test_scalars_of_numpy_are_numbers_everywhere():
    cell = {
        "pitch": np.float32(0.0078125),
        "thickness": np.array(1e-3),
        "pillar": {"diameter": np.float64(3e-3)},
    }
    cell["pillar"]["height"] = np.int64(1) * 4e-3
    study = Study(material="steel", cell=cell, bands={"count": np.int64(9)})
    assert study.cell.lattice.pitch == 0.0078125
    assert study.cell.thickness == 1e-3
    assert study.bands_settings.count == 9
    assert study.replace(bands={"count": np.int16(7)}).bands_settings.count == 7
    with refusing(StudyError, "malformed", "bands.count"):
        Study(material="steel", cell=cell, bands={"count": np.float64(9.5)})


def test_a_key_that_is_a_word_of_python_has_the_name_of_the_signature():
    names = [name for name in inspect.signature(SweepSettings).parameters if name != "second"]
    assert names == ["vary", "start", "to", "steps"]
    sweep = SweepSettings(vary="cell.pitch", start=6e-3, to="8 mm", steps=3)
    assert sweep == SweepSettings(**{"vary": "cell.pitch", "from": 6e-3, "to": 8e-3, "steps": 3})


@pytest.mark.parametrize("name", ["touchpad.toml", "bands.nc"])
def test_a_file_in_place_of_a_title(name):
    error = refused(lambda: Study(name), code="malformed", argument="the study")
    assert f"load({name!r})" in error.next_step


def test_a_described_value_does_not_change():
    study = Study(cell=CELL)

    def change(owner, name):
        setattr(owner, name, 1.0)

    error = refused(lambda: change(study, "bands_settings"), code="unsupported", argument="bands")
    assert "study.replace(bands=...)" in error.next_step
    error = refused(lambda: change(study.cell, "thickness"), code="unsupported", argument="cell.thickness")
    assert "dataclasses.replace" in error.next_step
    assert study.bands_settings != 1.0


def test_a_key_of_a_sweep_keeps_the_sweeps():
    sweep = {"vary": "cell.thickness", "from": "1 mm", "to": "2 mm", "steps": 5}
    study = Study(cell=CELL, sweep=[sweep, sweep | {"steps": 7}])
    changed = study.with_keys({"sweep[2].steps": 3})
    assert [each.steps for each in changed.sweep_settings] == [5, 3]
    assert not study.with_keys({"bands.count": 9}).sweep_settings
