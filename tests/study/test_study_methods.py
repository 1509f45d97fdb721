"""A study in Python: methods show their options, misuse is answered, and slips of units are warned about."""

from __future__ import annotations

import inspect
import pydoc
import warnings
from dataclasses import fields

import pytest
from hypothesis import given, settings, strategies as st

from five_parts import assert_explained
from haptonic.analyses import NAMES, named
from haptonic.analyses.options import option_of
from haptonic.analyses.tables import settings_of
from haptonic.cell import Pillar, UnitCell
from haptonic.errors import HaptonicWarning, StudyError
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.study import Study, loads

SIZES = {"pitch": 7e-3, "thickness": 1.5e-3, "pillar": {"diameter": 3.5e-3, "height": 14.7e-3}}
STUDY = Study(cell=SIZES, material="steel", carrier=60e3)
WITH_TABLE = [name for name in NAMES if settings_of(name)]


@pytest.mark.parametrize("name", NAMES)
def test_help_and_signature_show_every_option_with_its_default_and_words(name):
    method = getattr(STUDY, name.replace(" ", "_"))
    shown, options = inspect.signature(method), fields(named(name).options)
    help_text = " ".join(pydoc.render_doc(method, renderer=pydoc.plaintext).split())
    assert NAMES[name] in help_text
    assert [field.name for field in options] == list(shown.parameters)[: len(options)]
    assert list(shown.parameters)[len(options) :] == ["store", "workers", "scheduler", "progress", "budget"]
    for field in options:
        known = option_of(field)
        assert f"{field.name} : " in help_text
        assert known is None or " ".join(known.help.split()) in help_text
        default = shown.parameters[field.name].default
        assert default == field.default or default is inspect.Parameter.empty
    assert shown.return_annotation is named(name).result
    assert method.__doc__ == getattr(Study, method.__name__).__doc__
    assert method.__name__ in dir(STUDY)


@given(st.sampled_from(WITH_TABLE), st.data())
@settings(deadline=None, max_examples=40)
def test_a_setting_given_as_an_option_is_answered_with_where_it_belongs(name, data):
    options = {field.name for field in fields(named(name).options)} | set(
        inspect.signature(Study.run).parameters
    )
    key = data.draw(st.sampled_from([setting for setting in settings_of(name) if setting not in options]))
    with pytest.raises(StudyError) as caught:
        getattr(STUDY, name.replace(" ", "_"))(**{key: 3})
    assert_explained(caught.value, f"table [{name}]", f'"{key}": 3', f"{name}.{key}", argument=key)


def test_a_sweep_by_place_is_answered_with_where_sweeps_are_declared():
    with pytest.raises(StudyError) as caught:
        STUDY.sweep("cell.pillar.height", [10e-3, 12e-3])
    assert_explained(caught.value, 'sweep=[{"vary": "cell.pillar.height", "from": ...', "table [sweep]")


def test_what_is_no_number_is_changed_by_its_key():
    with pytest.raises(StudyError) as caught:
        STUDY.with_parameter("cell.lattice", "triangular")
    assert_explained(caught.value, "with_keys", "cell.lattice")
    changed = STUDY.with_keys({"cell.lattice": "hexagonal", "bands.count": 20, "material": "brass"})
    assert changed.cell.lattice == Lattice.triangular(7e-3)
    assert changed.bands_settings.count == 20
    assert changed.cell.material == material("brass")
    sweep = STUDY.with_keys({"sweep": [{"vary": "cell.pitch", "from": "7 mm", "to": "8 mm", "steps": 2}]})
    assert len(sweep.sweep_settings) == 1


STEEL = "steel"


def test_parts_are_replaced_by_texts_tables_and_values():
    cell = UnitCell(Lattice.square(8e-3), 1e-3, "brass")
    assert STUDY.replace(material="brass").cell.material.name == "brass"
    assert STUDY.replace(material=material("brass")).cell.pillar == STUDY.cell.pillar
    assert STUDY.replace(cell=cell, carrier="50 kHz") == Study(cell=cell, carrier=50e3)
    assert STUDY.replace(cell={"pitch": "8 mm", "thickness": "1 mm"}, material="brass").cell == cell
    assert STUDY.replace(bands={"count": 7}).bands_settings.count == 7
    assert STUDY.replace() == STUDY
    with pytest.raises(StudyError) as caught:
        STUDY.replace(materail="brass")
    assert_explained(caught.value, 'write "material"', code="unknown", argument="materail")


LARGE = st.floats(0.2, 500)
MAKERS = {
    "a study": lambda z: Study(cell=SIZES | {"pillar": {"diameter": 3e-3, "height": z}}, material=STEEL),
    "a pillar": lambda size: Pillar(3.5e-3, size),
    "a lattice": lambda size: Lattice.square(size),
    "a cell": lambda size: UnitCell(Lattice.square(7e-3), size, "steel"),
    "a changed study": lambda size: STUDY.with_parameter("cell.pillar.height", size),
    "several changes": lambda size: STUDY.with_parameters({"cell.pillar.height": size}),
    "changed keys": lambda size: STUDY.with_keys({"cell.pillar.height": f"{size} m"}),
    "another cell": lambda size: STUDY.replace(cell=SIZES | {"pillar": {"diameter": 3e-3, "height": size}}),
}  # fmt: skip


@pytest.mark.parametrize("maker", MAKERS)
@given(LARGE)
@settings(deadline=None, max_examples=8)
def test_a_size_in_another_unit_is_warned_about_in_python_as_in_a_file(maker, size):
    with pytest.warns(HaptonicWarning, match="is unusual") as caught:
        MAKERS[maker](size)
    assert len(caught) == 1
    assert caught[0].filename == __file__


def test_a_pitch_of_six_asks_for_millimetres_once_for_each_size():
    with pytest.warns(HaptonicWarning) as caught:
        Study(cell={"pitch": 6, "thickness": 1, "pillar": {"diameter": 3, "height": 12}}, material="brass")
    messages = [str(warning.message) for warning in caught]
    assert "cell.pitch: 6 m is unusual: 100 nm to 100 mm is typical. Did you mean 6 mm?" in messages
    assert len(messages) == 4


def test_a_file_is_warned_about_once_and_ready_values_are_not_warned_about_again():
    text = STUDY.to_toml().replace('"14.7 mm"', '"14.7 m"')
    with pytest.warns(HaptonicWarning) as caught:
        study = loads(text)
    assert len(caught) == 1
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        Study(cell=study.cell)
        study.with_parameter("cell.thickness", 1.4e-3)
        study.cell.scaled(0.5)
