"""Tests for a change of friction by vibration: the test as published, and tests that the design allows.

Trials of one person are alike: sixty trials of three people are not 180 independent pairs. A test over trials
applies to *these* people only; other people need not show the same difference. A test over participants, and
a mixed model with an effect for every participant, apply to the population.
"""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.friction.statistics.pairs import Pairs
from haptonic.friction.statistics.sizes import effect_sizes
from haptonic.names import counted

Name = Literal["trials, as published", "participants", "mixed model"]

CONFIDENCE = 0.95
OPTIMISERS = ["lbfgs", "powell"]  # the second where a variance goes to zero and the first stops
ALIKE = 1e-12  # relative to friction: a smaller variation of the differences counts as none


@dataclass(frozen=True)
class Test:
    """One test of the difference of friction, on less off. Missing numbers are NaN; `note` gives the reason.

    name, waveguide : test, and waveguide that it is about
    n : number of its units: pairs of trials, or participants
    difference : mean, on less off
    low, high : its 95 % confidence interval
    statistic, dof : Student's t and its degrees of freedom
    p : two-sided p-value of this test alone
    corrected : p-value times the number of simultaneous tests (Bonferroni)
    holm : p-value by the rule of Holm, which has the same error rate and more power
    d_z : mean difference over the standard deviation of the differences, t / sqrt(n)
    d_av : mean difference over the mean of the standard deviations on and off
    d_z_low, d_z_high, d_av_low, d_av_high : their 95 % intervals, see `sizes`
    participant : name of the only participant whose trials were tested; empty for all participants
    """

    __test__ = False  # not a test of pytest

    name: Name
    waveguide: str
    n: int
    difference: float
    low: float = math.nan
    high: float = math.nan
    statistic: float = math.nan
    dof: float = math.nan
    p: float = math.nan
    corrected: float = math.nan
    holm: float = math.nan
    d_z: float = math.nan
    d_z_low: float = math.nan
    d_z_high: float = math.nan
    d_av: float = math.nan
    d_av_low: float = math.nan
    d_av_high: float = math.nan
    note: str = ""
    participant: str = ""

    def among(self, tests: int) -> Test:
        """The test with its p-value corrected for a number of tests."""
        return replace(self, corrected=min(1.0, self.p * tests) if math.isfinite(self.p) else math.nan)


def by_trials(pairs: Pairs) -> Test:
    """Paired t-test over trials, as published: it treats the trials of one person as independent."""
    return _paired("trials, as published", pairs.waveguide, pairs.on, pairs.off, "pair of trials")


def by_participants(pairs: Pairs) -> Test:
    """Paired t-test over the means of the participants."""
    on, off = pairs.means
    return _paired("participants", pairs.waveguide, on, off, "participant")


def by_mixed_model(pairs: Pairs) -> Test:
    """Linear mixed model of all trials, with a random level and a random effect for every participant.

    Trial t of participant i has the friction ``y_it = (m + a_i) + (d + b_i) x_it + e_it`` with x = +1/2 on
    and -1/2 off; a_i, b_i and e_it are normal and independent of each other. Restricted maximum likelihood
    (statsmodels). The effect over its standard error is compared with Student's t with one degree of freedom
    fewer than participants, as in a balanced design; a normal distribution would reject far too often with
    few participants.
    """
    # importing it with the module would take half a second of every start of the program
    from statsmodels.regression.mixed_linear_model import MixedLM, MixedLMParams

    people = len(pairs.people)
    difference = float(np.mean(np.subtract(*pairs.means)))
    test = Test("mixed model", pairs.waveguide, people, difference)
    friction = np.concatenate([pairs.on, pairs.off])
    scale = float(friction.std())
    if people < 2:
        return replace(test, note="one participant only: no conclusion about other people")
    if scale <= ALIKE * float(np.abs(friction).max()) or len(pairs.on) <= people:
        return replace(test, note="too few trials, or trials that do not vary: no model to fit")
    coding = np.repeat([0.5, -0.5], len(pairs.on))
    design = np.column_stack([np.ones_like(coding), coding])
    independent = MixedLMParams.from_components(fe_params=np.ones(2), cov_re=np.eye(2))
    with warnings.catch_warnings():
        # a variance estimated as zero lies on the edge of the allowed range, which is not worth a warning
        warnings.simplefilter("ignore", RuntimeWarning)
        warnings.simplefilter("ignore", UserWarning)  # statsmodels' own on convergence among them
        try:
            model = MixedLM(friction / scale, design, np.tile(pairs.participant, 2), exog_re=design)
            fit = model.fit(reml=True, free=independent, method=OPTIMISERS)
            effect, error = float(fit.fe_params[1]) * scale, float(fit.bse_fe[1]) * scale
            converged = bool(fit.converged)
        except (np.linalg.LinAlgError, ValueError):
            converged = False
    if not converged or not (math.isfinite(error) and error > 0):
        return replace(test, note="the fit did not converge: too few participants for its random parts")
    dof = people - 1
    reach = float(scipy.stats.t.ppf(0.5 + CONFIDENCE / 2, dof)) * error
    statistic = effect / error
    return replace(
        test,
        difference=effect,
        low=effect - reach,
        high=effect + reach,
        statistic=statistic,
        dof=float(dof),
        p=float(2 * scipy.stats.t.sf(abs(statistic), dof)),
        note=_few(people),
    )


