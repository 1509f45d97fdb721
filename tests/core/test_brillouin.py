"""The irreducible zone: its corners, the path round it, and triangles that tile it."""

from collections import Counter

import numpy as np
import pytest
from hypothesis import given, strategies as st
from strategies import ALUMINIUM, lattices, upright_lattices

from five_parts import refusing
from haptonic.bloch import bands_dataset
from haptonic.bloch.settings import BandSettings
from haptonic.brillouin import IrreducibleZone
from haptonic.cell import UnitCell
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice


def zone_of(lattice: Lattice) -> IrreducibleZone:
    return IrreducibleZone.of(lattice, lattice.point_group)


def contains(polygon, point) -> bool:
    """Whether a convex polygon (n, 2), anticlockwise, holds a point, or nearly."""
    sides = np.roll(polygon, -1, axis=0) - polygon
    away = point - polygon
    return bool(
        (sides[:, 0] * away[:, 1] - sides[:, 1] * away[:, 0] > -1e-9 * np.abs(polygon).max() ** 2).all()
    )


@given(lattices(), st.tuples(st.floats(-9, 9), st.floats(-9, 9)), st.booleans())
def test_every_wavevector_has_an_image_in_the_zone(lattice, kappa, whole):
    """And the zone is as small as its group is large, so it repeats none."""
    group = lattice.point_group if whole else lattice.point_group.kept(lambda turn: turn[0, 1] == 0)
    zone = IrreducibleZone.of(lattice, group)
    polygon = lattice.wavevector(np.pi * np.array([point for _, point in zone.corners]))
    shifts = 2 * np.pi * np.stack(np.meshgrid(np.arange(-4, 5), np.arange(-4, 5)), axis=-1).reshape(-1, 2)
    images = [np.linalg.inv(np.array(op)).T @ kappa + shift for op in group.operations for shift in shifts]
    assert any(contains(polygon, lattice.wavevector(image)) for image in images)
    area = doubled_area(np.pi * np.array([point for _, point in zone.corners])) / 2
    assert abs(area) * len(group) == pytest.approx((2 * np.pi) ** 2)


@given(lattices())
def test_labels_are_names_of_one_corner_each(lattice):
    labels = [label for label, _ in zone_of(lattice).corners]
    assert len(set(labels)) == len(labels)
    assert labels[0] == "Γ"


@given(upright_lattices(), st.integers(9, 200))
def test_path_goes_evenly_round_the_irreducible_zone(lattice, points):
    zone = zone_of(lattice)
    path = zone.path(points)
    assert path.kappa.shape == (points, 2)
    labels = [label for label, _ in zone_of(lattice).corners]
    assert list(path.labels) == [*labels, labels[0]]
    assert path.corners[0] == 0
    assert path.corners[-1] == points - 1
    for corner, label in zip(path.corners, path.labels, strict=True):
        assert path.kappa[corner] == pytest.approx(
            np.pi * np.array(dict(zone_of(lattice).corners)[label]), abs=1e-12
        )

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


@given(lattices(), st.integers(17, 60))
def test_a_corner_opens_the_next_segment(lattice, points):
    path = zone_of(lattice).path(points)
    for number, (start, stop) in enumerate(zip(path.corners, path.corners[1:], strict=False)):
        assert (path.segment[start:stop] == number).all()
    assert path.segment[-1] == len(zone_of(lattice).corners) - 1


def test_too_few_points_are_refused():
    assert len(zone_of(Lattice.square(1.0)).path(7).kappa) == 7
    with refusing(GeometryError, "too-few", "bands.points", "at least 7"):
        zone_of(Lattice.square(1.0)).path(6)
    with refusing(GeometryError, "too-few", "bands.points", "at least 9"):
        zone_of(Lattice.rectangular(1.0, 2.0)).path(8)


def test_too_few_points_are_refused_before_anything_is_meshed(monkeypatch):
    monkeypatch.setattr("haptonic.bloch.bands.best_model", lambda *_, **__: pytest.fail("computed"))
    cell = UnitCell(Lattice.oblique(7e-3, 8e-3, 1.3), 1.5e-3, ALUMINIUM)
    with refusing(GeometryError, "too-few", "bands.points", "at least 17"):
        bands_dataset(cell, BandSettings(points=16))


def doubled_area(corners):
    """(m,) signed, of polygons (m, corners, 2)."""
    following = np.roll(corners, -1, axis=-2)
    return (corners[..., 0] * following[..., 1] - corners[..., 1] * following[..., 0]).sum(axis=-1)


@given(lattices(), st.integers(1, 9))
def test_triangles_tile_the_irreducible_zone(lattice, divisions):
    kappa, triangles = zone_of(lattice).triangles(divisions)
    zone = np.pi * np.array([point for _, point in zone_of(lattice).corners])
    assert len(np.unique(np.round(kappa, 9), axis=0)) == len(kappa)
    assert set(triangles.ravel()) == set(range(len(kappa)))
    areas = doubled_area(kappa[triangles])
    assert (areas > 0).all()
    for fan in areas.reshape(-1, divisions**2):  # the triangles that the zone's corners make with its centre
        assert fan == pytest.approx(np.full(len(fan), fan[0]))
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
    kappa, triangles = zone_of(lattice).triangles(3)
    area = 0.5 * doubled_area(kappa[triangles]).sum()
    assert area * len(lattice.point_group) == pytest.approx((2 * np.pi) ** 2)
