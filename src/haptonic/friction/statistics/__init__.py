"""Statistics of a table of trials: tests by trials, participants and a mixed model; effects; planning."""

from haptonic.friction.statistics.comparison import (
    Test,
    by_each,
    by_mixed_model,
    by_participants,
    by_trials,
    compared,
    conclusion,
    corrected,
)
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
from haptonic.friction.statistics.pairs import Pairs, paired
from haptonic.friction.statistics.planning import (
    Alarms,
    Population,
    expected_power,
    false_alarms,
    participants_needed,
    power,
    smallest_shown,
)

__all__ = [
    "Alarms",
    "Equivalence",
    "IntervalEstimate",
    "Pairs",
    "Population",
    "Test",
    "by_each",
    "by_mixed_model",
    "by_participants",
    "by_trials",
    "compared",
    "conclusion",
    "corrected",
    "drift",
    "equivalence",
    "expected_power",
    "false_alarms",
    "paired",
    "participants_needed",
    "power",
    "reduction",
    "reduction_here",
    "smallest_shown",
    "stopped",
    "stopped_here",
]
