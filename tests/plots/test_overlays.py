"""Bands over each other with their differences below, and pillars that keep apart."""

from __future__ import annotations

import numpy as np
import pytest
from seeing import artists, assert_readable

from haptonic import plots
from haptonic.cell.skin import FACES
from haptonic.plots.modes import clearance

PLACES = np.linspace(0, 3, 31)
BANDS = np.stack([20e3 * np.abs(np.sin(PLACES)), 50e3 + 5e3 * PLACES], axis=1)


def test_differences_are_below_the_bands_in_percent():
    """The second side is 0.4 % higher; where a band is at rest there is no share of it."""
    sides = [("ours", PLACES, BANDS, [(32e3, 50e3)]), ("theirs", PLACES[::2], 1.004 * BANDS[::2], [])]
    with plots.chosen("column"):
        figure = plots.compared(sides, ["Γ", "X", "M", "Γ"], crosses=True)
    assert_readable(figure)
    points = np.concatenate([line.get_ydata() for line in artists(figure, "residual")])
    assert np.isnan(points).any()
    assert points[np.isfinite(points)] == pytest.approx(0.4)
    assert figure.axes[1].get_ylabel() == "difference (%)"
    assert len(plots.compared(sides, ["Γ", "X"], ax=figure.axes[0]).axes) == 2, "none on axes of one's own"


def test_the_clear_distance_of_pillars_is_that_of_parts_of_the_upper_half():
    cube = np.array([[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))], dtype=float)
    pillars = [np.add(cube, [x, 1, 0.9]) for x in (1, 4.5)]
    position = np.concatenate([9 * cube * [1, 1, 0.1], *pillars])
    faces = np.concatenate([FACES + 8 * number for number in range(3)])
    assert clearance(position, faces) == pytest.approx(2.5)
    assert clearance(position[:16], faces[:12]) == float("inf")
