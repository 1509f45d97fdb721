"""Everything that a table of trials shows, in one value, and what it cannot show."""

import math

import numpy as np
import pytest
import xarray as xr
from statsmodels.stats.multitest import multipletests
from test_statistics import drawn

from daily import daily
from five_parts import refused
from haptonic.friction.protocol import Protocol
from haptonic.friction.simulation import coefficients
from haptonic.friction.statistics import Test, by_each, compared, corrected, paired
from haptonic.friction.statistics.sizes import effect_sizes
from haptonic.friction.statistics.summary import EVERYBODY, summary
from trial_folders import truth_of


def experiment(participants=4, seed=0, **truth):
    """A table of trials without force records."""
    rng = np.random.default_rng(seed)
    rows = list(coefficients(truth_of(**truth), Protocol(4, 10), participants, rng))
    names = ("participant", "block", "trial", "waveguide", "actuation")
    table = {name: np.array([getattr(label, name) for label, _ in rows]) for name in names}
    friction = np.array([value for _, value in rows])
    table |= {"friction": friction, "ratio_of_means": friction + 0.01, "force": np.full(len(rows), 0.8)}
    table |= {"speed": np.full(len(rows), 0.08), "excluded": np.full(len(rows), "", dtype="<U20")}
    return xr.Dataset({name: ("stroke", values) for name, values in table.items()})


def without(table, rows):
    excluded = table["excluded"].values.copy()
    excluded[rows] = "no contact"
    return table.assign(excluded=("stroke", excluded))


def where(table, **labels):
    return np.all([table[name].values == value for name, value in labels.items()], axis=0)


class TestCorrections:
    @pytest.mark.parametrize("count", daily([1, 2, 5, 8], 1, 8))
    def test_bonferroni_and_holm_against_another_code(self, count):
        ps = np.random.default_rng(count).uniform(0, 0.3, count).tolist()
        tests = corrected([Test("participants", "WG1", 5, -0.1, p=p) for p in ps])
        for name, values in (
            ("bonferroni", [test.corrected for test in tests]),
            ("holm", [test.holm for test in tests]),
        ):
            assert values == pytest.approx(multipletests(ps, method=name)[1])

    def test_a_test_without_p_has_no_corrected_one_but_counts(self):
        tests = corrected([Test("participants", "WG1", 5, 0.1, p=p) for p in (math.nan, 0.01)])
        assert math.isnan(tests[0].holm)
        assert math.isnan(tests[0].corrected)
        assert tests[1].holm == tests[1].corrected == 0.02

    def test_each_kind_of_test_is_corrected_by_itself(self):
        pairs = [drawn(seed=1), drawn(seed=2)]
        tests = compared(pairs)
        for kind in range(3):
            ps = [test.p for test in tests[kind::3]]
            assert [test.holm for test in tests[kind::3]] == pytest.approx(
                multipletests(ps, method="holm")[1]
            )
        alone = by_each(pairs)
        assert len(alone) == sum(len(group.people) for group in pairs)
        assert alone[0].corrected == pytest.approx(min(1, len(alone) * alone[0].p))
        assert alone[0].participant == "P1"


class TestSizes:
    @pytest.mark.parametrize(("n", "effect"), [(4, 0.5), (8, -2.0), (30, 0.3)])
    def test_the_intervals_have_their_nominal_coverage(self, n, effect):
        """On and off with a correlation of 0.6 and unequal spreads."""
        rng = np.random.default_rng(3)
        covariance = np.array([[0.5, 0.6 * math.sqrt(0.5)], [0.6 * math.sqrt(0.5), 1.0]])
        spread = math.sqrt(1.5 - 2 * 0.6 * math.sqrt(0.5))
        truth = {"d_z": effect / spread, "d_av": effect / (0.5 * (1 + math.sqrt(0.5)))}
        hits = {"d_z": 0, "d_av": 0}
        for _ in range(400):
            both = rng.multivariate_normal([effect, 0], covariance, n)
            apart = both[:, 0] - both[:, 1]
            mean_spread = float(both.std(axis=0, ddof=1).mean())
            sizes = effect_sizes(float(apart.mean()), float(apart.std(ddof=1)), mean_spread, n)
            for name in hits:
                hits[name] += sizes[f"{name}_low"] < truth[name] < sizes[f"{name}_high"]
        # 95 %, with three standard errors of 400 draws; d_av's is approximate
        assert hits["d_z"] / 400 == pytest.approx(0.95, abs=0.033)
        assert hits["d_av"] / 400 == pytest.approx(0.95, abs=0.04)

    def test_the_interval_of_d_z_excludes_zero_just_when_the_test_does(self):
        for seed in range(15):
            test = compared([drawn(5, 6, seed)])[1]
            assert (test.p < 0.05) == (test.d_z_low * test.d_z_high > 0)
            assert test.d_z_low < test.d_z < test.d_z_high
            assert test.d_av_low < test.d_av < test.d_av_high


