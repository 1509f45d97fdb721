"""Lattices: wavevectors, little groups, the path and the tiling of the irreducible zone."""

from collections import Counter
from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import lattices, pitches

from haptonic.errors import GeometryError
from haptonic.lattice import IDENTITY, Lattice

phases = st.tuples(st.floats(-7, 7), st.floats(-7, 7))


class Oblique(Lattice):
    """A lattice that no file describes: nothing about wavevectors may need right angles."""

    point_group = (IDENTITY,)
    a1 = property(lambda self: (self.pitch, 0.2 * self.pitch))
    a2 = property(lambda self: (-0.3 * self.pitch, 0.8 * self.pitch))


def oblique(pitch: float) -> Lattice:
    return Oblique(pitch=pitch)


@given(lattices() | pitches.map(oblique), phases)
def test_wavevectors_give_back_their_phases(lattice, kappa):
    k = lattice.wavevector(np.array(kappa))
    assert np.dot(k, lattice.a1) == pytest.approx(kappa[0], abs=1e-12)
    assert np.dot(k, lattice.a2) == pytest.approx(kappa[1], abs=1e-12)
    many = lattice.wavevector(np.array([kappa, kappa]))
    assert many == pytest.approx(np.array([k, k]))


@given(pitches, st.floats(0.3, 3))
def test_sizes(pitch, ratio):
    lattice = Lattice.rectangular(pitch, ratio * pitch)
    assert lattice.pitch == pitch
    assert lattice.area == pytest.approx(ratio * pitch**2)
    assert oblique(pitch).area == pytest.approx((0.8 + 0.06) * pitch**2)


@pytest.mark.parametrize("pitch", [0.0, float("nan"), float("inf")])
def test_a_pitch_that_spans_no_lattice_is_refused(pitch):
    with pytest.raises(GeometryError, match=r"cell\.pitch: "):
        Lattice.square(pitch)
    with pytest.raises(GeometryError, match=r"cell\.pitch_y: "):
        Lattice.rectangular(1e-3, pitch)


@given(lattices())
def test_the_point_group_is_a_group_of_isometries(lattice):
    group = {tuple(map(tuple, op)) for op in lattice.point_group}
    assert len(group) == len(lattice.point_group)
    for a, b in product(lattice.point_group, repeat=2):
        assert tuple(map(tuple, (np.array(a) @ np.array(b)).tolist())) in group
    metric = lattice.vectors @ lattice.vectors.T
    for op in lattice.point_group:
        assert np.array(op).T @ metric @ np.array(op) == pytest.approx(metric)


LITTLE = {
    "square": {(0, 0): 8, (1, 0): 4, (1, 1): 8, (0.4, 0): 2, (1, 0.4): 2, (0.4, 0.4): 2, (0.5, 0.2): 1},
    "rectangular": {(0, 0): 4, (1, 0): 4, (1, 1): 4, (0, 1): 4, (0.4, 0): 2, (1, 0.4): 2, (0.4, 0.4): 1},
}


@pytest.mark.parametrize(
    "lattice", [Lattice.square(7e-3), Lattice.rectangular(8e-3, 6e-3)], ids=lambda v: v.name
)
def test_little_groups_have_the_orders_of_the_plane_group(lattice):
    for point, order in LITTLE[lattice.name].items():
        assert len(lattice.little_group((np.pi * point[0], np.pi * point[1]))) == order


@given(lattices(), st.tuples(st.integers(-4, 4), st.integers(-4, 4)))
def test_little_groups_turn_the_wavevector_by_a_reciprocal_vector(lattice, quarters):
    kappa = 0.5 * np.pi * np.array(quarters)
    little = lattice.little_group(tuple(kappa))
    k = lattice.wavevector(kappa)
    for op in lattice.point_group:
        # the same operation in Cartesian coordinates: r = V^T n, so R = V^T op V^-T
        turn = lattice.vectors.T @ np.array(op) @ np.linalg.inv(lattice.vectors.T)
        moved = lattice.vectors @ (turn @ k - k) / (2 * np.pi)
        assert (op in little) == bool(np.allclose(moved, np.round(moved), atol=1e-9))


