"""Paths into answers: they reach what is called anything."""

from __future__ import annotations

import pytest
from hypothesis import assume, given, strategies as st

from five_parts import refusing
from haptonic.analyses.reproduce import changed
from haptonic.cell import Pillar, UnitCell
from haptonic.errors import StudyError
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.results.references import found_at
from haptonic.study import Study
from hostile import names


@given(st.lists(names, min_size=2, max_size=2, unique=True), names)
def test_a_path_reaches_whatever_it_is_called(two, mode):
    first, second = two
    # otherwise the longer one is meant
    assume(not first.startswith(f"{second}.") and not second.startswith(f"{first}."))
    answer = {"guides": {name: {mode: number} for number, name in enumerate(two)},
              "pairs": [{"pair": name, "contrast": number} for number, name in enumerate(two)]}  # fmt: skip
    for number, name in enumerate(two):
        assert found_at(answer, f"guides.{name}.{mode}") == number
        assert found_at(answer, f"pairs.pair={name}.contrast") == number


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("gaps.complete=True.lower", 2.0),  # the first of two
        ("gaps.1.lower", 2.0),
        ("gaps.complete=True", {"complete": True, "lower": 2.0}),
        ("gaps.complete=Tru.lower", None),
        ("gaps.3.lower", None),
        ("gaps.0.lower.of", None),
        ("modes.WG 1.5", 7),
        ("modes.WG 1", {"6": 1}),
        ("modes.WG 1.6", 1),
        ("modes.WG", None),
        ("nothing", None),
    ],
)
def test_a_path_takes_the_first_and_the_longest(path, value):
    gaps = [{"complete": False, "lower": 1.0}] + [{"complete": True, "lower": low} for low in (2.0, 3.0)]
    assert found_at({"gaps": gaps, "modes": {"WG 1": {"6": 1}, "WG 1.5": 7}}, path) == value


def test_a_variant_changes_what_its_file_gives_by_keys():
    site = tuple({"at": (at, at), "pillar": Pillar(2e-3, high)} for at, high in ((0.0, 5e-3), (0.5, 6e-3)))
    lattice = Lattice.rectangular(7e-3, 6e-3)
    study = Study(cell=UnitCell(lattice, 1.5e-3, material("aluminium-paper"), site=site))
    variant = changed(study, {"cell.site[2].pillar.height": "7 mm", "material": "steel"}, "variant")
    assert [pillar.height for pillar in variant.cell.pillars] == [5e-3, 7e-3]
    assert variant.cell.material == material("steel")
    assert changed(study, {}, "variant").cell == study.cell
    with refusing(StudyError, "unknown", "cell.thicknes"):
        changed(study, {"cell.thicknes": "1 mm"}, "variant")
    with refusing(StudyError, "malformed", "cell.thickness"):
        changed(study, {"cell.thickness": "1 kHz"}, "variant")
    with refusing(StudyError, "unknown", "cell.site[3].pillar.height"):
        changed(study, {"cell.site[3].pillar.height": "7 mm"}, "variant")
