"""Chances of plates with many pillars: closed forms, integrals and plain draws by the million."""

import math

import numpy as np
import pytest
import scipy.stats as st
from scipy.integrate import quad
from scipy.special import ndtr, ndtri

from haptonic.design.rare import Divided
from haptonic.design.tolerance import CUT, REACH, Chances, Spread, Surface, terms_needed

UM = 1e-6
FAR = 1e9  # Hz, of an upper edge that never matters
NORMAL, UNIFORM = st.truncnorm(-CUT, CUT), st.uniform(-1.0, 2.0)
PATHS = ("cell.pillar.diameter", "cell.pillar.height", "cell.pillar.fillet", "cell.pillar.draft")


def spreads(*kinds):
    """A spread for each pair of a distribution and either batch or pillar."""
    return tuple(Spread(path, 1e-5, *kind) for path, kind in zip(PATHS, kinds, strict=False))


def gap(kinds, lower, upper=None, pillars=1):
    """A gap around 51 kHz whose lower edge is the highest of some quadratics, each with all its terms."""
    coefficients = np.zeros((terms_needed(len(kinds)), 2, len(lower)))
    coefficients[0, 1] = FAR
    coefficients[:, 0] = np.transpose(lower)
    if upper is not None:
        coefficients[:, 1] = np.transpose(upper)
    return Chances(Surface(coefficients, np.zeros(2)), spreads(*kinds), 51e3, 0.0, pillars)


