"""Folders of records as other laboratories write them: known friction or a reason, never a wrong one."""

from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from drawn_folders import KINDS, drawn_at, outcome
from hypothesis import HealthCheck, given, settings, strategies as st

GOOD = ("right", "left out", "refused")
DRAWS = st.fixed_dictionaries({name: st.sampled_from(some) for name, some in KINDS.items()})
PLAIN = {name: some[0] for name, some in KINDS.items()}
SINGLE = [(name, value) for name, some in KINDS.items() if name != "seed" for value in dict.fromkeys(some)]


@pytest.mark.parametrize(
    ("name", "value"), [one for one in SINGLE if one[0] in ("clock", "direction", "sign", "spoil", "step")]
)
def test_one_thing_unlike_the_plain_case(tmp_path, name, value):
    found = outcome(tmp_path / "a", {**PLAIN, name: value})
    assert found in GOOD, found


def test_the_plain_case_is_read(tmp_path):
    assert outcome(tmp_path / "a", PLAIN) == "right"


@settings(max_examples=12, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(DRAWS)
def test_drawn_folders(tmp_path, draw):
    found = outcome(tmp_path / "a", draw)
    assert found in GOOD, found


@pytest.mark.nightly
def test_thousands_of_drawn_folders(tmp_path):
    counts, faults = Counter[str](), []
    for number in range(5000):
        found = outcome(Path(tmp_path) / "a", drawn_at(number))
        counts[found.partition(":")[0]] += 1
        if found not in GOOD:
            faults.append((number, found))
    assert not faults, (counts, faults[:5])
    assert np.isclose(sum(counts.values()), 5000)
