"""The clamped pillar: equation (3), Timoshenko beams, and the exact solid."""

import itertools
import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import scipy.linalg as la
from hypothesis import given, strategies as st
from outlines import side
from scipy.optimize import brentq
from strategies import ALUMINIUM

from haptonic.cell import Pillar, Step
from haptonic.cell.cantilever import euler_bernoulli, timoshenko

DATA = Path(__file__).parents[1] / "data"
PROTOTYPE = Pillar(diameter=3.5e-3, height=14.7e-3)

# roots of cosh x cos x = -1, each between two multiples of pi; alpha = x^2
ROOTS = np.array([brentq(lambda x: np.cosh(x) * np.cos(x) + 1, n * np.pi, (n + 1) * np.pi) for n in range(3)])


def test_equation_3_by_hand_for_the_prototype():
    # sqrt(70e9 / 2700) = 5091.75 m/s; d / h^2 = 16.1969 1/m; over 8 pi: 3281.4 Hz for each unit of alpha
    unit = 3.5e-3 / 14.7e-3**2 * 5091.7508 / (8 * 3.14159265)
    assert euler_bernoulli(PROTOTYPE, ALUMINIUM) == pytest.approx(
        np.array([3.516, 22.03, 61.70]) * unit, rel=1e-7
    )
    assert euler_bernoulli(PROTOTYPE, ALUMINIUM)[0] == pytest.approx(11537, abs=1)


def test_the_papers_constants_are_the_squared_roots():
    constants = euler_bernoulli(PROTOTYPE, ALUMINIUM) / euler_bernoulli(PROTOTYPE, ALUMINIUM)[0] * 3.516
    assert constants == pytest.approx(ROOTS**2, rel=3e-4)


@given(st.floats(0.2, 5.0), st.floats(0.2, 5.0))
def test_equation_3_is_linear_in_diameter_and_falls_with_the_square_of_height(wider, higher):
    changed = Pillar(PROTOTYPE.diameter * wider, PROTOTYPE.height * higher)
    expected = euler_bernoulli(PROTOTYPE, ALUMINIUM) * wider / higher**2
    assert euler_bernoulli(changed, ALUMINIUM) == pytest.approx(expected)


def deficit(slenderness):
    """(3,) relative shortfall of Timoshenko from the exact slender beam."""
    pillar = Pillar(1e-3, slenderness * 1e-3)
    slender = ROOTS**2 / (8 * np.pi) * 1e-3 / pillar.height**2 * np.sqrt(70e9 / 2700)
    return 1 - timoshenko(pillar, ALUMINIUM) / slender


def test_timoshenko_tends_to_the_slender_beam_with_the_square_of_d_over_h():
    thick, thin, thinner = deficit(20), deficit(40), deficit(80)
    assert (thinner > 0).all()
    assert (thinner < [1e-3, 5e-3, 1.5e-2]).all()
    assert np.log2(thin / thinner) == pytest.approx([2, 2, 2], abs=0.05)
    assert np.log2(thick / thin) == pytest.approx([2, 2, 2], abs=0.2)


def test_timoshenko_is_close_to_the_solid_pillar():
    solid = json.loads((DATA / "pillar.json").read_text("utf-8"))["clamped"]
    bending = np.array([frequency for frequency, kind in solid if kind == "m1"])[:3]
    assert timoshenko(PROTOTYPE, ALUMINIUM) == pytest.approx(bending, rel=0.03)
    # the slender beam is far off in the second and third: the pillar is stocky
    assert (euler_bernoulli(PROTOTYPE, ALUMINIUM)[1:] / bending[1:] > [1.15, 1.35]).all()


def test_as_many_modes_as_asked_for_and_well_resolved():
    many = timoshenko(PROTOTYPE, ALUMINIUM, count=5)
    assert many.shape == (5,)
    assert (np.diff(many) > 0).all()
    assert many[:3] == pytest.approx(timoshenko(PROTOTYPE, ALUMINIUM), rel=1e-12)


def slender_beam(pillar, count=3, elements=60):
    """(count,) frequencies, Hz, of the Euler-Bernoulli beam: Hermite cubics between the outline's corners.

    Nothing is shared with the Timoshenko element: fourth-order equation, other unknowns, other integration.
    """
    E, rho = ALUMINIUM.youngs_modulus, ALUMINIUM.density
    break_at = pillar.step.height / pillar.height if pillar.step else 0.5
    first = max(1, round(elements * break_at))
    z = pillar.height * np.concatenate([
        np.linspace(0, break_at, first + 1), np.linspace(break_at, 1, elements - first + 1)[1:]
    ])  # fmt: skip
    K, M = np.zeros((2, 2 * len(z), 2 * len(z)))
    points, weights = np.polynomial.legendre.leggauss(8)
    s = 0.5 * (1 + points)
    for k, (low, high) in enumerate(itertools.pairwise(z)):
        h = high - low
        shape = np.array(
            [1 - 3 * s**2 + 2 * s**3, h * (s - 2 * s**2 + s**3), 3 * s**2 - 2 * s**3, h * (s**3 - s**2)]
        )
        bend = np.array([12 * s - 6, h * (6 * s - 4), 6 - 12 * s, h * (6 * s - 2)]) / h**2
        half = np.array([side(pillar, low + h * t) for t in s])
        area, moment = (
            (np.pi * half**2, np.pi / 4 * half**4)
            if pillar.section == "round"
            else (4 * half**2, 4 / 3 * half**4)
        )
        here = np.arange(2 * k, 2 * k + 4)
        w = 0.5 * h * weights
        K[np.ix_(here, here)] += (bend * w * E * moment) @ bend.T
        M[np.ix_(here, here)] += (shape * w * rho * area) @ shape.T
    return np.sqrt(la.eigh(K[2:, 2:], M[2:, 2:], eigvals_only=True)[:count]) / (2 * np.pi)


