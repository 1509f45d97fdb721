"""Folders of records as other laboratories write them: known friction or a reason, never a wrong one."""

from collections import Counter
from pathlib import Path

import pytest
from drawn_folders import KINDS, drawn_at, outcome
from hypothesis import HealthCheck, given, settings, strategies as st

GOOD = ("right", "left out", "noted", "refused")
DRAWS = st.fixed_dictionaries({name: st.sampled_from(some) for name, some in KINDS.items()})
PLAIN = {name: some[0] for name, some in KINDS.items()}
SINGLE = [(name, value) for name, some in KINDS.items() if name != "seed" for value in dict.fromkeys(some)]


@pytest.mark.parametrize(
    ("name", "value"),
    [entry for entry in SINGLE if entry[0] in ("clock", "direction", "sign", "spoil", "step")],
)
def test_one_thing_unlike_the_plain_case(tmp_path, name, value):
    result = outcome(tmp_path / "a", {**PLAIN, name: value})
    assert result in GOOD, result


@pytest.mark.parametrize(
    "unlike",
    [
        {"drift": -0.1, "rest_after": 0.0},
        {"drift": 0.05, "rest_after": 0.0, "step": 5e-3},
        {"unit": "lbf", "other_unit": True},
        {"clock": "scatter and rate", "spoil": "gap"},
        {"spoil": "clipped", "step": 5e-3, "noise": "quiet", "sign": "one up"},
        {"spoil": "clipped", "clip": "along", "direction": "other", "bias": -2.0},
    ],
    ids=str,
)
def test_some_things_unlike_the_plain_case(tmp_path, unlike):
    result = outcome(tmp_path / "a", {**PLAIN, **unlike})
    assert result in GOOD, result


@pytest.mark.parametrize(
    "friction_names", [{}, {"names": "Kraft_z"}, {"names": "none", "answered": True}], ids=str
)
def test_exchanged_forces_are_refused_or_noted_where_the_study_names_both(tmp_path, friction_names):
    result = outcome(tmp_path / "a", {**PLAIN, **friction_names, "exchanged": True})
    assert result == ("noted" if "answered" in friction_names else "refused")


def test_the_plain_case_is_read(tmp_path):
    assert outcome(tmp_path / "a", PLAIN) == "right"


@settings(max_examples=5, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(DRAWS)
def test_drawn_folders(tmp_path, draw):
    result = outcome(tmp_path / "a", draw)
    assert result in GOOD, result


@pytest.mark.parametrize(
    "number",
    [32, 884, 1345, 1586, 1723, 3301, 3405],
    ids=[
        "coarse steps at rest",
        "coarse steps in the end",
        "rare clear comma",
        "few steps",
        "few steps, others more",
        "equal samples",
        "scatter like a drift",
    ],
)
def test_rare_folders(tmp_path, number):
    result = outcome(tmp_path / "a", drawn_at(number))
    assert result in GOOD, result


@pytest.mark.nightly
def test_a_thousand_drawn_folders(tmp_path):
    counts, faults = Counter[str](), []
    for number in range(1000):
        result = outcome(Path(tmp_path) / "a", drawn_at(number))
        counts[result.partition(":")[0]] += 1
        if result not in GOOD:
            faults.append((number, result))
    assert not faults, (counts, faults[:5])
    assert sum(counts.values()) == 1000
