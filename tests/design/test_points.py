"""Designs that are reported while an analysis computes are those of its result."""

from dataclasses import replace

import numpy as np
import pytest

from haptonic.analyses import named
from haptonic.analyses.runner import Runner
from haptonic.bloch import Resolution
from haptonic.design import edges, quick
from haptonic.store import Store
from haptonic.study import loads
from quick import QUICK_CELL

STUDY = QUICK_CELL.replace("order = 2\nfoot_rings = 0", "order = 3\nfoot_rings = 1")
DESIGN = """
[design]
starts = 2
climbs = 1
steps = 2
[[design.vary]]
parameter = "cell.pillar.height"
from = "14 mm"
to = "16 mm"
"""
TOLERANCE = """
[tolerance]
samples = 16
[[tolerance.of]]
parameter = "cell.pillar.height"
spread = "20 um"
"""


@pytest.fixture(autouse=True)
def _cheap(monkeypatch):
    """Designs are computed in a coarser model, at fewer wavevectors."""
    monkeypatch.setattr(quick, "QUICK", Resolution(2, 1))
    monkeypatch.setattr(edges, "DIVISIONS", 4)


def computed(name, text, store_folder):
    analysis, points = named(name), []
    runner = Runner(Store(store_folder), report=points.append)
    return points, analysis.compute(loads(text), analysis.options(), runner)


def test_a_search_reports_every_design_with_its_margin(store_folder):
    points, result = computed("design", STUDY + DESIGN, store_folder)
    coarse = [point for point in points if point.group != "required accuracy"]
    data = result.dataset
    heights = [point.varied[0].value for point in coarse]
    np.testing.assert_allclose(heights, data["value"].values[:, 0])
    margins = [point.results[0].value for point in coarse]
    np.testing.assert_allclose(margins, data["margin"].values * 60e3)
    assert all(point.results[0].error is None for point in coarse)
    exact = [point for point in points if point.group == "required accuracy"]
    best = max(exact, key=lambda point: point.results[0].value - point.results[0].error)
    assert best.changes["cell.pillar.height"] == result.values["cell.pillar.height"]
    assert best.results[0].value - best.results[0].error == pytest.approx(result.margin)


def test_tolerances_report_the_edges_of_their_designs(store_folder):
    points, result = computed("tolerance", STUDY + TOLERANCE, store_folder)
    reported = [[number.value for number in point.results] for point in points]
    np.testing.assert_allclose(reported, result.dataset["edge"].values)
    assert len({point.changes["cell.pillar.height"] for point in points}) == len(points) == 16


def test_constants_of_built_in_materials_vary_in_tolerances(store_folder):
    spread = TOLERANCE.replace("cell.pillar.height", "material.density").replace("20 um", "20 kg/m^3")
    points, result = computed("tolerance", STUDY + spread, store_folder)
    assert points[0].varied[0].unit == "kg/m^3"
    assert result.loosest is None
    assert result.facts()["loosest_factor"] is None
    assert "No size or angle varies" in " ".join(result.summary())
    (row,) = result.tables()[0].rows
    assert row[:2] == ("material.density", "20 kg/m^3")
    assert row[2:4] == pytest.approx(tuple(20.0 * result.dataset["slope"].values[0]))
    far = replace(result, loosest=0.0, plate=0.4, exact_sizes=0.425)
    words = "With exact sizes the probability is 42.50 %, so no spread of sizes, however small, gives"
    assert words in " ".join(far.summary())
