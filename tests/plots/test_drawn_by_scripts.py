"""Pictures of pages that scripts draw: the benchmark against NGSolve, and the mesh of the method."""

from __future__ import annotations

import json
import runpy
from pathlib import Path

import pytest
from matplotlib.colors import to_hex
from seeing import assert_readable

from haptonic.plots import style

ROOT = Path(__file__).parents[2]
HOUSE = {to_hex(c) for c in (style.BLUE, style.SKY, style.GREEN, style.ORANGE, style.RED, style.INK)}


@pytest.fixture
def figures():
    return runpy.run_path(str(ROOT / "docs" / "draw_figures.py"))


def test_the_line_of_a_race_is_named_and_every_point_has_its_order(monkeypatch):
    monkeypatch.syspath_prepend(ROOT / "benchmarks")
    race = runpy.run_path(str(ROOT / "benchmarks" / "render.py"))["race"]
    record = json.loads((ROOT / "benchmarks/results/thousand_times_cheaper.json").read_text("utf-8"))
    figure = race(record)
    (axes,) = figure.axes
    texts = [text.get_text() for text in axes.texts]
    assert "compared at 0.2 %" in texts
    assert sum(text.startswith("order") for text in texts) == len(record["haptonic"] + record["ngsolve"])
    assert axes.get_ylabel() == "largest true error (%)"
    assert_readable(figure)


def test_polynomials_have_colours_of_the_house(figures):
    axes = style.blank(6.0).subplots()
    figures["draw_basis"](axes)
    curves = {to_hex(line.get_color()) for line in axes.lines if line.get_linestyle() != "None"}
    assert len(curves) == 5
    assert curves <= HOUSE


def test_the_enlarged_part_is_framed_in_the_section_and_contains_the_foot(figures):
    section, foot = style.blank(6.0).subplots(1, 2)
    figures["magnify"](section, foot)
    (frame,) = section.patches
    (left, bottom), (right, top) = zip(foot.get_xlim(), foot.get_ylim(), strict=True)
    assert frame.get_bbox().extents == pytest.approx([left, bottom, right, top])
    assert left < 1.75 < right  # radius of the pillar, mm
    assert bottom < 1.5 < top  # thickness of the plate
    assert right - left < 2
