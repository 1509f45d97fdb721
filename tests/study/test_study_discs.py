"""Studies whose cell has discs: read, written, refused, swept."""

import numpy as np
import pytest

from five_parts import refusing
from haptonic.cell import Disc
from haptonic.errors import GeometryError, HaptonicWarning, StudyError
from haptonic.materials import material
from haptonic.study import loads

STUDY = """
material = "aluminium-paper"
[cell]
pitch = "10 mm"
thickness = "2 mm"
[[cell.disc]]
diameter = "8 mm"
material = "epoxy"
[[cell.disc]]
diameter = "6 mm"
section = "hexagon"
high = "3 mm"
[cell.disc.material]
youngs_modulus = "200 GPa"
poisson_ratio = 0.3
density = "7850 kg/m^3"
"""
HOLE = STUDY.split("[[cell.disc]]")[0] + '[[cell.disc]]\ndiameter = "8 mm"\nempty = true\n'
SITES = """
material = "steel"
[cell]
lattice = "honeycomb"
pitch = "10 mm"
thickness = "1 mm"
[[cell.site]]
[[cell.site.disc]]
diameter = "4 mm"
empty = true
[[cell.site]]
[cell.site.pillar]
diameter = "3 mm"
height = "4 mm"
"""


@pytest.mark.parametrize("text", [STUDY, HOLE, SITES])
def test_what_is_written_is_read_again(text):
    study = loads(text)
    assert loads(study.to_toml()) == study


def test_discs_are_read_with_their_materials():
    wide, narrow = loads(STUDY).cell.disc
    assert wide == Disc(8e-3, material=material("epoxy"))
    assert narrow.material.youngs_modulus == 200e9
    assert narrow.high == 3e-3
    assert set(loads(STUDY).inputs()["cell"]["materials"]) == {"disc[1].material", "disc[2].material"}


def test_a_sweep_changes_a_number_of_a_disc():
    study = loads(
        HOLE + '[[sweep]]\nvary = "cell.disc[1].diameter / cell.pitch"\nfrom = 0.3\nto = 0.5\nsteps = 3\n'
    )
    designs = list(study.designs(study.sweep_settings[0]))
    assert [design.cell.disc[0].diameter for design in designs] == pytest.approx([3e-3, 4e-3, 5e-3])


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("material.density", 2800.0),
        ("cell.disc[1].material.youngs_modulus", 4e9),
        ("cell.site[1].disc[1].material.loss_factor", 0.01),
    ],
)
def test_constants_of_built_in_materials_are_numbers_of_a_study(path, value):
    """A design with another constant has a table of its own for it."""
    sited = SITES.replace("empty = true", 'material = "epoxy"')
    study = loads(sited if "site" in path else STUDY)
    design = study.with_parameter(path, value)
    assert loads(design.to_toml()).parameters() == {**study.parameters(), path: value}
    unit = study.units()[path]
    own = study.parameters()[path]
    sweep = {"vary": path, "from": f"{own} {unit}", "to": f"{value} {unit}", "steps": 3}
    swept = study.with_keys({"sweep": [sweep if unit else {**sweep, "from": own, "to": value}]})
    last = swept.designs(swept.sweep_settings[0])[-1]
    assert last.parameters()[path] == pytest.approx(value)


GLUED = """
material = "aluminium-paper"
[cell]
pitch = "8 mm"
thickness = "1 mm"
[[cell.disc]]
diameter = "5 mm"
low = "0 mm"
high = "50 um"
material = "epoxy"
[[cell.disc]]
diameter = "5 mm"
low = "50 um"
high = "7 mm"
material = "steel"
"""


@pytest.mark.parametrize("end", ["disc[1].high", "disc[2].low"])
def test_a_sweep_of_the_glue_moves_the_pillar_on_it(end):
    study = loads(GLUED + f'[[sweep]]\nvary = "cell.{end}"\nfrom = "20 um"\nto = "200 um"\nsteps = 2\n')
    for design, height in zip(study.designs(study.sweep_settings[0]), (20e-6, 200e-6), strict=True):
        glue, pillar = design.cell.disc
        assert (glue.high, pillar.low, pillar.high) == pytest.approx((height, height, 7e-3))


def test_the_plan_lists_materials_and_ends_at_the_face():
    sizes = next(table for table in loads(GLUED).plan().tables() if table.title.startswith("sizes"))
    values = {row[0]: row[1] for row in sizes.rows}
    assert (values["disc[1].low"], values["disc[1].material"]) == ("0 m", "epoxy")


def test_only_ends_that_meet_move_together_unless_both_are_given():
    study = loads(GLUED)
    glue, pillar = study.with_parameter("cell.disc[1].diameter", 4e-3).cell.disc
    assert (glue.diameter, pillar.diameter) == (4e-3, 5e-3)
    with pytest.warns(HaptonicWarning, match="no effect above 20 µm"):
        glue, pillar = study.with_parameters({"cell.disc[1].high": 1e-4, "cell.disc[2].low": 2e-5}).cell.disc
    assert (glue.high, pillar.low) == (1e-4, 2e-5)
    with pytest.warns(HaptonicWarning, match="no effect above 50 µm"):
        glue, pillar = study.with_keys({"cell.disc[1].high": "80 um"}).cell.disc
    assert (glue.high, pillar.low) == pytest.approx((8e-5, 5e-5))


SECOND = """
[[sweep]]
vary = "cell.disc[1].high"
from = "50 um"
to = "60 um"
steps = 2
[sweep.second]
vary = "cell.disc[2].low"
from = "30 um"
to = "40 um"
steps = 2
"""


