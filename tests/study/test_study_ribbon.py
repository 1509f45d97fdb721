"""[ribbon] in a study file: what it describes, and what is refused."""

import numpy as np
import pytest

from each import each
from five_parts import assert_explained
from haptonic.analyses import ribbon
from haptonic.analyses.options import NoOptions
from haptonic.errors import HaptonicError
from haptonic.study import loads

STUDY = """
carrier = "57 kHz"
material = "aluminium-2017a"
[cell]
lattice = "square"
pitch = "7 mm"
thickness = "1.5 mm"
[cell.pillar]
diameter = "3.5 mm"
height = "14.7 mm"
"""
RIBBON = """
[ribbon]
map = "ooo1111ooo"
rows = 20
[ribbon.tiles]
o = "lattice"
1 = "guide"
[ribbon.widths]
guide = "8 mm"
"""
DEFECT = """
[ribbon]
map = '''
ooo
o1o
'''
tiles = { o = "lattice", 1 = "short" }
[[ribbon.cell]]
name = "short"
change = { "cell.pillar.height" = "14 mm" }
"""
COMB = """
material = "aluminium-2017a"
[cell]
lattice = "honeycomb"
pitch = "12 mm"
thickness = "1.5 mm"
[[cell.site]]
pillar = { diameter = "5 mm", height = "3.3 mm" }
[[cell.site]]
pillar = { diameter = "5 mm", height = "2.7 mm" }
[ribbon]
map = "aaabbb"
tiles = { a = "lattice", b = "mirrored" }
[[ribbon.cell]]
name = "mirrored"
change = { "cell.site[1].pillar.height" = "2.7 mm", "cell.site[2].pillar.height" = "3.3 mm" }
"""


def ribbon_of(text):
    study = loads(text)
    return study.ribbon_settings.ribbon(study.cell)


def test_a_map_is_columns_of_cells_side_by_side():
    ribbon = ribbon_of(STUDY + RIBBON)
    assert [cell.pillar is None for cell in ribbon.first] == [letter == "1" for letter in "ooo1111ooo"]
    assert len({id(cell) for cell in ribbon.first}) == 2, "equal columns are one object"
    assert ribbon.first[4].lattice.a1 == (8e-3, 0.0)
    assert np.argwhere(ribbon.guide).tolist() == [[0, 3], [0, 4], [0, 5], [0, 6]]
    assert ribbon.period == pytest.approx(7e-3)
    assert ribbon.origins[-1] - ribbon.origins[0] == pytest.approx([6 * 7e-3 + 4 * 8e-3 - 7e-3, 0.0])


def test_pillars_of_sites_may_be_exchanged_beyond_an_edge():
    ribbon = ribbon_of(COMB)
    heights = [[pillar.height for pillar in cell.pillars] for cell in (ribbon.first[0], ribbon.first[-1])]
    assert heights[0] == heights[1][::-1] == [3.3e-3, 2.7e-3]
    assert np.flatnonzero(ribbon.guide).tolist() == [2, 3], "on either side of where they meet"
    assert ribbon.kind == "edge"


@pytest.mark.parametrize("line", ["o", "ooooo"])
def test_equal_letters_are_a_strip_with_free_edges(line):
    ribbon = ribbon_of(changed(("ooo1111ooo", line), ('1 = "guide"', ""), ('guide = "8 mm"', "")))
    assert ribbon.kind == "strip"
    assert len(ribbon.first) == len(line)
    assert ribbon.crystals == ribbon.first[:1]


def test_lines_of_different_pillars_are_a_strip_too():
    ribbon = ribbon_of(changed(("ooo\no1o", "ooo\n111"), text=STUDY + DEFECT))
    assert ribbon.kind == "strip"
    assert ribbon.period == pytest.approx(14e-3)


def test_several_lines_are_read_from_the_bottom_up():
    study = loads(STUDY + DEFECT)
    ribbon = study.ribbon_settings.ribbon(study.cell)
    assert ribbon.kind == "defect"
    assert np.argwhere(ribbon.guide).tolist() == [[0, 1]], "the last line of the map is the lowest"
    assert study.ribbon_settings.names == [["lattice", "short", "lattice"], ["lattice"] * 3]
    assert ribbon.period == pytest.approx(14e-3)
    assert study.ribbon_settings.wavevectors < loads(STUDY + RIBBON).ribbon_settings.wavevectors
    assert loads(study.to_toml()) == study


def test_a_study_with_a_ribbon_is_written_and_read_back():
    study = loads(STUDY + RIBBON)
    assert loads(study.to_toml()) == study
    assert "ribbon" in study.inputs()
    assert "ribbon" not in loads(STUDY).inputs()


def test_a_sweep_is_about_the_lattice_alone():
    """As it leaves the plate out, whose tiles some of the designs would not fit either."""
    further = '[[ribbon.cell]]\nname = "wide"\nchange = { "cell.pillar.diameter" = "6 mm" }\n'
    text = changed(('"ooo1111ooo"', '"ooo1111oow"'), ('1 = "guide"', '1 = "guide"\nw = "wide"')) + further
    sweep = '[[sweep]]\nvary = "cell.pitch"\nfrom = "5 mm"\nto = "7 mm"\nsteps = 3\n'
    study = loads(text + sweep)
    (designs,) = (study.designs(settings) for settings in study.sweep_settings)
    assert [design.ribbon_settings for design in designs] == [None] * 3


