"""Fits and chances against closed forms: known quadratics, and gaps that are linear in what varies."""

import math
from dataclasses import replace

import numpy as np
import pytest
import scipy.stats as st
from hypothesis import given, settings, strategies as hst
from scipy.integrate import quad

from haptonic.cell import Pillar, UnitCell
from haptonic.design.parameters import values_of
from haptonic.design.spread_designs import samples
from haptonic.design.tolerance import (
    CUT,
    REACH,
    Chances,
    Spread,
    Surface,
    edges_of,
    first_order,
    terms_needed,
)
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial

MM, UM = 1e-3, 1e-6
CELL = UnitCell(
    Lattice.square(7 * MM),
    1.5 * MM,
    IsotropicMaterial(70e9, 0.33, 2700.0, name="aluminium"),
    Pillar(3.5 * MM, 9 * MM),
)
HEIGHT = Spread("cell.pillar.height", 20 * UM, "normal", "pillar")
DIAMETER = Spread("cell.pillar.diameter", 30 * UM, "uniform", "pillar")
PLATE = Spread("cell.thickness", 10 * UM, "normal", "batch")
MODULUS = Spread("material.youngs_modulus", 1e9, "normal", "batch")
FAR = 1e9  # Hz, of an upper edge that never matters
NORMAL = st.truncnorm(-CUT, CUT)


def linear(spreads, slopes, lower=50e3, upper=FAR, carrier=51e3, margin=0.0, pillars=1):
    """A gap whose lower edge rises by ``slopes`` Hz for each width of each spread; its upper edge stays."""
    coefficients = np.zeros((terms_needed(len(spreads)), 2, 1))
    coefficients[0, :, 0] = lower, upper
    coefficients[1 : 1 + len(spreads), 0, 0] = slopes
    return Chances(Surface(coefficients, np.zeros(2)), tuple(spreads), carrier, margin, pillars)


class TestSurface:
    def quadratic(self, x):
        """(n, 2, 3) Hz, of known quadratics at three wavevectors."""
        a, b, c = x.T
        lower = [50e3 + 3 * a - 2 * b * c, 49e3 + 40 * c**2, 50e3 - a + 7 * b]
        upper = [60e3 - a * b, 60e3 + 5 * c - b**2, 61e3 + a]
        return np.stack([np.stack(lower, axis=-1), np.stack(upper, axis=-1)], axis=1)

    def test_a_quadratic_is_found_exactly(self):
        rng = np.random.default_rng(1)
        x, elsewhere = rng.uniform(-6, 6, (15, 3)), rng.uniform(-6, 6, (50, 3))
        surface = Surface.fitted(x, self.quadratic(x))
        values = self.quadratic(elsewhere)
        expected = np.stack([values[:, 0].max(axis=1), values[:, 1].min(axis=1)], axis=1)
        assert surface.at(elsewhere) == pytest.approx(expected, rel=1e-12)
        assert np.array_equal(edges_of(values), expected)
        assert (surface.doubt < 1e-6).all()
        # constant, three linear, then aa ab ac bb bc cc
        assert surface.coefficients[:, 0, 0] == pytest.approx([50e3, 3, 0, 0, 0, 0, 0, 0, -2, 0], abs=1e-8)
        assert surface.coefficients[:, 1, 1] == pytest.approx([60e3, 0, 0, 5, 0, 0, 0, -1, 0, 0], abs=1e-8)

    def test_pairs_of_plates_and_pillars(self):
        rng = np.random.default_rng(5)
        x, common, single = (rng.uniform(-3, 3, (count, 3)) for count in (15, 4, 9))
        common[:, 1], single[:, [0, 2]] = 0.0, 0.0
        surface = Surface.fitted(x, self.quadratic(x))
        for plate, edges in zip(common, surface.of_pairs(common, single), strict=True):
            assert edges == pytest.approx(surface.at(plate + single), rel=1e-12)
        few = surface.leading(single[:1])
        assert few.coefficients.shape[2] < 3
        assert few.at(single[:1]) == pytest.approx(surface.at(single[:1]), rel=1e-12)

    def test_the_doubt_is_what_new_designs_differ_by(self):
        """Noise of one hertz: designs left out differ by it and by the fit's own error."""
        rng = np.random.default_rng(2)
        x, new = rng.uniform(-3, 3, (60, 3)), rng.uniform(-3, 3, (4000, 3))
        doubts, seen = [], []
        for _ in range(20):
            noise, again = rng.normal(0, 1, (60, 2, 1)), rng.normal(0, 1, (4000, 2))
            exact = self.quadratic(x)[:, :, :1]
            surface = Surface.fitted(x, exact + noise)
            doubts.append(surface.doubt)
            away = surface.at(new) - edges_of(self.quadratic(new)[:, :, :1]) - again
            seen.append(np.sqrt((away**2).mean(axis=0)))
        assert np.mean(doubts) == pytest.approx(np.mean(seen), rel=0.07)
        assert np.mean(doubts) > 1.05  # more than the noise, and than the residual of the fit

    def test_a_fit_of_a_cubic_has_a_large_error(self):
        x = np.random.default_rng(3).uniform(-1, 1, (40, 2))
        cubic = np.stack([50e3 + 500 * x[:, 0] ** 3, 60e3 + 0 * x[:, 0]], axis=1)[:, :, None]
        doubt = Surface.fitted(x, cubic).doubt
        assert doubt[0] > 50
        assert doubt[1] < 1e-6

    def test_too_few_samples(self):
        assert terms_needed(3) == 10
        x = np.random.default_rng(4).uniform(-1, 1, (10, 3))
        with pytest.raises(AssertionError, match="too few"):
            Surface.fitted(x, self.quadratic(x))


