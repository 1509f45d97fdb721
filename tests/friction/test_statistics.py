"""What trials prove: tests by hand and by simulation, alarms counted where there is nothing, bad tables."""

import math
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings, strategies as st
from scipy import stats
from statsmodels.stats.power import TTestPower
from statsmodels.stats.weightstats import ttost_paired

from five_parts import refused
from haptonic.friction.lubrication import WEBER_FRACTION
from haptonic.friction.statistics import (
    Pairs,
    Population,
    by_mixed_model,
    by_participants,
    by_trials,
    compared,
    conclusion,
    drift,
    equivalence,
    expected_power,
    false_alarms,
    paired,
    participants_needed,
    power,
    reduction,
    reduction_here,
    smallest_shown,
    stopped,
    stopped_here,
)

PAPER = Population(reduction=0.11, effect_between=0.06)


def table(rows):
    """Trials from (participant, block, trial, waveguide, actuation, friction, excluded)."""
    names = ("participant", "block", "trial", "waveguide", "actuation", "friction", "excluded")
    return xr.Dataset(
        {
            name: ("stroke", np.array(column))
            for name, column in zip(names, zip(*rows, strict=True), strict=True)
        }
    )


def drawn(participants=4, trials=30, seed=0, population=PAPER):
    return population.drawn(participants, trials, np.random.default_rng(seed))


class TestPairs:
    ROWS = (
        ("A", 1, 1, "WG1", "on", 0.1, ""),
        ("A", 1, 2, "WG1", "off", 0.4, ""),
        ("A", 1, 3, "WG1", "on", 0.2, "no contact"),
        ("A", 1, 4, "WG1", "off", 0.5, ""),
        ("A", 1, 5, "WG1", "on", 0.3, ""),
        ("A", 1, 6, "WG1", "off", 0.6, ""),
        ("A", 2, 1, "WG2", "off", 0.9, ""),
        ("B", 1, 2, "WG1", "on", 0.7, ""),
        ("B", 1, 1, "WG1", "off", 0.8, ""),
    )

    def test_by_hand(self):
        """The second pair of A lacks its trial with the vibration on; nothing moves up into its place."""
        pairs = paired(table(self.ROWS), "WG1")
        assert sorted(zip(pairs.participant.tolist(), pairs.on, pairs.off, strict=True)) == [
            ("A", 0.1, 0.4),
            ("A", 0.3, 0.6),
            ("B", 0.7, 0.8),
        ]
        assert pairs.omitted == 2
        on, off = pairs.means
        assert on == pytest.approx([0.2, 0.7] if pairs.people == ("A", "B") else [0.7, 0.2])
        assert pairs.reduction == pytest.approx(1 - 0.45 / 0.65)
        assert off.mean() == pytest.approx(0.65)
        assert pairs.of("A").off.tolist() == [0.4, 0.6]

    @given(st.permutations(range(9)))
    def test_the_order_of_the_rows_does_not_count(self, order):
        pairs = paired(table([self.ROWS[row] for row in order]), "WG1")
        assert sorted(zip(pairs.on, pairs.off, strict=True)) == [(0.1, 0.4), (0.3, 0.6), (0.7, 0.8)]

    def test_bad_tables_are_refused(self):
        whole = table(self.ROWS)
        refused(lambda: paired(whole, "WG3"), "WG3", code="unknown", argument="waveguide")
        refused(lambda: paired(whole, "WG2"), code="too-few", argument="trials on WG2")
        refused(lambda: paired(whole.drop_vars("excluded"), "WG1"), code="mismatch", argument="trials")
        refused(lambda: paired(xr.Dataset(), "WG1"), "no columns", code="mismatch", argument="trials")
        refused(
            lambda: paired(whole.assign(excluded=("stroke", ["no contact"] * 9)), "WG1"),
            "0 of them usable",
            code="too-few",
            argument="trials on WG1",
        )
        refused(lambda: paired(whole, "WG1").of("a"), code="unknown", argument="participant")


