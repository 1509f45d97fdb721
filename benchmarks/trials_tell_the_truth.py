"""Claim: the analysis of a simulated experiment returns its truth within the intervals that it states.

For each of a number of seeds, three people are simulated who stroke the prototype's two waveguides 240 times
each, with friction by load sharing; their force records are processed and analysed as measured ones would be.
With more people the coefficients are taken as they are, without force records, which makes many experiments
cheap. With amplitudes of zero nobody's friction changes on average: alarms of each test are counted.
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from typing import Any

import numpy as np
import xarray as xr
from record import STUDY, timed, write
from scipy import stats

import haptonic
from haptonic.analyses.experiments import protocol_of, truth_of
from haptonic.friction.protocol import Protocol
from haptonic.friction.signals import measured
from haptonic.friction.simulation import Truth, coefficients, people, strokes
from haptonic.friction.statistics import (
    Pairs,
    by_mixed_model,
    by_participants,
    by_trials,
    paired,
    reduction,
    reduction_here,
    stopped,
    stopped_here,
)

LEVEL = 0.05
MORE_PEOPLE = (3, 4, 6, 8, 12)
GROUP = 3
MORE = 5  # times as many experiments for the quick tests as for the mixed model


def processed(truth: Truth, protocol: Protocol, seed: int) -> tuple[Pairs, Pairs]:
    """Pairs of both waveguides, from force records."""
    simulated = strokes(truth, protocol, GROUP, seed)
    trials = measured((label, record) for label, record, _ in simulated)
    driven, idle = (paired(trials, guide) for guide in protocol.waveguides)
    return driven, idle


def as_they_are(truth: Truth, protocol: Protocol, number: int, *seed: int) -> tuple[Pairs, Pairs]:
    """Pairs of both waveguides, from the coefficients themselves."""
    rows = list(coefficients(truth, protocol, number, np.random.default_rng(seed)))
    names = ("participant", "block", "trial", "waveguide", "actuation")
    table = {name: np.array([getattr(label, name) for label, _ in rows]) for name in names}
    table |= {"friction": np.array([friction for _, friction in rows]), "excluded": np.full(len(rows), "")}
    trials = xr.Dataset({name: ("stroke", values) for name, values in table.items()})
    driven, idle = (paired(trials, guide) for guide in protocol.waveguides)
    return driven, idle


def within(hits: list[bool]) -> dict[str, Any]:
    """How often, and what 95 times in 100 would make of so many experiments (95 % of all such counts)."""
    low, high = stats.binom.interval(0.95, len(hits), 0.95)
    return {"held": int(sum(hits)), "of": len(hits), "expected": [int(low), int(high)]}


def covered(truth: Truth, protocol: Protocol, seeds: int) -> dict[str, Any]:
    """Intervals of processed strokes against what is true of the population, and of the very people."""
    guides = protocol.waveguides
    left = [truth.remaining[guide] for guide in guides]
    population = {"driven": 1 - left[0], "idle": 1 - left[1], "stopped": 1 - (1 - left[1]) / (1 - left[0])}
    hits: dict[str, list[bool]] = {}
    off: dict[str, list[float]] = {}
    for seed in range(seeds):
        pairs = processed(truth, protocol, seed)
        group = people(truth, GROUP, np.random.default_rng(seed))
        level = np.array([person.friction for person in group])
        here = [
            1 - (level * [person.remaining[guide] for person in group]).mean() / level.mean()
            for guide in guides
        ]
        own = {"driven": here[0], "idle": here[1], "stopped": 1 - here[1] / here[0]}
        estimates = {
            "people": {
                "driven": reduction(pairs[0]),
                "idle": reduction(pairs[1]),
                "stopped": stopped(*pairs),
            },
            "these participants": {
                "driven": reduction_here(pairs[0], seed=seed),
                "idle": reduction_here(pairs[1], seed=seed),
                "stopped": stopped_here(*pairs, seed=seed),
            },
        }
        for about, true in (("people", population), ("these participants", own)):
            for name, estimate in estimates[about].items():
                hits.setdefault(f"{name}, {about}", []).append(
                    bool(estimate.low < true[name] < estimate.high)
                )
                off.setdefault(f"{name}, {about}", []).append(estimate.value - true[name])
        print(f"seed {seed + 1} of {seeds}", flush=True)
    return {
        name: within(held) | {"bias": float(np.mean(off[name])), "spread": float(np.std(off[name]))}
        for name, held in hits.items()
    } | {"true": population}


def with_more_people(truth: Truth, protocol: Protocol, experiments: int) -> list[dict[str, Any]]:
    """The intervals for people, of coefficients without force records."""
    true = 1 - np.array([truth.remaining[guide] for guide in protocol.waveguides])
    rows = []
    for number in MORE_PEOPLE:
        hits: dict[str, list[bool]] = {"driven": [], "idle": [], "stopped": []}
        widths = []
        for seed in range(experiments):
            pairs = as_they_are(truth, protocol, number, number, seed)
            reductions = (reduction(pairs[0]), reduction(pairs[1]), stopped(*pairs))
            for name, estimate, value in zip(hits, reductions, (*true, 1 - true[1] / true[0]), strict=True):
                hits[name].append(bool(estimate.low < value < estimate.high))
            widths.append(reductions[1].high - reductions[1].low)
        rows.append(
            {"people": number, "width_idle": float(np.median(widths))}
            | {name: within(held) for name, held in hits.items()}
        )
        print(f"{number} people", flush=True)
    return rows


def alarms(truth: Truth, protocol: Protocol, experiments: int) -> dict[str, dict[str, float]]:
    """How often each test finds a difference on the idle waveguide where the population has none."""
    still = replace(truth, remaining=dict.fromkeys(protocol.waveguides, 1.0), film=None)
    p_values: dict[str, list[float]] = {}
    for seed in range(MORE * experiments):
        _, idle = as_they_are(still, protocol, GROUP, 0, seed)
        slow = (by_mixed_model(idle),) if seed < experiments else ()
        for test in (by_trials(idle), by_participants(idle), *slow):
            p_values.setdefault(test.name, []).append(test.p)
    rates = {}
    for name, values in p_values.items():
        computed = [p for p in values if np.isfinite(p)]
        rate = float(np.mean([p < LEVEL for p in computed]))
        error = float(np.sqrt(max(rate * (1 - rate), LEVEL * (1 - LEVEL)) / len(computed)))
        rates[name] = {"rate": rate, "error": error, "computed": len(computed)}
    return rates


def main(seeds: int, experiments: int) -> None:
    study = haptonic.load(STUDY)
    truth, protocol = truth_of(study), protocol_of(study)
    seconds, figures = timed(lambda: covered(truth, protocol, seeds))
    write(
        "trials_tell_the_truth",
        {
            "seeds": seeds,
            "people": GROUP,
            "strokes": protocol.blocks * protocol.trials * GROUP,
            "amplitude_m": dict(truth.film.amplitude) if truth.film else {},
            "covered": figures,
            "covered_s": seconds,
            "more_people": with_more_people(truth, protocol, experiments),
            "level": LEVEL,
            "alarms": alarms(truth, protocol, experiments),
            "experiments": experiments,
        },
    )


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--seeds", type=int, default=100)
    parser.add_argument("--experiments", type=int, default=600)
    arguments = parser.parse_args()
    main(arguments.seeds, arguments.experiments)
