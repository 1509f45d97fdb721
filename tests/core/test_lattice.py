"""Lattices: wavevectors, point groups and little groups."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given, strategies as st
from strategies import lattices, pitches

from five_parts import refusing
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice

phases = st.tuples(st.floats(-7, 7), st.floats(-7, 7))


@given(lattices(), phases)
def test_wavevectors_give_back_their_phases(lattice, kappa):
    k = lattice.wavevector(np.array(kappa))
    assert np.dot(k, lattice.a1) == pytest.approx(kappa[0], abs=1e-12)
    assert np.dot(k, lattice.a2) == pytest.approx(kappa[1], abs=1e-12)
    many = lattice.wavevector(np.array([kappa, kappa]))
    assert many == pytest.approx(np.array([k, k]), abs=1e-12 * np.abs(k).max())  # a zero among large ones


@given(pitches, st.floats(0.3, 3))
def test_sizes(pitch, ratio):
    lattice = Lattice.rectangular(pitch, ratio * pitch)
    assert lattice.pitch == pitch
    assert lattice.area == pytest.approx(ratio * pitch**2)
    leaning = Lattice.oblique(pitch, 1.3 * pitch, 2.0)
    assert leaning.area == pytest.approx(1.3 * np.sin(2.0) * pitch**2)
    assert Lattice.centred(pitch, 1.7 * pitch).area == pytest.approx(0.85 * pitch**2)


@pytest.mark.parametrize("pitch", [0.0, float("nan"), float("inf")])
def test_a_pitch_that_spans_no_lattice_is_refused(pitch):
    with refusing(GeometryError, "out-of-range", "cell.pitch"):
        Lattice.square(pitch)
    with refusing(GeometryError, "out-of-range", "cell.pitch_y"):
        Lattice.rectangular(1e-3, pitch)


@given(lattices())
def test_the_point_group_is_a_group_of_isometries(lattice):
    group = lattice.point_group
    assert len(set(group.operations)) == len(group)
    for a, b in product(group.operations, repeat=2):
        assert tuple(map(tuple, (np.array(a) @ np.array(b)).tolist())) in group
    for op in group.operations:
        turn = group.turn(op)
        assert turn @ turn.T == pytest.approx(np.eye(3), abs=1e-12)
        assert turn[:2, :2] @ lattice.vectors.T == pytest.approx(lattice.vectors.T @ np.array(op), rel=1e-9)


LITTLE = {
    "square": {(0, 0): 8, (1, 0): 4, (1, 1): 8, (0.4, 0): 2, (1, 0.4): 2, (0.4, 0.4): 2, (0.5, 0.2): 1},
    "rectangular": {(0, 0): 4, (1, 0): 4, (1, 1): 4, (0, 1): 4, (0.4, 0): 2, (1, 0.4): 2, (0.4, 0.4): 1},
}


@pytest.mark.parametrize(
    "lattice", [Lattice.square(7e-3), Lattice.rectangular(8e-3, 6e-3)], ids=lambda v: v.name
)
def test_little_groups_have_the_orders_of_the_plane_group(lattice):
    for point, order in LITTLE[lattice.name].items():
        assert len(lattice.point_group.little_group(np.pi * np.array(point))) == order


@given(lattices(), st.tuples(st.integers(-4, 4), st.integers(-4, 4)))
def test_little_groups_turn_the_wavevector_by_a_reciprocal_vector(lattice, quarters):
    kappa = 0.5 * np.pi * np.array(quarters)
    little = lattice.point_group.little_group(kappa)
    k = lattice.wavevector(kappa)
    for op in lattice.point_group.operations:
        # the same operation in Cartesian coordinates: r = V^T n, so R = V^T op V^-T
        turn = lattice.vectors.T @ np.array(op) @ np.linalg.inv(lattice.vectors.T)
        moved = lattice.vectors @ (turn @ k - k) / (2 * np.pi)
        assert (op in little) == bool(np.allclose(moved, np.round(moved), atol=1e-9))


def test_mirrors_are_those_of_the_lattice():
    square = Lattice.square(1.0).point_group
    assert list(square.mirrors) == ["x", "y", "d", "45°"]
    assert list(square.distinct_mirrors) == ["x", "y", "d"]
    triangular = Lattice.triangular(1.0).point_group
    assert list(triangular.mirrors) == ["x", "y", "120°", "150°", "30°", "60°"]
    assert list(triangular.distinct_mirrors) == ["x", "y"]
    assert list(Lattice.rectangular(1.0, 2.0).point_group.mirrors) == ["x", "y"]
    assert Lattice.oblique(1.0, 1.1, 1.3).point_group.mirrors == {}


@given(lattices())
def test_a_mirror_turns_its_normal_over(lattice):
    group = lattice.point_group
    for name, op in group.mirrors.items():
        angle = np.radians({"x": 0, "y": 90, "d": 135}.get(name) or float(name.strip("xy°") or 0))
        angle = np.radians(90) if name == "y" else angle
        normal = np.array([np.cos(angle), np.sin(angle), 0.0])
        assert group.turn(op) @ normal == pytest.approx(-normal, abs=1e-9)


# at the limits themselves, rounding decides
powers = st.floats(-12, 12).filter(lambda power: abs(abs(power) - 3) > 1e-9)


@given(pitches, powers.map(lambda power: 10.0**power))
def test_a_rectangle_has_four_sides_and_four_operations_or_is_refused(pitch, ratio):
    if not 1e-3 < ratio < 1e3:
        with refusing(GeometryError, "out-of-range", "cell.pitch_y"):
            Lattice.rectangular(pitch, ratio * pitch)
        return
    lattice = Lattice.rectangular(pitch, ratio * pitch)
    assert len(lattice.neighbours) == 4
    assert len(lattice.point_group) == 4
    assert lattice.corners == pytest.approx(
        0.5 * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * [pitch, ratio * pitch], rel=1e-9
    )
