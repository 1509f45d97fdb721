"""Plates with one thing changed, and what the report says of them."""

from dataclasses import replace

import numpy as np
import pytest
from small import COARSE, LOSS, drawn, glued

from haptonic.plate.parts import Force, Plate
from haptonic.results.plate.variants import (
    Look,
    guide_mode,
    resonance,
    with_rows,
)

TWO_GUIDES = Plate(
    drawn("o1oo2o"), actuators=(glued((10.5e-3, 3.5e-3), (5e-3, 4e-3, 0.5e-3)),), loss_factor=LOSS
)


def strip(columns=8):
    """A free strip of plain plate."""
    return Plate(drawn("p" * columns), loss_factor=LOSS)


@pytest.mark.parametrize("rows", [0, 1, 2, 5])
def test_rows_of_lattice_come_and_go(rows):
    beyond = Force("F", (31e-3, 3.5e-3), None)
    plate = with_rows(replace(TWO_GUIDES, forces=(beyond,)), "1", "2", rows)
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
        look = Look(0.7 * frequency, 1.3 * frequency, name, 1e-3, 1e-3)
        assert guide_mode(strip(), "p", look, COARSE) == pytest.approx(frequency, rel=0.025)
    assert np.isnan(guide_mode(strip(), "p", replace(look, name="5x5"), COARSE))


def test_a_driven_guide_resonates_at_its_peak():
    """Plain plate all over, so quick; the loudest line is a maximum of the region's own response."""
    patch = glued((10.5e-3, 3.5e-3), (5e-3, 4e-3, 0.5e-3))
    plate = Plate(drawn("11112222"), actuators=(patch,), loss_factor=0.02)
    frequency, level = resonance(plate, Look(2.0e3, 3.2e3, "", 2e-3, 1e-2), "1", "2")
    length, speed = 56e-3, np.sqrt(70e9 / 2700.0)
    beam = 4.73004**2 * 1.5e-3 / np.sqrt(12) / length**2 * speed / (2 * np.pi)
    assert frequency == pytest.approx(beam, rel=0.06)  # the patch stiffens and loads it
    assert abs(level) < 3, "both halves of a free beam move alike"