class TestSpread:
    @pytest.mark.parametrize("spread", [HEIGHT, DIAMETER], ids=["normal", "uniform"])
    def test_variance_and_range_by_integration(self, spread):
        draws = Chances(Surface(np.zeros((3, 2, 1)), np.zeros(2)), (spread,), 0.0, 0.0, 1).drawn(2**14)
        assert draws.std() * spread.spread == pytest.approx(math.sqrt(spread.variance), rel=1e-3)
        assert np.abs(draws).max() * spread.spread <= spread.half_range
        assert np.abs(draws).max() * spread.spread > 0.99 * spread.half_range

    def test_variances_by_hand(self):
        assert DIAMETER.variance == pytest.approx((30 * UM) ** 2 / 3)
        density = math.exp(-(CUT**2) / 2) / math.sqrt(2 * math.pi)
        inside = math.erf(CUT / math.sqrt(2))
        assert HEIGHT.variance == pytest.approx((20 * UM) ** 2 * (1 - 2 * CUT * density / inside))

    def test_the_workshop_decides_sizes_and_angles(self):
        assert HEIGHT.is_machined
        assert Spread("cell.pillar.draft", 0.01, "normal", "pillar").is_machined
        assert not MODULUS.is_machined

    def test_samples_fill_twice_the_range(self):
        spreads = (HEIGHT, DIAMETER, MODULUS)
        cells = samples(CELL, spreads, 64)
        assert len(cells) == 64
        away = np.array(
            [[values_of(c)[s.parameter] - values_of(CELL)[s.parameter] for s in spreads] for c in cells]
        )
        share = away / [s.half_range for s in spreads]
        assert np.abs(share).max() <= REACH * (1 + 1e-9)
        assert (np.abs(share).max(axis=0) > 0.9 * REACH).all()
        assert share.mean(axis=0) == pytest.approx(np.zeros(3), abs=0.05)
        untouched = set(values_of(CELL)) - {s.parameter for s in spreads}
        assert all(values_of(c)[p] == values_of(CELL)[p] for c in cells for p in untouched)


