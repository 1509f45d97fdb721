"""Traces on few pieces of each side and few levels, against those on all nodes or more levels."""

import sys
from dataclasses import replace

import numpy as np
import pytest
from strategies import ALUMINIUM

from daily import daily
from haptonic.bloch import BlochModel, Resolution
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.layers import Interface
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.bloch.plate_waves import FAMILIES
from haptonic.bloch.rows import CondensedRows
from haptonic.cell import Disc, MeshPlan, Pillar, Site, UnitCell
from haptonic.cell.mesh import along_rim, side_shares, trace_shares
from haptonic.cell.orders import trace_error
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.superelement import Tiling

MM = 1e-3
SQUARE, TRIANGULAR = Lattice.square(7 * MM), Lattice.triangular(7 * MM)
KAPPA = np.pi * np.array([(0.35, 0.73), (1.0, 0.0), (0.13, -0.83)])


def hole(section, wide, radius, arm_width=None, **further):
    return Disc(
        wide * MM, section=section, corner_radius=radius and radius * MM,
        arm_width=arm_width and arm_width * MM, empty=True, **further,
    )  # fmt: skip


def cell(lattice, *discs, thickness=1.5):
    return UnitCell(lattice, thickness * MM, ALUMINIUM, disc=discs)


CELLS = {
    "square": cell(SQUARE, hole("square", 4.5, None)),
    "cross": cell(SQUARE, hole("cross", 6.0, 0.3, 1.0)),
    "cross near its neighbours": cell(SQUARE, hole("cross", 6.5, 0.2, 1.5)),
    "turned cross": cell(SQUARE, hole("cross", 6.0, 0.3, 1.0, turn=0.3)),
    "snowflake": cell(TRIANGULAR, hole("snowflake", 5.8, 0.25, 1.0)),
    "snowflake near its neighbours": cell(TRIANGULAR, hole("snowflake", 6.5, 0.15, 0.9)),
    "hexagon in a square": cell(SQUARE, hole("hexagon", 5.0, 0.3), thickness=0.5),
    "coated square": cell(
        SQUARE,
        Disc(5 * MM, section="square", corner_radius=0.5 * MM, material=material("epoxy")),
        Disc(3 * MM, material=material("steel")),
    ),
    "two sites": UnitCell(
        Lattice(lattice="honeycomb", pitch=12 * MM),
        1.5 * MM,
        ALUMINIUM,
        site=(Site(disc=(hole("square", 4.0, 0.4),)), Site(pillar=Pillar(3 * MM, 4 * MM))),
    ),
}


def frequencies(cell, plans):
    tiling = Tiling.condensed(cell, plans, 3, 24, measured=False)
    pencil = lattice_pencil(tiling)
    return np.array([hertz(eigenpairs(pencil, kappa, 10)[0]) for kappa in KAPPA])


@pytest.mark.parametrize("name", daily(CELLS, "square"))
def test_fewer_places_on_the_rim_change_frequencies_by_no_more_than_is_stated(monkeypatch, name):
    cell, order = CELLS[name], 3
    plans = Resolution(order, 1).plans(cell)
    assert all(plan.rim[0] for plan in plans)
    few = frequencies(cell, plans)
    monkeypatch.setattr(sys.modules["haptonic.cell.plan"], "pieces_of_sides", lambda *_: (0, 0))
    plans = Resolution(order, 1).plans(cell)
    assert not any(plan.rim[0] for plan in plans)
    change = few / frequencies(cell, plans) - 1
    assert np.abs(change).max() < trace_error(order)


@pytest.mark.parametrize(
    ("name", "along"),
    daily([("square", (0, 1)), ("square", (1, 1)), ("cross", (0, 1))], ("square", (0, 1))),
)
def test_fewer_places_on_the_rim_transmit_the_same_through_rows(monkeypatch, name, along):
    """Between plain plate, and at faces that zigzag beside fillers of plain plate."""

    def shares():
        rows = CondensedRows.of(CELLS[name], Resolution(3, 1), along)
        return Interface.of(rows, 30.0).scattering(2e5 * np.pi, 2, FAMILIES)

    few = shares()
    monkeypatch.setattr(sys.modules["haptonic.cell.plan"], "pieces_of_sides", lambda *_: (0, 0))
    every = shares()
    assert few.transmitted == pytest.approx(every.transmitted, abs=2e-3)
    assert few.reflected == pytest.approx(every.reflected, abs=2e-3)


@pytest.mark.parametrize("rim", [(1, 9), (2, 6), (3, 4)])
def test_the_nodes_of_a_mesh_move_with_the_polynomials_of_the_trace(rim):
    plan = MeshPlan(5, 0, 0, blocks=4, sides=6, rim=rim)
    along = np.arange(6)[:, None] + trace_shares(plan)
    nodes = np.arange(6)[:, None] + side_shares(plan)
    powers = np.arange(rim[1] + 1)[:, None]

    def motion(place):
        # on each side a polynomial that vanishes at its ends, so that sides meet
        return ((place % 1) * (1 - place % 1) * (place % 1) ** powers[: rim[1] - 1]).T

    moved = along_rim(plan) @ motion(along.ravel())
    assert moved == pytest.approx(motion(nodes.ravel()), abs=1e-12)


def test_a_mesh_with_few_nodes_on_its_rim_keeps_them():
    plan = MeshPlan(5, 0, 0, blocks=2, rim=(2, 5))
    assert plan.rim == (0, 0)
    assert plan.rim_nodes == plan.around == 40
    assert np.array_equal(along_rim(plan), np.eye(40))


def test_a_trace_ends_at_the_pieces_of_a_divided_side():
    """As where neighbouring tiles of a plate meet in the middle of a side."""
    plan = MeshPlan(5, 0, 0, blocks=8, rim=(1, 14))
    assert plan.divided(1, 3) is plan
    assert plan.divided(2, 3).rim == (0, 0)
    assert replace(plan, rim=(2, 9)).divided(2, 3).rim == (2, 9)
    assert plan.divided(3, 3).rim == (0, 0)


THICK = {
    "pillar": UnitCell(SQUARE, 4.5 * MM, ALUMINIUM, Pillar(2.8 * MM, 4.2 * MM)),
    "pillar near the rim": UnitCell(SQUARE, 4.5 * MM, ALUMINIUM, Pillar(6.4 * MM, 4.2 * MM)),
    "blind hole": cell(SQUARE, Disc(3.5 * MM, low=-2 * MM, empty=True), thickness=4.0),
    "countersunk hole": cell(
        TRIANGULAR,
        Disc(3.5 * MM, high=-2 * MM, empty=True),
        Disc(3.5 * MM, low=-2 * MM, draft=-0.44, empty=True),
        thickness=5.5,
    ),
    "pillar on glue": cell(
        SQUARE,
        Disc(3 * MM, low=0.0, high=0.5 * MM, material=material("epoxy")),
        Disc(3 * MM, low=0.5 * MM, high=3 * MM),
        thickness=4.0,
    ),
}


@pytest.mark.parametrize("name", daily(THICK, "pillar"))
def test_more_levels_on_the_rim_of_a_thick_plate_change_less_than_the_estimate(name):
    cell, resolution = THICK[name], Resolution(3, 1, 3, 24)
    (plan,) = resolution.plans(cell)
    assert len(plan.plate_layer_orders) > 1
    change = frequencies(cell, [plan]) - frequencies(cell, [replace(plan, near_rim=plan.near_rim + 2)])
    model = BlochModel.of(cell, resolution, 10, measured=False)
    errors = [model.solve(kappa).error for kappa in KAPPA]
    assert (np.abs(change) < 0.4 * np.array(errors)).all()