class TestTests:
    def test_the_paired_test_by_hand(self):
        """Differences 1, 2, 3 (tenths): t = 2 / (1 / sqrt 3), 0.2 +- 4.3027 * 0.057735."""
        pairs = Pairs(
            "WG1", np.array(["A", "B", "C"]), np.array([0.1, 0.2, 0.3]), np.array([0.2, 0.4, 0.6]), 0
        )
        for test in (by_trials(pairs), by_participants(pairs)):
            assert test.difference == pytest.approx(-0.2)
            assert test.statistic == pytest.approx(-2 * math.sqrt(3))
            assert (test.low, test.high) == pytest.approx((-0.2 - 0.24841, -0.2 + 0.24841), abs=1e-4)
            assert test.p == pytest.approx(0.0742, abs=1e-4)
            assert test.d_z == pytest.approx(-2)
            assert test.d_z == pytest.approx(test.statistic / math.sqrt(3))
            assert test.d_av == pytest.approx(-0.2 / 0.15)
            assert test.among(2).corrected == pytest.approx(2 * test.p)
            assert test.among(100).corrected == 1.0

    def test_each_test_counts_its_own_units(self):
        pairs = drawn(5, 30)
        assert (by_trials(pairs).n, by_participants(pairs).n, by_mixed_model(pairs).n) == (150, 5, 5)
        assert (by_trials(pairs).dof, by_participants(pairs).dof) == (149, 4)

    @pytest.mark.parametrize("seed", range(4))
    def test_the_mixed_model_of_a_balanced_design_is_the_test_by_participants(self, seed):
        """They are known to agree where the effects of people vary by more than their trials explain."""
        pairs = drawn(8, 40, seed, Population(0.2, 0.1, within=0.1))
        mixed, people = by_mixed_model(pairs), by_participants(pairs)
        assert mixed.difference == pytest.approx(people.difference, rel=1e-5)
        assert mixed.statistic == pytest.approx(people.statistic, rel=0.02)
        assert (mixed.low, mixed.high) == pytest.approx((people.low, people.high), rel=0.03)
        assert mixed.p == pytest.approx(people.p, rel=0.3)

    @settings(max_examples=10)
    @given(st.integers(0, 1000), st.floats(0.1, 10))
    def test_neither_scale_nor_sign_changes_the_verdict(self, seed, scale):
        pairs = drawn(5, 8, seed)
        larger = replace(pairs, on=scale * pairs.on, off=scale * pairs.off)
        turned = replace(pairs, on=pairs.off, off=pairs.on)
        for test in (by_trials, by_participants):
            assert test(larger).p == pytest.approx(test(pairs).p)
            assert test(turned).statistic == pytest.approx(-test(pairs).statistic)
            assert test(larger).d_av == pytest.approx(test(pairs).d_av)

    def test_unbalanced_people_count_the_same(self):
        """Ten times the trials of one person do not move the mean over people."""
        pairs = drawn(3, 10)
        mask = pairs.participant == "P1"
        more = [
            np.concatenate([side, *[side[mask]] * 9]) for side in (pairs.participant, pairs.on, pairs.off)
        ]
        heavier = Pairs("simulated", *more, omitted=0)
        assert by_participants(heavier).p == pytest.approx(by_participants(pairs).p)
        assert by_trials(heavier).n == 120

    def test_one_participant(self):
        """No p-value over people, and the note gives the reason."""
        pairs = drawn(1, 30)
        for test in (by_participants(pairs), by_mixed_model(pairs)):
            assert math.isnan(test.p)
            assert math.isnan(test.among(2).corrected)
            assert "one participant only" in test.note
        assert by_trials(pairs).p < 0.05
        assert "these participants only" in conclusion(compared([pairs]))

    def test_trials_that_do_not_vary(self):
        level = np.full(6, 0.4)
        pairs = Pairs("WG1", np.repeat(["A", "B", "C"], 2), 0.5 * level, level, 0)
        for test in (by_trials(pairs), by_participants(pairs)):
            assert math.isnan(test.p)
            assert "equal" in test.note
        same = by_mixed_model(replace(pairs, on=level))
        assert math.isnan(same.p)
        assert same.note
        assert math.isnan(by_trials(Pairs("WG1", np.array(["A"]), level[:1], level[:1], 0)).p)

    def test_corrected_for_the_waveguides(self):
        first, other = drawn(seed=1), replace(drawn(seed=2), waveguide="other")
        tests = compared([first, other])
        assert [test.waveguide for test in tests] == ["simulated"] * 3 + ["other"] * 3
        for test in tests:
            assert test.corrected == pytest.approx(min(1, 2 * test.p), nan_ok=True)


