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
from trial_folders import simulated, written

PUBLISHED = {"driven": 0.55, "idle": 0.11, "stopped": 0.8}


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    folder = written(
        tmp_path_factory.mktemp("trials") / "a",
        simulated(trials=4),
        per="block",
        kind="h5",
        origin="simulated",
    )
    return compute_friction(folder, Sensor(), Rules())


def texts(figure):
    return [text.get_text() for text in figure.findobj(lambda artist: hasattr(artist, "get_text"))]


def test_a_mean_for_every_condition_and_a_line_from_off_to_on(result):
    figure = result.figures["conditions"]
    (axes,) = figure.axes
    points = {line.get_gid(): line for line in axes.lines if len((line.get_gid() or "").split()) >= 3}
    means = {f"{c.participant} {c.waveguide} {c.actuation}": c.friction[0] for c in result.found.conditions}
    assert {name: float(line.get_ydata()[0]) for name, line in points.items()} == pytest.approx(means)
    for name, line in points.items():
        hollow = line.get_markerfacecolor() == "white"
        assert hollow == name.endswith("off")
    joins = [line for line in axes.lines if len(line.get_xdata()) == 2 and line.get_linestyle() == "-"]
    pairs = {tuple(np.round(line.get_ydata(), 9)) for line in joins}
    for name, mean in means.items():
        if name.endswith("off"):
            assert (round(mean, 9), round(means[f"{name[:-3]}on"], 9)) in pairs
    assert axes.get_ylim()[1] > max(sum(c.friction) for c in result.found.conditions)
    assert axes.get_ylim()[0] == 0
    assert "simulated" in axes.get_ylabel()


def test_the_published_reductions_only_where_they_belong(result):
    assert not any("published" in text for text in texts(result.figures["reductions"]))
    figure = replace(result, published=PUBLISHED).figures["reductions"]
    marks = {line.get_gid(): line.get_xdata()[0] for line in figure.axes[0].lines if line.get_gid()}
    assert marks["WG1 published"] == pytest.approx(100 * PUBLISHED["driven"])
    assert marks["WG2 published"] == pytest.approx(100 * PUBLISHED["idle"])


def test_reductions_with_their_intervals(result):
    figure = result.figures["reductions"]
    (axes,) = figure.axes
    points = {line.get_gid(): line.get_xdata()[0] for line in axes.lines if line.get_gid()}
    assert points["weber"] == 11
    for (guide, person), reduction in result.found.own.items():
        assert points[f"{guide} {person}"] == pytest.approx(100 * reduction.value)
    ends = {tuple(np.round(line.get_xdata(), 6)) for line in axes.lines if line.get_gid() is None}
    reduction = result.found.own["WG1", "P2"]
    assert tuple(np.round([100 * reduction.low, 100 * reduction.high], 6)) in ends
    assert "simulated" in axes.get_xlabel()


def test_every_trial_of_a_block_is_on_its_sheet(result):
    blocks, more = result.blocks()
    assert (len(blocks), more) == (6, 0)
    trials = result.trials
    excluded = np.where(np.arange(trials.sizes["stroke"]) == 1, "no contact", "")
    trials = trials.assign(excluded=("stroke", excluded))
    marked = type(result)(result.source, result.sensor, result.rules, trials, (), result.found)
    ((person, block, figure),) = marked.sheets([("P1", 1)])
    assert (person, block) == ("P1", 1)
    written = texts(figure)
    assert [text for text in written if text[:2] in ("1:", "2:", "3:", "4:")] == [
        f"{n + 1}: WG2 {side}" + (f"  {trials['friction'].values[n]:.2f}" if n != 1 else "")
        for n, side in enumerate(["on", "off"] * 2)
    ]
    assert "no contact" in written
    assert "P1, block 1, simulated" in written


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