def test_a_pillar_stays_on_the_glue_that_a_further_lattice_makes_thicker():
    discs = """
[[cell.disc]]
diameter = "3 mm"
low = "0 mm"
high = "50 um"
material = "epoxy"
[[cell.disc]]
diameter = "3 mm"
low = "50 um"
high = "4 mm"
"""
    thick = changed(("cell.pillar.height", "cell.disc[1].high"), ("14 mm", "0.2 mm"), text=DEFECT)
    ribbon = ribbon_of(STUDY.partition("[cell.pillar]")[0] + discs + thick)
    glue, pillar = ribbon.first[1].disc
    assert (glue.high, pillar.low, pillar.high) == (0.2e-3, 0.2e-3, 4e-3)


def changed(*pairs, text=STUDY + RIBBON):
    for old, new in pairs:
        assert old in text
        text = text.replace(old, new)
    return text


@each(
    ("text", "code", "argument", "words"),
    [
        (changed(("ooo1111ooo", "ooo11x1ooo")), "unknown", "ribbon.map", "[ribbon.tiles] does not explain"),
        (changed(("ooo1111ooo", "ooo1..1ooo")), "malformed", "ribbon.map", "no holes"),
        (changed(('"ooo1111ooo"', '"""' + 12 * "ooo1111ooo\n" + 'o11"""')), "malformed", "ribbon.map", "13"),
        (changed(('"ooo1111ooo"', '"""' + 13 * "ooo1111ooo\n" + '"""')), "malformed",
         "ribbon.map", "13 x 10"),
        (changed(('"ooo1111ooo"', '"""\nooo\no1o\n"""')), "conflict", "ribbon.rows", "several lines"),
        (changed(('"ooo1111ooo"', '""')), "malformed", "ribbon.map", "the map is empty"),
        (changed(('guide = "8 mm"', 'lattice = "8 mm"')), "unknown",
         "ribbon.widths.lattice", "its own pitch"),
        (changed(('guide = "8 mm"', 'giude = "8 mm"')), "unknown", "ribbon.widths.giude", 'write "guide"'),
        (changed(("rows = 20", "rows = 20\nalong = [0, 1.5]")), "malformed", "ribbon.along", "whole"),
        (changed(("rows = 20", "rows = 20\nalong = [0, 2]"), ('guide = "8 mm"', "")), "out-of-range",
         "ribbon.along", "without a common divisor"),
        (changed(("rows = 20", "rows = 20\nalong = [1, 1]")), "unsupported",
         "ribbon.widths.guide", "tiles that are rectangles"),
        (changed(("rows = 20", 'lowest = "60 kHz"\nhighest = "50 kHz"')), "conflict",
         "ribbon.highest", "60 kHz"),
        (changed(('"ooo1111ooo"', '"ooo1111oof"'), ('1 = "guide"', '1 = "guide"\nf = "low"'))
         + '[[ribbon.cell]]\nname = "low"\nchange = { "cell.pitch" = "6 mm" }\n', "mismatch",
         "ribbon.map", "column 10"),
        (changed(('"ooo1111ooo"', '"ooo1111oof"'), ('1 = "guide"', '1 = "guide"\nf = "low"'))
         + '[[ribbon.cell]]\nname = "low"\nchange = { "cell.site[2].pillar.height" = "6 mm" }\n', "unknown",
         "change", "this study does not give it"),
        (changed(("rows = 20", "rows = 20"))
         + '[[ribbon.cell]]\nname = "low"\nchange = { "cell.pillar.height" = "6 mm" }\n', "unknown",
         "ribbon.cell[1].name", "no column is of this lattice"),
        (changed(("[cell.pillar]\n", ""), ('diameter = "3.5 mm"\n', ""), ('height = "14.7 mm"\n', "")),
         "conflict", "ribbon.tiles.o", "plain plate"),
        (changed(("12 mm", "12 mm"), ('"cell.site[1].pillar.height" = "2.7 mm"', '"cell.pitch" = "13 mm"'),
                 text=COMB), "mismatch", "ribbon.map", "column 4"),
    ],
)  # fmt: skip
def test_what_is_no_ribbon_is_refused_in_five_parts(text, code, argument, words):
    with pytest.raises(HaptonicError) as caught:
        loads(text)
    assert_explained(caught.value, words, code=code, argument=argument)


@each("line", ["ooo1111xoo", "ooo1 11ooo", '""\nooo\no1\n""'])
def test_errors_of_a_map_propose_no_absent_tile(line):
    with pytest.raises(HaptonicError) as caught:
        loads(changed(("ooo1111ooo", line)))
    assert '"."' not in str(caught.value)


def test_the_error_for_a_missing_ribbon_names_the_table():
    with pytest.raises(HaptonicError) as caught:
        ribbon.check(loads(STUDY), NoOptions())
    assert_explained(caught.value, "[ribbon.tiles]", code="missing", argument="ribbon")
