"""Drives of several carriers: each frequency is answered with its own drives alone."""

from dataclasses import replace

import numpy as np
import pytest

from haptonic.bloch import Gap
from haptonic.bloch.gaps import common_gap, shared_gaps
from haptonic.fields import remade
from haptonic.report.chapter import Results
from haptonic.report.chapters.plate import chapter
from haptonic.results.plate.tables import power_table
from haptonic.study import loads

STUDY = """
title = "Two keys"
carrier = "20 kHz"
[cell]
pitch = "7 mm"
thickness = "1.5 mm"
[cell.pillar]
diameter = "3.5 mm"
height = "10 mm"
[material]
name = "aluminium"
youngs_modulus = "70 GPa"
poisson_ratio = 0.33
density = "2700 kg/m^3"
loss_factor = 1e-2
[bands]
accuracy = 0.05
[mesh]
order = 2
foot_rings = 0
[plate]
map = "1os2"
[plate.tiles]
o = "lattice"
s = "short"
1 = "left"
2 = "right"
[[plate.cell]]
name = "short"
change = { "cell.pillar.height" = "8 mm" }
[[plate.force]]
name = "F1"
region = "left"
centre = ["3 mm", "3 mm"]
force = "2 N"
[[plate.force]]
name = "F2"
region = "right"
centre = ["3 mm", "3 mm"]
carrier = "30 kHz"
[plate.response]
lowest = "10 kHz"
highest = "35 kHz"
points = 6
grid = "3.5 mm"
"""


@pytest.fixture(scope="module")
def study():
    return loads(STUDY)


@pytest.fixture(scope="module")
def result(study):
    return study.plate()


def test_powers_are_those_of_unit_drives_and_in_the_table_those_of_the_study(result):
    line, table = result.maps.sel(frequency=result.resonance), power_table(result)
    assert {line[name].attrs["units"] for name in ("given", "dissipated")} == {"W/N^2"}
    assert table.title.endswith("for 2 N at F1")
    assert table.rows[-1][1] == pytest.approx(4 * float(line["given"]), rel=1e-12)
    assert sum(row[1] for row in table.rows[:-1]) == pytest.approx(table.rows[-1][1], rel=1e-4)


def near(response, other):
    """Check equal responses, but for the mesh below a force, which the other study does not have."""
    np.testing.assert_allclose(response.values, other.values, rtol=0, atol=5e-3 * np.abs(other.values).max())


def test_each_carrier_is_answered_as_in_a_study_with_only_its_drives(study, result):
    assert [(answer.carrier, answer.drives) for answer in result.answers] == [(20e3, ["F1"]), (30e3, ["F2"])]
    alone = remade(study.plate_settings, force=study.plate_settings.force[1:])
    other = remade(study, carrier=30e3, plate_settings=alone).plate(at=30e3)
    response = result.answers[1].result.response
    near(response, other.response)
    assert response.dataset.attrs["reference"] == "F2, N"


def test_the_whole_response_has_the_drives_of_the_carrier_of_the_study(study, result):
    alone = remade(study.plate_settings, force=study.plate_settings.force[:1])
    other = remade(study, plate_settings=alone).plate()
    near(result.response, other.response)
    assert other.answers == ()


def test_one_frequency_has_the_drives_of_its_carrier(study, result):
    at = study.plate(at="30 kHz")
    np.testing.assert_array_equal(at.response.values, result.answers[1].result.response.values)


def test_lattices_around_the_driven_region_are_named(result):
    assert [list(answer.around) for answer in result.answers] == [["lattice"], ["short"]]


def test_table_picture_and_facts_have_a_line_for_each_carrier(result):
    table = next(table for table in result.tables() if "carrier" in table.title)
    assert len(table.rows) == 2
    assert "carriers" in result.figures
    facts = result.facts()["carriers"]
    assert [line["driven"] for line in facts] == ["left", "right"]
    pair, level = result.answers[1].least_contrast
    assert facts[1]["contrast_db"][pair] == level == min(facts[1]["contrast_db"].values())


def gap(lower, upper, band):
    return Gap((band, band + 1), lower, upper, 1.0, 2.0, (0.0, 0.0), (1.0, 1.0), True, "all", 9)


def test_a_common_gap_is_inside_all():
    low, high = gap(50e3, 62e3, 4), gap(55e3, 70e3, 6)
    both = common_gap([low, high])
    assert (both.lower, both.upper, both.between) == (55e3, 62e3, (6, 5))
    assert common_gap([low]) == low
    assert common_gap([low, None]) is None
    assert common_gap([]) is None


def test_shared_gaps_are_all_ranges_that_lie_in_a_gap_of_each_lattice():
    lattice = [gap(80e3, 99e3, 9), gap(50e3, 62e3, 4), replace(gap(10e3, 20e3, 2), complete=False)]
    assert shared_gaps([lattice]) == ((50e3, 62e3), (80e3, 99e3))
    assert shared_gaps([lattice, [gap(55e3, 85e3, 6)]]) == ((55e3, 62e3), (80e3, 85e3))
    assert shared_gaps([lattice, []]) == shared_gaps([]) == ()


def test_all_complete_gaps_are_known_and_shaded_also_without_the_carrier(study, result):
    assert result.gap is None
    assert list(result.gaps) == [gap.edges for gap in study.bands().gaps if gap.complete]
    assert result.gaps
    two = replace(result, gaps=((12e3, 15e3), (22e3, 30e3)))
    for name in ("velocity", "contrast"):
        shades = [patch for patch in two.plot(name).axes[0].patches if patch.get_gid() == "gap"]
        assert [shade.get_x() for shade in shades] == [12, 22]


def test_the_chapter_of_the_report_names_each_carrier(study, result):
    section = chapter(Results(study, {"plate": result}))
    assert [finding.split(",")[0] for finding in section.findings[:2]] == ["F1 at 20 kHz", "F2 at 30 kHz"]
    assert [picture.name for picture in section.pictures].count("carriers") == 1
    assert "each carrier" in section.tables[0].title