def drawn_chance(chances, scale, count):
    """Share of plates that keep the margin, from (count) plain draws of pillars, or of whole plates."""
    chance = np.random.default_rng(3)
    by_pillar = np.array([spread.per == "pillar" for spread in chances.spreads])

    def plain(number):
        inside = chance.uniform(-1.0, 1.0, (number, len(chances.spreads)))
        is_normal = [spread.distribution == "normal" for spread in chances.spreads]
        inside[:, is_normal] = ndtri(0.5 + (ndtr(CUT) - 0.5) * inside[:, is_normal])
        return scale * inside

    if by_pillar.all():
        failing = np.mean([(chances.room(plain(250_000)) < 0).mean() for _ in range(count // 250_000)])
        return (1 - failing) ** chances.pillars
    kept = [
        (chances.room(np.where(by_pillar, plain(chances.pillars), plate)) >= 0).all()
        for plate in plain(count)
    ]
    return np.mean(kept)


class TestDraws:
    mixed = Divided([NORMAL, UNIFORM])

    @pytest.mark.parametrize("rate", [0.5, 5.0, 25.0])
    def test_a_proposal_is_as_rare_as_it_should_be(self, rate):
        shares = self.mixed.leaning(np.array([1.0, -0.5]), rate)
        assert shares.sum(axis=1) == pytest.approx([1.0, 1.0])
        entropy = (shares * np.log(np.maximum(shares, 1e-300) / self.mixed.own)).sum()
        assert entropy == pytest.approx(rate, rel=0.02)
        first, second = (shares * self.mixed.places).sum(axis=1)
        assert first > 0 > second

    def test_numbers_without_a_direction_keep_their_distribution(self):
        shares = self.mixed.leaning(np.array([0.0, 2.0]), 3.0)
        assert shares[0] == pytest.approx(self.mixed.own[0])
        assert self.mixed.leaning(np.zeros(2), 3.0) is self.mixed.own

    def test_weighted_averages_are_those_of_the_distributions(self):
        proposals = [self.mixed.own, self.mixed.even, *(
            self.mixed.leaning(np.array([1.0, side]), rate)
            for side in (1.0, -1.0) for rate in (2.0, 8.0, 20.0)
        )]  # fmt: skip
        draws, weights = self.mixed.drawn(proposals, 2**14, seed=1)
        assert weights.mean() == pytest.approx(1.0, abs=2e-3)
        assert np.average(draws**2, axis=0, weights=weights) == pytest.approx(
            [NORMAL.var(), UNIFORM.var()], rel=5e-3
        )
        corner = (draws > [2.999, 0.9999]).all(axis=1)
        assert weights[corner].sum() / len(draws) == pytest.approx(NORMAL.sf(2.999) * 5e-5, rel=0.05)


class TestManyPillars:
    @pytest.mark.parametrize("pillars", [180, 20_000, 10**7])
    @pytest.mark.parametrize("confidence", [0.99, 0.9999])
    @pytest.mark.parametrize("kind", ["normal", "uniform"])
    def test_the_closed_form_of_one_number(self, pillars, confidence, kind):
        """The loosest scale s has (1 - sf(room / s))^pillars = confidence."""
        chances = gap([(kind, "pillar")], [[50e3, 600.0, 0.0]], pillars=pillars)
        failing = -math.expm1(math.log(confidence) / pillars)
        exact = 1000 / (600 * (NORMAL if kind == "normal" else UNIFORM).isf(failing))
        assert chances.loosest(confidence) == pytest.approx(min(exact, REACH), rel=2e-3)
        just = exact * (1 - 1e-3)
        expected = (1 - (NORMAL if kind == "normal" else UNIFORM).sf(1000 / 600 / just)) ** pillars
        assert chances.of_a_plate(just) == pytest.approx(expected, abs=0.1 * (1 - confidence))
        assert chances.of_a_plate(0.999 * 1000 / 600 / (CUT if kind == "normal" else 1)) == 1.0

    def test_the_chance_of_a_plate_follows_from_that_of_a_pillar(self):
        """The study of 180 pillars that printed 8.39 % beside 98.73 % for one pillar."""
        chances = gap([("normal", "pillar")] * 2, [[50e3, 300.0, 250.0, 5.0, -9.0, 4.0]], pillars=180)
        assert chances.of_a_plate() == pytest.approx(chances.of_one_pillar() ** 180, rel=0.05)

    @pytest.mark.parametrize("pillars", [180, 20_000])
    def test_a_number_on_whose_two_sides_a_gap_fails(self, pillars):
        """Without a slope at the study's own value: r = 1000 - 150 x^2 - 100 y Hz."""
        chances = gap([("normal", "pillar")] * 2, [[50e3, 0.0, 100.0, 150.0, 0.0, 0.0]], pillars=pillars)
        scale = chances.loosest(0.95)

        def failing(x):
            return NORMAL.pdf(x) * NORMAL.sf((1000 - 150 * (scale * x) ** 2) / (100 * scale))

        share = 2 * quad(failing, 0.0, CUT, epsabs=1e-14, limit=200)[0]
        assert (1 - share) ** pillars == pytest.approx(0.95, abs=0.02)

    @pytest.mark.parametrize(
        ("kinds", "pillars", "count"),
        [
            ([("normal", "pillar")] * 2, 180, 2_000_000),
            ([("uniform", "pillar")] * 3, 180, 2_000_000),
            ([("normal", "pillar"), ("uniform", "pillar")] * 2, 2000, 3_000_000),
            ([("normal", "pillar"), ("normal", "batch"), ("uniform", "batch")], 180, 1500),
        ],
    )
    def test_plain_draws_of_two_curved_edges(self, kinds, pillars, count):
        """Four bands on each side whose order changes; the averages have standard errors of 0.5 %."""
        chance, size = np.random.default_rng(8), terms_needed(len(kinds))
        ends = 1 + len(kinds)

        def bands(edge, away, sign):
            shared = sign * chance.uniform(100, 400, len(kinds))
            quadratics = np.zeros((4, size))
            quadratics[:, 0] = edge + away * np.arange(4)
            quadratics[:, 1:ends] = shared + chance.normal(0, 60, (4, len(kinds)))
            quadratics[:, ends:] = chance.normal(0, 15, (4, size - ends))
            return quadratics

        chances = gap(kinds, bands(50e3, -40.0, 1), bands(52.4e3, 50.0, -1), pillars)
        scale = chances.loosest(0.9)
        assert 0.1 < scale < REACH
        assert drawn_chance(chances, scale, count) == pytest.approx(0.9, abs=0.02)

    @pytest.mark.parametrize(("pillars", "room"), [(1, 3.2), (10**6, 3.45)])
    def test_rare_plates_are_resolved(self, pillars, room):
        """Few plates of 10^4 fail, by a number that all their pillars have in common."""
        lower = [51e3 - 400 * room, 200.0, 400.0, 0.0, 0.0, 0.0]
        chances = gap([("uniform", "pillar"), ("normal", "batch")], [lower], pillars=pillars)

        def failing(x):
            return -NORMAL.pdf(x) * np.expm1(pillars * np.log1p(-UNIFORM.sf(2 * (room - x))))

        expected = quad(failing, room - 0.5, CUT, epsabs=1e-12, limit=400)[0]
        assert 5e-5 < expected < 1e-3
        assert 1 - chances.of_a_plate() == pytest.approx(expected, rel=0.1)