def test_mirrors_are_those_of_the_lattice():
    assert set(Lattice.square(1.0).mirrors()) == {"x", "y", "d"}
    assert set(Lattice.rectangular(1.0, 2.0).mirrors()) == {"x", "y"}


@given(lattices(), st.integers(9, 200))
def test_path_goes_evenly_round_the_irreducible_zone(lattice, points):
    path = lattice.path(points)
    assert path.kappa.shape == (points, 2)
    labels = [label for label, _ in lattice.zone]
    assert list(path.labels) == [*labels, labels[0]]
    assert path.corners[0] == 0
    assert path.corners[-1] == points - 1
    for corner, label in zip(path.corners, path.labels, strict=True):
        assert path.kappa[corner] == pytest.approx(np.pi * np.array(dict(lattice.zone)[label]), abs=1e-12)

    k = lattice.wavevector(path.kappa)
    steps = np.linalg.norm(np.diff(k, axis=0), axis=1)
    assert path.distance[1:] == pytest.approx(np.cumsum(steps), rel=1e-12)
    ideal = path.distance[-1] / (points - 1)
    for start, stop in zip(path.corners, path.corners[1:], strict=False):
        inside = steps[start:stop]
        assert stop - start >= 2
        assert inside == pytest.approx(np.full(stop - start, inside.mean()), rel=1e-9)
        rounding = 2 if points > 60 else 3  # steps that a segment may have more or less than its share
        assert abs((stop - start) - inside.sum() / ideal) <= rounding


@given(lattices(), st.integers(9, 60))
def test_a_corner_opens_the_next_segment(lattice, points):
    path = lattice.path(points)
    for number, (start, stop) in enumerate(zip(path.corners, path.corners[1:], strict=False)):
        assert (path.segment[start:stop] == number).all()
    assert path.segment[-1] == len(lattice.zone) - 1


def test_too_few_points_are_refused():
    assert len(Lattice.square(1.0).path(7).kappa) == 7
    with pytest.raises(GeometryError, match="at least 7 for 3 segments"):
        Lattice.square(1.0).path(6)
    with pytest.raises(GeometryError, match="at least 9 for 4 segments"):
        Lattice.rectangular(1.0, 2.0).path(8)


def doubled_area(corners):
    """(m,) signed, of polygons (m, corners, 2)."""
    following = np.roll(corners, -1, axis=-2)
    return (corners[..., 0] * following[..., 1] - corners[..., 1] * following[..., 0]).sum(axis=-1)


@given(lattices(), st.integers(1, 9))
def test_triangles_tile_the_irreducible_zone(lattice, divisions):
    kappa, triangles = lattice.zone_triangles(divisions)
    zone = np.pi * np.array([point for _, point in lattice.zone])
    assert len(np.unique(np.round(kappa, 9), axis=0)) == len(kappa)
    assert set(triangles.ravel()) == set(range(len(kappa)))
    areas = doubled_area(kappa[triangles])
    assert (areas > 0).all()
    assert areas == pytest.approx(np.full(len(areas), areas[0]))
    assert areas.sum() == pytest.approx(doubled_area(zone))
    # no hanging vertex: an edge belongs to two triangles, or to one on the zone's border
    edges = Counter(frozenset((int(t[i]), int(t[i - 1]))) for t in triangles for i in range(3))
    assert set(edges.values()) <= {1, 2}
    for edge, count in edges.items():
        middle = kappa[list(edge)].mean(axis=0)
        sides = zip(zone, np.roll(zone, -1, axis=0), strict=True)
        on_border = any(abs(doubled_area(np.array([a, b, middle]))) < 1e-9 for a, b in sides)
        assert on_border == (count == 1)


@given(lattices())
def test_the_images_of_the_irreducible_zone_fill_the_whole(lattice):
    kappa, triangles = lattice.zone_triangles(3)
    area = 0.5 * doubled_area(kappa[triangles]).sum()
    assert area * len(lattice.point_group) == pytest.approx((2 * np.pi) ** 2)
