"""Does the vibration change friction? The test as published, and the tests that the design allows.

Trials of one person are alike: sixty trials of three people are not 180 independent pairs. A test over trials
asks whether *these* people feel a difference, and finds one that other people need not show; a test over
participants, and a mixed model in which every participant has an effect of his or her own, ask about people.
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

Name = Literal["trials, as published", "participants", "mixed model"]

CONFIDENCE = 0.95
OPTIMISERS = ["lbfgs", "powell"]  # the second where a variance goes to zero and the first stops
ALIKE = 1e-12  # relative to friction: differences that vary less do not vary


@dataclass(frozen=True)
class Test:
    """One test of the difference of friction, on less off. What cannot be had is NaN, and `note` says why.

    name, waveguide : which test, of what
    n : number of its units: pairs of trials, or participants
    difference : mean, on less off; low, high : its 95 % confidence interval
    statistic, dof : Student's t and its degrees of freedom
    p : two-sided, for itself; corrected : times the number of tests made at once (Bonferroni); holm : by the
        rule of Holm, which promises the same and finds more
    d_z : mean difference over the standard deviation of the differences, t / sqrt(n)
    d_av : mean difference over the mean of the standard deviations on and off
    d_z_low, d_z_high, d_av_low, d_av_high : their 95 % intervals, see `sizes`
    participant : whose trials alone were tested; empty for all of them
    """

    __test__ = False  # no test in pytest's sense

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
    """The paired t-test over trials, as published: it takes the trials of one person for independent."""
    return _paired("trials, as published", pairs.waveguide, pairs.on, pairs.off, "pair of trials")


def by_participants(pairs: Pairs) -> Test:
    """The paired t-test over the means of the participants."""
    on, off = pairs.means
    return _paired("participants", pairs.waveguide, on, off, "participant")


def by_mixed_model(pairs: Pairs) -> Test:
    """Linear mixed model of all trials: a level and an effect of his or her own for every participant.

    Trial t of participant i has the friction ``y_it = (m + a_i) + (d + b_i) x_it + e_it`` with x = +1/2 on
    and -1/2 off; a_i, b_i and e_it are normal and independent of each other. Restricted maximum likelihood
    (statsmodels); the effect over its standard error is compared with Student's t with one degree of freedom
    less than there are participants, as in a balanced design, not with a normal distribution, which would
    reject far too often with few participants.
    """
    # half a second of every start of the program otherwise
    from statsmodels.regression.mixed_linear_model import MixedLM, MixedLMParams

    people = len(pairs.people)
    difference = float(np.mean(np.subtract(*pairs.means)))
    made = Test("mixed model", pairs.waveguide, people, difference)
    friction = np.concatenate([pairs.on, pairs.off])
    scale = float(friction.std())
    if people < 2:
        return replace(made, note="one participant only: nothing can be said about others")
    if scale <= ALIKE * float(np.abs(friction).max()) or len(pairs.on) <= people:
        return replace(made, note="too few trials, or trials that do not vary: there is nothing to fit")
    coding = np.repeat([0.5, -0.5], len(pairs.on))
    design = np.column_stack([np.ones_like(coding), coding])
    independent = MixedLMParams.from_components(fe_params=np.ones(2), cov_re=np.eye(2))
    with warnings.catch_warnings():
        # a random part that comes out as zero lies on the edge of what is allowed: no reason for a warning
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
        return replace(made, note="the fit did not converge: too few participants for its random parts")
    dof = people - 1
    reach = float(scipy.stats.t.ppf(0.5 + CONFIDENCE / 2, dof)) * error
    statistic = effect / error
    return replace(
        made,
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
    tests = [test(one) for one in pairs for test in (by_trials, by_participants, by_mixed_model)]
    kinds = [corrected(tests[kind::3]) for kind in range(3)]
    return [kind[row] for row in range(len(pairs)) for kind in kinds]


def by_each(pairs: list[Pairs]) -> list[Test]:
    """The test over trials of every participant by himself or herself, on every waveguide; all corrected."""
    return corrected(
        [
            replace(by_trials(one.of(name)), participant=name, note="speaks of each participant alone")
            for one in pairs
            for name in one.people
        ]
    )


def corrected(tests: list[Test]) -> list[Test]:
    """Tests made at once, corrected for their number by the rules of Bonferroni and of Holm."""
    order = sorted(range(len(tests)), key=lambda row: (math.isnan(tests[row].p), tests[row].p))
    made, largest = list(tests), 0.0
    for rank, row in enumerate(order):
        largest = max(largest, min(1.0, tests[row].p * (len(tests) - rank)))
        holm = largest if math.isfinite(tests[row].p) else math.nan
        made[row] = replace(tests[row].among(len(tests)), holm=holm)
    return made


def conclusion(tests: list[Test], level: float = 0.05) -> str:
    """What may be said about one waveguide, from its three tests."""
    found = {test.name: test for test in tests}
    assert len(found) == len(tests), "tests of one waveguide"
    trials, people = found["trials, as published"], found["participants"]
    where = f"{people.waveguide}, {people.n} participant{'s' * (people.n != 1)}"
    if not math.isfinite(people.corrected):
        return f"{where}: {people.note}; the test over trials speaks of these participants only."
    if people.corrected < level:
        return (
            f"{where}: friction differs, also for people who did not take part (p = {people.corrected:.2g})."
        )
    if trials.corrected < level:
        return (
            f"{where}: these participants show a difference, but so few cannot show that others would "
            f"(p = {people.corrected:.2g} by participants, {trials.corrected:.2g} by trials)."
        )
    return f"{where}: no difference is shown (p = {people.corrected:.2g}); that does not prove there is none."


def _paired(name: Name, waveguide: str, on: Array, off: Array, unit: str) -> Test:
    n = len(on)
    apart = on - off
    made = Test(name, waveguide, n, float(apart.mean()))
    if n < 2:
        return replace(made, note=f"one {unit} only: no variation to compare with")
    spread = float(apart.std(ddof=1))
    if spread <= ALIKE * float(np.abs(np.concatenate([on, off])).max()):
        return replace(made, note="all differences are equal: no variation to compare with")
    result = scipy.stats.ttest_rel(on, off)
    interval = result.confidence_interval(CONFIDENCE)
    mean_spread = 0.5 * float(on.std(ddof=1) + off.std(ddof=1))
    return replace(
        made,
        low=float(interval.low),
        high=float(interval.high),
        statistic=float(result.statistic),
        dof=float(result.df),
        p=float(result.pvalue),
        **effect_sizes(made.difference, spread, mean_spread, n),
        note=_few(n) if unit == "participant" else "trials of one participant are treated as independent",
    )


def _few(people: int) -> str:
    return "" if people >= 6 else f"{people} participants: the interval is wide, and rests on normality"
