"""Sites in a study file: what they describe, and what is refused."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from each import each
from five_parts import assert_explained, refused
from haptonic.analyses import design, export, waveguide
from haptonic.cell import Pillar, Site, Step, UnitCell
from haptonic.design.parameters import values_of
from haptonic.errors import GeometryError, HaptonicError
from haptonic.fields import table
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.study import Study, loads

STUDY = """
title = "Sites"
carrier = "60 kHz"
material = "aluminium-2017a"
[cell]
lattice = "honeycomb"
pitch = "7 mm"
thickness = "1.5 mm"
"""
UNEQUAL = """
[[cell.site]]
pillar = { diameter = "1.5 mm", height = "5 mm" }
[[cell.site]]
[cell.site.pillar]
diameter = "2 mm"
height = "6 mm"
fillet = "0.2 mm"
"""
EQUAL = """
[cell.pillar]
diameter = "1.5 mm"
height = "5 mm"
"""
FREE = """
[[cell.site]]
at = [0, 0]
pillar = { diameter = "1.5 mm", height = "5 mm" }
[[cell.site]]
at = ["1/3", 0.4]
[[cell.site]]
position = ["5 mm", "5.5 mm"]
pillar = { diameter = "1 mm", height = "4 mm" }
"""
SQUARE = STUDY.replace("honeycomb", "square")
ALUMINIUM = material("aluminium-2017a")
MM = 1e-3
KEYS = table(Study)


def test_a_site_has_all_keys_of_a_pillar():
    whole = (
        SQUARE
        + """
