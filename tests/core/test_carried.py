"""Long waves of a lattice are the plate's, however heavy the pillars that they carry along."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from coarse import reference_cell
from hypothesis import given, settings, strategies as st

from haptonic.bloch import Resolution
from haptonic.bloch.character import BENDING, DEFORMATION, FLEXURAL, IN_PLANE, LONGITUDINAL, characters
from haptonic.bloch.model import BlochModel
from haptonic.cell import Disc

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
        named = characters(model.fine.tiling, solution.fields, solution.values).name
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
    assert characters(model.fine.tiling, solution.fields, solution.values).name[0] != LONGITUDINAL


def test_a_tube_that_becomes_oval_is_named_after_the_deformation_of_its_sections():
    """Its rim moves outwards in two places and inwards between them; in bending it moves to one side."""
    cell = reference_cell()
    tube = (Disc(6e-3, low=0.0, high=5e-3), Disc(4e-3, low=0.0, high=5e-3, empty=True))
    model = BlochModel.of(replace(cell, pillar=None, thickness=1e-3, disc=tube), Resolution(3, 0), 6)
    solution = model.solve(np.array([0.5, 0.2]))
    points = model.fine.tiling.meshes[0].points
    at_top = np.isclose(points[:, 2], points[:, 2].max())
    rim = at_top & np.isclose(np.linalg.norm(points[:, :2], axis=1), 3e-3)
    angle = np.arctan2(points[rim, 1], points[rim, 0])
    radial = model.displacement(solution)[rim, :2] * np.array([np.cos(angle), np.sin(angle)]).T[:, :, None]
    terms = np.stack([np.exp(1j * turns * angle) for turns in (0, 1, -1, 2, -2, 3, -3)], axis=1)
    amplitudes = np.abs(np.linalg.lstsq(terms, radial.sum(axis=1))[0]) ** 2
    to_one_side, oval = amplitudes[1:3].sum(axis=0), amplitudes[3:5].sum(axis=0)
    named = characters(model.fine.tiling, solution.fields, solution.values).name
    bends, deforms = named == BENDING, named == DEFORMATION
    assert bends.any()
    assert deforms.any()
    assert (to_one_side > 3 * oval)[bends].all()
    assert (oval > 3 * to_one_side)[deforms].all()
