"""Order of trials: blocks of strokes on one waveguide, with the vibration on and off in turn."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.random import Generator

from haptonic.errors import FrictionError, shown
from haptonic.friction.signals import Label


@dataclass(frozen=True)
class Protocol:
    """Blocks of trials that alternate between on and off; the published one has 8 blocks of 30.

    The published experiment has conditions C1 and C3 in turn in even blocks, C2 and C4 in odd ones
    [daunizeau-haptics]; it does not define the conditions. Here every block compares on with off: even blocks
    are strokes on the driven waveguide, odd ones on the idle one.

    waveguides : names of the driven and of the idle waveguide
    blocks : number of blocks for each participant, even
    trials : number of trials in a block, even
    counterbalanced : True if every second participant starts with the other waveguide, and every second block
        of a waveguide with the other actuation; the published order does not change
    seed : for the random order of on and off in every pair of neighbouring trials; None for strict
        alternation
    """

    blocks: int = 8
    trials: int = 30
    counterbalanced: bool = False
    waveguides: tuple[str, str] = ("WG1", "WG2")
    seed: int | None = None

    def __post_init__(self) -> None:
        for name in ("blocks", "trials"):
            number = getattr(self, name)
            if not isinstance(number, int) or isinstance(number, bool) or number < 2 or number % 2:
                raise FrictionError.out_of_range(
                    argument=f"protocol.{name}",
                    given=shown(number),
                    allowed="an even number, 2 or more",
                    cause="an odd number leaves one condition with more trials than the other",
                    next_step="add or drop one",
                )
        if len(set(self.waveguides)) != 2:
            raise FrictionError.conflict(
                argument="protocol.waveguides",
                given=shown(self.waveguides),
                allowed="two different names",
                cause="the driven and the idle waveguide are compared with each other",
                next_step="name another region",
            )

    @property
    def pairs(self) -> int:
        """Number of strokes of one participant on one waveguide with vibration on; as many with it off."""
        return self.blocks * self.trials // 4

    def order(self, participants: int) -> list[Label]:
        """List every trial in its order, for participants P1, P2, ...

        Raises
        ------
        FrictionError : the number of participants is not a positive integer
        """
        if not isinstance(participants, int) or isinstance(participants, bool) or participants < 1:
            raise FrictionError.out_of_range(
                argument="participants",
                given=shown(participants),
                allowed="a number from 1",
                cause="the number was left out",
                next_step="give how many people take part",
            )
        labels = [
            Label(f"P{person + 1}", block + 1, trial + 1, *self._condition(person, block, trial))
            for person in range(participants)
            for block in range(self.blocks)
            for trial in range(self.trials)
        ]
        return labels if self.seed is None else _shuffled(labels, np.random.default_rng(self.seed))

    def _condition(self, person: int, block: int, trial: int) -> tuple[str, str]:
        """Waveguide and actuation of a trial."""
        driven = block % 2 == 1
        if not self.counterbalanced:
            return self.waveguides[not driven], ("on", "off")[trial % 2]
        driven = driven != bool(person % 2)  # every second participant starts with the other waveguide
        turned = trial + block // 2 + person // 2
        return self.waveguides[not driven], ("on", "off")[turned % 2]


def _shuffled(plain: list[Label], rng: Generator) -> list[Label]:
    """Draw at random which of two neighbouring trials has the vibration on.

    On each waveguide, as many of a participant's pairs begin with on as with off (one more or less for an odd
    number of pairs), so that a steady drift cancels.
    """
    labels = list(plain)
    pairs: dict[tuple[str, str], list[int]] = {}  # first trial of each
    for row in range(0, len(labels), 2):
        pairs.setdefault((labels[row].participant, labels[row].waveguide), []).append(row)
    for rows in pairs.values():
        spare = rng.permutation(("on", "off"))[: len(rows) % 2]
        firsts = rng.permutation([*("on", "off") * (len(rows) // 2), *spare])
        for row, first in zip(rows, firsts, strict=True):
            labels[row] = replace(labels[row], actuation=str(first))
            labels[row + 1] = replace(labels[row + 1], actuation="off" if first == "on" else "on")
    return labels


def imbalance(labels: list[Label]) -> float:
    """Largest difference, in trials, of the mean position in the session between on and off of one waveguide.

    A drift along the session (moisture, fatigue, learning) biases a difference by this number times its
    slope.
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
