"""Simulated strokes, processed and analysed, give their truth back within the stated intervals."""

import numpy as np
import pytest
from scipy import stats

from haptonic.friction.protocol import Protocol
from haptonic.friction.signals import measured
from haptonic.friction.simulation import Truth, film_of, people, strokes
from haptonic.friction.statistics import paired, reduction, reduction_here, stopped

FORCE = (0.8, 0.4)
AMPLITUDE = {"WG1": 0.95e-6, "WG2": 0.27e-6}


def held(protocol, participants, seeds):
    """How often each interval holds what is true of the population, or of these very people."""
    film = film_of(AMPLITUDE, 58.8e3, FORCE)
    truth = Truth(remaining=film.mean, film=film, force=FORCE)
    share = 1 - (1 - film.mean["WG2"]) / (1 - film.mean["WG1"])
    hits = {"driven": [], "idle": [], "stopped": [], "these": []}
    for seed in range(seeds):
        recorded = strokes(truth, protocol, participants, seed)
        table = measured((label, record) for label, record, _ in recorded)
        driven, idle = paired(table, "WG1"), paired(table, "WG2")
        group = people(truth, participants, np.random.default_rng(seed))
        level, left = (np.array(values) for values in zip(*((p.friction, p.remaining["WG1"]) for p in group),
                                                    strict=True))  # fmt: skip
        for name, estimate, true in (
            ("driven", reduction(driven), 1 - film.mean["WG1"]),
            ("idle", reduction(idle), 1 - film.mean["WG2"]),
            ("stopped", stopped(driven, idle), share),
            ("these", reduction_here(driven, draws=500, seed=seed), 1 - (level @ left) / level.sum()),
        ):
            hits[name].append(estimate.low < true < estimate.high)
    return {name: sum(of) for name, of in hits.items()}


def test_truth_within_the_stated_intervals():
    """Twenty small experiments; of as many sound ones, 99.9 % hold the truth at least so often."""
    least = stats.binom.ppf(0.001, 20, 0.95)
    assert {name: count for name, count in held(Protocol(2, 24), 3, 20).items() if count < least} == {}


@pytest.mark.nightly
def test_truth_within_the_stated_intervals_of_a_hundred_published_experiments():
    least, most = stats.binom.ppf([0.001, 0.999], 100, 0.95)
    for name, count in held(Protocol(), 3, 100).items():
        assert least <= count <= most, name