class TestSummary:
    def test_the_whole(self):
        table = experiment()
        result = summary(table)
        assert (result.driven, result.idle) == ("WG1", ("WG2",))
        assert "the study gives none" in result.chosen
        assert list(result.reductions) == ["WG1", "WG2"]
        assert result.reductions["WG1"].value == pytest.approx(0.55, abs=0.08)
        assert len(result.tests) == 6
        assert len(result.each) == 8
        assert result.stopped["WG2"].value == pytest.approx(
            1 - result.reductions["WG2"].value / result.reductions["WG1"].value
        )
        assert [equivalence.waveguide for equivalence in result.equivalences] == ["WG2"]
        assert len(result.conclusions) == 2
        assert result.omissions == ()
        asked = ("P2", "WG1", "on")
        condition = next(c for c in result.conditions if (c.participant, c.waveguide, c.actuation) == asked)
        values = table["friction"].values[where(table, participant="P2", waveguide="WG1", actuation="on")]
        assert condition.friction == pytest.approx((values.mean(), values.std(ddof=1)))
        assert condition.by_means[0] == pytest.approx(values.mean() + 0.01)
        assert (condition.used, condition.excluded, condition.force[0]) == (10, 0, pytest.approx(0.8))
        everybody = [c for c in result.conditions if c.participant == EVERYBODY]
        assert [c.used for c in everybody] == [40] * 4

    def test_the_study_may_give_the_driven_waveguide(self):
        result = summary(experiment(), "WG2")
        assert (result.driven, result.chosen) == ("WG2", "given in the study")
        refused(lambda: summary(experiment(), "WG3"), "WG3", code="unknown")

    def test_unequal_and_missing_conditions_are_named(self):
        table = experiment()
        lost = where(table, participant="P1", waveguide="WG2", actuation="off")
        few = np.flatnonzero(where(table, participant="P2", waveguide="WG1", actuation="on"))[:3]
        result = summary(without(table, np.flatnonzero(lost).tolist() + few.tolist()))
        omissions = " ".join(result.omissions)
        assert "P1: no valid trial on WG2 off" in omissions
        assert "P2: unequal numbers of trials (WG1 off: 10, WG1 on: 7" in omissions
        assert "without P1" in omissions
        assert math.isfinite(result.stopped["WG2"].value)
        assert paired(without(table, lost), "WG2").people == ("P2", "P3", "P4")

    def test_many_unequal_participants_are_counted(self):
        table = experiment(12)
        firsts = [np.flatnonzero(table["participant"].values == f"P{n + 1}")[0] for n in range(12)]
        result = summary(without(table, firsts))
        assert len(result.omissions) == 6
        assert result.omissions[-1] == "the same of 7 other participants"

    def test_a_waveguide_without_pairs_has_no_test_and_no_p(self):
        table = experiment()
        result = summary(without(table, where(table, waveguide="WG2", actuation="on")))
        assert {test.waveguide for test in result.tests} == {"WG1"}
        assert not result.stopped
        assert not result.equivalences
        assert any(text.startswith("WG2: no test") for text in result.omissions)

    def test_nothing_at_all_can_be_tested(self):
        table = experiment()
        result = summary(without(table, where(table, actuation="on")))
        assert result.tests == result.each == result.conclusions == ()
        assert result.driven is None
        assert "no waveguide can be tested" in result.chosen
        assert [c.used for c in result.conditions if c.participant == EVERYBODY and c.actuation == "on"] == [
            0,
            0,
        ]

    def test_one_participant(self):
        result = summary(experiment(1))
        assert all(c.participant == "P1" for c in result.conditions)
        for test in result.tests:
            assert (test.name == "trials, as published") == math.isfinite(test.p)
        assert all(
            math.isnan(estimate.low) for estimate in (*result.reductions.values(), *result.stopped.values())
        )
        assert all(math.isnan(equivalence.p) for equivalence in result.equivalences)
        assert all("one participant" in text for text in result.conclusions)
        assert result.own["WG1", "P1"].low > 0

    def test_too_few_for_a_drift(self):
        table = experiment(2)
        off = np.flatnonzero(where(table, participant="P1", actuation="off"))
        result = summary(without(table, off[:-2]))
        assert result.drift is None
        assert any("drift" in text for text in result.omissions)