MM = 1e-3
SLENDER = {
    "square": Pillar(MM, 100 * MM, "square"),
    "cone": Pillar(MM, 100 * MM, draft=math.atan(0.45 / 100)),
    "undercut, square": Pillar(MM, 100 * MM, "square", draft=-math.atan(0.4 / 100)),
    "step": Pillar(MM, 100 * MM, step=Step(0.5 * MM, 40 * MM)),
    "stepped cone": Pillar(MM, 100 * MM, "round", math.atan(0.2 / 100), step=Step(0.6 * MM, 30 * MM)),
}


def test_the_slender_square_pillar_by_hand():
    # E I / (rho A) = E d^2 / (12 rho)
    pillar = Pillar(MM, 200 * MM, "square")
    expected = ROOTS**2 / (2 * np.pi) * np.sqrt(70e9 * MM**2 / (12 * 2700.0)) / pillar.height**2
    assert timoshenko(pillar, ALUMINIUM) == pytest.approx(expected, rel=2e-3)
    assert (timoshenko(pillar, ALUMINIUM) < expected).all()


def test_the_independent_beam_has_the_closed_form_of_a_uniform_one():
    expected = ROOTS**2 / (8 * np.pi) / MM * 1e-4 * np.sqrt(70e9 / 2700.0)  # d / h^2 = 1e-4 / mm
    assert slender_beam(Pillar(MM, 100 * MM)) == pytest.approx(expected, rel=1e-6)


def test_modes_of_a_stepped_beam_are_roots_of_a_determinant():
    """Deflection, slope, moment and shear force continue at the step: eight conditions, zero determinant."""
    pillar = SLENDER["step"]
    diameters, lengths = (MM, 0.5 * MM), (40 * MM, 60 * MM)

    def condition(hertz):
        omega, rows = 2 * np.pi * hertz, np.zeros((4, 4))
        stiff, pieces = [], []
        for d in diameters:
            beta = (omega / np.sqrt(70e9 * d**2 / 16 / 2700.0)) ** 0.5
            pieces.append(beta)
            stiff.append(d**4)

        def state(z, beta, EI):
            c, s, ch, sh = np.cos(beta * z), np.sin(beta * z), np.cosh(beta * z), np.sinh(beta * z)
            w = np.array([c, s, ch, sh])
            slope = beta * np.array([-s, c, sh, ch])
            moment = EI * beta**2 * np.array([-c, -s, ch, sh])
            force = EI * beta**3 * np.array([s, -c, sh, ch])
            return np.array([w, slope, moment, force])

        foot, end = state(0.0, pieces[0], stiff[0])[:2], state(lengths[1], pieces[1], stiff[1])[2:]
        through = np.linalg.solve(state(0.0, pieces[1], stiff[1]), state(lengths[0], pieces[0], stiff[0]))
        rows[:2], rows[2:] = foot, end @ through
        return np.linalg.det(rows / np.linalg.norm(rows, axis=1)[:, None])

    for frequency in timoshenko(pillar, ALUMINIUM):
        root = brentq(condition, 0.97 * frequency, 1.03 * frequency, xtol=1e-9 * frequency)
        assert frequency == pytest.approx(root, rel=2e-3)
        assert slender_beam(pillar)[np.abs(slender_beam(pillar) - root).argmin()] == pytest.approx(
            root, rel=1e-6
        )


@pytest.mark.parametrize("pillar", SLENDER.values(), ids=SLENDER)
def test_slender_members_tend_to_an_independent_beam(pillar):
    """The shortfall is that of shear and rotary inertia: it falls with the square of the slenderness."""

    def shortfall(taller):
        step = pillar.step and Step(pillar.step.diameter, pillar.step.height * taller)
        slope = math.atan(math.tan(pillar.draft) / taller)
        higher = replace(pillar, height=pillar.height * taller, draft=slope, step=step)
        return 1 - timoshenko(higher, ALUMINIUM) / slender_beam(higher)

    here, there = shortfall(0.25), shortfall(0.5)
    assert (here > 0).all()
    assert (there < 0.02).all()
    assert np.log2(here / there) == pytest.approx([2, 2, 2], abs=0.15)
