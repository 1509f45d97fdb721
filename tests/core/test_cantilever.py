"""The clamped pillar: equation (3), Timoshenko beams, and the exact solid."""

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq
from strategies import ALUMINIUM

from haptonic.cell import Pillar
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
    found = euler_bernoulli(PROTOTYPE, ALUMINIUM) / euler_bernoulli(PROTOTYPE, ALUMINIUM)[0] * 3.516
    assert found == pytest.approx(ROOTS**2, rel=3e-4)


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
