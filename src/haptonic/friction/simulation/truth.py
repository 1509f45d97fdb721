"""True properties of simulated participants, and the resulting coefficients of friction."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.random import Generator

from haptonic.errors import FrictionError, shown
from haptonic.friction.participants import Participants
from haptonic.friction.protocol import Protocol
from haptonic.friction.signals import Label
from haptonic.friction.simulation.film import LIGHTEST, Film

SLOWEST = 0.03  # m/s: smallest speed of a participant who follows instructions


@dataclass(frozen=True)
class Truth:
    """True properties of the simulated participants.

    people : friction with the vibration off, and its variation; the sensor
    remaining : waveguide -> mu / mu0 with the vibration on, in the population
    force, speed : (mean, standard deviation) over trials, N and m/s
    contact : duration of a stroke, s
    film : dependence of the remaining friction on the force of a stroke; None for no dependence
    """

    people: Participants = field(default_factory=Participants)
    remaining: Mapping[str, float] = field(
        default_factory=lambda: MappingProxyType({"WG1": 0.45, "WG2": 0.89})
    )
    force: tuple[float, float] = (0.8, 0.4)
    speed: tuple[float, float] = (0.078, 0.013)
    contact: float = 0.9
    film: Film | None = None

    def __post_init__(self) -> None:
        for guide, left in self.remaining.items():
            if not 0 < left <= 1:
                raise _untrue(f"remaining.{guide}", left, "mu / mu0, above 0 and at most 1")


@dataclass(frozen=True)
class Person:
    """True properties of one participant.

    friction : with the vibration off, in the middle of the session
    remaining : waveguide -> mu / mu0 with the vibration on, mean over the forces of the strokes
    """

    friction: float
    remaining: Mapping[str, float]


@dataclass(frozen=True)
class Trial:
    """One stroke to simulate: its coefficient of friction, and the means of its force (N) and speed (m/s)."""

    label: Label
    friction: float
    force: float
    speed: float


def _untrue(name: str, value: object, allowed: str) -> FrictionError:
    return FrictionError.out_of_range(
        argument=f"truth.{name}",
        given=shown(value),
        allowed=allowed,
        cause="a percentage, or another unit",
        next_step="give shares, such as 0.45 for a reduction of 55 %",
    )


def people(truth: Truth, participants: int, rng: Generator) -> list[Person]:
    """Participants drawn from the population."""
    return [
        Person(
            truth.people.friction * _positive_factor(truth.people.between, rng),
            {
                guide: float(np.clip(mean + truth.people.effect_between * rng.standard_normal(), 0.01, 2))
                for guide, mean in truth.remaining.items()
            },
        )
        for _ in range(participants)
    ]


def trials(truth: Truth, protocol: Protocol, group: Sequence[Person], rng: Generator) -> Iterator[Trial]:
    """Every trial of an experiment with these people, in its order.

    Raises
    ------
    FrictionError : no people, or a waveguide that is not in the truth
    """
    labels = protocol.order(len(group))
    for guide in {label.waveguide for label in labels} - set(truth.remaining):
        raise _untrue("remaining", dict(truth.remaining), f"one number for each waveguide, also for {guide}")
    session = protocol.blocks * protocol.trials
    for row, label in enumerate(labels):
        person, place = group[row // session], row % session
        force = max(LIGHTEST, truth.force[0] + truth.force[1] * float(rng.standard_normal()))
        speed = max(SLOWEST, truth.speed[0] + truth.speed[1] * float(rng.standard_normal()))
        friction = person.friction * (1 + truth.people.drift * (place / session - 0.5))
        if label.actuation == "on":
            friction *= person.remaining[label.waveguide]
            friction *= truth.film.relative(label.waveguide, force) if truth.film else 1.0
        yield Trial(label, friction * _positive_factor(truth.people.within, rng), force, speed)


def coefficients(
    truth: Truth, protocol: Protocol, participants: int, rng: Generator
) -> Iterator[tuple[Label, float]]:
    """True coefficient of friction of every trial, without force records: enough to test statistics.

    Raises
    ------
    FrictionError : no participant, or a waveguide that is not in the truth
    """
    for trial in trials(truth, protocol, people(truth, participants, rng), rng):
        yield trial.label, trial.friction


def _positive_factor(spread: float, rng: Generator) -> float:
    """A log-normal factor with mean 1 and this standard deviation."""
    width = math.sqrt(math.log1p(spread**2))
    return math.exp(width * float(rng.standard_normal()) - width**2 / 2)
