"""Long waves of a lattice are the plate's, however heavy the pillars that they carry along."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from coarse import reference_cell
from hypothesis import given, settings, strategies as st

from haptonic.bloch import Resolution
from haptonic.bloch.character import FLEXURAL, IN_PLANE, LONGITUDINAL, characters
from haptonic.bloch.model import BlochModel

PITCH = 7e-3


@settings(max_examples=3, deadline=None)
@given(
    diameter=st.floats(0.3, 0.7), height=st.floats(0.2, 1.6), thickness=st.floats(0.1, 0.3),
    angle=st.floats(0, 0.5 * np.pi),
)  # fmt: skip
def test_long_waves_belong_to_the_plate(diameter, height, thickness, angle):
    cell = reference_cell()
    pillar = replace(cell.pillar, diameter=diameter * PITCH, height=height * PITCH)
    cell = replace(cell, thickness=thickness * PITCH, pillar=pillar)
    model = BlochModel.of(cell, Resolution(2, 0), 6)
    at_rest = model.solve(np.zeros(2)).frequency[3]  # the first motion that the cell has by itself
    direction = np.array([np.cos(angle), np.sin(angle)])
    for length, kinds in ((0.15, {0: FLEXURAL}), (0.03, {1: IN_PLANE, 2: IN_PLANE})):
        solution = model.solve(length * direction)
        named = characters(model.fine.tiling, solution.fields).name
        for number, kind in kinds.items():
            if solution.frequency[number] < 0.3 * at_rest:  # others meet the pillar's own motion
                assert named[number] == kind


@settings(max_examples=3, deadline=None)
@given(height=st.floats(0.5, 3.0), thickness=st.floats(0.05, 0.3), length=st.floats(0.1, np.pi))
def test_pillars_that_rise_with_the_plate_are_not_stretched(height, thickness, length):
    """Tall ones tilt as well, and so move against their feet: still the lowest wave is not longitudinal."""
    cell = reference_cell()
    pillar = replace(cell.pillar, diameter=0.6 * PITCH, height=height * PITCH)
    cell = replace(cell, thickness=thickness * PITCH, pillar=pillar)
    model = BlochModel.of(cell, Resolution(2, 0), 6)
    solution = model.solve(np.array([length, 0.0]))
    assert characters(model.fine.tiling, solution.fields).name[0] != LONGITUDINAL