class TestWhatTrialsProve:
    def test_an_idle_waveguide_of_three_people(self):
        """Stated: a simulated 11 % drop has a corrected p of 2e-8 by trials and 0.20 by participants."""
        p_values = []
        for seed in range(60):
            pairs = drawn(3, 60, seed)
            p_values.append([test(pairs).among(2).corrected for test in (by_trials, by_participants)])
        trials, people = np.median(p_values, axis=0)
        assert trials < 1e-4
        assert 0.1 < people < 0.4

    def test_what_may_be_concluded(self):
        seeds = (drawn(3, 60, seed) for seed in range(20))
        conclusions = " ".join(conclusion([test.among(2) for test in compared([pairs])]) for pairs in seeds)
        assert "too few for a conclusion about other people" in conclusions
        sure = compared([drawn(12, 60, 0, Population(0.55, 0.05))])
        assert "significant across participants" in conclusion(sure)
        nothing = compared([drawn(3, 10, 5, Population(0.0, 0.0))])
        assert "a difference may still exist" in conclusion(nothing)

    @pytest.mark.parametrize("simulations", [40, pytest.param(150, marks=pytest.mark.nightly)])
    def test_how_often_each_test_cries_wolf(self, simulations):
        """Nobody's mean effect, but people differ: 5 % is what each test promises."""
        rates = false_alarms(PAPER, participants=6, trials=60, simulations=simulations, seed=1)
        trials, people, mixed = (
            rates[name] for name in ("trials, as published", "participants", "mixed model")
        )
        assert trials[0] > 0.2
        assert people[0] == pytest.approx(0.05, abs=3 * math.sqrt(0.05 * 0.95 / simulations))
        assert mixed[0] == pytest.approx(0.05, abs=3 * math.sqrt(0.05 * 0.95 / simulations))
        assert mixed[2] == people[2] == simulations

    def test_a_reduction_of_the_population_is_left_out_of_the_alarms(self):
        """A drop that every test would see for certain."""
        rates = false_alarms(Population(0.5, 0.02, within=0.02), 8, 4, simulations=30)
        assert rates["participants"][0] < 0.3
        assert rates["trials, as published"][2] == 30

    @pytest.mark.nightly
    def test_where_people_do_not_differ_every_test_keeps_its_promise(self):
        rates = false_alarms(Population(0.0, 0.0), participants=6, trials=20, simulations=200, seed=2)
        assert rates["trials, as published"][0] == pytest.approx(0.05, abs=0.047)
        assert rates["participants"][0] == pytest.approx(0.05, abs=0.047)
        assert rates["mixed model"][0] < 0.097


