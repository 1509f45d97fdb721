"""Words that other programs use for our keys are known: what to write, or why there is no such key."""

from __future__ import annotations

import pytest
from hypothesis import given, settings, strategies as st

from five_parts import refused_study as refused, refusing
from haptonic.cell import Disc, Pillar
from haptonic.errors import StudyError
from haptonic.fields import table
from haptonic.fields.aliases import aliases
from haptonic.fields.keys import key_of
from haptonic.lattice import Lattice
from haptonic.study import Study, loads
from haptonic.study.schema import Description

WORDS = aliases(Description)
KEYS = table(Description)
CELL = {"pitch": 7e-3, "thickness": 1.5e-3, "pillar": {"diameter": 3.5e-3, "height": 14.7e-3}}


def nested(path: str, value: object) -> dict[str, object]:
    """A study in Python with a value at a path, and with what else it needs."""
    data: dict[str, object] = {"cell": {**CELL, "pillar": dict(CELL["pillar"])}, "material": "steel"}
    steps = path.split(".")
    inside = data
    for step in steps[:-1]:
        name, several = step.removesuffix("[]"), step.endswith("[]")
        below = inside.get(name)
        below = below if isinstance(below, dict) else {}
        inside[name] = [below] if several else below
        inside = below
    inside[steps[-1]] = value
    return data


@given(st.sampled_from(sorted(WORDS)), st.sampled_from([1, "x", 0.3]), st.booleans())
@settings(deadline=None, max_examples=60)
def test_a_word_of_other_programs_is_answered_with_what_to_write(path, value, capital):
    section, dot, name = path.rpartition(".")
    asked = f"{section}{dot}{name.upper() if capital and name.islower() else name}"
    with pytest.raises(StudyError) as caught:
        Study(**nested(asked, value))
    message, word = str(caught.value), WORDS[path]
    assert word.cause in message
    assert word.next_step.split("\n")[0] in message
    assert "no key has this name" not in message


def test_no_other_word_hides_a_key_and_every_meant_key_is_there():
    for path, word in WORDS.items():
        assert path not in KEYS, path
        section, dot, _ = path.rpartition(".")
        assert not word.key or key_of(f"{section}{dot}{word.key}", KEYS), (path, word.key)
        assert word.cause
        assert word.next_step


def test_a_radius_is_answered_once_and_the_missing_diameter_is_not_another_problem():
    with refusing(StudyError, "unknown", "cell.pillar.radius", "twice") as caught:
        Study(cell={**CELL, "pillar": {"radius": 1.7e-3, "height": 14.7e-3}}, material="steel")
    assert "other problem" not in str(caught.value)


@pytest.mark.parametrize("feature", [Pillar(1e-3, 2e-3, section="circle"), Disc(1e-3, section="circular")])
def test_a_circle_is_a_round_section(feature):
    assert feature.section == "round"


@pytest.mark.parametrize("word", ["hexagonal", "triangular"])
def test_a_triangular_lattice_has_two_names(word):
    study = loads(f'material = "steel"\n[cell]\nlattice = "{word}"\npitch = "7 mm"\nthickness = "1 mm"\n')
    assert study.cell.lattice == Lattice.hexagonal(7e-3) == Lattice.triangular(7e-3)
    assert loads(study.to_toml()) == study


@given(st.text(alphabet="abcdefgh", min_size=1, max_size=9))
@settings(deadline=None, max_examples=20)
def test_a_wrong_word_of_a_choice_lists_the_words_also_behind_another_problem(word):
    text = f'material = "steel"\n[cell]\nlattice = "{word}"\npitch = "7 mm"\nthickness = "1 mm"\nzzz = 1\n'
    refused(text, '"honeycomb" or "kagome" or "lieb"')


def test_a_misspelt_lattice_is_answered_with_its_usual_name_and_one_list_of_words():
    text = 'material = "steel"\n[cell]\nlattice = "hexagon"\npitch = "7 mm"\nthickness = "1 mm"\n'
    with refusing(StudyError, "unknown", "cell.lattice", 'write "hexagonal"') as caught:
        loads(text)
    assert str(caught.value).count("honeycomb") == 1


@pytest.mark.parametrize("given", [{"pillar": {"diameter": 3e-3}}, {"disc": [{"diameter": 3e-3}]}])
def test_a_table_of_the_cell_at_the_top_is_moved_into_the_cell(given):
    with refusing(StudyError, "unknown", next(iter(given)), "move it to [cell]"):
        Study(**given, cell=CELL, material="steel")
