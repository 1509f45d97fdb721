"""The numbers of the publication are in one file; each is compared with ours, or a reason is given."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from hypothesis import given, settings, strategies as st

from five_parts import refusing
from haptonic.errors import StudyError
from haptonic.report.against import compared
from haptonic.report.derived import derived, inputs_of
from haptonic.results.references import References, Value
from haptonic.study import load

STUDIES = Path(__file__).parents[2] / "studies"
PAPER = References.read(STUDIES / "references" / "touchpad.toml")
STUDY = load(STUDIES / "touchpad.toml")
# quantities that the publication gives, by their numbers
NUMBERS = (
    "7 1.5 3.5 14.7 0.5 2.1 70 0.33 2700 3.516 22.03 61.70 52.9 61.4 8.5 30 225 100 51 3040 20 3 1 127 140 "
    "180 32 8 58.8 11.5 0.7 60 200 2 16 50 21 78 13 0.8 0.4 55 11 80 -0.25 -0.21 -0.06 -0.02 0.01"
)


def test_every_number_of_the_publication_is_a_row():
    there = {number for value in PAPER.value for number in re.findall(r"-?\d+\.?\d*", value.value)}
    assert [value for value in NUMBERS.split() if value not in there] == []
    assert PAPER.friction == pytest.approx({"driven": 0.55, "idle": 0.11, "stopped": 0.80})
    for pair in ("M7 and M8", "M3, M4, M5 and M6"):
        assert pair in {value.value for value in PAPER.value}


def test_every_input_is_a_key_of_the_study_and_derived_numbers_are_found():
    inputs, known = inputs_of(STUDY), derived(STUDY, {})
    rows = compared(PAPER, {"study": inputs, "derived": known})
    for value, row in zip(PAPER.value, rows, strict=True):
        if value.analysis == "study":
            assert row.agrees is not None, row
        if value.analysis == "derived" and not value.path.startswith(("edges", "optimum", "power")):
            assert row.value is not None, row
        assert row.ours
        assert row.role in ("computed", "input", "experiment")
    by_name = {row.quantity: row for row in rows}
    assert by_name["Period for Bragg scattering, c / f"].value == pytest.approx(3122 / 60e3, rel=1e-3)
    assert by_name["Factor 2 of the clamped pillar's frequency, equation (3)"].agrees is True
    assert by_name["Sample rate"].agrees is False
    json.dumps([row.__dict__ for row in rows])


@given(st.floats(1.0, 900.0), st.floats(-0.02, 0.02), st.floats(0.0, 0.02))
@settings(deadline=None, max_examples=60)
def test_a_value_agrees_within_the_error_and_the_rounding_and_not_beyond(theirs, off, share):
    published = f"{theirs:.1f} kHz"
    number = float(published.split()[0])
    value = Value(quantity="f", value=published, unit="Hz", analysis="a", path="f", error="e", remark="why")
    ours, error = 1e3 * number * (1 + off), 1e3 * number * share
    (row,) = compared(References(value=(value,)), {"a": {"f": ours, "e": error}})
    away, room = abs(ours - 1e3 * number), error + 50.0
    if abs(away - room) > 1e-6 * room:
        assert row.agrees == (away <= room)
    assert row.value == ours


def test_words_that_mean_the_same_agree_and_others_differ():
    value = Value(
        quantity="M1 and M2", value="paired", analysis="a", path="m.0", to="m.1", means=("bending",)
    )
    words = {"same": ["bending", "bending"], "other": ["bending", "torsion"]}
    same, other = (compared(References(value=(value,)), {"a": {"m": means}})[0] for means in words.values())
    assert (same.difference, same.agrees) == ("none", True)
    assert (other.difference, other.agrees) == ("differs", False)


@pytest.mark.parametrize(
    ("relation", "ours", "agrees"),
    [
        ("at least", 101.0, True),
        ("at least", 99.0, False),
        ("at most", 99.0, True),
        ("at most", 101.0, False),
    ],
)
def test_a_bound_is_met_or_not(relation, ours, agrees):
    value = Value(quantity="Q", value="100", unit="1", analysis="a", path="q", relation=relation)
    (row,) = compared(References(value=(value,)), {"a": {"q": ours}})
    assert row.agrees is agrees
    assert row.published == f"{relation} 100"


def test_a_reference_value_needs_a_path_or_a_remark(tmp_path):
    path = tmp_path / "references.toml"
    path.write_text('[[value]]\nquantity = "Asperities"\nvalue = "1 um"\nrole = "experiment"\n')
    with refusing(StudyError, "malformed", "value.0", "remark"):
        References.read(path)
    path.write_text('[[value]]\nquantity = "Gap"\nvalue = "1 kHz"\nunit = "Hz"\n')
    with refusing(StudyError, "malformed", "value.0", "path"):
        References.read(path)