class TestChances:
    @pytest.mark.parametrize("room", [-2.0, -0.5, 0.0, 0.8, 1.7, 2.5])
    def test_one_sided_normal(self, room):
        gap = linear([PLATE], [400.0], carrier=50e3 + 400 * room + 100, margin=100.0)
        expected = NORMAL.cdf(room)
        assert gap.of_one_pillar() == pytest.approx(expected, abs=1e-3)
        assert gap.of_a_plate() == pytest.approx(expected, abs=1e-3)

    @pytest.mark.parametrize("room", [-0.7, 0.0, 0.4, 0.95])
    def test_one_sided_uniform(self, room):
        width = replace(DIAMETER, per="batch")
        gap = linear([width], [-400.0], carrier=50e3 + 400 * room)
        assert gap.of_a_plate() == pytest.approx((1 + room) / 2, abs=1e-3)

    def test_the_upper_edge_counts_alike(self):
        """Upper edge down by 300 Hz per width: the carrier has to stay 100 Hz below it."""
        coefficients = np.zeros((3, 2, 1))
        coefficients[:2, :, 0] = [[0.0, 52e3], [0.0, -300.0]]
        gap = Chances(Surface(coefficients, np.zeros(2)), (PLATE,), 51.6e3, 100.0, 1)
        assert gap.of_a_plate() == pytest.approx(NORMAL.cdf(1.0), abs=1e-3)

    @pytest.mark.parametrize("moved", [-150.0, 0.0, 150.0])
    def test_edges_move_inwards_by_their_errors(self, moved):
        gap = linear([PLATE], [400.0], carrier=50e3 + 400)
        narrowed = replace(gap, narrowed=(moved, 10.0))
        assert narrowed.of_a_plate() == pytest.approx(NORMAL.cdf((400 - moved) / 400), abs=1e-3)

    @pytest.mark.parametrize(("room", "pillars"), [(1.5, 3), (2.0, 20), (2.6, 100)])
    def test_pillars_of_their_own_are_all_to_be_right(self, room, pillars):
        gap = linear([HEIGHT], [400.0], carrier=50e3 + 400 * room, pillars=pillars)
        share = NORMAL.cdf(room)
        assert gap.of_one_pillar() == pytest.approx(share, abs=1e-3)
        assert gap.of_a_plate() == pytest.approx(share**pillars, abs=2e-3 * pillars * share ** (pillars - 1))

    def test_a_batch_and_its_pillars(self):
        """P = E[ F((room - a x) / b)^pillars ] over the batch's own x."""
        a, b, room, pillars = 300.0, 200.0, 700.0, 12
        gap = linear([PLATE, DIAMETER], [a, b], carrier=50e3 + room, pillars=pillars)

        def kept(x):
            share = min(max(0.5 * (1 + (room - a * x) / b), 0.0), 1.0)
            return NORMAL.pdf(x) * share**pillars

        expected = quad(kept, -CUT, CUT, points=[(room - b) / a, (room + b) / a])[0]
        assert gap.of_a_plate() == pytest.approx(expected, abs=0.01)
        assert gap.of_a_plate() < gap.of_one_pillar() - 0.02

    def test_no_spread_of_pillars_leaves_the_number_of_them_out(self):
        few, many = (linear([PLATE], [400.0], carrier=50.4e3, pillars=n) for n in (1, 400))
        assert few.of_a_plate() == many.of_a_plate()

    def test_only_what_is_machined_is_scaled(self):
        gap = linear([PLATE, MODULUS], [300.0, 400.0], carrier=50.5e3)
        assert gap.of_a_plate(0.0) == pytest.approx(NORMAL.cdf(1.25), abs=1e-3)
        # two normals, cut off where it hardly matters
        both = st.norm.cdf(500 / math.hypot(1.5 * 300, 400))
        assert gap.of_a_plate(1.5) == pytest.approx(both, abs=0.01)


class TestLoosest:
    @pytest.mark.parametrize("confidence", [0.9, 0.95, 0.99])
    def test_the_closed_form_of_a_linear_gap(self, confidence):
        gap = linear([PLATE], [400.0], carrier=51e3)
        assert gap.loosest(confidence) == pytest.approx(1000 / (400 * NORMAL.ppf(confidence)), rel=5e-3)

    @settings(max_examples=3)
    @given(hst.floats(0.5, 0.98), hst.floats(600.0, 2000.0), hst.sampled_from([PLATE, HEIGHT, DIAMETER]))
    def test_it_keeps_the_confidence_and_no_looser_one_does(self, confidence, room, spread):
        gap = linear([spread, MODULUS], [400.0, 50.0], carrier=50e3 + room, pillars=10)
        scale = gap.loosest(confidence)
        assert 0 < scale <= REACH
        assert gap.of_a_plate(scale) >= confidence
        if scale < REACH:
            assert gap.of_a_plate(scale + 2 * REACH / 2**12) < confidence
        assert gap.loosest(confidence + 0.01) <= scale

    def test_its_ends(self):
        assert linear([PLATE], [400.0], carrier=49e3).loosest(0.9) == 0.0, "not even a perfect plate"
        assert linear([PLATE], [1.0], carrier=51e3).loosest(0.9) == REACH, "as far as the fit holds"
        assert linear([MODULUS], [1.0], carrier=51e3).loosest(0.9) is None, "nothing to machine"


class TestImportance:
    spreads = (PLATE, DIAMETER, MODULUS)
    slopes = np.array([300.0, 400.0, 100.0])

    def variances(self):
        """(3,) Hz^2."""
        return self.slopes**2 * np.array([NORMAL.var(), 1 / 3, NORMAL.var()])

    def test_indices_of_a_linear_gap_are_shares_of_its_variance(self):
        gap = linear(self.spreads, self.slopes)
        lower = gap.importance()[:, 0]
        assert lower == pytest.approx(self.variances() / self.variances().sum(), abs=5e-3)

    def test_deviations_of_a_linear_gap(self):
        gap = linear(self.spreads, self.slopes)
        assert gap.deviations() == pytest.approx([math.sqrt(self.variances().sum()), 0.0], rel=1e-3, abs=1e-3)

    def test_first_order_is_exact_where_the_gap_is_linear(self):
        widths = np.array([s.spread for s in self.spreads])
        slopes = np.stack([self.slopes / widths, -2 * self.slopes / widths], axis=1)
        expected = np.stack([self.variances(), 4 * self.variances()], axis=1)
        assert first_order(slopes, self.spreads) == pytest.approx(expected)
