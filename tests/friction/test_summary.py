"""Everything that a table of trials says, in one value, and what it cannot say."""

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
            ("bonferroni", [one.corrected for one in tests]),
            ("holm", [one.holm for one in tests]),
        ):
            assert values == pytest.approx(multipletests(ps, method=name)[1])

    def test_a_test_without_p_has_no_corrected_one_but_counts(self):
        tests = corrected([Test("participants", "WG1", 5, 0.1, p=p) for p in (math.nan, 0.01)])
        assert math.isnan(tests[0].holm)
        assert math.isnan(tests[0].corrected)
        assert tests[1].holm == tests[1].corrected == 0.02

    def test_each_kind_of_test_is_corrected_by_itself(self):
        pairs = [drawn(seed=1), drawn(seed=2)]
        found = compared(pairs)
        for kind in range(3):
            ps = [one.p for one in found[kind::3]]
            assert [one.holm for one in found[kind::3]] == pytest.approx(multipletests(ps, method="holm")[1])
        alone = by_each(pairs)
        assert len(alone) == sum(len(one.people) for one in pairs)
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
            found = effect_sizes(float(apart.mean()), float(apart.std(ddof=1)), mean_spread, n)
            for name in hits:
                hits[name] += found[f"{name}_low"] < truth[name] < found[f"{name}_high"]
        # 95 %, with three standard errors of 400 draws; d_av's is approximate
        assert hits["d_z"] / 400 == pytest.approx(0.95, abs=0.033)
        assert hits["d_av"] / 400 == pytest.approx(0.95, abs=0.04)

    def test_the_interval_of_d_z_excludes_zero_just_when_the_test_does(self):
        for seed in range(15):
            one = compared([drawn(5, 6, seed)])[1]
            assert (one.p < 0.05) == (one.d_z_low * one.d_z_high > 0)
            assert one.d_z_low < one.d_z < one.d_z_high
            assert one.d_av_low < one.d_av < one.d_av_high


class TestSummary:
    def test_the_whole(self):
        table = experiment()
        found = summary(table)
        assert (found.driven, found.idle) == ("WG1", ("WG2",))
        assert "the study gives none" in found.chosen
        assert list(found.reductions) == ["WG1", "WG2"]
        assert found.reductions["WG1"].value == pytest.approx(0.55, abs=0.08)
        assert len(found.tests) == 6
        assert len(found.each) == 8
        assert found.stopped["WG2"].value == pytest.approx(
            1 - found.reductions["WG2"].value / found.reductions["WG1"].value
        )
        assert [one.waveguide for one in found.equivalences] == ["WG2"]
        assert len(found.conclusions) == 2
        assert found.omissions == ()
        asked = ("P2", "WG1", "on")
        one = next(c for c in found.conditions if (c.participant, c.waveguide, c.actuation) == asked)
        values = table["friction"].values[where(table, participant="P2", waveguide="WG1", actuation="on")]
        assert one.friction == pytest.approx((values.mean(), values.std(ddof=1)))
        assert one.by_means[0] == pytest.approx(values.mean() + 0.01)
        assert (one.used, one.excluded, one.force[0]) == (10, 0, pytest.approx(0.8))
        everybody = [c for c in found.conditions if c.participant == EVERYBODY]
        assert [c.used for c in everybody] == [40] * 4

    def test_the_study_may_give_the_driven_waveguide(self):
        found = summary(experiment(), "WG2")
        assert (found.driven, found.chosen) == ("WG2", "given in the study")
        refused(lambda: summary(experiment(), "WG3"), "WG3", code="unknown")

    def test_unequal_and_missing_conditions_are_named(self):
        table = experiment()
        lost = where(table, participant="P1", waveguide="WG2", actuation="off")
        few = np.flatnonzero(where(table, participant="P2", waveguide="WG1", actuation="on"))[:3]
        found = summary(without(table, np.flatnonzero(lost).tolist() + few.tolist()))
        said = " ".join(found.omissions)
        assert "P1: no valid trial on WG2 off" in said
        assert "P2: unequal numbers of trials (WG1 off: 10, WG1 on: 7" in said
        assert "without P1" in said
        assert math.isfinite(found.stopped["WG2"].value)
        assert paired(without(table, lost), "WG2").people == ("P2", "P3", "P4")

    def test_many_unequal_participants_are_counted(self):
        table = experiment(12)
        firsts = [np.flatnonzero(table["participant"].values == f"P{n + 1}")[0] for n in range(12)]
        found = summary(without(table, firsts))
        assert len(found.omissions) == 6
        assert found.omissions[-1] == "the same of 7 other participants"

    def test_a_waveguide_without_pairs_has_no_test_and_no_p(self):
        table = experiment()
        found = summary(without(table, where(table, waveguide="WG2", actuation="on")))
        assert {one.waveguide for one in found.tests} == {"WG1"}
        assert not found.stopped
        assert not found.equivalences
        assert any(text.startswith("WG2: no test") for text in found.omissions)

    def test_nothing_at_all_can_be_tested(self):
        table = experiment()
        found = summary(without(table, where(table, actuation="on")))
        assert found.tests == found.each == found.conclusions == ()
        assert found.driven is None
        assert "no waveguide can be tested" in found.chosen
        assert [c.used for c in found.conditions if c.participant == EVERYBODY and c.actuation == "on"] == [
            0,
            0,
        ]

    def test_one_participant(self):
        found = summary(experiment(1))
        assert all(c.participant == "P1" for c in found.conditions)
        for one in found.tests:
            assert (one.name == "trials, as published") == math.isfinite(one.p)
        assert all(math.isnan(one.low) for one in (*found.reductions.values(), *found.stopped.values()))
        assert all(math.isnan(one.p) for one in found.equivalences)
        assert all("one participant" in text for text in found.conclusions)
        assert found.own["WG1", "P1"].low > 0

    def test_too_few_for_a_drift(self):
        table = experiment(2)
        off = np.flatnonzero(where(table, participant="P1", actuation="off"))
        found = summary(without(table, off[:-2]))
        assert found.drift is None
        assert any("drift" in text for text in found.omissions)
