"""Tiles against the exact dynamic condensation of their meshes, and against each other."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import scipy.linalg as la
from small import ALUMINIUM, CELL, PITCH, THICKNESS, glued
from whole import placed

from haptonic.cell import MeshPlan, UnitCell
from haptonic.cell.quadrature import lobatto
from haptonic.lattice import Lattice
from haptonic.plate.body import reduction
from haptonic.plate.body.joined_tile import joined_tile, opened_tile
from haptonic.plate.body.reduction import MISSED_BY_BLOCK, block_tile, cell_tile
from haptonic.plate.body.skeleton import TraceOrders, numbered
from haptonic.plate.body.unreduced import BodyOrders, body
from haptonic.plate.layout.grid import Block
from haptonic.superelement import FoldedMesh, dynamic_stiffness
from haptonic.superelement.interior import MISSED
from haptonic.superelement.trace import trace_levels

HZ = 2 * np.pi
ORDERS, HIGHEST = TraceOrders(3, 2), 60e3
PLAIN = UnitCell(Lattice.rectangular(PITCH, 5e-3), THICKNESS, ALUMINIUM)
CELLS = {
    "lattice": (CELL, MeshPlan.suited(CELL, 2, 0), ((PITCH,), (PITCH,))),
    "plain": (PLAIN, replace(MeshPlan.suited(PLAIN, 3, 0), outward=3, upward=3), ((PITCH,), (5e-3,))),
}
X, Y = (0.0, 7e-3, 14e-3), (0.0, 7e-3)
PATCH = replace(glued((7.5e-3, 3.2e-3), (9e-3, 4e-3, 0.7e-3)))


@cache
def single(name, missed=MISSED, highest=HIGHEST):
    return cell_tile(*CELLS[name], ORDERS, highest, missed)


def places(x, y):
    """Points of the trace around a rectangle of tiles."""
    (rim,), points = numbered(
        np.array(x), np.array(y), [Block((0, len(y) - 1), (0, len(x) - 1))], ORDERS.along
    )
    return points[rim]


def rigid_trace(x, y):
    """(trace, 6) translations and rotations."""
    levels = 0.5 * THICKNESS * (1 + lobatto(ORDERS.through)[0])
    around = places(x, y)
    position = np.empty((len(around), len(levels), 3))
    position[..., :2], position[..., 2] = around[:, None], levels
    moves = [np.broadcast_to(axis, position.shape) for axis in np.eye(3)]
    moves += [np.cross(axis, position) for axis in np.eye(3)]
    return np.reshape(moves, (6, -1)).T


@cache
def block(missed=MISSED_BY_BLOCK):
    return block_tile(unreduced(), X, Y, THICKNESS, {"F": point_force()}, ORDERS, HIGHEST, missed=missed)


def point_force():
    """On one node of the flat face, inside."""
    force, points = np.zeros(len(unreduced().mass)), unreduced().points
    nearest = np.linalg.norm(points - [11e-3, 4e-3, 0], axis=1).argmin()
    assert nearest not in unreduced().rim
    force[3 * nearest + 2] = 1.0
    return force


@cache
def unreduced():
    return body(X, Y, THICKNESS, ALUMINIUM, (PATCH,), BodyOrders(3, 2, 1, 2), 8e-3)


@cache
def joined_tiles(missed=MISSED):
    return joined_tile(single("plain"), (PITCH, 5e-3), (2, 3), ORDERS, HIGHEST, missed=missed)


SIZES = {
    "lattice": ([0, PITCH], [0, PITCH]),
    "plain": ([0, PITCH], [0, 5e-3]),
    "block": (X, Y),
    "joined": (PITCH * np.arange(4), 5e-3 * np.arange(3)),
}


def tile_of(name):
    return {"block": block, "joined": joined_tiles}.get(name, lambda: single(name))()


def weight(name):
    (left, *_, right), (low, *_, high) = SIZES[name]
    plate = ALUMINIUM.density * (right - left) * (high - low) * THICKNESS
    if name == "lattice":
        return plate + ALUMINIUM.density * np.pi * CELL.pillar.radius**2 * CELL.pillar.height
    if name == "block":
        glue = PATCH.bond
        return plate + 36e-6 * (glue.thickness * glue.material.density + 0.7e-3 * PATCH.material.density)
    return plate


@pytest.mark.parametrize("name", SIZES)
def test_rigid_motions_cost_nothing_and_carry_the_whole_mass(name):
    tile = tile_of(name)
    fields = np.zeros((tile.size, 6))
    fields[: tile.trace_size] = rigid_trace(*SIZES[name])
    scale = np.abs(tile.elastic).max() * np.abs(fields).max(axis=0)
    for part in tile.stiffness.values():
        assert (np.abs(part @ fields) < 1e-9 * scale).all()
    # a round pillar of elements with four sides a quarter turn each misses its volume by 2e-4
    allowed = 3e-4 if name == "lattice" else 1e-9
    moving = fields.T @ tile.mass @ fields
    assert moving[:3, :3] == pytest.approx(weight(name) * np.eye(3), rel=allowed, abs=1e-9 * weight(name))
    for drive in tile.drive.values():
        work = np.abs(drive) @ np.abs(fields)
        on_rim = [1.0, 4e-3, -11e-3] if drive is tile.drive.get("F") else np.zeros(3)
        assert np.abs((drive @ fields)[2:5] - on_rim).max() < max(1e-9 * work.max(), 1e-3 * on_rim[0])
    assert np.abs(tile.elastic - tile.elastic.T).max() < 1e-9 * np.abs(tile.elastic).max()
    assert la.eigvalsh(tile.elastic, tile.mass)[6] > (HZ * 1e3) ** 2


@pytest.mark.parametrize("name", SIZES)
def test_modes_have_no_trace_unit_mass_and_no_static_coupling(name):
    tile = tile_of(name)
    t = tile.trace_size
    assert np.diag(tile.elastic)[t:] == pytest.approx(tile.values, rel=1e-6)
    scale = np.sqrt(np.diag(tile.elastic))
    coupling = tile.elastic / np.outer(scale, scale)
    assert np.abs(coupling[:t, t:]).max() < 1e-6
    assert coupling[t:, t:] == pytest.approx(np.eye(tile.size - t), abs=1e-6)
    assert tile.mass[t:, t:] == pytest.approx(np.eye(tile.size - t), abs=1e-6)


def missed_energy(exact, ours, static):
    """Largest share of the static energy of any trace by which two dynamic stiffnesses differ."""
    shift = 1e-3 * np.trace(static) / len(static)  # rigid motions have none
    return np.abs(la.eigvalsh(ours - exact, static + shift * np.eye(len(static)))).max()


@pytest.mark.parametrize("name", CELLS)
def test_a_single_tile_has_the_dynamic_stiffness_of_its_mesh(name):
    cell, plan, steps = CELLS[name]
    shared = FoldedMesh.of(cell, plan)
    onto = reduction._onto_rim(plan, steps, shared.levels, ORDERS)
    errors = []
    for missed in (1e-1, 1e-2, 1e-3):
        tile = single(name, missed)
        worst = 0.0
        for frequency in (11e3, 37e3, 60e3):
            exact = onto.T @ dynamic_stiffness(shared, HZ * frequency).matrix @ onto
            ours = tile.dynamic((HZ * frequency) ** 2).on_trace
            worst = max(worst, missed_energy(exact, ours, tile.elastic[: len(exact), : len(exact)]))
        errors.append(worst)
    assert errors[1] < {"lattice": 5e-4, "plain": 1e-4}[name]
    assert errors[1] < errors[0] / 20
    assert errors[2] < min(errors[1] / 3, 2e-5)


def test_a_block_has_the_dynamic_stiffness_and_the_drives_of_its_body():
    whole = unreduced()
    K, M = sum(whole.stiffness.values()).toarray(), np.diag(whole.mass)
    onto = reduction._rim_of_body(whole, X, Y, THICKNESS, ORDERS)
    rim = (3 * whole.rim[:, None] + np.arange(3)).ravel()
    inner = np.setdiff1d(np.arange(len(K)), rim)
    errors = []
    for missed in (3e-2, 1e-3):
        tile, worst = block(missed), 0.0
        t = tile.trace_size
        for frequency in (13e3, 35e3, 60e3):
            Z = K - (HZ * frequency) ** 2 * M
            follow = np.linalg.solve(Z[np.ix_(inner, inner)], Z[np.ix_(inner, rim)] @ onto)
            exact = onto.T @ Z[np.ix_(rim, rim)] @ onto - (Z[np.ix_(inner, rim)] @ onto).T @ follow
            left = tile.dynamic((HZ * frequency) ** 2)
            worst = max(worst, missed_energy(exact, left.on_trace, tile.elastic[:t, :t]))
            for name in ("A", "F"):
                load = {**whole.drive, "F": point_force()}[name]
                felt = onto.T @ load[rim] - follow.T @ load[inner]
                drive = tile.drive[name][:t] + left.follow.T @ tile.drive[name][t:]
                assert np.linalg.norm(drive - felt) < max(1e-4, 3 * missed) * np.linalg.norm(felt)
                own = load[inner] @ np.linalg.solve(Z[np.ix_(inner, inner)], load[inner])
                ours_own = (tile.drive[name][t:] ** 2 / (tile.values - (HZ * frequency) ** 2)).sum()
                assert ours_own == pytest.approx(own, rel=max(1e-4, 10 * missed))
        errors.append(worst)
    assert errors[1] < 1e-4
    assert errors[1] < errors[0]


def test_joined_tiles_have_the_dynamic_stiffness_of_the_single_ones_together():
    tile, x, y = single("plain"), *SIZES["joined"]
    blocks = [Block((i, i + 1), (j, j + 1)) for i in range(2) for j in range(3)]
    (outer, *rims), points = numbered(
        np.array(x), np.array(y), [Block((0, 2), (0, 3)), *blocks], ORDERS.along
    )
    per_node, modes = ORDERS.per_node, len(tile.values)
    size = len(points) * per_node + 6 * modes
    K, M = np.zeros((2, size, size))
    for k, rim in enumerate(rims):
        own = np.concatenate([
            (rim[:, None] * per_node + np.arange(per_node)).ravel(),
            len(points) * per_node + k * modes + np.arange(modes),
        ])  # fmt: skip
        placed(size, tile.elastic, own, K)
        placed(size, tile.mass, own, M)
    held = (outer[:, None] * per_node + np.arange(per_node)).ravel()
    inner = np.setdiff1d(np.arange(size), held)
    errors = []
    for missed in (1e-1, 1e-2):
        whole, worst = joined_tiles(missed), 0.0
        for frequency in (11e3, 37e3, 60e3):
            Z = K - (HZ * frequency) ** 2 * M
            coupling = Z[np.ix_(inner, held)]
            exact = Z[np.ix_(held, held)] - coupling.T @ np.linalg.solve(Z[np.ix_(inner, inner)], coupling)
            ours = whole.dynamic((HZ * frequency) ** 2).on_trace
            t = whole.trace_size
            worst = max(worst, missed_energy(exact, ours, whole.elastic[:t, :t]))
        errors.append(worst)
    assert errors[1] < 1e-3
    assert errors[1] < errors[0]


@pytest.mark.parametrize("name", CELLS)
def test_tiles_joined_twice_are_those_joined_once(name):
    """Two by two of two by two have the free waves of four by four, and move the same points alike."""
    size = SIZES[name][0][1], SIZES[name][1][1]
    four = joined_tile(single(name), size, (2, 2), ORDERS, HIGHEST)
    twice = joined_tile(four, (2 * size[0], 2 * size[1]), (2, 2), ORDERS, HIGHEST, (2, 2))
    once = joined_tile(single(name), size, (4, 4), ORDERS, HIGHEST)
    solved = [la.eigh(tile.elastic, tile.mass, subset_by_index=[6, 17]) for tile in (twice, once)]
    (values, modes), (others, meant) = solved
    assert np.sqrt(values) == pytest.approx(np.sqrt(others), rel=1e-4)
    assert np.sqrt(others[-1]) > 0.1 * HZ * HIGHEST
    where = np.random.default_rng(9).uniform(0, 4, (40, 2)) * size
    ours, theirs = twice.inside.normal_at(where) @ modes, once.inside.normal_at(where) @ meant
    fit = np.linalg.lstsq(theirs, ours, rcond=None)[
        0
    ]  # equal but for signs and turns among equal frequencies
    assert theirs @ fit == pytest.approx(ours, abs=1e-2 * np.abs(ours).max())


def test_an_opened_tile_answers_the_rest_of_its_trace_as_the_closed_one():
    """What is condensed into it moves freely; a motion of the rest is followed, and lifted, alike."""
    closed = joined_tiles(1e-3)
    t = closed.trace_size
    gone = np.arange(t // 3, t // 2)
    kept = np.setdiff1d(np.arange(t), gone)
    tile = opened_tile(closed, gone, HIGHEST, 1e-3)
    assert tile.trace_size == len(kept)
    inner = np.setdiff1d(np.arange(closed.size), kept)
    where = np.random.default_rng(7).uniform(0, 1, (9, 2)) * [3 * PITCH, 1e-2]
    worst, motion = 0.0, np.random.default_rng(8).standard_normal((len(kept), 3))
    for frequency in (11e3, 37e3, 60e3):
        omega = HZ * frequency
        Z = closed.elastic - omega**2 * closed.mass
        follow = -np.linalg.solve(Z[np.ix_(inner, inner)], Z[np.ix_(inner, kept)])
        exact = Z[np.ix_(kept, kept)] + Z[np.ix_(kept, inner)] @ follow
        ours = tile.dynamic(omega**2)
        worst = max(worst, missed_energy(exact, ours.on_trace, tile.elastic[: len(kept), : len(kept)]))
        whole = np.zeros((closed.size, 3))
        whole[kept], whole[inner] = motion, follow @ motion
        seen = tile.inside.normal_at(where) @ np.vstack([motion, ours.follow @ motion])
        assert seen == pytest.approx(closed.inside.normal_at(where) @ whole, rel=2e-2, abs=2e-2)
    assert worst < 1e-4


@cache
@pytest.mark.parametrize("name", SIZES)
def test_normal_motion_of_the_flat_face(name):
    """Of rigid motions, exact; of plate bending with a quadratic w, that shear-free plates follow closely."""
    tile, (x, y) = tile_of(name), SIZES[name]
    fields = np.zeros((tile.size, 6))
    fields[: tile.trace_size] = rigid_trace(x, y)
    where = np.random.default_rng(5).uniform(0, 1, (30, 2)) * [x[-1], y[-1]]
    where[:4] = [(0, 0), (x[-1], 0), (0, y[-1]), (x[-1], y[-1])]
    seen = tile.inside.normal_at(where) @ fields
    across, up = where.T
    expected = np.stack([0 * across, 0 * across, 1 + 0 * across, up, -across, 0 * across], axis=-1)
    assert seen == pytest.approx(expected, abs=1e-9)
    lifted = tile.inside.lifted(fields)
    points = tile.inside.points
    assert lifted[:, :, 2] == pytest.approx(np.broadcast_to([0.0, 0, 1], points.shape), abs=1e-9)
    assert lifted[:, :, 4] == pytest.approx(np.cross([0.0, 1, 0], points), abs=1e-9)


@pytest.mark.parametrize("name", ["plain", "joined"])
def test_pure_bending_of_plain_tiles(name):
    """Exact 3D: u = z' x / R in the plane, w = -(x^2 - nu z'^2 + ...) / 2 R under bending moments alone."""
    tile, (x, y) = tile_of(name), SIZES[name]
    levels = 0.5 * THICKNESS * (1 + lobatto(ORDERS.through)[0])
    around, nu = places(x, y), ALUMINIUM.poisson_ratio

    def field(px, py, pz):
        z = pz - THICKNESS / 2
        return np.stack([px * z, -nu * py * z, -0.5 * px**2 + 0.5 * nu * (py**2 - z**2)], axis=-1)

    trace = np.zeros(tile.size)
    trace[: tile.trace_size] = field(
        around[:, :1], around[:, 1:], np.broadcast_to(levels, (len(around), len(levels)))
    ).ravel()
    energy = trace @ tile.elastic @ trace
    volume = x[-1] * y[-1] * THICKNESS**3 / 12
    # not to rounding: the elements have curved sides
    assert energy == pytest.approx(ALUMINIUM.youngs_modulus * volume, rel=1e-5)
    where = np.random.default_rng(6).uniform(0, 1, (20, 2)) * [x[-1], y[-1]]
    assert tile.inside.normal_at(where) @ trace == pytest.approx(
        field(*where.T, np.zeros(20))[:, 2], abs=3e-5 * x[-1] ** 2
    )


@pytest.mark.parametrize("order", [2, 4])
def test_at_the_order_of_its_mesh_a_plate_has_the_unknowns_of_bands(order):
    """A trace of bands is a polynomial along each edge and through the thickness too, in another order."""
    plan = MeshPlan.suited(CELL, order, 1)
    levels, places = trace_levels(plan), FoldedMesh.of(CELL, plan).mesh.topology.rim.shape[1]
    onto = reduction._onto_rim(plan, ((PITCH,), (PITCH,)), levels, TraceOrders(places // 4, levels - 1))
    places_of = np.eye(len(onto))[np.abs(onto).argmax(axis=0)].T
    assert places_of.sum(axis=1) == pytest.approx(1)
    assert onto == pytest.approx(places_of, abs=1e-12)
