"""The statistics against pingouin, an independent package."""

import numpy as np
import pandas as pd
import pingouin
import pytest
from test_statistics import drawn

from haptonic.friction.statistics import by_participants, by_trials, corrected, equivalence


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("test", [by_trials, by_participants])
def test_the_paired_test_and_its_interval(test, seed):
    pairs = drawn(6, 12, seed)
    ours = test(pairs)
    sides = (pairs.on, pairs.off) if test is by_trials else pairs.means
    peer = pingouin.ttest(*sides, paired=True).iloc[0]
    columns = {name.lower().replace("-", "_").replace("%", ""): name for name in peer.index}
    assert ours.statistic == pytest.approx(float(peer[columns["t"]]), abs=5e-3)
    assert ours.dof == peer[columns["dof"]]
    assert ours.p == pytest.approx(float(peer[columns["p_val"]]), rel=1e-3)
    interval = peer[columns["ci95"]]
    assert (ours.low, ours.high) == pytest.approx(tuple(interval), abs=6e-3)
    # pingouin's d of pairs divides by the root mean square of both deviations: ours by their mean
    ratio = np.sqrt(0.5 * (sides[0].var(ddof=1) + sides[1].var(ddof=1)))
    ratio /= 0.5 * (sides[0].std(ddof=1) + sides[1].std(ddof=1))
    d = pingouin.compute_effsize(*sides, paired=True, eftype="cohen")
    assert ours.d_av == pytest.approx(d * ratio)


def test_corrections():
    tests = [by_participants(drawn(6, 12, seed)) for seed in range(6)]
    for method, values in (
        ("bonf", [test.corrected for test in corrected(tests)]),
        ("holm", [test.holm for test in corrected(tests)]),
    ):
        assert values == pytest.approx(pingouin.multicomp([test.p for test in tests], method=method)[1])


def test_equivalence():
    pairs = drawn(8, 20, 4)
    on, off = pairs.means
    peer = pingouin.tost(1 - on / off, np.zeros(len(on)), bound=0.11, paired=True)
    column = next(name for name in peer.columns if name.lower().startswith("p"))
    assert equivalence(pairs, 0.11).p == pytest.approx(float(peer[column].iloc[0]), rel=1e-6)


@pytest.mark.filterwarnings("ignore:The inplace keyword")  # pingouin 0.7 with pandas 3.1
def test_repeated_measures_of_two_conditions_are_the_paired_test():
    """An analysis of variance of the participants' means: F is t squared."""
    pairs = drawn(7, 10, 2)
    on, off = pairs.means
    table = pd.DataFrame(
        {
            "friction": np.concatenate([on, off]),
            "actuation": np.repeat(["on", "off"], len(on)),
            "participant": [*pairs.people, *pairs.people],
        }
    )
    peer = pingouin.rm_anova(table, dv="friction", within="actuation", subject="participant").iloc[0]
    assert by_participants(pairs).statistic ** 2 == pytest.approx(float(peer["F"]), rel=1e-6)
