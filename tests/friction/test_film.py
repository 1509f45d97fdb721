"""The squeezed film of air: closed limits, an invariant, a march through time, stated values."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.integrate import solve_ivp

from daily import daily
from haptonic.friction.lubrication import film

squeezes = st.floats(-1, 3).map(lambda power: 10.0**power)
excursions = st.floats(0.01, 0.94)


def marched_efficiency(squeeze: float, excursion: float, rings: int, periods: int) -> float:
    """The same film by another road: finite volumes in r^2, marched through time until it repeats itself."""
    edge = np.linspace(0, 1, rings + 1)  # of the rings, in s = r^2; the laplacian is 4 d/ds (s d/ds)
    step = edge[1]

    def gap(t):
        return 1 + excursion * np.cos(t)

    def rate(t, psi):
        square = np.append(psi**2, gap(t) ** 2)
        apart = np.append(np.full(rings - 1, step), step / 2)
        flow = 4 * edge[1:] * np.diff(square) / apart
        return gap(t) / (2 * squeeze) * np.diff(flow, prepend=0.0) / step

    last = 2 * np.pi * np.linspace(periods - 1, periods, 201)
    start = np.full(rings, np.sqrt(1 + 1.5 * excursion**2))
    solution = solve_ivp(
        rate, (0, last[-1]), start, "LSODA", t_eval=last, rtol=1e-7, atol=1e-9, lband=1, uband=1
    )
    pressure = (solution.y / gap(last)).mean(axis=0)  # all rings have the same area
    mean = np.trapezoid(pressure, last) / (2 * np.pi)
    return float((mean - 1) / film.sealed_overpressure(excursion))


class TestAgainstClosedForms:
    @pytest.mark.parametrize(("squeeze", "stated"), [(30, 0.741), (10, 0.535), (3, 0.15), (1, 0.02)])
    def test_the_stated_efficiencies(self, squeeze, stated):
        """Stated for excursions up to 0.2, to as many digits as they are given with."""
        assert film.efficiency(squeeze, 0.0) < stated + 0.005
        assert film.efficiency(squeeze, 0.2) > stated - 0.005
        assert film.efficiency(squeeze, 0.1) == pytest.approx(stated, abs=0.005)

    @pytest.mark.parametrize("squeeze", [30.0, 100.0, 1000.0, 1e5])
    def test_the_edge_that_leaks_where_the_squeeze_number_is_large(self, squeeze):
        """1 - sqrt(2 / sigma), next term of order 1 / sigma."""
        expected = 1 - np.sqrt(2 / squeeze)
        assert film.small_amplitude_efficiency(squeeze) == pytest.approx(expected, abs=0.05 / squeeze)
        assert film.efficiency(squeeze, 0.0) == pytest.approx(expected, abs=0.06 / squeeze + 1e-5)

    @pytest.mark.parametrize("squeeze", [0.3, 3.0, 30.0, 300.0])
    def test_small_amplitudes(self, squeeze):
        """The full solution tends to the perturbation theory as the square of the excursion."""
        limit = film.small_amplitude_efficiency(squeeze)
        off = [film.solved_efficiency(squeeze, e, instants=17) - limit for e in (0.04, 0.02)]
        assert off[0] / off[1] == pytest.approx(4, rel=0.02)
        assert off[1] == pytest.approx(0, abs=0.002 * limit**0.5)

    @pytest.mark.parametrize("excursion", daily([0.2, 0.6, 0.9], 0.6))
    def test_the_sealed_film(self, excursion):
        """In the middle the pressure of a film that cannot leak; over the disc, once the rim is removed."""
        psi = film.solved(1000.0, excursion, radial=28)
        pressure = (psi[-1] / film.gaps(excursion, psi.shape[1])).mean()
        assert pressure - 1 == pytest.approx(film.sealed_overpressure(excursion), rel=1e-3)
        leaky, tight = (film.solved_efficiency(s, excursion, radial=28) for s in (250.0, 1000.0))
        assert 2 * tight - leaky == pytest.approx(1, abs=0.01)  # the rim's share halves
        assert film.efficiency(1e9, excursion) == pytest.approx(1, abs=1e-4)

    def test_the_sealed_film_at_small_excursions(self):
        assert film.sealed_overpressure(1e-6) == pytest.approx(1.25e-12, rel=1e-6)

    def test_the_squeeze_number(self):
        """A millimetre of film at 3 um and 60 kHz, by hand."""
        number = film.squeeze_number(3e-6, 2 * np.pi * 60e3, 1e-3, 1.8e-5, 1e5)
        assert number == pytest.approx(12 * 1.8e-5 * 376991.1 * 1e-6 / (1e5 * 9e-12), rel=1e-6)


class TestAgainstItself:
    @settings(max_examples=8)
    @given(squeezes, excursions)
    def test_the_mean_flux_vanishes_everywhere(self, squeeze, excursion):
        """<H psi^2> is harmonic and so the same at every radius, which no step of the solution imposes."""
        psi = film.solved(squeeze, excursion, instants=33)
        means = (film.gaps(excursion, 33) * psi**2).mean(axis=1)
        assert means == pytest.approx(np.full(len(psi), 1 + 1.5 * excursion**2), rel=1e-9)

    @settings(max_examples=3)
    @given(st.floats(-2, 3).map(lambda power: 10.0**power), excursions)
    def test_the_table_agrees_with_the_equation(self, squeeze, excursion):
        efficiency = film.solved_efficiency(squeeze, excursion, radial=24, instants=71)
        assert film.efficiency(squeeze, excursion) == pytest.approx(efficiency, rel=1e-3)

    @pytest.mark.parametrize(("squeeze", "excursion"), [(3.0, 0.5), (30.0, 0.8)])
    def test_time_stepping_gives_the_same_result(self, squeeze, excursion):
        """The error is of second order in the width of the rings, so two widths give the limit."""
        coarse, fine = (marched_efficiency(squeeze, excursion, rings, 12) for rings in (40, 80))
        assert fine + (fine - coarse) / 3 == pytest.approx(
            film.solved_efficiency(squeeze, excursion), rel=2e-3
        )

    @given(st.floats(-3, 5), st.floats(0.001, 2), st.floats(0, 0.95))
    def test_the_faster_the_tighter(self, power, more, excursion):
        low, high = film.efficiency(10.0 ** np.array([power, power + more]), excursion)
        assert 0 < low < high < 1

    def test_beyond_the_table_it_goes_on(self):
        assert film.efficiency(3000.0, 0.5) == pytest.approx(
            film.solved_efficiency(3000.0, 0.5, 34), abs=1e-4
        )
        ends = film.efficiency(np.array([0.01, 0.01 * (1 - 1e-9), 1000, 1000 * (1 + 1e-9)]), 0.7)
        assert ends[::2] == pytest.approx(ends[1::2], rel=1e-6)
        assert film.efficiency(1e-3, 0.1) == pytest.approx(film.small_amplitude_efficiency(1e-3), rel=0.1)
