"""The order of trials: blocks in which a waveguide is stroked with the vibration on and off in turn."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.random import Generator

from haptonic.errors import FrictionError
from haptonic.friction.signals import Label
from haptonic.units import shown

CONDITIONS = {"C1": ("WG1", "on"), "C2": ("WG2", "on"), "C3": ("WG1", "off"), "C4": ("WG2", "off")}
"""Even blocks of the published experiment alternate C1 and C3, odd ones C2 and C4 [daunizeau-haptics]; which
number means which is not said there: this is the reading in which every block compares on with off."""


@dataclass(frozen=True)
class Protocol:
    """Blocks of trials that alternate between on and off; the published one has 8 blocks of 30.

    blocks : for each participant, an even number
    trials : in a block, an even number
    counterbalanced : whether every second participant starts with the other waveguide, and every second block
        of a waveguide with the other actuation; the published order does not change
    """

    blocks: int = 8
    trials: int = 30
    counterbalanced: bool = False

    def __post_init__(self) -> None:
        for name in ("blocks", "trials"):
            number = getattr(self, name)
            if not isinstance(number, int) or isinstance(number, bool) or number < 2 or number % 2:
                raise FrictionError(
                    argument=f"protocol.{name}",
                    given=shown(number),
                    allowed="an even number, 2 or more",
                    cause="an odd number leaves one condition with more trials than the other",
                    next_step="add or drop one",
                )

    def order(self, participants: int) -> list[Label]:
        """Every trial in its order, for participants P1, P2, ...

        Raises
        ------
        FrictionError : no participant
        """
        if not isinstance(participants, int) or isinstance(participants, bool) or participants < 1:
            raise FrictionError(
                argument="participants",
                given=shown(participants),
                allowed="a number from 1",
                cause="the number was left out",
                next_step="give how many people take part",
            )
        return [
            Label(f"P{person + 1}", block + 1, trial + 1, *CONDITIONS[self._condition(person, block, trial)])
            for person in range(participants)
            for block in range(self.blocks)
            for trial in range(self.trials)
        ]

    def shuffled(self, participants: int, rng: Generator) -> list[Label]:
        """The same numbers of trials in each block, but on and off in a random order, as many of each."""
        made = []
        plain = self.order(participants)
        for start in range(0, len(plain), self.trials):
            block = plain[start : start + self.trials]
            for label, drawn in zip(block, rng.permutation(self.trials), strict=True):
                actuation = block[drawn].actuation
                made.append(Label(label.participant, label.block, label.trial, label.waveguide, actuation))
        return made

    def _condition(self, person: int, block: int, trial: int) -> str:
        number = block + 1
        even = number % 2 == 0
        if not self.counterbalanced:
            return ("C1", "C3")[trial % 2] if even else ("C2", "C4")[trial % 2]
        first = even != bool(person % 2)  # the waveguide changes places from one participant to the next
        turned = trial + block // 2 + person // 2
        return ("C1", "C3")[turned % 2] if first else ("C2", "C4")[turned % 2]


def imbalance(labels: list[Label]) -> float:
    """Largest difference of the mean position in the session between on and off of one waveguide, in trials.

    What a drift along the session (moisture, fatigue, learning) adds to a difference is this times its slope.
    """
    places: dict[tuple[str, str, str], list[int]] = {}
    count: dict[str, int] = {}
    for label in labels:
        count[label.participant] = count.get(label.participant, 0) + 1
        key = (label.participant, label.waveguide, label.actuation)
        places.setdefault(key, []).append(count[label.participant])
    pairs = {(person, guide) for person, guide, _ in places}
    gaps = [
        abs(float(np.mean(places[(*pair, "on")]) - np.mean(places[(*pair, "off")])))
        for pair in pairs
        if (*pair, "on") in places and (*pair, "off") in places
    ]
    return max(gaps, default=0.0)
