"""A sweep over two expressions: every combination of their values is a design."""

from __future__ import annotations

import numpy as np
import pytest

from five_parts import assert_explained
from haptonic.errors import StudyError
from haptonic.study import load, loads
from quick import QUICK_CELL

HEIGHTS = {"vary": "cell.pillar.height", "from": "14 mm", "to": "15 mm", "steps": 2}
RATIOS = {"vary": "cell.pillar.diameter / cell.pitch", "from": 0.5, "to": 0.6, "steps": 3}
PITCHES = {"vary": "cell.pitch", "from": "6 mm", "to": "8 mm", "steps": 2}


def swept(first, second):
    return loads(QUICK_CELL).with_keys({"sweep": [{**first, "second": second}]})


def test_every_combination_is_a_design():
    study = swept(HEIGHTS, RATIOS)
    (sweep,) = study.sweep_settings
    assert sweep.count == 6
    assert sweep.designs == pytest.approx(
        np.array([(height, ratio) for height in (14e-3, 15e-3) for ratio in (0.5, 0.55, 0.6)])
    )
    sizes = [(design.cell.pillar.height, design.cell.pillar.diameter) for design in study.designs(sweep)]
    assert np.array(sizes) == pytest.approx(np.array(sweep.designs) * (1, 7e-3))


@pytest.mark.parametrize("tables", [(RATIOS, PITCHES), (PITCHES, RATIOS)], ids=["ratio first", "pitch first"])
def test_both_expressions_have_their_values_whatever_changes_first(tables):
    """A diameter over a pitch that varies too is found after the pitch."""
    study = swept(*tables)
    (sweep,) = study.sweep_settings
    for values, design in zip(sweep.designs, study.designs(sweep), strict=True):
        for axis, value in zip(sweep.axes, values, strict=True):
            assert axis.expression.value(design.parameters()) == pytest.approx(value)


def test_it_comes_back_from_its_file():
    study = swept(HEIGHTS, RATIOS)
    assert loads(study.to_toml()) == study


@pytest.mark.parametrize(
    ("first", "second", "code", "at"),
    [
        (HEIGHTS, HEIGHTS, "repeated", "sweep[1].second.vary"),
        (
            {**RATIOS, "vary": "cell.pillar.diameter / cell.pitch"},
            {**RATIOS, "vary": "cell.pitch / cell.pillar.diameter", "from": 1.5, "to": 2.0},
            "conflict",
            "sweep[1].second.vary",
        ),
        ({**HEIGHTS, "steps": 100}, {**RATIOS, "steps": 11}, "too-large", "sweep[1].second.steps"),
        (HEIGHTS, {**RATIOS, "to": 1.2}, "out-of-range", "sweep[1]"),
        (HEIGHTS, {**RATIOS, "vary": "cell.pillar.diametre"}, "unknown", "sweep[1].second.vary"),
    ],
    ids=["the same twice", "each needs the other", "too many", "impossible", "misspelt"],
)
def test_a_grid_that_cannot_be_is_refused(first, second, code, at):
    with pytest.raises(StudyError) as caught:
        swept(first, second)
    assert_explained(caught.value, code=code, argument=at)


def test_a_column_of_the_grid_is_a_sweep_along_one_expression():
    grid = swept(HEIGHTS, {**RATIOS, "steps": 2}).sweep()
    along = loads(QUICK_CELL).with_keys({"sweep": [{**RATIOS, "steps": 2}], "cell.pillar.height": "15 mm"})
    theirs = along.sweep().dataset.isel(sweep=0)
    ours = grid.dataset.isel(sweep=0, step=slice(2, None))
    assert ours["value"].values.tolist() == pytest.approx([15e-3, 15e-3])
    assert ours["second_value"].values == pytest.approx(theirs["value"].values)
    assert ours["gap_lower"].values == pytest.approx(theirs["gap_lower"].values, rel=1e-6, nan_ok=True)
    facts = grid.facts()["sweeps"][0]
    assert (facts["vary"], facts["second_vary"]) == (HEIGHTS["vary"], RATIOS["vary"])
    assert [design["second_value"] for design in facts["designs"]] == pytest.approx([0.5, 0.6] * 2)
    table = grid.to_dataframe()
    assert list(table)[:2] == ["cell.pillar.height (m)", "cell.pillar.diameter / cell.pitch"]
    assert len(table) == 4


def test_all_sweeps_are_one_table_and_each_file_contains_the_study(tmp_path):
    study = loads(QUICK_CELL).with_keys({"sweep": [HEIGHTS, PITCHES], "bands.accuracy": 1e-2})
    answer = study.sweep()
    frame = answer.to_dataframe()
    assert frame["sweep"].tolist() == [1, 1, 2, 2]
    assert frame["cell.pillar.height (m)"].tolist()[:2] == pytest.approx([14e-3, 15e-3])
    assert frame["cell.pitch (m)"].tolist()[2:] == pytest.approx([6e-3, 8e-3])
    answer.write(tmp_path / "swept")
    assert all(load(tmp_path / "swept" / f"sweep_{number}.nc") == study for number in (1, 2))
