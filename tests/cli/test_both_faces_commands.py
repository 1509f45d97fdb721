"""Every command for a cell with pillars on both faces: answered, or refused in five parts."""

from __future__ import annotations

import pytest

from daily import daily
from five_parts import assert_five_parts
from haptonic.analyses import NAMES, named, tolerance
from haptonic.analyses.costs import gaps
from haptonic.analyses.options import NoOptions
from haptonic.study import loads
from quick import QUICK_CELL

pytestmark = pytest.mark.usefixtures("empty_pictures")

STUDY = (
    QUICK_CELL.replace("60 kHz", "110 kHz")
    .replace("14.7 mm", "4 mm")
    .replace("count = 8", "count = 10")
    .replace("order = 2", "order = 3")
    + """
[layers]
points = 3
count = 2

[[sweep]]
vary = "cell.pillar.diameter"
from = "3.4 mm"
to = "3.5 mm"
steps = 2

[ribbon]
map = "oo11oo"
points = 2

[ribbon.tiles]
o = "lattice"
1 = "guide"

[[design.vary]]
parameter = "cell.pillar.height"
from = "3.5 mm"
to = "4.5 mm"

[tolerance]
margin = "0.1 kHz"
pillars = 4

[[tolerance.of]]
parameter = "cell.pillar.height"
spread = "10 um"
"""
).replace('thickness = "1.5 mm"', 'thickness = "1.5 mm"\nfaces = "both"')
REFUSED = {  # code and argument
    "waveguide": ("no-answer", "waveguide.mode"),  # a wave so short is diffracted by the rows
    **dict.fromkeys(("plate", "feel", "simulate scan"), ("missing", "plate")),
    "verdict": ("conflict", "response"),  # a study in place of what a scan has given
}
LONG = {
    "design",
    "tolerance",
    "export",
    "reproduce",
    "simulate friction",
}  # asked what they cost, which looks through the study
# "bands" is in the test of its table
ASKED = [name for name in NAMES if named(name).study == "needed" and name != "bands"]
DEAR = {"ribbon", "layers", "sweep"}  # seconds each
PLATE = """
[plate]
map = "o11o"

[plate.tiles]
o = "lattice"
1 = "WG"
"""


@pytest.fixture
def both(tmp_path):
    path = tmp_path / "both.toml"
    path.write_text(STUDY, encoding="utf-8")
    return path


@pytest.mark.parametrize("name", daily(ASKED, *(name for name in ASKED if name not in DEAR)))
def test_every_command_answers_or_gives_a_reason(name, both, inside, tmp_path):
    given = [both, both] if name == "verdict" else [both]
    how = ["--dry-run"] if name in LONG else ["--out", tmp_path / "out"]
    ran = inside(*name.split(), *given, *how)
    if name in REFUSED:
        code, argument = REFUSED[name]
        assert_five_parts(ran, code=code, argument=argument)
    else:
        assert ran.code == 0, ran.err


def test_solids_are_written_with_both_faces(both, inside, tmp_path):
    ran = inside("export", both, "--stl", "--out", tmp_path / "out")
    assert ran.code == 0, ran.err
    assert "2 pillars" in ran.out
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["both.stl"]


def test_the_table_names_the_waves_of_a_gap(both, inside, tmp_path):
    ran = inside("bands", both, "--out", tmp_path / "out")
    assert ran.code == 0, ran.err
    assert "Gap of antisymmetric waves alone" in ran.out
    assert "these waves only" in ran.out
    gap = next(gap for gap in inside("bands", both, "--json").json["gaps"] if gap["waves"] != "all")
    assert not gap["complete"]


def test_a_finite_plate_of_such_a_cell_is_refused(both, inside):
    both.write_text(STUDY + PLATE, encoding="utf-8")
    assert_five_parts(inside("bands", both), code="unsupported", argument="cell.faces")


def test_the_forecast_of_tolerances_counts_both_faces_and_the_lattice():
    """A design beside the study's own took 1.7 times as long, on an oblique lattice 9.3 times.

    Forecasts are classes of time, and the search of gaps in a larger zone is not among their terms.
    """
    one_face = loads(STUDY.replace('faces = "both"', 'faces = "one"'))
    oblique = 'lattice = "oblique"\npitch_2 = "8 mm"\nangle = "75 deg"'
    studies = (loads(STUDY), loads(STUDY.replace('faces = "both"', oblique)), one_face)
    spent = [tolerance.cost(study, NoOptions()).seconds - gaps(study).seconds for study in studies]
    assert spent[0] / spent[2] == pytest.approx(1.7, rel=0.25)
    assert spent[1] / spent[2] == pytest.approx(9.3, rel=0.4)
