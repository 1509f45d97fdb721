"""The assembled plate against dense matrices, and its supports against closed forms."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import scipy.linalg as la
from hypothesis import given, settings, strategies as st
from small import ALUMINIUM, COARSE, PITCH, THICKNESS, busy_plate, drawn, plain_plate
from whole import answered, forms, foundations, lossless

from haptonic.cell.quadrature import lobatto
from haptonic.plate.body.foundations import CLAMPED, supported
from haptonic.plate.body.model import PlateModel
from haptonic.plate.body.skeleton import Skeleton, TraceOrders
from haptonic.plate.layout.grid import Block
from haptonic.plate.layout.parts import Force, Plate
from haptonic.plate.layout.supports import Support

HZ = 2 * np.pi


@cache
def busy():
    return PlateModel.of(busy_plate(), 40e3, COARSE)


@cache
def dense():
    return lossless(busy())


@cache
def eigenvalues():
    return la.eigh(*dense(), eigvals_only=True)


def random(columns, seed=0):
    return np.random.default_rng(seed).standard_normal((busy().assembly.size, columns))


def test_products_are_those_of_the_whole_matrices():
    K, M = dense()
    vectors = random(70)  # more than one share of columns
    assert busy().assembly.mass_times(vectors) == pytest.approx(M @ vectors, abs=1e-12 * np.abs(M).max())
    expected = K @ vectors
    assert np.abs(busy().assembly.stiffness_times(vectors) - expected).max() < 1e-12 * np.abs(expected).max()


@settings(max_examples=4)
@given(st.floats(0.0, 60e3))
def test_solutions_and_counts_at_any_shift(frequency):
    K, M = dense()
    shift = (HZ * frequency) ** 2
    shifted = busy().assembly.shifted(shift)
    assert shifted.below == (eigenvalues() < shift).sum()
    right = random(3, 1)
    solution = shifted.solve(right)
    rest = (K - shift * M) @ solution - right
    assert np.abs(rest).max() < 1e-8 * (np.abs(K) @ np.abs(solution)).max()
    assert np.linalg.norm(solution - np.linalg.solve(K - shift * M, right)) < 1e-5 * np.linalg.norm(solution)


def test_a_shift_between_two_modes_of_a_tile_counts_them():
    """Above the tiles' own modes with the rim at rest, whose signs the skeleton does not see."""
    highest = max(group.tile.values.max() for group in busy().assembly.groups)
    shift = 1.01 * highest
    assert busy().assembly.shifted(shift).below == (eigenvalues() < shift).sum()


# -- supports ---------------------------------------------------------------------------------------


def rigid(skeleton):
    """(size, 6) translations and rotations on all unknowns of a skeleton; further profiles are at rest."""
    levels = 0.5 * skeleton.layout.thickness * (1 + lobatto(skeleton.orders.through)[0])
    position = np.empty((len(skeleton.points), len(levels), 3))
    position[..., :2] = skeleton.points[:, None]
    position[..., 2] = levels
    moves = [np.broadcast_to(axis, position.shape) for axis in np.eye(3)]
    moves += [np.cross(axis, position) for axis in np.eye(3)]
    moves = np.reshape(moves, (6, -1)).T
    return np.vstack([moves, np.zeros((skeleton.size - len(moves), 6))])


def skeleton(text="ppp pp.", shear=0):
    layout = drawn(text)
    tiles = [Block((i, i + 1), (j, j + 1)) for i, j in np.ndindex(layout.rows, layout.columns)]
    return Skeleton.of(
        layout, [block for block in tiles if layout.at(block.tiles[0])], TraceOrders(3, 2, shear)
    )


@pytest.mark.parametrize("shear", [0, 2])
@pytest.mark.parametrize(("where", "edges"), [("left", 2), ("right", 2), ("top", 3), ("bottom", 3)])
def test_springs_store_what_a_rigid_motion_takes(where, edges, shear):
    """An edge of the L that looks to a side counts, on the rim of the map or not."""
    places = skeleton(shear=shear)
    held, (foundation,) = supported(places, [Support(where, "spring", stiffness=3e9, loss_factor=0.1)])
    area = edges * PITCH * THICKNESS
    assert not len(held)
    assert foundation.loss_factor == 0.1
    moves = rigid(places)
    energy = moves.T @ (foundation.stiffness @ moves)
    assert energy[:3, :3] == pytest.approx(3e9 * area * np.eye(3), abs=1e-6 * 3e9 * area)
    # turned about the x axis by one radian: z and y squared over the faces
    faces = [edge for edge in places.outer_edges if edge.side == where]
    assert len(faces) == edges
    squared = sum(_integral(edge, 1) for edge in faces) * THICKNESS + THICKNESS**3 / 3 * edges * PITCH
    assert energy[3, 3] == pytest.approx(3e9 * squared, rel=1e-9)