def test_both_axes_of_a_sweep_begin_at_the_study():
    """On the way, the glue ends where the pillar begins in the study, which must not join them."""
    with pytest.warns(HaptonicWarning, match="no effect above 50 µm"):
        study = loads(GLUED.replace('high = "50 um"', 'high = "60 um"') + SECOND)
    reached = [(d.cell.disc[0].high, d.cell.disc[1].low) for d in study.designs(study.sweep_settings[0])]
    assert np.array(reached) == pytest.approx(np.array([(50, 30), (50, 40), (60, 30), (60, 40)]) * 1e-6)


def test_a_ratio_of_ends_that_meet_is_refused():
    sweep = '[[sweep]]\nvary = "cell.disc[1].high / cell.disc[2].low"\nfrom = 0.5\nto = 0.8\nsteps = 2\n'
    with refusing(StudyError, "conflict", "vary"):
        loads(GLUED + sweep)


@pytest.mark.parametrize("table", ["hole", "inclusion", "coating", "cap"])
def test_another_word_for_a_disc_is_answered_with_what_to_write(table):
    with refusing(StudyError, "unknown", f"cell.{table}") as refusal:
        loads(STUDY.split("[[cell.disc]]")[0] + f'[cell.{table}]\ndiameter = "3 mm"\n')
    assert "[[cell.disc]]" in refusal.value.next_step


def test_a_disc_of_a_site_is_named_by_its_path():
    with refusing(StudyError, "out-of-range", "cell.site[1].disc[1].diameter"):
        loads(SITES.replace('"4 mm"\nempty', '"9 mm"\nempty'))


HOLLOW = '{ diameter = "2 mm", low = "-1.5 mm", high = "-1 mm", empty = true },'
CAPPED = f"""
material = "steel"
cell = {{ pitch = "7 mm", thickness = "1.5 mm", disc = [
  {{ diameter = "2.5 mm", low = "0 mm", high = "3 mm" }},
  {{ diameter = "4.5 mm", low = "3 mm", high = "4 mm" }},
  {HOLLOW}
] }}
"""


@pytest.mark.parametrize("table", ["design.vary", "tolerance.of"])
def test_designs_and_tolerances_vary_discs_that_keep_their_order(table):
    def reading(number):
        more = 'from = "3.5 mm"\nto = "5 mm"' if table == "design.vary" else 'spread = "0.1 mm"'
        return loads(f'{CAPPED}[[{table}]]\nparameter = "{number}"\n{more}\n')

    for number in ("cell.disc[2].diameter", "cell.disc[1].high", "cell.disc[2].high", "cell.disc[3].high"):
        reading(number)
    fixed = {
        "cell.disc[2].low": "cell.disc[1].high",
        "cell.disc[1].low": "other end",
        "cell.disc[3].low": "other end",
        "cell.thickness": "leave cell.disc[3].low out",
    }
    for number, advice in fixed.items():
        with refusing(StudyError, "conflict", f"{table}[1].parameter") as refusal:
            reading(number)
        assert advice in refusal.value.next_step


def test_another_lattice_of_a_plate_changes_a_disc():
    plate = """
[plate]
map = "oxo"
tiles = { o = "lattice", x = "low" }
cell = [{ name = "low", change = { "cell.disc[2].diameter" = "4 mm" } }]
"""
    cells = loads(CAPPED.replace(HOLLOW, "") + plate).mounted_plate().layout.cells
    assert [cells[name].disc[1].diameter for name in ("lattice", "low")] == [4.5e-3, 4e-3]


@pytest.mark.parametrize(
    ("path", "value", "allowed", "joined"),
    [
        ("cell.disc[1].high", 8e-3, "above 0 m and below 7 mm", "cell.disc[2].low meets it"),
        ("cell.disc[2].low", -1e-3, "above 0 m and below 7 mm", "cell.disc[1].high meets it"),
        ("cell.disc[2].high", 20e-6, "above 50 µm", "a disc would have no thickness"),
        ("cell.disc[1].low", 60e-6, "below 50 µm", "a disc would have no thickness"),
    ],
)
def test_the_end_that_was_given_is_refused_with_its_range(path, value, allowed, joined):
    with refusing(StudyError, "out-of-range", path, joined) as caught:
        loads(GLUED).with_parameter(path, value)
    assert caught.value.allowed == allowed


def test_errors_of_discs_name_the_disc():
    study = loads(GLUED)
    below = ("cell.disc[1].low", -2e-3, "the plate's lower face")
    for path, value, words in (below, ("cell.disc[2].diameter", -1e-3, "negative")):
        with refusing(StudyError, "out-of-range", path, words):
            study.with_parameter(path, value)
    with refusing(GeometryError, "out-of-range", "cell.disc[2].low", "below the upper end, 7 mm"):
        study.cell.with_numbers({"cell.disc[2].low": 8e-3})
    with refusing(StudyError, "out-of-range", "cell.disc[1].material.poisson_ratio"):
        study.cell.with_numbers({"cell.disc[1].material.poisson_ratio": 0.7})


@pytest.mark.parametrize(
    ("path", "next_step"),
    [
        ("cell.disc[0].high", 'write "cell.disc[1].high"'),
        ("cell.disc[7].low", 'write "cell.disc[2].low"'),
        ("cell.disc[0].section", "choose a name of the list"),
    ],
)
def test_tables_count_from_one(path, next_step):
    study = loads(GLUED)
    with refusing(StudyError, "unknown", "name of a number", "count from 1") as caught:
        study.with_parameter(path, 1e-3)
    assert caught.value.next_step == next_step
    with refusing(StudyError, "unknown", path, "count from 1"):
        study.with_keys({path: "1 mm"})
