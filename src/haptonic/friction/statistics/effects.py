"""Effect sizes: reductions, for the population and for these participants; equivalence; drift.

There are two kinds of interval. A reduction *in the population* is estimated from the differences between
participants: Student's t over them, which is wide for three participants, and whose coverage is nominal from
two on. The reduction *for these participants*, averaged over infinitely many strokes, is estimated from the
scatter of their trials: a bootstrap of trials within each participant, which is narrow and does not apply to
other people.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np
import scipy
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.errors import FrictionError
from haptonic.friction.statistics.pairs import Pairs
from haptonic.later import xarray as xr
from haptonic.names import counted, listed

About = Literal["people", "these participants"]

DRAWS = 2000
QUANTILES = (0.025, 0.975)
FEWEST_FOR_A_BOOTSTRAP = 15  # pairs of one participant


@dataclass(frozen=True)
class IntervalEstimate:
    """A value with its 95 % interval; the ends are NaN if it has none, and `note` gives the reason.

    about : group of people that the interval applies to
    """

    value: float
    low: float
    high: float
    note: str = ""
    about: About = "people"


def reduction(pairs: Pairs) -> IntervalEstimate:
    """Reduction of friction, 1 - on / off, with Student's interval over participants, for the population.

    The ratio of two means over participants is linearised: the contribution of a participant to its deviation
    is (on - ratio off) / mean off.
    """
    return _among_people(pairs.reduction, _contributions(pairs))


def stopped(driven: Pairs, idle: Pairs) -> IntervalEstimate:
    """Share of the driven region's reduction that does not reach the idle region, about 0.8 as published.

    Student's interval over participants, for the population, linearised as in `reduction`. The share is NaN
    if the driven region's reduction may be zero.

    Raises
    ------
    FrictionError : the participants of the two regions differ
    """
    _check_the_same_people(driven, idle)
    if driven.reduction == 0:
        return IntervalEstimate(math.nan, math.nan, math.nan, "no reduction on the driven region")
    shares = idle.reduction / driven.reduction
    least = reduction(driven)
    if len(driven.people) >= 2 and not (least.low > 0 or least.high < 0):
        return IntervalEstimate(
            math.nan, math.nan, math.nan, "the reduction on the driven region may be zero"
        )
    place = [idle.people.index(name) for name in driven.people]
    apart = shares * _contributions(driven) - _contributions(idle)[place]
    return _among_people(1 - shares, apart / driven.reduction)


def reduction_here(pairs: Pairs, *, draws: int = DRAWS, seed: int = 0) -> IntervalEstimate:
    """Reduction of friction with an interval for these participants, by resampling pairs within each."""
    on, off = _resampled(pairs, draws, np.random.default_rng(seed))
    return _among_these(pairs.reduction, 1 - on / off, pairs)


def stopped_here(driven: Pairs, idle: Pairs, *, draws: int = DRAWS, seed: int = 0) -> IntervalEstimate:
    """As `stopped`, with an interval for these participants, by resampling pairs within each.

    Raises
    ------
    FrictionError : the participants of the two regions differ
    """
    _check_the_same_people(driven, idle)
    rng = np.random.default_rng(seed)
    (on, off), (idle_on, idle_off) = (_resampled(pairs, draws, rng) for pairs in (driven, idle))
    with np.errstate(divide="ignore", invalid="ignore"):
        cloud = 1 - (1 - idle_on / idle_off) / (1 - on / off)
    value = 1 - idle.reduction / driven.reduction if driven.reduction != 0 else math.nan
    return _among_these(value, cloud, driven)


@dataclass(frozen=True)
class Equivalence:
    """Test for a reduction too small to be felt: two one-sided t-tests over participants.

    bound : the largest reduction, and increase, that people do not feel, as a share
    mean, low, high : reduction, and its 90 % interval, which corresponds to tests at 5 %
    p : the larger p-value of the two tests
    p_above : p-value against a reduction of at least ``bound``; alone enough to call an idle region not
        slippery
    """

    waveguide: str
    bound: float
    n: int
    mean: float
    low: float = math.nan
    high: float = math.nan
    p: float = math.nan
    p_above: float = math.nan
    note: str = ""


def equivalence(pairs: Pairs, bound: float) -> Equivalence:
    """Two one-sided tests (TOST) of the reduction of every participant against -bound and bound.

    Parameters
    ----------
    bound : such as 0.11, the Weber fraction (`haptonic.friction.lubrication.WEBER_FRACTION`)

    Raises
    ------
    FrictionError : a bound that is not a share
    """
    if not 0 < bound < 1:
        raise FrictionError.out_of_range(
            argument="bound",
            given=f"{bound}",
            allowed="a share above 0 and below 1",
            cause="a percentage was given",
            next_step="give 0.11 for 11 %",
        )
    on, off = pairs.means
    each = 1 - on / off
    estimate = Equivalence(pairs.waveguide, bound, len(each), float(each.mean()))
    if len(each) < 2 or float(each.std(ddof=1)) == 0:
        note = "one participant, or no variation between them: no conclusion about other people"
        return Equivalence(pairs.waveguide, bound, len(each), estimate.mean, note=note)
    error = float(each.std(ddof=1)) / math.sqrt(len(each))
    dof = len(each) - 1
    above = float(scipy.stats.t.cdf((estimate.mean - bound) / error, dof))
    below = float(scipy.stats.t.sf((estimate.mean + bound) / error, dof))
    reach = float(scipy.stats.t.ppf(0.95, dof)) * error
    return Equivalence(
        waveguide=pairs.waveguide,
        bound=bound,
        n=len(each),
        mean=estimate.mean,
        low=estimate.mean - reach,
        high=estimate.mean + reach,
        p=max(above, below),
        p_above=above,
    )


def drift(trials: xr.Dataset) -> IntervalEstimate:
    """Relative change of friction over a session with the vibration off: learning, moisture, fatigue.

    It is the slope of a line through every participant's trials, relative to their mean; the interval is
    Student's over participants. One participant gives no interval.

    Raises
    ------
    FrictionError : a participant with fewer than three usable trials
    """
    slopes = []
    people = trials["participant"].values
    usable = (trials["excluded"].values == "") & (trials["actuation"].values == "off")
    for name in dict.fromkeys(people):
        rows = np.flatnonzero(people == name)
        order = np.lexsort((trials["trial"].values[rows], trials["block"].values[rows])).argsort()
        place = order / max(len(rows) - 1, 1)
        rows_used = usable[rows]
        if rows_used.sum() < 3:
            recorded = int((trials["actuation"].values[rows] == "off").sum())
            raise FrictionError.too_few(
                argument=f"trials of {name}",
                given=f"{int(rows_used.sum())} usable with the vibration off",
                allowed="at least 3",
                cause=f"{recorded - int(rows_used.sum())} trials were excluded"
                if recorded >= 3
                else f"the table has {counted(recorded, 'trial')} of this kind",
                next_step="leave this participant out, or look at the reasons for exclusion"
                if recorded >= 3
                else "leave this participant out, or add trials without vibration",
            )
        friction = trials["friction"].values[rows][rows_used]
        guide = trials["waveguide"].values[rows][rows_used]
        # both less the means of their region: a region that is felt later is not a drift, and its mean
        # contains a part of the drift
        moved, change = _without_guides(place[rows_used], guide), _without_guides(friction, guide)
        spread = float(moved @ moved)
        if spread == 0:
            raise FrictionError.too_few(
                argument=f"trials of {name}",
                given="one trial with the vibration off in each region",
                allowed="two of a region",
                cause="a drift cannot be distinguished from a difference of the regions",
                next_step="leave this participant out, or add trials without vibration",
            )
        slopes.append(float(moved @ change) / spread / float(friction.mean()))
    each = np.array(slopes)
    if len(each) < 2:
        return IntervalEstimate(float(each.mean()), math.nan, math.nan, "one participant only")
    error = float(each.std(ddof=1)) / math.sqrt(len(each))
    reach = float(scipy.stats.t.ppf(QUANTILES[1], len(each) - 1)) * error
    return IntervalEstimate(float(each.mean()), float(each.mean()) - reach, float(each.mean()) + reach)


def _without_guides(values: Array, guide: NDArray[np.str_]) -> Array:
    """Values less the mean of their waveguide, because plates of unequal roughness are not a drift."""
    means = {name: values[guide == name].mean() for name in set(guide)}
    return np.asarray(values - np.array([means[name] for name in guide]))


def _check_the_same_people(driven: Pairs, idle: Pairs) -> None:
    if set(driven.people) != set(idle.people):
        raise FrictionError.mismatch(
            argument="pairs",
            given=listed([f"{', '.join(pairs.people)} on {pairs.waveguide}" for pairs in (driven, idle)]),
            allowed="the same participants on both",
            cause="all trials of a participant on one of them were excluded",
            next_step="leave this participant out of both",
        )


def _contributions(pairs: Pairs) -> Array:
    """(participant,) contribution of each to the reduction, times their number; the sum is zero."""
    on, off = pairs.means
    return np.asarray(-(on - (1 - pairs.reduction) * off) / off.mean())


def _among_people(value: float, each: Array) -> IntervalEstimate:
    people = len(each)
    if people < 2:
        return IntervalEstimate(value, math.nan, math.nan, "one participant only: no interval for others")
    error = float(each.std(ddof=1)) / math.sqrt(people)
    reach = float(scipy.stats.t.ppf(QUANTILES[1], people - 1)) * error
    note = "" if people >= 6 else f"{people} participants: the interval is wide, and assumes normality"
    return IntervalEstimate(value, value - reach, value + reach, note)


def _resampled(pairs: Pairs, draws: int, rng: np.random.Generator) -> tuple[Array, Array]:
    """(draws,) means on and off over the same participants, with pairs resampled within each of them."""
    sums = np.zeros((2, draws))
    for name in pairs.people:
        rows = np.flatnonzero(pairs.participant == name)
        drawn = rows[rng.integers(len(rows), size=(draws, len(rows)))]
        for side, values in enumerate((pairs.on, pairs.off)):
            sums[side] += values[drawn].mean(axis=1)
    return sums[0] / len(pairs.people), sums[1] / len(pairs.people)


def _among_these(value: float, cloud: Array, pairs: Pairs) -> IntervalEstimate:
    fewest = min(int((pairs.participant == name).sum()) for name in pairs.people)
    if fewest < 2 or np.isnan(cloud).all():
        note = "no draw of the trials has a reduction"
        if fewest < 2:
            note = "a participant with a single pair of trials: their scatter is unknown"
        return IntervalEstimate(
            value=value, low=math.nan, high=math.nan, note=note, about="these participants"
        )
    low, high = np.nanquantile(cloud, QUANTILES)
    note = "for these participants only"
    if fewest < FEWEST_FOR_A_BOOTSTRAP:
        note += f"; {fewest} pairs are few for a bootstrap: the interval is too narrow"
    return IntervalEstimate(
        value=value, low=float(low), high=float(high), note=note, about="these participants"
    )