def _integral(edge, axis):
    """Integral of the square of a coordinate along an edge."""
    a, b = edge.start[axis], edge.end[axis]
    return edge.length * (a * a + a * b + b * b) / 3


def test_corners_are_held_on_their_length_from_the_corners_of_the_map():
    places = skeleton()
    moves = rigid(places)
    held, (foundation,) = supported(places, [Support("corners", "spring", length=3e-3, stiffness=1e9)])
    assert not len(held)
    # the L has three corners of the map, each with two edges
    expected = 1e9 * 6 * 3e-3 * THICKNESS
    assert moves[:, 2] @ foundation.stiffness @ moves[:, 2] == pytest.approx(expected, rel=1e-9)
    touched = np.flatnonzero(np.diff(foundation.stiffness.indptr))
    points = places.points[np.unique(touched // places.orders.per_node)]
    ends = np.array([(x, y) for x in (0, 3 * PITCH) for y in (0, 2 * PITCH)])
    assert (np.abs(points[:, None] - ends).sum(-1).min(1) <= PITCH + 1e-9).all()
    _, (clamp,) = supported(places, [Support("corners", "clamped", length=3e-3)])
    stiff = CLAMPED * ALUMINIUM.stiffness[0, 0] / THICKNESS
    assert clamp.stiffness.toarray() == pytest.approx(foundation.stiffness.toarray() * stiff / 1e9)


def test_a_corner_may_be_held_across_several_tiles():
    places = skeleton("ppp ppp ppp")
    length = 1.4 * PITCH
    held, (foundation,) = supported(places, [Support("corners", "spring", length=length, stiffness=1e9)])
    assert not len(held)
    energy = rigid(places).T @ (foundation.stiffness @ rigid(places))
    assert energy[2, 2] == pytest.approx(1e9 * 8 * length * THICKNESS, rel=1e-9)
    # turned about the x axis: y squared and z squared over the held faces
    end, start = 3 * PITCH, 3 * PITCH - length
    squared = (2 * end**2 * length + 2 * length**3 / 3 + 2 * (end**3 - start**3) / 3) * THICKNESS
    assert energy[3, 3] == pytest.approx(1e9 * (squared + 8 * length * THICKNESS**3 / 3), rel=1e-9)


def test_a_corner_as_long_as_its_edge_is_held_for_good():
    places = skeleton()
    held, beds_found = supported(places, [Support("corners", "clamped", length=PITCH)])
    assert not beds_found
    points = {tuple(np.round(places.points[k // places.orders.per_node] / PITCH, 6)) for k in held}
    assert {(0.0, 0.0), (0.0, 2.0), (3.0, 2.0)} <= points
    assert {(1.0, 0.0), (0.0, 1.0), (1.0, 2.0), (2.0, 2.0), (3.0, 1.0)} <= points
    assert not {(2.0, 0.0), (2.0, 1.0), (1.0, 1.0)} & points
    assert len(points) == 20  # of three runs around a corner, two edges of order 3 each: 7, 7 and 6 more


def test_clamped_edges_rest_and_simple_ones_move_normal_to_their_face():
    places = skeleton("pp pp")
    per_node = places.orders.per_node
    for where, axis, end in (("left", 0, 0.0), ("top", 1, 2 * PITCH)):
        on_edge = np.flatnonzero(np.abs(places.points[:, axis] - end) < 1e-12)
        clamped, _ = supported(places, [Support(where, "clamped")])
        assert np.array_equal(clamped, np.sort(places.unknowns(on_edge)))
        simple, _ = supported(places, [Support(where, "simple")])
        assert np.array_equal(simple, clamped[clamped % per_node % 3 != axis])


def test_a_clamp_holds_the_further_profile_and_a_simple_support_that_along_the_face():
    places = skeleton("pp pp", shear=2)
    first = 9 * len(places.points)
    clamped, simple = (supported(places, [Support("left", hold)])[0] for hold in ("clamped", "simple"))
    further = clamped[clamped >= first]
    assert len(further) == 2 * (2 * 2 + 1)
    assert np.array_equal(simple[simple >= first], further[(further - first) % 2 == 1])
    held, (foundation,) = supported(places, [Support("left", "spring", stiffness=2e9)])
    assert not len(held)
    along = np.zeros(places.size)
    along[further[(further - first) % 2 == 0]] = 1.0  # the profile 3 z (1 - z^2), whose mean square is 24/35
    assert along @ foundation.stiffness @ along == pytest.approx(
        2e9 * 2 * PITCH * THICKNESS * 24 / 35, rel=1e-12
    )


def test_a_plate_has_the_free_motions_that_its_supports_leave():
    cases = {
        (): 6,
        (Support("left", "simple"),): 3,  # along x, and turns about y and z that only tilt the face
        (Support("left", "simple"), Support("bottom", "simple")): 1,  # the turn about their common corner
        (Support("left", "simple"), Support("right", "simple")): 1,
        (Support("left", "simple"), Support("bottom", "simple"), Support("top", "simple")): 0,
        (Support("left", "clamped"),): 0,
        (Support("right", "spring", stiffness=1e9),): 0,
    }
    for supports, count in cases.items():
        plate = plain_plate(1, 2, supports=supports)
        assert plate.rigid_modes == count
        values = la.eigh(*lossless(PlateModel.of(plate, 40e3, COARSE)), eigvals_only=True)
        assert (np.abs(values[:count]) < 1e-6 * values[count]).all()
        assert values[count] > (HZ * 20) ** 2  # the foundation is soft


def test_separate_beds_of_one_model_add_to_the_stiffness():
    model = busy()
    stiffness, _ = forms(model.assembly)
    K, _ = dense()
    assert pytest.approx(sum(stiffness.values()) + sum(foundations(model))) == K
    soft = replace(busy_plate(), supports=(Support("right", "clamped"),))
    bare = lossless(PlateModel.of(soft, 40e3, COARSE))[0]
    assert np.linalg.norm(K - bare) > 1e-3 * np.linalg.norm(bare[:50])


def test_free_edges_that_are_condensed_into_their_tiles_change_no_mode():
    """A notch, a force, springs and a clamp: what they touch stays, the rest of the outer edges goes."""
    supports = (Support("left", "spring", stiffness=3e11), Support("corners", "clamped", length=2e-3))
    plate = plain_plate(4, 5, supports=supports, forces=(Force("F", (30e-3, 10e-3), None),))
    closed = PlateModel.of(plate, 40e3, COARSE)
    opened = PlateModel.of(plate, 40e3, COARSE, open_from=0)
    assert opened.assembly.free < closed.assembly.free - 100
    for foundation, other in zip(opened.foundations, closed.foundations, strict=True):
        assert np.array_equal(np.sort(foundation.stiffness.data), np.sort(other.stiffness.data))
    of_closed, of_opened = (
        la.eigh(*lossless(model), eigvals_only=True, subset_by_value=(0, (HZ * 40e3) ** 2))
        for model in (closed, opened)
    )
    assert len(of_closed) == len(of_opened) > 10
    assert np.sqrt(of_opened) == pytest.approx(np.sqrt(of_closed), rel=1e-4)
    where = np.array([[1e-3, 1e-3], [34e-3, 27e-3], [30e-3, 10e-3]])
    omega = HZ * 17.8e3
    seen = [model.observed(where) @ answered(model, {"F": 1.0}, [omega]) for model in (closed, opened)]
    assert seen[1] == pytest.approx(seen[0], rel=1e-3)


def test_a_solver_that_is_released_serves_the_next_shift():
    assembly = busy().assembly
    first = assembly.shifted((HZ * 9e3) ** 2)
    right = np.random.default_rng(4).standard_normal((assembly.size, 2))
    solution = first.solve(right)
    first.release()
    second = assembly.shifted((HZ * 23e3) ** 2)
    assert second.solver is first.solver
    assert assembly.shifted((HZ * 9e3) ** 2).solver is not second.solver, "one that is in use stays so"
    second.release()
    again = assembly.shifted((HZ * 9e3) ** 2)
    assert again.solve(right) == pytest.approx(solution, rel=1e-9, abs=1e-9 * np.abs(solution).max())


def test_holes_and_notches_leave_gaps_in_the_numbers_of_no_one():
    plate = Plate(drawn("ppp p.p ppp"))
    model = PlateModel.of(plate, 40e3, COARSE)
    assert np.array_equal(np.sort(model.assembly.number), np.arange(model.assembly.free))
    values = la.eigh(*lossless(model), eigvals_only=True)
    assert (np.abs(values[:6]) < 1e-6 * values[6]).all()
    weight = ALUMINIUM.density * 8 * PITCH**2 * THICKNESS
    skeleton_part = np.zeros((model.assembly.size, 6))
    skeleton_part[: model.assembly.free] = rigid(model.assembly.skeleton)
    mass = skeleton_part.T @ model.assembly.mass_times(skeleton_part)
    assert mass[:3, :3] == pytest.approx(weight * np.eye(3), abs=1e-6 * weight)
    assert np.abs(model.assembly.stiffness_times(skeleton_part)).max() < 1e-4 * 70e9 * THICKNESS * PITCH
