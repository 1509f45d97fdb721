"""The lattice as a wall, and guided modes, against a row of cells that knows no plate waves at all."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from coarse import rows, single
from hypothesis import given, settings, strategies as st
from strategies import reference_cell

from daily import daily
from five_parts import refusing
from haptonic.bloch.evanescent import bloch_waves
from haptonic.bloch.guide import Guide, GuidedMode, _root, strip_mode
from haptonic.bloch.layers import Interface, stacked
from haptonic.bloch.rows import CondensedRows
from haptonic.bloch.wall import Wall
from haptonic.cell import MeshPlan
from haptonic.errors import StudyError
from haptonic.lattice import Lattice
from haptonic.superelement import condense

KILOHERTZ = 2e3 * np.pi
PITCH, WIDTH, LENGTH = 7e-3, 32e-3, 140e-3
GAP = (50.5 * KILOHERTZ, 66.0 * KILOHERTZ)  # of waves as steep as those of the prototype
ALONG = 17.5 * np.pi / LENGTH


@cache
def guide(along: float = ALONG) -> Guide:
    return Guide.of(rows(), along)


@settings(max_examples=10)
@given(kilohertz=st.floats(56.0, 65.0))
def test_a_closed_wall_throws_back_all_and_seems_to_hold_the_plate_behind_it(kilohertz):
    wall = guide().walls(kilohertz * KILOHERTZ)[0]
    r = wall.reflection[wall.flexural, wall.flexural]
    assert wall.closed
    assert abs(r) == pytest.approx(1.0, abs=1e-9)
    # an incoming wave and the reflected one cancel at the fixed line
    there = np.exp(-1j * wall.wavenumber * wall.fixed_line)
    assert abs(there + r / there) < 1e-9
    assert 0 < wall.fixed_line < 0.3 * PITCH


@pytest.mark.parametrize(("cells", "nodal_lines"), daily([(4, 0), (5, 0), (8, 1), (9, 1)], (4, 0), (9, 1)))
def test_a_guided_mode_is_a_resonance_of_plain_cells_between_lattices(cells, nodal_lines):
    """By counting frequencies passed, without any wave of a plate (Wittrick and Williams 1971)."""
    mode = guide().mode(cells * PITCH, nodal_lines, GAP)
    slabs = [rows(pillars=pillars).slab(ALONG * PITCH) for pillars in (True, False)]

    def negative(omega: float) -> int:
        walls, strip = (slab.at(omega) for slab in slabs)
        *_, whole = stacked(strip, cells)
        right, left = bloch_waves(walls, omega)
        ends = np.block([
            [whole.LL - left.impedance(), whole.LR],
            [whole.RL, whole.RR + right.impedance()],
        ])  # fmt: skip
        return int((np.linalg.eigvalsh(ends) < 0).sum())

    low, high = 0.997 * mode.omega, 1.003 * mode.omega
    before = negative(low)
    assert negative(high) == before + 1
    for _ in range(8):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if negative(middle) == before else (low, middle)
    assert mode.omega == pytest.approx(low, rel=1e-3)


@pytest.mark.parametrize("nodal_lines", [0, 1, 2, 3])
def test_modes_have_the_nodal_lines_that_were_asked_for(nodal_lines):
    mode = guide().mode((22 + 25 * nodal_lines) * 1e-3, nodal_lines, GAP)
    inner = mode.amplitude[1:-1]
    dips = (inner < mode.amplitude[:-2]) & (inner < mode.amplitude[2:])
    assert dips.sum() == nodal_lines
    assert (inner[dips] < 0.02).all()
    assert mode.amplitude == pytest.approx(mode.amplitude[::-1], abs=1e-9)
    assert mode.amplitude.max() == 1.0


@pytest.mark.parametrize(("width", "nodal_lines"), [(22e-3, 0), (47e-3, 1)])
def test_a_mode_is_a_fixed_point_of_crossing_the_strip_and_coming_back(width, nodal_lines):
    """With all decaying waves: R P x = x for even fields, -x for odd ones."""
    mode = guide().mode(width, nodal_lines, GAP)
    wall = guide().walls(mode.omega)[0]
    factors = np.linalg.eigvals(wall.reflection * np.exp(1j * wall.plate.wavenumber * width))
    assert np.abs(factors - (-1) ** nodal_lines).min() < 1e-9


@pytest.mark.parametrize("nodal_lines", [0, 1, 2])
def test_the_width_of_a_mode_and_its_frequency_are_one_relation(nodal_lines):
    omega = 58.0 * KILOHERTZ
    width = guide().width(omega, nodal_lines)
    assert guide().mode(width, nodal_lines, GAP).omega == pytest.approx(omega, rel=1e-9)
    wall = guide().walls(omega)[0]
    # a fixed line on either side and a whole number of half waves between: decaying waves hardly matter
    assert width + 2 * wall.fixed_line == pytest.approx((nodal_lines + 1) * np.pi / wall.wavenumber, rel=1e-3)


def prototype(
    intervals: int, mirrors: CondensedRows | None = None, closed_by: CondensedRows | None = None
) -> GuidedMode:
    return strip_mode(
        mirrors or rows(),
        width=WIDTH,
        length=LENGTH,
        intervals=intervals,
        nodal_lines=0,
        between=GAP,
        closed_by=closed_by,
    )


@pytest.mark.parametrize(("intervals", "kilohertz"), [(16, 51.8), (17, 57.0), (18, 62.7)])
def test_the_prototype_resonates_where_a_model_of_the_whole_plate_does(intervals, kilohertz):
    """An independent finite-element model of all pillars; here the mesh is a coarse one."""
    mode = prototype(intervals)
    assert mode.omega == pytest.approx(kilohertz * KILOHERTZ, rel=0.01)
    assert 0.05 < mode.at_edge < 0.2  # 0.15 in that model
    assert mode.at_edge == pytest.approx(mode.amplitude[-1], rel=1e-3), "the faces are straight"
    assert mode.wavenumber == pytest.approx((intervals + 0.5) * np.pi / LENGTH)


def test_ends_closed_by_the_mirror_hold_the_plate_at_normal_incidence():
    cell = replace(reference_cell(), lattice=Lattice.rectangular(PITCH, 6.8e-3))
    tile = condense(cell, MeshPlan.suited(cell, 3, 1), measured=False)
    narrow, closed_by = single(tile), single(tile, (1, 0))
    mode = prototype(16, narrow, closed_by)
    end = Wall.of(Interface.of(closed_by, 0.0), mode.omega)
    assert mode.wavenumber * (LENGTH + 2 * end.fixed_line) == pytest.approx(18 * np.pi, rel=1e-9)
    assert Guide.of(narrow, mode.wavenumber).mode(WIDTH, 0, GAP).omega == pytest.approx(mode.omega)


def test_a_jump_is_no_root():
    assert _root(lambda x: x - 0.3, 0.0, 1.0) == pytest.approx(0.3)
    assert _root(lambda x: 1.0 if x > 0.3 else -1.0, 0.0, 1.0) is None
    assert _root(lambda x: 0.3 - x, 0.0, 1.0) is None


def test_there_is_no_guide_where_other_waves_propagate():
    with refusing(StudyError, "no-answer", "waveguide.mode"):
        Guide.of(rows(), 50.0).mode(WIDTH, 0, GAP)
    with refusing(StudyError, "no-answer", "waveguide.mode"):
        Guide.of(rows(), 50.0).width(58.0 * KILOHERTZ, 0)


def test_a_mode_is_found_below_the_frequency_from_which_other_waves_propagate():
    long_waves, omega = Guide.of(rows(), 130.0), 58.0 * KILOHERTZ
    with refusing(StudyError, "no-answer", "waveguide.mode"):
        long_waves.walls(65.0 * KILOHERTZ)
    mode = long_waves.mode(long_waves.width(omega, 0), 0, (53.0 * KILOHERTZ, 65.0 * KILOHERTZ))
    assert mode.omega == pytest.approx(omega, rel=1e-9)


def test_there_is_no_mode_where_the_lattice_passes_waves_or_bending_waves_decay():
    leaky = Guide.of(rows(), 14.5 * np.pi / LENGTH)
    assert not leaky.walls(49.5 * KILOHERTZ)[0].closed
    for refused in (
        lambda: leaky.width(49.5 * KILOHERTZ, 0),
        lambda: leaky.mode(15.68e-3, 0, (49.2 * KILOHERTZ, 49.5 * KILOHERTZ)),
        lambda: guide().width(50.0 * KILOHERTZ, 0),
        lambda: guide().mode(WIDTH, 0, (60.0 * KILOHERTZ, 62.0 * KILOHERTZ)),
        lambda: guide().mode(WIDTH, 5, GAP),
    ):
        with refusing(StudyError, "no-answer", "waveguide.mode"):
            refused()
    assert guide().walls(50.0 * KILOHERTZ) == ()
    assert guide(ALONG + 2 * np.pi / PITCH).walls(58.0 * KILOHERTZ) == ()
