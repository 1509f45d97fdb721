"""Summary of a table of trials in one value; missing results are listed with their reasons."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import FrictionError
from haptonic.friction.lubrication import WEBER_FRACTION
from haptonic.friction.signals.record import EVERYBODY
from haptonic.friction.statistics.comparison import Test, by_each, compared, conclusion
from haptonic.friction.statistics.effects import (
    Equivalence,
    IntervalEstimate,
    drift,
    equivalence,
    reduction,
    reduction_here,
    stopped,
    stopped_here,
)
from haptonic.friction.statistics.pairs import Pairs, check_waveguide, paired
from haptonic.later import xarray as xr

SIDES = ("off", "on")
MOST_NAMED = 5  # participants with unequal conditions


@dataclass(frozen=True)
class Condition:
    """Trials of one waveguide with the vibration on or off, of one participant or of all.

    used, excluded : numbers of trials
    friction, by_means : (mean, standard deviation) over trials of the mean of ratios and the ratio of means
    force, speed : (mean, standard deviation), N and m/s; NaN if not recorded
    """

    participant: str
    waveguide: str
    actuation: str
    used: int
    excluded: int
    friction: tuple[float, float]
    by_means: tuple[float, float]
    force: tuple[float, float]
    speed: tuple[float, float]


@dataclass(frozen=True)
class Summary:
    """Tests and estimates from trials; `omissions` gives the reason for each missing one.

    driven : waveguide with the vibration
    idle : the other waveguides
    chosen : reason for the choice of ``driven``
    tests : of all participants together, three for each waveguide
    each : tests of every participant alone
    reductions : waveguide -> reduction in the population
    own : (waveguide, participant) -> reduction from this participant's trials
    stopped : idle waveguide -> share of the driven reduction that does not reach it
    stopped_here : the same with an interval for these participants, by bootstrap
    equivalences : of idle waveguides, against the largest reduction that people do not feel
    drift : of friction over a session, or None
    conclusions : a sentence for each waveguide
    """

    driven: str | None
    idle: tuple[str, ...]
    chosen: str
    conditions: tuple[Condition, ...]
    tests: tuple[Test, ...]
    each: tuple[Test, ...]
    reductions: dict[str, IntervalEstimate]
    own: dict[tuple[str, str], IntervalEstimate]
    stopped: dict[str, IntervalEstimate]
    stopped_here: dict[str, IntervalEstimate]
    equivalences: tuple[Equivalence, ...]
    drift: IntervalEstimate | None
    conclusions: tuple[str, ...]
    omissions: tuple[str, ...]


def summary(trials: xr.Dataset, driven: str | None = None) -> Summary:
    """Compute all tests and estimates from a table of trials.

    Parameters
    ----------
    driven : the waveguide with the vibration; by default the one with the largest reduction

    Raises
    ------
    FrictionError : an unknown waveguide
    """
    guides = list(dict.fromkeys(str(name) for name in trials["waveguide"].values))
    if driven is not None:
        check_waveguide("trials.driven", driven, guides)
    omissions = []
    pairs: dict[str, Pairs] = {}
    for guide in guides:
        try:
            pairs[guide] = paired(trials, guide)
        except FrictionError as error:
            omissions.append(f"{guide}: no test; {error.given}; {error.cause}")
    chosen = "given in the study"
    if driven is None and pairs:
        driven = max(pairs, key=lambda guide: pairs[guide].reduction)
        chosen = "waveguide with the largest reduction; the study gives none"
    guides.sort(key=lambda guide: guide != driven)
    pairs = {guide: pairs[guide] for guide in guides if guide in pairs}
    conditions = tuple(conditions_of(trials, guides))
    unequal = list(_unequal(conditions))
    more = len(unequal) - MOST_NAMED
    omissions += [*unequal[:MOST_NAMED], *[f"the same of {more} other participants"] * (more > 0)]
    all_pairs = list(pairs.values())
    tests = compared(all_pairs)
    reductions = {guide: reduction(guide_pairs) for guide, guide_pairs in pairs.items()}
    idle = tuple(guide for guide in guides if guide != driven)
    shares, shares_here = {}, {}
    for guide in idle:
        try:
            if driven in pairs and guide in pairs:
                both = _same_people(pairs[driven], pairs[guide], omissions)
                shares[guide], shares_here[guide] = stopped(*both), stopped_here(*both)
        except FrictionError as error:
            omissions.append(f"share stopped before {guide}: {error.given}; {error.cause}")
    drifted = None
    try:
        drifted = drift(trials)
    except FrictionError as error:
        omissions.append(f"drift: {error.argument}: {error.given}; {error.cause}")
    return Summary(
        driven=driven,
        idle=idle,
        chosen=chosen if driven else "no waveguide can be tested",
        conditions=conditions,
        tests=tuple(tests),
        each=tuple(by_each(all_pairs)),
        reductions=reductions,
        own={
            (guide, name): reduction_here(guide_pairs.of(name))
            for guide, guide_pairs in pairs.items()
            for name in guide_pairs.people
        },
        stopped=shares,
        stopped_here=shares_here,
        equivalences=tuple(equivalence(pairs[guide], WEBER_FRACTION) for guide in idle if guide in pairs),
        drift=drifted,
        conclusions=tuple(conclusion([test for test in tests if test.waveguide == guide]) for guide in pairs),
        omissions=tuple(omissions),
    )


def conditions_of(trials: xr.Dataset, guides: list[str]) -> Iterator[Condition]:
    """Every condition of every participant and, if there are several, of all together."""
    columns = {name: trials[name].values for name in ("participant", "waveguide", "actuation", "excluded")}
    people = list(dict.fromkeys(columns["participant"].tolist()))
    for person in [*people, *[EVERYBODY] * (len(people) > 1)]:
        for guide in guides:
            for side in SIDES:
                rows = (columns["waveguide"] == guide) & (columns["actuation"] == side)
                if person != EVERYBODY:
                    rows &= columns["participant"] == person
                good = rows & (columns["excluded"] == "")
                yield Condition(
                    participant=person, waveguide=guide, actuation=side, used=int(good.sum()),
                    excluded=int(rows.sum() - good.sum()), friction=_spread(trials, "friction", good),
                    by_means=_spread(trials, "ratio_of_means", good), force=_spread(trials, "force", good),
                    speed=_spread(trials, "speed", good),
                )  # fmt: skip


def _spread(trials: xr.Dataset, name: str, rows: NDArray[np.bool_]) -> tuple[float, float]:
    values = trials[name].values[rows] if name in trials else np.empty(0)
    values = values[np.isfinite(values)]
    mean = float(values.mean()) if values.size else math.nan
    return mean, float(values.std(ddof=1)) if values.size > 1 else math.nan


def _unequal(conditions: tuple[Condition, ...]) -> Iterator[str]:
    """Sentences on participants with conditions that have no trial, or unequal numbers of trials."""
    for person in dict.fromkeys(c.participant for c in conditions if c.participant != EVERYBODY):
        names = {
            f"{condition.waveguide} {condition.actuation}": condition.used
            for condition in conditions
            if condition.participant == person
        }
        missing = [name for name, used in names.items() if not used]
        if missing:
            yield f"{person}: no valid trial on {', '.join(missing)}"
        elif len(set(names.values())) > 1:
            listed = ", ".join(f"{name}: {used}" for name, used in names.items())
            yield f"{person}: unequal numbers of trials ({listed})"


def _same_people(driven: Pairs, idle: Pairs, omissions: list[str]) -> tuple[Pairs, Pairs]:
    """Both without participants who have pairs on only one of them."""
    both = [name for name in driven.people if name in idle.people]
    left_out = sorted(set(driven.people) ^ set(idle.people))
    if not left_out or not both:
        return driven, idle
    omissions.append(
        f"share stopped before {idle.waveguide}: without {', '.join(left_out)}, who has pairs on one "
        "waveguide only"
    )
    return _of(driven, both), _of(idle, both)


def _of(pairs: Pairs, people: list[str]) -> Pairs:
    rows = np.isin(pairs.participant, people)
    return replace(pairs, participant=pairs.participant[rows], on=pairs.on[rows], off=pairs.off[rows])
