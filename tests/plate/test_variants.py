"""Plates with one thing changed, and what the report contains of them."""

import runpy
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from small import COARSE, LOSS, drawn, glued

from haptonic.plate import Band, PlateModel, modes_between
from haptonic.plate.layout.parts import Force, Plate
from haptonic.plate.layout.sampling import grid_points
from haptonic.plate.vibration.datasets import mode_names

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"
TWO_GUIDES = Plate(
    drawn("o1oo2o"), actuators=(glued((10.5e-3, 3.5e-3), (5e-3, 4e-3, 0.5e-3)),), loss_factor=LOSS
)


@pytest.fixture(scope="module")
def bench():
    """What the claim of benchmarks/rows_keep_it_there.py is made with."""
    with pytest.MonkeyPatch.context() as patched:
        patched.syspath_prepend(str(BENCHMARKS))
        return runpy.run_path(str(BENCHMARKS / "rows_keep_it_there.py"))


def strip(columns=8):
    """A free strip of plain plate."""
    return Plate(drawn("p" * columns), loss_factor=LOSS)


@pytest.mark.parametrize("rows", [0, 1, 2, 5])
def test_rows_of_lattice_come_and_go(bench, rows):
    beyond = Force("F", (31e-3, 3.5e-3), None)
    plate = bench["with_rows"](replace(TWO_GUIDES, forces=(beyond,)), "1", "2", rows)
    (row,) = plate.layout.tiles
    assert "".join(row) == "o1" + "o" * rows + "2o"
    assert np.diff(plate.layout.x) == pytest.approx(np.full(4 + rows, 7e-3))
    assert plate.actuators == TWO_GUIDES.actuators
    assert not plate.forces, "it would act somewhere else"


def test_a_mode_is_found_by_its_name():
    """The first two bending modes of a free beam (Euler and Bernoulli), thirty times as long as thick."""
    length, beta = 56e-3, np.array([4.73004, 7.85320])
    layout = strip().layout
    speed = np.sqrt(layout.material.youngs_modulus / layout.material.density)
    expected = beta**2 * layout.thickness / np.sqrt(12) / length**2 * speed / (2 * np.pi)
    for name, frequency in zip(("0x1", "0x2"), expected, strict=True):
        low, high = 0.7 * frequency, 1.3 * frequency
        model = PlateModel.of(strip(), high, COARSE)
        modes = modes_between(Band.of(model, low, high), low, high)
        points, regions = grid_points(strip(), 1e-3)
        shapes = model.displaced(points, modes.vectors)
        called = mode_names(strip(), model, modes, shapes, points, regions)
        assert called.count(name) == 1
        assert modes.frequency[called.index(name)] == pytest.approx(frequency, rel=0.025)


def test_a_driven_guide_resonates_at_its_peak(bench):
    """Plain plate all over, so quick; the loudest line is a maximum of the region's own response."""
    patch = glued((10.5e-3, 3.5e-3), (5e-3, 4e-3, 0.5e-3))
    plate = Plate(drawn("11112222"), actuators=(patch,), loss_factor=0.02)
    frequency, level = bench["resonance"](plate, (2.0e3, 3.2e3), 2e-3, 1e-2, "1", "2")
    length, speed = 56e-3, np.sqrt(70e9 / 2700.0)
    beam = 4.73004**2 * 1.5e-3 / np.sqrt(12) / length**2 * speed / (2 * np.pi)
    assert frequency == pytest.approx(beam, rel=0.06)  # the patch stiffens and loads it
    assert abs(level) < 3, "both halves of a free beam move alike"
