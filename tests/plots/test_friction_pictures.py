"""Pictures of trials: the right bars, intervals and reasons, and where they come from."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import xarray as xr

from haptonic.analyses.friction import compute_friction
from haptonic.friction.recordings import Sensor
from haptonic.friction.signals import Rules
from haptonic.results.friction import MOST_SHEETS
from trial_folders import made_up, written

PUBLISHED = {"driven": 0.55, "idle": 0.11, "stopped": 0.8}


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    folder = written(
        tmp_path_factory.mktemp("trials") / "a", made_up(trials=4), per="block", kind="h5", origin="simulated"
    )
    return compute_friction(folder, Sensor(), Rules())


def texts(figure):
    return [text.get_text() for text in figure.findobj(lambda one: hasattr(one, "get_text"))]


def test_a_bar_for_every_condition(result):
    figure = result.figures["conditions"]
    (axes,) = figure.axes
    bars = {bar.get_gid(): bar.get_height() for bar in axes.patches if bar.get_gid()}
    found = {f"{c.participant} {c.waveguide} {c.actuation}": c.friction[0] for c in result.found.conditions}
    assert bars == pytest.approx(found)
    assert len(axes.containers) >= len(bars)  # one sd on each
    assert axes.get_ylim()[1] > max(sum(c.friction) for c in result.found.conditions)
    assert "simulated" in axes.get_title()


def test_the_published_numbers_only_where_they_belong(result):
    plain = " ".join(texts(result.figures["conditions"]))
    assert "published" not in plain
    beside = " ".join(texts(replace(result, published=PUBLISHED).figures["conditions"]))
    for words in ("published: 55%", "published: 11%", "published: about 80%", "WG1 (driven)"):
        assert words in beside


def test_reductions_with_their_intervals(result):
    figure = result.figures["reductions"]
    (axes,) = figure.axes
    points = {line.get_gid(): line.get_xdata()[0] for line in axes.lines if line.get_gid()}
    assert points["weber"] == 11
    for (guide, person), one in result.found.own.items():
        assert points[f"{guide} {person}"] == pytest.approx(100 * one.value)
    ends = {tuple(np.round(line.get_xdata(), 6)) for line in axes.lines if line.get_gid() is None}
    one = result.found.own["WG1", "P2"]
    assert tuple(np.round([100 * one.low, 100 * one.high], 6)) in ends
    assert "simulated" in axes.get_title()


def test_every_trial_of_a_block_is_on_its_sheet(result):
    blocks, more = result.blocks()
    assert (len(blocks), more) == (6, 0)
    trials = result.trials
    excluded = np.where(np.arange(trials.sizes["stroke"]) == 1, "no contact", "")
    trials = trials.assign(excluded=("stroke", excluded))
    marked = type(result)(result.source, result.sensor, result.rules, trials, (), result.found)
    ((person, block, figure),) = marked.sheets([("P1", 1)])
    assert (person, block) == ("P1", 1)
    said = texts(figure)
    assert [text for text in said if text[:2] in ("1:", "2:", "3:", "4:")] == [
        f"{n + 1}: WG2 {side}" + (f"  {trials['friction'].values[n]:.2f}" if n != 1 else "")
        for n, side in enumerate(["on", "off"] * 2)
    ]
    assert "no contact" in said
    assert "P1, block 1, simulated" in said


def test_of_too_many_blocks_those_with_most_exclusions_are_drawn(result):
    count = MOST_SHEETS + 20
    names = np.repeat([f"P{n}" for n in range(count)], 2)
    excluded = np.where(np.arange(2 * count) >= 2 * count - 10, "no contact", "")
    table = {"participant": names, "block": np.ones(2 * count, dtype=int), "excluded": excluded}
    trials = xr.Dataset({name: ("stroke", values) for name, values in table.items()})
    many = type(result)(result.source, result.sensor, result.rules, trials, (), result.found)
    blocks, more = many.blocks()
    assert (len(blocks), more) == (MOST_SHEETS, 20)
    assert {(f"P{count - 1 - n}", 1) for n in range(5)} <= set(blocks)