class TestEffects:
    @pytest.mark.parametrize("people", [3, 12])
    def test_intervals_for_people_contain_the_truth_in_95_of_100(self, people):
        """Three standard errors of 600 experiments are 2.7 %."""
        hits = {"driven": [], "idle": [], "stopped": []}
        for seed in range(600):
            driven, idle = (drawn(people, 20, (seed, n), Population(r, 0.05))
                            for n, r in enumerate((0.55, 0.11)))  # fmt: skip
            for name, estimate, true in (
                ("driven", reduction(driven), 0.55),
                ("idle", reduction(idle), 0.11),
                ("stopped", stopped(driven, idle), 0.8),
            ):
                hits[name].append(estimate.low < true < estimate.high)
        assert {name: np.mean(of) for name, of in hits.items()} == pytest.approx(
            dict.fromkeys(hits, 0.95), abs=0.027
        )

    def test_intervals_for_these_participants_contain_their_true_reduction(self):
        """People who are what they are, and new trials of theirs: 60 pairs each."""
        rng = np.random.default_rng(5)
        level, left = 1 + 0.15 * rng.standard_normal(3), 0.45 + 0.1 * rng.standard_normal(3)
        true = 1 - (level * left).mean() / level.mean()
        hits, blind = [], []
        for seed in range(200):
            on, off = (
                (mean[:, None] * (1 + 0.22 * rng.standard_normal((3, 60)))).ravel()
                for mean in (level * left, level)
            )
            pairs = Pairs("WG1", np.repeat(["A", "B", "C"], 60), on, off, omitted=0)
            estimate = reduction_here(pairs, draws=400, seed=seed)
            hits.append(estimate.low < true < estimate.high)
            blind.append(estimate.low < 0.55 < estimate.high)
        assert np.mean(hits) == pytest.approx(0.95, abs=0.047)
        assert np.mean(blind) < 0.5  # they show nothing about the population
        assert estimate.about == "these participants"
        assert reduction(pairs).about == "people"

    def test_what_these_participants_show_is_narrower_than_what_people_would(self):
        driven, idle = (drawn(4, 60, 1, Population(r, 0.1)) for r in (0.55, 0.11))
        for wide, narrow in (
            (reduction(driven), reduction_here(driven)),
            (stopped(driven, idle), stopped_here(driven, idle)),
        ):
            assert wide.value == narrow.value
            assert wide.high - wide.low > 2 * (narrow.high - narrow.low)

    def test_too_few_pairs_for_a_bootstrap(self):
        assert "few for a bootstrap" in reduction_here(drawn(3, 5)).note
        assert "few for a bootstrap" not in reduction_here(drawn(3, 20)).note
        estimate = reduction_here(drawn(3, 1))
        assert math.isnan(estimate.low)
        assert "single pair" in estimate.note

    def test_the_share_that_is_stopped(self):
        rng = np.random.default_rng(0)
        driven, idle = (Population(r, 0.01).drawn(10, 60, rng) for r in (0.55, 0.11))
        estimate = stopped(driven, idle)
        assert estimate.value == pytest.approx(1 - idle.reduction / driven.reduction)
        assert estimate.low < 0.8 < estimate.high
        assert estimate.high - estimate.low < 0.15
        few = stopped(*(drawn(3, population=Population(r, 0.01)) for r in (0.55, 0.11)))
        assert "3 participants" in few.note
        vague = stopped(drawn(3), drawn(3, seed=1))
        assert math.isnan(vague.value)
        assert math.isnan(vague.low)
        assert "may be zero" in vague.note
        refused(lambda: stopped_here(drawn(3), drawn(4)), "P4", code="mismatch", argument="pairs")
        refused(lambda: stopped(drawn(3), drawn(4)), "P4", code="mismatch", argument="pairs")

    def test_one_participant_has_no_interval(self):
        estimate = reduction(drawn(1))
        assert math.isnan(estimate.low)
        assert "one participant" in estimate.note

    def test_the_same_people_are_drawn_on_both(self):
        """A waveguide compared with itself: no spread from people, and here only from trials."""
        pairs = drawn(6, 400, population=Population(0.5, 0.1, within=0.01))
        estimate, here = stopped(pairs, pairs), stopped_here(pairs, pairs)
        assert estimate.value == pytest.approx(0)
        assert estimate.high - estimate.low < 1e-12
        assert 0 < here.high - here.low < 0.01
        people = pairs.people[::-1]
        turned = [pairs.of(name) for name in people]
        joined = Pairs("other", *(np.concatenate([getattr(part, side) for part in turned])
                                  for side in ("participant", "on", "off")), omitted=0)  # fmt: skip
        assert stopped(pairs, joined).high == pytest.approx(0, abs=1e-12)  # whoever comes first

    def test_equivalence_against_another_code(self):
        """TOST of statsmodels on the same reductions."""
        pairs = drawn(10, 60, 3, Population(0.03, 0.03, 0.1))
        test = equivalence(pairs, WEBER_FRACTION)
        on, off = pairs.means
        each = 1 - on / off
        p, _, _ = ttost_paired(each, np.zeros(10), -0.11, 0.11)
        assert test.p == pytest.approx(p)
        assert test.mean == pytest.approx(each.mean())
        assert test.p < 0.05
        assert -0.11 < test.low < test.high < 0.11
        assert stats.ttest_1samp(each, 0.11, alternative="less").pvalue == pytest.approx(test.p_above)

    def test_the_interval_and_the_test_agree(self):
        for seed in range(20):
            test = equivalence(drawn(6, 20, seed, Population(0.08, 0.04)), 0.11)
            assert (test.p < 0.05) == (test.low > -0.11 and test.high < 0.11)

    def test_at_the_bound_itself_one_in_twenty(self):
        hits = [equivalence(drawn(8, 20, seed), 0.11).p < 0.05 for seed in range(300)]
        assert np.mean(hits) == pytest.approx(0.05, abs=0.04)

    def test_equivalence_needs_people_and_a_share(self):
        test = equivalence(drawn(1), 0.11)
        assert math.isnan(test.p)
        assert "one participant" in test.note
        for bound in (11, 0, -0.1, float("nan")):
            refused(lambda b=bound: equivalence(drawn(), b), code="out-of-range", argument="bound")

    def test_drift(self):
        """A line that was put in, a tenth of the mean, and a second plate that is twice as rough."""
        rows = []
        for person, steepness in (("A", 0.08), ("B", 0.10), ("C", 0.12)):
            for n in range(40):
                guide, rough = (("WG1", 1), ("WG2", 2))[n % 2]
                actuation = ("on", "off")[(n // 2) % 2]
                friction = 0.4 * rough + 0.6 * steepness * (n / 39 - 0.5)
                friction *= 0.5 if actuation == "on" else 1
                rows.append((person, 1 + n // 20, 1 + n % 20, guide, actuation, friction, ""))
        estimate = drift(table(rows))
        assert estimate.value == pytest.approx(0.1, abs=0.005)
        assert estimate.low < 0.08
        assert estimate.high > 0.12
        refused(lambda: drift(table(rows[:4])), code="too-few", argument="trials of A")
        assert "one participant" in drift(table(rows[:40])).note

    @pytest.mark.parametrize("blocks", [2, 4, 8])
    def test_drift_with_one_region_in_each_block(self, blocks):
        """The mean of a region that is felt late contains a part of the drift."""
        rows = [
            (person, block, trial, ("WG1", "WG2")[block % 2], "off", 0.4 * (1 + 0.2 * (place - 0.5)), "")
            for person in ("A", "B", "C")
            for block in range(1, blocks + 1)
            for trial in range(1, 11)
            for place in [(10 * (block - 1) + trial - 1) / (10 * blocks - 1)]
        ]
        assert drift(table(rows)).value == pytest.approx(0.2, rel=1e-6)

    def test_no_drift_from_one_trial_in_each_region(self):
        rows = [(p, 1, n, f"WG{n}", "off", 0.4 + 0.01 * n, "") for p in "AB" for n in (1, 2, 3)]
        refused(lambda: drift(table(rows)), code="too-few", argument="trials of A")


class TestPlanning:
    def test_power_against_the_noncentral_t(self):
        """Without differences of level the paired test has a power in closed form."""
        plan = Population(0.11, 0.06, within=0.2, between=0.0)
        spread = math.sqrt(0.06**2 + 2 * 0.2**2 / 20)
        powers = power(plan, [4, 8], [20], tests=2, simulations=4000, seed=1)
        for people in (4, 8):
            exact = TTestPower().power(0.11 / spread, people, 0.025)
            got = powers["power"].sel(participants=people, trials=20).item()
            assert got == pytest.approx(exact, abs=0.03)

    def test_more_people_more_power_but_more_trials_only_up_to_a_point(self):
        powers = power(Population(0.11, 0.08), [3, 6, 12], [10, 60, 1000])["power"]
        assert (np.diff(powers.values, axis=0) > 0).all()
        assert powers.sel(participants=3, trials=1000) < 0.3

    def test_nothing_to_find_is_found_at_the_level(self):
        powers = power(Population(0.0, 0.05), [6], [30], tests=2, simulations=5000)
        assert powers["power"].item() == pytest.approx(0.025, abs=0.008)

    def test_participants_needed(self):
        plan = Population(0.11, 0.08)
        people = participants_needed(plan, 60)
        chances = power(plan, [people - 1, people], [60], simulations=40_000, seed=9)["power"].values
        assert chances[0] < 0.805
        assert chances[1] > 0.795
        assert participants_needed(Population(0.01, 0.2), 10, most=10) is None

    @pytest.mark.parametrize("effect", [(0.05, 0.05), (0.2, 0.3), (0.1, 0.02), (0.0, 0.1)])
    def test_the_expected_power_is_that_of_simulated_experiments(self, effect):
        plan = Population(*effect)
        for people, strokes in ((4, 5), (12, 20), (29, 20)):
            simulated = power(plan, [people], [strokes], simulations=40_000)
            chance, error = (simulated[name].item() for name in ("power", "error"))
            assert expected_power(plan, people, strokes) == pytest.approx(chance, abs=4 * error + 0.004)

    def test_the_smallest_reduction_that_a_design_shows(self):
        """Without differences of level, where the power has a closed form."""
        plan = Population(0.5, 0.06, within=0.2, between=0.0)
        spread = math.sqrt(0.06**2 + 2 * 0.2**2 / 20)
        for people in (3, 6):
            effect = TTestPower().solve_power(nobs=people, alpha=0.025, power=0.8)
            assert smallest_shown(plan, people, 20) == pytest.approx(effect * spread, rel=0.05)
        assert smallest_shown(plan, 6, 20, wanted=0.95) > smallest_shown(plan, 6, 20)
        assert smallest_shown(Population(0.1, 0.9, within=0.9), 2, 1) is None

    def test_bad_plans_are_refused(self):
        plan = Population(0.11, 0.08)
        refused(lambda: Population(11, 0.08), code="out-of-range", argument="population.reduction")
        refused(
            lambda: Population(0.11, float("nan")),
            "nan",
            code="out-of-range",
            argument="population.effect_between",
        )
        refused(
            lambda: Population(0.11, True), "True", code="out-of-range", argument="population.effect_between"
        )
        refused(lambda: power(plan, [1], [60]), code="out-of-range", argument="participants")
        refused(lambda: power(plan, [], [60]), code="out-of-range", argument="participants")
        refused(lambda: power(plan, [3], [0]), code="out-of-range", argument="trials")
        refused(lambda: power(plan, [3], [2.5]), "2.5", code="out-of-range", argument="trials")
        refused(lambda: power(plan, [3], [20], simulations=3), code="out-of-range", argument="simulations")
        refused(lambda: participants_needed(plan, 60, wanted=80), code="out-of-range", argument="wanted")
        refused(lambda: false_alarms(plan, 1, 20), code="out-of-range", argument="participants")