[[cell.site]]
at = [0.25, "1/4"]
[cell.site.pillar]
diameter = "3 mm"
height = "9 mm"
section = "round"
draft = "1 deg"
fillet = "0.2 mm"
[cell.site.pillar.step]
diameter = "1.5 mm"
height = "5 mm"
"""
    )
    (site,) = loads(whole).cell.site
    assert site.at == (0.25, 0.25)
    assert site.pillar == Pillar("3 mm", "9 mm", "round", np.radians(1), "0.2 mm", Step("1.5 mm", "5 mm"))
    known = {path.removeprefix("cell.site[].") for path in KEYS if path.startswith("cell.site[].pillar.")}
    assert known == {path.removeprefix("cell.") for path in KEYS if path.startswith("cell.pillar.")}


@pytest.mark.parametrize("text", [STUDY + UNEQUAL, STUDY + EQUAL, SQUARE + FREE, STUDY])
def test_a_study_with_sites_reads_back_from_what_it_writes(text):
    study = loads(text)
    assert loads(study.to_toml()) == study


def test_sites_come_from_the_lattice_or_from_the_table():
    cell = loads(STUDY + UNEQUAL).cell
    assert cell.shares == pytest.approx(np.array([[1, 1], [2, 2]]) / 3)
    assert [pillar.diameter for pillar in cell.pillars] == [1.5 * MM, 2 * MM]
    cell = loads(STUDY + EQUAL).cell
    assert cell.pillars[0] == cell.pillars[1] == cell.pillar
    cell = loads(SQUARE + FREE).cell
    assert cell.shares == pytest.approx(np.array([[0, 0], [1 / 3, 0.4], [5 / 7, 5.5 / 7]]))
    assert cell.pillars[1] is None
    assert not loads(STUDY).cell.has_features


def test_from_python_the_same():
    thin, wide = Pillar("1.5 mm", "5 mm"), Pillar("2 mm", "6 mm", fillet="0.2 mm")
    cell = UnitCell(
        Lattice(lattice="honeycomb", pitch="7 mm"),
        "1.5 mm",
        "aluminium-2017a",
        site=(Site(pillar=thin), Site(pillar=wide)),
    )
    assert cell == loads(STUDY + UNEQUAL).cell
    assert cell.scaled(2.0).scaled(0.5) == cell


SWEEP = '\n[[sweep]]\nvary = "cell.site[2].pillar.height"\nfrom = "6 mm"\nto = "7 mm"\nsteps = 3\n'
SPREAD = '\n[[tolerance.of]]\nparameter = "cell.site[1].pillar.diameter"\nspread = "20 um"\nper = "pillar"\n'


def test_numbers_of_sites_are_swept_and_have_tolerances():
    study = loads(STUDY + UNEQUAL + SWEEP + SPREAD)
    heights = [variant.cell.pillars[1].height for variant in study.designs(study.sweep_settings[0])]
    assert heights == pytest.approx([6 * MM, 6.5 * MM, 7 * MM])
    assert study.tolerance_settings.of[0].unit == "m"
    assert "cell.site[2].pillar.fillet" in values_of(study.cell)
    assert "cell.site[1].pillar.fillet" not in values_of(study.cell), "a sharp edge stays one"
    assert not [path for path in values_of(study.cell) if ".at" in path or ".position" in path]


@pytest.mark.parametrize(
    ("name", "guess"),
    [("hoenycomb", "honeycomb"), ("kagomé", "kagome"), ("Lieb", "lieb"), ("graphene", "")],
)
def test_a_lattice_misspelt_is_refused(name, guess):
    with pytest.raises(HaptonicError) as caught:
        loads(STUDY.replace("honeycomb", name) + EQUAL)
    assert caught.value.argument.endswith("cell.lattice")
    assert_explained(caught.value, name, guess, code="unknown", argument="study: cell.lattice")


FILLETED = '\n[[design.vary]]\nparameter = "cell.site[2].pillar.fillet"\nfrom = 0\nto = "0.3 mm"\n'
REFUSED = {
    "too few": (STUDY + UNEQUAL.split("[[cell.site]]\n[")[0], "cell.site", "conflict"),
    "a place of a named one": (
        STUDY + UNEQUAL.replace("[cell.site.pillar]", "at = [0, 0]\n[cell.site.pillar]"),
        "cell.site[2].at",
        "conflict",
    ),
    "no place": (SQUARE + UNEQUAL, "cell.site[1].at", "missing"),
    "a place of one site alone": (
        SQUARE + FREE.replace('at = ["1/3", 0.4]', ""), "cell.site[2].at", "missing"
    ),
    "two places": (SQUARE + FREE.replace("0.4]", '0.4]\nposition = ["1 mm", "1 mm"]'), "at", "conflict"),
    "outside": (SQUARE + FREE.replace("0.4", "1.4"), "cell.site[2].at[2]", "out-of-range"),
    "overlapping": (
        SQUARE + FREE.split("[[cell.site]]\nposition")[0].replace('"1/3", 0.4', "0.15, 0"),
        "cell.site[1].pillar.diameter",
        "out-of-range",
    ),
    "beyond the edge": (
        SQUARE + FREE.replace('"5.5 mm"', '"7.5 mm"'), "cell.site[3].position", "out-of-range"
    ),
    "no number": (SQUARE + FREE.replace('"1/3"', '"1/0"'), "cell.site[2].at[1]", "out-of-range"),
    "one place twice": (SQUARE + FREE.replace('"1/3", 0.4', "0, 0"), "cell.site[2].at", "repeated"),
    "too wide": (STUDY + EQUAL.replace("1.5 mm", "4 mm"), "cell.pillar.diameter", "out-of-range"),
    "one too wide": (
        STUDY + UNEQUAL.replace("2 mm", "4 mm", 1),
        "cell.site[2].pillar.diameter",
        "out-of-range",
    ),
    "a fillet too wide": (
        STUDY + UNEQUAL.replace("0.2 mm", "1 mm"), "cell.site[2].pillar.diameter", "out-of-range"
    ),
    "a length of a square pillar": (
        STUDY + EQUAL.replace("height", 'section = "square"\nlength = "1 mm"\nheight'),
        "cell.pillar.length",
        "conflict",
    ),
    "a short side": (
        SQUARE.replace('"square"', '"rectangular"\npitch_y = "7.001 mm"')
        + FREE.split("[[cell.site]]\nposition")[0].replace('"1/3", 0.4', "0.5, 0.5"),
        "cell.site[1].at",
        "out-of-range",
    ),
    "two pillars": (STUDY + UNEQUAL + EQUAL, "cell.pillar", "conflict"),
    "unknown key": (STUDY + UNEQUAL.replace("[cell.site.p", "where = 1\n[cell.site.p"), "where", "unknown"),
    "a fillet to nothing": (
        STUDY + UNEQUAL + FILLETED, "design.vary[1].from", "out-of-range"
    ),
    "no such site": (STUDY + UNEQUAL + SWEEP.replace("[2]", "[3]"), "sweep[1].vary", "unknown"),
}  # fmt: skip


@each(("text", "key", "code"), REFUSED.values())
def test_sites_that_do_not_fit_are_refused(text, key, code):
    refused(lambda: loads(text), code=code, argument=key)


@given(
    st.lists(st.tuples(*2 * [st.floats(-0.5, 1.5)], st.floats(0.1, 9.0)), min_size=1, max_size=5),
    st.sampled_from(["square", "triangular"]),
)
@settings(max_examples=60, deadline=None)
def test_any_sites_make_a_cell_or_are_refused_in_five_parts(places, lattice):
    """Overlapping ones, ones outside the cell, pillars beyond their tiles; whatever is made has room."""
    site = [{"at": (x, y), "pillar": Pillar(width * MM, 5 * MM)} for x, y, width in places]
    try:
        cell = UnitCell(Lattice(lattice=lattice, pitch=7 * MM), 1.5 * MM, ALUMINIUM, site=tuple(site))
    except GeometryError as error:
        refusal = error
    else:
        refusal = None
    if refusal is not None:
        assert refusal.argument.startswith("cell.site")
        assert_explained(refusal)
        return
    assert all(0 <= value < 1 for x, y, _ in places for value in (x, y))
    positions = cell.shares @ cell.lattice.vectors
    steps = [np.array([n, m]) @ cell.lattice.vectors for n in (-1, 0, 1) for m in (-1, 0, 1)]
    for i, pillar in enumerate(cell.pillars):
        for j, other in enumerate(cell.pillars):
            for step in steps:
                apart = np.linalg.norm(positions[i] - positions[j] + step)
                assert apart == 0 or apart > pillar.radius + other.radius


MANY = '\n[[design.vary]]\nparameter = "cell.pitch"\nfrom = "6 mm"\nto = "8 mm"\n'
# three pillars without any symmetry need 5 GB on the usual mesh, which other tests may have taken
COARSE = "[mesh]\norder = 2\nfoot_rings = 0\n"


@pytest.mark.parametrize("text", [STUDY + UNEQUAL, STUDY.replace("honeycomb", "lieb") + EQUAL, SQUARE + FREE])
def test_searches_guides_and_files_know_sites(text):
    study = loads(text + MANY + COARSE)
    assert design.brief(study).paths == ("cell.pitch",)
    waveguide.ANALYSIS.check(study, waveguide.ANALYSIS.options())
    export.check(study, export.ExportOptions())


@pytest.mark.parametrize(("along", "code"), [("[2, 2]", "out-of-range"), ("[0.5, 1]", "malformed")])
def test_a_strip_that_runs_along_no_translation_is_refused(along, code):
    def asked():
        study = loads(STUDY + UNEQUAL + f"\n[waveguide]\nalong = {along}\n")
        waveguide.ANALYSIS.check(study, waveguide.ANALYSIS.options())

    with pytest.raises(HaptonicError) as caught:
        asked()
    assert_explained(caught.value, code=code, argument="waveguide.along")
