"""Places on the lines between tiles: numbers, orientation, and the polynomials that they carry."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from numpy.polynomial.legendre import leggauss
from small import drawn

from haptonic.plate.body.foundations import _products
from haptonic.plate.body.skeleton import Skeleton, TraceOrders, edge_fields, rim_fields
from haptonic.plate.layout.grid import Block

UNEVEN_X, UNEVEN_Y = np.array([0, 5e-3, 12e-3, 21e-3]), np.array([0, 4e-3, 11e-3, 14e-3])
MAPS = {
    "full": "ppp ppp ppp",
    "L": "p.. p.. ppp",
    "ring": "ppp p.p ppp",
    "diagonal": "p.. .p. ..p",  # pieces that touch at corners
}


def tiles(layout):
    every = [Block((i, i + 1), (j, j + 1)) for i, j in np.ndindex(layout.rows, layout.columns)]
    return [block for block in every if layout.at(block.tiles[0])]


def skeleton_of(name, order=3, blocks=None):
    layout = drawn(MAPS[name], UNEVEN_X, UNEVEN_Y)
    return Skeleton.of(layout, blocks or tiles(layout), TraceOrders(order, 2))


def corners(places, block):
    layout = places.layout
    (low, high), (left, right) = block.rows, block.columns
    x, y = layout.x, layout.y
    return np.array([(x[left], y[low]), (x[right], y[low]), (x[right], y[high]), (x[left], y[high])])


@pytest.mark.parametrize("name", MAPS)
@pytest.mark.parametrize("order", [1, 2, 4])
def test_rims_run_anticlockwise_around_their_block_from_the_lower_left(name, order):
    places = skeleton_of(name, order)
    for block, rim in zip(places.blocks, places.rims, strict=True):
        assert len(rim) == len(set(rim)) == block.edges * order
        points = places.points[rim]
        turning = corners(places, block)
        assert points[::order] == pytest.approx(turning, abs=1e-15)
        following = np.roll(points, -1, axis=0)
        area = 0.5 * (points[:, 0] * following[:, 1] - points[:, 1] * following[:, 0]).sum()
        assert area == pytest.approx(np.prod(turning[2] - turning[0]))
        # on its border, and along each edge on the points of the quadrature
        inside = ((points > turning[0] + 1e-12) & (points < turning[2] - 1e-12)).all(axis=1)
        assert not inside.any()


@pytest.mark.parametrize("name", MAPS)
def test_a_place_has_one_number_and_every_number_a_place(name):
    places = skeleton_of(name)
    assert np.array_equal(np.unique(np.concatenate(places.rims)), np.arange(len(places.points)))
    distance = np.linalg.norm(places.points[:, None] - places.points, axis=-1)
    assert (distance[~np.eye(len(distance), dtype=bool)] > 1e-4).all(), "no place is there twice"
    assert places.size == 9 * len(places.points)


def test_a_large_block_has_no_places_within_and_those_of_its_neighbours_around():
    large = [Block((0, 2), (0, 2)), Block((0, 1), (2, 3)), Block((1, 2), (2, 3)), Block((2, 3), (0, 3))]
    places, small = skeleton_of("full", blocks=large), skeleton_of("full")
    rim = places.points[places.rims[0]]
    assert len(rim) == 8 * 3
    inside = ((places.points > 1e-9) & (places.points < [12e-3 - 1e-9, 11e-3 - 1e-9])).all(axis=1)
    assert not inside.any()
    known = {tuple(row) for row in small.points.round(12)}
    assert {tuple(row) for row in places.points.round(12)} < known


def test_unknowns_are_ordered_by_place_level_and_component():
    places = skeleton_of("L")
    assert list(places.unknowns(np.array([4, 0]))) == [*range(36, 45), *range(9)]


@pytest.mark.parametrize(
    ("name", "count"), [("full", 12), ("L", 12), ("ring", 16), ("diagonal", 12)], ids=lambda value: str(value)
)
def test_outer_edges_are_those_with_nothing_beyond(name, count):
    places = skeleton_of(name)
    layout, edges = places.layout, places.outer_edges
    assert len(edges) == count
    for edge in edges:
        points = places.points[edge.nodes]
        assert tuple(points[0]) == edge.start
        assert tuple(points[-1]) == edge.end
        assert (np.diff(points, axis=0).sum(axis=1) > 0).all(), "from left to right, from low to high"
        assert edge.length == pytest.approx(np.abs(points[-1] - points[0]).sum())
        outward = {"left": (-1, 0), "right": (1, 0), "bottom": (0, -1), "top": (0, 1)}[edge.side]
        for sign, there in ((-1, True), (1, False)):
            x, y = points.mean(axis=0) + sign * 1e-4 * np.array(outward)
            column, row = np.searchsorted(layout.x, x) - 1, np.searchsorted(layout.y, y) - 1
            assert (layout.at((int(row), int(column))) is not None) is there
    around = sum(np.array(edge.length) * (1 if edge.side in ("left", "bottom") else -1) for edge in edges)
    assert around == pytest.approx(0, abs=1e-12), "as much looks one way as the other"


@settings(max_examples=25)
@given(st.integers(1, 4), st.integers(1, 3), st.sampled_from([4, 6, 10]), st.integers(0, 10_000))
def test_traces_reproduce_polynomials_on_every_edge(along, through, edges, seed):
    """Continuous around the rim, of the orders of the trace on each edge and through the thickness."""
    random = np.random.default_rng(seed)
    orders = TraceOrders(along, through)
    where, height = random.uniform(0, edges, 40), random.uniform(0, 1, 40)
    where[:3], height[:2] = (0.0, edges, 2.0), (0.0, 1.0)
    fields = rim_fields(edges, orders, where, height).reshape(40, 3, -1, 3)
    weights = fields[:, 0, :, 0]
    assert np.array_equal(fields, weights[:, None, :, None] * np.eye(3)[:, None]), "each component by itself"
    assert weights.sum(axis=1) == pytest.approx(1.0)
    # an angle around the rim makes smooth data; on each edge it is replaced by its interpolating polynomial
    levels, ends = random.normal(size=through + 1), random.normal(size=(edges, along))

    def field(position, up):
        position = position % edges
        edge = np.minimum(position.astype(int), edges - 1)
        local = position - edge
        first, last = ends[edge, 0], ends[(edge + 1) % edges, 0]
        bubble = sum(
            ends[edge, power] * local**power * (1 - local) for power in range(1, along)
        ) if along > 1 else 0.0  # fmt: skip
        return (first * (1 - local) + last * local + bubble) * np.polyval(levels, up)

    share = 0.5 * (1 + _lobatto(along)[:-1])
    nodes = (np.arange(edges)[:, None] + share).ravel()
    heights = 0.5 * (1 + _lobatto(through))
    values = field(np.repeat(nodes, through + 1), np.tile(heights, len(nodes)))
    assert weights @ values == pytest.approx(field(where, height), abs=1e-10)


def _lobatto(order):
    """Ends, and extrema of the Legendre polynomial."""
    inner = np.polynomial.legendre.Legendre.basis(order).deriv().roots()
    return np.concatenate([[-1.0], np.sort(inner.real), [1.0]])


def test_places_lie_on_the_points_of_the_quadrature():
    places = skeleton_of("full", 4)
    bottom = places.points[places.rims[0][:5]]
    assert bottom[:, 0] == pytest.approx(5e-3 * 0.5 * (1 + _lobatto(4)))
    assert (bottom[:, 1] == 0).all()


def _lagrange(order, at):
    """(n, order + 1) values on [0, 1] from the roots of the polynomials."""
    nodes = 0.5 * (1 + _lobatto(order))
    shapes = [np.poly(np.delete(nodes, k)) for k in range(order + 1)]
    return np.stack(
        [np.polyval(shape, at) / np.polyval(shape, node) for shape, node in zip(shapes, nodes, strict=True)],
        axis=-1,
    )


def _edge(share, height, shear):
    """(n, 3, unknowns) displacement on an edge of orders 3 and 2, with a further profile of order shear."""
    main = np.einsum("na,nl->nal", _lagrange(3, share), _lagrange(2, height)).reshape(len(share), -1)
    both = [np.einsum("nm,ck->ncmk", main, np.eye(3)).reshape(len(share), 3, -1)]
    if shear:
        z = 2 * height - 1
        further = _lagrange(shear, share) * (3 * z * (1 - z**2))[:, None]
        both.append(np.einsum("nm,ck->ncmk", further, np.eye(3)[:, :2]).reshape(len(share), 3, -1))
    return np.concatenate(both, axis=-1)


@given(st.floats(0, 1), st.floats(0, 1), st.sampled_from([0, 1, 2]))
def test_products_of_polynomials_are_integrated_exactly(first, second, shear):
    low, high = min(first, second), max(first, second)
    orders = TraceOrders(3, 2, shear)
    points, weights = leggauss(12)
    points, weights = 0.5 * (1 + points), 0.5 * weights
    share, height = (a.ravel() for a in np.meshgrid(low + (high - low) * points, points, indexing="ij"))
    fields = _edge(share, height, shear)
    assert edge_fields(orders, share, height) == pytest.approx(fields.reshape(3 * len(share), -1), abs=1e-10)
    area = (high - low) * np.outer(weights, weights).ravel()
    exact = np.einsum("ncm,n,nck->mk", fields, area, fields)
    assert _products(orders, low, high) == pytest.approx(exact, abs=1e-12)


@given(st.sampled_from([1, 2, 3]), st.integers(0, 10_000))
def test_the_further_profile_is_shared_by_neighbours_and_moves_in_the_plane_only(shear, seed):
    """Along every edge of a rim it is the polynomial on that edge alone, from whichever side it is seen."""
    layout = drawn("pp pp")
    orders = TraceOrders(3, 2, shear)
    places = Skeleton.of(layout, tiles(layout), orders)
    rims = Skeleton.of(layout, tiles(layout), TraceOrders(shear, 1)).points
    assert places.size == 9 * len(places.points) + 2 * len(rims)
    random = np.random.default_rng(seed)
    values = random.normal(size=places.size)
    share, height = random.uniform(0, 1, (2, 20))
    seen = {}
    for trace, block in zip(places.traces, places.blocks, strict=True):
        assert len(set(trace)) == len(trace) == 4 * (27 + 2 * shear)
        for k in range(4):
            there = share if k < 2 else 1 - share  # anticlockwise: top and left run the other way
            field = rim_fields(4, orders, k + there, height) @ values[trace]
            key = tuple(np.round(corners(places, block)[[k, (k + 1) % 4]].mean(axis=0), 9))
            seen.setdefault(key, []).append(field)
    assert sorted(len(fields) for fields in seen.values()) == [1] * 8 + [2] * 4
    for first, *others in seen.values():
        assert all(other == pytest.approx(first, abs=1e-12) for other in others)
    values[: 9 * len(places.points)] = 0.0
    moved = (rim_fields(4, orders, 4 * share, height) @ values[places.traces[0]]).reshape(-1, 3)
    assert np.abs(moved[:, :2]).max() > 0
    assert (moved[:, 2] == 0).all()
    levels = np.array([0.0, 0.5, 1.0])
    assert rim_fields(4, orders, np.full(3, 0.3), levels) @ values[places.traces[0]] == pytest.approx(0)
    edge = places.outer_edges[0]
    along = edge_fields(orders, share, height) @ values[edge.unknowns]
    assert along == pytest.approx(rim_fields(4, orders, share, height) @ values[places.traces[0]], abs=1e-12)


def test_what_a_block_has_for_itself_no_other_touches():
    layout = drawn("ppp ppp")
    places = Skeleton.of(layout, [Block((0, 2), (0, 1)), Block((0, 2), (1, 3))], TraceOrders(3, 2, 2))
    left, right = places.alone(np.array([places.traces[0][0]]), [])
    assert not set(places.traces[0][left]) & set(places.traces[1])
    assert set(places.traces[0]) - set(places.traces[0][left]) == {
        *places.traces[1], places.traces[0][0]
    } & set(places.traces[0])  # fmt: skip
    assert len(right) == len(places.traces[1]) - len(set(places.traces[0]) & set(places.traces[1]))
    assert [len(numbers) for numbers in places.alone(np.zeros(0, int), places.blocks[:1])] == [0, len(right)]


def test_blocks_meet_only_where_they_share_a_tile():
    block = Block((0, 2), (0, 2))
    assert block.meets(Block((1, 3), (1, 3)))
    assert not block.meets(Block((2, 3), (0, 2)))
    assert not block.meets(Block((0, 2), (2, 3)))
    assert block.joined(Block((3, 4), (0, 1))) == Block((0, 4), (0, 2))
    assert Block((1, 3), (0, 1)).tiles == [(1, 0), (2, 0)]
