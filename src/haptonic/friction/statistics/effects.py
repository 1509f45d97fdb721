"""How large the effect is: reductions with intervals clustered by participant; equivalence; drift."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import xarray as xr
from numpy.typing import NDArray
from scipy import stats

from haptonic.errors import FrictionError
from haptonic.friction.statistics.pairs import Pairs

Array = NDArray[np.float64]

DRAWS = 2000
QUANTILES = (0.025, 0.975)


@dataclass(frozen=True)
class Estimate:
    """A value, the ends of its 95 % interval (NaN where there is none, and `note` says why)."""

    value: float
    low: float
    high: float
    note: str = ""


def reduction(pairs: Pairs, *, draws: int = DRAWS, seed: int = 0) -> Estimate:
    """Reduction of friction, 1 - on / off, with a bootstrap interval clustered by participant.

    Participants are drawn first, then pairs of trials within each of them.
    """
    on, off = _resampled([pairs], draws, seed)[0]
    return _estimate(pairs.reduction, 1 - on / off, len(pairs.people))


def stopped(driven: Pairs, idle: Pairs, *, draws: int = DRAWS, seed: int = 0) -> Estimate:
    """Share of the driven region's reduction that does not reach the idle one, about 0.8 as published.

    The same participants are drawn for both regions.

    Raises
    ------
    FrictionError : other participants on one region than on the other
    """
    if set(driven.people) != set(idle.people):
        raise FrictionError(
            argument="pairs",
            given=" and ".join(f"{', '.join(one.people)} on {one.waveguide}" for one in (driven, idle)),
            allowed="the same participants on both",
            cause="all trials of a participant on one of them were excluded",
            next_step="leave this participant out of both",
        )
    (on, off), (idle_on, idle_off) = _resampled([driven, idle], draws, seed)
    with np.errstate(divide="ignore", invalid="ignore"):
        cloud = 1 - (1 - idle_on / idle_off) / (1 - on / off)
    value = 1 - idle.reduction / driven.reduction if driven.reduction != 0 else math.nan
    return _estimate(value, cloud, len(driven.people))


@dataclass(frozen=True)
class Equivalence:
    """Whether a reduction is too small to be felt: two one-sided t-tests over participants.

    bound : the largest reduction, and increase, that nobody feels, as a share
    mean, low, high : reduction, and the 90 % interval, which is the one that belongs to tests at 5 %
    p : the larger of both; p_above : that of the reduction being at least ``bound``, which alone is enough to
        call an idle region not slippery
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
    """TOST of the reduction of every participant against -bound and bound.

    Parameters
    ----------
    bound : 0.11, the Weber fraction (`haptonic.friction.lubrication.WEBER_FRACTION`), for what people feel

    Raises
    ------
    FrictionError : a bound that is no share
    """
    if not 0 < bound < 1:
        raise FrictionError(
            argument="bound",
            given=f"{bound}",
            allowed="a share above 0 and below 1",
            cause="a percentage was given",
            next_step="give 0.11 for 11 %",
        )
    on, off = pairs.means
    each = 1 - on / off
    made = Equivalence(pairs.waveguide, bound, len(each), float(each.mean()))
    if len(each) < 2 or float(each.std(ddof=1)) == 0:
        note = "one participant, or no variation between them: nothing can be said about others"
        return Equivalence(pairs.waveguide, bound, len(each), made.mean, note=note)
    error = float(each.std(ddof=1)) / math.sqrt(len(each))
    dof = len(each) - 1
    above = float(stats.t.cdf((made.mean - bound) / error, dof))
    below = float(stats.t.sf((made.mean + bound) / error, dof))
    reach = float(stats.t.ppf(0.95, dof)) * error
    return Equivalence(
        pairs.waveguide,
        bound,
        len(each),
        made.mean,
        made.mean - reach,
        made.mean + reach,
        max(above, below),
        above,
    )


def drift(trials: xr.Dataset) -> Estimate:
    """Relative change of friction over a session with the vibration off: learning, moisture, fatigue.

    A line through every participant's trials, as a share of their mean; the interval is Student's over
    participants. With one participant there is none.

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
        kept = usable[rows]
        if kept.sum() < 3:
            raise FrictionError(
                argument=f"trials of {name}",
                given=f"{int(kept.sum())} usable with the vibration off",
                allowed="at least 3",
                cause="most trials were excluded",
                next_step="leave this participant out, or look at the reasons for exclusion",
            )
        friction = trials["friction"].values[rows][kept]
        centred = _without_guides(friction, trials["waveguide"].values[rows][kept])
        slopes.append(float(np.polyfit(place[kept], centred, 1)[0] / friction.mean()))
    each = np.array(slopes)
    if len(each) < 2:
        return Estimate(float(each.mean()), math.nan, math.nan, "one participant only")
    error = float(each.std(ddof=1)) / math.sqrt(len(each))
    reach = float(stats.t.ppf(QUANTILES[1], len(each) - 1)) * error
    return Estimate(float(each.mean()), float(each.mean()) - reach, float(each.mean()) + reach)


def _without_guides(friction: Array, guide: NDArray[np.str_]) -> Array:
    """Friction less the mean of its waveguide: two plates of unequal roughness are no drift."""
    means = {name: friction[guide == name].mean() for name in set(guide)}
    return np.asarray(friction - np.array([means[name] for name in guide]))


def _resampled(many: list[Pairs], draws: int, seed: int) -> list[tuple[Array, Array]]:
    """(draws,) means on and off of every set of pairs, participants drawn alike for all of them."""
    rng = np.random.default_rng(seed)
    people = many[0].people
    chosen = rng.integers(len(people), size=(draws, len(people)))
    made = []
    for pairs in many:
        sums = np.zeros((2, draws))
        for number, name in enumerate(people):
            rows = np.flatnonzero(pairs.participant == name)
            hit = np.nonzero(chosen == number)[0]  # a draw as often as the participant is in it
            drawn = rng.integers(len(rows), size=(len(hit), len(rows)))
            for side, values in enumerate((pairs.on[rows], pairs.off[rows])):
                sums[side] += np.bincount(hit, values[drawn].mean(axis=1), draws)
        made.append((sums[0] / len(people), sums[1] / len(people)))
    return made


def _estimate(value: float, cloud: Array, people: int) -> Estimate:
    if people < 2:
        return Estimate(value, math.nan, math.nan, "one participant only: no interval for others")
    low, high = np.nanquantile(cloud, QUANTILES)
    note = "" if people >= 6 else f"{people} participants are few for a bootstrap: the interval is too narrow"
    return Estimate(value, float(low), float(high), note)