def compared(pairs: list[Pairs]) -> list[Test]:
    """All three tests of every waveguide, corrected for the number of waveguides."""
    tests = [
        test(waveguide_pairs)
        for waveguide_pairs in pairs
        for test in (by_trials, by_participants, by_mixed_model)
    ]
    kinds = [corrected(tests[kind::3]) for kind in range(3)]
    return [kind[row] for row in range(len(pairs)) for kind in kinds]


def by_each(pairs: list[Pairs]) -> list[Test]:
    """The test over trials of every participant alone, on every waveguide; corrected for their number."""
    return corrected(
        [
            replace(by_trials(waveguide_pairs.of(name)), participant=name, note="for each participant alone")
            for waveguide_pairs in pairs
            for name in waveguide_pairs.people
        ]
    )


def corrected(tests: list[Test]) -> list[Test]:
    """Simultaneous tests, corrected for their number by the rules of Bonferroni and of Holm."""
    order = sorted(range(len(tests)), key=lambda row: (math.isnan(tests[row].p), tests[row].p))
    tests_corrected, largest = list(tests), 0.0
    for rank, row in enumerate(order):
        largest = max(largest, min(1.0, tests[row].p * (len(tests) - rank)))
        holm = largest if math.isfinite(tests[row].p) else math.nan
        tests_corrected[row] = replace(tests[row].among(len(tests)), holm=holm)
    return tests_corrected


def conclusion(tests: list[Test], level: float = 0.05) -> str:
    """Conclusion about one waveguide, from its three tests, as a sentence."""
    by_name = {test.name: test for test in tests}
    assert len(by_name) == len(tests), "tests of one waveguide"
    trials, people = by_name["trials, as published"], by_name["participants"]
    where = f"{people.waveguide}, {counted(people.n, 'participant')}"
    if not math.isfinite(people.corrected):
        return f"{where}: {people.note}; the test over trials applies to these participants only."
    if people.corrected < level:
        return f"{where}: the difference is significant across participants (p = {people.corrected:.2g})."
    if trials.corrected < level:
        return (
            f"{where}: these participants show a difference, but too few for a conclusion about other people "
            f"(p = {people.corrected:.2g} across participants, {trials.corrected:.2g} across trials)."
        )
    return f"{where}: no significant difference (p = {people.corrected:.2g}); a difference may still exist."


def _paired(name: Name, waveguide: str, on: Array, off: Array, unit: str) -> Test:
    n = len(on)
    apart = on - off
    test = Test(name, waveguide, n, float(apart.mean()))
    if n < 2:
        return replace(test, note=f"one {unit} only: no variation to compare with")
    spread = float(apart.std(ddof=1))
    if spread <= ALIKE * float(np.abs(np.concatenate([on, off])).max()):
        return replace(test, note="all differences are equal: no variation to compare with")
    result = scipy.stats.ttest_rel(on, off)
    interval = result.confidence_interval(CONFIDENCE)
    mean_spread = 0.5 * float(on.std(ddof=1) + off.std(ddof=1))
    return replace(
        test,
        low=float(interval.low),
        high=float(interval.high),
        statistic=float(result.statistic),
        dof=float(result.df),
        p=float(result.pvalue),
        **effect_sizes(test.difference, spread, mean_spread, n),
        note=_few(n) if unit == "participant" else "trials of one participant are treated as independent",
    )


def _few(people: int) -> str:
    return "" if people >= 6 else f"{people} participants: the interval is wide, and assumes normality"
