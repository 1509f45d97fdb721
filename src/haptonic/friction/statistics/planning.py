"""Planning by simulation: participants and trials needed, and rates of false alarms of the tests."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import scipy

from haptonic.errors import FrictionError, shown
from haptonic.friction.statistics.comparison import by_mixed_model, by_participants, by_trials
from haptonic.friction.statistics.pairs import Pairs
from haptonic.later import xarray as xr

SHARP = 1e-3  # accuracy of the smallest reduction


@dataclass(frozen=True)
class Population:
    """Assumptions about people for planning an experiment, all relative to the mean friction.

    reduction : mean of the population
    effect_between : standard deviation of the reduction between people
    within : standard deviation of a trial about the mean of its participant and condition
    between : standard deviation of the level between people; pairing removes it
    """

    reduction: float
    effect_between: float
    within: float = 0.22
    between: float = 0.15

    def __post_init__(self) -> None:
        for name in ("reduction", "effect_between", "within", "between"):
            value = getattr(self, name)
            number = isinstance(value, int | float) and not isinstance(value, bool)
            if not (number and 0 <= value < 1):
                raise _bad(f"population.{name}", value, "a share from 0 to 1", "a percentage was given")

    def drawn(self, participants: int, trials: int, rng: np.random.Generator) -> Pairs:
        """Draw the pairs of one experiment; ``trials`` is the number in each condition."""
        level = 1 + self.between * rng.standard_normal((participants, 1))
        left = 1 - self.reduction + self.effect_between * rng.standard_normal((participants, 1))
        noise = self.within * rng.standard_normal((2, participants, trials))
        names = np.repeat([f"P{number + 1}" for number in range(participants)], trials)
        on, off = level * left + noise[0], level + noise[1]
        return Pairs("simulated", names, on.ravel(), off.ravel(), omitted=0)


def power(
    population: Population,
    participants: list[int],
    trials: list[int],
    *,
    tests: int = 2,
    level: float = 0.05,
    simulations: int = 2000,
    seed: int = 0,
) -> xr.Dataset:
    """Power of the test over participants, from simulated experiments.

    Parameters
    ----------
    participants, trials : numbers to try; trials in one condition, for one participant
    tests : number of simultaneous tests (Bonferroni): two waveguides
    level : significance level of all tests together

    Returns
    -------
    ``power`` and ``error``, its Monte-Carlo standard error, on (participants, trials)

    Raises
    ------
    FrictionError : fewer than 2 participants, no trials, or too few simulations
    """
    _counts("participants", participants, 2)
    _counts("trials", trials, 1)
    _counts("simulations", [simulations], 100)
    rng = np.random.default_rng(seed)
    chance = np.empty((len(participants), len(trials)))
    for row, people in enumerate(participants):
        for column, strokes in enumerate(trials):
            noise = math.sqrt(2 / strokes) * population.within * rng.standard_normal((simulations, people))
            level_of_each = 1 + population.between * rng.standard_normal((simulations, people))
            effect = population.reduction + population.effect_between * rng.standard_normal(
                (simulations, people)
            )
            p = scipy.stats.ttest_1samp(noise - level_of_each * effect, 0.0, axis=1).pvalue
            chance[row, column] = (p * tests < level).mean()
    dims = ("participants", "trials")
    error = np.sqrt(chance * (1 - chance) / simulations)
    return xr.Dataset(
        {"power": (dims, chance), "error": (dims, error)},
        coords={"participants": participants, "trials": trials},
        attrs={
            "origin": "simulated",
            "tests": tests,
            "level": level,
            "simulations": simulations,
            "seed": seed,
        },
    )


def expected_power(
    population: Population, participants: int, trials: int, *, tests: int = 2, level: float = 0.05
) -> float:
    """Power of the test over participants from the noncentral t distribution, without simulation.

    The mean difference of a participant is taken as normal, with the variance of the product of level and
    reduction. `power` simulates the product itself; both agree to 0.005.
    """
    spread = math.sqrt(
        2 / trials * population.within**2
        + (population.between * population.reduction) ** 2
        + population.effect_between**2 * (1 + population.between**2)
    )
    if spread == 0:
        return float(population.reduction > 0)
    bound = scipy.stats.t.isf(level / (2 * tests), participants - 1)
    shift = population.reduction / spread * math.sqrt(participants)
    # both tails as upper ones: scipy's lower one is NaN far from the mean
    return float(sum(scipy.stats.nct(participants - 1, side).sf(bound) for side in (shift, -shift)))


def participants_needed(
    population: Population, trials: int, *, wanted: float = 0.8, most: int = 60
) -> int | None:
    """Smallest number of participants for an `expected_power` of ``wanted``; None above ``most``.

    Raises
    ------
    FrictionError : a power outside of 0 to 1, or no trials
    """
    if not 0 < wanted < 1:
        raise _bad("wanted", wanted, "a chance above 0 and below 1", "a percentage was given")
    _counts("trials", [trials], 1)
    tried = (people for people in range(2, most + 1) if expected_power(population, people, trials) >= wanted)
    return next(tried, None)


def smallest_shown(
    population: Population, participants: int, trials: int, *, wanted: float = 0.8
) -> float | None:
    """Smallest reduction that a design detects with an `expected_power` of ``wanted``, to 0.001.

    Only the reduction of the population changes. None if no reduction reaches the power.

    Raises
    ------
    FrictionError : fewer than 2 participants, or no trials
    """
    _counts("participants", [participants], 2)
    _counts("trials", [trials], 1)
    low, high = 0.0, 0.999

    def chance(reduction: float) -> float:
        return expected_power(replace(population, reduction=reduction), participants, trials)

    if chance(high) < wanted:
        return None
    while high - low > SHARP:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if chance(middle) >= wanted else (middle, high)
    return high


Alarms = tuple[float, float, int]
"""Rate, its standard error, and the number of experiments."""


def false_alarms(
    population: Population,
    participants: int,
    trials: int,
    *,
    level: float = 0.05,
    simulations: int = 400,
    seed: int = 0,
) -> dict[str, Alarms]:
    """Rate at which each test finds a difference although the population has none.

    The population's reduction is set to zero; people still differ.

    Returns
    -------
    name of the test -> rate, its standard error, and the number of experiments in which it could be computed

    Raises
    ------
    FrictionError : fewer than 2 participants, no trials, or too few simulations
    """
    _counts("participants", [participants], 2)
    _counts("trials", [trials], 2)
    _counts("simulations", [simulations], 20)
    rng = np.random.default_rng(seed)
    null = Population(0.0, population.effect_between, population.within, population.between)
    values: dict[str, list[float]] = {}
    for _ in range(simulations):
        pairs = null.drawn(participants, trials, rng)
        for test in (by_trials(pairs), by_participants(pairs), by_mixed_model(pairs)):
            values.setdefault(test.name, []).append(test.p)
    rates = {}
    for name, many in values.items():
        computed = [p for p in many if math.isfinite(p)]
        rate = float(np.mean([p < level for p in computed])) if computed else math.nan
        rates[name] = rate, math.sqrt(max(rate * (1 - rate), 1e-12) / max(len(computed), 1)), len(computed)
    return rates


def _counts(name: str, numbers: list[int], least: int) -> None:
    whole = [isinstance(n, int) and not isinstance(n, bool) and n >= least for n in numbers]
    if not numbers or not all(whole):
        raise _bad(name, numbers, f"whole numbers from {least}", "with fewer, the test cannot be computed")


def _bad(name: str, given: object, allowed: str, cause: str) -> FrictionError:
    return FrictionError.out_of_range(
        argument=name,
        given=shown(given),
        allowed=allowed,
        cause=cause,
        next_step=f"give {allowed}",
    )
